"""Recordings in: camera telemetry, motion logs, synchronisation.

Times are media time (0 is the first picture) where the clocks are one; frame A is
x right, y front, z up. Each module is loaded when its first name is used.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.capture.csv_log import (
        read_force_csv,
        read_imu_csv,
        write_imu_csv,
    )
    from hapticplayer.capture.gopro import GoProTelemetry, read_gopro, read_raw_gopro
    from hapticplayer.capture.logs import (
        LogChoices,
        LogQuestion,
        parse_choices,
        write_template,
    )
    from hapticplayer.capture.recording import Recording, read_recording
    from hapticplayer.capture.sync import Synchronisation, read_sound, synchronize

_HOMES = {
    "GoProTelemetry": "gopro",
    "LogChoices": "logs",
    "LogQuestion": "logs",
    "Recording": "recording",
    "Synchronisation": "sync",
    "parse_choices": "logs",
    "read_force_csv": "csv_log",
    "read_gopro": "gopro",
    "read_imu_csv": "csv_log",
    "read_raw_gopro": "gopro",
    "read_recording": "recording",
    "read_sound": "sync",
    "synchronize": "sync",
    "write_imu_csv": "csv_log",
    "write_template": "logs",
}

__all__ = [
    "GoProTelemetry",
    "LogChoices",
    "LogQuestion",
    "Recording",
    "Synchronisation",
    "parse_choices",
    "read_force_csv",
    "read_gopro",
    "read_imu_csv",
    "read_raw_gopro",
    "read_recording",
    "read_sound",
    "synchronize",
    "write_imu_csv",
    "write_template",
]


def __getattr__(name: str) -> object:
    """Load the module of a public name at its first use."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = importlib.import_module(f"{__name__}.{_HOMES[name]}")
    globals()[name] = getattr(module, name)
    return globals()[name]
