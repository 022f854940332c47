"""The quaternion Kalman filter of Sabatini 2006."""

from hapticplayer.motion.ekf.parameters import EkfParameters
from hapticplayer.motion.ekf.recording import EkfResult, run_ekf

__all__ = ["EkfParameters", "EkfResult", "run_ekf"]
