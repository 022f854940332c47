"""The acceleration of another point of the rigid body that carries the sensor.

    a_P = a_O + alpha x r + omega x (omega x r)

with r from the sensor O to the point P, all in frame A.
"""

import dataclasses

import numpy as np

from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.model.arrays import Floats

SMOOTHING_HZ = 15.0
"""Of the angular rate: its derivative alpha would amplify the noise above."""

HIGHEST_SHARE_OF_RATE = 0.45
"""Slower recordings are smoothed below half their rate."""

Point = tuple[float, float, float]

LEVER_ARMS_M: dict[str, Point] = {
    "handlebar": (0.0, 0.45, -0.25),
    "seat": (0.0, -0.25, -0.50),
    "head": (0.0, 0.05, 0.35),
}
"""Rough examples for a recorder on a rider's chest, not measured ones."""


def at_point(motion: MotionTrack, imu: ImuLog, lever_arm_m: Point) -> MotionTrack:
    """Return the motion of the point at a lever arm (right, front, up) from the sensor.

    Args:
        motion: of the sensor, in media time.
        imu: its angular rate, in media time.
        lever_arm_m: from the sensor, in frame A.
    """
    rate_radps = _smoothed(imu)
    alpha_radps2 = np.gradient(rate_radps, imu.time_s, axis=0)
    rate_radps, alpha_radps2 = (
        np.stack([np.interp(motion.time_s, imu.time_s, c) for c in values.T], axis=1)
        for values in (rate_radps, alpha_radps2)
    )
    arm_m = np.array(lever_arm_m)
    tangential = np.cross(alpha_radps2, arm_m)
    centripetal = np.cross(rate_radps, np.cross(rate_radps, arm_m))
    acceleration = motion.acceleration_mps2 + tangential + centripetal
    return dataclasses.replace(motion, acceleration_mps2=acceleration)


def _smoothed(imu: ImuLog) -> Floats:
    from hapticplayer.motion.conditioning.filtering import lowpass_samples

    rate_radps, valid = imu.angular_rate_radps, imu.valid
    if valid is not None and valid.any():
        # filtered by itself, an invalid span would leave a jump that alpha repeats
        columns = (
            np.interp(imu.time_s, imu.time_s[valid], c[valid]) for c in rate_radps.T
        )
        rate_radps = np.stack(list(columns), axis=1)
    cutoff_hz = min(SMOOTHING_HZ, HIGHEST_SHARE_OF_RATE * imu.rate_hz)
    whole = np.ones(len(imu), dtype=np.bool_)
    return lowpass_samples(imu.time_s, rate_radps, whole, cutoff_hz)
