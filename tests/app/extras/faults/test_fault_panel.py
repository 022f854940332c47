"""The developer's panel: faults through the real window, processes and contract."""

import pytest

from app.extras.faults.panel import FaultPanel, expected, fault_text, names
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.processes import Health

pytestmark = pytest.mark.realtime

PENDING = "\u2026"


@pytest.fixture
def window(make_window, source, wait_for):
    """The clip plays again and again on the simulated device, without faults."""
    made = make_window("simulated")
    made.session.show_source(source)
    made.player.set_loop((0.0, 1.5))
    made.player.play()
    return made


@pytest.fixture
def panel(window, wait_for):
    window.commands.faults.trigger()
    made = window.findChild(FaultPanel)
    wait_for(lambda: is_acting(window))
    return made


def is_acting(window):
    latest = window.player.snapshot().leading.tick
    return latest is not None and latest["mode"] in (Mode.ENTERING, Mode.FOLLOWING)


def cells(panel, row=0):
    return [panel.table.item(row, column).text() for column in range(4)]


def press_until_met(panel, window, wait_for, fault, rule):
    """Press a fault until its rule answers: a busy machine may take the force first."""

    def is_met():
        met = cells(panel)[1]
        if panel.rearm.isEnabled() and met != rule:
            panel.rearm.click()
        elif is_acting(window) and met not in (rule, PENDING):
            panel.buttons[fault].click()
        return met == rule

    wait_for(panel.buttons[fault].isEnabled)
    panel.buttons[fault].click()
    wait_for(lambda: panel.table.rowCount() and is_met())


@pytest.mark.parametrize(
    ("fault", "rule"),
    [
        ("position-nan", "NOT_FINITE (TRIP)"),
        ("force-nan", "NOT_FINITE (TRIP)"),
        ("unplug", "UNPLUGGED (TRIP)"),
        ("long-stall", "REPLY_LOST (TRIP)"),
        ("hang-long", "HEARTBEAT_LOST (TRIP)"),
    ],
)
def test_a_fault_is_answered_by_its_rule_and_told(panel, window, wait_for, fault, rule):
    press_until_met(panel, window, wait_for, fault, rule)
    wait_for(lambda: cells(panel)[3] != "\u2013")
    assert cells(panel)[0] == fault_text(fault)
    assert rule in expected(fault)
    _, _, reaction_ms, zero_ms = cells(panel)
    assert 0 <= int(reaction_ms) <= int(zero_ms)
    wait_for(panel.rearm.isEnabled)
    assert "STOPPED" in panel.state.text() or fault == "unplug"


def test_the_force_comes_back_after_re_arming(panel, window, wait_for):
    press_until_met(panel, window, wait_for, "position-nan", "NOT_FINITE (TRIP)")
    wait_for(panel.rearm.isEnabled)
    window.player.play()
    panel.rearm.click()
    wait_for(lambda: is_acting(window))
    press_until_met(panel, window, wait_for, "short-stall", "REPLY_LATE (RAMP)")
    rules = [cells(panel, row)[1] for row in range(1, panel.table.rowCount())]
    assert "NOT_FINITE (TRIP)" in rules  # the one before is kept


def test_an_unplugged_device_is_restarted(panel, window, wait_for):
    wait_for(panel.buttons["unplug"].isEnabled)
    panel.buttons["unplug"].click()
    wait_for(lambda: window.player.snapshot().leading.health is Health.FAILED)
    wait_for(lambda: not any(one.isEnabled() for one in panel.buttons.values()))
    assert "Restart device" in panel.hint.text()
    panel.again.click()
    wait_for(lambda: window.player.snapshot().leading.health is Health.READY)
    assert window.session.is_stopped  # it is re-armed as after any other trip
    assert window.player.snapshot().leading.takes_faults


def test_faults_are_over_when_the_panel_closes(panel, window, wait_for):
    assert window.player.snapshot().leading.takes_faults
    panel.reject()
    assert window.player.snapshot().leading.name == "simulated"
    assert not window.player.snapshot().leading.takes_faults


def test_without_a_simulated_device_no_fault_can_be_pressed(make_window, wait_for):
    window = make_window("none")
    window.commands.faults.trigger()
    panel = window.findChild(FaultPanel)
    assert not any(button.isEnabled() for button in panel.buttons.values())
    assert "a simulated device" in panel.hint.text()
    panel.reject()


def test_no_fault_can_be_pressed_while_nothing_is_felt(panel, window, wait_for):
    window.player.pause()
    wait_for(lambda: not any(one.isEnabled() for one in panel.buttons.values()))
    assert "Play a clip with force first" in panel.hint.text()


def test_every_fault_has_words_and_a_rule():
    assert len({fault_text(name) for name in names()}) == len(names()) == 14
    assert all("TRIP" in expected(n) or "RAMP" in expected(n) for n in names())
