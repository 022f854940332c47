"""Where a recording stands still, and what the accelerometer's scale is there.

Accelerometers of action cameras are uncalibrated: norms at rest between 9.8 and
10.8 m/s^2 were measured. A scale error of 1 % leaves 0.1 m/s^2 of gravity in
every sample, so still spans set the gain before anything else.
"""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model.arrays import Floats

WINDOW_S = 1.0
# A tripod or a standing person stays below these, a rolling wheel does not
# (measured: ADXL345 noise 0.1 m/s^2 per sample, hand tremor 0.05 rad/s).
MAX_FORCE_STD_MPS2 = 0.25
MAX_RATE_STD_RADPS = 0.05
MAX_RATE_MEAN_RADPS = 0.1  # allows a gyro bias of 5 deg/s
# Beyond this the norm is no scale error but a wrong unit or constant motion.
GAIN_RANGE = (0.85, 1.15)


@dataclass(frozen=True, slots=True)
class AccelerometerGain:
    """Scale of the accelerometer and how it is known.

    Attributes:
        gain: multiply the specific force with it.
        still_s: total time of the still spans it comes from; 0 when assumed.
        reason: for provenance, in words.
    """

    gain: float
    still_s: float
    reason: str


def estimate_accelerometer_gain(imu: ImuLog) -> AccelerometerGain:
    """Return the gain that makes the norm of the specific force 1 g at rest.

    Args:
        imu: the log; needs no particular rate.

    Returns:
        gain = |g| / median norm over the still spans, or 1 where there is none or
        where the result would be outside 0.85 to 1.15.
    """
    still = still_mask(imu)
    still_s = float(np.sum(np.diff(imu.time_s)[still[1:]])) if len(imu) > 1 else 0.0
    if still_s < WINDOW_S:
        return AccelerometerGain(1.0, 0.0, "assumed: the recording has no still span")
    norm = np.linalg.norm(imu.specific_force_mps2[still], axis=1)
    gain = STANDARD_GRAVITY_MPS2 / float(np.median(norm))
    if not GAIN_RANGE[0] <= gain <= GAIN_RANGE[1]:
        reason = f"assumed: still spans would give {gain:.3f}, which is not plausible"
        return AccelerometerGain(1.0, 0.0, reason)
    return AccelerometerGain(gain, still_s, f"from {still_s:.1f} s of still spans")


def still_mask(imu: ImuLog) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Return (N,) True for samples inside a window of 1 s that stands still."""
    count = max(2, round(WINDOW_S * imu.rate_hz))
    mask = np.zeros(len(imu), dtype=np.bool_)
    if len(imu) < count:
        return mask
    force_mean, force_std = _windows(imu.specific_force_mps2, count)
    rate_mean, rate_std = _windows(imu.angular_rate_radps, count)
    span_s = imu.time_s[count - 1 :] - imu.time_s[: len(imu) - count + 1]
    starts = np.flatnonzero(
        (force_std < MAX_FORCE_STD_MPS2)
        & (rate_std < MAX_RATE_STD_RADPS)
        & (rate_mean < MAX_RATE_MEAN_RADPS)
        & (force_mean > 0.5 * STANDARD_GRAVITY_MPS2)
        & (span_s < 1.5 * WINDOW_S)  # a gap inside is no evidence of rest
    )
    edges = np.zeros(len(imu) + 1, dtype=np.int64)
    np.add.at(edges, starts, 1)
    np.add.at(edges, starts + count, -1)
    mask[:] = np.cumsum(edges[:-1]) > 0
    return mask


def _windows(values: Floats, count: int) -> tuple[Floats, Floats]:
    """Return norm of the mean and norm of the deviation of sliding windows."""
    centred = values - values.mean(axis=0)  # cancellation would eat the variance
    sums = np.cumsum(np.vstack([np.zeros(3), centred]), axis=0)
    squares = np.cumsum(np.vstack([np.zeros(3), np.square(centred)]), axis=0)
    mean = (sums[count:] - sums[:-count]) / count
    variance = (squares[count:] - squares[:-count]) / count - np.square(mean)
    deviation = np.sqrt(np.maximum(variance, 0.0).sum(axis=1))
    return np.linalg.norm(mean + values.mean(axis=0), axis=1), deviation
