"""Recordings in: camera telemetry and motion logs, and how their clocks lie to a clip.

Times are media time (0 is the first frame) where the clocks are one; frame A is x right,
y front, z up. What reads a recording is loaded when it is used: the list of formats
needs nothing.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.capture.recording import read_recording as read_recording
    from hapticplayer.capture.sync.synchronize import (
        synchronize as synchronize,
    )


def __getattr__(name: str) -> object:
    """Load one of the two functions of this room at its first use."""
    homes = {"read_recording": "recording", "synchronize": "sync.synchronize"}
    if name not in homes:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{homes[name]}"), name)
