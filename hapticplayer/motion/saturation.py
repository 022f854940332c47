"""The rails of a sensor that clips, found from its readings alone.

A sensor that clips repeats one extreme reading, its rail: many samples lie exactly on
it, in runs, and few just below. Neither still, nor smooth, nor coarsely quantised data
do that.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats

Flags = NDArray[np.bool_]

# Relative widths below an extreme reading. Nexus 5 phones: 95 % of the samples within
# 2 % of the rail are within 0.05 % of it; a sinusoid has 19 % of them there. The rails
# of RepoIMU's gyros wobble by 0.3 %; a sinusoid has 32 % of 4 % there.
ON_RAIL_SHARE, WOBBLING_RAIL_SHARE = 5e-4, 4e-3
BELOW_RAIL_SHARES = {ON_RAIL_SHARE: 0.02, WOBBLING_RAIL_SHARE: 0.04}
# Interpolation and calibration smear a rail by this much.
RAIL_SMEAR_SHARE = 2e-3
# Axes of one sensor have different offsets: +-2 g phones clip at 19.05 to 19.55.
SAME_SCALE_SHARE = 0.04
MIN_RUN_SAMPLES = 3
# A level that no data sheet names needs more evidence than a known one.
MIN_RUN_COUNT = 3
MIN_PILE_RATIO = {True: 2.0, False: 4.0}
MAX_MEAN_RUN_SAMPLES = 100.0
MAX_ON_RAIL_SHARE = 0.5


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


def find_rails(values: Floats, sensor: SensorRange) -> Floats | None:
    """Return the rails (3, 2), low and high, of some readings; None without any.

    Infinite where an axis has none. One axis and side must show a pile of readings;
    others that end at the same scale then end at their own extreme.

    Args:
        values: (N, 3), finite; specific force or angular rate.
        sensor: ACCELEROMETER or GYROSCOPE.
    """
    if max(values.max(initial=0.0), -values.min(initial=0.0)) < sensor.least:
        return None
    columns = np.ascontiguousarray(values.T)  # numpy is slow along axes of three
    outward = np.array([-1.0, 1.0])
    tops = outward * np.array([columns.min(axis=1), columns.max(axis=1)]).T
    is_rail = np.zeros(tops.shape, np.bool_)
    for width in BELOW_RAIL_SHARES:
        for axis, side in np.argwhere(tops >= sensor.least):
            column = columns[axis] if side else -columns[axis]
            top = float(tops[axis, side])
            is_rail[axis, side] = _is_rail(column, top, width, sensor)
        if is_rail.any():
            break
    else:
        return None
    tops *= 1.0 - (width - ON_RAIL_SHARE)
    for rail in tops[is_rail]:
        is_rail |= np.abs(tops / rail - 1.0) <= SAME_SCALE_SHARE
    return np.where(is_rail, outward * tops, outward * np.inf)


def on_rails(values: Floats, rails: Floats) -> Flags:
    """Return which readings (N, 3) lie on a rail or beyond, (N, 3)."""
    low, high = (1.0 - RAIL_SMEAR_SHARE) * rails.T
    return np.asarray((values <= low) | (values >= high))


def _is_rail(values: Floats, top: float, width: float, sensor: SensorRange) -> bool:
    """Return whether samples pile up at `top`, in runs, with few just below."""
    on_rail = values >= (1.0 - width) * top
    count = int(np.count_nonzero(on_rail))
    # what lies there most of the time is a steady motion, not a peak cut off
    if not MIN_RUN_SAMPLES <= count <= MAX_ON_RAIL_SHARE * len(values):
        return False
    is_near = values >= (1.0 - BELOW_RAIL_SHARES[width]) * top
    near = int(np.count_nonzero(is_near))
    is_known = any(abs(top / s - 1.0) <= SAME_SCALE_SHARE for s in sensor.full_scales)
    if count < MIN_PILE_RATIO[is_known] * (near - count):
        return False
    if width == WOBBLING_RAIL_SHARE:
        # the noise of a steady turn must not split it into runs
        on_rail, is_known = is_near, False
    edges = np.flatnonzero(np.diff(on_rail, prepend=False, append=False))
    runs = edges[1::2] - edges[::2]
    runs = runs[runs >= MIN_RUN_SAMPLES]
    if len(runs):
        # a logger that repeats slow samples makes a run of every value
        runs = runs[runs >= MIN_RUN_SAMPLES * _typical_repeat(values)]
    if is_known:
        return len(runs) >= 1
    return len(runs) >= MIN_RUN_COUNT and float(np.mean(runs)) <= MAX_MEAN_RUN_SAMPLES


def _typical_repeat(values: Floats) -> float:
    changes = np.flatnonzero(values[1:] != values[:-1])
    return float(np.median(np.diff(changes))) if len(changes) > 1 else 1.0
