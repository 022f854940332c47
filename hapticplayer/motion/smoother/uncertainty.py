"""The standard deviation of the smoothed vertical.

Parts added in square: the model's noise for a known calibration; what the
accelerometer's bias does where the motion does not show it and it is taken for tilt;
how far the vertical moves when the velocity is bounded as tightly as it was found
(the bound is `velocity_factor` times wider, or more for a vehicle), large where the
bound, and not the sensor, separates tilt from acceleration; turns within a reading; and
a floor. Where the plain estimate is preferred, its own variance is used (`short_memory`).

The second and the third grow with the gyro's bias, the one error that every motion
shows: an uncalibrated gyro comes with an uncalibrated accelerometer. Beyond the prior
sigma of the bias they do not grow. The shares were chosen by the coverage of
`benchmarks.motion accuracy` (recordings with optical truth, simulated rides); the
model's noises are those of the least error, not those that describe it best.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother.least_squares import (
    ACCEL_BIAS,
    Problem,
    Solution,
    minimise,
    tilt_variances,
    with_tighter_bound,
)
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.problem import mean_square, velocity_bound
from hapticplayer.motion.smoother.state import Block, BlockState
from hapticplayer.motion.smoother.vehicle import Locomotion

# The model's variance is found at nodes this far apart, of so many at the least.
VARIANCE_NODE_SPACING_S, MIN_VARIANCE_NODES = 20.0, 5
# Intervals whose tilt weight is below this share of the median are gaps; so many of
# them are looked at one by one.
GAP_TILT_WEIGHT_SHARE, MAX_EXAMINED_GAPS = 0.02, 50
# Half and twice of it leave 0.926 and 0.987 of the samples within 2 sigma, in place of
# 0.965.
TILT_SIGMA_FLOOR_RAD = 0.004
# Share of the model's deviation for noise, which the smoother assumes too large
# (not that of a gap); half and twice of it: 0.953 and 0.977.
NOISE_SIGMA_SHARE = 0.27
# Share of the prior sigma of the accelerometer's bias, and from which gyro bias it grows.
ACCEL_BIAS_SIGMA_SHARE, CALIBRATED_GYRO_BIAS_RADPS = 0.1, 0.006
# Share of the way that the vertical moves (half and twice of it: 0.926 and 0.981), and
# the same.
BOUND_SHIFT_SHARE, ROUGH_GYRO_BIAS_RADPS = 0.75, 0.03
# A vehicle's bound is tightened beyond the velocity found by this factor; lower values
# underestimate outliers.
VEHICLE_BOUND_TIGHTENING_RATIO = 1.85

# Error of the vertical per turn within a sample: half and twice of it leave 0.960 and
# 0.971 of the samples within 2 sigma in place of 0.965.
TILT_ERROR_PER_SAMPLE_TURN = 0.04


@dataclass(frozen=True, slots=True, eq=False)
class BoundExcess:
    """By how much a bound is wider than one for the velocity found.

    Attributes:
        factor: (K + 1,) at least 1.
        vehicle_weight: 0 to 1.
    """

    factor: Floats
    vehicle_weight: float = 0.0


def tilt_variance(
    problem: Problem,
    solution: Solution,
    gyro_bias_radps: Floats,
    excess: BoundExcess,
    p: SmootherParameters,
) -> Floats:
    """Return the variance of both tilts together at the nodes (K + 1,), rad^2.

    Args:
        problem: the last one.
        solution: of it.
        gyro_bias_radps: (3,) found, in all.
        excess: of the velocity bound.
        p: of the smoother.
    """
    squared = float(np.square(gyro_bias_radps).sum())
    squared = min(squared, p.gyro_bias_sigma_radps**2)
    bias_share = ACCEL_BIAS_SIGMA_SHARE**2 * (
        1.0 + squared / CALIBRATED_GYRO_BIAS_RADPS**2
    )
    bound_share = BOUND_SHIFT_SHARE**2 * (1.0 + squared / ROUGH_GYRO_BIAS_RADPS**2)
    tightening = VEHICLE_BOUND_TIGHTENING_RATIO**excess.vehicle_weight
    factor = p.velocity_factor * excess.factor * tightening
    other = minimise(with_tighter_bound(problem, solution, factor)).tilt
    moved = mean_square(other - solution.tilt, problem.duration_s, p.bound_half_width_s)
    if excess.vehicle_weight:
        # the noise of a bound halfway to that of the velocity found
        bound_weight = problem.bound_weight * excess.factor
        problem = replace(problem, bound_weight=bound_weight)
    gaps = gaps_of(problem)
    noise = noise_variance(problem, gaps)
    shares = np.full(len(noise), 2.0 * NOISE_SIGMA_SHARE**2)
    shares[gaps] = shares[gaps + 1] = 2.0
    return np.asarray(
        shares * noise
        + bias_share * accel_bias_variance(problem, solution)
        + bound_share * moved
        + TILT_SIGMA_FLOOR_RAD**2
    )


def accel_bias_variance(problem: Problem, solution: Solution) -> Floats:
    """Return the variance of both tilts by the accelerometer's bias, (K + 1,).

    A bias that is off its prior by one sigma moves the calibration by a column of
    `pulled`.
    """
    weight = problem.prior_weight[ACCEL_BIAS]
    off = np.zeros((len(solution.calibration), 3))
    np.fill_diagonal(off[ACCEL_BIAS], np.sqrt(weight))
    pulled = solution.covariance_times(off)
    tilts = solution.states[1 : 1 + len(pulled), ..., 0]
    moved = pulled.T @ tilts.reshape(len(pulled), -1)
    return np.asarray(np.square(moved).reshape(6, -1).sum(axis=0))


def noise_variance(problem: Problem, gaps: NDArray[np.intp]) -> Floats:
    """Return the variance of one tilt for a known calibration, (K + 1,).

    Args:
        problem: the block.
        gaps: of it, see `gaps_of`.
    """
    count = len(problem.duration_s) + 1
    wanted = max(
        MIN_VARIANCE_NODES,
        round(float(problem.duration_s.sum()) / VARIANCE_NODE_SPACING_S),
    )
    chosen = np.linspace(0, count - 1, min(wanted, count)).round().astype(np.intp)
    if len(gaps):
        gaps = gaps[:: max(1, len(gaps) // MAX_EXAMINED_GAPS)]
        near = (gaps[:, None] + np.arange(-2, 4)).ravel().clip(0, count - 1)
        chosen = np.unique(np.concatenate([chosen, near]))
    found = np.log(tilt_variances(problem, chosen))
    return np.asarray(np.exp(np.interp(np.arange(count), chosen, found)))


def gaps_of(problem: Problem) -> NDArray[np.intp]:
    """Return the intervals whose tilt has far less weight than usual."""
    weight = problem.tilt_weight
    if weight.min() >= GAP_TILT_WEIGHT_SHARE * weight.max():
        return np.empty(0, np.intp)
    return np.flatnonzero(weight < GAP_TILT_WEIGHT_SHARE * np.median(weight))


def sigma_rad(
    block: Block, state: BlockState, gyro_bias_radps: Floats, tilt: Floats
) -> Floats:
    """Return the standard deviation of the tilt at each sample, both axes together.

    Args:
        block: the block.
        state: the last one.
        gyro_bias_radps: (3,) found, in all.
        tilt: (2, K + 1) of the smoother after levelling at rest, without the floor.
    """
    if state.mixture is not None:
        variance = state.mixture.variance + TILT_SIGMA_FLOOR_RAD**2
    else:
        excess = _excess(state, block.p)
        variance = tilt_variance(
            state.problem, state.solution, gyro_bias_radps, excess, block.p
        )
    per_node = block.samples_per_node
    turn_rad = state.integration.nodes.turned_rad / per_node
    variance += _turning_variance(turn_rad, block.samples.held())
    # at rest the accelerometer's bias is taken for tilt, so that nothing is felt
    variance += rot.squared_norm(tilt - state.solution.tilt)
    if state.floor is not None:
        variance = state.floor.mixed(variance, state.floor.variance)
    # two unrelated directions are 90 degrees apart
    sigma = np.sqrt(np.minimum(variance, 2.0))
    share = np.arange(per_node) / per_node
    at_samples = sigma[:-1, None] + share * np.diff(sigma)[:, None]
    return np.asarray(at_samples.reshape(-1)[: len(block.samples)])


def _excess(state: BlockState, p: SmootherParameters) -> BoundExcess:
    """Return by how much the bound is wider than one for the velocity found."""
    bound_mps, velocity_mps = state.known.bound_mps, state.solution.velocity_mps
    if not state.motion.moving_weight:
        return BoundExcess(np.ones_like(bound_mps))
    duration_s = state.problem.duration_s
    found_mps = velocity_bound(velocity_mps, duration_s, Locomotion(), p)
    factor = np.maximum(bound_mps / found_mps, 1.0)
    return BoundExcess(factor, state.motion.vehicle_weight)


def _turning_variance(turn_rad: Floats, held: float) -> Floats:
    """Return the variance by turns (K,) within a reading, at the nodes, rad^2.

    Args:
        turn_rad: (K,) per sample.
        held: samples that repeat a reading; they are late by half of it.
    """
    at = np.empty(len(turn_rad) + 1)
    at[0], at[-1] = turn_rad[0], turn_rad[-1]
    at[1:-1] = 0.5 * (turn_rad[1:] + turn_rad[:-1])
    late = 0.5 * (held - 1.0)
    return np.asarray((TILT_ERROR_PER_SAMPLE_TURN**2 + late**2) * np.square(at))
