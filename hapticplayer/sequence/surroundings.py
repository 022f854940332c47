"""The part of a log that the motion of a clip is estimated from.

The inclination needs some seconds around a sample, the sensor's calibration minutes, so
the log is not cut to the clip first. But a day's log around a minute would cost memory
and time for a gyro bias that has changed meanwhile.
"""

import math

import numpy as np

from hapticplayer.model import ImuLog
from hapticplayer.model.calibration import SensorCalibration, vector

MARGIN_S = 300.0
"""On either side of the clip. Clips of 10 s of phones have 0.89 m/s^2 of gravity error
without a margin, 0.37 with 10 s, 0.17 with 30 s, 0.12 with 60 s and 0.09 with 120 s; with
a short clip 300 s are still one block of the smoother, over which a bias is constant."""


def surroundings(
    imu: ImuLog, start_s: float, end_s: float
) -> tuple[ImuLog, SensorCalibration | None]:
    """The part of a log from which the motion between two times is estimated.

    Args:
        imu: the whole log.
        start_s: on the log's clock.
        end_s: on the log's clock.

    Returns:
        The log up to MARGIN_S before and after, and the gyro's bias in the nearest
        still span of 3 s outside, or None where nothing is left out or nothing still.
        The whole log where it has a gap there.
    """
    from hapticplayer.motion.gravity import MIN_SAMPLES

    time_s = imu.time_s
    first = int(np.searchsorted(time_s, start_s - MARGIN_S))
    last = int(np.searchsorted(time_s, end_s + MARGIN_S, side="right"))
    if last - first == len(imu) or last - first < MIN_SAMPLES:
        return imu, None
    return imu.part(slice(first, last)), _still_outside(imu, start_s, end_s)


def _still_outside(
    imu: ImuLog, start_s: float, end_s: float
) -> SensorCalibration | None:
    from hapticplayer.motion import SmootherParameters
    from hapticplayer.motion.stillness import find_still, nearest_still_bias

    still = find_still(imu)
    edges = still.per_bin * np.arange(len(still.bins) + 1)
    edges_s = imu.time_s[np.minimum(edges, len(imu) - 1)]
    found = nearest_still_bias(still, edges_s, start_s, end_s)
    if found is None:
        return None
    bias_radps, sigma_radps = found
    usual = SmootherParameters()
    sigma = math.hypot(
        usual.still_bias_sigma_radps, usual.still_sigma_factor * sigma_radps
    )
    return SensorCalibration(vector(bias_radps), (sigma, sigma, sigma))
