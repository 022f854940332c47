"""More devices in the window: added, muted, tested, removed, and stopped by Escape."""

import contextlib
import threading

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.player import outlets_page
from app.player.outlets_page import OutletsPage, outlet_text, state_text
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.model import RigTrack
from hapticplayer.playback.snapshot import OutletState
from hapticplayer.simulation.rig.receiver import Ears


@pytest.fixture
def ears():
    with contextlib.closing(Ears(SystemClock(), [0])) as made:
        yield made


@pytest.fixture
def page(window):
    window.commands.outlets.trigger()
    return window.findChild(OutletsPage)


def outlets_of(window):
    return {one.name: one for one in window.player.snapshot().outlets}


def add_rig(page, ears):
    (port,) = ears.rigs
    page.kind.setCurrentIndex(page.kind.findData("rig:outsim"))
    page.address.setText(f"127.0.0.1:{port}")
    page.add()
    return f"rig:outsim,127.0.0.1:{port},gain=0.25,latency_ms=0"


def wait_for_tests_to_end(wait_for):
    wait_for(lambda: "rig-test" not in [t.name for t in threading.enumerate()])


def test_a_rig_is_added_with_a_small_gain_and_removed(window, page, ears, wait_for):
    name = add_rig(page, ears)
    wait_for(lambda: outlets_of(window)[name].health is Health.READY)
    assert outlets_of(window)[name].gain == 0.25
    page.look()
    assert page.states[name].text() == "at rest"
    page.add()
    assert page.problem.text() == "This device plays already"
    page.remove(name)
    assert outlets_of(window) == {}
    assert page.states == {}


def test_what_cannot_be_reached_or_is_not_allowed_is_said(window, page):
    page.kind.setCurrentIndex(page.kind.findData("rig:beamng"))
    page.address.setText("here")
    page.add()
    assert "'here' is not HOST:PORT" in page.problem.text()
    assert outlets_of(window) == {}


def test_muting_is_seen_by_the_player(window, page, ears):
    name = add_rig(page, ears)
    QTest.mouseClick(page.mutes[name], Qt.MouseButton.LeftButton)
    assert outlets_of(window)[name].is_muted == page.mutes[name].isChecked()
    page.mute(name, is_muted=True)
    assert outlets_of(window)[name].is_muted
    page.mute(name, is_muted=False)
    assert not outlets_of(window)[name].is_muted


def test_a_test_moves_the_rig_and_leaves_it_in_neutral(
    window, page, ears, wait_for, monkeypatch
):
    motion = np.zeros((150, 15))
    motion[60:90, 2] = 2.0
    track = RigTrack(np.arange(0.0, 1.5, 0.01), motion)
    monkeypatch.setattr(outlets_page, "rig_demonstration", lambda: (track, ()))
    name = add_rig(page, ears)
    wait_for(lambda: outlets_of(window)[name].health is Health.READY)
    page.test(name)
    assert outlets_of(window)[name].is_muted  # its packets would alternate with these
    wait_for(lambda: page.tested is None)
    wait_for(lambda: not outlets_of(window)[name].is_muted)
    list(ears.listen(0.0))
    (report,) = ears.report().values()
    assert report["peak_mps2"] > 0.1
    assert report["is_neutral"]


def test_escape_stops_everything(window, page, ears, wait_for):
    name = add_rig(page, ears)
    wait_for(lambda: outlets_of(window)[name].health is Health.READY)
    page.test(name)
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert page.tested is None
    wait_for(lambda: outlets_of(window)[name].mode is Mode.TRIPPED)
    assert window.session.is_stopped
    window.session.rearm()
    wait_for(lambda: outlets_of(window)[name].mode is Mode.IDLE)
    wait_for_tests_to_end(wait_for)


def test_names_and_states_are_words():
    assert outlet_text("rig:outsim,gain=0.5") == "Motion rig: outsim, gain=0.5"
    assert outlet_text("simulated") == "Simulated"
    values = ("", "realistic", False, 1.0, 0.0, Mode.FOLLOWING, Cause.NONE, 1)
    playing = OutletState("rig", Health.READY, "", *values)
    assert state_text(playing) == "active"
    lost = OutletState("rig", Health.FAILED, "the network is down", *values)
    assert state_text(lost) == "the network is down"
    assert state_text(OutletState("rig", Health.STARTING, "", *values)) == "starting"
