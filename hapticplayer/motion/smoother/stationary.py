"""Zero-velocity intervals, and recordings that are stationary throughout.

Over a zero-velocity interval the velocity does not change. But what looks still may
be a smooth, steady acceleration, so the weight of an interval falls with the
acceleration that the last solution found there (iteratively reweighted least squares
with Cauchy's weights).
"""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import fused
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother.least_squares import Problem, Solution
from hapticplayer.motion.smoother.parameters import SmootherParameters

Flags = NDArray[np.bool_]

# An interval is still if this share of it is; bins and nodes never quite agree. Half
# of it costs 1.5 %, no still interval 6 %.
MIN_STILL_SHARE = 0.99
# From so many sigmas on a bias is an outlier (half of it costs 5 %); by what to widen
# its prior then.
BIAS_OUTLIER_SIGMAS, WIDE_BIAS_SIGMA_FACTOR = 2.0, 4.0
# No accelerometer has a larger bias (data sheets: 0.25 g at the worst axis).
MAX_ACCEL_BIAS_MPS2 = 2.5
# What may be left at rest, below the leak of 0.05 m/s^2 that docs/numerics.md allows.
REST_ACCEL_TOLERANCE_MPS2 = 0.03
# Correlation time of unseen accelerations of a sensor at rest; twice as much costs 1 %.
REST_ACCEL_CORRELATION_S = 1.0
# Stationary recordings are decimated to this rate, that of the windows, from so many
# samples on.
STATIONARY_RATE_HZ, MIN_STATIONARY_SAMPLES = 16.0, 100


