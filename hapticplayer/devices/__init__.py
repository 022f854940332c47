"""Haptic devices behind one protocol: open, exchange at 1 kHz, close.

A driver is loaded by the process that makes the device, and by no other. Extensions add
devices (docs/devices.md).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Protocol, runtime_checkable

from hapticplayer.devices.capabilities import (
    BUTTPLUG,
    FALCON,
    INVERSE3,
    RIG,
    RUMBLE,
    SHAKER,
    SIMULATED,
    TCODE,
    WHEEL,
)
from hapticplayer.errors import DeviceError, Message, joined
from hapticplayer.extension import load, rows
from hapticplayer.model.device import DeviceCapabilities, DeviceReading, Vector

NO_DEVICE = "none"
UDEV_RULE = "packaging/udev/70-novint-falcon.rules"


class HapticDevice(Protocol):
    """Something that exerts a force on a hand and measures where it is.

    All vectors are in frame D: x right, y up, z towards the user.
    """

    name: str
    capabilities: DeviceCapabilities

    def open(self) -> None:
        """Connect; raises DeviceError with what to do."""

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Command a force and return the newest answer; never waits for one.

        Raises:
            DeviceError: when the device is gone. Late and malformed answers are
                no errors: the reading shows them.
        """

    def close(self) -> None:
        """Let go of the device; the force has been zero before."""


@runtime_checkable
class DelayedDevice(Protocol):
    """A device that acts so much later that a stop must not wait for it."""

    def forget(self) -> None:
        """Drop the commands that have not acted yet; called at a stop, never waits."""


@dataclass(frozen=True, slots=True)
class DeviceEntry:
    """A device that can be chosen by name. Functions are named "module:function".

    Attributes:
        name: for command lines and files.
        label: short, for lists.
        title: a line about it.
        capabilities: what it can do.
        driver: called with a descriptor, and with a serial number where there may be
            several, returns the `HapticDevice`, not yet open.
        silencer: called by the guard with what `driver` is called with, returns what
            writes one zero command; False from it means that there is nothing left to
            silence.
        server: module that is run as a process of its own; loop and guard both hold
            the other end of its line. "" for real hardware: then they hold the two
            ends of one line, along which the loop may pass what the guard needs.
        faults: module of the faults that developers can inject; "" for none.
        direct: called with the line of a loop, or -1 for none, returns how tools
            reach a Falcon without the haptics process (`falcon.reach`).
        has_serials: whether it can be chosen as `name:serial`.
        is_for_developers: whether windows leave it out.
        patience_s: longest time that opening it may take.
        release_s: longest time that bringing it to rest may take.
        settings: called with what follows the name and a colon, in place of a serial
            number; raises DeviceError for what is not allowed.
        loop: class of the loop in the device's process; "" for the 1 kHz loop.
        fades_alone: whether it falls silent by itself when its loop stands still, so
            that the guard writes zero only after the loop's end.
        guard: what makes the loop's guard; "" for the one that writes zero.
        keeps_latency: whether its driver keeps the latency of its settings, by the
            device's own clock.
        guide: its set-up page, a `guides.Guide`; "" for one made of what is here.
        record: called with what follows `name:`, returns the capabilities with these
            options, or raises DeviceError; "" where they are always the same.
        serial: the one that was chosen, or its options.
    """

    name: str
    label: Message
    title: str
    capabilities: DeviceCapabilities
    driver: str
    silencer: str
    server: str = ""
    faults: str = ""
    direct: str = ""
    has_serials: bool = False
    is_for_developers: bool = False
    patience_s: float = 10.0
    release_s: float = 2.0
    record: str = ""
    serial: str = ""
    settings: str = ""
    loop: str = ""
    guard: str = ""
    guide: str = ""
    fades_alone: bool = False
    keeps_latency: bool = False

    def make(self, descriptor: int) -> HapticDevice:
        """Return the device, not yet open."""
        made: HapticDevice = load(self.driver)(*self._chosen(descriptor))
        return made

    def silence(self, descriptor: int) -> Callable[[], bool]:
        """Return what writes one zero command."""
        silencer: Callable[[], bool] = load(self.silencer)(*self._chosen(descriptor))
        return silencer

    def _chosen(self, descriptor: int) -> tuple[int] | tuple[int, str]:
        return (descriptor, self.serial) if self.serial else (descriptor,)


