"""Asks a web server for parts of one file, and for nothing else.

TLS is verified. Redirects stay within their scheme and never lead from a public address to
a private one. Messages name the server and the file: path, query and the target of a
redirect may be secrets.
"""

import contextlib
import ipaddress
import re
import socket
import ssl
from collections.abc import Iterator
from http import HTTPStatus
from http.client import HTTPConnection, HTTPException, HTTPResponse, HTTPSConnection
from typing import NamedTuple
from urllib.parse import SplitResult, quote, unquote, urljoin, urlsplit

from hapticplayer.errors import InputError, Message
from hapticplayer.untrusted import without_controls

SCHEMES = ("http", "https")
MAX_REDIRECTS = 5
ANSWER_S = 5.0
"""How long a web server may say nothing before it is asked again."""

_PART = re.compile(r"bytes (\d{1,18})-(\d{1,18})/(\d{1,18})")
_UNESCAPED = "%/:=&?~#+!$,;'@()*[]"
_REDIRECTS = (301, 302, 303, 307, 308)
_DOWNLOAD = Message("download it and play the file")
_ASK = Message("check the address, or ask who offers the file")


class NetworkError(InputError):
    """A file cannot be offered, reached or used."""


class Unreachable(Exception):  # noqa: N818 - it may be reached the next time
    """There was no whole answer; `args[0]` is why."""


class Aborted(Unreachable):
    """Something else is more urgent."""


class NotOfferedError(NetworkError):
    """The server has no such file, or not for us."""


class Version(NamedTuple):
    """What tells one state of a file on a server from another."""

    size_bytes: int
    etag: str
    modified: str

    def is_same(self, other: "Version") -> bool:
        """Whether both are of one state, as far as the server says."""
        if self.size_bytes != other.size_bytes:
            return False
        if self.etag and other.etag:
            return self.etag == other.etag
        return self.modified == other.modified


