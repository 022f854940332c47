"""What nobody sees is not drawn: hidden, minimised and covered windows and plots."""

import pytest
from PySide6.QtWidgets import QWidget

from app.player.statistics import Statistics
from app.player.video_surface import VideoSurface
from app.plots.panel import PlotPanel
from app.widgets.layout import is_seen
from hapticplayer.media.frames import FrameConverter
from hapticplayer.playback.phases import Phase

WAYS = ("hidden", "minimised", "covered")


@pytest.fixture
def counts(monkeypatch):
    """Count what costs: conversions, paintings, and drawing of the plots."""
    found = {"convert": 0, "paint": 0, "plots": 0, "statistics": 0}

    def watch(owner, name, key):
        original = getattr(owner, name)

        def counted(*args, **more):
            found[key] += 1
            return original(*args, **more)

        monkeypatch.setattr(owner, name, counted)

    watch(FrameConverter, "convert", "convert")
    watch(VideoSurface, "_paint", "paint")
    watch(PlotPanel, "follow", "plots")
    watch(Statistics, "refresh", "statistics")
    return found


def put_away(window, way, monkeypatch):
    if way == "hidden":
        window.hide()
    elif way == "minimised":
        window.showMinimized()
    else:  # what Wayland and macOS tell of a window behind another one
        monkeypatch.setattr(
            type(window.windowHandle()), "isExposed", lambda _self: False
        )


def take(counts):
    taken = dict(counts)
    counts.update(dict.fromkeys(counts, 0))
    return taken


@pytest.mark.parametrize("way", WAYS)
def test_a_window_that_nobody_sees_paints_nothing_and_plays_on(
    make_window, source, wait_for, counts, way, monkeypatch
):
    window = make_window()
    window.plots.prepare()
    window.extras.statistics.show_text("figures")
    window.session.show_source(source)
    player = window.player
    player.set_loop((0.0, 1.9))  # however many frames a busy machine drops
    player.play()
    wait_for(lambda: player.snapshot().media_s > 0.3)
    seen = take(counts)
    assert all(seen.values()), seen
    with monkeypatch.context() as patch:
        put_away(window, way, patch)
        play_unseen(window, wait_for, counts, way)
    take(counts)
    window.showNormal()
    wait_for(lambda: min(counts["convert"], counts["paint"]) >= 3)


def play_unseen(window, wait_for, counts, way):
    """Play on, and see that nothing is drawn.

    Whether a minimised or covered window is painted, Qt decides by what the platform
    says; the offscreen platform says nothing.
    """
    player = window.player
    wait_for(lambda: not is_seen(window.surface))
    shown = player.snapshot().frames_shown
    take(counts)
    wait_for(lambda: player.snapshot().frames_shown >= shown + 8)
    unseen = take(counts)
    assert unseen["plots"] == unseen["statistics"] == 0
    assert way != "hidden" or unseen["paint"] == unseen["convert"] == 0


def test_a_window_restored_while_paused_shows_the_position(
    make_window, source, wait_for, counts
):
    window = make_window()
    window.session.show_source(source)
    player, surface = window.player, window.surface
    player.play()
    wait_for(lambda: player.snapshot().media_s > 0.2)
    window.hide()
    wait_for(lambda: player.snapshot().media_s > 0.8)
    player.pause()
    take(counts)
    window.show()
    wait_for(lambda: take(counts)["paint"] > 0)
    media_s = player.snapshot().media_s
    assert surface.frame.pts_s <= media_s < surface.frame.pts_s + 0.04 + 1e-6
    assert player.snapshot().phase is Phase.PAUSED


def test_hidden_plots_cost_nothing_and_the_rest_is_drawn(playing, wait_for, counts):
    playing.show_plots(are_wanted=False)
    take(counts)
    at_s = playing.player.snapshot().media_s
    wait_for(lambda: playing.player.snapshot().media_s > at_s + 0.3)
    done = take(counts)
    assert done["plots"] == 0
    assert done["paint"] >= 3


def test_a_widget_without_a_window_is_not_seen(qtbot):
    widget = QWidget()
    qtbot.addWidget(widget)
    assert not is_seen(widget)
