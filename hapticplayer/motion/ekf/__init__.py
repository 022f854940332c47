"""The quaternion Kalman filter of Sabatini 2006; a recording loads it when it is chosen."""

from hapticplayer.motion.ekf.parameters import EkfParameters

__all__ = ["EkfParameters"]
