"""Set-up pages of wheels and pads."""

from collections.abc import Iterable

from hapticplayer.devices.checks import Check, on_linux, usable
from hapticplayer.devices.guides import Guide
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import Message
from hapticplayer.extras.wheels.effects import FF_CONSTANT, FF_RUMBLE
from hapticplayer.extras.wheels.ports import DEVICES, list_devices


def _event(node: str, effect: int, kind: Message) -> Iterable[Check]:
    yield from on_linux()
    found = [one for one in list_devices(effect) if node in ("", one.node)]
    title = found[0].title if found else kind
    yield Check(
        Message(title),
        bool(found),
        Message(
            "Connect it; if it is connected, its driver is missing or has no such force "
            "feedback."
        ),
    )
    group = Message("Add yourself to the group input, log out and log in again.")
    for one in found[:1]:
        yield usable(str(DEVICES / one.node), group)


def _wheel(options: DeviceOptions) -> Iterable[Check]:
    return _event(
        options.address, FF_CONSTANT, Message("Wheel or joystick with a motor")
    )


def _rumble(options: DeviceOptions) -> Iterable[Check]:
    return _event(options.address, FF_RUMBLE, Message("Game pad that Linux can rumble"))


WHEEL = Guide(
    Message(
        "Wheel or joystick with a motor: it exerts one axis of the force, by default "
        "sideways."
    ),
    Message(
        "Connect its USB cable and its power supply. The settings choose another axis, or "
        "reverse the direction."
    ),
    hold=Message("Hold it with both hands."),
    checks=_wheel,
    example="event5,axis=x,sign=-",
)
RUMBLE = Guide(
    Message(
        "Game pad that Linux can rumble: its vibration follows the strength of the force, "
        "not its direction."
    ),
    Message("Connect it by cable or by Bluetooth."),
    checks=_rumble,
    example="event5",
)
