"""Haptic devices behind one protocol: open, exchange at 1 kHz, close.

A driver is loaded by the process that makes the device, and by no other. Extensions add
devices (docs/devices.md).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Protocol, runtime_checkable

from hapticplayer.devices.capabilities import FALCON, SIMULATED
from hapticplayer.devices.options import DeviceOptions, divided
from hapticplayer.errors import DeviceError, Message, joined
from hapticplayer.extension import load, rows
from hapticplayer.model.device import DeviceCapabilities, DeviceReading, Signal, Vector

NO_DEVICE = "none"
FAULTS = "hapticplayer.extras.faults"
"""Package of the faults that developers can inject into what has a `server`."""
_RELEASE_S, _OWN_LOOP_RELEASE_S = 2.0, 4.0


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
        name: for command lines and files; with what was chosen after a colon.
        label: short, for lists.
        title: a line about it.
        capabilities: what it can do, with what was chosen.
        driver: called with a descriptor, and where there are `options` with those,
            returns the `HapticDevice`, not yet open.
        silencer: called by the guard as `driver` is, returns what writes one zero
            command; False from it means that there is nothing left to silence.
        options: called with what follows the name and a colon, returns
            `DeviceOptions`; raises DeviceError for what is not allowed, with what is.
            "" where nothing but `gain=` can follow, which all devices take.
        guide: its set-up page, a `guides.Guide`; "" for one made of what is here.
        server: module that is run as a process of its own and takes injected faults;
            loop and guard both hold the other end of its line. "" for real hardware:
            then they hold the two ends of one line, along which the loop may pass what
            the guard needs.
        direct: called with the line of a loop, or -1 for none, and what was chosen,
            returns how tools reach a Falcon without the haptics process.
        loop: class of the loop in the device's process, whose `guard` makes its guard;
            "" for the 1 kHz loop and the guard that writes zero.
        patience_s: longest time that opening it may take.
        is_for_developers: whether windows leave it out.
    """

    name: str
    label: Message
    title: str
    capabilities: DeviceCapabilities
    driver: str
    silencer: str = ""
    options: str = ""
    guide: str = ""
    server: str = ""
    direct: str = ""
    loop: str = ""
    patience_s: float = 10.0
    is_for_developers: bool = False

    @property
    def chosen(self) -> str:
        """What follows the name and a colon, but for what all devices take."""
        return divided(self.name)[0]

    @property
    def takes_motion(self) -> bool:
        """Whether it is sent the motion of the recording and no force."""
        return self.capabilities.signal is Signal.MOTION

    @property
    def settings(self) -> DeviceOptions:
        """What was chosen, with all that follows from it; raises DeviceError."""
        return _parsed(self.options, self.capabilities, self.name)

    @property
    def release_s(self) -> float:
        """Longest time that bringing it to rest may take."""
        return _OWN_LOOP_RELEASE_S if self.loop else _RELEASE_S

    def make(self, descriptor: int) -> HapticDevice:
        """The device, not yet open."""
        made: HapticDevice = load(self.driver)(*self._arguments(descriptor))
        return made

    def silence(self, descriptor: int) -> Callable[[], bool]:
        """What writes one zero command."""
        silencer: Callable[[], bool] = load(self.silencer)(*self._arguments(descriptor))
        return silencer

    def _arguments(self, descriptor: int) -> tuple[Any, ...]:
        return (descriptor, self.settings) if self.options else (descriptor,)


@cache
def _parsed(options: str, record: DeviceCapabilities, name: str) -> DeviceOptions:
    own, shared = divided(name)
    found: DeviceOptions = load(options)(own) if options else DeviceOptions(record)
    return replace(found, **shared)


_SIMULATION = "hapticplayer.simulation"
_BUILT_IN = (
    DeviceEntry(
        "simulated",
        Message("Simulated"),
        "simulated Falcon, held by a relaxed hand",
        SIMULATED,
        f"{_SIMULATION}.falcon.remote:RemoteFalcon",
        f"{_SIMULATION}.falcon.remote:silence",
        server=f"{_SIMULATION}.falcon",
        guide="hapticplayer.devices.guides:SIMULATED",
    ),
    DeviceEntry(
        "falcon",
        Message("Falcon"),
        "Novint Falcon on USB",
        FALCON,
        "hapticplayer.devices.falcon.driver:make",
        "hapticplayer.devices.falcon.silence:silence",
        direct="hapticplayer.devices.falcon.reach:real",
        options="hapticplayer.devices.falcon:falcon_options",
        patience_s=45.0,  # ten uploads, should the first nine fail
        guide="hapticplayer.devices.falcon.guide:FALCON",
    ),
)
DEVICES: dict[str, DeviceEntry] = {entry.name: entry for entry in _BUILT_IN}
"""Those of the core; `installed_devices` has also those of extensions."""


@cache
def installed_devices() -> dict[str, DeviceEntry]:
    """All devices by name, ours first. The window asks 30 times a second."""
    return {one.name: one for one in rows("devices", DeviceEntry, DEVICES.values())}


def device_names() -> list[str]:
    """The names for `--device`: all devices, and none."""
    return [*installed_devices(), NO_DEVICE]


def takes_motion(name: str) -> bool:
    """Whether a device is sent the motion of the recording, whatever was chosen of it."""
    entry = installed_devices().get(name.partition(":")[0])
    return entry is not None and entry.takes_motion


def find_device(name: str) -> DeviceEntry:
    """The device of that name, or of name:options.

    Raises:
        DeviceError: for others, and for options that are not allowed.
    """
    kind, _, chosen = name.partition(":")
    known = rows("devices", DeviceEntry, DEVICES.values())  # asks no package for ours
    entry = next((one for one in known if one.name == kind), None)
    if entry is None:
        raise DeviceError(
            "device {name!r}: this version has no driver for it; use {known}",
            name=name,
            known=joined(Message(" or "), installed_devices()),
        )
    if not chosen:
        return entry
    entry = replace(entry, name=name)
    if entry.chosen and not entry.options:
        raise DeviceError(
            "device {name!r}: nothing but gain= can follow; use {kind}",
            name=name,
            kind=kind,
        )
    return replace(entry, capabilities=entry.settings.capabilities)
