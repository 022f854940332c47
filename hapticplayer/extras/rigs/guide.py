"""Set-up page of a motion rig."""

from collections.abc import Iterable

from hapticplayer.devices.checks import Check, receiver
from hapticplayer.devices.guides import Guide
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import Message
from hapticplayer.extras.rigs.packets import FORMATS
from hapticplayer.extras.rigs.settings import LOOPBACK


def _rig(options: DeviceOptions) -> Iterable[Check]:
    yield receiver(options.address, Message("Start the rig's software."))


RIG = Guide(
    Message(
        "Motion-rig software: receives the motion of the recording over UDP, as from a "
        "game."
    ),
    Message(
        "Choose this game in the rig's software. Packets stay on this computer unless you "
        "enter another address."
    ),
    checks=_rig,
    variants={
        name: (kind.title, f"{LOOPBACK}:{kind.port}") for name, kind in FORMATS.items()
    },
)
