"""The latencies that were measured on this machine, kept with the settings."""

from PySide6.QtWidgets import QWidget

from app.bridge.settings import Settings
from hapticplayer.playback.kept_latencies import (
    DEVICE,
    DISPLAY,
    LATENCIES,
    MOST_NAMES,
    SOUND,
    latencies_in,
    table_s,
)
from hapticplayer.playback.latency import Latencies

__all__ = [
    "DEVICE",
    "DISPLAY",
    "SOUND",
    "is_known",
    "keep_latency",
    "latencies_of",
    "screen_name",
]


def screen_name(widget: QWidget) -> str:
    """Return the name of the screen that a widget is on; some have none."""
    return widget.screen().name() or "screen"


def latencies_of(settings: Settings, screen: str) -> Latencies:
    """Return what is known of a screen, and of all sound outputs and devices."""
    return latencies_in(settings.table(LATENCIES), screen)


def keep_latency(settings: Settings, part: str, name: str, latency_ms: float) -> None:
    """Remember what was measured of one output; written by `Settings.save`."""
    kept = settings.table(LATENCIES)
    known = {key: 1e3 * value for key, value in table_s(kept, part).items()}
    known.pop(name, None)
    known[name] = latency_ms
    newest = list(known.items())[-MOST_NAMES:]
    settings.keep(LATENCIES, {**kept, part: dict(newest)})


def is_known(settings: Settings, part: str, name: str) -> bool:
    """Whether somebody measured or entered the latency of an output."""
    return name in table_s(settings.table(LATENCIES), part)
