"""Asks the server of a stream for what its manifest names: nothing else, nowhere else.

One server, one connection at a time, no redirects; every answer is as long as was asked
for at most, and has to be there in time however slowly its bytes come.
"""

import contextlib
import io
import re
import socket
from collections.abc import Callable
from http import HTTPStatus
from http.client import HTTPConnection, HTTPException
from typing import Any, NamedTuple, Self, cast
from urllib.parse import urlsplit

from hapticplayer.clock import Clock
from hapticplayer.errors import Message, NetworkError
from hapticplayer.streaming.manifest import MANIFEST
from hapticplayer.untrusted import ANSWER_S, without_controls

_PATH = re.compile(r"/([A-Za-z0-9_-]{8,64})/(?:" + re.escape(MANIFEST) + r")?")
_AGAIN = Message("check the address, and that `hapticplayer serve` still runs there")
_REASONS = {
    HTTPStatus.FORBIDDEN: Message("refuses the token in the address"),
    HTTPStatus.NOT_FOUND: Message("does not have what its manifest names"),
    HTTPStatus.GONE: Message("has a clip that was changed meanwhile"),
}


class Unreachable(Exception):  # noqa: N818 - it may be reached the next time
    """There was no whole answer in time; `args[0]` is why."""


class Aborted(Unreachable):
    """Something else is more urgent."""


