"""From its set-up a device is tested, and its forces are tried."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.player.device_page import DevicePage
from app.player.outputs_page import OutputsPage
from app.player.setup_page import SetupPage
from hapticplayer.haptics.processes import Health
from tests.app.setting_up.conftest import choose


def begin_test(page, wait_for, until_s=1.2):
    page.panel.test_button.click()
    text = page.panel.question.text.text()
    page.panel.question.yes.click()
    wait_for(lambda: page.panel.test is not None and page.panel.test.done_s > until_s)
    return text


def test_a_device_is_tested_after_asking_and_stopped_by_escape(make_page, wait_for):
    page = make_page("simulated")
    text = begin_test(page, wait_for)
    assert text.startswith(
        "Simulated\n\nIt will push gently in each direction for 18 s,"
    )
    assert "with up to 1.1\u00a0N" in text
    assert "Esc or STOP ends it immediately." in text
    wait_for(lambda: page.panel.state.text() == "To the right, 1.1\u00a0N")
    wait_for(lambda: page.panel.picture.shown.grip.force_n[0] > 0.3)
    assert not page.use.isEnabled()
    assert not page.device.isEnabled()
    assert page.focusWidget() is page.panel.stop_button
    player = page.panel.test.player
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert not page.panel.is_acting
    wait_for(lambda: player.health is Health.GONE)
    wait_for(lambda: not page.panel.is_running)
    assert page.isVisible()  # the first Escape ends the test, the next one the page
    assert page.panel.state.text() == "Stopped."
    assert page.focusWidget() is page.panel.test_button
    wait_for(page.use.isEnabled)


def test_a_falcon_is_tested_only_when_it_is_homed(make_page, wait_for):
    page = make_page()
    wait_for(lambda: page.drawing.view.arrow == 1)
    assert not page.panel.test_button.isEnabled()
    wait_for(lambda: page.is_ready)
    wait_for(page.panel.test_button.isEnabled)
    page.panel.begin()
    assert not page.panel.is_free()  # before the page has let go of it
    wait_for(page.panel.is_free)
    page.panel.stop()
    wait_for(lambda: page.is_ready)  # and holds it again


def test_a_test_waits_until_the_window_has_let_go(make_window, wait_for):
    window = make_window("none")
    window.player.set_outputs(["simulated"])
    states = window.player.snapshot
    wait_for(lambda: states().outputs[0].health is Health.READY)
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    choose(page, "simulated")
    assert states().outputs[0].health is Health.NONE
    begin_test(page, wait_for, until_s=0.0)
    page.reject()
    wait_for(lambda: not page.panel.is_running)
    page.reject()
    wait_for(lambda: states().outputs[0].health is Health.READY)


def test_the_forces_of_an_output_are_tried_and_it_plays_again(make_window, wait_for):
    window = make_window("none")
    window.player.set_outputs(["simulated"])
    window.commands.outputs.trigger()
    window.findChild(OutputsPage).set_up_wanted.emit("simulated")
    window.findChild(SetupPage).forces.click()
    wait_for(lambda: window.findChild(DevicePage) is not None)
    page, states = window.findChild(DevicePage), window.player.snapshot
    assert states().outputs[0].health is Health.NONE  # it is lent to the page
    page.begin()
    wait_for(lambda: page.test.done_s > 0.0)
    page.reject()
    wait_for(lambda: states().outputs[0].health is Health.READY)


def test_a_device_test_leads_on_to_the_forces(make_window, wait_for):
    window = make_window("simulated")
    window.commands.set_up_device.trigger()
    window.findChild(SetupPage).forces.click()
    wait_for(lambda: window.findChild(DevicePage) is not None)
    window.findChild(DevicePage).reject()
    wait_for(lambda: window.player.snapshot().leading.name == "simulated")
