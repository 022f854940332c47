"""The demonstration of forces: announced step by step, and stopped at once."""

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.player.device_page import DevicePage
from app.player.device_test_words import state_text
from app.player.force_words import homing_text, step_text
from hapticplayer.clock import SystemClock
from hapticplayer.devices import find_device, installed_devices
from hapticplayer.haptics.contract import Cause
from hapticplayer.haptics.processes import Health
from hapticplayer.rendering.demonstration import LEAD_S, DemonstrationStep
from tests.needed_extras import needs


@pytest.fixture
def page(application, qtbot):
    made = DevicePage(SystemClock(), "simulated")
    qtbot.addWidget(made)
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.reject()


def test_a_demonstration_waits_for_a_person_and_says_how_to_stop(page):
    assert not page.is_running
    assert "Esc" in page.text.text()
    assert page.start_button.isEnabled()
    assert not page.stop_button.isEnabled()


def test_each_force_is_announced_while_it_is_made(page, wait_for, monkeypatch):
    page.start_button.setFocus()
    page.start_button.click()
    assert page.focusWidget() is page.stop_button  # not Close
    wait_for(lambda: "right" in page.text.text())
    assert "1.1\u00a0N" in page.text.text()
    player, poll, ticks = page.test.player, page.test.player.poll, []

    def noted_poll():
        ticks.append(poll())
        return ticks[-1]

    def is_pushed() -> bool:
        return bool(ticks) and np.concatenate(ticks)["force_n"][:, 0].max() > 0.3

    monkeypatch.setattr(player, "poll", noted_poll)

    wait_for(is_pushed)
    wait_for(lambda: page.picture.shown.grip.force_n[0] > 0.3)
    assert player.media_s > LEAD_S


@pytest.mark.parametrize("way", ["stop", "escape", "close"])
def test_a_demonstration_stops_at_once_and_releases_the_device(page, wait_for, way):
    page.start_button.click()
    wait_for(lambda: "right" in page.text.text())
    player = page.test.player
    if way == "stop":
        page.stop_button.click()
        assert page.text.text() == "Stopped."
        assert not page.start_button.isEnabled()
        page.stop_button.click()  # it re-arms by now
        assert page.focusWidget() is page.start_button
    elif way == "escape":
        QTest.keyClick(page, Qt.Key.Key_Escape)
        assert not page.isVisible()
    else:
        page.close()
    assert not page.is_running
    assert player.health is Health.GONE


def test_a_device_that_is_not_there_is_said_on_the_page(application, qtbot, wait_for):
    page = DevicePage(SystemClock(), "falcon:NOWHERE0")
    qtbot.addWidget(page)
    page.begin()
    wait_for(lambda: not page.is_running)
    assert "Falcon" in page.text.text()


@needs("faults")
def test_a_falcon_that_is_not_homed_leads_to_the_homing_page(
    application, qtbot, wait_for, monkeypatch
):
    page = DevicePage(SystemClock(), "falcon-simulated")
    qtbot.addWidget(page)
    wanted = []
    page.homing_wanted.connect(lambda: wanted.append(page.is_running))
    page.begin()
    wait_for(lambda: page.test.mode.name == "FOLLOWING")
    assert not wanted  # the first answers, which know nothing yet, do not count
    monkeypatch.setattr(page.test, "poll", lambda: np.empty(0))
    page.test.cause = Cause.NOT_HOMED
    wait_for(lambda: bool(wanted))
    assert wanted == [False]


@needs("wheels")
def test_between_two_pushes_it_is_a_pause_and_no_start():
    first = SimpleNamespace(begin_s=1.0, end_s=2.0)
    part = SimpleNamespace(steps=(first,), label="")
    test = SimpleNamespace(step=None, cause=Cause.NONE, part=part, done_s=0.5)
    record = find_device("simulated").capabilities
    assert state_text(test, record) == "Starting"
    test.done_s = 2.5
    assert state_text(test, record) == "Pause"


def test_every_step_has_words():
    names = ["right", "left", "up", "down", "towards you", "away from you", "vibration"]
    steps = [DemonstrationStep(0.0, 1.0, name, 2.25) for name in names]
    falcon, wheel = (
        installed_devices()[name].capabilities for name in ("falcon", "wheel")
    )
    assert len({step_text(step, falcon) for step in steps}) == len(names)
    assert all(step_text(step, falcon).endswith(", 2.2\u00a0N") for step in steps)
    assert step_text(steps[0], wheel) == "To the right, 50 % of its strength"
    assert "push it in" in homing_text()


def test_the_window_lends_its_device_and_gets_it_back(make_window, wait_for, qtbot):
    window = make_window("simulated")
    window.commands.get_to_know.trigger()
    page = window.findChild(DevicePage)
    assert page.isVisible()
    assert window.player.snapshot().leading.health is Health.NONE
    page.reject()
    wait_for(lambda: window.player.snapshot().leading.health is Health.READY)


def test_without_a_device_there_is_nothing_to_get_to_know(window):
    window.commands.get_to_know.trigger()
    assert window.findChild(DevicePage) is None
    assert "device" in window.messages.text()
