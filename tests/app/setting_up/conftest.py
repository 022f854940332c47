"""The page that sets a device up, with a simulated Falcon at the other end."""

import pytest

from app.player import setup_page
from app.player.choices import PluggedFalcons
from app.player.setup_page import SetupPage
from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.transport import open_falcon


def small_image():
    """Return firmware that is loaded within 0.1 s."""
    from hapticplayer.extras.faults.usb.board import synthetic_image

    return synthetic_image(200)


@pytest.fixture
def owner():
    """Somebody who soon homes the Falcon."""
    from hapticplayer.extras.faults.usb.mechanics import Homing

    return Homing(deciding_s=0.2)


@pytest.fixture
def falcon(owner):
    """A simulated one, just plugged in."""
    from hapticplayer.extras.faults.usb.board import Stage
    from hapticplayer.extras.faults.usb.driver import make_set

    return make_set(stage=Stage.DARK, homing=owner)


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


def choose(page, kind, text=""):
    page.device.setCurrentIndex(page.device.findData(kind))
    page.device.activated.emit(page.device.currentIndex())
    page.form.settings.setText(text)
    page.form.settings.editingFinished.emit()