class RangeClient:
    """One connection at a time to the server of a file, for one thread.

    Attributes:
        name: of the file, for people.
        where: server and file, without what may be secret.
        version: of the file at the first answer; later ones have to be of the same.

    Raises:
        NetworkError: when the URL is not the address of a file.
    """

    def __init__(self, url: str) -> None:
        self.version: Version | None = None
        self._first = self._target = _target_of(url)
        name = unquote(self._first.path.rpartition("/")[2])
        self.name = without_controls(name)[:200].replace("/", "?") or "clip"
        host = without_controls(self._first.netloc)
        self.where = f"{self._first.scheme}://{host}: {self.name}"
        self._connection: HTTPConnection | None = None
        self._sock: socket.socket | None = None  # also of an answer that closes it
        self._is_public = False  # whether the address that was given is
        self._is_closed = self._is_aborted = False

    @property
    def url(self) -> str:
        """The address that was given."""
        return self._first.geturl()

    def part(self, begin: int, end: int, piece_bytes: int) -> Iterator[bytes]:
        """Yield a part of the file as it comes, in pieces of a size; the last may be less.

        Raises:
            Unreachable: for now; it is worth asking again.
        """
        try:
            yield from self._part(begin, end, piece_bytes)
        except (OSError, HTTPException, ValueError) as problem:
            self.drop()
            if self._is_aborted:
                raise Aborted from problem
            self._target = self._first
            raise Unreachable(_reason(problem)) from problem
        except BaseException:
            self.drop()
            raise

    def abort(self) -> None:
        """Give up what is being waited for; called from another thread."""
        self._is_aborted = True
        if (sock := self._sock) is not None:
            with contextlib.suppress(OSError):  # it has gone by itself
                # not that of TLS, which would let the thread read on without it
                socket.socket.shutdown(sock, socket.SHUT_RDWR)

    def close(self) -> None:
        """Give up, and ask for nothing any more; called from another thread."""
        self._is_closed = True
        self.abort()

    def drop(self) -> None:
        """Hang up; the next question opens another connection."""
        connection, self._connection, self._sock = self._connection, None, None
        if connection is not None:
            connection.close()

    def _part(self, begin: int, end: int, piece_bytes: int) -> Iterator[bytes]:
        is_kept, self._is_aborted = self._connection is not None, False
        try:
            response = self._asked(begin, end)
        except (ConnectionError, HTTPException):
            if not is_kept or self._is_aborted:
                raise
            self.drop()  # the server has closed it since the last answer
            response = self._asked(begin, end)
        with response:
            left = self._checked_size(response, begin, end)
            while left:
                piece = response.read(min(left, piece_bytes))
                if len(piece) < min(left, piece_bytes):
                    raise ConnectionError("the answer ended early")
                left -= len(piece)
                yield piece
            if response.will_close or not response.isclosed():
                self.drop()

    def _asked(self, begin: int, end: int) -> HTTPResponse:
        for _ in range(MAX_REDIRECTS + 1):
            connection, target = self._connected(), self._target
            path = quote(target.path or "/", safe=_UNESCAPED)
            query = f"?{quote(target.query, safe=_UNESCAPED)}" if target.query else ""
            wanted = {"Range": f"bytes={begin}-{end - 1}"}
            connection.request("GET", path + query, headers=wanted)
            response = connection.getresponse()
            if response.status not in _REDIRECTS:
                return response
            self._follow(response.getheader("Location", ""))
        raise self._refusal(Message("redirects too often"), _ASK)

    def _follow(self, location: str) -> None:
        self.drop()
        where, scheme = self._target.geturl(), self._target.scheme
        self._target = _target_of(urljoin(where, location), shown=self.where)
        if self._target.scheme != scheme:
            raise self._refusal(
                Message("redirects from {scheme} to another scheme", scheme=scheme),
                Message("give the address that it leads to, if you trust it"),
            )

    def _connected(self) -> HTTPConnection:
        if self._is_closed:
            raise ConnectionError("closed")
        if self._connection is None:
            target = self._target
            host, port = target.hostname or "", target.port
            made: HTTPConnection = (
                HTTPSConnection(
                    host, port, timeout=ANSWER_S, context=ssl.create_default_context()
                )
                if target.scheme == "https"
                else HTTPConnection(host, port, timeout=ANSWER_S)
            )
            made.connect()
            self._connection, self._sock = made, made.sock
            self._refuse_inward(made.sock.getpeername()[0])
        return self._connection

    def _refuse_inward(self, address: str) -> None:
        """Let nobody outside send us to what only we can reach."""
        if self._target is self._first:
            self._is_public = is_public(address)
        elif self._is_public and not is_public(address):
            raise self._refusal(Message("redirects to a private address"), _ASK)

    def _checked_size(self, response: HTTPResponse, begin: int, end: int) -> int:
        """Return how many bytes come; raises unless they are those of the same file."""
        self._check_status(response.status)
        found = _PART.fullmatch(response.getheader("Content-Range", ""))
        if found is None or response.getheader("Content-Encoding", "identity") != (
            "identity"
        ):
            raise self._refusal(Message("does not give parts of this file"), _DOWNLOAD)
        first, last, size_bytes = map(int, found.groups())
        version = Version(
            size_bytes,
            response.getheader("ETag", ""),
            response.getheader("Last-Modified", ""),
        )
        if self.version is None:
            self.version = version
        if not self.version.is_same(version):
            raise self._refusal(
                Message("was changed on the server"), Message("open it again")
            )
        count, whole = last + 1 - first, (begin, min(end, size_bytes))
        if (first, last + 1) != whole or response.length not in (None, count):
            raise self._refusal(Message("sends another part than was asked for"), _ASK)
        return count

    def _check_status(self, status: int) -> None:
        if status == HTTPStatus.PARTIAL_CONTENT:
            return
        if status == HTTPStatus.OK:
            raise self._refusal(
                Message("its server does not give parts of files (HTTP ranges)"),
                _DOWNLOAD,
            )
        if (
            status >= HTTPStatus.INTERNAL_SERVER_ERROR
            or status == HTTPStatus.TOO_MANY_REQUESTS
        ):
            raise ConnectionError(f"status {status}")
        if status == HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE:
            raise self._refusal(Message("is empty or has become shorter"), _ASK)
        what = Message("is refused by its server (status {status})", status=status)
        raise NotOfferedError(what, where=self.where, remedy=_ASK)

    def _refusal(self, what: Message, remedy: Message) -> NetworkError:
        return NetworkError(what, where=self.where, remedy=remedy)


def _reason(problem: Exception) -> str:
    """What went wrong, in the system's words."""
    if isinstance(problem, ssl.SSLCertVerificationError):
        return f"its certificate is not valid: {problem.verify_message}"
    if isinstance(problem, TimeoutError):
        return "no answer in time"
    text = getattr(problem, "strerror", None) or str(problem)
    return without_controls(text)[:200] or type(problem).__name__


def _target_of(url: str, shown: str = "") -> SplitResult:
    """Return the parts of an address; `shown` is what messages name instead."""
    try:
        parts = urlsplit(url)
        is_usable = bool(parts.scheme in SCHEMES and parts.hostname and parts.port != 0)
    except ValueError:
        parts, is_usable = urlsplit(""), False
    if not is_usable:
        raise NetworkError(
            "is not the address of a file",
            where=shown or "URL",
            remedy="give one that begins with http:// or https://",
        )
    if parts.username is not None or parts.password is not None:
        raise NetworkError(
            "holds a user name or password, which would be shown and stored",
            where=shown or f"{parts.scheme}://{without_controls(parts.hostname or '')}",
            remedy="give a link that needs none, such as a signed one",
        )
    return parts._replace(fragment="")


def is_public(address: str) -> bool:
    """Whether everybody on the internet can reach an address."""
    found = ipaddress.ip_address(address)
    mapped = getattr(found, "ipv4_mapped", None)
    return bool((mapped or found).is_global)
