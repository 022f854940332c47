"""The nodes of a block as a least-squares problem about a vertical."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.least_squares import (
    ACCEL_BIAS,
    ACCEL_SCALE,
    ALL_COLUMNS,
    BIAS_COLUMNS,
    GYRO_BIAS,
    GYRO_MATRIX,
    GYRO_SCALE,
    Problem,
)
from hapticplayer.motion.smoother.nodes import Nodes
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.vehicle import (
    BODY_VELOCITY_COLUMNS,
    Locomotion,
    with_body_velocity,
)

# Sigmas of the specific force where it is in doubt, and of the rate where it is lost.
DOUBTFUL_ACCEL_SIGMA_MPS2, LOST_RATE_SIGMA_RADPS = 5.0, 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Knowledge:
    """What is known before a solution.

    Attributes:
        bound_mps: (K + 1,) of the velocity.
        zero_velocity_weight: (K,) see Problem.
        applied: (C,) calibration that the nodes were integrated with.
        bias_radps: (3,) expected gyro bias, in all.
        bias_sigma_radps: (3,) its prior sigma.
        gyro_scale_sigma: prior sigma of the gyro's scale.
        has_body_velocity: whether there are columns for a vehicle's velocity.
        body_sigma_mps: prior sigma of that; 0 for none.
    """

    bound_mps: Floats
    zero_velocity_weight: Floats
    applied: Floats
    bias_radps: Floats
    bias_sigma_radps: Floats
    gyro_scale_sigma: float
    has_body_velocity: bool
    body_sigma_mps: float


def linearised(
    nodes: Nodes,
    vertical: Floats,
    frames: Pair,
    known: Knowledge,
    p: SmootherParameters,
) -> Problem:
    """Return the problem about verticals (3, K + 1) and level frames at the nodes."""
    duration_s, columns = nodes.duration_s, 1 + len(known.applied)
    total = columns + BODY_VELOCITY_COLUMNS * known.has_body_velocity
    tilt = np.zeros((total, 2, len(duration_s)))
    impulse = np.zeros((total, 3, len(duration_s)))
    C = rot.matrices((frames[0][:-1], frames[1][:-1]))
    # a rotation w of frame I moves the vertical z by w x z = (w_y, -w_x)
    tilt[0] = rot.rotate((frames[0][1:], frames[1][1:]), vertical[:, :-1])[:2]
    turn = np.einsum("ijn,jqn->qin", C, nodes.bias_turn_s)
    by_bias = tilt[1:][GYRO_BIAS]
    by_bias[:, 0], by_bias[:, 1] = turn[:, 1], -turn[:, 0]
    if columns > 1 + BIAS_COLUMNS:
        turned = np.einsum("ijn,jqn->qin", C[:2], nodes.matrix_turn_rad)
        by_matrix = tilt[1:][GYRO_MATRIX]
        by_matrix[:, 0], by_matrix[:, 1] = turned[:, 1], -turned[:, 0]
    impulse[0] = np.einsum("ijn,jn->in", C, nodes.impulse_mps)
    impulse[1 + ACCEL_SCALE] = -impulse[0]
    impulse[0, 2] -= STANDARD_GRAVITY_MPS2 * duration_s
    impulse[1:][ACCEL_BIAS] = -turn
    if known.has_body_velocity:
        attitude = rot.matrices(rot.multiply(frames, nodes.at))
        change = attitude[..., 1:] - attitude[..., :-1]
        impulse[columns:] = -change.swapaxes(0, 1)
    prior, prior_weight = _prior(known, p)
    return Problem(
        duration_s=duration_s,
        tilt=tilt,
        impulse=impulse,
        tilt_weight=1.0 / _tilt_noise(nodes, p),
        velocity_weight=1.0 / _velocity_noise(nodes, known.bound_mps, p),
        bound_weight=_around(duration_s) / (2.0 * known.bound_mps**2),
        zero_velocity_weight=known.zero_velocity_weight,
        prior=prior,
        prior_weight=prior_weight,
    )


def velocity_bound(
    velocity_mps: Floats, duration_s: Floats, motion: Locomotion, p: SmootherParameters
) -> Floats:
    """Return the bound on the velocity at each node (K + 1,), from that found.

    Args:
        velocity_mps: (2, K + 1) in the last solution.
        duration_s: (K,) between the nodes.
        motion: how the sensor moves along.
        p: settings.
    """
    squared = mean_square(velocity_mps, duration_s, p.bound_half_width_s)
    squared *= 0.5 * p.velocity_factor**2
    squared += p.velocity_floor_mps**2
    return motion.bound_mps(np.sqrt(squared))


def mean_square(vectors: Floats, duration_s: Floats, half_width_s: float) -> Floats:
    """Return the mean of squared norms over the nodes within some time of each.

    Args:
        vectors: (2, K + 1) at the nodes.
        duration_s: (K,) between them.
        half_width_s: of the mean.

    Returns:
        (K + 1,).
    """
    weight = _around(duration_s)
    sums = np.zeros((3, len(weight) + 1))
    sums[0, 1:-1] = duration_s
    sums[1, 1:] = weight * rot.squared_norm(vectors)
    sums[2, 1:] = weight
    time_s, total, length = np.cumsum(sums, axis=1)
    time_s = time_s[:-1]
    first = np.searchsorted(time_s, time_s - half_width_s)
    last = np.searchsorted(time_s, time_s + half_width_s, side="right")
    return np.asarray((total[last] - total[first]) / (length[last] - length[first]))


def _around(duration_s: Floats) -> Floats:
    """Return half of the intervals at both sides of each node."""
    at = np.zeros(len(duration_s) + 1)
    at[:-1] = 0.5 * duration_s
    at[1:] += 0.5 * duration_s
    return at


def _prior(known: Knowledge, p: SmootherParameters) -> tuple[Floats, Floats]:
    """Return the expected calibration and 1 / variance of it, (C,)."""
    prior = -known.applied
    accelerometer, accelerometer_sigma = p.accelerometer_prior()
    prior[ACCEL_BIAS], prior[ACCEL_SCALE] = accelerometer[:3], accelerometer[3]
    prior[GYRO_BIAS] += known.bias_radps
    sigma = np.empty(ALL_COLUMNS)
    sigma[GYRO_BIAS], sigma[GYRO_MATRIX] = known.bias_sigma_radps, p.gyro_matrix_sigma
    sigma[GYRO_SCALE] = known.gyro_scale_sigma
    sigma[ACCEL_BIAS], sigma[ACCEL_SCALE] = (
        accelerometer_sigma[:3],
        accelerometer_sigma[3],
    )
    weight = sigma[: len(prior)] ** -2.0
    if not known.body_sigma_mps:
        return prior, weight
    return with_body_velocity(prior, weight, known.body_sigma_mps)


def _tilt_noise(nodes: Nodes, p: SmootherParameters) -> Floats:
    """Return the variance of the tilt's change from node to node, rad^2."""
    return np.asarray(
        p.rate_noise_rad_per_sqrt_s**2 * nodes.duration_s
        + (p.rotation_error * nodes.turned_rad) ** 2
        + (LOST_RATE_SIGMA_RADPS * nodes.lost_s) ** 2
    )


def _velocity_noise(nodes: Nodes, bound_mps: Floats, p: SmootherParameters) -> Floats:
    """Return the variance of the velocity's change from node to node, (m/s)^2."""
    doubt = (DOUBTFUL_ACCEL_SIGMA_MPS2 * nodes.doubt_s) ** 2
    # a velocity that is bounded on both sides of a gap changes no more than this
    doubt = np.minimum(doubt, bound_mps[1:] ** 2 + bound_mps[:-1] ** 2)
    return np.asarray(
        p.accel_noise_mps_per_sqrt_s**2 * nodes.duration_s
        + p.accel_error**2 * nodes.power_m2ps3 * nodes.duration_s
        + doubt
    )
