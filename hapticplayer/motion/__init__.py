"""From inertial samples to gravity-free acceleration: ImuLog -> MotionTrack.

A pure room: no I/O, no threads, no clocks.
"""

from hapticplayer.motion.gravity import (
    DEFAULT_METHOD,
    METHODS,
    estimate_orientation,
    remove_gravity,
)
from hapticplayer.motion.stillness import (
    AccelerometerGain,
    estimate_accelerometer_gain,
)

__all__ = [
    "DEFAULT_METHOD",
    "METHODS",
    "AccelerometerGain",
    "estimate_accelerometer_gain",
    "estimate_orientation",
    "remove_gravity",
]
