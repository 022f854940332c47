"""Gravity removal, p[k] = a[k] - |g| n_g[k].

Source: Danieau et al. 2012, "A Framework for Enhancing Video Viewing Experience
with Haptic Effects of Motion", equation 1; orientation by offline VQF (Laidig and
Seel 2023, doi:10.1016/j.inffus.2022.10.014). Cost: 0.5 us a sample.
"""

from collections.abc import Callable

import numpy as np

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack, Sampling
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import grid
from hapticplayer.motion.stillness import estimate_accelerometer_gain

MIN_SAMPLES = 2


def _offline_vqf(log: grid.EvenLog) -> Floats:
    """Return (M, 4) sensor to earth; heading starts at an arbitrary angle."""
    import vqf

    # no magnetometer: only the vertical is subtracted, and heading does not move it
    result = vqf.offlineVQF(
        np.array(log.angular_rate_radps),
        np.array(log.specific_force_mps2),
        None,
        log.interval_s,
    )
    return np.asarray(result["quat6D"])


METHODS: dict[str, Callable[[grid.EvenLog], Floats]] = {"offline-vqf": _offline_vqf}
"""Orientation estimators by name; each takes an even log and returns (M, 4)."""

DEFAULT_METHOD = "offline-vqf"


def estimate_orientation(imu: ImuLog, method: str = DEFAULT_METHOD) -> Floats:
    """Return the orientation (N, 4), wxyz, sensor to earth, at the log's times.

    For averaged samples it is the orientation at the middle of each window.

    Raises:
        UsageError: for a method that does not exist.
        InputError: for fewer than two samples.
    """
    if method not in METHODS:
        raise UsageError(
            f"there is no method {method!r}; choose one of {', '.join(METHODS)}"
        )
    if len(imu) < MIN_SAMPLES:
        raise InputError(
            f"{len(imu)} motion samples are too few; at least {MIN_SAMPLES} are needed",
            where=imu.source,
        )
    log = grid.even(imu)
    q = METHODS[method](log)
    if imu.sampling is Sampling.AVERAGED:
        # the filter's answer belongs to the end of the window, half of one later
        half_s = 0.5 * log.interval_s
        q = quat.multiply(
            q, quat.from_rotation_vector(-half_s * log.angular_rate_radps)
        )
    if log.time_s is imu.time_s:
        return quat.normalized(q)
    return quat.interpolate(imu.time_s, log.time_s, q)


def remove_gravity(imu: ImuLog, method: str = DEFAULT_METHOD) -> MotionTrack:
    """Return the gravity-free acceleration of a log, in frame A.

    The accelerometer's gain is corrected where the recording stands still for at
    least one second, else it is taken as 1.

    Args:
        imu: samples in frame A; see ImuLog.
        method: one of METHODS.

    Raises:
        UsageError: for a method that does not exist.
        InputError: for fewer than two samples.
    """
    gain = estimate_accelerometer_gain(imu).gain
    q = estimate_orientation(imu, method)
    gravity = STANDARD_GRAVITY_MPS2 * quat.vertical(q)
    return MotionTrack(
        time_s=imu.time_s,
        acceleration_mps2=gain * imu.specific_force_mps2 - gravity,
        gravity_mps2=gravity,
        accelerometer_gain=gain,
        quaternion_wxyz=q,
        gravity_sigma_mps2=None,
        valid=~grid.gap_mask(imu.time_s),
    )
