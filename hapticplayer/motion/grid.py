"""Even time grids for filters that know only one sampling interval."""

import itertools
from dataclasses import dataclass, replace

import numpy as np

from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

# Below this the interval of a sample is as good as its time stamp.
MAX_JITTER_INTERVALS = 0.01
MAX_GRID_COUNT_RATIO = 20.0
# Beyond a longer gap the attitude is unknown, however long it was.
MAX_GAP_S = 60.0
_CLOSED_S = 1.0
# A piece has so many samples at least.
_MIN_PIECE_SAMPLES = 50


@dataclass(frozen=True, slots=True, eq=False)
class EvenLog:
    """Samples on an even grid.

    Attributes:
        time_s: (M,) evenly spaced.
        interval_s: the spacing.
        specific_force_mps2: (M, 3).
        angular_rate_radps: (M, 3).
        magnetic_field_ut: (M, 3), or None where it is not wanted.
    """

    time_s: Floats
    interval_s: float
    specific_force_mps2: Floats
    angular_rate_radps: Floats
    magnetic_field_ut: Floats | None = None


def even(
    imu: ImuLog, specific_force_mps2: Floats, *, with_field: bool = False
) -> EvenLog:
    """Return the log on an even grid; the log itself where it is even already.

    Angular rate is resampled by its integral, so that no rotation is lost; all else
    by straight lines.

    Args:
        imu: the log.
        specific_force_mps2: (N, 3) to be used instead of the log's.
        with_field: whether the magnetic field is wanted.
    """
    field = imu.magnetic_field_ut if with_field else None
    steps = np.diff(imu.time_s)
    interval_s = float(np.median(steps)) if len(steps) else 0.01
    if not len(steps) or np.abs(steps / interval_s - 1.0).max() < MAX_JITTER_INTERVALS:
        return EvenLog(
            imu.time_s,
            interval_s if len(steps) < 2 else float(np.mean(steps)),
            specific_force_mps2,
            imu.angular_rate_radps,
            field,
        )
    span_s = float(imu.time_s[-1] - imu.time_s[0])
    # hours of silence between two samples must not become millions of samples
    count = min(round(span_s / interval_s), int(MAX_GRID_COUNT_RATIO * len(imu))) + 1
    time_s = np.linspace(imu.time_s[0], imu.time_s[-1], max(count, 2))
    return EvenLog(
        time_s,
        float(time_s[1] - time_s[0]),
        columns(time_s, imu.time_s, specific_force_mps2),
        _mean_rate(time_s, imu),
        None if field is None else columns(time_s, imu.time_s, field),
    )


def pieces(imu: ImuLog) -> list[slice]:
    """Return the samples between gaps of more than a minute.

    After one a filter restarts, because the attitude is unknown. What is too short to
    start on stays with the piece before.
    """
    edges = [0]
    gaps = np.flatnonzero(np.diff(imu.time_s) > MAX_GAP_S) + 1
    for gap, after in itertools.pairwise([*gaps.tolist(), len(imu)]):
        if min(gap - edges[-1], after - gap) >= _MIN_PIECE_SAMPLES:
            edges.append(gap)
    return [slice(*ends) for ends in itertools.pairwise([*edges, len(imu)])]


def with_gaps_closed(imu: ImuLog) -> ImuLog:
    """Return the log with gaps of more than a minute shortened to a second.

    A grid over hours without samples would have to be coarse.
    """
    steps = np.diff(imu.time_s)
    gap = steps > MAX_GAP_S
    if not gap.any():
        return imu
    steps[gap] = _CLOSED_S
    return replace(imu, time_s=imu.time_s[0] + np.append(0.0, np.cumsum(steps)))


def _mean_rate(grid_s: Floats, imu: ImuLog) -> Floats:
    """Return the mean angular rate over each interval that ends on the grid."""
    steps = np.diff(imu.time_s, prepend=imu.time_s[0] - np.median(np.diff(imu.time_s)))
    angle = np.cumsum(imu.angular_rate_radps * steps[:, None], axis=0)
    on_grid = columns(grid_s, imu.time_s, angle)
    rate = np.diff(on_grid, axis=0) / np.diff(grid_s)[:, None]
    return np.vstack([imu.angular_rate_radps[:1], rate])


def columns(query_s: Floats, time_s: Floats, values: Floats) -> Floats:
    """Return (M, 3) values by straight lines through (N, 3) ones."""
    return np.stack([np.interp(query_s, time_s, column) for column in values.T], axis=1)
