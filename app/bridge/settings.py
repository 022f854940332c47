"""What the window remembers from one start to the next."""

import contextlib
import json
import os
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QStandardPaths
from PySide6.QtWidgets import QWidget

_GEOMETRY = "geometry"
_MAX_BYTES = 1 << 20


def default_path() -> Path:
    """Return the file in the place that this platform has for settings."""
    places = QStandardPaths.StandardLocation
    folder = QStandardPaths.writableLocation(places.GenericConfigLocation)
    return Path(folder) / "hapticplayer" / "window.json"


class Settings:
    """A small JSON file of names and texts; losing it costs nothing.

    Args:
        path: the file; None remembers nothing.
    """

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._values = _read(path) if path else {}

    def text(self, name: str, default: str = "") -> str:
        """Return what was kept under a name."""
        value = self._values.get(name, default)
        return value if isinstance(value, str) else default

    def flag(self, name: str, *, default: bool) -> bool:
        """Return a yes or no that was kept."""
        value = self._values.get(name, default)
        return value if isinstance(value, bool) else default

    def keep(self, name: str, value: str | bool) -> None:
        """Remember a value; written by `save`."""
        self._values[name] = value

    def keep_geometry(self, window: QWidget) -> None:
        """Remember where a window is and how large."""
        kept = bytes(window.saveGeometry().toBase64().data())
        self.keep(_GEOMETRY, kept.decode())

    def restore_geometry(self, window: QWidget, width_px: int, height_px: int) -> None:
        """Put a window where it was; at first as large as said, if that fits."""
        room = window.screen().availableGeometry()
        window.resize(min(width_px, room.width()), min(height_px, room.height()))
        kept = self.text(_GEOMETRY)
        if kept:
            window.restoreGeometry(QByteArray.fromBase64(kept.encode()))

    def save(self) -> None:
        """Write the file; where that is not allowed, go on without."""
        if self._path is None:
            return
        aside = self._path.with_name(f".{self._path.name}.{os.getpid()}")
        with contextlib.suppress(OSError):
            self._path.parent.mkdir(parents=True, exist_ok=True)
            aside.write_text(json.dumps(self._values, indent=1), encoding="utf-8")
            aside.replace(self._path)


def _read(path: Path) -> dict[str, Any]:
    try:
        if path.stat().st_size > _MAX_BYTES:
            return {}
        values = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return values if isinstance(values, dict) else {}
