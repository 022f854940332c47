"""Haptic devices behind one protocol: open, exchange at 1 kHz, close."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from hapticplayer.devices.simulated.point_mass import SimulatedFalcon
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceCapabilities, DeviceReading, Vector


class HapticDevice(Protocol):
    """Something that pushes a hand and knows where it is.

    All vectors are in frame D: x right, y up, z towards the user.
    """

    name: str
    capabilities: DeviceCapabilities

    def open(self) -> None:
        """Connect; raises DeviceError with what to do."""
        ...

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Command a force and return what the device answers, at 1 kHz."""
        ...

    def close(self) -> None:
        """Let go of the device; the force has been zero before."""
        ...


@dataclass(frozen=True, slots=True)
class DeviceEntry:
    """A device that can be chosen by name."""

    name: str
    title: str
    make: Callable[[], HapticDevice]


DEVICES: dict[str, DeviceEntry] = {
    "simulated": DeviceEntry(
        "simulated", "simulated Falcon, held by a relaxed hand", SimulatedFalcon
    ),
}


def make_device(name: str) -> HapticDevice:
    """Return the device of that name, not yet open.

    Raises:
        DeviceError: when this version has no driver for it.
    """
    if name not in DEVICES:
        raise DeviceError(
            f"device {name!r}: this version has no driver for it; "
            f"use {' or '.join(DEVICES)}"
        )
    return DEVICES[name].make()
