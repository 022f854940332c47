"""What is chosen with a wheel: `wheel:event5,axis=y,full=3,sign=-`."""

import math
from dataclasses import dataclass, replace

from hapticplayer.devices.capabilities import WHEEL
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceCapabilities

AXES = "xyz"
_LEAST_FULL_N, _MOST_FULL_N = 0.5, 20.0


@dataclass(frozen=True, slots=True)
class WheelOptions:
    """What the user has chosen.

    Attributes:
        node: name under /dev/input; "" for the first that fits.
        axis: 0, 1, 2 for x, y, z of frame D: which part of the force it exerts.
        full_n: force of the track at which the wheel does all it can; negative turns
            its direction round.
    """

    node: str = ""
    axis: int = 0
    full_n: float = WHEEL.peak_force_n


def parse(text: str) -> WheelOptions:
    """Return what follows "wheel:"; raises DeviceError for what makes no sense."""
    node, sign, full_n, axis = "", 1.0, WHEEL.peak_force_n, 0
    for part in filter(None, text.split(",")):
        key, equals, value = part.partition("=")
        if not equals and not node:
            node = key
        elif key == "axis" and len(value) == 1 and value in AXES:
            axis = AXES.index(value)
        elif key == "full":
            full_n = _newtons(part, value)
        elif key == "sign" and value in ("+", "-"):
            sign = -1.0 if value == "-" else 1.0
        else:
            raise _unknown(part)
    return WheelOptions(node, axis, sign * full_n)


def capabilities_of(text: str) -> DeviceCapabilities:
    """Return the record of a wheel with its options; raises DeviceError."""
    return replace(WHEEL, first_axis=parse(text).axis)


def _newtons(part: str, value: str) -> float:
    try:
        full_n = float(value)
    except ValueError:
        raise _unknown(part) from None
    if not math.isfinite(full_n) or not _LEAST_FULL_N <= full_n <= _MOST_FULL_N:
        raise _unknown(part)
    return full_n


def _unknown(part: str) -> DeviceError:
    return DeviceError(
        "device option {part!r}: not known; use event5 (a name in /dev/input), "
        "axis=x, y or z, full=N (0.5 to 20 newtons of the track), sign=+ or -",
        part=part,
    )