class StreamAddress(NamedTuple):
    """Where a stream is: host, port and token."""

    host: str
    port: int
    token: str

    @classmethod
    def of(cls, url: str) -> Self:
        """Return the address in the URL that `serve` prints.

        Raises:
            NetworkError: when it is not the address of a stream.
        """
        shown = without_controls(url[:200])
        try:
            parts = urlsplit(url)
            host, port = parts.hostname, parts.port or 80
        except ValueError:
            host, port = None, 0
        else:
            found = _PATH.fullmatch(parts.path)
            is_plain = parts.scheme == "http" and not (parts.query or parts.username)
            if host and found and is_plain and host.isprintable():
                return cls(host, port, found[1])
        raise NetworkError(
            "is not the address of a stream",
            where=shown,
            remedy=Message(
                "give the one that `hapticplayer serve` prints "
                "(http://HOST:PORT/TOKEN/{name})",
                name=MANIFEST,
            ),
        )

    def __str__(self) -> str:
        """Return host and port; the token is a secret."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"http://{host}:{self.port}"


class StreamClient:
    """A connection to the server of a stream, for one thread; opened when needed."""

    def __init__(self, address: StreamAddress, clock: Clock) -> None:
        self._address, self._clock = address, clock
        self._connection: HTTPConnection | None = None
        self._is_closed = self._is_aborted = False

    def get(
        self,
        resource: str,
        most_bytes: int,
        span: tuple[int, int, int] | None = None,
    ) -> bytes:
        """Return a resource.

        Args:
            resource: below the token.
            most_bytes: that are accepted.
            span: begin, end and whole size, bytes, of a part that has to come as such.

        Raises:
            Unreachable: for now; it is worth asking again.
            NetworkError: for good.
        """
        self._is_aborted = False
        is_kept = self._connection is not None
        try:
            return self._get(resource, most_bytes, span)
        except (OSError, HTTPException, ValueError) as problem:
            self.drop()
            if self._is_aborted:
                raise Aborted from problem
            if is_kept and isinstance(problem, ConnectionError):
                # the server has closed it since the last answer
                return self.get(resource, most_bytes, span)
            raise Unreachable(str(problem) or type(problem).__name__) from problem
        except BaseException:
            self.drop()
            raise

    def abort(self) -> None:
        """Give up what is being waited for; called from another thread."""
        self._is_aborted = True
        connection = self._connection
        if connection is not None and connection.sock is not None:
            cast("_TimedSocket", connection.sock).hang_up()

    def close(self) -> None:
        """Give up, and ask for nothing any more; called from another thread."""
        self._is_closed = True
        self.abort()

    def _get(
        self, resource: str, most_bytes: int, span: tuple[int, int, int] | None
    ) -> bytes:
        connection = self._connected()
        cast("_TimedSocket", connection.sock).until_s = self._clock.now_s() + ANSWER_S
        headers = {"Range": f"bytes={span[0]}-{span[1] - 1}"} if span else {}
        path = f"/{self._address.token}/{resource}"
        connection.request("GET", path, headers=headers)
        with connection.getresponse() as response:
            self._check(response.status, is_part=span is not None)
            size = response.length
            if size is None:  # its headers may have ended early
                raise ConnectionError("the answer has no length")
            if size > most_bytes:
                raise self._wrong(Message("sends more than was asked for"))
            if span is not None:
                self._check_part(response.getheader("Content-Range"), span)
            content = response.read(size)
            if len(content) < size:
                raise ConnectionError("the answer ended early")
            if response.will_close:
                self.drop()
        return content

    def _check(self, status: int, *, is_part: bool) -> None:
        if status == (HTTPStatus.PARTIAL_CONTENT if is_part else HTTPStatus.OK):
            return
        if status >= HTTPStatus.INTERNAL_SERVER_ERROR:
            raise ConnectionError(f"status {status}")
        usual = Message("answers with status {status}", status=status)
        raise self._wrong(_REASONS.get(HTTPStatus(status), usual))

    def _check_part(self, stated: str | None, span: tuple[int, int, int]) -> None:
        if stated is None:
            raise ConnectionError("the answer does not say which part it is")
        if stated != f"bytes {span[0]}-{span[1] - 1}/{span[2]}":
            raise self._wrong(Message("sends another part than was asked for"))

    def _wrong(self, what: Message) -> NetworkError:
        return NetworkError(what, where=str(self._address), remedy=_AGAIN)

    def _connected(self) -> HTTPConnection:
        if self._is_closed:
            raise ConnectionError("closed")
        if self._connection is None:
            made = HTTPConnection(
                self._address.host, self._address.port, timeout=ANSWER_S
            )
            made.connect()
            made.sock = cast("Any", _TimedSocket(made.sock, self._clock.now_s))
            self._connection = made
            if self._is_closed:
                raise ConnectionError("closed")
        return self._connection

    def drop(self) -> None:
        """Hang up; the next question opens another connection."""
        connection, self._connection = self._connection, None
        if connection is not None:
            with contextlib.suppress(OSError):
                connection.close()


class _TimedSocket:
    """What http.client needs of a socket, with one deadline for a whole answer."""

    def __init__(self, sock: socket.socket, now_s: Callable[[], float]) -> None:
        self._sock, self._now_s, self._users = sock, now_s, 1
        self.until_s = 0.0

    def sendall(self, content: bytes) -> None:
        self._limit()
        self._sock.sendall(content)

    def makefile(self, _mode: str) -> io.BufferedReader:
        self._users += 1
        return io.BufferedReader(_TimedReader(self))

    def receive_into(self, buffer: memoryview) -> int:
        self._limit()
        return self._sock.recv_into(buffer)

    def hang_up(self) -> None:
        with contextlib.suppress(OSError):  # it has gone by itself
            self._sock.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """End one use: an answer may be read when its connection is closed already."""
        self._users -= 1
        if not self._users:
            self._sock.close()

    def _limit(self) -> None:
        left_s = self.until_s - self._now_s()
        if left_s <= 0.0:
            raise TimeoutError("timed out")
        self._sock.settimeout(left_s)


class _TimedReader(io.RawIOBase):
    def __init__(self, sock: _TimedSocket) -> None:
        super().__init__()
        self._sock = sock

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: Any) -> int:
        return self._sock.receive_into(memoryview(buffer))

    def close(self) -> None:
        if not self.closed:
            self._sock.close()
        super().close()
