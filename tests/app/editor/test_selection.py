"""Several effects selected, moved, copied and deleted together."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from hapticplayer.rendering.effects import Effect, EffectList
from tests.app.editor.hands import at, click, drag, middle, press, pull, release

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
EFFECTS = EffectList(
    (
        Effect("gain", 0.2, 0.5),
        Effect("mute", 0.3, 0.6),
        Effect("sine", 0.8, 1.0),
        Effect("pulse", 1.2, 1.4),
    )
)


@pytest.fixture
def page(make_page, folder):
    made = make_page(folder)
    made.lanes.setFocus()
    return made


def starts(page):
    return [round(one.start_s, 6) for one in page.document.effects.effects]


def test_control_and_shift_clicks_select_several(page):
    lanes = page.lanes
    click(lanes, middle(lanes, 0))
    click(lanes, middle(lanes, 2), CONTROL)
    assert page.document.selection == (0, 2)
    click(lanes, middle(lanes, 0), CONTROL)
    assert page.document.selection == (2,)
    click(lanes, middle(lanes, 0), SHIFT)
    assert sorted(page.document.selection) == [0, 1, 2]
    assert page.document.selected == 0
    assert page.panel.title.text() == "3 effects are selected"
    assert page.panel.span.text() == "0.200 \u2013 1.000 s"
    assert "3 effects are selected" in lanes.accessibleName()
    click(lanes, middle(lanes, 1))  # a click without a drag
    assert page.document.selection == (1,)


def test_a_band_selects_what_it_touches(page):
    lanes = page.lanes
    lane = lanes.lanes.effects
    begin, end = at(lanes, 0.7, lane.top() + 5), at(lanes, 1.3, lane.bottom() - 2)
    press(lanes, begin)
    pull(lanes, begin, end)
    before = lanes.grab().toImage()
    assert page.document.selection == (2, 3)
    release(lanes, end)
    assert lanes.grab().toImage() != before  # the band is gone
    assert page.document.selection == (2, 3)
    drag(
        lanes,
        at(lanes, 0.05, lane.bottom() - 4),
        at(lanes, 0.25, lane.top() + 3),
        SHIFT,
    )
    assert sorted(page.document.selection) == [0, 2, 3]
    press(lanes, begin)
    pull(lanes, begin, end)
    QTest.keyClick(lanes, Qt.Key.Key_Escape)
    assert page.document.selection == ()
    release(lanes, end)
    assert page.document.effects == EFFECTS
    assert not page.document.stack.canUndo()


def test_several_are_dragged_in_one_step(page):
    lanes = page.lanes
    page.document.select(0, 2)
    begin = middle(lanes, 2)
    end = begin + QPoint(round(0.161 / 2.0 * lanes.width()), 0)
    press(lanes, begin)
    pull(lanes, begin, end)
    assert lanes.readout.text() == "0.960 \u2013 1.160 s (+0.160 s)"
    release(lanes, end)
    assert not lanes.readout.isVisible()
    # 0.8 + 0.161 s is next to the frame at 0.96 s; the other goes with it
    assert starts(page) == [0.36, 0.3, 0.96, 1.2]
    assert page.document.stack.count() == 1
    assert set(page.document.selection) == {0, 2}
    page.undo()
    assert page.document.effects == EFFECTS


def test_several_stop_together_at_the_ends_of_the_clip(page):
    page.editing.select_all()
    for _ in range(3):
        QTest.keyClick(page.lanes, Qt.Key.Key_Left, SHIFT)
    assert starts(page) == [0.0, 0.1, 0.6, 1.0]  # 0.2 s earlier, not 1.2 s
    assert page.document.stack.count() == 1


def test_keys_select_copy_paste_and_delete_several(page):
    lanes, key = page.lanes, Qt.Key
    QTest.keyClick(lanes, key.Key_Tab)
    QTest.keyClick(lanes, key.Key_Down, CONTROL)
    assert page.document.selection == (0, 1)
    QTest.keyClick(lanes, key.Key_C, CONTROL)
    lanes.point_at(1.5)
    QTest.keyClick(lanes, key.Key_V, CONTROL)
    assert starts(page)[4:] == [1.5, 1.6]
    assert page.document.selection == (4, 5)
    assert page.document.stack.count() == 1
    QTest.keyClick(lanes, key.Key_E)
    assert [one.enabled for one in page.document.effects.effects] == [True] * 4 + [
        False
    ] * 2
    QTest.keyClick(lanes, key.Key_D, CONTROL)
    assert len(page.document.effects) == 8
    QTest.keyClick(lanes, key.Key_A, CONTROL)
    QTest.keyClick(lanes, key.Key_Delete)
    assert len(page.document.effects) == 0
    assert page.document.stack.count() == 4
    QTest.keyClick(lanes, key.Key_Z, CONTROL)
    assert len(page.document.selection) == 8
    while page.document.stack.canUndo():
        QTest.keyClick(lanes, key.Key_Z, CONTROL)
    assert page.document.effects == EFFECTS


def test_a_list_that_is_full_takes_all_or_nothing(page):
    many = EffectList(tuple(Effect("mute", 0.001 * k, 1.0) for k in range(499)))
    page.document.open(many)
    page.document.select(0, 1)
    page.editing.duplicate()
    assert page.document.effects == many
    page.document.select(0)
    page.editing.duplicate()
    assert len(page.document.effects) == 500
