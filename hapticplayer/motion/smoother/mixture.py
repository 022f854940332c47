"""Short blocks: the mean over models of motion and sensor, weighed by their evidence.

In half a minute a wrong bias of the gyro looks like a motion, and the other way round.
So nothing is decided: the velocity is a Gauss-Markov process of each of some deviations,
the sensor is calibrated or not, its gyro as noisy as usual or more, and what each
combination finds counts by the probability of the data under it (`evidence`, MacKay
1992). The variance is that of the mixture, with the spread between its parts.

Whether it goes on wheels, evidence of that kind tells badly: a steady acceleration is a
tilt that no velocity contradicts. A second witness does: wheels shake a sensor without
turning it, hands and feet turn it. And a steady turn is balanced by a tilt, so that for
wheels the gyro's bias about the vertical is looked for apart (`vehicle.yaw_bias_radps`).
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from scipy.linalg import lapack

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother import nodes as nd
from hapticplayer.motion.smoother.evidence import (
    VelocityModel,
    log_evidence_of_prior,
    velocity_precisions,
)
from hapticplayer.motion.smoother.least_squares import (
    ACCEL_BIAS,
    ALL_COLUMNS,
    GYRO_BIAS,
    GYRO_SCALE,
    Problem,
    Solution,
    horizontal_factor,
    minimise,
    tilt_variances,
    tridiagonal,
    with_prior,
)
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.problem import linearised
from hapticplayer.motion.smoother.state import (
    Block,
    BlockState,
    Mixture,
    reintegrate,
)
from hapticplayer.motion.smoother.strapdown import Windows
from hapticplayer.motion.smoother.vehicle import (
    BODY_VELOCITY_COLUMNS,
    VEHICLE_BODY_SIGMA_MPS,
    yaw_bias_radps,
)


class SensorGrade(NamedTuple):
    """Prior sigmas of a sensor: no less is assumed than what is known of it."""

    gyro_bias_radps: float
    accel_bias_mps2: float
    gyro_scale: float


# What is carried: deviations of a velocity that hardly outlasts a node, with a way to go
# or without. Each is judged by the deviation that fits, and its vertical is that of the
# next, so that slower motion than the usual is not taken for tilt.
CARRIED_SIGMAS_MPS, CARRIED_CORRELATION_S = (0.03, 0.1, 0.3, 1.0, 3.0), 0.5
WALKING_BODY_SIGMAS_MPS = (0.0, 3.0)
# What goes on wheels, across and upwards: speeds that last, on roads and on paths.
WHEELED = tuple(
    itertools.product(
        (VelocityModel(5.0, 20.0), VelocityModel(15.0, 20.0)),
        (VelocityModel(0.3, 3.0), VelocityModel(1.0, 0.5)),
    )
)
# A calibrated sensor, a usual one, and one whose gyro has a wrong scale.
SENSORS = (
    SensorGrade(0.006, 0.06, 0.0065),
    SensorGrade(0.05, 0.14, 0.0065),
    SensorGrade(0.05, 0.14, 0.045),
)
# Change of the specific force over that of the rate, from window to window, m/rad/s:
# mean and deviation of its logarithm for what is carried (recordings: 2 to 5, feet: 10
# to 12) and on wheels (a car: 20 to 30, simulated: 14 to 30). Below this change of the
# rate it is the gyro's noise.
CARRIED_SHAKE, WHEELED_SHAKE = (math.log(5.0), 0.6), (math.log(22.0), 0.35)
SHAKE_RATE_NOISE_RADPS = 0.003
# Factor on the deviation of the noise of a gyro that is noisier than usual.
NOISY_GYRO_FACTOR = 3.0
# Share of the evidence that counts between carried and wheeled, and between motions on
# wheels: a steady acceleration is a tilt to the smallest velocity that allows it.
WHEELED_EVIDENCE_SHARE = 0.03
# Parts that weigh less have no variance of their own.
MIN_WEIGHT = 1e-3
# Share of the variance that is counted of what is carried: the noises are those of the least
# error, not those that describe it best.
CARRIED_VARIANCE_SHARE = 0.7
# A vertical that moves so far, or a bias about it, is solved for again about where it
# went, so often at most.
MAX_MOVED_RAD, MAX_YAW_CHANGE_RADPS, MOST_AGAIN = 0.1, 0.002, 3


@dataclass(frozen=True, slots=True, eq=False)
class Hypothesis:
    """One model and what it finds.

    Attributes:
        problem: with its weights.
        solution: of that, under the prior of a sensor.
        log_evidence: of the model.
        levelling_mps: deviation of a white velocity that levels alike, times sqrt(s).
    """

    problem: Problem
    solution: Solution
    log_evidence: float
    levelling_mps: float


def mixed(block: Block, state: BlockState) -> BlockState:
    """Return the mean over the models about a solution; again while it moves far."""
    found, about = _mixed_about(block, state)
    for _ in range(MOST_AGAIN):
        if about is None:
            break
        start = reintegrate(block, about, about.known.bound_mps, is_fine=True)
        applied = start.integration.applied[: len(about.known.applied)]
        again = replace(
            about,
            integration=start.integration,
            known=replace(about.known, applied=applied),
            frames=nd.level_frames(start.vertical),
            solution=replace(about.solution, tilt=np.zeros_like(about.solution.tilt)),
        )
        found, about = _mixed_about(block, again)
    return found


def _mixed_about(
    block: Block, state: BlockState
) -> tuple[BlockState, BlockState | None]:
    """Return the mean over the models about a solution, and what to do it about again.

    None if the mean is near that solution.
    """
    vertical = state.vertical
    known = replace(state.known, has_body_velocity=True, body_sigma_mps=1.0)
    frames = nd.level_frames(vertical)
    nodes = state.integration.nodes
    problem = linearised(nodes, vertical, frames, known, block.p)
    carried, wheeled = _carried(problem, 1.0), _wheeled(problem)
    on_wheels = _probability(
        WHEELED_EVIDENCE_SHARE * (_log_mean(wheeled) - _log_mean(carried))
        + shake_evidence(shaking(state.integration.windows))
    )
    noisy = _carried(problem, NOISY_GYRO_FACTOR)
    odds = _log_mean(noisy) - _log_mean(carried) - block.p.gyro_evidence
    shares = _shares(carried), _shares(wheeled, WHEELED_EVIDENCE_SHARE)
    weight = np.concatenate([(1.0 - on_wheels) * shares[0], on_wheels * shares[1]])
    known_share = np.repeat([CARRIED_VARIANCE_SHARE, 1.0], [len(carried), len(wheeled)])
    parts, wider = [*carried, *wheeled], [*_wider(carried), *wheeled]
    noisy_share = (1.0 - on_wheels) * _probability(odds)
    mixture, solution = _mixture(
        parts, wider, weight, known_share, noisy_share, block.p
    )
    moved_rad = float(np.sqrt(rot.squared_norm(solution.tilt)).max())
    found = replace(
        state,
        known=known,
        frames=frames,
        problem=problem,
        solution=solution,
        motion=replace(state.motion, vehicle_weight=on_wheels),
        mixture=mixture,
    )
    if on_wheels > 0.5:
        sensors = shares[1].reshape(-1, len(SENSORS)).sum(axis=0)
        turned = _with_yaw_bias(block, found, sensors)
        if turned is not None:
            return found, turned
    return found, found if moved_rad >= MAX_MOVED_RAD else None


def _with_yaw_bias(
    block: Block, state: BlockState, sensors: Floats
) -> BlockState | None:
    """Return a solution with the gyro's bias about the vertical that wheels have.

    None if it would change little.

    Args:
        block: the block.
        state: of it, with the mean over the models.
        sensors: (S,) probability of each on wheels.
    """
    nodes, windows = state.integration.nodes, state.integration.windows
    usual, known, vertical = block.bias_radps, state.known, state.vertical
    up = rot.rotate(rot.inverse(nodes.at), vertical).mean(axis=1)
    up /= max(float(np.linalg.norm(up)), 1e-9)
    turn_rad = rot.rotate(nodes.start, windows.turn_rad)
    count = turn_rad.shape[1]
    around = np.repeat(vertical[:, :-1], nodes.per_node, axis=1)[:, :count]
    starts = np.arange(0, count, nodes.per_node)
    yaw_rad = np.add.reduceat(rot.dot(turn_rad, around), starts)
    yaw_rad -= nodes.duration_s * (up @ (usual - state.integration.applied[GYRO_BIAS]))
    weight = state.problem.prior_weight[GYRO_BIAS]
    variance = np.array(
        [
            up**2 @ (1.0 / np.maximum(weight, sensor.gyro_bias_radps**-2.0))
            for sensor in SENSORS
        ]
    )
    found_radps = yaw_bias_radps(yaw_rad, nodes.duration_s, variance, sensors)
    change = found_radps - up @ (known.bias_radps - usual)
    if abs(change) < MAX_YAW_CHANGE_RADPS:
        return None
    # no motion shows it: it is known beforehand, as it were
    calibration = state.solution.calibration.copy()
    calibration[GYRO_BIAS] += change * up
    return replace(
        state,
        known=replace(known, bias_radps=known.bias_radps + change * up),
        solution=replace(state.solution, calibration=calibration),
    )


def shake_evidence(shake: float) -> float:
    """Return the logarithm of the odds of wheels that the shaking gives."""

    def log_density(mean: float, sigma: float) -> float:
        return -0.5 * ((math.log(shake) - mean) / sigma) ** 2 - math.log(sigma)

    return log_density(*WHEELED_SHAKE) - log_density(*CARRIED_SHAKE)


def shaking(windows: Windows) -> float:
    """Return the change of specific force over that of the rate, m/rad/s."""
    duration_s = np.maximum(windows.duration_s, 1e-9)
    used = (windows.lost_s + windows.doubt_s == 0.0)[:-1]
    used = used[1:] & used[:-1]
    if not used.any():
        return math.exp(CARRIED_SHAKE[0])
    force, rate = (
        float(np.mean(rot.squared_norm(np.diff(values / duration_s))[:-1][used]))
        for values in (windows.impulse_mps, windows.turn_rad)
    )
    return math.sqrt(max(force, 1e-12) / (rate + SHAKE_RATE_NOISE_RADPS**2))


def _carried(problem: Problem, noise_factor: float) -> list[Hypothesis]:
    problem = replace(problem, tilt_weight=problem.tilt_weight / noise_factor**2)
    return [
        part
        for sigma_mps in CARRIED_SIGMAS_MPS
        for part in parts_of(
            problem,
            [VelocityModel(sigma_mps, CARRIED_CORRELATION_S)] * 2,
            WALKING_BODY_SIGMAS_MPS,
        )
    ]


def _wheeled(problem: Problem) -> list[Hypothesis]:
    return [
        part
        for models in WHEELED
        for part in parts_of(problem, models, (VEHICLE_BODY_SIGMA_MPS,))
    ]


def _wider(carried: list[Hypothesis]) -> list[Hypothesis]:
    """Return for each part that with the next deviation of the velocity, or itself."""
    to_next = len(SENSORS) * len(WALKING_BODY_SIGMAS_MPS)
    return [*carried[to_next:], *carried[-to_next:]]


def parts_of(
    problem: Problem,
    models: Sequence[VelocityModel],
    body_sigmas_mps: Sequence[float],
) -> list[Hypothesis]:
    """Return a motion with each body velocity and sensor: one matrix serves all."""
    bound, change = velocity_precisions(problem.duration_s, models)
    across, upwards = (
        replace(
            problem,
            bound_weight=one,
            zero_velocity_weight=problem.zero_velocity_weight + other,
        )
        for one, other in zip(bound, change, strict=True)
    )
    solution = minimise(across, upwards)
    log_evidence = _log_evidence_but_for_prior(across, upwards, solution)
    levelling = models[0].sigma_mps * math.sqrt(models[0].correlation_s)
    found = []
    for body_sigma_mps, sensor in itertools.product(body_sigmas_mps, SENSORS):
        prior, weight = _prior(problem, body_sigma_mps, sensor)
        one = with_prior(solution, prior, weight)
        gain = log_evidence + log_evidence_of_prior(one, prior, weight)
        found.append(Hypothesis(across, one, gain, levelling))
    return found


def _prior(
    problem: Problem, body_sigma_mps: float, sensor: SensorGrade
) -> tuple[Floats, Floats]:
    """Return prior and weight (C,) for a sensor, without a body velocity of 0."""
    prior, weight = problem.prior, problem.prior_weight.copy()
    weight[GYRO_BIAS] = np.maximum(weight[GYRO_BIAS], sensor.gyro_bias_radps**-2.0)
    weight[ACCEL_BIAS] = np.maximum(weight[ACCEL_BIAS], sensor.accel_bias_mps2**-2.0)
    if len(weight) > ALL_COLUMNS:
        weight[GYRO_SCALE] = np.minimum(weight[GYRO_SCALE], sensor.gyro_scale**-2.0)
    if not body_sigma_mps:
        return prior[:-BODY_VELOCITY_COLUMNS], weight[:-BODY_VELOCITY_COLUMNS]
    weight[-BODY_VELOCITY_COLUMNS:] = body_sigma_mps**-2.0
    return prior, weight


def _log_evidence_but_for_prior(
    across: Problem, upwards: Problem, solution: Solution
) -> float:
    """Return what `log_evidence_of_prior` lacks of the evidence, but for a constant."""

    def log_det(problem: Problem, side: Floats) -> float:
        main = tridiagonal(problem.bound_weight, side)
        return float(np.log(lapack.dpttrf(main, -side)[0]).sum())

    log_weights = 2.0 * np.log(across.tilt_weight).sum()
    log_weights += 2.0 * log_det(across, across.zero_velocity_weight)
    log_weights += log_det(upwards, upwards.zero_velocity_weight)
    log_normal = 4.0 * np.log(horizontal_factor(across)[0]).sum()
    side = upwards.zero_velocity_weight + upwards.velocity_weight
    log_normal += log_det(upwards, side)
    return float(0.5 * (log_weights - log_normal - solution.normal[0, 0]))


def _mixture(
    parts: list[Hypothesis],
    wider: list[Hypothesis],
    weight: Floats,
    known_share: Floats,
    noisy_share: float,
    p: SmootherParameters,
) -> tuple[Mixture, Solution]:
    """Return means and variances over the parts, by the vertical of the wider ones."""
    best = parts[int(weight.argmax())].solution
    columns = len(best.normal) - 1
    tilts = np.array([part.solution.tilt for part in wider])
    tilt = np.tensordot(weight, tilts, 1)
    known = weight * known_share
    variance = known @ rot.squared_norm((tilts - tilt).swapaxes(0, 1))
    calibrations = np.zeros((len(parts), columns))
    for row, part in zip(calibrations, wider, strict=True):
        row[: len(part.solution.calibration)] = part.solution.calibration
    calibration = weight @ calibrations
    calibration_variance = weight @ np.square(calibrations - calibration)
    for one in np.flatnonzero(weight > MIN_WEIGHT).tolist():
        own, covariance = variances_of(parts[one])
        shift = rot.squared_norm(parts[one].solution.tilt - tilts[one])
        variance += known[one] * (own + shift)
        calibration_variance[: len(covariance)] += weight[one] * covariance
    velocity_mps = np.tensordot(weight, [w.solution.velocity_mps for w in wider], 1)
    levelling_mps = np.array([part.levelling_mps for part in wider])
    mixture = Mixture(
        variance=variance,
        calibration_variance=calibration_variance,
        time_constant_s=float(weight @ p.time_constant_of_s(levelling_mps)),
        noisy_share=noisy_share,
    )
    solution = replace(
        best, tilt=tilt, velocity_mps=velocity_mps, calibration=calibration
    )
    return mixture, solution


def variances_of(part: Hypothesis) -> tuple[Floats, Floats]:
    """Return the variance of both tilts (K + 1,) and of the calibration (C,)."""
    solution = part.solution
    columns = len(solution.calibration)
    covariance = solution.covariance_times(np.eye(columns))
    every = np.arange(len(part.problem.bound_weight))
    moved = solution.states[1 : 1 + columns, ..., 0]
    by_calibration = np.einsum("iak,ij,jak->k", moved, covariance, moved)
    own = 2.0 * tilt_variances(part.problem, every) + by_calibration
    return own, np.diagonal(covariance)


def _shares(parts: list[Hypothesis], counted: float = 1.0) -> Floats:
    """Return the probabilities (n,) of parts that are equally likely beforehand.

    Args:
        parts: motions, with each sensor.
        counted: share of the evidence that counts between the motions.
    """
    evidence = np.array([part.log_evidence for part in parts])
    evidence = evidence.reshape(-1, len(SENSORS))
    of_motion = np.logaddexp.reduce(evidence, axis=1, keepdims=True)
    evidence -= (1.0 - counted) * of_motion
    share = np.exp(evidence - evidence.max()).reshape(-1)
    return np.asarray(share / share.sum())


def _log_mean(parts: list[Hypothesis]) -> float:
    """Return the logarithm of the mean probability of the data under some models."""
    evidence = [part.log_evidence for part in parts]
    return float(np.logaddexp.reduce(evidence)) - math.log(len(parts))


def _probability(log_odds: float) -> float:
    return 1.0 / (1.0 + math.exp(-min(max(log_odds, -500.0), 500.0)))
