"""How far the smoothed vertical may be off.

Three parts, which add up in square: what the model says; how far the vertical moves
when the velocity is bounded four times less tightly, which is large where accelerations
last and cannot be told from tilt; and a floor for all that no part of it knows. How much
of each was found on recordings with optical truth, for the model's noises are those
that give the least error, not those that describe it best.
"""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.calibrated import (
    Problem,
    Solution,
    tighter,
)
from hapticplayer.motion.smoother.linearise import local_mean
from hapticplayer.motion.smoother.stages import minimise, tilt_variances

# The model's variance is found exactly at nodes this far apart.
_EVERY_S = 20.0
_AT_LEAST = 5
# Intervals whose tilt is less certain than the usual one by this factor, and at most
# how many of them are looked at one by one.
_HOLE, _HOLES = 0.02, 50
_FLOOR_RAD = 0.0045
_MOVED = 1.5
_LOOSER = 4.0
# Share of the model's deviation, and by how much it grows where a long time constant
# says that accelerations last.
_MODEL = 0.27
_LONG_S, _LONGER_S, _MOST = 35.0, 25.0, 2.0


def tilt_variance(
    problem: Problem,
    solution: Solution,
    covariance: Floats,
    time_constant_s: Floats,
    local_s: float,
) -> Floats:
    """Return the variance of both tilts together at the nodes (K + 1,), rad^2.

    Args:
        problem: the last one.
        solution: of it.
        covariance: of its calibration.
        time_constant_s: (K + 1,) of the levelling.
        local_s: half width of the means.
    """
    rows = solution.tilt_per_calibration
    spread = (rows * (covariance @ rows)).sum(axis=(0, 1))
    model = 2.0 * noise_variance(problem) + spread
    longer = np.clip((time_constant_s - _LONG_S) / _LONGER_S, 0.0, _MOST)
    other = minimise(tighter(problem, solution, 1.0 / _LOOSER)).tilt
    moved = np.square(other - solution.tilt).sum(axis=0)
    return np.asarray(
        (_MODEL * (1.0 + longer)) ** 2 * model
        + _MOVED**2 * local_mean(moved, problem.duration_s, local_s)
        + _FLOOR_RAD**2
    )


def noise_variance(problem: Problem) -> Floats:
    """Return the variance of one tilt for a known calibration, (K + 1,)."""
    count = len(problem.duration_s) + 1
    number = max(_AT_LEAST, round(float(problem.duration_s.sum()) / _EVERY_S))
    number = min(number, count)
    even = np.rint(np.arange(number) * ((count - 1) / max(1, number - 1))).astype(int)
    # holes are looked at where they are
    holes = _holes(problem.tilt_weight)
    chosen = even
    if len(holes):
        holes = holes[:: max(1, len(holes) // _HOLES)]
        near = (holes[:, None] + np.arange(-2, 4)).ravel().clip(0, count - 1)
        chosen = np.unique(np.concatenate([even, near]))
    found = np.log(tilt_variances(problem, chosen))
    return np.asarray(np.exp(np.interp(np.arange(count), chosen, found)))


def _holes(weight: Floats) -> NDArray[np.intp]:
    """Return the intervals whose tilt is far less certain than that of the usual."""
    if weight.min() >= _HOLE * weight.max():
        return np.empty(0, np.intp)
    return np.flatnonzero(weight < _HOLE * np.median(weight))
