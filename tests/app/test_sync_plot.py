"""The sync plot shows what the meters measured, where it is seen and nowhere else."""

import hearing
import numpy as np
import pytest
from PySide6.QtGui import QColor

from app.player.sync_plot import LATE_MS, SPAN_S, SyncPlot, trace_of
from app.widgets import theme
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.meters import TRACE_EVENTS, SyncMeter
from hapticplayer.playback.snapshot import SyncTraces

NOW_S = 1000.0


def measured(late_ms, count=200, rate_hz=30.0):
    """A meter that has compared so many events with an exact loop."""
    ticks = np.zeros(round(1000 * count / rate_hz) + 10, dtype=TICK)
    ticks["monotonic_s"] = NOW_S - len(ticks) / 1000 + np.arange(len(ticks)) / 1000
    ticks["media_s"] = ticks["monotonic_s"] - 900.0
    ticks["mode"] = Mode.FOLLOWING
    meter = SyncMeter()
    for at_s in NOW_S - 0.005 - np.arange(count)[::-1] / rate_hz:
        meter.event(at_s, at_s - 900.0 + 1e-3 * late_ms)
    meter.compare(ticks)
    return meter


def traces_of(video, audio):
    figures = video.recent(), audio.recent()
    return lambda: SyncTraces(video.trace(), audio.trace(), *figures)


@pytest.fixture
def plot(application, qtbot):
    made = SyncPlot()
    qtbot.addWidget(made)
    made.resize(700, made.sizeHint().height())
    return made


def shown(plot, qtbot):
    plot.show()
    qtbot.waitUntil(lambda: plot.windowHandle().isExposed())
    return plot


def near(image, x, y, colour, within=3):
    """Whether a colour is met around a place."""
    wanted = QColor(colour)
    return any(
        image.pixelColor(x + dx, y + dy) == wanted
        for dx in range(-within, within + 1)
        for dy in range(-within, within + 1)
        if image.rect().contains(x + dx, y + dy)
    )


def test_a_trace_holds_times_and_differences_of_the_last_events():
    meter = measured(4.0)
    trace = meter.trace()
    assert trace.shape == (200, 2)
    assert trace[-1, 0] == pytest.approx(NOW_S - 0.005)
    assert trace[:, 1] == pytest.approx(4.0, abs=1e-6)
    assert measured(0.0, count=TRACE_EVENTS + 50).trace().shape == (TRACE_EVENTS, 2)
    assert SyncMeter().trace().shape == (0, 2)
    later = trace_of(trace, NOW_S + SPAN_S - 1.0)
    assert 0.0 < later.ages_s.min() <= later.ages_s.max() <= SPAN_S
    assert len(later.ages_s) < len(trace)


def test_points_lie_where_the_differences_are(plot, qtbot):
    shown(plot, qtbot).follow(NOW_S, traces_of(measured(20.0), measured(-10.0)))
    image, area = plot.grab().toImage(), plot.plot_area()
    for later_ms, colour in zip((20.0, -10.0), theme.AXIS_COLOURS, strict=False):
        # at the newest end, and not at a time before anything was measured
        y = round(plot.height_of(area, later_ms))
        assert near(image, round(area.right()) - 2, y, colour)
        assert not near(image, round(area.left()) + 5, y, colour)
    assert plot.height_of(area, LATE_MS) > area.top()
    said = hearing.value(plot)
    assert "video: p50 +20.0" in said
    assert "sound: p50 \u221210.0" in said


def test_a_value_beyond_the_plot_is_held_on_its_edge(plot, qtbot):
    shown(plot, qtbot).follow(NOW_S, traces_of(measured(400.0), SyncMeter()))
    image, area = plot.grab().toImage(), plot.plot_area()
    place = round(area.right()) - 2, round(area.top())
    assert near(image, *place, theme.AXIS_COLOURS[0])


def test_a_hidden_plot_reads_and_draws_nothing(plot, qtbot):
    asked = []

    def traces():
        asked.append(1)
        return traces_of(SyncMeter(), SyncMeter())()

    plot.follow(NOW_S, traces)
    assert asked == []
    shown(plot, qtbot).follow(NOW_S, traces)
    assert len(asked) == 1
    plot.follow(NOW_S + 0.01, traces)  # a few times a second are enough
    assert len(asked) == 1
    plot.hide()
    plot.follow(NOW_S + 10.0, traces)
    assert len(asked) == 1


def test_the_key_shows_and_hides_it_also_around_fullscreen(playing, qtbot):
    window = playing
    assert not window.sync_plot.isVisible()
    window.commands.sync_plot.trigger()
    assert window.sync_plot.isVisible()
    window.enter_fullscreen()
    assert not window.sync_plot.isVisible()
    window.fullscreen.leave()
    assert window.sync_plot.isVisible()
    window.commands.sync_plot.trigger()
    assert not window.sync_plot.isVisible()
