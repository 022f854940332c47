"""Setting a Falcon up in the window: found, loaded, homed, and every problem said."""

import errno

import pytest
from PySide6.QtWidgets import QFileDialog

from app.player import choices
from app.player.choices import PluggedFalcons
from app.player.firmware_dialog import offer_firmware
from app.player.homing_view import HomingView
from app.player.question import Question
from hapticplayer.devices.falcon.firmware import find_image
from tests.app.setting_up.conftest import small_image


@pytest.fixture
def _undecided(owner):
    """The owner holds the grip, and does not pull it yet."""
    owner.deciding_s = 1e9


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
def test_a_falcon_cannot_be_used_before_it_is_homed(make_page, wait_for):
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


def test_plugged_devices_are_looked_for_beside_the_window(application, wait_for):
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


def test_another_choice_lets_go_of_the_falcon(make_page, falcon, wait_for):
    page = make_page()
    wait_for(lambda: falcon.bus.ports[0].is_claimed)
    page.device.setCurrentIndex(page.device.findData("simulated"))
    page.device.activated.emit(page.device.currentIndex())
    wait_for(lambda: not falcon.bus.ports[0].is_claimed)
    assert page.use.isEnabled()
