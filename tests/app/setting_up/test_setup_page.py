"""Setting any device up in the window: what it is, what is missing, its settings."""

import socket
from dataclasses import replace

import pytest

from app.bridge.settings import KeptOutput, outputs_of
from app.player import check_list
from app.player.outputs_page import OutputsPage
from app.player.setup_page import SetupPage
from hapticplayer.devices import DEVICES, guides, installed_devices
from hapticplayer.devices.checks import Check
from hapticplayer.devices.guides import Guide
from hapticplayer.errors import Message
from hapticplayer.haptics.processes import Health
from tests.app.setting_up.conftest import choose
from tests.needed_extras import needs


@pytest.fixture
def others():
    """Devices of other packages: "seat" has a guide, "plain" has none."""
    guide = Guide(
        Message("A seat by UDP."),
        Message("Push it in."),
        checks=lambda _: [Check(Message("Ticket"), False, Message("Pay it."))],
    )
    seat = replace(
        installed_devices()["rumble"], name="seat", guide=f"{guides.__name__}:SEAT"
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(guides, "SEAT", guide, raising=False)
        patch.setitem(DEVICES, "seat", seat)
        patch.setitem(DEVICES, "plain", replace(seat, name="plain", guide=""))
        installed_devices.cache_clear()
        yield
    installed_devices.cache_clear()


def test_a_device_that_needs_nothing_says_so(make_page, wait_for):
    page = make_page("simulated")
    assert page.is_ready
    assert "simulated hand" in page.what.text()
    wait_for(lambda: page.title.text() == "No setup needed")
    assert not page.drawing.isVisible()
    assert not page.form.settings.isVisible()
    assert not page.is_busy


def test_every_kind_says_what_it_is_and_how_to_connect_it(make_page):
    from hapticplayer.extras.rigs.packets import FORMATS

    page = make_page("simulated")
    said = {}
    for row in range(page.device.count()):
        kind = page.device.itemData(row)
        choose(page, kind)
        said[kind] = page.what.text(), page.text.text()
        assert all(said[kind]), kind
    assert {f"rig:{name}" for name in FORMATS} | {"wheel", "shaker"} <= set(said)
    assert "game" in said["rig:outsim"][0]
    assert len({what for what, _ in said.values()}) == len(said) - 2  # one for all rigs


def test_a_missing_requirement_is_named_until_it_is_met(
    make_page, wait_for, monkeypatch
):
    monkeypatch.setattr(check_list, "LOOK_MS", 50)
    monkeypatch.setattr(check_list, "MOST_SHARE", 1.0)
    page = make_page("simulated")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        where = f"127.0.0.1:{end.getsockname()[1]}"
        choose(page, "rig:outsim", where)
        wait_for(lambda: page.title.text() == "Ready to be tested")
        assert page.chosen == f"rig:outsim,{where}"
    choose(page, "rig:beamng", where)
    wait_for(lambda: page.title.text() == "Not ready yet")
    assert f"Program that listens at {where}: missing" in page.checks.label.text()
    assert "Start the rig's software" in page.checks.label.text()
    assert not page.use.isEnabled()
    assert not page.panel.test_button.isEnabled()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", int(where.rpartition(":")[2])))
        wait_for(lambda: page.title.text() == "Ready to be tested")


def test_settings_that_are_not_allowed_cannot_be_used(make_page, wait_for):
    page = make_page("simulated")
    choose(page, "shaker", "pulse,channels=3+9")
    wait_for(lambda: "shaker option 'channels=3+9'" in page.title.text())
    assert not page.use.isEnabled()
    assert not page.latency.number.isEnabled()
    choose(page, "shaker")
    assert page.use.isEnabled()
    assert page.latency.number.isEnabled()


def test_settings_of_the_device_in_use_are_shown(make_page):
    page = make_page("wheel:event5,axis=y")
    assert page.device.currentData() == "wheel"
    assert page.form.settings.text() == "event5,axis=y"
    assert page.chosen == "wheel:event5,axis=y"


@needs("wheels")
def test_a_device_of_another_package_has_a_page(others, make_page, wait_for):
    page = make_page("seat")
    wait_for(lambda: page.title.text() == "Not ready yet")
    assert page.what.text() == "A seat by UDP."
    assert "Pay it." in page.checks.label.text()
    choose(page, "plain")
    assert page.text.text() == "Connect it as its maker says."


@needs("rigs")
def test_a_rig_may_take_the_place_of_the_leading_device(make_window, wait_for):
    window = make_window("simulated")
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    choose(page, "rig:outsim", "127.0.0.1:9")
    page.use.click()
    name = "rig:outsim,127.0.0.1:9"
    wait_for(lambda: window.player.output_names == [name])
    wait_for(lambda: outputs_of(window.settings) == {name: KeptOutput(gain=1.0)})
    wait_for(lambda: window.player.snapshot().leading.health is Health.READY)


@needs("wheels")
def test_the_outputs_lead_here_and_back(make_window, wait_for):
    window = make_window("simulated", "rumble")
    window.commands.outputs.trigger()
    window.findChild(OutputsPage).set_up_wanted.emit("rumble")
    page = window.findChild(SetupPage)
    assert page.chosen == "rumble"
    choose(page, "tcode")
    page.use.click()
    wait_for(lambda: window.player.output_names == ["simulated", "tcode"])
    window.findChild(OutputsPage).accept()
    window.commands.set_up_device.trigger()
    pages = window.findChildren(SetupPage)
    next(one for one in pages if one.isVisible()).others.click()
    wait_for(lambda: any(o.isVisible() for o in window.findChildren(OutputsPage)))
    wait_for(lambda: window.player.snapshot().leading.health is Health.READY)


def test_the_first_page_leads_here_and_the_choice_is_taken(make_window, wait_for):
    window = make_window("none")
    window.empty_page.device.click()
    page = window.findChild(SetupPage)
    assert page.isVisible()
    page.device.setCurrentIndex(page.device.findData("simulated"))
    page.begin()
    wait_for(page.use.isEnabled)
    page.use.click()
    wait_for(lambda: window.player.snapshot().leading.name == "simulated")
    assert list(outputs_of(window.settings)) == ["simulated"]


def test_closing_it_gives_the_device_from_before_back(make_window, wait_for):
    window = make_window("simulated")
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    assert window.player.snapshot().leading.health is Health.NONE
    page.close_button.click()
    wait_for(lambda: window.player.snapshot().leading.health is Health.READY)
