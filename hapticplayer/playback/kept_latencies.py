"""The latencies that somebody measured, as the window keeps them on this machine."""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from hapticplayer.playback.latency import MOST_S, Latencies
from hapticplayer.sequence.files import config_home

SETTINGS_NAME = "window.json"
SETTINGS_VERSION = 1
"""Of the file; files without one are of the days before it and read the same."""

VERSION, LATENCIES = "version", "latencies"
DISPLAY, SOUND, DEVICE = "display", "sound", "device"
"""Tables within the table of the settings: milliseconds by the name of the output."""

MOST_NAMES = 64
_MAX_BYTES = 1 << 20


def kept_latencies() -> Latencies:
    """Return those of all sound outputs and devices; nothing where no file is."""
    try:
        path = config_home() / SETTINGS_NAME
    except RuntimeError:  # nobody's home is known
        return Latencies()
    values = read_settings(path)
    if version_of(values) > SETTINGS_VERSION:
        return Latencies()
    table = values.get(LATENCIES)
    return latencies_in(table if isinstance(table, dict) else {})


def latencies_in(table: Mapping[str, Any], screen: str = "") -> Latencies:
    """Return what a table of the settings says.

    Args:
        table: by part, then by the name of the output, ms.
        screen: that the pictures are on; "" where there is none.
    """
    display_s = table_s(table, DISPLAY).get(screen, 0.0)
    return Latencies(display_s, table_s(table, SOUND), table_s(table, DEVICE))


def table_s(table: Mapping[str, Any], part: str) -> dict[str, float]:
    """Return what makes sense of one part, s: people may edit the file."""
    found = table.get(part)
    values = list(found.items())[:MOST_NAMES] if isinstance(found, dict) else []
    return {name: 1e-3 * value for name, value in values if _is_sane(value)}


def read_settings(path: Path) -> dict[str, Any]:
    """Return the window's settings; nothing of a file that makes no sense."""
    try:
        if not path.is_file() or path.stat().st_size > _MAX_BYTES:
            return {}
        values = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return values if isinstance(values, dict) else {}


def version_of(values: Mapping[str, Any]) -> float:
    """Return the version of settings that were read."""
    version = values.get(VERSION, 0)
    return version if isinstance(version, int) else math.inf


def _is_sane(value: Any) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and 0.0 <= value <= 1e3 * MOST_S
