"""What nobody sees is not drawn: hidden, minimised and covered windows and plots."""

import numpy as np
import pytest
from PySide6.QtWidgets import QWidget

from app.player.statistics import Statistics
from app.player.video_surface import SurfaceSink, VideoSurface
from app.plots.panel import PlotPanel
from app.widgets.room import is_seen
from hapticplayer.media import Picture
from hapticplayer.media.pictures import PictureConverter
from hapticplayer.playback.snapshot import Phase

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

    watch(PictureConverter, "_converted", "convert")
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
    window.extras.statistics.show_text("figures")
    window.session.show_source(source)
    player = window.player
    player.play()
    wait_for(lambda: player.snapshot().media_s > 0.3)
    seen = take(counts)
    assert all(seen.values()), seen
    with monkeypatch.context() as patch:
        put_away(window, way, patch)
        play_unseen(window, wait_for, counts)
    window.showNormal()
    at_s = player.snapshot().media_s
    wait_for(
        lambda: (
            player.snapshot().phase is Phase.ENDED
            or player.snapshot().media_s > at_s + 0.3
        )
    )
    back = take(counts)
    assert back["convert"] >= 3
    assert back["paint"] >= 3


def play_unseen(window, wait_for, counts):
    """Play on, and see that nothing is drawn."""
    player = window.player
    window.surface.look()
    wait_for(lambda: not is_seen(window.surface))
    at_s, shown = player.snapshot().media_s, player.snapshot().frames_shown
    take(counts)
    wait_for(lambda: player.snapshot().media_s > at_s + 0.4)
    unseen = take(counts)
    assert unseen["convert"] <= 1, "one may have been on its way"
    assert unseen["plots"] == unseen["statistics"] == unseen["paint"] == 0
    assert player.snapshot().frames_shown >= shown + 8
    assert (
        player.snapshot().frames_dropped == 0
        or player.snapshot().phase is Phase.PLAYING
    )


def test_a_window_restored_while_paused_shows_the_position(
    make_window, source, wait_for
):
    window = make_window()
    window.session.show_source(source)
    player, surface = window.player, window.surface
    player.play()
    wait_for(lambda: player.snapshot().media_s > 0.2)
    window.showMinimized()
    wait_for(lambda: player.snapshot().media_s > 0.8)
    player.pause()
    before_s = surface._picture.pts_s
    assert before_s < 0.6, "what nobody saw was converted"
    window.showNormal()
    wait_for(lambda: surface._picture.pts_s > before_s)
    media_s = player.snapshot().media_s
    assert surface._picture.pts_s <= media_s < surface._picture.pts_s + 0.04 + 1e-6
    assert player.snapshot().phase is Phase.PAUSED


def test_hidden_plots_cost_nothing_and_the_rest_is_drawn(playing, wait_for, counts):
    playing.show_plots(are_wanted=False)
    take(counts)
    at_s = playing.player.snapshot().media_s
    wait_for(lambda: playing.player.snapshot().media_s > at_s + 0.3)
    done = take(counts)
    assert done["plots"] == 0
    assert done["paint"] >= 3


def flat(level, owner=None):
    pixels = np.full((90, 160, 4), level, np.uint8)
    return Picture(0.0, 160, 90, 640, pixels.reshape(-1).data, owner or pixels)


@pytest.fixture
def surface(qtbot):
    made = VideoSurface()
    qtbot.addWidget(made)
    made.resize(160, 90)
    made.set_clip_size(160, 90)
    made.show()
    qtbot.waitExposed(made)
    return made


def test_a_picture_that_is_shown_already_is_not_painted_again(surface, counts):
    sink, first, other = SurfaceSink(surface), flat(40), flat(200)
    same = Picture(0.1, 160, 90, 640, first.pixels, first.owner)
    take(counts)
    for picture in (first, same, same, other, same):
        sink.show(picture)
    assert take(counts)["paint"] == 3
    assert surface.image.pixelColor(80, 45).red() == 40


def test_a_picture_without_pixels_leaves_what_is_shown(surface, counts):
    surface.present(flat(40))
    take(counts)
    surface.present(Picture.without_pixels(0.5, object()))
    assert take(counts)["paint"] == 0
    assert surface.image.pixelColor(80, 45).red() == 40


def test_a_surface_that_is_about_to_be_shown_counts_as_seen(qtbot):
    surface, told = VideoSurface(), []
    qtbot.addWidget(surface)
    surface.seen_changed.connect(told.append)
    surface.look()
    assert told == []  # the first pictures are ready before the window is
    surface.show()
    qtbot.waitUntil(lambda: surface._was_painted)
    assert told == []
    surface.hide()
    surface.look()
    assert told == [False]
    surface.show()
    qtbot.waitUntil(lambda: told == [False, True])


def test_a_widget_without_a_window_is_not_seen(qtbot):
    widget = QWidget()
    qtbot.addWidget(widget)
    assert not is_seen(widget)
