"""The window plays a clip on a web server as it plays a file, and remembers nothing of it."""

import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.extras.web import http_clip
from hapticplayer.extras.web.http_clip import HttpClip
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.pack import pack
from tests.web_server import WebServer


@pytest.fixture
def server(sequence, tmp_path):
    pack(sequence, tmp_path / "ride.mkv")
    with WebServer({"/ride.mkv": (tmp_path / "ride.mkv").read_bytes()}) as made:
        yield made


@pytest.fixture
def source(server):
    found = open_source(HttpClip(server.url(), SystemClock()))
    yield found
    found.clip.remote.close()


def test_a_remote_clip_plays_and_is_not_remembered(window, source, wait_for):
    window.session.show_source(source)
    player = window.session.player
    player.play()
    wait_for(lambda: player.snapshot().media_s > 0.3)
    assert player.snapshot().frames_shown
    window.transport.slider.hovered.emit(0.5)
    assert not window.extras.thumbnails.is_busy
    window.extras.history.note_position(player)
    window.session.show_source(source)
    assert not window.extras.history.recent()


@pytest.fixture
def little_memory(monkeypatch):
    """What was read to open a clip is forgotten when it plays."""
    monkeypatch.setattr(http_clip, "BLOCK_BYTES", 1000)
    monkeypatch.setattr(http_clip, "KEPT_BLOCKS", 4)
    monkeypatch.setattr(http_clip, "AHEAD_BLOCKS", 2)


def test_why_a_remote_clip_waits_is_shown(
    little_memory, window, source, server, wait_for
):
    server.gate.clear()
    window.session.show_source(source)
    window.session.player.play()
    wait_for(lambda: "ride.mkv: waiting for the server" in window.session.last_problem)
