"""A clip on a web server reads like the file, and no server can do harm."""

import contextlib
import os
import ssl
import subprocess

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import MediaError
from hapticplayer.extras.web import http_clip, http_range
from hapticplayer.extras.web.http_clip import HttpClip
from hapticplayer.extras.web.http_range import NetworkError
from hapticplayer.media.video import VideoDecoder
from tests.web_server import WebServer, wait_for

CLOCK = SystemClock()


@pytest.fixture
def content(rng):
    return rng.bytes(50_123)


@pytest.fixture
def server(content):
    with WebServer({"/ride.mkv": content, "/ride.haptics.mkv": b"side"}) as made:
        yield made


@contextlib.contextmanager
def opened(url):
    clip = HttpClip(url, CLOCK)
    try:
        yield clip
    finally:
        clip.close()


@pytest.fixture
def small(monkeypatch):
    """Blocks so small that the file has many."""
    monkeypatch.setattr(http_clip, "BLOCK_BYTES", 1000)
    monkeypatch.setattr(http_clip, "_RETRY_S", 0.001)


@pytest.mark.parametrize("block_bytes", [100, 1000, 1 << 17])
def test_bytes_are_those_of_the_file(server, content, rng, monkeypatch, block_bytes):
    monkeypatch.setattr(http_clip, "BLOCK_BYTES", block_bytes)
    with opened(server.url()) as clip, clip.open() as reader, clip.open() as other:
        assert (clip.name, clip.size_bytes) == ("ride.mkv", len(content))
        assert other.read() == content
        for at in rng.integers(0, len(content) + 10, 40).tolist():
            reader.seek(at)
            assert reader.read(500) == content[at : at + 500]
        reader.seek(-7, os.SEEK_END)
        assert reader.read() == content[-7:]


def test_frames_are_those_of_the_file(tiny_clip):
    with (
        WebServer({"/a.mp4": tiny_clip.path.read_bytes()}) as server,
        opened(server.url("/a.mp4")) as clip,
        VideoDecoder(clip) as far,
        VideoDecoder(tiny_clip.path) as near,
    ):
        for a, b in zip(far.frames(), near.frames(), strict=True):
            assert np.array_equal(a.native.to_ndarray(), b.native.to_ndarray())
        far.seek(1.0)
        assert far.next_frame().pts_s == pytest.approx(1.0)


def test_memory_is_limited(server, content, monkeypatch):
    monkeypatch.setattr(http_clip, "BLOCK_BYTES", 100)
    monkeypatch.setattr(http_clip, "KEPT_BLOCKS", 20)
    monkeypatch.setattr(http_clip, "AHEAD_BLOCKS", 5)
    with opened(server.url()) as clip, clip.open() as reader:
        assert reader.read() == content
        reader.seek(0)
        assert reader.read() == content
    begun = [span for _, span in server.asked if span.startswith("bytes=0-")]
    assert len(begun) == 2


def test_a_leap_goes_before_what_lies_ahead(server, content, small, monkeypatch):
    monkeypatch.setattr(http_clip, "AHEAD_BLOCKS", 20)
    with opened(server.url()) as clip, clip.open() as reader:
        reader.read(1)
        wait_for(lambda: clip.is_ahead(0.15))
        reader.seek(48_000)
        assert reader.read(10) == content[48_000:48_010]
        spans = [span for _, span in server.asked]
    assert spans[:2] == ["bytes=0-1999", "bytes=2000-19999"]
    assert "bytes=48000-50999" in spans


def test_reading_ahead_is_known(server, small, monkeypatch):
    monkeypatch.setattr(http_clip, "AHEAD_BLOCKS", 20)
    with opened(server.url()) as clip, clip.open() as reader:
        server.gate.clear()
        reader.read(1)
        assert clip.is_ahead(0.01)
        assert not clip.is_ahead(0.15)
        server.gate.set()
        wait_for(lambda: clip.is_ahead(0.15))


@pytest.mark.parametrize(
    ("fault", "reason"),
    [
        ({"most_bytes": 0}, "the answer ended early"),
        ({"statuses": [503] * 1000}, "status 503"),
        ({"statuses": [429] * 1000}, "status 429"),
        ({"lies": {"ETag": '"another"'}}, "was changed on the server"),
        ({"lies": {"Content-Range": "bytes 0-1/7"}}, "was changed on the server"),
        ({"lies": {"Content-Range": "bytes 7-9/50123"}}, "sends another part"),
        ({"lies": {"Content-Length": "99999"}}, "sends another part"),
        ({"lies": {"Content-Range": None}}, "does not give parts"),
        ({"lies": {"Content-Encoding": "gzip"}}, "does not give parts"),
        ({"statuses": [403] * 1000}, "is refused by its server (status 403)"),
        ({"gives_ranges": False}, "does not give parts"),
    ],
)
def test_a_reader_waits_with_a_reason_and_goes_on(
    server, content, small, fault, reason
):
    with opened(server.url()) as clip, clip.open() as reader:
        clip.patience_s = 30.0
        before = {name: getattr(server, name) for name in fault}
        for name, value in fault.items():
            setattr(server, name, value)
        reader.read(10)
        wait_for(lambda: clip.waiting)
        assert reason in clip.waiting
        assert "ride.mkv" in clip.waiting
        for name, value in before.items():
            setattr(server, name, value if name != "statuses" else [])
        reader.seek(30_000)
        assert reader.read(20) == content[30_000:30_020]
        assert clip.waiting is None


