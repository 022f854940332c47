"""What `serve` gives, and to whom."""

import os
import socket
import threading
from http.client import HTTPConnection
from urllib.parse import urlsplit

import pytest

from hapticplayer.extras.web.http_range import NetworkError
from hapticplayer.extras.web.serving import (
    FileServer,
)
from tests.web_server import wait_for


class served(FileServer):  # noqa: N801 - used as a function
    """A server whose thread runs within a `with` block."""

    def __init__(self, files, **how):
        super().__init__(files, **how)
        self.thread = threading.Thread(target=self.serve_forever, args=(0.01,))

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.shutdown()
        self.thread.join()
        self.server_close()


@pytest.fixture
def file(tmp_path, rng):
    made = tmp_path / "a ride.mkv"
    made.write_bytes(rng.bytes(5000))
    return made


@pytest.fixture
def server(file):
    with served([file]) as made:
        yield made


@pytest.fixture
def ask(server):
    """Ask the server for a path below its token, unless another one is given."""
    place = urlsplit(server.url)
    connection = HTTPConnection(place.hostname, place.port, timeout=10)

    def asked(name="a%20ride.mkv", token=None, method="GET", **headers):
        path = f"/{server.token if token is None else token}/{name}"
        named = {key.replace("_", "-"): value for key, value in headers.items()}
        connection.request(method, path, headers=named)
        response = connection.getresponse()
        return response, response.read()

    yield asked
    connection.close()


def test_the_file_comes_whole_and_in_parts(ask, file):
    whole = file.read_bytes()
    assert ask()[1] == whole
    response, content = ask(Range="bytes=100-299")
    assert (response.status, content) == (206, whole[100:300])
    assert response.getheader("Content-Range") == f"bytes 100-299/{len(whole)}"
    assert ask(Range="bytes=-7")[1] == whole[-7:]
    response, content = ask(Range=f"bytes={len(whole)}-")
    assert (response.status, content) == (416, b"")


def test_a_request_with_the_whole_address_is_answered(server, file):
    with connected(server) as proxy:
        address = server.url.replace("http:", "HTTP:")
        proxy.sendall(f"GET {address} HTTP/1.1\r\nHost: a\r\n\r\n".encode())
        with proxy.makefile("rb") as answer:
            assert answer.readline().startswith(b"HTTP/1.1 200")


def test_a_part_of_another_state_is_the_whole_file(ask, file):
    first, _ = ask(Range="bytes=0-9")
    same = [first.getheader("ETag"), first.getheader("Last-Modified")]
    for tag, status in [*((one, 206) for one in same), ('"another"', 200)]:
        assert ask(Range="bytes=0-9", If_Range=tag)[0].status == status
    assert ask(Range="bytes=0-9", If_Range=f"W/{same[0]}")[0].status == 200
    os.utime(file, (0, 0))
    assert ask(Range="bytes=0-9", If_Range=same[0])[0].status == 200
    assert ask()[0].getheader("ETag") != same[0]


@pytest.mark.parametrize(
    ("header", "wanted"),
    [
        ("bytes=0-", (0, 5000)),
        ("bytes=4999-8000", (4999, 5000)),
        ("bytes=-8000", (0, 5000)),
        ("bytes=5000-", None),
        ("bytes=9-8", None),
        ("bytes=-0", None),
    ],
)
def test_a_range_is_met_or_refused(ask, file, header, wanted):
    response, content = ask(Range=header)
    assert response.status == (206 if wanted else 416)
    assert content == (file.read_bytes()[slice(*wanted)] if wanted else b"")


@pytest.mark.parametrize("header", ["bytes=-", "bytes=0-1,3-4", "lines=1-2", "x"])
def test_a_header_that_is_not_one_range_is_ignored(ask, file, header):
    response, content = ask(Range=header)
    assert (response.status, content) == (200, file.read_bytes())


@pytest.mark.parametrize("token", ["", "x", "%", "A" * 22, "."])
def test_a_wrong_token_gets_nothing(ask, token):
    response, content = ask(token=token)
    assert (response.status, content) == (403, b"")


def test_a_token_that_is_not_ascii_gets_nothing(server):
    with connected(server) as rude:
        rude.sendall("GET /\xff\xe9/clip HTTP/1.1\r\n\r\n".encode("latin-1"))
        assert rude.recv(100).startswith(b"HTTP/1.1 403")


