"""The command `serve`: a packed file for others on this machine or a local network.

Whoever has the URL may watch: it holds a token of 128 bits, and nothing is encrypted.
Only the file can be read, whole or in parts. A connection that asks for nothing, or takes
nothing, is closed; so are those beyond the limits below.
"""

import argparse
import contextlib
import hmac
import ipaddress
import json
import os
import re
import secrets
import sys
import tempfile
from collections.abc import Mapping
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler
from pathlib import Path
from typing import Any, BinaryIO
from urllib.parse import quote, unquote

from hapticplayer.capture.live.push_server import LOOPBACK, BoundedServer
from hapticplayer.cli.common import (
    add_accept_changed,
    add_number,
    refuse_idle,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.errors import InputError, UsageError, shell_line
from hapticplayer.extras.web.http_range import NetworkError
from hapticplayer.media.remux import video_payload
from hapticplayer.model import ranges
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.store import DESCRIPTION, open_sequence
from hapticplayer.sequence.unpack import require_packed
from hapticplayer.untrusted import open_regular

CONNECTION_S = 30.0
"""How long a connection may send nothing of a request, or take nothing of an answer."""

_RANGE = re.compile(r"bytes=(\d{1,18}-\d{0,18}|-\d{1,18})")
_AUTHORITY = re.compile(r"^https?://[^/?]*", re.ASCII | re.IGNORECASE)
"""Of a request in absolute form, as proxies send it (RFC 9112, 3.2.2)."""
_MEDIA_TYPES = {".mkv": "video/x-matroska", ".mp4": "video/mp4"}


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "source",
        metavar="FILE_OR_SEQUENCE",
        help="a file that was packed; a sequence is packed first",
    )
    command.add_argument(
        "--bind",
        metavar="ADDRESS",
        default=LOOPBACK,
        help="address of this machine to listen on, 0.0.0.0 for all of them: then "
        "whoever has the URL can watch from the network, and nothing is encrypted "
        f"(default: {LOOPBACK}, only this machine)",
    )
    add_number(
        command,
        "--port",
        ranges.PORT,
        default=0,
        metavar="N",
        help="port to listen on (default: any that is free)",
    )
    add_accept_changed(command)
    command.add_argument("--json", action="store_true", help="print the URL as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Serve until Ctrl-C."""
    address = _address(options.bind)
    with tempfile.TemporaryDirectory(prefix="hapticplayer-serve-") as place:
        title, files = _offered(Path(options.source), Path(place), options)
        with (
            FileServer(files, address, int(options.port)) as server,
        ):
            try:
                _announce(server, title, options)
                server.serve_forever(poll_interval=0.2)
            except KeyboardInterrupt:
                say_aside("stopped")
    return 0


def _address(text: str) -> str:
    """Return an address to listen on; "" and other short forms would mean all of them."""
    with contextlib.suppress(ValueError):
        return str(ipaddress.ip_address("127.0.0.1" if text == "localhost" else text))
    raise UsageError(
        "{text!r} (--bind) is not an address of this machine; give one in full, such as "
        "{loopback} or 192.168.1.5",
        text=text,
        loopback=LOOPBACK,
    )


def _offered(
    source: Path, place: Path, options: argparse.Namespace
) -> tuple[str, list[Path]]:
    """Return the title of what is served, and its files."""
    source = source.parent if source.name == DESCRIPTION else source
    if source.is_dir():
        refuse_idle(options, "on a sequence", "--accept-changed-video")
        title, target = open_sequence(source).title, place / "ride.mkv"
        with shown_progress() as progress:
            pack(source, target, progress=progress)
        return title, [target]
    packed = require_packed(source)
    why = packed.payload.difference(video_payload(source))
    if why and not options.accept_changed_video:
        raise NetworkError(
            "is not the video that its force was made for ({reason})",
            where=str(source),
            reason=why,
            remedy="ask for the file again, or agree (--accept-changed-video)",
        )
    return packed.sequence.title, list({source: None, packed.carrier: None})


def _announce(server: "FileServer", title: str, options: argparse.Namespace) -> None:
    if not ipaddress.ip_address(str(server.server_address[0])).is_loopback:
        say_aside(
            "whoever on the network has this URL can watch and feel the clip; nothing "
            "is encrypted"
        )
    if options.json:
        say(json.dumps({"title": title, "url": server.url}))
    else:
        say(f"{title} is served until Ctrl-C; to play it:")
        words = ("hapticplayer", "play", "--allow-network", server.url)
        say(f"  {shell_line(*words)}")
    sys.stdout.flush()  # it may be a pipe, and nothing follows


class FileServer(BoundedServer):
    """Serves files by name; a thread for each connection.

    Args:
        files: the first is the one to play.
        address: to listen on; only this machine reaches the default.
        port: 0 for any that is free.

    Raises:
        NetworkError: when it cannot listen there.
    """

    refusal = NetworkError

    def __init__(
        self, files: list[Path], address: str = LOOPBACK, port: int = 0
    ) -> None:
        self.files: Mapping[str, Path] = {file.name: file for file in files}
        self.token = secrets.token_urlsafe(16)
        super().__init__(address, port, _Handler)

    @property
    def url(self) -> str:
        """The address that a viewer needs."""
        name = quote(os.fsencode(next(iter(self.files))))
        return f"{self.root}/{self.token}/{name}"


class _Handler(BaseHTTPRequestHandler):
    server: FileServer

    protocol_version = "HTTP/1.1"
    server_version, sys_version = "hapticplayer", ""
    error_message_format, error_content_type = "%(message)s", "text/plain"
    timeout = CONNECTION_S
    disable_nagle_algorithm = True

    def do_GET(self) -> None:
        lengths = self.headers.get_all("Content-Length", ["0"])
        is_odd = self.headers.defects or "\n" in "".join(self.headers.values())
        if is_odd or lengths != ["0"] or "Transfer-Encoding" in self.headers:
            # a body, perhaps one that was not understood, would be the next request
            self._refuse(HTTPStatus.BAD_REQUEST)
            return
        path = _AUTHORITY.sub("", self.path, count=1).partition("?")[0]
        token, _, name = path.removeprefix("/").partition("/")
        ours = self.server.token.encode()
        if not hmac.compare_digest(token.encode("utf-8", "replace"), ours):
            self._refuse(HTTPStatus.FORBIDDEN)
            return
        file = self.server.files.get(unquote(name, errors="surrogateescape"))
        try:
            if file is None:
                self._refuse(HTTPStatus.NOT_FOUND)
                return
            with open_regular(file) as reader:
                self._send(reader, _MEDIA_TYPES.get(file.suffix.lower(), ""))
        except InputError:
            self._refuse(HTTPStatus.NOT_FOUND)
        except (ConnectionError, TimeoutError):
            self.close_connection = True

    do_HEAD = do_GET  # noqa: N815 - names of http.server

    def _refuse(self, status: HTTPStatus) -> None:
        self.close_connection = True
        self._head(status, 0, {"Connection": "close"})

    def _send(self, reader: BinaryIO, media_type: str) -> None:
        found = os.fstat(reader.fileno())
        size = found.st_size
        tag = f'"{found.st_mtime_ns:x}-{found.st_ctime_ns:x}-{size:x}"'
        headers = {
            "Content-Type": media_type or "application/octet-stream",
            "Accept-Ranges": "bytes",
            "ETag": tag,
            "Last-Modified": self.date_time_string(found.st_mtime),
        }
        wanted = self.headers.get("Range", "")
        if self.headers.get("If-Range", tag) not in (tag, headers["Last-Modified"]):
            wanted = ""  # of another state of the file: the whole one
        if not _RANGE.fullmatch(wanted):
            self._send_part(HTTPStatus.OK, reader, (0, size), headers)
            return
        span = wanted_bytes(wanted, size)
        if span is None:
            unmet = HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE
            self._head(unmet, 0, {"Content-Range": f"bytes */{size}"})
            return
        headers["Content-Range"] = f"bytes {span[0]}-{span[1] - 1}/{size}"
        self._send_part(HTTPStatus.PARTIAL_CONTENT, reader, span, headers)

    def _send_part(
        self,
        status: HTTPStatus,
        reader: BinaryIO,
        span: tuple[int, int],
        headers: Mapping[str, str],
    ) -> None:
        first, count = span[0], span[1] - span[0]
        self._head(status, count, headers)
        if self.command != "HEAD" and count:
            sent = self.connection.sendfile(reader, first, count)
            if sent < count:  # the file has become shorter
                self.close_connection = True

    def _head(
        self, status: HTTPStatus, size_bytes: int, headers: Mapping[str, str]
    ) -> None:
        self.send_response(status)
        self.send_header("Content-Length", str(size_bytes))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")  # the URL holds the token
        self.send_header("X-Content-Type-Options", "nosniff")
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Log nothing: requests hold the token."""


def wanted_bytes(header: str, size: int) -> tuple[int, int] | None:
    """Return begin and end of a range, None where it cannot be met (RFC 9110, 14.2)."""
    first, last = header.removeprefix("bytes=").split("-")
    if not first:
        begin, end = max(0, size - int(last)), size
    else:
        begin, end = int(first), min(size, int(last) + 1) if last else size
    return (begin, end) if begin < end else None
