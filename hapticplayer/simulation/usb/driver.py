"""The real driver on the simulated USB: for the loop, and for tools that go past it."""

from typing import Any

from hapticplayer.devices.falcon.driver import DEFAULTS, FalconDriver, Options
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.silence import NO_LINE
from hapticplayer.devices.falcon.transport import OpenTransport, Transport, open_falcon
from hapticplayer.simulation.usb import Stage
from hapticplayer.simulation.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.simulation.usb.board import synthetic_image
from hapticplayer.simulation.usb.mechanics import Homing
from hapticplayer.simulation.usb.remote import RemoteChip
from hapticplayer.simulation.usb.whole import make_set


def opening(descriptor: int) -> OpenTransport:
    """Return what opens the Falcon at the other end of a descriptor, which it takes."""
    bus: list[Any] = []

    def open_transport() -> Transport:
        if not bus:
            port = SimulatedPort(RemoteChip(descriptor))
            bus.append(SimulatedBus([port]))
        return open_falcon(backend=bus[0])

    return open_transport


def make(descriptor: int, options: Options = DEFAULTS) -> FalconDriver:
    """Return the real driver for the Falcon at the other end of a descriptor."""
    return FalconDriver(opening(descriptor), image=synthetic_image, options=options)


def simulated(line: int, _serial: str) -> Reach:
    """Return how to get at one: at the other end of a line, or made here and now."""
    if line != NO_LINE:
        return Reach(opening(line), synthetic_image)
    bus = make_set(stage=Stage.DARK, homing=Homing()).bus
    return Reach(lambda: open_falcon(backend=bus), synthetic_image)
