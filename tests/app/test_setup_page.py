"""Setting a Falcon up in the window: found, loaded, homed, and every trouble said."""

import errno
import socket
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog

from app.bridge.settings import outlets_of
from app.player import check_list, choices, setup_page
from app.player.choices import PluggedFalcons
from app.player.device_page import DevicePage
from app.player.firmware_dialog import offer_firmware
from app.player.homing_view import HomingDrawing, HomingView, TravelEstimate, view_of
from app.player.outlets_page import OutletsPage
from app.player.question import Question
from app.player.setup_page import SetupPage
from app.widgets import theme
from hapticplayer.clock import SystemClock
from hapticplayer.devices import DEVICES, guides, installed_devices
from hapticplayer.devices.checks import Check
from hapticplayer.devices.falcon.firmware import find_image
from hapticplayer.devices.falcon.homing import WAY_COUNTS, Advice, Guidance
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.setting_up import Progress, Step
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.devices.guides import Guide
from hapticplayer.devices.rig.packets import FORMATS
from hapticplayer.errors import Message
from hapticplayer.haptics.processes import Health
from hapticplayer.simulation.usb import mechanics
from hapticplayer.simulation.usb.board import Stage, synthetic_image
from hapticplayer.simulation.usb.driver import make_set
from hapticplayer.simulation.usb.mechanics import Homing


def small_image():
    """Return firmware that is loaded within 0.1 s."""
    return synthetic_image(200)


@pytest.fixture
def falcon(monkeypatch):
    """A simulated one, just plugged in, with an owner who soon homes it."""
    monkeypatch.setattr(mechanics, "_DECIDING_S", 0.2)
    return make_set(stage=Stage.DARK, homing=Homing())


@pytest.fixture
def _undecided(falcon, monkeypatch):
    """The owner holds the grip, and does not pull it yet."""
    monkeypatch.setattr(mechanics, "_DECIDING_S", 1e9)


@pytest.fixture
def others():
    """Devices of other packages: "seat" has a guide, "plain" has none."""
    guide = Guide(
        Message("A seat by UDP."),
        Message("Push it in."),
        checks=lambda _: [Check(Message("Ticket"), False, Message("Pay it."))],
    )
    seat = replace(DEVICES["gamepad"], name="seat", guide=f"{guides.__name__}:SEAT")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(guides, "SEAT", guide, raising=False)
        patch.setitem(DEVICES, "seat", seat)
        patch.setitem(DEVICES, "plain", replace(seat, name="plain", guide=""))
        installed_devices.cache_clear()
        yield
    installed_devices.cache_clear()


