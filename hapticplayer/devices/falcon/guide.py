"""Set-up page of the Falcon."""

from collections.abc import Iterable
from pathlib import Path

from hapticplayer.devices.checks import Check, usable
from hapticplayer.devices.falcon import firmware
from hapticplayer.devices.falcon.transport import list_falcons
from hapticplayer.devices.falcon.usbfs import NODE
from hapticplayer.devices.guides import Guide
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import HapticPlayerError, Message, message_of
from hapticplayer.shipped import UDEV_RULE

_RULE = Message(
    "Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the device and plug it "
    "in.",
    rule=UDEV_RULE,
)


def _falcon(options: DeviceOptions) -> Iterable[Check]:
    remedy = Message("Connect its power supply and its USB cable.")
    found = [
        one
        for one in list_falcons()
        if options.address in ("", one.serial) or not one.serial
    ]
    yield Check(Message("Falcon on USB"), bool(found), remedy)
    for one in found[:1]:
        node = Path(NODE.format(one.bus, one.address))
        if node.exists():  # on Linux
            yield usable(str(node), _RULE)
    try:
        firmware.find_image()
    except HapticPlayerError as problem:
        yield Check(Message("Firmware"), False, message_of(problem))
    else:
        yield Check(Message("Firmware"), True)


FALCON = Guide(
    Message("Novint Falcon: its grip pushes and pulls in three directions."),
    Message("Connect its USB cable and power supply; it is detected automatically."),
    hold=Message("Hold the grip loosely."),
    checks=_falcon,
    tells_latency=True,
)
