"""Nothing but a stream is asked for, and no server can keep or flood the client."""

import socket
import threading

import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import NetworkError
from hapticplayer.streaming import client
from hapticplayer.streaming.client import StreamAddress, StreamClient, Unreachable
from hapticplayer.streaming.manifest import MANIFEST
from hapticplayer.streaming.opening import is_address, open_stream

TOKEN = "t" * 22


@pytest.mark.parametrize(
    ("url", "address"),
    [
        (f"http://127.0.0.1:8000/{TOKEN}/manifest.json", ("127.0.0.1", 8000, TOKEN)),
        (f"http://ride.local/{TOKEN}/", ("ride.local", 80, TOKEN)),
        (f"HTTP://[::1]:9/{TOKEN}/manifest.json", ("::1", 9, TOKEN)),
    ],
)
def test_the_address_that_serve_prints_is_understood(url, address):
    assert is_address(url)
    assert StreamAddress.of(url) == address
    assert TOKEN not in str(StreamAddress.of(url))


@pytest.mark.parametrize(
    "url",
    [
        f"https://host/{TOKEN}/manifest.json",
        f"file:///{TOKEN}/manifest.json",
        f"http://host/{TOKEN}/other.json",
        f"http://host/{TOKEN}/clip",
        f"http://host/a/{TOKEN}/manifest.json",
        f"http://me:pw@host/{TOKEN}/manifest.json",
        f"http://host/{TOKEN}/manifest.json?a=b",
        f"http://host:99999/{TOKEN}/manifest.json",
        f"http://[::1/{TOKEN}/manifest.json",
        f"http:///{TOKEN}/manifest.json",
        "http://host/manifest.json",
        "http://host/..%2f..%2f..%2f/manifest.json",
        "http://host/clip.mp4",
        "http://host/\r\nEvil: x/manifest.json",
        "http://",
    ],
)
def test_other_addresses_are_refused_before_any_is_asked(url, monkeypatch):
    monkeypatch.setattr(client, "HTTPConnection", None)
    with pytest.raises(NetworkError, match="is not the address of a stream") as caught:
        open_stream(url, SystemClock())
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("path", "is_one"),
    [
        ("ride.mkv", False),
        ("/http/x.mkv", False),
        ("http:x", False),
        ("x http://", False),
    ],
)
def test_names_of_files_are_no_addresses(path, is_one):
    assert is_address(path) is is_one


class hostile:  # noqa: N801 - used as a function
    """A server that answers each connection with the same bytes, piece by piece."""

    def __init__(self, *pieces, pause_s=0.0):
        self._pieces, self._pause_s = pieces, pause_s
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    @property
    def address(self):
        return StreamAddress("127.0.0.1", self._listener.getsockname()[1], TOKEN)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._is_over.set()
        self._listener.close()

    def _run(self):
        try:
            while True:
                end = self._listener.accept()[0]
                threading.Thread(target=self._answer, args=(end,), daemon=True).start()
        except OSError:
            return

    def _answer(self, end):
        with end:
            try:
                end.recv(1 << 16)
                for piece in self._pieces:
                    end.sendall(piece)
                    if self._is_over.wait(self._pause_s):
                        return
            except OSError:
                return


def got(server, most_bytes=100, span=None):
    one = StreamClient(server.address, SystemClock())
    try:
        return one.get("clip", most_bytes, span)
    finally:
        one.drop()


OK, PART = b"HTTP/1.1 200 OK\r\n", b"HTTP/1.1 206 Partial Content\r\n"


@pytest.mark.parametrize(
    "answer",
    [
        OK + b"Content-Length: 101\r\n\r\n" + bytes(101),
        OK + b"Content-Length: 999999999999\r\n\r\n",
        b"HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:9/\r\nContent-Length: 0\r\n\r\n",
        b"HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\n\r\n",
        b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n",
        PART + b"Content-Range: bytes 0-1/9\r\nContent-Length: 2\r\n\r\nab",
    ],
)
def test_an_answer_of_another_kind_is_refused_for_good(answer):
    with hostile(answer) as server, pytest.raises(NetworkError) as caught:
        got(server)
    assert str(caught.value).startswith("http://127.0.0.1:")


@pytest.mark.parametrize(
    "answer",
    [
        b"",
        b"\x00\xff nonsense\r\n\r\n",
        OK + b"\r\nabc",
        OK + b"Transfer-Encoding: chunked\r\n\r\n5\r\nabcde\r\n0\r\n\r\n",
        b"HTTP/1.1 200 OK\r\n" + b"A: b\r\n" * 1000,
        b"HTTP/1.1 200 OK\r\nA: " + b"b" * 100_000,
        OK + b"Content-Length: 50\r\n\r\nshort",
        OK + b"Content-Length: -5\r\n\r\n",
        b"HTTP/1.1 503 Busy\r\nContent-Length: 0\r\n\r\n",
    ],
)
def test_an_answer_that_is_broken_may_be_whole_next_time(answer):
    with hostile(answer) as server, pytest.raises((Unreachable, NetworkError)):
        got(server)


@pytest.mark.parametrize(
    "pieces",
    [
        [OK] + [b"A: b\r\n"] * 1000,
        [OK + b"Content-Length: 100\r\n\r\n"] + [b"x"] * 99,
        [b"HTTP"] + [b" "] * 1000,
    ],
)
def test_bytes_that_trickle_in_are_given_up_in_time(pieces, monkeypatch):
    monkeypatch.setattr(client, "ANSWER_S", 0.3)
    slow = hostile(*pieces, pause_s=0.05)
    with slow as server, pytest.raises(Unreachable, match="timed out"):
        got(server)


def test_another_part_than_was_asked_for_is_refused():
    answer = PART + b"Content-Range: bytes 5-9/100\r\nContent-Length: 5\r\n\r\nabcde"
    with hostile(answer) as server, pytest.raises(NetworkError, match="another part"):
        got(server, 5, (0, 5, 100))


def test_what_is_waited_for_can_be_given_up(monkeypatch):
    monkeypatch.setattr(client, "ANSWER_S", 60.0)
    with hostile(OK, pause_s=60.0) as server:
        one = StreamClient(server.address, SystemClock())
        threading.Timer(0.2, one.close).start()
        with pytest.raises(Unreachable):
            one.get("clip", 100)
        with pytest.raises(Unreachable, match="closed"):
            one.get("clip", 100)


@pytest.mark.parametrize("content", [b"{}", b"\xff", b"[1]"])
def test_a_manifest_of_another_kind_is_refused(content):
    answer = OK + b"Content-Length: %d\r\n\r\n" % len(content) + content
    with hostile(answer) as server:
        url = f"{server.address}/{TOKEN}/{MANIFEST}"
        with pytest.raises(NetworkError, match=r"manifest\.json"):
            open_stream(url, SystemClock())


def test_nobody_at_the_address_is_one_sentence():
    with socket.create_server(("127.0.0.1", 0)) as unused:
        url = f"http://127.0.0.1:{unused.getsockname()[1]}/{TOKEN}/"
    with pytest.raises(NetworkError, match="cannot be reached") as caught:
        open_stream(url, SystemClock())
    assert "\n" not in str(caught.value)
