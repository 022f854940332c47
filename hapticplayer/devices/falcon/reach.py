"""A Falcon by its name on the command line: `falcon`, `falcon:SERIAL`, or a simulated one.

For tools that speak to the device themselves: its firmware, its homing, measurements.
Playing goes through the haptics process instead.
"""

from collections.abc import Callable
from dataclasses import dataclass

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon.driver import FalconDriver, opening
from hapticplayer.devices.falcon.firmware import FirmwareImage, find_image
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.link import DirectLink, Link
from hapticplayer.devices.falcon.silence import NO_LINE
from hapticplayer.devices.falcon.transport import OpenTransport, open_falcon
from hapticplayer.errors import UsageError


@dataclass(frozen=True, slots=True)
class Reach:
    """How to get at one Falcon.

    Attributes:
        open_transport: finds and opens it.
        image: returns the firmware for it.
    """

    open_transport: OpenTransport
    image: Callable[[], FirmwareImage]

    def driver(
        self, clock: Clock, make_link: Callable[[Ftdi, Clock], Link] = DirectLink
    ) -> FalconDriver:
        """Return its driver, not open; by default it makes the caller wait."""
        return FalconDriver(
            self.open_transport, clock=clock, image=self.image, make_link=make_link
        )


def reach_of(name: str, line: int = NO_LINE) -> Reach:
    """Return how to get at the Falcon of this name.

    Args:
        name: of the device.
        line: what a loop gets of its `Crew`, where a guard watches: for a simulated
            Falcon the way to its process, whose owner it becomes.

    Raises:
        UsageError: when it is no Falcon's.
    """
    kind, _, serial = name.partition(":")
    if kind == "falcon":
        return Reach(opening(line, serial), find_image)
    if name == "falcon-simulated":
        return _simulated() if line == NO_LINE else _simulated_elsewhere(line)
    raise UsageError(f"{name!r} is no Falcon; use falcon, or falcon:SERIAL")


def _simulated_elsewhere(line: int) -> Reach:
    from hapticplayer.devices.falcon.simulated_usb import remote
    from hapticplayer.devices.falcon.simulated_usb.board import synthetic_image

    return Reach(remote.opening(line), synthetic_image)


def _simulated() -> Reach:
    from hapticplayer.devices.falcon.simulated_usb import Stage
    from hapticplayer.devices.falcon.simulated_usb.board import synthetic_image
    from hapticplayer.devices.falcon.simulated_usb.mechanics import Homing
    from hapticplayer.devices.falcon.simulated_usb.whole import make_set

    bus = make_set(stage=Stage.DARK, homing=Homing()).bus
    return Reach(lambda: open_falcon(backend=bus), synthetic_image)
