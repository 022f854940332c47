"""Wheels and rumbling pads of Linux as haptic devices."""

from collections.abc import Callable

from hapticplayer.devices.options import DeviceOptions
from hapticplayer.devices.paced import PacedDriver, silencer
from hapticplayer.extras.wheels.effects import (
    FF_CONSTANT,
    FF_RUMBLE,
    REFRESH_S,
    ConstantForceTranslator,
    RumbleTranslator,
)
from hapticplayer.extras.wheels.options import WheelOptions
from hapticplayer.extras.wheels.ports import EventPort, GainPort, open_first


def _wheel(chosen: WheelOptions, kind: type[EventPort]) -> EventPort:
    return open_first(
        FF_CONSTANT,
        chosen.address,
        lambda: ConstantForceTranslator(chosen.axis, chosen.sign * chosen.full_n),
        kind,
    )


def _pad(chosen: DeviceOptions, kind: type[EventPort]) -> EventPort:
    return open_first(FF_RUMBLE, chosen.address, RumbleTranslator, kind)


def make_wheel(_line: int, options: WheelOptions) -> PacedDriver:
    record = options.capabilities
    return PacedDriver("wheel", record, lambda: _wheel(options, EventPort), REFRESH_S)


def silence_wheel(_line: int, options: WheelOptions) -> Callable[[], bool]:
    """What takes a wheel's gain away, for the guard."""
    return silencer(lambda: _wheel(options, GainPort))


def make_rumble(_line: int, options: DeviceOptions) -> PacedDriver:
    record = options.capabilities
    return PacedDriver("rumble", record, lambda: _pad(options, EventPort), REFRESH_S)


def silence_rumble(_line: int, options: DeviceOptions) -> Callable[[], bool]:
    """What takes a pad's gain away, for the guard."""
    return silencer(lambda: _pad(options, GainPort))
