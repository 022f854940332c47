"""What the window remembers from one start to the next."""

import contextlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from PySide6.QtCore import QByteArray, QStandardPaths
from PySide6.QtWidgets import QWidget

from app.widgets.layout import resize_within_screen
from hapticplayer.devices import find_device
from hapticplayer.devices.options import GAIN, with_gain
from hapticplayer.errors import DeviceError, InputError
from hapticplayer.model.ranges import finite_number
from hapticplayer.playback.latency import (
    DEVICE,
    DISPLAY,
    ENTERED,
    LATENCIES,
    MOST_NAMES,
    SETTINGS_NAME,
    SETTINGS_VERSION,
    SOUND,
    VERSION,
    Latencies,
    latencies_in,
    read_settings,
    table_s,
    version_of,
)
from hapticplayer.playback.snapshot import OutputSnapshot
from hapticplayer.storage import StorageError, replace_json

_GEOMETRY = "geometry"
_OWN_PLACES = ("folder", "study_folder", "library", "recent", "positions")
THEME, LANGUAGE = "look", "language"
"""Names in the settings."""

OUTPUTS, MOST_OUTPUTS = "outputs", 16
"""Name in the settings: the outputs in order, each with what was chosen of it."""

RECORD = "record"
"""Name in the settings: camera, microphone and sensor that were used last."""

_PRIVATE = (_GEOMETRY, *_OWN_PLACES, LATENCIES, OUTPUTS, RECORD)
"""Specific to this machine, or private: never exported, nor taken from others.

An output may have an address on the network, which only its user enters.
"""

_MUTED, _GAIN = "muted", "gain"
_MOST_TEXTS, _LONGEST_TEXT = 1000, 4096


def default_path() -> Path:
    places = QStandardPaths.StandardLocation
    folder = QStandardPaths.writableLocation(places.GenericConfigLocation)
    return Path(folder) / "hapticplayer" / SETTINGS_NAME


class Settings:
    """A small JSON file of names and values; losing it costs nothing.

    A file of a newer version is left as it is, and nothing is remembered, as without a
    path.
    """

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._values = read_settings(path) if path else {}
        if version_of(self._values) > SETTINGS_VERSION:
            self._path, self._values = None, {}

    def text(self, name: str, default: str = "") -> str:
        value = self._values.get(name, default)
        return value if isinstance(value, str) else default

    def flag(self, name: str, *, default: bool) -> bool:
        """Return a yes or no that was kept."""
        value = self._values.get(name, default)
        return value if isinstance(value, bool) else default

    def number(self, name: str, default: float) -> float:
        value = finite_number(self._values.get(name))
        return default if value is None or abs(value) >= 1e9 else value

    def texts(self, name: str) -> list[str]:
        value = self._values.get(name, [])
        return _texts(value) if isinstance(value, list) else []

    def table(
        self, name: str, default: Mapping[str, Any] = MappingProxyType({})
    ) -> dict[str, Any]:
        """Return a table that was kept; what is in it is to be looked at."""
        value = self._values.get(name, default)
        return dict(value) if isinstance(value, Mapping) else {}

    def keep(self, name: str, value: Any) -> None:
        """Remember a value that JSON knows; written by `save`."""
        self._values[name] = value

    def keep_geometry(self, window: QWidget) -> None:
        """Remember where a window is and how large."""
        kept = bytes(window.saveGeometry().toBase64().data())
        self.keep(_GEOMETRY, kept.decode())

    def restore_geometry(self, window: QWidget, width_px: int, height_px: int) -> None:
        """Put a window where it was; at first as large as said, if that fits."""
        resize_within_screen(window, width_px, height_px)
        kept = self.text(_GEOMETRY)
        if kept:
            window.restoreGeometry(QByteArray.fromBase64(kept.encode()))

    def save(self) -> None:
        """Write the file; continue where that is not permitted."""
        if self._path is not None:
            with contextlib.suppress(StorageError):
                replace_json(self._path, {**self._values, VERSION: SETTINGS_VERSION})

    def export(self, path: Path) -> None:
        """Write what is worth having on another machine; raises InputError."""
        kept = {k: v for k, v in self._values.items() if k not in _PRIVATE}
        replace_json(path, {**kept, VERSION: SETTINGS_VERSION})

    def take(self, path: Path) -> None:
        """Take over what another machine exported; what is private here stays."""
        values = read_settings(path)
        if VERSION not in values:
            raise InputError(
                "holds no settings of this program",
                where=str(path),
                remedy="choose a file that was exported by it",
            )
        if version_of(values) > SETTINGS_VERSION:
            raise InputError(
                "is of a newer version of this program",
                where=str(path),
                remedy="update the program, or export again with this version",
            )
        self._values.update({k: v for k, v in values.items() if k not in _PRIVATE})


