"""Frozen value types, units and frames that all rooms share.

SI units throughout. Frame A (the actor's sensor): x right, y front, z up. Frame D
(the device as its user sees it): x right, y up, z towards the user. Both are
right-handed. Quaternions are wxyz, Hamilton, unit, sensor to earth (z up).
"""

from hapticplayer.model.device import (
    DeviceCapabilities,
    DeviceReading,
    LoopStats,
    SyncStats,
)
from hapticplayer.model.force import ForceTrack, Reconstruction
from hapticplayer.model.imu import ImuLog, Sampling
from hapticplayer.model.mapping import M_AD, Feedback, Mapping
from hapticplayer.model.motion import MotionTrack
from hapticplayer.model.timing import ClockMap, PlaybackClock

STANDARD_GRAVITY_MPS2 = 9.80665
"""|g| of equation 1 (3rd CGPM, 1901); local gravity is within 0.3 % of it."""

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
    "Reconstruction",
    "Sampling",
    "SyncStats",
]
