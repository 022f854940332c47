"""A Falcon by its name on the command line: `falcon`, `falcon:SERIAL`, or a simulated one.

For tools that speak to the device themselves: its firmware, its homing, measurements.
Playing goes through the haptics process instead.
"""

from collections.abc import Callable
from dataclasses import dataclass

from hapticplayer.clock import Clock
from hapticplayer.devices import find_device, installed_devices
from hapticplayer.devices.falcon.driver import FalconDriver, opening
from hapticplayer.devices.falcon.firmware import FirmwareImage, find_image
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.link import DirectLink, Link
from hapticplayer.devices.falcon.silence import NO_LINE
from hapticplayer.devices.falcon.transport import OpenTransport
from hapticplayer.errors import UsageError
from hapticplayer.extension import load


@dataclass(frozen=True, slots=True)
class Reach:
    """How to get at one Falcon: what finds and opens it, what returns its firmware."""

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

    `line` is what a loop gets from the owner of its processes, where a guard watches:
    for a simulated Falcon the way to its process, whose owner it becomes.
    """
    entry = installed_devices().get(name.partition(":")[0])
    if entry is None or not entry.direct:
        raise UsageError(
            "{name!r} is not a Falcon; use falcon, or falcon:SERIAL", name=name
        )
    found: Reach = load(entry.direct)(line, find_device(name).chosen)
    return found


def real(line: int, serial: str) -> Reach:
    return Reach(opening(line, serial), find_image)