@dataclass(frozen=True, slots=True, eq=False)
class StillBins:
    """Where the sensor of a block is still, and what its gyro reads there.

    Attributes:
        edges: (n + 1,) of the bins, in samples of the block.
        still: (n + 1,) still samples up to there.
        rate_radps: (3,) mean.
        rate_sigma_radps: of the mean, by its scatter.
    """

    edges: Floats
    still: Floats
    rate_radps: Floats
    rate_sigma_radps: float

    def decimated(self, factor: int, count: int) -> "StillBins":
        """Return the same for means over `factor` of `count` samples.

        A last mean of fewer samples counts in full.
        """
        edges, still = self.edges / factor, self.still / factor
        missing = -(-count // factor) - edges[-1]
        if missing <= 1.0:
            edges[-1] += missing
            still[-1] += missing
        return replace(self, edges=edges, still=still)


def still_intervals(bins: StillBins, edges: NDArray[np.intp]) -> Flags:
    """Return which intervals between samples (K + 1,) are still, (K,)."""
    still = np.diff(np.interp(edges, bins.edges, bins.still))
    return np.asarray(still > MIN_STILL_SHARE * np.diff(edges))


def zero_velocity_weight(
    still: Flags, duration_s: Floats, apparent_mps2: Floats, p: SmootherParameters
) -> Floats:
    """Return 1 / variance of the change of velocity in each interval, (m/s)^-2.

    Args:
        still: (K,) from `still_intervals`.
        duration_s: (K,).
        apparent_mps2: (K,) acceleration in the last solution.
        p: of the smoother.
    """
    squared = p.still_accel_mps2**2 + apparent_mps2 * apparent_mps2
    return np.asarray(
        still / (squared * REST_ACCEL_CORRELATION_S * np.maximum(duration_s, 1e-9))
    )


def apparent_acceleration(
    velocity_mps: Floats, solved_s: Floats, duration_s: Floats
) -> Floats:
    """Return how fast the velocity found changes in each interval, (K,) m/s^2.

    Args:
        velocity_mps: (2, n + 1) of the last solution.
        solved_s: (n,) its intervals.
        duration_s: (K,) intervals that are asked for, mostly the same array.
    """
    change = np.diff(velocity_mps)
    size = np.sqrt(rot.squared_norm(change)) / np.maximum(solved_s, 1e-9)
    if duration_s is solved_s:
        return np.asarray(size)
    middle_s = np.cumsum(duration_s) - 0.5 * duration_s
    return np.asarray(np.interp(middle_s, np.cumsum(solved_s) - 0.5 * solved_s, size))


def gyro_bias_prior(
    bins: StillBins | None, p: SmootherParameters
) -> tuple[Floats, Floats]:
    """Return the expected gyro bias (3,) and its prior sigma (3,), rad/s."""
    known_radps, known_sigma_radps = p.gyro_bias_prior()
    if bins is None:
        return known_radps, known_sigma_radps
    sigma = math.hypot(
        p.still_bias_sigma_radps, p.still_sigma_factor * bins.rate_sigma_radps
    )
    still_sigma_radps = np.full(3, min(sigma, p.gyro_bias_sigma_radps))
    if p.calibration is None:
        return bins.rate_radps, still_sigma_radps
    return fused(bins.rate_radps, still_sigma_radps, known_radps, known_sigma_radps)


def widened_bias_sigma(
    bins: StillBins | None, found_radps: Floats, p: SmootherParameters
) -> Floats:
    """Return the prior sigma of the gyro's bias (3,), given the bias (3,) found.

    Without still bins an outlier is pulled towards its prior, so that the bias is
    farther off than what was found.
    """
    expected, sigma = gyro_bias_prior(bins, p)
    if (
        bins is not None
        or _norm((found_radps - expected) / sigma) < BIAS_OUTLIER_SIGMAS
    ):
        return sigma
    return np.maximum(WIDE_BIAS_SIGMA_FACTOR * sigma, p.gyro_bias_sigma_radps)


def _norm(vector: Floats) -> float:
    return math.hypot(*vector)


def levelled_at_rest(problem: Problem, solution: Solution, still: Flags) -> Floats:
    """Return the tilt (2, K + 1) with hardly anything left of the force at rest.

    What is left there is the accelerometer's bias for this attitude, and would be felt
    as a steady force.

    Args:
        problem: the last one.
        solution: of it.
        still: (K,) intervals at rest.
    """
    tilt = solution.tilt
    if not still.any():
        return tilt
    weight_mps = still * STANDARD_GRAVITY_MPS2 * problem.duration_s
    pushed = still * problem.impulse[0, :2]
    # frame I turns by the gyro calibration found since it was integrated: in the
    # middle of the interval by half of that at its end, in that node's frame
    columns = slice(1, 1 + len(solution.calibration))
    turned = np.tensordot(solution.calibration, problem.tilt[columns], 1)
    to_end = problem.tilt[0] + 0.5 * turned
    # at an edge of a still span only one side of the node counts
    span_mps = np.zeros(tilt.shape[1])
    level = np.zeros_like(tilt)
    for side, moved in (slice(1, None), to_end), (slice(None, -1), -0.5 * turned):
        span_mps[side] += weight_mps
        level[:, side] += pushed + weight_mps * moved
    inside = span_mps > 0.0
    shift = np.where(inside, level / np.where(inside, span_mps, 1.0) - tilt, 0.0)
    size = STANDARD_GRAVITY_MPS2 * np.sqrt(rot.squared_norm(shift))
    part = np.maximum(1.0 - REST_ACCEL_TOLERANCE_MPS2 / np.maximum(size, 1e-9), 0.0)
    return np.asarray(tilt + np.where(size < MAX_ACCEL_BIAS_MPS2, part, 0.0) * shift)


def decimation_of(bins: StillBins | None, count: int, interval_s: float) -> int:
    """Return by how much to decimate a block, 1 where anything moves.

    Args:
        bins: where the block is still, or None.
        count: samples of it.
        interval_s: of a sample.
    """
    if bins is None or bins.still[-1] < bins.edges[-1] - bins.edges[0]:
        return 1
    factor = max(1, round(1.0 / (STATIONARY_RATE_HZ * interval_s)))
    return factor if count >= MIN_STATIONARY_SAMPLES * factor else 1


def interpolated(values: Floats, factor: int, count: int, *, averaged: bool) -> Floats:
    """Return means over `factor` samples (m, columns) at `count` samples, linearly.

    Args:
        values: one row for the middle of each part.
        factor: samples of a part; the last may be shorter.
        count: samples.
        averaged: whether a sample stands for its middle, else for its end.
    """
    place = (np.arange(count) + (0.5 if averaged else 1.0)) / factor - 0.5
    rows = np.arange(len(values))
    return np.stack([np.interp(place, rows, one) for one in values.T], axis=1)


def with_one_sign(quaternion: Floats) -> Floats:
    """Return quaternions (m, 4) of one sign each with the one before."""
    flips = np.sum(quaternion[1:] * quaternion[:-1], axis=1) < 0.0
    sign = np.where(np.append(0, np.cumsum(flips)) % 2, -1.0, 1.0)
    return sign[:, None] * quaternion
