"""Markers set at the cursor, named, listed, snapped to, and kept."""

import json

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from hapticplayer.rendering.effects import Effect, EffectList, TimeMarker
from hapticplayer.sequence import open_sequence, store, verify_sequence
from tests.app.editor.hands import at, click, drag, middle

EFFECTS = EffectList((Effect("gain", 0.2, 0.6),), (TimeMarker(1.5, "The gate"),))


@pytest.fixture
def page(make_page, folder):
    made = make_page(folder)
    made.lanes.setFocus()
    return made


def listed(page):
    items = map(page.markers.topLevelItem, range(page.markers.topLevelItemCount()))
    return [(item.text(0), item.text(1)) for item in items]


def mark(page, at_s) -> None:
    page.lanes.point_at(at_s)
    QTest.keyClick(page.lanes, Qt.Key.Key_M)


def test_a_key_sets_a_marker_that_is_listed_named_and_undone(page, wait_for):
    assert listed(page) == [("1.500 s", "The gate")]
    mark(page, 0.84)
    mark(page, 0.84)  # there is one
    mark(page, 0.4)
    assert page.markers.isVisible()
    assert listed(page) == [
        ("0.400 s", "Marker 2"),
        ("0.840 s", "Marker 1"),
        ("1.500 s", "The gate"),
    ]
    assert page.markers.currentItem().text(1) == "Marker 2"
    page.markers.setFocus()
    QTest.keyClick(page.markers, Qt.Key.Key_F2)
    field = page.markers.findChild(QLineEdit)
    field.selectAll()
    QTest.keyClicks(field, "Start of it")
    QTest.keyClick(field, Qt.Key.Key_Return)
    renamed = TimeMarker(0.4, "Start of it")  # taken once the key has been dealt with
    wait_for(lambda: page.document.effects.markers[0] == renamed)
    QTest.keyClick(page.markers, Qt.Key.Key_Down)
    QTest.keyClick(page.markers, Qt.Key.Key_Return)
    assert page.lanes.cursor_s == pytest.approx(0.84)
    QTest.keyClick(page.markers, Qt.Key.Key_Delete)
    assert [one.name for one in page.document.effects.markers] == [
        "Start of it",
        "The gate",
    ]
    while page.document.stack.canUndo():
        QTest.keyClick(page.markers, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert page.document.effects == EFFECTS
    assert listed(page) == [("1.500 s", "The gate")]


def test_keys_go_from_marker_to_marker_and_drags_snap_to_them(page):
    mark(page, 0.71)
    page.lanes.point_at(0.0)
    shift = Qt.KeyboardModifier.ShiftModifier
    for expected in (0.71, 1.5):
        QTest.keyClick(page.lanes, Qt.Key.Key_PageDown, shift)
        assert page.lanes.cursor_s == pytest.approx(expected)
    page.lanes.point_at(0.0)
    begin = middle(page.lanes, 0)
    end = begin.x() + round(0.508 / 2.0 * page.lanes.width())
    drag(page.lanes, begin, type(begin)(end, begin.y()))
    assert page.document.effect.start_s == pytest.approx(0.71)  # no frame: 0.708 s


def test_a_click_on_a_marker_goes_exactly_there(page):
    lanes = page.lanes
    y = lanes.lanes.markers.center().y()
    click(lanes, at(lanes, 1.5, y) + QPoint(4, 0))
    assert lanes.cursor_s == 1.5
    click(lanes, at(lanes, 1.0, y))
    assert lanes.cursor_s == pytest.approx(1.0, abs=0.003)
    QTest.mouseMove(lanes, at(lanes, 1.5, y))
    assert lanes.toolTip() == "1.500 s: The gate"


def test_markers_are_saved_with_the_effects(page, folder, wait_for):
    mark(page, 0.84)
    track = page.playing.track
    wait_for(lambda: not page.live.is_busy)
    assert page.playing.track is track  # a marker is not felt
    page.save()
    wait_for(page.document.stack.isClean)
    verify_sequence(folder)
    sequence = open_sequence(folder)
    kept = json.loads((folder / sequence.description.effects).read_text())
    assert kept["markers"] == [
        {"time_s": 0.84, "name": "Marker 1"},
        {"time_s": 1.5, "name": "The gate"},
    ]
    assert store.effects_of(sequence) == page.document.effects


def test_a_name_without_a_letter_is_refused(page):
    page.left.setCurrentWidget(page.markers)
    page.markers.topLevelItem(0).setText(1, "   ")
    assert listed(page) == [("1.500 s", "The gate")]
    page.markers.topLevelItem(0).setText(1, "x" * 101)
    assert "1 to 100 characters" in page.messages.text()
    assert page.document.effects == EFFECTS


def test_an_empty_list_says_how_markers_are_set(page, qtbot):
    page.left.setCurrentWidget(page.markers)
    full = page.markers.grab().toImage()
    page.editing.remove_marker(EFFECTS.markers[0])
    assert page.markers.topLevelItemCount() == 0
    assert page.markers.grab().toImage() != full