def _texts(values: list[Any]) -> list[str]:
    kept = [v for v in values if isinstance(v, str) and len(v) <= _LONGEST_TEXT]
    return kept[:_MOST_TEXTS]


LIBRARY = "library"
"""Name in the settings."""


def library_folder(settings: Settings) -> Path:
    """Return the folder of the sequences; it may not exist yet."""
    chosen = settings.text(LIBRARY)
    if chosen:
        return Path(chosen)
    documents = QStandardPaths.StandardLocation.DocumentsLocation
    return Path(QStandardPaths.writableLocation(documents)) / "hapticplayer"


def choose_library(settings: Settings, folder: Path) -> None:
    if folder != library_folder(settings):
        settings.keep(LIBRARY, str(folder))
        settings.save()


class KeptOutput(NamedTuple):
    """What a person has chosen of an output; a gain of None is that of its settings."""

    is_muted: bool = False
    gain: float | None = None


def outputs_of(settings: Settings) -> dict[str, KeptOutput]:
    """The outputs that are kept, in order.

    Those that this version has no driver for are left out. Until a person has chosen, it
    is the simulated device.
    """
    found: dict[str, KeptOutput] = {}
    kept = settings.table(OUTPUTS, {"simulated": {}})
    for name, chosen in list(kept.items())[:MOST_OUTPUTS]:
        with contextlib.suppress(DeviceError):
            find_device(name)
            if name.isprintable():
                found[name] = _kept_output(chosen)
    return found


def _kept_output(chosen: object) -> KeptOutput:
    values = chosen if isinstance(chosen, dict) else {}
    gain = finite_number(values.get(_GAIN))
    is_allowed = gain is not None and GAIN.least <= gain <= GAIN.largest
    return KeptOutput(values.get(_MUTED) is True, gain if is_allowed else None)


def keep_outputs(settings: Settings, outputs: Iterable[OutputSnapshot]) -> None:
    """Remember what plays, in order, each with its mute and gain."""
    kept = {one.name: {_MUTED: one.is_muted, _GAIN: one.gain} for one in outputs}
    settings.keep(OUTPUTS, kept)
    settings.save()


__all__ = [
    "DEVICE",
    "DISPLAY",
    "SOUND",
    "enter_latency",
    "is_known",
    "keep_latency",
    "latencies_of",
    "screen_name",
]


def screen_name(widget: QWidget) -> str:
    """Return the name of the screen that a widget is on; some have none."""
    return widget.screen().name() or "screen"


def latencies_of(settings: Settings, screen: str) -> Latencies:
    """The latencies of a screen, and of all sound outputs and devices."""
    return latencies_in(settings.table(LATENCIES), screen)


def keep_latency(settings: Settings, part: str, name: str, latency_ms: float) -> None:
    """Remember what was measured of one output; written by `Settings.save`."""
    kept, name = settings.table(LATENCIES), _key(part, name)
    known = {key: 1e3 * value for key, value in table_s(kept, part).items()}
    known.pop(name, None)
    known[name] = latency_ms
    newest = list(known.items())[-MOST_NAMES:]
    settings.keep(LATENCIES, {**kept, part: dict(newest)})


def enter_latency(settings: Settings, name: str, latency_ms: float) -> None:
    """Remember what a person has entered for a device, in place of what was measured."""
    kept = settings.table(LATENCIES)
    measured = {key: 1e3 * value for key, value in table_s(kept, DEVICE).items()}
    measured.pop(_key(DEVICE, name), None)
    settings.keep(LATENCIES, {**kept, DEVICE: measured})
    keep_latency(settings, ENTERED, name, latency_ms)


def is_known(settings: Settings, part: str, name: str) -> bool:
    """Whether the latency of an output was measured or entered."""
    return _key(part, name) in table_s(settings.table(LATENCIES), part)


def _key(part: str, name: str) -> str:
    """A device's latency is the same with every gain."""
    return with_gain(name) if part in (DEVICE, ENTERED) else name
