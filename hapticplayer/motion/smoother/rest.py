"""What standing still says, and how far it is believed.

Over a still span the velocity does not change. But what passes for one may be a
smooth, steady acceleration, so that each interval is believed the less the more it
seems to be accelerated in the solution so far (iteratively reweighted, as with
Cauchy's distribution): true rest draws the solution to itself from one to the next,
false rest lets go of it.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother.calibrated import Problem, Solution
from hapticplayer.motion.smoother.parameters import SmootherParameters

# An interval rests if as much of it does; bins and nodes never quite agree.
_ALL = 0.99
# A bias of so many deviations was not expected, and by how much more to expect then.
_FAR, _WIDE = 2.0, 4.0
# No accelerometer has a bias beyond this (data sheets: 0.25 g at the worst axis).
_BIAS_MPS2 = 2.5
# So much may be left at rest; nobody feels it.
_LEFT_MPS2 = 0.03
# For so long what moves a resting sensor unseen stays the same.
_STEADY_S = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Rest:
    """Where the sensor of a block stands still, and what its gyro reads there.

    Attributes:
        at: (n + 1,) edges of the bins, in samples of the block.
        count: (n + 1,) still samples up to there.
        mean_radps: (3,).
        sigma_radps: standard deviation of the mean, by its scatter.
    """

    at: Floats
    count: Floats
    mean_radps: Floats
    sigma_radps: float


def resting(rest: Rest, edges: NDArray[np.intp]) -> NDArray[np.bool_]:
    """Return which intervals between samples (K + 1,) lie in still spans, (K,)."""
    still = np.interp(edges, rest.at, rest.count)
    return np.asarray(still[1:] - still[:-1] > _ALL * (edges[1:] - edges[:-1]))


def rest_weight(
    still: NDArray[np.bool_],
    duration_s: Floats,
    seems_mps2: Floats,
    p: SmootherParameters,
) -> Floats:
    """Return 1 / variance of the change of velocity in each interval, (m/s)^-2.

    Args:
        still: (K,) from `resting`.
        duration_s: (K,).
        seems_mps2: (K,) acceleration in the last solution.
        p: of the smoother.
    """
    squared = p.rest_mps2**2 + seems_mps2 * seems_mps2
    return np.asarray(still / (squared * _STEADY_S * np.maximum(duration_s, 1e-9)))


def seeming_acceleration(
    solution: Solution, solved_s: Floats, duration_s: Floats
) -> Floats:
    """Return how fast the velocity found changes in each interval, (K,) m/s^2.

    Args:
        solution: the last one.
        solved_s: (n,) intervals that it was found for.
        duration_s: (K,) intervals that are asked for, mostly the same array.
    """
    change = solution.velocity_mps[:, 1:] - solution.velocity_mps[:, :-1]
    size = np.sqrt(rot.squared_norm(change)) / np.maximum(solved_s, 1e-9)
    if duration_s is solved_s:
        return np.asarray(size)
    middle_s = np.cumsum(duration_s) - 0.5 * duration_s
    return np.asarray(np.interp(middle_s, np.cumsum(solved_s) - 0.5 * solved_s, size))


def expected_bias(rest: Rest | None, p: SmootherParameters) -> tuple[Floats, float]:
    """Return the gyro's bias before the motion is looked at, and its deviation."""
    if rest is None:
        return np.zeros(3), p.gyro_bias_radps
    sigma = math.hypot(p.still_bias_radps, p.still_scatter * rest.sigma_radps)
    return rest.mean_radps, min(sigma, p.gyro_bias_radps)


def widened(rest: Rest | None, found_radps: Floats, p: SmootherParameters) -> float:
    """Return the deviation of the gyro's bias once the motion has been looked at.

    Without rest a bias far beyond what was expected is pulled towards zero by that,
    and is more than is found.

    Args:
        rest: where the sensor stands still, or None.
        found_radps: (3,) the bias in the last solution.
        p: of the smoother.
    """
    sigma = expected_bias(rest, p)[1]
    far = rest is None and math.hypot(*found_radps) > _FAR * sigma
    return _WIDE * sigma if far else sigma


def settled(problem: Problem, solution: Solution, still: NDArray[np.bool_]) -> Floats:
    """Return the tilt with hardly anything left of the specific force at rest.

    What is left there is the accelerometer's bias for this attitude, and would be felt
    as a steady pull.

    Args:
        problem: the last one.
        solution: of it.
        still: (K,) intervals at rest.

    Returns:
        (2, K + 1).
    """
    tilt = solution.tilt
    if not still.any():
        return tilt
    weight_mps = still * STANDARD_GRAVITY_MPS2 * problem.duration_s
    pushed = still * problem.impulse[:2, 0]
    # frame I turns by what was found of the gyro since it was integrated: halfway
    # through the interval it is half as far as at its end, in that node's frame
    turned = (problem.rows[:, :2, 1:] @ solution.calibration).T
    to_end = problem.tilt[:, 0] + 0.5 * turned
    # at an edge of a still span only one side of the node has a say
    span_mps = np.zeros(tilt.shape[1])
    level = np.zeros_like(tilt)
    for side, moved in (slice(1, None), to_end), (slice(None, -1), -0.5 * turned):
        span_mps[side] += weight_mps
        level[:, side] += pushed + weight_mps * moved
    inside = span_mps > 0.0
    shift = np.where(inside, level / np.where(inside, span_mps, 1.0) - tilt, 0.0)
    size = STANDARD_GRAVITY_MPS2 * np.sqrt(rot.squared_norm(shift))
    part = np.maximum(1.0 - _LEFT_MPS2 / np.maximum(size, 1e-9), 0.0)
    return np.asarray(tilt + np.where(size < _BIAS_MPS2, part, 0.0) * shift)
