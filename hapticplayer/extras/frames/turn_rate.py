"""Turn rates of the frames and of the gyro, as they are compared, to be looked at."""

import numpy as np

from hapticplayer.capture.frames import FrameRotation
from hapticplayer.extras.frames.rotation_match import Gyro, Watched, high_passed
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

_STEP_S = 1.0 / 30.0


def turn_rate_of_frames(frames: FrameRotation) -> tuple[Floats, Floats]:
    """Return media times (N,), s, and the turn rate (N,) above 0.4 Hz, rad/s.

    Two of its three axes hold the unknown factor of `FrameRotation`. Where the frames
    show nothing of the rotation it is 0; single intervals are bridged, because a key
    frame has no motion vectors.
    """
    watched = Watched.of(frames)
    known = watched.weight > 0.0
    high = watched.high_passed(watched.rotation_rad, known)
    middle_s = 0.5 * (watched.begin_s + watched.end_s)
    length_s = watched.end_s - watched.begin_s
    rate = np.linalg.norm(high, axis=1) / length_s
    alone = 1 + np.flatnonzero(known[:-2] & ~known[1:-1] & known[2:])
    rate[alone] = 0.5 * (rate[alone - 1] + rate[alone + 1])
    return middle_s, rate


def turn_rate_of_gyro(imu: ImuLog) -> tuple[Floats, Floats]:
    """Return log times (N,), s, and the turn rate (N,) above 0.4 Hz, rad/s.

    It is averaged over 1/30 s, as a frame averages it, and 0 in gaps.
    """
    gyro = Gyro(imu)
    count = max(1, int((gyro.end_s - gyro.begin_s) / _STEP_S))
    edges_s = np.asarray(gyro.begin_s + _STEP_S * np.arange(count + 1), dtype=float)
    begin_s, end_s = edges_s[:-1], edges_s[1:]
    high = high_passed(gyro.rotation(begin_s, end_s), 1.0 / _STEP_S)
    rate = np.linalg.norm(high, axis=1) / _STEP_S
    return 0.5 * (begin_s + end_s), np.where(gyro.knows(begin_s, end_s), rate, 0.0)


def turn_rates(
    imu: ImuLog, frames: FrameRotation
) -> tuple[tuple[Floats, Floats], tuple[Floats, Floats]]:
    """Those of the frames and of the gyro."""
    return turn_rate_of_frames(frames), turn_rate_of_gyro(imu)