_SIMULATION = "hapticplayer.simulation"
_GUIDES = "hapticplayer.devices.guides"
_BUILT_IN = (
    DeviceEntry(
        "simulated",
        Message("Simulated"),
        "simulated Falcon, held by a relaxed hand",
        SIMULATED,
        f"{_SIMULATION}.falcon.remote:RemoteFalcon",
        f"{_SIMULATION}.falcon.remote:silence",
        server=f"{_SIMULATION}.falcon",
        faults=f"{_SIMULATION}.faults",
        guide=f"{_GUIDES}:SIMULATED",
    ),
    DeviceEntry(
        "falcon",
        Message("Falcon"),
        "Novint Falcon on USB",
        FALCON,
        "hapticplayer.devices.falcon.driver:make",
        "hapticplayer.devices.falcon.silence:silence",
        direct="hapticplayer.devices.falcon.reach:real",
        has_serials=True,
        patience_s=45.0,  # ten uploads, should the first nine fail
        guide=f"{_GUIDES}:FALCON",
    ),
    DeviceEntry(
        "falcon-simulated",
        Message("Falcon on simulated USB"),
        "the Falcon's own driver on simulated USB, for developers",
        FALCON,
        f"{_SIMULATION}.usb.driver:make",
        f"{_SIMULATION}.usb.remote:silence",
        server=f"{_SIMULATION}.usb",
        faults=f"{_SIMULATION}.faults",
        direct=f"{_SIMULATION}.usb.driver:simulated",
        is_for_developers=True,
        patience_s=45.0,
    ),
    DeviceEntry(
        "inverse3",
        Message("Inverse3"),
        "Haply Inverse3 through the Inverse Service of this machine",
        INVERSE3,
        "hapticplayer.devices.inverse3.driver:make",
        "hapticplayer.devices.inverse3.driver:silence",
        has_serials=True,
        guide=f"{_GUIDES}:INVERSE3",
    ),
    DeviceEntry(
        "inverse3-simulated",
        Message("Inverse3 on a simulated service"),
        "the Inverse3's own driver on a simulated service, for developers",
        INVERSE3,
        f"{_SIMULATION}.inverse3.driver:make",
        f"{_SIMULATION}.falcon.remote:silence",
        server=f"{_SIMULATION}.inverse3",
        faults=f"{_SIMULATION}.faults",
        is_for_developers=True,
    ),
    DeviceEntry(
        "wheel",
        Message("Wheel"),
        "wheel or joystick with a motor (Linux): one axis, no newtons",
        WHEEL,
        "hapticplayer.devices.evdev.driver:make_wheel",
        "hapticplayer.devices.evdev.driver:silence_wheel",
        has_serials=True,
        record="hapticplayer.devices.evdev.options:capabilities_of",
        guide=f"{_GUIDES}:WHEEL",
    ),
    DeviceEntry(
        "rumble",
        Message("Rumble"),
        "game pad or joystick that the kernel can rumble (Linux): vibration only",
        RUMBLE,
        "hapticplayer.devices.evdev.driver:make_rumble",
        "hapticplayer.devices.evdev.driver:silence_rumble",
        has_serials=True,
        guide=f"{_GUIDES}:RUMBLE",
    ),
    DeviceEntry(
        "shaker",
        Message("Shaker"),
        "bass shakers and voice coils on a sound card",
        SHAKER,
        "hapticplayer.devices.transducer.driver:make",
        "hapticplayer.devices.transducer.silence:silence",
        settings="hapticplayer.devices.transducer.settings:shaker_settings",
        guide=f"{_GUIDES}:SHAKER",
        fades_alone=True,
        keeps_latency=True,
    ),
    DeviceEntry(
        "buttplug",
        Message("Intiface"),
        "toys through Intiface (Buttplug): vibration only",
        BUTTPLUG,
        "hapticplayer.devices.buttplug:make",
        "hapticplayer.devices.buttplug:silence",
        has_serials=True,
        guide=f"{_GUIDES}:BUTTPLUG",
    ),
    DeviceEntry(
        "tcode",
        Message("TCode"),
        "a board that takes TCode by UDP or a serial port: vibration only",
        TCODE,
        "hapticplayer.devices.tcode:make",
        "hapticplayer.devices.tcode:silence",
        has_serials=True,
        guide=f"{_GUIDES}:TCODE",
    ),
)
DEVICES: dict[str, DeviceEntry] = {entry.name: entry for entry in _BUILT_IN}
"""Those of the core; `installed_devices` has also those of extensions."""

_RIG = "hapticplayer.haptics.rig"
OUTLETS: dict[str, DeviceEntry] = {
    "rig": DeviceEntry(
        "rig",
        Message("Motion rig"),
        "software of a motion rig, spoken to as a game does by UDP",
        RIG,
        "hapticplayer.devices.rig.sender:make",
        "",
        release_s=4.0,
        settings="hapticplayer.devices.rig.settings:rig_settings",
        loop=f"{_RIG}.loop:RigLoop",
        guard=f"{_RIG}.guard:make",
        guide=f"{_GUIDES}:RIG",
    )
}
"""What plays beside a device, or without one, and takes no force."""


@cache
def installed_devices() -> dict[str, DeviceEntry]:
    """All devices by name, ours first. The window asks 30 times a second."""
    return {one.name: one for one in rows("devices", DeviceEntry, DEVICES.values())}


def device_names() -> list[str]:
    """Return what `--device` takes: all devices, and none."""
    return [*installed_devices(), NO_DEVICE]


def find_device(name: str) -> DeviceEntry:
    """Return the device or outlet of that name, or name:serial, or name:settings.

    Raises:
        DeviceError: for others.
    """
    kind, _, serial = name.partition(":")
    ours = (*DEVICES.values(), *OUTLETS.values())
    known = rows("devices", DeviceEntry, ours)  # asks no package for one of ours
    entry = next((one for one in known if one.name == kind), None)
    if entry is not None and entry.settings:
        load(entry.settings)(serial)  # refuses what is not allowed
    elif entry is None or (serial and not entry.has_serials):
        raise DeviceError(
            "device {name!r}: this version has no driver for it; use {known}",
            name=name,
            known=joined(Message(" or "), installed_devices()),
        )
    if not serial:
        return entry
    record = load(entry.record)(serial) if entry.record else entry.capabilities
    return replace(entry, name=name, serial=serial, capabilities=record)


def settings_of(entry: DeviceEntry) -> Any:
    """Return what was chosen of an entry that has settings, else None."""
    return load(entry.settings)(entry.serial) if entry.settings else None
