"""The nodes of a block as a least-squares problem about a vertical."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.calibrated import (
    BIASES_ONLY,
    CALIBRATION,
    FORCE_BIAS,
    FORCE_SCALE,
    GYRO_BIAS,
    GYRO_MATRIX,
    Problem,
    Solution,
)
from hapticplayer.motion.smoother.nodes import Nodes
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.travel import Travel, travel_prior, with_travel

# A sample whose specific force is in doubt may be wrong by as much.
DOUBTFUL_MPS2 = 5.0
# Where the rotation is not known it may be this fast.
LOST_RADPS = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Knowledge:
    """What is known before a solution.

    Attributes:
        bound_mps: (K + 1,) how large the velocity may be.
        rest_weight: (K,) see Problem.
        applied: (C,) calibration that is in the nodes already.
        bias_radps: (3,) where the gyro's bias is expected, in all.
        bias_sigma_radps: how well.
        may_travel: whether there are columns for `travel`.
        travel_sigma_mps: see there; 0 where nothing is expected of them.
    """

    bound_mps: Floats
    rest_weight: Floats
    applied: Floats
    bias_radps: Floats
    bias_sigma_radps: float
    may_travel: bool
    travel_sigma_mps: float


def linearised(
    nodes: Nodes,
    vertical: Floats,
    frames: Pair,
    known: Knowledge,
    p: SmootherParameters,
) -> Problem:
    """Return the problem about verticals (3, K + 1) and level frames at the nodes."""
    duration_s, columns = nodes.duration_s, len(known.applied)
    C = rot.matrices((frames[0][:-1], frames[1][:-1]))
    turn = np.einsum("ijn,jkn->ikn", C, nodes.bias_turn_s)
    rows = np.zeros((len(duration_s), 5, 1 + columns))
    tilt, impulse = rows[:, :2].transpose(1, 2, 0), rows[:, 2:].transpose(1, 2, 0)
    carried = rot.rotate((frames[0][1:], frames[1][1:]), vertical[:, :-1])
    tilt[:, 0] = carried[:2]
    # a rotation w of frame I moves the vertical z by w x z = (w_y, -w_x)
    by = tilt[:, 1:]
    by[0, GYRO_BIAS], by[1, GYRO_BIAS] = turn[1], -turn[0]
    if columns > BIASES_ONLY:
        scale = np.einsum("ijn,jqn->iqn", C[:2], nodes.scale_turn_rad)
        by[0, GYRO_MATRIX], by[1, GYRO_MATRIX] = scale[1], -scale[0]
    impulse[:, 0] = np.einsum("ijn,jn->in", C, nodes.impulse_mps)
    impulse[:, 1 + FORCE_SCALE] = -impulse[:, 0]
    impulse[2, 0] -= STANDARD_GRAVITY_MPS2 * duration_s
    impulse[:, 1:][:, FORCE_BIAS] = -turn
    prior, prior_weight = expected(known, p)
    if known.may_travel:
        rows = with_travel(rows, nodes, frames)
    return Problem(
        duration_s=duration_s,
        rows=rows,
        tilt_weight=1.0 / _tilt_noise(nodes, p),
        velocity_weight=1.0 / _velocity_noise(nodes, known.bound_mps, p),
        bound_weight=around(duration_s) / (2.0 * known.bound_mps**2),
        rest_weight=known.rest_weight,
        prior=prior,
        prior_weight=prior_weight,
    )


def expected(known: Knowledge, p: SmootherParameters) -> tuple[Floats, Floats]:
    """Return where the calibration is expected, and 1 / variance of that, (C,)."""
    prior = -known.applied
    prior[FORCE_BIAS] = prior[FORCE_SCALE] = 0.0
    prior[GYRO_BIAS] += known.bias_radps
    sigma = np.empty(CALIBRATION)
    sigma[GYRO_BIAS], sigma[GYRO_MATRIX] = known.bias_sigma_radps, p.gyro_matrix
    sigma[FORCE_BIAS], sigma[FORCE_SCALE] = p.accelerometer_bias_mps2, p.force_scale
    weight = sigma[: len(prior)] ** -2.0
    if not known.travel_sigma_mps:
        return prior, weight
    return travel_prior(prior, weight, known.travel_sigma_mps)


def velocity_bound(
    solution: Solution, duration_s: Floats, travel: Travel, p: SmootherParameters
) -> Floats:
    """Return how large the velocity may be at each node, from the one found.

    Args:
        solution: that found it.
        duration_s: (K,) between the nodes.
        travel: how it gets about.
        p: settings.
    """
    squared = mean_square(solution.velocity_mps, duration_s, p.local_s)
    squared *= 0.5 * p.velocity_factor**2
    squared += p.velocity_floor_mps**2
    return travel.bound_mps(np.sqrt(squared))


def mean_square(vectors: Floats, duration_s: Floats, half_width_s: float) -> Floats:
    """Return the mean of squared norms over the nodes within some time of each.

    Args:
        vectors: (2, K + 1) at the nodes.
        duration_s: (K,) between them.
        half_width_s: of the mean.

    Returns:
        (K + 1,).
    """
    weight, values = around(duration_s), rot.squared_norm(vectors)
    time_s = np.concatenate([[0.0], np.cumsum(duration_s)])
    total = np.concatenate([[0.0], np.cumsum(values * weight)])
    length = np.concatenate([[0.0], np.cumsum(weight)])
    first = np.searchsorted(time_s, time_s - half_width_s)
    last = np.searchsorted(time_s, time_s + half_width_s, side="right")
    return np.asarray((total[last] - total[first]) / (length[last] - length[first]))


def around(duration_s: Floats) -> Floats:
    """Return half of the intervals at both sides of each node."""
    at = np.zeros(len(duration_s) + 1)
    at[:-1] = 0.5 * duration_s
    at[1:] += 0.5 * duration_s
    return at


def _tilt_noise(nodes: Nodes, p: SmootherParameters) -> Floats:
    """Return the variance of the tilt's change from node to node, rad^2."""
    return np.asarray(
        p.rate_noise_rad_per_sqrt_s**2 * nodes.duration_s
        + (p.rotation_error * nodes.turned_rad) ** 2
        + (LOST_RADPS * nodes.lost_s) ** 2
    )


def _velocity_noise(nodes: Nodes, bound_mps: Floats, p: SmootherParameters) -> Floats:
    """Return the variance of the velocity's change from node to node, (m/s)^2."""
    doubt = (DOUBTFUL_MPS2 * nodes.doubt_s) ** 2
    # a velocity that is bounded on both sides of a hole changes no more than this
    doubt = np.minimum(doubt, bound_mps[1:] ** 2 + bound_mps[:-1] ** 2)
    return np.asarray(
        p.force_noise_mps_per_sqrt_s**2 * nodes.duration_s
        + p.force_error**2 * nodes.power_m2ps3 * nodes.duration_s
        + doubt
    )
