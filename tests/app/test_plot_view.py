"""Zoom, pan, read-out, jump and saving of the plots."""

import csv
from xml.etree import ElementTree as ET

import hearing
import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.plots.panel import PlotPanel
from app.plots.save_view import SaveButton, save_view
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import Snapshot


@pytest.fixture
def panel(qtbot, application, source) -> PlotPanel:
    made = PlotPanel()
    qtbot.addWidget(made)
    made.resize(900, 180)
    made.show()
    qtbot.waitExposed(made)
    made.set_source(source)
    made.follow(Snapshot(media_s=1.0, feedback="realistic"), TickHistory().since)
    return made


def x_at(plot, media_s: float) -> int:
    box = plot.view_box.sceneBoundingRect()
    first_s, last_s = plot.time_at(box.left()), plot.time_at(box.right())
    return round(box.left() + (media_s - first_s) / (last_s - first_s) * box.width())


def wheel(plot, steps: int) -> None:
    viewport = plot.viewport()
    middle = QPointF(viewport.rect().center())
    event = QWheelEvent(
        middle,
        viewport.mapToGlobal(middle),
        QPoint(),
        QPoint(0, 120 * steps),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(viewport, event)


def span(plot) -> tuple[float, float]:
    first_s, last_s = plot.view_box.viewRange()[0]
    return pytest.approx(first_s, abs=1e-6), pytest.approx(last_s, abs=1e-6)


def test_the_wheel_zooms_both_plots_within_limits(panel):
    wheel(panel.force, 1)
    assert span(panel.force) == (1.0 - 3.2, 1.0 + 3.2)
    assert span(panel.acceleration) == (1.0 - 3.2, 1.0 + 3.2)
    for _ in range(40):
        wheel(panel.force, 1)
    assert span(panel.force) == (0.5, 1.5)
    for _ in range(60):
        wheel(panel.force, -1)
    assert span(panel.force) == (-29.0, 31.0)


def test_a_click_jumps_to_its_time(panel, qtbot):
    plot = panel.acceleration
    with qtbot.waitSignal(panel.sought) as signal:
        qtbot.mouseClick(
            plot.viewport(),
            Qt.MouseButton.LeftButton,
            pos=QPoint(x_at(plot, 1.8), 40),
        )
    pixel_s = 8.0 / plot.view_box.sceneBoundingRect().width()
    assert signal.args[0] == pytest.approx(1.8, abs=1.5 * pixel_s)


def test_a_drag_pans_and_does_not_jump(panel, qtbot):
    plot = panel.force
    viewport = plot.viewport()
    with qtbot.assertNotEmitted(panel.sought):
        qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=QPoint(200, 40))
        qtbot.mouseMove(viewport, QPoint(170, 40))
        qtbot.mouseMove(viewport, QPoint(140, 40))
        qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=QPoint(140, 40))
    per_px_s = 8.0 / plot.view_box.sceneBoundingRect().width()
    assert panel.span.offset_s == pytest.approx(60 * per_px_s, rel=0.05)
    plot.setFocus()
    QTest.keyClick(plot, Qt.Key.Key_Return)
    assert panel.span.offset_s == 0.0


def test_the_keys_zoom_and_pan(panel):
    panel.force.setFocus()
    QTest.keyClick(panel.force, Qt.Key.Key_Plus)
    assert panel.span.half_s == pytest.approx(3.2)
    QTest.keyClick(panel.force, Qt.Key.Key_Right)
    assert panel.span.offset_s == pytest.approx(0.8)
    QTest.keyClick(panel.force, Qt.Key.Key_Minus)
    assert panel.span.half_s == pytest.approx(4.0)


def test_the_read_out_says_the_values_of_the_track(panel, source):
    words = panel.force.pointer.words(0.7)
    wanted = source.tracks["realistic"].at(np.array([0.7]))[0]
    assert words[0][0] == "0.700 s"
    for (text, _), axis, value in zip(words[1:], "xyz", wanted, strict=True):
        name, number = text.split()
        assert name == axis
        assert float(number) == pytest.approx(value, abs=0.02)
    panel.force.set_playhead(0.7)
    assert hearing.value(panel.force) == ", ".join(text for text, _ in words)


def test_hovering_draws_the_read_out(panel, qtbot):
    before = panel.force.grab().toImage()
    qtbot.mouseMove(panel.force.viewport(), QPoint(x_at(panel.force, 0.5), 30))
    assert panel.force.pointer.hover_px is not None
    assert panel.force.grab().toImage() != before


def test_a_view_is_saved_as_picture_drawing_and_numbers(panel, tmp_path, source):
    names = [tmp_path / f"view.{kind}" for kind in ("png", "svg", "csv")]
    for name in names:
        assert save_view(panel.acceleration, name) == ""
    image = QImage(str(names[0]))
    assert image.size() == panel.acceleration.size() * 2
    root = ET.parse(names[1]).getroot()
    assert root.tag.endswith("svg")
    assert any(node.tag.endswith("polyline") or node.tag.endswith("path")
               for node in root.iter())  # fmt: skip
    with names[2].open() as reader:
        rows = list(csv.DictReader(reader))
    motion = source.motion
    found = np.array([[float(row[k]) for k in ("time_s", "z")] for row in rows])
    z = np.interp(found[:, 0], motion.time_s, motion.acceleration_mps2[:, 2])
    assert found[:, 1] == pytest.approx(z, abs=1e-4)
    assert {row["series"] for row in rows} == {"acceleration"}


def test_numbers_of_the_force_tell_planned_from_sent(panel, tmp_path):
    assert save_view(panel.force, tmp_path / "f.csv") == ""
    with (tmp_path / "f.csv").open() as reader:
        assert {row["series"] for row in csv.DictReader(reader)} == {"planned"}


@pytest.mark.parametrize("name", ["view.gif", "missing/view.png"])
def test_a_view_that_cannot_be_saved_is_told(panel, tmp_path, name):
    assert "view" in save_view(panel.force, tmp_path / name)
    assert not (tmp_path / name).exists()


def test_each_plot_has_a_button_to_save_it(panel):
    names = [button.accessibleName() for button in panel.findChildren(SaveButton)]
    assert len(names) == 2
    assert len(set(names)) == 2


def test_a_click_on_a_plot_of_the_window_seeks(playing):
    playing.player.pause()
    playing.plots.prepare()
    playing.plots.panel.force.sought.emit(1.5)
    assert playing.player.snapshot().media_s == pytest.approx(1.5)
