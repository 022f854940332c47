"""A packed sequence, and a server for it on this machine."""

import threading
from http.client import HTTPConnection
from urllib.parse import urlsplit

import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.pack import pack
from hapticplayer.streaming.offer import Offer
from hapticplayer.streaming.server import StreamServer


def wait_for(condition):
    clock = SystemClock()
    end_s = clock.now_s() + 30.0
    while not condition():
        assert clock.now_s() < end_s, "it did not happen"
        clock.sleep_until(clock.now_s() + 0.002)


@pytest.fixture(autouse=True)
def _own_cache(tmp_path_factory, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))


@pytest.fixture
def packed(sequence_folder, tmp_path):
    target = tmp_path / "ride.mkv"
    pack(sequence_folder, target)
    return target


@pytest.fixture
def server(packed):
    with served(Offer(open_source(packed))) as server:
        yield server


class served(StreamServer):  # noqa: N801 - used as a function
    """A server whose thread runs within a `with` block."""

    def __init__(self, offer, clock=None, **how):
        super().__init__(offer, clock or SystemClock(), **how)
        self.thread = threading.Thread(target=self.serve_forever, args=(0.01,))

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.shutdown()
        self.thread.join()
        self.server_close()


@pytest.fixture
def ask(server):
    """Return what asks the server for a resource, with its token unless another one is given."""
    place = urlsplit(server.url)
    connection = HTTPConnection(place.hostname, place.port, timeout=10)

    def asked(resource, token=None, method="GET", **headers):
        path = f"/{server.token if token is None else token}/{resource}"
        connection.request(method, path, headers=headers)
        response = connection.getresponse()
        return response, response.read()

    yield asked
    connection.close()
