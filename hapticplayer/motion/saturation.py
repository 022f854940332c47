"""Which samples sit on the sensor's rail, found from the values alone.

A sensor that clips repeats one extreme value: many samples lie exactly on it, in
runs, and few just below. Neither still, nor smooth, nor coarsely quantised data do
that. Cost: 0.1 us a sample, 0.3 where it clips.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

Flags = NDArray[np.bool_]

# Samples at a time: of a long log no copy is made.
_CHUNK = 1 << 16
# Relative widths below an extreme value. Nexus 5 phones: 95 % of the samples within
# 2 % of the rail are within 0.05 % of it; a sinusoid has 19 % of them there.
ON_RAIL = 5e-4
BELOW_RAIL = 0.02
# Interpolation and calibration smear a rail by this much.
MARKED = 2e-3
# Axes of one sensor have different offsets: +-2 g phones clip at 19.05 to 19.55.
SAME_SCALE = 0.04
MIN_RUN = 3
# A level that no data sheet names needs more evidence than a known one.
MIN_RUNS = 3
MIN_CONTRAST = {True: 2.0, False: 4.0}
MAX_MEAN_RUN = 100.0
MAX_SHARE = 0.5


@dataclass(frozen=True, slots=True)
class SensorRange:
    """What is known about the rails of a kind of sensor.

    Attributes:
        full_scales: the ranges that data sheets offer.
        least: no rail lies below it, so that a sensor at rest never seems clipped.
    """

    full_scales: tuple[float, ...]
    least: float


ACCELEROMETER = SensorRange(
    tuple(g * STANDARD_GRAVITY_MPS2 for g in (2.0, 4.0, 8.0, 16.0, 32.0)),
    1.2 * STANDARD_GRAVITY_MPS2,
)
"""In m/s^2."""

GYROSCOPE = SensorRange(
    tuple(map(math.radians, (125.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0))),
    math.radians(20.0),
)
"""In rad/s."""


def saturated_mask(values: Floats, sensor: SensorRange) -> tuple[Flags, float | None]:
    """Return the samples on a rail and the full scale they belong to.

    Args:
        values: (N, 3), finite; specific force or angular rate.
        sensor: ACCELEROMETER or GYROSCOPE.

    Returns:
        mask: (N, 3) True where an axis sits on its rail.
        full_scale: the known range within 4 % of the rail, else the largest rail
            that was found; None when nothing is clipped.
    """
    mask = np.zeros(values.shape[::-1], np.bool_)
    # a second look is needed only where the first finds nothing
    is_low = values.max(initial=-np.inf) < sensor.least
    if is_low and -values.min(initial=np.inf) < sensor.least:
        return mask.T, None
    tops, by_axis = _tops(values)
    rails = np.zeros((2, 3))
    for side, sign in enumerate((1.0, -1.0)):
        for axis, top in enumerate(tops[side].tolist()):
            if top >= sensor.least and _is_rail(by_axis[axis], sign, top, sensor):
                rails[side, axis] = top
    if not rails.any():
        return mask.T, None
    _add_siblings(rails, tops)
    for side, sign in enumerate((1.0, -1.0)):
        for axis in range(3):
            if rails[side, axis] > 0.0:
                rail = (1.0 - MARKED) * rails[side, axis]
                mask[axis] |= sign * by_axis[axis] >= rail
    largest = float(rails.max())
    return mask.T, _known(largest, sensor) or largest


def _tops(values: Floats) -> tuple[Floats, Floats]:
    """Return how far each axis goes both ways (2, 3), and the values by axis (3, N)."""
    tops, by_axis = np.full((2, 3), -np.inf), values.T
    for first in range(0, len(values), _CHUNK):
        # by axis: numpy is slow along axes of three
        part = np.ascontiguousarray(values[first : first + _CHUNK].T)
        np.maximum(tops, [part.max(axis=1), -part.min(axis=1)], out=tops)
        if len(values) <= _CHUNK:
            by_axis = part
    return tops, by_axis


def _is_rail(values: Floats, sign: float, top: float, sensor: SensorRange) -> bool:
    """Return whether samples pile up at `top`, in runs, with few just below."""
    level = sign * (1.0 - ON_RAIL) * top
    on_rail = values >= level if sign > 0.0 else values <= level
    count = int(np.count_nonzero(on_rail))
    # what lies there most of the time is a steady motion, not a peak cut off
    if not MIN_RUN <= count <= MAX_SHARE * len(values):
        return False
    below = sign * (1.0 - BELOW_RAIL) * top
    near = int(np.count_nonzero(values >= below if sign > 0.0 else values <= below))
    is_known = _known(top, sensor) is not None
    if count < MIN_CONTRAST[is_known] * (near - count):
        return False
    runs = _run_lengths(on_rail)
    runs = runs[runs >= MIN_RUN]
    if len(runs):
        # a logger that repeats slow samples makes a run of every value
        runs = runs[runs >= MIN_RUN * _typical_repeat(values)]
    if is_known:
        return len(runs) >= 1
    return len(runs) >= MIN_RUNS and float(np.mean(runs)) <= MAX_MEAN_RUN


def _run_lengths(flags: Flags) -> NDArray[np.intp]:
    edges = np.flatnonzero(np.diff(flags, prepend=False, append=False))
    return np.asarray(edges[1::2] - edges[::2])


def _typical_repeat(values: Floats) -> float:
    """Return the median number of times that a value is repeated in a row."""
    changed = values[1:] != values[:-1]
    in_a_row = np.count_nonzero(changed[1:] & changed[:-1])
    if 2 * in_a_row > np.count_nonzero(changed):
        return 1.0
    changes = np.flatnonzero(changed)
    return float(np.median(np.diff(changes))) if len(changes) > 1 else 1.0


def _add_siblings(rails: Floats, tops: Floats) -> None:
    """Take over axes that end at the same scale with less evidence of their own."""
    for rail in np.unique(rails[rails > 0.0]):
        same = (rails == 0.0) & (np.abs(tops / rail - 1.0) <= SAME_SCALE)
        rails[same] = tops[same]


def _known(level: float, sensor: SensorRange) -> float | None:
    for scale in sensor.full_scales:
        if abs(level / scale - 1.0) <= SAME_SCALE:
            return scale
    return None
