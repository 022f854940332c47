"""A simulated Falcon for tools that speak to the device themselves."""

from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.silence import NO_LINE
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.simulation.usb import Stage, remote
from hapticplayer.simulation.usb.board import synthetic_image
from hapticplayer.simulation.usb.mechanics import Homing
from hapticplayer.simulation.usb.whole import make_set


def simulated(line: int, _serial: str) -> Reach:
    """Return how to get at one: at the other end of a line, or made here and now."""
    if line != NO_LINE:
        return Reach(remote.opening(line), synthetic_image)
    bus = make_set(stage=Stage.DARK, homing=Homing()).bus
    return Reach(lambda: open_falcon(backend=bus), synthetic_image)
