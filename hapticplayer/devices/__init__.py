"""Haptic devices behind one protocol: open, exchange at 1 kHz, close.

A driver is loaded by the process that makes the device, and by no other.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Protocol

from hapticplayer.devices.falcon.capabilities import CAPABILITIES as _FALCON
from hapticplayer.devices.gamepad.capabilities import CAPABILITIES as _GAMEPAD
from hapticplayer.devices.simulated.capabilities import FALCON
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
        make: returns the device, not yet open, for a descriptor, and for a serial
            number where there may be several.
        silence: returns what writes one zero command, for the guard, for a descriptor;
            False from it means that there is nothing left to silence.
        server: module that is run as a process of its own; loop and guard both hold
            the other end of its line. "" for real hardware: then they hold the two
            ends of one line, along which the loop may pass what the guard needs.
        has_serials: whether it can be chosen as `name:serial`.
        is_for_developers: whether windows leave it out.
        patience_s: longest time that opening it may take.
    """

    name: str
    title: str
    capabilities: DeviceCapabilities
    make: Callable[..., HapticDevice]
    silence: Callable[[int], Callable[[], bool]]
    server: str = ""
    has_serials: bool = False
    is_for_developers: bool = False
    patience_s: float = 10.0


def _simulated(descriptor: int) -> HapticDevice:
    from hapticplayer.devices.simulated.remote import RemoteFalcon

    return RemoteFalcon(descriptor)


def _silence_simulated(descriptor: int) -> Callable[[], bool]:
    from hapticplayer.devices.simulated.remote import silence

    return silence(descriptor)


def _falcon(descriptor: int, serial: str = "") -> HapticDevice:
    from hapticplayer.devices.falcon import driver

    return driver.make(descriptor, serial)


def _silence_falcon(descriptor: int) -> Callable[[], bool]:
    from hapticplayer.devices.falcon.silence import silence

    return silence(descriptor)


def _gamepad(descriptor: int) -> HapticDevice:
    from hapticplayer.devices.gamepad import driver

    return driver.make(descriptor)


def _silence_gamepad(descriptor: int) -> Callable[[], bool]:
    from hapticplayer.devices.gamepad import driver

    return driver.silence(descriptor)


def _falcon_simulated(descriptor: int) -> HapticDevice:
    from hapticplayer.devices.falcon.simulated_usb import remote

    return remote.make(descriptor)


def _silence_falcon_simulated(descriptor: int) -> Callable[[], bool]:
    from hapticplayer.devices.falcon.simulated_usb import remote

    return remote.silence(descriptor)


_ENTRIES = (
    DeviceEntry(
        "simulated",
        "simulated Falcon, held by a relaxed hand",
        FALCON,
        _simulated,
        _silence_simulated,
        server="hapticplayer.devices.simulated",
    ),
    DeviceEntry(
        "falcon",
        "Novint Falcon on USB",
        _FALCON,
        _falcon,
        _silence_falcon,
        has_serials=True,
        patience_s=45.0,  # ten uploads, should the first nine fail
    ),
    DeviceEntry(
        "falcon-simulated",
        "the Falcon's own driver on simulated USB, for developers",
        _FALCON,
        _falcon_simulated,
        _silence_falcon_simulated,
        server="hapticplayer.devices.falcon.simulated_usb",
        is_for_developers=True,
        patience_s=45.0,
    ),
    DeviceEntry(
        "gamepad",
        "DualSense or DualShock 4 on USB: vibration only",
        _GAMEPAD,
        _gamepad,
        _silence_gamepad,
    ),
)
DEVICES: dict[str, DeviceEntry] = {entry.name: entry for entry in _ENTRIES}


def find_device(name: str) -> DeviceEntry:
    """Return the device of that name, or of that name and serial number.

    Raises:
        DeviceError: when this version has no driver for it.
    """
    kind, _, serial = name.partition(":")
    entry = DEVICES.get(kind)
    if entry is None or (serial and not entry.has_serials):
        raise DeviceError(
            f"device {name!r}: this version has no driver for it; "
            f"use {' or '.join(DEVICES)}"
        )
    if serial:
        return replace(entry, name=name, make=partial(entry.make, serial=serial))
    return entry
