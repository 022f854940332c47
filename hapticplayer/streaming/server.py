"""Offers a felt video over HTTP, on this machine or a local network.

Whoever has the URL may watch: it holds a token of 128 bits, and nothing is encrypted.
Only reading is possible, and only what `Offer` names. A connection that asks for nothing,
or takes nothing, is closed; so are those beyond the limits in `untrusted`.
"""

import contextlib
import hmac
import secrets
import socket
from collections import Counter
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from hapticplayer.clock import Clock
from hapticplayer.errors import NetworkError
from hapticplayer.streaming.manifest import MANIFEST
from hapticplayer.streaming.offer import Offer, Response
from hapticplayer.untrusted import (
    CONNECTION_S,
    MAX_CONNECTIONS,
    MAX_CONNECTIONS_OF_ONE,
)

LOOPBACK = "127.0.0.1"
EVERYWHERE = ("0.0.0.0", "::")  # noqa: S104 - recognised, not chosen
_ANY_ADDRESS = ("192.0.2.1", 9)  # of documentation (RFC 5737): nothing is sent there


class StreamServer(ThreadingHTTPServer):
    """Serves an offer; a thread for each connection.

    Args:
        offer: what there is.
        clock: of the machine.
        address: to listen on; only this machine reaches the default.
        port: 0 for any that is free.

    Raises:
        NetworkError: when it cannot listen there.
    """

    daemon_threads = True
    request_queue_size = MAX_CONNECTIONS

    def __init__(
        self, offer: Offer, clock: Clock, address: str = LOOPBACK, port: int = 0
    ) -> None:
        self.offer, self._clock = offer, clock
        self.token = secrets.token_urlsafe(16)
        self._open: dict[socket.socket, tuple[str, float | None]] = {}
        self.address_family = socket.AF_INET6 if ":" in address else socket.AF_INET
        try:
            super().__init__((address, port), _Handler)
        except (OSError, OverflowError) as problem:
            raise NetworkError(
                "cannot listen on port {port} ({reason})",
                where=address,
                remedy="choose an address of this machine and a free port",
                port=port,
                reason=problem,
            ) from problem

    @property
    def connections(self) -> int:
        """How many are open."""
        return len(self._open)

    @property
    def url(self) -> str:
        """Return what a viewer needs."""
        address, port = self.server_address[:2]
        host = str(address)
        if host in EVERYWHERE:
            host = _own_address(self.address_family) or socket.gethostname()
        host = f"[{host}]" if ":" in host else host
        return f"http://{host}:{port}/{self.token}/{MANIFEST}"

    def server_bind(self) -> None:
        """Bind without asking a name server who we are."""
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.bind(self.server_address)
        self.server_address = self.socket.getsockname()

    def verify_request(self, request: Any, client_address: Any) -> bool:
        """Whether there is room for one more connection."""
        host = client_address[0]
        of_one = Counter(address for address, _ in list(self._open.values()))
        if len(self._open) >= MAX_CONNECTIONS or of_one[host] >= MAX_CONNECTIONS_OF_ONE:
            return False
        self._open[request] = (host, self._clock.now_s() + CONNECTION_S)
        return True

    def note_waiting(self, connection: socket.socket, *, is_waiting: bool) -> None:
        """Note that a connection has to send its next request soon, or has done so."""
        if connection in self._open:
            until_s = self._clock.now_s() + CONNECTION_S if is_waiting else None
            self._open[connection] = (self._open[connection][0], until_s)

    def service_actions(self) -> None:
        """Hang up on those that have not sent a whole request in time."""
        now_s = self._clock.now_s()
        for connection, (_, until_s) in list(self._open.items()):
            if until_s is not None and now_s > until_s:
                _hang_up(connection)

    def shutdown_request(self, request: Any) -> None:
        """End a connection."""
        self._open.pop(request, None)
        super().shutdown_request(request)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say nothing of what clients do wrong."""

    def server_close(self) -> None:
        """Hang up on everybody and stop to listen."""
        super().server_close()
        for connection in list(self._open):
            _hang_up(connection)


class _Handler(BaseHTTPRequestHandler):
    server: StreamServer

    protocol_version = "HTTP/1.1"
    server_version, sys_version = "hapticplayer", ""
    error_message_format, error_content_type = "%(message)s", "text/plain"
    timeout = CONNECTION_S
    disable_nagle_algorithm = True

    def handle_one_request(self) -> None:
        self.server.note_waiting(self.connection, is_waiting=True)
        super().handle_one_request()

    def do_GET(self) -> None:
        self.server.note_waiting(self.connection, is_waiting=False)
        with contextlib.suppress(ConnectionError, TimeoutError):
            self._send(self._answer())
            return
        self.close_connection = True

    do_HEAD = do_GET  # noqa: N815 - names of http.server

    def _answer(self) -> Response:
        token, _, resource = self.path.removeprefix("/").partition("/")
        ours = self.server.token.encode()
        if not hmac.compare_digest(token.encode("utf-8", "replace"), ours):
            self.close_connection = True
            return Response(HTTPStatus.FORBIDDEN)
        return self.server.offer.answer(resource, self.headers.get("Range"))

    def _send(self, answer: Response) -> None:
        self.send_response(answer.status)
        self.send_header("Content-Type", answer.media_type)
        self.send_header("Content-Length", str(answer.size_bytes))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")  # the URL holds the token
        self.send_header("X-Content-Type-Options", "nosniff")
        for name, value in answer.headers:
            self.send_header(name, value)
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        if self.command == "HEAD":
            return
        if answer.open_clip is None:
            self.wfile.write(answer.content)
            return
        with answer.open_clip() as clip:
            sent = self.connection.sendfile(clip, answer.first, answer.count)
        if sent < answer.count:  # the file has become shorter
            self.close_connection = True

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Log nothing: requests hold the token."""


def _hang_up(connection: socket.socket) -> None:
    with contextlib.suppress(OSError):  # it has gone by itself
        connection.shutdown(socket.SHUT_RDWR)


def _own_address(family: int) -> str:
    """Return the address under which the local network knows this machine, "" if none."""
    if family != socket.AF_INET:
        return ""
    with socket.socket(family, socket.SOCK_DGRAM) as asked:
        try:
            asked.connect(_ANY_ADDRESS)
        except OSError:
            return ""
        return str(asked.getsockname()[0])
