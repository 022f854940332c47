"""What is chosen with a wheel or pad: `wheel:event5,axis=y,full=3,sign=-`."""

import re
from dataclasses import dataclass, replace

from hapticplayer.devices.options import (
    DeviceOptions,
    Fields,
    Parse,
    fields_of,
    one_of,
)
from hapticplayer.errors import DeviceError
from hapticplayer.extras.wheels.extension import RUMBLE, WHEEL
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.ranges import Range

AXES = "xyz"
FULL_N = Range(0.5, 20.0, "N")
_SIGNS = {"+": 1.0, "-": -1.0}


@dataclass(frozen=True, slots=True)
class WheelOptions(DeviceOptions):
    """Which wheel, and how it is moved.

    Attributes:
        address: name under /dev/input; "" for the first that fits.
        axis: 0, 1, 2 for x, y, z of frame D: which part of the force it exerts.
        full_n: force of the track at which the wheel does all it can.
        sign: -1 reverses the direction.
    """

    capabilities: DeviceCapabilities = WHEEL
    axis: int = 0
    full_n: float = WHEEL.peak_force_n
    sign: float = 1.0


def wheel_options(text: str) -> WheelOptions:
    """What follows "wheel:"; raises DeviceError."""
    found = WheelOptions(**fields_of("wheel", text, _node, _OPTIONS))
    return replace(found, capabilities=replace(WHEEL, first_axis=found.axis))


def rumble_options(text: str) -> DeviceOptions:
    """What follows "rumble:"; raises DeviceError."""
    return DeviceOptions(RUMBLE, **fields_of("rumble", text, _node, {}))


def _node(part: str) -> Fields:
    if not re.fullmatch(r"event\d+", part):
        raise DeviceError("use a name in /dev/input, such as event5")
    return {"address": part}


_OPTIONS: dict[str, tuple[str, Parse]] = {
    "axis": ("axis", lambda _name, value: AXES.index(one_of(value, AXES))),
    "full": ("full_n", FULL_N.parse),
    "sign": ("sign", lambda _name, value: _SIGNS[one_of(value, _SIGNS)]),
}
