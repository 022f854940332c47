"""J, K and L: back without force, pause, forward."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from hapticplayer.haptics.contract import Mode
from hapticplayer.rendering.effects import Effect, EffectList

EFFECTS = EffectList((Effect("pulse", 0.1, 1.9, parameters={"amplitude": 2.0}),))


@pytest.fixture
def page(make_page, folder):
    made = make_page(folder)
    made.lanes.setFocus()
    return made


def test_back_goes_frame_by_frame_without_playing(page, wait_for):
    page.lanes.point_at(1.6)
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    player, shuttle = page.playing.session.player, page.playing.shuttle
    assert page.playing.is_playing
    wait_for(lambda: page.lanes.cursor_s < 1.4)
    assert not player.snapshot().is_playing
    assert "\u22121\u00d7" in page.play_bar.time.text()
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    assert shuttle.speed == -2.0
    QTest.keyClick(page.lanes, Qt.Key.Key_K)
    assert not page.playing.is_playing
    assert shuttle.speed == 1.0
    rests_s = page.lanes.cursor_s
    QTest.qWait(250)
    assert page.lanes.cursor_s == rests_s
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    wait_for(lambda: page.lanes.cursor_s == 0.0)
    assert not page.playing.is_playing  # the beginning of the clip


def test_forward_plays_and_again_faster(page, wait_for):
    player = page.playing.session.player
    QTest.keyClick(page.lanes, Qt.Key.Key_L)
    assert player.snapshot().is_playing
    assert player.snapshot().speed == 1.0
    for speed in (2.0, 4.0, 4.0):
        QTest.keyClick(page.lanes, Qt.Key.Key_L)
        assert player.snapshot().speed == speed
    QTest.keyClick(page.lanes, Qt.Key.Key_Space)
    assert not player.snapshot().is_playing
    assert player.snapshot().speed == 1.0
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    QTest.keyClick(page.lanes, Qt.Key.Key_Space)
    assert not page.playing.is_playing
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    QTest.keyClick(page.lanes, Qt.Key.Key_L)
    assert page.playing.shuttle.speed == 1.0
    assert player.snapshot().is_playing


def test_a_click_ends_going_back_and_escape_stops_it(page):
    page.lanes.point_at(1.9)
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    page.lanes.point_at(0.5)
    assert not page.playing.is_playing
    page.lanes.point_at(1.9)
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    QTest.keyClick(page.windowHandle(), Qt.Key.Key_Escape)
    assert not page.playing.is_playing
    assert page.isVisible()


@pytest.mark.realtime
def test_no_force_is_felt_while_the_clip_goes_back(felt, wait_for):
    page, player = felt
    page.playing.shuttle.back()

    def at_rest():
        tick = player.snapshot().leading.tick
        return not np.any(tick["force_n"])

    wait_for(at_rest)
    begin_s = float(player.snapshot().leading.tick["monotonic_s"])
    wait_for(lambda: page.lanes.cursor_s == 0.0)
    ticks = player.ticks_since(begin_s)
    assert len(ticks) > 50
    assert not ticks["force_n"].any()
    assert Mode.TRIPPED not in ticks["mode"]


@pytest.mark.realtime
def test_edits_by_hand_never_let_the_force_jump(make_page, folder, wait_for):
    page = make_page(folder, "simulated")
    player = page.playing.session.player
    wait_for(lambda: player.snapshot().leading.tick is not None)
    page.document.select(0)
    page.play_bar.loop.click()
    page.playing.toggle()
    wait_for(lambda: np.any(player.snapshot().leading.tick["force_n"]))
    begin_s = float(player.snapshot().leading.tick["monotonic_s"])
    for change in (
        page.editing.duplicate,
        lambda: page.editing.put(Effect("mute", 0.0, 2.0), "Mute"),
        page.undo,
        page.editing.select_all,
        page.editing.delete,
        page.undo,
        lambda: page.editing.paste(0.0),
        page.redo,
    ):
        change()
        wait_for(lambda: not page.live.is_busy)
        QTest.qWait(120)
    ticks = player.ticks_since(begin_s)
    on_time = np.diff(ticks["monotonic_s"]) < 0.0015
    sent_n = np.abs(np.diff(ticks["force_n"], axis=0))[on_time]
    assert np.count_nonzero(on_time) > 100
    assert sent_n.max() <= 1.0 + 1e-6  # the slew of the contract
    # away from the ends of the pulse all versions are slower than 0.02 N a millisecond
    is_even = (ticks["media_s"] > 0.35) & (ticks["media_s"] < 1.65)
    is_even &= ticks["mode"] == Mode.FOLLOWING
    within = on_time & is_even[1:] & is_even[:-1]
    planned_n = np.linalg.norm(np.diff(ticks["planned_n"], axis=0), axis=1)[within]
    assert np.count_nonzero(within) > 100
    assert planned_n.max() <= 0.05 + 2 * 0.02


def test_undo_never_takes_a_stop_back(page):
    page.editing.add(Effect("mute", 0.2, 0.4), "Add")
    page.playing.toggle()
    page.playing.stop()
    for change in (page.undo, page.redo, page.editing.delete, page.undo):
        change()
        assert page.playing.is_stopped
    QTest.keyClick(page.lanes, Qt.Key.Key_L)
    assert page.playing.is_stopped
    QTest.keyClick(page.lanes, Qt.Key.Key_J)
    QTest.keyClick(page.lanes, Qt.Key.Key_K)
    assert page.playing.is_stopped
