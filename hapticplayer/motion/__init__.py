"""From inertial samples to gravity-free acceleration: ImuLog -> MotionTrack.

A pure room: no I/O, no threads, no clocks.
"""

from hapticplayer.model.motion import DEFAULT_METHOD
from hapticplayer.motion.ekf import EkfParameters
from hapticplayer.motion.gravity import (
    GravityRemoval,
    analyse,
    estimate_orientation,
    remove_gravity,
)
from hapticplayer.motion.methods import METHODS
from hapticplayer.motion.smoother import SmootherParameters

__all__ = [
    "DEFAULT_METHOD",
    "METHODS",
    "EkfParameters",
    "GravityRemoval",
    "SmootherParameters",
    "analyse",
    "estimate_orientation",
    "remove_gravity",
]
