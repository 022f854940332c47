"""What the evidence of a block's data says about its gyro.

The smoother assumes the noise and the scale of a calibrated gyro. One that saturates,
drifts or repeats samples is noisier, and a bound on the velocity that follows the
velocity found then takes drift for motion. Which factor on its noise is likely depends
on how the sensor moves: the velocity is a Gauss-Markov process (Gelb 1974, "Applied Optimal
Estimation", section 3.8), v[k+1] = a v[k] + w with a = exp(-T / tau) and
var w = sigma^2 (1 - a^2). The evidence is the probability of the data with nodes and
calibration integrated out (MacKay 1992, "Bayesian Interpolation", equation 2.5). Several
velocities are weighed at once: their normal matrices follow one another in one band.
"""

import itertools
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy.linalg import lapack

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.least_squares import (
    ALL_COLUMNS,
    BIAS_COLUMNS,
    GYRO_SCALE,
    Problem,
    Solution,
    half_solve,
    horizontal_factor,
    right_sides,
    tridiagonal,
    vertical_right_sides,
    with_fixed_calibration,
    with_prior,
)
from hapticplayer.motion.smoother.parameters import SmootherParameters


class VelocityModel(NamedTuple):
    """Deviation of each component of the velocity, and its correlation time."""

    sigma_mps: float
    correlation_s: float


# Factors on the deviation of the gyro's noise, upwards; half and twice of them cost 1 %.
GYRO_NOISE_FACTORS = (2.0, 4.0, 8.0)
# Deviations (m/s) and correlation times (s) of the velocity that are tried: from a hand
# to a bicycle, from a step to a bend.
VELOCITY_MODELS = tuple(
    itertools.starmap(
        VelocityModel, itertools.product((0.1, 0.3, 1.0, 3.0), (0.5, 2.0, 8.0))
    )
)
# No step on the way up may lose more evidence than this (natural logarithm): beyond a
# valley lies a gyro that is worth nothing, which explains any vehicle.
MAX_LOG_EVIDENCE_LOSS = 0.5
# Prior sigmas of the scale of a gyro that nobody calibrated: the tolerance of cheap ones
# (3 %, data sheet of the MPU-6050) and, to solve with, twice of it.
GYRO_SCALE_SIGMA, WIDE_GYRO_SCALE_SIGMA = 0.03, 0.06


def gyro_noise_factor(
    problem: Problem, solution: Solution, body: slice, p: SmootherParameters
) -> float:
    """Return how much noisier the gyro is than usual, 1 where it is not.

    A walk in circles looks like an error of the gyro unless the velocity in the body's
    frame is known, a shaken head if it is: what counts is the evidence either way.

    Args:
        problem: the last one.
        solution: of it.
        body: columns of the velocity in the body's frame.
        p: settings.
    """
    resting = solution.calibration.copy()
    resting[body] = 0.0
    moving, still = (
        with_fixed_calibration(problem, calibration, BIAS_COLUMNS)
        for calibration in (solution.calibration, resting)
    )
    both = replace(
        moving,
        tilt=np.concatenate([still.tilt[:1], moving.tilt]),
        impulse=np.concatenate([still.impulse[:1], moving.impulse]),
    )
    usual: Floats | None = None
    best, best_gain, last_gain = 1.0, p.gyro_evidence, 0.0
    for factor in GYRO_NOISE_FACTORS:
        noisier = replace(both, tilt_weight=both.tilt_weight / factor**2)
        evidences = log_evidences(noisier, VELOCITY_MODELS, 2)
        least = evidences.max(axis=1) - last_gain + MAX_LOG_EVIDENCE_LOSS
        if usual is None:
            # two velocities are mostly enough to see that the usual gyro explains more
            likely = [VELOCITY_MODELS[place] for place in evidences.argmax(axis=1)]
            if (log_evidences(both, likely, 2).max(axis=1) > least).any():
                return best
            usual = log_evidences(both, VELOCITY_MODELS, 2).max(axis=1)
        if (usual > least).any():
            return best
        last_gain = float((evidences.max(axis=1) - usual).min())
        if last_gain > best_gain:
            best, best_gain = factor, last_gain
    return best


def shows_scale_error(
    problem: Problem, solution: Solution, p: SmootherParameters
) -> bool:
    """Return whether a wide prior of the gyro's scale explains the data better."""
    if len(problem.prior) < ALL_COLUMNS:
        return False
    prior, weight = problem.prior, problem.prior_weight
    least = log_evidence_of_prior(solution, prior, weight) + p.scale_evidence
    for sigma in (GYRO_SCALE_SIGMA, WIDE_GYRO_SCALE_SIGMA):
        wide = weight.copy()
        wide[GYRO_SCALE] = sigma**-2.0
        widened = with_prior(solution, prior, wide)
        if log_evidence_of_prior(widened, prior, wide) > least:
            return True
    return False


