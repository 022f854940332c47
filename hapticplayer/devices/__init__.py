"""Haptic devices behind one protocol: open, exchange at 1 kHz, close."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from hapticplayer.devices.simulated import FALCON, RemoteFalcon, silence
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceCapabilities, DeviceReading, Vector

NO_HANDLE = -1


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
        """Command a force and return the newest answer; never waits for one.

        Raises:
            DeviceError: when the device is gone. Late and malformed answers are
                no errors: the reading tells.
        """
        ...

    def close(self) -> None:
        """Let go of the device; the force has been zero before."""
        ...


@dataclass(frozen=True, slots=True)
class DeviceEntry:
    """A device that can be chosen by name.

    Attributes:
        name: for command lines and files.
        title: for people.
        capabilities: what it can do.
        make: returns the device, not yet open, for a descriptor on which it can be
            reached (NO_HANDLE where it finds the hardware itself).
        silence: returns what writes one zero command over the same descriptor, for
            the guard; False from it means that there is nothing left to silence.
        server: module that is run as a process of its own at the other end of the
            descriptor; "" for real hardware.
    """

    name: str
    title: str
    capabilities: DeviceCapabilities
    make: Callable[[int], HapticDevice]
    silence: Callable[[int], Callable[[], bool]]
    server: str = ""


DEVICES: dict[str, DeviceEntry] = {
    "simulated": DeviceEntry(
        "simulated",
        "simulated Falcon, held by a relaxed hand",
        FALCON,
        RemoteFalcon,
        silence,
        server="hapticplayer.devices.simulated",
    ),
}


def find_device(name: str) -> DeviceEntry:
    """Return the device of that name.

    Raises:
        DeviceError: when this version has no driver for it.
    """
    if name not in DEVICES:
        raise DeviceError(
            f"device {name!r}: this version has no driver for it; "
            f"use {' or '.join(DEVICES)}"
        )
    return DEVICES[name]
