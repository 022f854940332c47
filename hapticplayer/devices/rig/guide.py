"""Set-up page of a motion rig."""

from collections.abc import Iterable

from hapticplayer.devices.checks import Check, receiver
from hapticplayer.devices.guides import Guide
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.devices.rig.packets import FORMATS
from hapticplayer.devices.rig.settings import LOOPBACK
from hapticplayer.errors import Message


def _rig(options: DeviceOptions) -> Iterable[Check]:
    yield receiver(options.address, Message("Start the rig's software."))


RIG = Guide(
    Message(
        "Software of a motion rig: it gets the motion of the recording by UDP, as from a "
        "game."
    ),
    Message(
        "Choose this game in the rig's software. Packets stay on this computer unless you "
        "enter another address."
    ),
    checks=_rig,
    variants={name: f"{LOOPBACK}:{kind.port}" for name, kind in FORMATS.items()},
)
