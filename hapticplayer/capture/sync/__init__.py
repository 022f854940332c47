"""Synchronises a log with a clip: `synchronize`, by pats or otherwise."""

from hapticplayer.capture.sync.result import (
    ENOUGH_CONFIDENCE,
    Pat,
    Rival,
    Synchronisation,
)
from hapticplayer.capture.sync.synchronize import METHODS, read_sound, synchronize

__all__ = [
    "ENOUGH_CONFIDENCE",
    "METHODS",
    "Pat",
    "Rival",
    "Synchronisation",
    "read_sound",
    "synchronize",
]
