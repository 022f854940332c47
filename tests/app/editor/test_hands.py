"""Effects edited on the timeline by mouse and keys, offered, saved and kept."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QDropEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox

from app.editor.kind_list import MIME
from app.player.command import KEYS
from hapticplayer.rendering.effects import EFFECTS as KINDS
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence import open_sequence, store, verify_sequence

FRAME_S = 0.04
EFFECTS = EffectList((Effect("gain", 0.2, 0.6), Effect("sine", 1.2, 1.6)))


@pytest.fixture
def page(make_page, folder):
    return make_page(folder)


def drag(lanes, at, by_px, steps=4) -> None:
    """Press, move in some steps, let go."""
    kinds, left = QEvent.Type, Qt.MouseButton.LeftButton
    places = [at + QPointF(by_px * k / steps, 0.0) for k in range(steps + 1)]
    for kind, place in (
        (kinds.MouseButtonPress, places[0]),
        *((kinds.MouseMove, place) for place in places[1:]),
        (kinds.MouseButtonRelease, places[-1]),
    ):
        held = Qt.MouseButton.NoButton if kind == kinds.MouseButtonRelease else left
        event = QMouseEvent(
            kind, place, lanes.mapToGlobal(place), left, held, Qt.KeyboardModifier(0)
        )
        QApplication.sendEvent(lanes, event)


def px(page, seconds) -> float:
    return seconds / page.view.span_s * page.lanes.width()


def test_dragging_moves_in_one_step_and_snaps_to_frames(page):
    box = page.lanes.effect_box(0)
    drag(page.lanes, box.center(), px(page, 0.311))
    moved = page.document.effect
    assert moved.start_s == pytest.approx(0.52)  # the next frame to 0.511
    assert moved.duration_s == pytest.approx(0.4)
    assert page.document.stack.count() == 1
    page.change_bar.undo_button.click()
    assert page.document.effects == EFFECTS
    assert page.document.stack.isClean()
    page.change_bar.redo_button.click()
    assert page.document.effect == moved


def test_without_snapping_it_stays_where_it_is_let_go(page):
    page.play_bar.snap.click()
    drag(page.lanes, page.lanes.effect_box(0).center(), px(page, 0.311))
    assert page.document.effect.start_s == pytest.approx(0.511, abs=0.004)


def test_an_end_snaps_to_another_effect(page):
    box = page.lanes.effect_box(0)
    end = QPointF(box.right() - 2.0, box.center().y())
    drag(page.lanes, end, px(page, 0.598))
    assert page.document.effect.start_s == 0.2
    assert page.document.effect.end_s == 1.2  # where the other begins


def test_tab_goes_through_effects_and_arrows_move_by_frames(page):
    lanes = page.lanes
    lanes.setFocus()
    for expected in (0, 1):
        QTest.keyClick(lanes, Qt.Key.Key_Tab)
        assert page.document.selected == expected
        assert page.focusWidget() is lanes
    assert "Sine" in lanes.accessibleName()
    QTest.keyClick(lanes, Qt.Key.Key_Right)
    QTest.keyClick(lanes, Qt.Key.Key_Right)
    assert page.document.effect.start_s == pytest.approx(1.2 + 2 * FRAME_S)
    QTest.keyClick(lanes, Qt.Key.Key_Left, Qt.KeyboardModifier.ControlModifier)
    assert page.document.effect.end_s == pytest.approx(1.6 + FRAME_S)
    QTest.keyClick(lanes, Qt.Key.Key_E)
    assert not page.document.effect.enabled
    assert not page.panel.enabled.isChecked()
    QTest.keyClick(lanes, Qt.Key.Key_Tab)
    assert page.focusWidget() is not lanes
    assert page.document.selected == 1  # for the panel
    lanes.setFocus()
    QTest.keyClick(lanes, Qt.Key.Key_Delete)
    assert len(page.document.effects) == 1
    while page.document.stack.canUndo():
        QTest.keyClick(lanes, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert page.document.effects == EFFECTS


def test_the_timeline_takes_the_keys_that_a_person_chose(make_page, folder, settings):
    settings.keep(KEYS, {"effect_delete": ["X"], "play": ["Y"]})
    page = make_page(folder)
    page.document.select(0)
    page.lanes.setFocus()
    QTest.keyClick(page.lanes, Qt.Key.Key_Delete)
    assert len(page.document.effects) == len(EFFECTS)
    QTest.keyClick(page.lanes, Qt.Key.Key_X)
    assert len(page.document.effects) == len(EFFECTS) - 1
    QTest.keyClick(page.lanes, Qt.Key.Key_Space)
    assert not page.playing.is_playing
    QTest.keyClick(page.lanes, Qt.Key.Key_Y)
    assert page.playing.is_playing


def test_space_plays_from_lists_and_numbers_but_not_in_a_text(page):
    page.document.select(0)  # a gain, which has control points
    panel = page.panel
    numbers = [panel.fields["gain"].box, panel.fields["gain"].slider]
    lists = [page.kinds, page.left.tabBar(), panel.target, page.view_bar]
    for part in (page.lanes, *numbers, *lists):
        part.setFocus()
        before = page.document.effects
        for is_on in (True, False):
            QTest.keyClick(part, Qt.Key.Key_Space)
            assert page.playing.is_playing is is_on, part
        assert page.document.effects == before
    panel.curve.setFocus()
    QTest.keyClick(panel.curve, Qt.Key.Key_Space)
    assert panel.curve.text() == " "
    assert not page.playing.is_playing


def test_space_checks_a_box_that_tab_has_gone_to(page):
    page.play_bar.snap.setFocus()
    QTest.keyClick(page.play_bar.snap, Qt.Key.Key_Space)
    assert not page.play_bar.snap.isChecked()
    assert not page.playing.is_playing


def test_space_plays_after_a_click_on_a_box(page):
    page.lanes.setFocus()
    page.document.select(0)
    bar = page.play_bar
    for box in (bar.loop, bar.compare, bar.snap, page.panel.enabled):
        was_checked = box.isChecked()
        QTest.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPoint(8, 8))
        assert box.isChecked() != was_checked
        assert page.lanes.hasFocus()
    QTest.keyClick(page.focusWidget(), Qt.Key.Key_Space)
    assert page.playing.is_playing


def test_copies_are_put_after_the_effect_and_at_the_cursor(page):
    page.document.select(0)
    page.panel.duplicate.click()
    assert page.document.effect.start_s == pytest.approx(0.6)
    control = Qt.KeyboardModifier.ControlModifier
    QTest.keyClick(page.lanes, Qt.Key.Key_C, control)
    page.lanes.point_at(1.0)
    QTest.keyClick(page.lanes, Qt.Key.Key_V, control)
    assert page.document.effect.start_s == pytest.approx(1.0)
    assert len(page.document.effects) == 4


def test_a_kind_is_dropped_where_the_pointer_is(page):
    lanes = page.lanes
    names = [kind.name for kind in KINDS]
    item = page.kinds.item(names.index("mute"))
    data = page.kinds.mimeData([item])
    assert bytes(data.data(MIME).data()) == b"mute"
    place = QPointF(px(page, 0.53), lanes.height() - 20.0)
    drop = QDropEvent(
        place,
        Qt.DropAction.CopyAction,
        data,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier(0),
    )
    lanes.dropEvent(drop)
    assert page.document.effect.kind == "mute"
    assert page.document.effect.start_s == pytest.approx(0.52)  # a frame
    page.lanes.point_at(0.0)
    page.kinds.setCurrentRow(names.index("knock"))
    page.kinds.setFocus()
    QTest.keyClick(page.kinds, Qt.Key.Key_Return)
    assert page.document.effect.kind == "knock"
    assert page.document.effect.start_s == 0.0


def test_an_event_offers_its_effect_and_applies_nothing(page):
    event = page.loaded.line.events[0] if page.loaded.line.events else None
    if event is None:
        page.lanes.events = (made_event(),)
        event = page.lanes.events[0]
    place = page.lanes.event_box(0).center()
    drag(page.lanes, place, 0.0)
    menu = page.lanes.menu
    assert page.document.effects == EFFECTS
    assert menu.isVisible()
    menu.actions()[-1].trigger()
    assert page.document.effects.effects[-1] == event.effect
    menu.close()
    page.lanes.point_at(0.0)
    page.lanes.setFocus()
    page.document.select()
    QTest.keyClick(page.lanes, Qt.Key.Key_PageDown)
    assert page.lanes.cursor_s == pytest.approx(event.start_s)


def made_event():
    from hapticplayer.errors import Message
    from hapticplayer.sequence.events import Event

    effect = Effect("knock", 0.9, 1.1, parameters={"amplitude": 2.0})
    return Event("impact", 0.9, 1.0, 0.8, Message("A shock"), effect)


def test_saving_writes_effects_and_renders(page, folder, wait_for):
    before = open_sequence(folder).tracks["realistic"]
    page.document.select(0)
    page.panel.delete.click()
    page.kinds.setCurrentRow(3)
    page.lanes.point_at(0.0)
    page.kinds.setFocus()
    QTest.keyClick(page.kinds, Qt.Key.Key_Return)
    assert page.change_bar.note.text() == "Not saved yet"
    kept = page.document.effects
    page.change_bar.save_button.click()
    assert not page.lanes.isEnabled()
    wait_for(lambda: page.document.stack.isClean() and page.lanes.isEnabled())
    verify_sequence(folder)
    sequence = open_sequence(folder)
    assert store.effects_of(sequence) == kept
    after, at_s = sequence.tracks["realistic"], np.array([0.62])  # of a shake of 2 Hz
    assert abs(after.at(at_s)).max() < 0.2 * abs(before.at(at_s)).max()
    assert page.lanes.track.provenance == after.provenance
    page.change_bar.undo_button.click()  # also what was saved
    assert page.change_bar.save_button.isEnabled()


@pytest.mark.parametrize("answer", ["Cancel", "Discard", "Save"])
def test_closing_asks_about_changes(page, folder, answer, monkeypatch, wait_for):
    buttons = QMessageBox.StandardButton
    asked = []

    def choose(box):
        asked.append(box.text())
        return int(getattr(buttons, answer))

    monkeypatch.setattr(QMessageBox, "exec", choose)
    page.document.select(1)
    page.panel.delete.click()
    page.close()
    assert asked == ["Save your changes to the effects?"]
    if answer == "Cancel":
        assert page.isVisible()
    else:
        wait_for(lambda: not page.isVisible())
    count = len(store.effects_of(open_sequence(folder)))
    assert count == (1 if answer == "Save" else 2)


def test_a_click_beside_effects_selects_none(page):
    page.document.select(0)
    lane = page.lanes.lanes.effects
    at = QPoint(round(px(page, 0.9)), round(lane.top() + 5))
    QTest.mouseClick(page.lanes, Qt.MouseButton.LeftButton, Qt.KeyboardModifier(0), at)
    assert page.document.selected is None
    assert page.panel.hint.isVisible()


def test_saving_can_be_cancelled_and_nothing_is_written(
    page, folder, monkeypatch, wait_for
):
    page.document.select(0)
    page.panel.delete.click()

    def never_ends(_work, *_arguments, progress):
        while True:
            progress(0.1, "waiting")
            QTest.qSleep(1)

    monkeypatch.setattr("app.editor.page.in_child", never_ends)

    def place():
        return page.lanes.mapTo(page, QPoint()), page.lanes.size()

    before = place()
    page.change_bar.save_button.click()
    page.reject()
    assert page.isVisible()  # it is being saved
    wait_for(page.job_bar.isVisible)
    QTest.qWait(20)
    assert place() == before  # nothing moves below the pointer
    page.job_bar.cancelled.emit()
    wait_for(page.lanes.isEnabled)
    assert not page.document.stack.isClean()
    assert store.effects_of(open_sequence(folder)) == EFFECTS


def test_a_menu_switches_and_deletes_an_effect(page, qtbot):
    lanes, at = page.lanes, page.lanes.effect_box(1).center().toPoint()
    for row in (0, 2):
        reason = QContextMenuEvent.Reason.Mouse
        lanes.contextMenuEvent(QContextMenuEvent(reason, at, lanes.mapToGlobal(at)))
        lanes.menu.actions()[row].trigger()
        lanes.menu.close()
        if row == 0:
            assert not page.document.effects.effects[1].enabled
    assert [one.kind for one in page.document.effects.effects] == ["gain"]
