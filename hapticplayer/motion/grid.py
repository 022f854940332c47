"""Even time grids for filters that know only one sampling interval."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

# Below this the interval of a sample is as good as its time stamp.
MAX_JITTER = 0.01
GAP_STEPS = 3.0
MAX_GRID_GROWTH = 20.0


@dataclass(frozen=True, slots=True, eq=False)
class EvenLog:
    """Samples on an even grid.

    Attributes:
        time_s: (M,) evenly spaced.
        interval_s: the spacing.
        specific_force_mps2: (M, 3).
        angular_rate_radps: (M, 3).
    """

    time_s: Floats
    interval_s: float
    specific_force_mps2: Floats
    angular_rate_radps: Floats


def even(imu: ImuLog) -> EvenLog:
    """Return the log on an even grid; the log itself where it is even already.

    Angular rate is resampled by its integral, so that no rotation is lost;
    specific force by straight lines.
    """
    steps = np.diff(imu.time_s)
    interval_s = float(np.median(steps)) if len(steps) else 0.01
    if not len(steps) or np.abs(steps / interval_s - 1.0).max() < MAX_JITTER:
        return EvenLog(
            imu.time_s,
            interval_s if len(steps) < 2 else float(np.mean(steps)),
            imu.specific_force_mps2,
            imu.angular_rate_radps,
        )
    span_s = float(imu.time_s[-1] - imu.time_s[0])
    # hours of silence between two samples must not become millions of samples
    count = min(round(span_s / interval_s), int(MAX_GRID_GROWTH * len(imu))) + 1
    time_s = np.linspace(imu.time_s[0], imu.time_s[-1], max(count, 2))
    force = _columns(time_s, imu.time_s, imu.specific_force_mps2)
    return EvenLog(time_s, float(time_s[1] - time_s[0]), force, _mean_rate(time_s, imu))


def gap_mask(time_s: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Return (N,) True for the samples at both ends of a gap (> 3 intervals)."""
    mask = np.zeros(len(time_s), dtype=np.bool_)
    steps = np.diff(time_s)
    if len(steps):
        wide = steps > GAP_STEPS * np.median(steps)
        mask[1:] |= wide
        mask[:-1] |= wide
    return mask


def _mean_rate(grid_s: Floats, imu: ImuLog) -> Floats:
    """Return the mean angular rate over each interval that ends on the grid."""
    steps = np.diff(imu.time_s, prepend=imu.time_s[0] - np.median(np.diff(imu.time_s)))
    angle = np.cumsum(imu.angular_rate_radps * steps[:, None], axis=0)
    on_grid = _columns(grid_s, imu.time_s, angle)
    rate = np.diff(on_grid, axis=0) / np.diff(grid_s)[:, None]
    return np.vstack([imu.angular_rate_radps[:1], rate])


def _columns(query_s: Floats, time_s: Floats, values: Floats) -> Floats:
    return np.stack([np.interp(query_s, time_s, column) for column in values.T], axis=1)