@pytest.fixture
def make_page(application, qtbot, falcon, wait_for, tmp_path, settings, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setattr(setup_page, "LOOK_MS", 50)
    made = []

    def make(device="falcon", serials=("SIM00001",), image=small_image):
        plugged = PluggedFalcons(lambda: list(serials))

        def find_reach(_name):
            return Reach(lambda: open_falcon(backend=falcon.bus), image)

        page = SetupPage(SystemClock(), device, plugged, settings, None, find_reach)
        page.show()
        qtbot.waitExposed(page)
        made.append((page, plugged))
        return page

    yield make
    for page, plugged in made:
        page.reject()
        wait_for(lambda page=page: not page.is_busy)
        plugged.close()
    assert not falcon.bus.ports[0].is_claimed
    assert falcon.simulation.commanded_n == (0.0, 0.0, 0.0)


def test_from_power_up_to_a_grip_that_is_followed(make_page, wait_for):
    page = make_page()
    titles, arrows = [], []

    def is_ready():
        titles.append(page.title.text())
        arrows.append(page.drawing.view.arrow)
        return page.is_ready

    wait_for(is_ready)
    wanted = [
        "Pull the grip all the way out",
        "Push the grip in until it locks",
    ]
    assert list(dict.fromkeys(t for t in titles if t in wanted)) == wanted
    assert {1, -1} <= set(arrows)
    wait_for(lambda: page.drawing.view.is_ready)
    assert page.title.text() == "The Falcon is ready"
    assert page.drawing.view.homed == (True, True, True)
    assert "lower left" in page.drawing.accessibleDescription()
    wait_for(lambda: page.use.isEnabled() and page.forces.isEnabled())


@pytest.mark.usefixtures("_undecided")
def test_it_cannot_be_used_before_it_is_homed(make_page, wait_for):
    page = make_page()
    wait_for(lambda: page.drawing.view.arrow == 1)
    assert not page.use.isEnabled()
    assert not page.forces.isEnabled()


@pytest.mark.usefixtures("_undecided")
@pytest.mark.parametrize(
    ("code", "title", "remedy"),
    [
        (errno.EACCES, "Permission denied", "packaging/udev/70-novint-falcon.rules"),
        (errno.EBUSY, "in use by another program", "Close that program"),
        (errno.ENOSYS, "wrong driver", "WinUSB"),
        (errno.ENODEV, "not plugged in", "power supply"),
        (errno.EPIPE, "cannot be used", "plug it in again"),
    ],
)
def test_each_trouble_is_said_and_goes_away_by_itself(
    make_page, falcon, wait_for, code, title, remedy
):
    falcon.bus.ports[0].refuses_with = code
    page = make_page()
    wait_for(lambda: title in page.title.text())
    assert remedy in page.text.text()
    assert page.drawing.view == HomingView()
    falcon.bus.ports[0].refuses_with = 0
    wait_for(lambda: page.drawing.view.arrow == 1)


@pytest.mark.usefixtures("_undecided")
def test_pulling_the_cable_while_homing_is_said(make_page, falcon, wait_for):
    page = make_page()
    wait_for(lambda: page.drawing.view.arrow == 1)
    falcon.chip.unplug()
    wait_for(lambda: "not plugged in" in page.title.text())


def answer(page, wait_for, yes=True):
    wait_for(lambda: any(q.isVisible() for q in page.findChildren(Question)))
    question = next(q for q in page.findChildren(Question) if q.isVisible())
    text = question.text.text()
    (question.yes if yes else question.no).click()
    return text


@pytest.mark.usefixtures("_undecided")
def test_missing_firmware_is_given_in_the_window(make_page, wait_for, tmp_path):
    page = make_page(image=find_image)
    wait_for(lambda: "needs its firmware" in page.title.text())
    assert "libnifalcon" in page.text.text()
    page.firmware.click()
    wait_for(lambda: page.findChild(QFileDialog) is not None)
    file = tmp_path / "image.bin"
    file.write_bytes(small_image().data)
    page.findChild(QFileDialog).close()
    offer_firmware(page, file, page.begin, page.on_no_firmware)
    assert "Novint" in answer(page, wait_for, yes=False)
    assert not (tmp_path / "data").exists()
    offer_firmware(page, file, page.begin, page.on_no_firmware)
    answer(page, wait_for)
    assert "not a known firmware image" in answer(page, wait_for)
    wait_for(lambda: page.drawing.view.arrow == 1)
    assert find_image().data == file.read_bytes()


def test_a_file_that_is_no_firmware_is_refused_and_said(make_page, wait_for, tmp_path):
    page = make_page(image=find_image)
    wait_for(lambda: "needs its firmware" in page.title.text())
    file = tmp_path / "image.bin"
    file.write_bytes(b"no firmware at all")
    offer_firmware(page, file, page.begin, page.on_no_firmware)
    answer(page, wait_for)
    wait_for(lambda: "cannot be used" in page.title.text())
    assert "08AA" in page.text.text()


def test_several_falcons_are_told_apart_by_their_numbers(make_page, wait_for):
    page = make_page("none", ["FTPNM0FB", "12PZ657E"])
    wait_for(lambda: page.device.findText("Falcon FTPNM0FB") >= 0)
    assert page.device.findData("falcon:12PZ657E") >= 0
    assert page.device.findText("Falcon 12PZ657E") >= 0


def test_the_only_falcon_shows_its_number_and_keeps_its_name():
    found = choices.devices("none", [("falcon", "12PZ657E")])
    assert ("falcon", "Falcon 12PZ657E", "") in found
    gone = choices.devices("falcon:GONE", [("falcon", "")])
    assert gone[0].name == "falcon:GONE"


def test_what_is_plugged_in_is_looked_for_beside_the_window(application, wait_for):
    found = [["B", "A"], ["A"], []]
    plugged = PluggedFalcons(lambda: found.pop(0))
    seen = []
    plugged.changed.connect(lambda: seen.append(plugged.falcons()))
    for count in (1, 2, 3):
        plugged.refresh()
        wait_for(lambda count=count: len(seen) == count)
    assert seen == [
        [("falcon:A", "A"), ("falcon:B", "B")],
        [("falcon", "A")],
        [("falcon", "")],
    ]
    plugged.close()


def test_a_device_that_needs_nothing_says_so(make_page, wait_for):
    page = make_page("simulated")
    assert page.is_ready
    assert "simulated hand" in page.what.text()
    wait_for(lambda: page.title.text() == "No setup needed")
    assert not page.drawing.isVisible()
    assert not page.form.settings.isVisible()
    assert not page.is_busy


def choose(page, kind, text=""):
    page.device.setCurrentIndex(page.device.findData(kind))
    page.device.activated.emit(page.device.currentIndex())
    page.form.settings.setText(text)
    page.form.settings.editingFinished.emit()


def test_every_kind_says_what_it_is_and_how_to_connect_it(make_page):
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


def test_what_is_missing_is_said_until_it_is_there(make_page, wait_for, monkeypatch):
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


def test_a_device_of_another_package_has_a_page(others, make_page, wait_for):
    page = make_page("seat")
    wait_for(lambda: page.title.text() == "Not ready yet")
    assert page.what.text() == "A seat by UDP."
    assert "Pay it." in page.checks.label.text()
    choose(page, "plain")
    assert page.text.text() == "Connect it as its maker says."


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
    player = page.panel.test._player
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
    assert not page.panel._is_free()  # before the page has let go of it
    wait_for(page.panel._is_free)
    page.panel.stop()
    wait_for(lambda: page.is_ready)  # and holds it again


def test_a_test_waits_until_the_window_has_let_go(make_window, wait_for):
    window = make_window("none")
    window.player.set_outlets(["simulated"])
    states = window.player.snapshot
    wait_for(lambda: states().outlets[0].health is Health.READY)
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    choose(page, "simulated")
    assert states().outlets[0].health is Health.NONE
    begin_test(page, wait_for, until_s=0.0)
    page.reject()
    wait_for(lambda: not page.panel.is_running)
    page.reject()
    wait_for(lambda: states().outlets[0].health is Health.READY)


def test_the_forces_of_an_outlet_are_tried_and_it_plays_again(make_window, wait_for):
    window = make_window("none")
    window.player.set_outlets(["simulated"])
    window.commands.outlets.trigger()
    window.findChild(OutletsPage).set_up_wanted.emit("simulated")
    window.findChild(SetupPage).forces.click()
    wait_for(lambda: window.findChild(DevicePage) is not None)
    page, states = window.findChild(DevicePage), window.player.snapshot
    assert states().outlets[0].health is Health.NONE  # it is lent to the page
    page.begin()
    wait_for(lambda: page.force_player.media_s > 0.0)
    page.reject()
    wait_for(lambda: states().outlets[0].health is Health.READY)
    assert states().device == "none"


def test_a_rig_is_set_up_and_plays_beside_the_device(make_window, wait_for):
    window = make_window("simulated")
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    choose(page, "rig:outsim", "127.0.0.1:9")
    page.use.click()
    name = "rig:outsim,127.0.0.1:9"
    wait_for(lambda: [o.name for o in window.player.snapshot().outlets] == [name])
    wait_for(lambda: window.player.snapshot().device == "simulated")
    assert outlets_of(window.settings) == {name: False}


def test_more_devices_lead_here_and_back(make_window, wait_for):
    window = make_window("simulated")
    window.player.set_outlets(["rumble"])
    window.commands.outlets.trigger()
    window.findChild(OutletsPage).set_up_wanted.emit("rumble")
    page = window.findChild(SetupPage)
    assert page.chosen == "rumble"
    choose(page, "tcode")
    page.use.click()
    beside = ["tcode"]
    wait_for(lambda: [o.name for o in window.player.snapshot().outlets] == beside)
    window.findChild(OutletsPage).accept()
    window.commands.set_up_device.trigger()
    pages = window.findChildren(SetupPage)
    next(one for one in pages if one.isVisible()).others.click()
    wait_for(lambda: any(o.isVisible() for o in window.findChildren(OutletsPage)))
    wait_for(lambda: window.player.snapshot().device == "simulated")


def test_another_choice_lets_go_of_the_falcon(make_page, falcon, wait_for):
    page = make_page()
    wait_for(lambda: falcon.bus.ports[0].is_claimed)
    page.device.setCurrentIndex(page.device.findData("simulated"))
    page.device.activated.emit(page.device.currentIndex())
    wait_for(lambda: not falcon.bus.ports[0].is_claimed)
    assert page.use.isEnabled()


def test_the_first_page_leads_here_and_the_choice_is_taken(make_window, wait_for):
    window = make_window("none")
    window.empty_page.device.click()
    page = window.findChild(SetupPage)
    assert page.isVisible()
    page.device.setCurrentIndex(page.device.findData("simulated"))
    page.begin()
    wait_for(page.use.isEnabled)
    page.use.click()
    wait_for(lambda: window.player.snapshot().device == "simulated")
    assert window.settings.text("device") == "simulated"


def test_closing_it_gives_the_device_from_before_back(make_window, wait_for):
    window = make_window("simulated")
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    assert window.player.snapshot().device == "none"
    page.close_button.click()
    wait_for(lambda: window.player.snapshot().device == "simulated")


def test_it_leads_on_to_the_forces(make_window, wait_for):
    window = make_window("simulated")
    window.commands.set_up_device.trigger()
    window.findChild(SetupPage).forces.click()
    wait_for(lambda: window.findChild(DevicePage) is not None)
    window.findChild(DevicePage).reject()
    wait_for(lambda: window.player.snapshot().device == "simulated")


def test_the_travel_of_a_leg_is_shown_from_end_to_end():
    ways = TravelEstimate()
    assert ways.share(0, 0) == 0.5
    assert ways.share(0, WAY_COUNTS) == 1.0
    assert ways.share(0, 0) == 0.0
    assert ways.share(0, -WAY_COUNTS) == 0.0
    assert ways.share(0, 0) == 1.0
    assert ways.share(1, 0) == 0.5  # each for itself


def test_a_view_says_what_the_guidance_says():
    guidance = Guidance(Advice.PUSH, (True, False, True), 600.0, (600, 0, 1200))
    view = view_of(Progress(Step.HOMING, 1.0, guidance), TravelEstimate())
    assert (view.homed, view.arrow, view.is_ready) == ((True, False, True), -1, False)
    assert view.legs == (0.75, 0.5, 1.0)
    view = view_of(
        Progress(Step.READY, 1.0, None, (0.02, -0.04, 0.08)), TravelEstimate()
    )
    assert (view.aside, view.out, view.is_ready) == ((0.5, -1.0), 1.0, True)
    assert view_of(None, TravelEstimate()) == HomingView()


def colours(picture):
    """Return how many pixels have each of the theme's signal colours."""
    image = picture.grab().toImage()
    names = [
        image.pixelColor(x, y).name()
        for x in range(image.width())
        for y in range(image.height())
    ]
    return {n: names.count(QColor(getattr(theme, n)).name()) for n in ("GOOD", "WARN")}


def test_the_picture_shows_rings_discs_and_arrows(application, qtbot):
    picture = HomingDrawing()
    qtbot.addWidget(picture)
    open_rings = HomingView((False,) * 3, (0.5,) * 3, 0.5)
    found = []
    for view in (
        open_rings,
        open_rings._replace(arrow=1),
        open_rings._replace(homed=(True, False, False)),
        open_rings._replace(homed=(True,) * 3),
    ):
        picture.show_view(view)
        found.append(colours(picture))
    none, arrow, one, three = found
    assert none["GOOD"] == 0
    assert none["WARN"] > 100  # three rings
    assert arrow["WARN"] > none["WARN"] + 200
    assert three["GOOD"] > 2.5 * one["GOOD"] > 0
    assert three["WARN"] == 0