def test_a_server_that_stalls_is_waited_for_so_long(server, small, monkeypatch):
    monkeypatch.setattr(http_range, "ANSWER_S", 0.05)
    with opened(server.url()) as clip, clip.open() as reader:
        server.gate.clear()
        clip.patience_s = 0.3
        reader.seek(40_000)
        with pytest.raises(MediaError, match="cannot be fetched"):
            reader.read(1)


def test_closing_wakes_who_waits(server, small):
    with opened(server.url()) as clip:
        server.gate.clear()
        reader = clip.open()
        reader.seek(40_000)
        clip.close()
        with pytest.raises(MediaError, match="cannot be fetched"):
            reader.read(1)


@pytest.mark.parametrize(
    ("fault", "sentence"),
    [
        ({"gives_ranges": False}, "does not give parts of files.*download it and play"),
        (
            {"lies": {"Content-Range": "bytes 0-9/*"}},
            "does not give parts.*download it",
        ),
        ({"statuses": [404]}, r"is refused by its server \(status 404\)"),
        ({"statuses": [416]}, "is empty"),
        ({"statuses": [500]}, r"cannot be reached \(status 500\)"),
        ({"moved": {"/ride.mkv": "/ride.mkv"}}, "redirects too often"),
        ({"moved": {"/ride.mkv": "ftp://x/ride.mkv"}}, "is not the address of a file"),
        (
            {"moved": {"/ride.mkv": "file:///etc/passwd"}},
            "is not the address of a file",
        ),
        ({"moved": {"/ride.mkv": "https://127.0.0.1/s3cret"}}, "to another scheme"),
    ],
)
def test_no_part_means_one_sentence(server, fault, sentence):
    for name, value in fault.items():
        setattr(server, name, value)
    with pytest.raises(NetworkError, match=sentence) as refused:
        HttpClip(server.url("/ride.mkv?key=s3cret"), CLOCK)
    assert "s3cret" not in str(refused.value)
    assert str(refused.value).startswith("http://127.0.0.1:")


def test_a_redirect_is_followed_and_kept(server, content, small):
    server.moved["/old/ride.mkv"] = "../ride.mkv?signed"
    with opened(server.url("/old/ride.mkv")) as clip, clip.open() as reader:
        assert reader.read() == content
    assert [path for path, _ in server.asked].count("/old/ride.mkv") == 1


def test_a_public_server_cannot_send_us_inside(server, monkeypatch):
    server.moved["/ride.mkv"] = "/secret"
    peers = iter([True, False])
    monkeypatch.setattr(http_range, "is_public", lambda _peer: next(peers))
    with pytest.raises(NetworkError, match="redirects to a private address"):
        HttpClip(server.url(), CLOCK)
    assert [path for path, _ in server.asked] == ["/ride.mkv"]


@pytest.mark.parametrize(
    ("address", "is_public"),
    [
        ("8.8.8.8", True),
        ("2001:4860:4860::8888", True),
        ("127.0.0.1", False),
        ("10.1.2.3", False),
        ("169.254.169.254", False),
        ("::1", False),
        ("fe80::1%eth0", False),
        ("::ffff:192.168.1.1", False),
    ],
)
def test_private_addresses_are_known(address, is_public):
    assert http_range.is_public(address) is is_public


@pytest.mark.parametrize(
    "url",
    [
        "ftp://a/b",
        "http://",
        "http://a:b/c",
        "http://a:0/c",
        "https:///x",
        "http://[a/c",
    ],
)
def test_other_addresses_are_refused(url):
    with pytest.raises(NetworkError, match="is not the address of a file"):
        HttpClip(url, CLOCK)


def test_passwords_are_refused_and_not_repeated():
    with pytest.raises(NetworkError, match="holds a user name") as refused:
        HttpClip("https://me:s3cret@example.org/ride.mkv", CLOCK)
    assert "s3cret" not in str(refused.value)


def test_a_closed_port_is_one_sentence():
    with pytest.raises(NetworkError, match=r"cannot be reached \(Connection refused\)"):
        HttpClip("http://127.0.0.1:9/ride.mkv", CLOCK)


def test_the_file_beside_is_found_or_not(server):
    with opened(server.url("/ride.mkv?key=1")) as clip:
        beside = clip.beside("ride.haptics.mkv")
        assert beside.open().read() == b"side"
        beside.close()
        assert clip.beside("other.mkv") is None
    assert server.asked[1][0] == "/ride.haptics.mkv?key=1"


def test_a_certificate_has_to_be_valid(tmp_path, content):
    words = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2"]
    files = ["-keyout", str(tmp_path / "key"), "-out", str(tmp_path / "certificate")]
    names = ["-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost"]
    subprocess.run([*words, *files, *names], check=True, capture_output=True)
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    context.load_cert_chain(tmp_path / "certificate", tmp_path / "key")
    with WebServer({"/ride.mkv": content}, context) as server:
        with pytest.raises(NetworkError, match="certificate is not valid"):
            HttpClip(server.url(host="localhost"), CLOCK)
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("SSL_CERT_FILE", str(tmp_path / "certificate"))
            with opened(server.url(host="localhost")) as clip, clip.open() as reader:
                assert reader.read() == content
            with pytest.raises(NetworkError, match="certificate is not valid"):
                HttpClip(server.url(), CLOCK)  # of another host
