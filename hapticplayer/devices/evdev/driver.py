"""Wheels and rumbling pads of Linux as haptic devices."""

from collections.abc import Callable

from hapticplayer.devices.capabilities import RUMBLE
from hapticplayer.devices.evdev.effects import (
    FF_CONSTANT,
    FF_RUMBLE,
    REFRESH_S,
    ConstantForceTranslator,
    RumbleTranslator,
)
from hapticplayer.devices.evdev.options import capabilities_of, parse
from hapticplayer.devices.evdev.ports import EventPort, GainPort, open_first
from hapticplayer.devices.paced import PacedDriver, silencer


def _wheel(text: str, kind: type[EventPort]) -> EventPort:
    chosen = parse(text)
    return open_first(
        FF_CONSTANT,
        chosen.node,
        lambda: ConstantForceTranslator(chosen.axis, chosen.full_n),
        kind,
    )


def make_wheel(_line: int, options: str = "") -> PacedDriver:
    """Return the driver of a wheel or joystick with a motor; raises DeviceError."""
    record = capabilities_of(options)
    return PacedDriver("wheel", record, lambda: _wheel(options, EventPort), REFRESH_S)


def silence_wheel(_line: int, options: str = "") -> Callable[[], bool]:
    """Return what takes a wheel's gain away, for the guard."""
    return silencer(lambda: _wheel(options, GainPort))


def make_rumble(_line: int, node: str = "") -> PacedDriver:
    """Return the driver of a pad that the kernel can rumble."""
    return PacedDriver(
        "rumble",
        RUMBLE,
        lambda: open_first(FF_RUMBLE, node, RumbleTranslator, EventPort),
        REFRESH_S,
    )


def silence_rumble(_line: int, node: str = "") -> Callable[[], bool]:
    """Return what takes a pad's gain away, for the guard."""
    return silencer(lambda: open_first(FF_RUMBLE, node, RumbleTranslator, GainPort))
