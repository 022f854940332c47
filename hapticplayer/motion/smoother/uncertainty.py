"""How far the smoothed vertical may be off.

Four parts, which add up in square. What the model says of noise for a known calibration.
What the accelerometer's bias does where the motion does not show it and it is taken for
tilt. How far the vertical moves when the velocity is bounded as tightly as it was found,
where the bound is `velocity_factor` times wider, or more for what drives: that is large
where the bound, and not the sensor, tells tilt from acceleration. And a floor for all
that no part of it knows.

The second and the third grow with the gyro's bias, the one error that every motion
shows: a maker who puts it right does so with the accelerometer's bias and both scales,
which many a motion hides. Beyond what is assumed of any gyro it says no more: there are
raw ones beside good accelerometers. How much of each was found on recordings with optical truth
and on simulated rides, for the model's noises are those that give the least error, not
those that describe it best.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.calibrated import (
    FORCE_BIAS,
    Problem,
    Solution,
    minimise,
    tighter,
    tilt_variances,
)
from hapticplayer.motion.smoother.linearise import mean_square
from hapticplayer.motion.smoother.parameters import SmootherParameters

# The model's variance is found exactly at nodes this far apart.
_EVERY_S = 20.0
_AT_LEAST = 5
# Intervals whose tilt is less certain than the usual one by this factor, and at most
# how many of them are looked at one by one.
_HOLE, _HOLES = 0.02, 50
_FLOOR_RAD = 0.004
# Share of the model's deviation for noise, which the smoother assumes too large, but
# not that of a hole.
_NOISE = 0.27
# Share of the deviation that is assumed of the accelerometer's bias, and from which bias
# of the gyro on it grows.
_BIAS, _CALIBRATED_RADPS = 0.1, 0.006
# Share of the way that the vertical moves, and the same.
_MOVED, _ROUGH_RADPS = 0.75, 0.03
# The bound of what drives is tightened beyond the velocity found by so much; less tells
# too little of the few rides that go wrong. The noise is that of a bound halfway to one
# that goes with that velocity, by the logarithm.
_BEYOND = 1.85


@dataclass(frozen=True, slots=True, eq=False)
class Wide:
    """How much wider a bound is than one that goes with the velocity found.

    Attributes:
        excess: (K + 1,) 1 where it is not.
        driven: share of a vehicle.
    """

    excess: Floats
    driven: float = 0.0


def tilt_variance(
    problem: Problem,
    solution: Solution,
    gyro_bias_radps: Floats,
    wide: Wide,
    p: SmootherParameters,
) -> Floats:
    """Return the variance of both tilts together at the nodes (K + 1,), rad^2.

    Args:
        problem: the last one.
        solution: of it.
        gyro_bias_radps: (3,) that was found, in all.
        wide: how much wider the bound is than the velocity found asks for.
        p: of the smoother.
    """
    squared = min(float(np.square(gyro_bias_radps).sum()), p.gyro_bias_radps**2)
    doubt = _BIAS**2 * (1.0 + squared / _CALIBRATED_RADPS**2)
    factor = p.velocity_factor * wide.excess * _BEYOND**wide.driven
    other = minimise(tighter(problem, solution, factor)).tilt
    moved = mean_square(other - solution.tilt, problem.duration_s, p.local_s)
    close = problem
    if wide.driven:
        close = replace(problem, bound_weight=problem.bound_weight * wide.excess)
    share = _MOVED**2 * (1.0 + squared / _ROUGH_RADPS**2)
    holes = holes_of(problem)
    noise = noise_variance(close, holes)
    known = np.full(len(noise), 2.0 * _NOISE**2)
    known[holes] = known[holes + 1] = 2.0
    return np.asarray(
        known * noise
        + doubt * force_bias_variance(problem, solution)
        + share * moved
        + _FLOOR_RAD**2
    )


def force_bias_variance(problem: Problem, solution: Solution) -> Floats:
    """Return the variance of both tilts by the accelerometer's bias, (K + 1,).

    A bias that is not where it is expected pulls the calibration away by the part that
    the expectation has in it: for the deviation that is assumed, by `pulled`.
    """
    weight = problem.prior_weight[FORCE_BIAS]
    expected = np.zeros((len(solution.factor), 3))
    np.fill_diagonal(expected[FORCE_BIAS], np.sqrt(weight))
    pulled = solution.per_information(expected)
    # x and y of the tilt of each node, by the three of the bias
    columns = solution.states[:, 1 : 1 + len(pulled)]
    moved = columns.dot(pulled).reshape(-1, 12)[:, :6]
    return np.asarray(np.vecdot(moved, moved))


def noise_variance(problem: Problem, holes: NDArray[np.intp]) -> Floats:
    """Return the variance of one tilt for a known calibration, (K + 1,).

    Args:
        problem: the block.
        holes: of it, see `holes_of`.
    """
    count = len(problem.duration_s) + 1
    number = max(_AT_LEAST, round(float(problem.duration_s.sum()) / _EVERY_S))
    number = min(number, count)
    even = np.rint(np.arange(number) * ((count - 1) / max(1, number - 1))).astype(int)
    # holes are looked at where they are
    chosen = even
    if len(holes):
        holes = holes[:: max(1, len(holes) // _HOLES)]
        near = (holes[:, None] + np.arange(-2, 4)).ravel().clip(0, count - 1)
        chosen = np.unique(np.concatenate([even, near]))
    found = np.log(tilt_variances(problem, chosen))
    return np.asarray(np.exp(np.interp(np.arange(count), chosen, found)))


def holes_of(problem: Problem) -> NDArray[np.intp]:
    """Return the intervals whose tilt is far less certain than that of the usual."""
    weight = problem.tilt_weight
    if weight.min() >= _HOLE * weight.max():
        return np.empty(0, np.intp)
    return np.flatnonzero(weight < _HOLE * np.median(weight))
