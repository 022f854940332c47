"""Frozen value types, units and frames that all rooms share.

SI units throughout. Frame A (the actor's sensor): x right, y front, z up. Frame D
(the device as its user sees it): x right, y up, z towards the user. Both are
right-handed. Quaternions are wxyz, Hamilton, unit, sensor to earth (z up).

Each module is loaded when its first name is used: what a device can do needs no numpy.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.model.device import (
        DeviceCapabilities,
        DeviceReading,
        LoopStats,
        SyncStats,
    )
    from hapticplayer.model.force import ForceTrack, Reconstruction
    from hapticplayer.model.imu import ImuLog, Sampling
    from hapticplayer.model.mapping import (
        M_AD,
        Feedback,
        Mapping,
        PresetName,
        rendered_feedback,
    )
    from hapticplayer.model.motion import MotionTrack
    from hapticplayer.model.rig_track import RigTrack
    from hapticplayer.model.timing import ClockMap, PlaybackClock

STANDARD_GRAVITY_MPS2 = 9.80665
"""|g| of equation 1 (3rd CGPM, 1901); local gravity is within 0.3 % of it."""

_MODULES = ("device", "timing", "force", "imu", "mapping", "motion", "rig_track")
"""Searched in this order: the first two load no numpy, which loop and guard do without."""

__all__ = [
    "M_AD",
    "STANDARD_GRAVITY_MPS2",
    "ClockMap",
    "DeviceCapabilities",
    "DeviceReading",
    "Feedback",
    "ForceTrack",
    "ImuLog",
    "LoopStats",
    "Mapping",
    "MotionTrack",
    "PlaybackClock",
    "PresetName",
    "Reconstruction",
    "RigTrack",
    "Sampling",
    "SyncStats",
    "rendered_feedback",
]


def __getattr__(name: str) -> object:
    """Load the module of a public name when it is first used."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    for module in _MODULES:
        found = vars(importlib.import_module(f"{__name__}.{module}")).get(name)
        if found is not None:
            globals()[name] = found
            return found
    raise AssertionError(name)
