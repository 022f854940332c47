"""Pictures of the device's pages: setting up, every problem, forces, latencies."""

from app.bridge.settings import Settings
from app.player import setup_texts
from app.player.choices import PluggedFalcons
from app.player.device_page import DevicePage
from app.player.force_words import homing_text
from app.player.latency_page import LatencyPage
from app.player.question import Question
from app.player.setup_page import SetupPage
from app.player.video_surface import SurfaceSink
from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.falcon.firmware import FirmwareMissingError, find_image
from hapticplayer.devices.falcon.homing import Advice, Guidance
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.setting_up import Progress, Step
from hapticplayer.devices.falcon.transport import (
    FalconBusyError,
    FalconDriverError,
    FalconForbiddenError,
    FalconGoneError,
    Transport,
)
from hapticplayer.errors import DeviceError
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.player import Player
from tools.pages.stage import Pictures, Stage

_TROUBLES: dict[str, type[DeviceError]] = {
    "unplugged": FalconGoneError,
    "forbidden": FalconForbiddenError,
    "busy": FalconBusyError,
    "driver": FalconDriverError,
    "firmware": FirmwareMissingError,
    "unknown": DeviceError,
}
_FIRST, _ALL = (True, False, False), (True, True, True)
_STEPS = {
    "loading": Progress(Step.LOADING, 0.6),
    "pull": Progress(
        Step.HOMING, 1.0, Guidance(Advice.PULL, _FIRST, 500.0, (600, 500, 400))
    ),
    "push": Progress(
        Step.HOMING, 1.0, Guidance(Advice.PUSH, _FIRST, 500.0, (600, 500, 400))
    ),
    "ready": Progress(
        Step.READY, 1.0, Guidance(Advice.DONE, _ALL, 0.0, (0, 0, 0)), (0.01, 0.0, 0.01)
    ),
}
PLAYED_MS = 1500


def pictures(stage: Stage) -> Pictures:
    """Yield every page about devices."""
    yield from _set_up(stage)
    for name, text in (
        ("licence", setup_texts.licence()),
        ("unknown", setup_texts.unknown_image()),
    ):
        with stage.shown(Question(None, "Firmware", text, "OK")) as question:
            yield f"firmware-{name}", question.grab()
    yield from _forces(stage)
    yield from _latencies(stage)


def _set_up(stage: Stage) -> Pictures:
    for name, kind in _TROUBLES.items():
        with stage.shown(_page("falcon", kind)) as page:
            stage.wait(300)
            yield f"set-up-{name}", page.grab()
    for name, progress in _STEPS.items():
        with stage.shown(_page("falcon", FalconGoneError)) as page:
            page.freeze(progress)
            stage.wait()
            yield f"set-up-{name}", page.grab()
    for device in ("simulated", "rumble"):
        with stage.shown(_page(device, FalconGoneError)) as page:
            yield f"set-up-{device}", page.grab()


def _page(device: str, kind: type[DeviceError]) -> SetupPage:
    page = SetupPage(
        SystemClock(), device, _plugged(), Settings(None), None, lambda _name: _no(kind)
    )
    page.resize(page.sizeHint())
    return page


def _plugged() -> PluggedFalcons:
    return PluggedFalcons(lambda: ["12PZ657E"])


def _no(kind: type[DeviceError]) -> Reach:
    def refuse() -> Transport:
        raise kind("the interface said something unexpected (LIBUSB_ERROR_OTHER)")

    return Reach(refuse, find_image)


def _forces(stage: Stage) -> Pictures:
    page = DevicePage(SystemClock(), "simulated")
    with stage.shown(page):
        yield "forces", page.grab()
        page.begin()
        stage.wait_until(lambda: "1" in page.text.text())
        yield "forces-felt", page.grab()
        page.stop()
        yield "forces-stopped", stage.picture(page)
        page.text.setText(homing_text())
        yield "forces-homing", stage.picture(page)


def _latencies(stage: Stage) -> Pictures:
    page = LatencyPage(
        *(SystemClock(), "simulated", stage.settings, _player), StopLatch()
    )
    with stage.shown(page):
        yield "latencies", page.grab()
        page.begin()
        stage.wait_until(lambda: page.player is not None)
        yield "latencies-together", stage.picture(page, PLAYED_MS)
        page.choose("sound")
        page.tap()
        yield "latencies-tapping", stage.picture(page)


def _player(clock: Clock, sink: SurfaceSink, device: str) -> Player:
    return Player(clock, sink, outputs=[device], audio=None)
