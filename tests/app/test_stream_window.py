"""The window plays a stream as it plays a file, and remembers nothing of it."""

import threading

import numpy as np
import pytest

from app.plots.panel import PlotPanel
from hapticplayer.clock import SystemClock
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.playback.source import open_source
from hapticplayer.streaming.offer import Offer
from hapticplayer.streaming.opening import open_stream
from hapticplayer.streaming.server import StreamServer


@pytest.fixture
def stream(sequence):
    with StreamServer(Offer(open_source(sequence)), SystemClock()) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.02,))
        thread.start()
        found = open_stream(server.url, SystemClock())
        yield found
        found.stream.close()
        server.shutdown()
        thread.join()


def test_a_stream_plays_and_is_not_remembered(window, stream, wait_for):
    window.session.show_source(stream)
    player = window.session.player
    player.play()
    wait_for(lambda: player.snapshot().media_s > 0.3)
    assert player.snapshot().frames_shown
    window.transport.slider.hovered.emit(0.5)
    assert not window.extras.thumbnails.is_busy
    window.extras.history.note_position(player)
    window.session.show_source(stream)
    assert not window.extras.history.recent()


def test_the_plot_shows_what_has_arrived(stream, sequence, qtbot, wait_for):
    panel = PlotPanel()
    qtbot.addWidget(panel)
    panel.set_source(stream)
    panel.follow(Snapshot(media_s=1.0, feedback="realistic"), TickHistory().since)
    wait_for(stream.stream.tracks["realistic"].has_arrived.all)
    panel.follow(Snapshot(media_s=1.0, feedback="realistic"), TickHistory().since)
    time_s, up = panel.force.curve_groups[0][1].getData()
    expected = open_source(sequence).tracks["realistic"].at(time_s)[:, 1]
    assert np.abs(up).max() > 0.5
    # the least and largest of a few milliseconds are drawn at the first of them
    assert np.abs(up - expected).max() < 0.1