def log_evidence_of_prior(
    solution: Solution, prior: Floats, prior_weight: Floats
) -> float:
    """Return the logarithm of the evidence, but for what no prior changes.

    Args:
        solution: under that prior.
        prior: (C,) expected calibration.
        prior_weight: (C,) 1 / variance of that.
    """
    pull = prior_weight * prior
    right = pull - solution.normal[1 : 1 + len(prior), 0]
    squares = prior @ pull - right @ solution.calibration
    log_det = 2.0 * np.log(np.diagonal(solution.factor)).sum()
    return float(0.5 * (np.log(prior_weight).sum() - log_det - squares))


def velocity_precisions(
    duration_s: Floats, models: Sequence[VelocityModel]
) -> tuple[Floats, Floats]:
    """Return the precision of such processes, (M, K + 1) and (M, K).

    Its three diagonals are those of a bound at each node and of one on the change from
    node to node.
    """
    sigma_mps, correlation_s = np.array(models).T[..., None]
    weight = sigma_mps**-2.0
    decay = np.exp(-duration_s / correlation_s)
    driven = weight / (1.0 - decay * decay)
    change = decay * driven
    bound = np.empty((len(decay), decay.shape[1] + 1))
    bound[:, :1] = weight
    bound[:, 1:] = driven - change
    bound[:, :-1] += decay * change - change
    return bound, change


def log_evidences(
    problem: Problem, models: Sequence[VelocityModel], known: int = 1
) -> Floats:
    """Return the logarithm of the evidence for models of the velocity, (known, M).

    All but for one constant, which depends on the number of nodes alone.

    Args:
        problem: whose first columns are the known part under one hypothesis each.
        models: M of them.
        known: how many columns that are.
    """
    count, columns = len(models), len(problem.tilt)
    chain = _chain(problem, models)
    factor = horizontal_factor(chain)
    sides = right_sides(problem)
    repeated = np.empty((columns, count, sides.shape[2]), complex)
    repeated.real, repeated.imag = sides[:, :1], sides[:, 1:]
    pairs = repeated.reshape(columns, -1)
    half_solve(factor, pairs)
    half = pairs.view(np.float64).reshape(columns, count, -1).swapaxes(0, 1)
    normal = _gram(problem.tilt, problem.tilt_weight)
    normal += _gram(problem.impulse, problem.velocity_weight)
    normal = normal - half @ half.swapaxes(1, 2)
    log_det = 2.0 * 2.0 * _sums(np.log(factor[0]), count)
    # the vertical velocity alone
    prior = tridiagonal(chain.bound_weight, chain.zero_velocity_weight)
    log_weights = 3.0 * _sums(
        np.log(lapack.dpttrf(prior, -chain.zero_velocity_weight)[0]), count
    )
    side = chain.zero_velocity_weight + chain.velocity_weight
    vertical = vertical_right_sides(problem)
    main, _, solved, _ = lapack.dptsv(
        tridiagonal(chain.bound_weight, side), -side, np.tile(vertical, count).T
    )
    normal -= vertical @ solved.reshape(count, -1, columns)
    log_det += _sums(np.log(main), count)
    log_weights += 2.0 * np.log(problem.tilt_weight).sum()
    # the calibration
    matrix = normal[:, known:, known:] + np.diag(problem.prior_weight)
    pull = (problem.prior_weight * problem.prior)[:, None] - normal[:, known:, :known]
    best = np.linalg.solve(matrix, pull)
    squares = np.diagonal(normal, axis1=1, axis2=2)[:, :known] - (pull * best).sum(
        axis=1
    )
    log_det += np.linalg.slogdet(matrix)[1]
    return np.asarray(0.5 * (log_weights - log_det - squares.T))


def _gram(columns: Floats, weight: Floats) -> Floats:
    """Return the weighted scalar products of columns (C, axes, K), (C, C)."""
    count = len(columns)
    weighted = (weight * columns).reshape(count, -1)
    return np.asarray(weighted @ columns.reshape(count, -1).T)


def _chain(problem: Problem, models: Sequence[VelocityModel]) -> Problem:
    """Return the problem with each model in turn, with nothing between them."""
    bound, change = velocity_precisions(problem.duration_s, models)

    def repeated(values: Floats) -> Floats:
        held = np.zeros(bound.shape)
        held[:, :-1] = values
        return held.reshape(-1)[:-1]

    return replace(
        problem,
        duration_s=repeated(problem.duration_s),
        tilt_weight=repeated(problem.tilt_weight),
        velocity_weight=repeated(problem.velocity_weight),
        zero_velocity_weight=repeated(problem.zero_velocity_weight + change),
        bound_weight=bound.reshape(-1),
    )


def _sums(values: Floats, parts: int) -> Floats:
    return np.asarray(values.reshape(parts, -1).sum(axis=1))
