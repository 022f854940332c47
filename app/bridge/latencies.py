"""The latencies that were measured on this machine, kept with the settings."""

import math
from typing import Any

from PySide6.QtWidgets import QWidget

from app.bridge.settings import LATENCIES, Settings
from hapticplayer.playback.latency import MOST_S, Latencies

DISPLAY, SOUND, DEVICE = "display", "sound", "device"
"""Tables within the table of the settings: milliseconds by the name of the output."""

_MOST_NAMES = 64


def screen_name(widget: QWidget) -> str:
    """Return the name of the screen that a widget is on; some have none."""
    return widget.screen().name() or "screen"


def latencies_of(settings: Settings, screen: str) -> Latencies:
    """Return what is known of a screen, and of all sound outputs and devices."""
    display_s = _table_s(settings, DISPLAY).get(screen, 0.0)
    return Latencies(display_s, _table_s(settings, SOUND), _table_s(settings, DEVICE))


def keep_latency(settings: Settings, part: str, name: str, latency_ms: float) -> None:
    """Remember what was measured of one output; written by `Settings.save`."""
    kept = settings.table(LATENCIES)
    known = {key: 1e3 * value for key, value in _table_s(settings, part).items()}
    known.pop(name, None)
    known[name] = latency_ms
    newest = list(known.items())[-_MOST_NAMES:]
    settings.keep(LATENCIES, {**kept, part: dict(newest)})


def is_known(settings: Settings, part: str, name: str) -> bool:
    """Whether somebody measured or entered the latency of an output."""
    return name in _table_s(settings, part)


def _table_s(settings: Settings, part: str) -> dict[str, float]:
    """Return what makes sense of a table, s: people may edit the file."""
    found = settings.table(LATENCIES).get(part)
    values = list(found.items())[:_MOST_NAMES] if isinstance(found, dict) else []
    return {name: 1e-3 * value for name, value in values if _is_sane(value)}


def _is_sane(value: Any) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and 0.0 <= value <= 1e3 * MOST_S
