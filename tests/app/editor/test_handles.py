"""Fades and control points dragged on the timeline, and moved by keys."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.editor.document import Handle
from app.editor.spans import Part
from hapticplayer.rendering.effects import Effect, EffectList
from tests.app.editor.hands import LEFT, NO_KEY, at, drag, press, pull, release

FRAME_S, INSET_PX, TOP = 0.04, 7.0, 3.0  # the lane of a gain of 1.5 goes up to 3
CURVE = ((0.0, 1.0), (0.4, 2.0), (0.8, 1.0))
EFFECTS = EffectList((Effect("gain", 0.4, 1.2, curve=CURVE), Effect("sine", 1.4, 1.8)))


@pytest.fixture
def page(make_page, folder):
    made = make_page(folder)
    made.lanes.setFocus()
    return made


@pytest.fixture
def lanes(page):
    page.document.select(0)
    return page.lanes


def y_of(lanes, value) -> float:
    """Return the height of a value in the lane of the curve, by hand."""
    lane = lanes.lanes.curve
    return lane.bottom() - INSET_PX - value / TOP * (lane.height() - 2 * INSET_PX)


def pixel(lanes) -> float:
    """Return the value that a pixel of the lane stands for."""
    return TOP / (lanes.lanes.curve.height() - 2 * INSET_PX)


def fade_spot(lanes, media_s, number=0) -> QPoint:
    return at(lanes, media_s, lanes.effect_box(number).top() + 4)


def test_a_point_is_dragged_to_a_time_and_a_value(page, lanes):
    begin, end = at(lanes, 0.8, y_of(lanes, 2.0)), at(lanes, 1.007, y_of(lanes, 0.5))
    press(lanes, begin)
    pull(lanes, begin, end)
    since_s, value = page.document.effect.curve[1]
    assert since_s == pytest.approx(0.6)  # 1.007 s is next to the frame at 1.0 s
    assert value == pytest.approx(0.5, abs=pixel(lanes))
    assert lanes.readout.isVisible()
    shown = lanes.readout.text()
    assert shown == f"Point 2 of 3: 1.000 s, Gain {value:g}"
    release(lanes, end)
    assert page.document.handle == Handle(Part.POINT, 1)
    assert page.document.stack.count() == 1
    page.undo()
    assert page.document.effects == EFFECTS


def test_a_point_snaps_to_the_value_of_another_and_to_one(page, lanes):
    begin, end = at(lanes, 0.8, y_of(lanes, 2.0)), at(lanes, 0.8, y_of(lanes, 1.0) + 3)
    drag(lanes, begin, end)
    assert page.document.effect.curve[1] == (pytest.approx(0.4), 1.0)
    page.undo()
    page.play_bar.snap.click()
    drag(lanes, begin, end)
    below = 1.0 - 3 * pixel(lanes)
    assert page.document.effect.curve[1][1] == pytest.approx(below, abs=pixel(lanes))


def test_a_point_never_passes_its_neighbours_or_the_range(page, lanes):
    drag(lanes, at(lanes, 0.8, y_of(lanes, 2.0)), at(lanes, 1.9, -3000))
    assert page.document.effect.curve[1] == (pytest.approx(0.799), 10.0)


def test_escape_takes_a_drag_back_and_leaves_no_step(page, lanes):
    begin, end = at(lanes, 0.8, y_of(lanes, 2.0)), at(lanes, 1.0, y_of(lanes, 0.5))
    for start, to in (
        (begin, end),
        (fade_spot(lanes, 0.4), fade_spot(lanes, 0.6)),
        (lanes.effect_box(1).center().toPoint(), at(lanes, 0.5, begin.y())),
    ):
        press(lanes, start)
        pull(lanes, start, to)
        assert page.document.effects != EFFECTS
        QTest.keyClick(lanes, Qt.Key.Key_Escape)
        assert page.document.effects == EFFECTS
        assert not page.document.stack.canUndo()
        QTest.mouseMove(lanes, to + QPoint(40, 0))  # still held, but no longer dragged
        release(lanes, to)
        assert page.document.effects == EFFECTS
        assert page.isVisible()
        page.document.select(0)


def test_fades_are_dragged_by_the_corners(page, lanes):
    begin = fade_spot(lanes, 0.4)
    press(lanes, begin)
    pull(lanes, begin, fade_spot(lanes, 0.603))
    assert page.document.effect.fade_in_s == pytest.approx(0.2)  # the frame at 0.6 s
    assert lanes.readout.text() == "Fade in 0.200 s"
    release(lanes, fade_spot(lanes, 0.603))
    drag(lanes, fade_spot(lanes, 1.2), fade_spot(lanes, 0.2))
    effect = page.document.effect
    assert effect.fade_out_s == pytest.approx(0.6)  # what the other one leaves
    assert (effect.start_s, effect.end_s) == (0.4, 1.2)
    assert page.document.stack.count() == 2
    drag(lanes, fade_spot(lanes, 0.6), fade_spot(lanes, 0.401))
    assert page.document.effect.fade_in_s == 0.0  # snapped to the start


def test_the_lower_part_of_an_end_still_stretches(page, lanes):
    box = lanes.effect_box(0)
    low = box.bottom() - 3
    drag(lanes, at(lanes, 1.2, low) - QPoint(1, 0), at(lanes, 1.32, low))
    assert page.document.effect.end_s == pytest.approx(1.32)
    assert page.document.effect.fade_out_s == 0.0


def test_a_double_click_adds_a_point_that_is_held(page, lanes):
    place = at(lanes, 1.0, y_of(lanes, 2.5))
    QTest.mouseDClick(lanes, LEFT, NO_KEY, place)
    curve = page.document.effect.curve
    assert len(curve) == 4
    assert curve[2] == (
        pytest.approx(0.6, abs=FRAME_S / 2),
        pytest.approx(2.5, abs=pixel(lanes)),
    )
    assert page.document.handle == Handle(Part.POINT, 2)
    outside = at(lanes, 1.6, y_of(lanes, 2.5))
    QTest.mouseDClick(lanes, LEFT, NO_KEY, outside)
    assert page.document.effect.curve == curve


def test_without_a_mouse_points_are_added_moved_and_deleted(page, lanes):
    lanes.point_at(0.6)
    QTest.keyClick(lanes, Qt.Key.Key_A)
    assert page.document.effect.curve[1] == (pytest.approx(0.2), pytest.approx(1.5))
    assert page.document.handle == Handle(Part.POINT, 1)
    QTest.keyClick(lanes, Qt.Key.Key_Right)
    QTest.keyClick(lanes, Qt.Key.Key_Up)
    QTest.keyClick(lanes, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    since_s, value = page.document.effect.curve[1]
    assert since_s == pytest.approx(0.2 + FRAME_S)
    assert value == pytest.approx(1.5 + 0.1 + 1.0)
    assert "Point 2 of 4: 0.640 s, Gain 2.6" in lanes.accessibleName()
    assert page.document.effect.start_s == 0.4  # the effect stays
    QTest.keyClick(lanes, Qt.Key.Key_Delete)
    assert page.document.effect.curve == CURVE
    assert len(page.document.effects) == 2
    while page.document.stack.canUndo():
        QTest.keyClick(lanes, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert page.document.effects == EFFECTS


def test_a_key_goes_through_fades_and_points(page, lanes):
    parts = [Part.FADE_IN, Part.POINT, Part.POINT, Part.POINT, Part.FADE_OUT]
    for part in parts:
        QTest.keyClick(lanes, Qt.Key.Key_P)
        assert page.document.handle.part is part
    QTest.keyClick(lanes, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert page.document.effect.fade_out_s == pytest.approx(10 * FRAME_S)
    assert "Fade out 0.400 s" in lanes.accessibleName()
    QTest.keyClick(lanes, Qt.Key.Key_P)
    assert page.document.handle is None
    QTest.keyClick(lanes, Qt.Key.Key_P, Qt.KeyboardModifier.ShiftModifier)
    assert page.document.handle.part is Part.FADE_OUT
    QTest.keyClick(lanes, Qt.Key.Key_Up)  # a fade has no value
    assert page.document.stack.count() == 1


def test_an_effect_without_a_curve_has_no_lane_for_it(page, lanes):
    assert lanes.lanes.curve.height() > 50
    top = lanes.lanes.effects.top()
    page.document.select(1)
    assert lanes.lanes.curve.height() == 0
    assert lanes.lanes.effects.top() == top  # it may be held by the pointer
    QTest.keyClick(lanes, Qt.Key.Key_A)
    assert page.document.effects == EFFECTS


def test_a_change_by_keys_ends_a_drag(page, lanes):
    begin = at(lanes, 0.8, y_of(lanes, 2.0))
    press(lanes, begin)
    pull(lanes, begin, begin + QPoint(20, 0))
    page.editing.select_all()
    page.editing.delete()
    pull(lanes, begin, begin + QPoint(60, 9))
    release(lanes, begin)
    assert len(page.document.effects) == 0
