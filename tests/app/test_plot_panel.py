import dataclasses

import numpy as np
import pytest

from app.plots.panel import PlotPanel
from app.plots.playhead_plot import clock_text
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import Snapshot


@pytest.fixture
def panel(qtbot, application) -> PlotPanel:
    made = PlotPanel()
    qtbot.addWidget(made)
    made.resize(900, 180)
    made.show()
    qtbot.waitExposed(made)
    return made


def follow(panel, media_s, feedback):
    panel.follow(Snapshot(media_s=media_s, feedback=feedback), TickHistory().since)


def curves(plot, group: int = 0) -> list:
    return plot.curve_groups[group]


def test_the_acceleration_is_the_motion_of_the_source(panel, source):
    panel.set_source(source)
    follow(panel, 1.0, source.feedback)
    time_s, up = curves(panel.acceleration)[2].getData()
    motion = source.motion
    assert len(time_s) == len(motion.time_s)
    assert np.allclose(up, motion.acceleration_mps2[:, 2])


def test_the_planned_force_follows_the_feedback(panel, source):
    panel.set_source(source)
    follow(panel, 1.0, "realistic")
    _, up = curves(panel.force)[1].getData()
    assert np.abs(up).max() > 0.5
    follow(panel, 1.0, "none")
    _, up = curves(panel.force)[1].getData()
    assert not up.any()


def test_the_planned_force_ends_with_the_clip(panel, source):
    panel.set_source(source)
    follow(panel, 1.0, "realistic")
    time_s, _ = curves(panel.force)[0].getData()
    assert time_s[-1] <= source.clip.duration_s + 0.01


def test_the_playhead_stays_in_the_middle(panel, source):
    panel.set_source(source)
    for media_s in (0.0, 0.7, 1.9):
        follow(panel, media_s, "realistic")
        left, right = panel.force.view_box.viewRange()[0]
        assert (left + right) / 2 == pytest.approx(media_s)


def test_a_page_is_drawn_once_and_then_only_moved(panel, source, monkeypatch):
    panel.set_source(source)
    follow(panel, 0.5, "realistic")
    drawn = []
    monkeypatch.setattr(panel.acceleration, "set_lines", lambda *_: drawn.append(1))
    for step in range(10):
        follow(panel, 0.5 + 0.1 * step, "realistic")
    assert not drawn


def test_a_clip_without_motion_says_so(panel, source):
    panel.set_source(dataclasses.replace(source, motion=None))
    follow(panel, 0.0, "realistic")
    assert "no motion" in panel.acceleration.notice
    panel.set_source(source)
    assert not panel.acceleration.notice


@pytest.mark.parametrize(
    ("media_s", "text"), [(0, "0:00"), (65, "1:05"), (3725, "1:02:05")]
)
def test_times_under_the_plots(media_s, text):
    assert clock_text(media_s) == text