@pytest.mark.parametrize(
    "name", ["", "a%20ride.mkv/", "../a%20ride.mkv", "%2fetc%2fpasswd", "%2e%2e", "%"]
)
def test_another_name_is_not_found(ask, name):
    response, content = ask(name)
    assert (response.status, content) == (404, b"")


def test_only_reading_is_possible(ask, file):
    response, content = ask(method="HEAD")
    assert (response.status, content) == (200, b"")
    assert int(response.getheader("Content-Length")) == file.stat().st_size
    assert ask(method="PUT")[0].status == 501


@pytest.mark.parametrize(
    "length",
    [
        "Content-Length: 40",
        "Content-Length: 0\r\nContent-Length: 40",
        "Content-Length: +40",
        "content-length: 0, 40",
        "Transfer-Encoding: chunked",
        "Content-Length : 40",
        "nonsense\r\nContent-Length: 40",
        " Content-Length: 40",
        "A: b\r\n\tContent-Length: 40",
    ],
)
def test_a_body_is_not_taken_for_the_next_request(server, length):
    path = f"/{server.token}/a%20ride.mkv"
    body = f"GET {path} HTTP/1.1\r\nHost: a\r\nA: b\r\n\r\n"
    with connected(server) as rude:
        rude.sendall(f"GET {path} HTTP/1.1\r\n{length}\r\n\r\n{body}".encode())
        with rude.makefile("rb") as answers:
            found = answers.read()
    assert found.startswith(b"HTTP/1.1 400")
    assert found.count(b"HTTP/1.1") == 1


def test_a_file_that_is_gone_is_not_found(ask, file):
    file.unlink()
    assert ask()[0].status == 404


def test_others_reach_it_only_when_told(server):
    assert server.server_address[0] == "127.0.0.1"
    assert server.url.startswith(f"http://127.0.0.1:{server.server_address[1]}/")
    assert len(server.token) == 22  # 128 bits


def test_a_port_in_use_is_refused_in_one_sentence(server, file):
    with pytest.raises(NetworkError, match=r"^127.0.0.1: cannot listen on port"):
        served([file], port=server.server_address[1])


def connected(server):
    return socket.create_connection(server.server_address[:2], timeout=10)


@pytest.mark.parametrize("said", [b"", b"GET /", b"GET / HTTP/1.1\r\nA: b\r\n"])
def test_who_never_finishes_a_request_is_hung_up_on(server, monkeypatch, said):
    monkeypatch.setattr(server.RequestHandlerClass, "timeout", 0.1)
    with connected(server) as slow:
        slow.sendall(said)
        wait_for(lambda: server.connections)
        wait_for(lambda: not server.connections)
        assert slow.recv(100) == b""


def test_one_address_cannot_take_all_connections(server, ask):
    crowd = [connected(server) for _ in range(server.most_of_one)]
    with connected(server) as one_more:
        assert one_more.recv(100) == b""
    for one in crowd:
        one.close()
    wait_for(lambda: not server.connections)
    assert ask()[0].status == 200


def test_ending_hangs_up_on_everybody(file):
    with served([file]) as server:
        viewer = connected(server)
        wait_for(lambda: server.connections)
    assert viewer.recv(100) == b""
    viewer.close()


def test_who_takes_no_bytes_is_hung_up_on(file, monkeypatch):
    os.truncate(file, 64 << 20)  # more than any buffer on the way
    with served([file]) as server, monkeypatch.context() as patch:
        patch.setattr(server.RequestHandlerClass, "timeout", 0.3)
        lazy = connected(server)
        path = urlsplit(server.url).path
        lazy.sendall(f"GET {path} HTTP/1.1\r\n\r\n".encode())
        assert lazy.recv(15) == b"HTTP/1.1 200 OK"
        wait_for(lambda: not server.connections)
        lazy.close()


def test_noise_in_place_of_requests_does_no_harm(server, ask, rng):
    for _ in range(100):
        with connected(server) as rude:
            rude.sendall(rng.bytes(int(rng.integers(1, 300))) + b"\r\n\r\n")
            rude.shutdown(socket.SHUT_WR)
            while rude.recv(1 << 16):
                pass
    assert ask()[0].status == 200
