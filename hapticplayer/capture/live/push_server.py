"""A small server that a phone posts to: POST only, to a path with a random token.

Nothing listens unless a person has chosen this source, and nothing beyond this machine
unless they have allowed it. What is sent in larger pieces, slowly, or elsewhere is refused.
"""

import contextlib
import hmac
import ipaddress
import secrets
import socket
import threading
from collections.abc import Callable
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from hapticplayer import storage
from hapticplayer.errors import InputError
from hapticplayer.untrusted import read_regular

LOOPBACK, ALL_ADDRESSES = "127.0.0.1", "0.0.0.0"  # noqa: S104 - after a question
MAX_BODY_BYTES = 1 << 20
CONNECTION_S = 10.0
_TOKEN, _TOKEN_BYTES = "push-token", 16
_DOCUMENTATION = ("192.0.2.1", 9)  # RFC 5737: nothing is sent there


class BoundedServer(ThreadingHTTPServer):
    """A thread for each connection, and not more than so many connections.

    Args:
        address: to listen on.
        port: 0 for any that is free.
        handler: of requests.

    Attributes:
        refusal: raised when it cannot listen there.
        most, most_of_one: connections, and those of one address.
    """

    daemon_threads = True
    refusal: type[InputError] = InputError
    most, most_of_one = 64, 16
    request_queue_size = most

    def __init__(
        self, address: str, port: int, handler: type[BaseHTTPRequestHandler]
    ) -> None:
        self._open: dict[socket.socket, str] = {}  # host by connection
        self.address_family = socket.AF_INET6 if ":" in address else socket.AF_INET
        try:
            super().__init__((address, port), handler)
        except (OSError, OverflowError) as problem:
            raise self.refusal(
                "cannot listen on port {port} ({reason})",
                where=address,
                remedy="choose an address of this machine and a free port",
                port=port,
                reason=problem,
            ) from problem

    @property
    def connections(self) -> int:
        return len(self._open)

    @property
    def root(self) -> str:
        """The beginning of its URL, as others reach it."""
        address, port = self.server_address[:2]
        host = str(address)
        if ipaddress.ip_address(host).is_unspecified:
            host = _own_address(self.address_family) or socket.gethostname()
        host = f"[{host}]" if ":" in host else host
        return f"http://{host}:{port}"

    def server_bind(self) -> None:
        """Bind without asking a name server who we are."""
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.bind(self.server_address)
        self.server_address = self.socket.getsockname()

    def verify_request(self, request: Any, client_address: Any) -> bool:
        """Whether there is room for one more connection."""
        host = client_address[0]
        of_one = list(self._open.values()).count(host)
        if len(self._open) >= self.most or of_one >= self.most_of_one:
            return False
        self._open[request] = host
        return True

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
            with contextlib.suppress(OSError):  # it has gone by itself
                connection.shutdown(socket.SHUT_RDWR)


class PushServer(BoundedServer):
    """Hands over the bodies that are posted to its URL, in threads of their own.

    Args:
        take: is given each body; raises InputError for one that is no message.
        address: to listen on.
        port: 0 for any that is free.

    Raises:
        InputError: when it cannot listen there.
    """

    def __init__(self, take: Callable[[bytes], None], address: str, port: int) -> None:
        self.take, self.token = take, kept_token()
        super().__init__(address, port, _PushHandler)
        self._thread = threading.Thread(
            target=self.serve_forever, args=(0.1,), daemon=True
        )
        self._thread.start()

    @property
    def url(self) -> str:
        """What a person enters on the phone."""
        return f"{self.root}/{self.token}"

    def close(self) -> None:
        """Stop to listen; may be called again."""
        self.shutdown()
        self._thread.join()
        self.server_close()


class _PushHandler(BaseHTTPRequestHandler):
    server: PushServer

    protocol_version = "HTTP/1.1"
    server_version, sys_version = "hapticplayer", ""
    error_message_format, error_content_type = "%(message)s", "text/plain"
    timeout = CONNECTION_S

    def do_POST(self) -> None:
        path = self.path.partition("?")[0].strip("/")
        ours = self.server.token.encode()
        if not hmac.compare_digest(path.encode("utf-8", "replace"), ours):
            self._answer(HTTPStatus.FORBIDDEN)
            return
        lengths = self.headers.get_all("Content-Length", [])
        if len(lengths) != 1 or not lengths[0].isdecimal() or len(lengths[0]) > 9:
            self._answer(HTTPStatus.LENGTH_REQUIRED)
            return
        size = int(lengths[0])
        if size > MAX_BODY_BYTES or "Transfer-Encoding" in self.headers:
            self._answer(HTTPStatus.REQUEST_ENTITY_TOO_LARGE)
            return
        with contextlib.suppress(ConnectionError, TimeoutError):  # the phone has gone
            body = self.rfile.read(size)
            if len(body) == size:
                self._answer(self._taken(body))
                return
        self.close_connection = True

    def _taken(self, body: bytes) -> HTTPStatus:
        try:
            self.server.take(body)
        except InputError:
            return HTTPStatus.BAD_REQUEST
        return HTTPStatus.OK

    def _answer(self, status: HTTPStatus) -> None:
        self.close_connection = self.close_connection or status != HTTPStatus.OK
        self.send_response(status)
        self.send_header("Content-Length", "0")
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Log nothing: requests hold the token."""


def kept_token() -> str:
    """The token of this user's URL, random, the same for each take."""
    path = storage.config_home() / _TOKEN
    with contextlib.suppress(InputError, UnicodeDecodeError):
        held = read_regular(path, 100).decode("ascii").strip()
        if len(held) >= _TOKEN_BYTES:
            return held
    token = secrets.token_urlsafe(_TOKEN_BYTES)
    storage.make_folder(path.parent)
    storage.replace_file(path, token.encode(), storage.PRIVATE_FILE)
    return token


def _own_address(family: int) -> str:
    """The address under which the local network knows this machine, "" if none."""
    if family != socket.AF_INET:
        return ""
    with socket.socket(family, socket.SOCK_DGRAM) as asked:
        try:
            asked.connect(_DOCUMENTATION)
        except OSError:
            return ""
        return str(asked.getsockname()[0])
