"""Reads real recordings (camera telemetry, motion logs) and synchronises them.

Times are media time (0 is the first frame) if the clocks are the same; frame A is x
right, y front, z up. Readers are imported when they are used.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.capture.reading import read_recording as read_recording
    from hapticplayer.capture.sync.synchronize import (
        synchronize as synchronize,
    )


def __getattr__(name: str) -> object:
    """Load one of the two functions of this room at its first use."""
    homes = {"read_recording": "reading", "synchronize": "sync.synchronize"}
    if name not in homes:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{homes[name]}"), name)
