"""How late frames, sound and force reach a person, beyond what the machine knows of.

A television that processes its frames, wireless headphones and a device on a slow link
all come late, and no interface tells by how much. A person measures it once
(`app.player.latency_page`), the window keeps it in its settings, and whatever comes later
than the others is begun earlier.
"""

import enum
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.devices.options import with_gain
from hapticplayer.errors import InputError, UsageError
from hapticplayer.model.ranges import finite_number
from hapticplayer.storage import config_home
from hapticplayer.structures import read_json

MOST_S = 1.0
LARGE_S = 0.200
"""A sound output that reports more than this is wireless: 120 ms are our own buffer, and
a sound server adds 20 ms (141 ms were measured), wireless headphones 100 to 250."""

_WIRELESS = (
    *("bluetooth", "bluez", "a2dp", "airpods", "hands-free", "handsfree"),
    *("wireless", "airplay", "chromecast"),
)


SETTINGS_NAME = "window.json"
SETTINGS_VERSION = 1

VERSION, LATENCIES = "version", "latencies"
DISPLAY, SOUND, DEVICE = "display", "sound", "device"
"""Tables within the table of the settings: milliseconds by the name of the output."""
ENTERED = "entered"
"""The same for devices whose latency nobody has measured: what a person has entered."""

MOST_NAMES = 64
_MAX_BYTES = 1 << 20


@dataclass(frozen=True, slots=True)
class Latency:
    """From the machine to the person, s; each from 0 to `MOST_S`.

    Attributes:
        display_s: from a painted frame to the light.
        sound_s: from the time that the sound output states to the ear.
        device_s: from a command on the wire to the hand.

    Raises:
        UsageError: when one of them is out of range.
    """

    display_s: float = 0.0
    sound_s: float = 0.0
    device_s: float = 0.0

    def __post_init__(self) -> None:
        for value in (self.display_s, self.sound_s, self.device_s):
            if not (math.isfinite(value) and 0.0 <= value <= MOST_S):
                raise UsageError(
                    "a latency of {value:g} s is not between 0 and 1 s", value=value
                )

    @property
    def lead_s(self) -> float:
        """How much earlier than the clip the first of frame and force begins."""
        return max(self.display_s, self.device_s)


class LatencySource(enum.StrEnum):
    """How a device's latency is known.

    MEASURED by a person's taps or by the age of its answers, ENTERED by a person, in its
    SETTINGS, KEPT by its driver after its own clock, or ASSUMED: typical for its kind.
    """

    MEASURED = "measured"
    ENTERED = "entered"
    SETTINGS = "settings"
    KEPT = "kept"
    ASSUMED = "assumed"


class DeviceLatency(NamedTuple):
    """From a command to what is felt, s, and how that is known."""

    latency_s: float
    source: LatencySource


@dataclass(frozen=True, slots=True)
class Latencies:
    """What was measured on this machine: the screen's, and others by output."""

    display_s: float = 0.0
    sound_s: Mapping[str, float] = field(default_factory=dict)
    device_s: Mapping[str, float] = field(default_factory=dict)
    entered_s: Mapping[str, float] = field(default_factory=dict)

    def of(self, sound: str, device: str) -> Latency:
        """Return those of the outputs in use; 0 for a sound that was not measured."""
        device_s = self.of_device(device).latency_s
        return Latency(self.display_s, self.sound_s.get(sound, 0.0), device_s)

    def of_device(self, name: str) -> "DeviceLatency":
        """Return the best that is known of a device.

        What its settings say counts first, then what was measured or entered for it, then
        what its driver keeps by the device's own clock, then what is typical.
        """
        if name in ("", NO_DEVICE):
            return DeviceLatency(self.device_s.get(name, 0.0), LatencySource.ASSUMED)
        entry = find_device(name)
        own_s = entry.settings.latency_s
        if own_s and not entry.capabilities.has_own_clock:
            return DeviceLatency(own_s, LatencySource.SETTINGS)
        for known_s, source in (
            (self.device_s, LatencySource.MEASURED),
            (self.entered_s, LatencySource.ENTERED),
        ):
            for kept in (name, with_gain(name)):
                if kept in known_s:
                    return DeviceLatency(known_s[kept], source)
        if own_s:
            return DeviceLatency(own_s, LatencySource.KEPT)
        return DeviceLatency(entry.capabilities.latency_s, LatencySource.ASSUMED)


def is_wireless(output: str) -> bool:
    return any(word in output.lower() for word in _WIRELESS)


def saved_latencies() -> Latencies:
    """Return those of all sound outputs and devices; none without settings."""
    try:
        path = config_home() / SETTINGS_NAME
    except RuntimeError:  # there is no home folder
        return Latencies()
    values = read_settings(path)
    if version_of(values) > SETTINGS_VERSION:
        return Latencies()
    table = values.get(LATENCIES)
    return latencies_in(table if isinstance(table, dict) else {})


def latencies_in(table: Mapping[str, Any], screen: str = "") -> Latencies:
    display_s = table_s(table, DISPLAY).get(screen, 0.0)
    parts_s = (table_s(table, part) for part in (SOUND, DEVICE, ENTERED))
    return Latencies(display_s, *parts_s)


def table_s(table: Mapping[str, Any], part: str) -> dict[str, float]:
    """Return the valid values of one part, s: people may edit the file."""
    found = table.get(part)
    values = list(found.items())[:MOST_NAMES] if isinstance(found, dict) else []
    found_ms = ((name, finite_number(value)) for name, value in values)
    return {
        name: 1e-3 * ms
        for name, ms in found_ms
        if ms is not None and 0.0 <= ms <= 1e3 * MOST_S
    }


def read_settings(path: Path) -> dict[str, Any]:
    """Return the window's settings; none of a file that is not valid."""
    try:
        return read_json(path, dict[str, Any], most_bytes=_MAX_BYTES)
    except InputError:
        return {}


def version_of(values: Mapping[str, Any]) -> float:
    version = values.get(VERSION, SETTINGS_VERSION)
    return version if isinstance(version, int) else math.inf
