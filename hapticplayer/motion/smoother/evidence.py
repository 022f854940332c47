"""The evidence of a block's data for how the sensor moves and how noisy its gyro is.

The velocity is a Gauss-Markov process (Gelb 1974, "Applied Optimal Estimation", section
3.8), v[k+1] = a v[k] + w with a = exp(-T / tau) and var w = sigma^2 (1 - a^2). The
evidence is the probability of the data with nodes and calibration integrated out (MacKay
1992, "Bayesian Interpolation", equation 2.5). Several velocities are weighed at once:
their normal matrices follow one another in one band.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy.linalg import lapack

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.least_squares import (
    Problem,
    half_solve,
    horizontal_factor,
    right_sides,
    vertical_right_sides,
)


class VelocityModel(NamedTuple):
    """Deviation of each component of the velocity, and its correlation time."""

    sigma_mps: float
    correlation_s: float


def with_velocity_model(problem: Problem, model: VelocityModel) -> Problem:
    """Return the problem with the velocity as such a process, in place of its bound."""
    bound, change = _precisions(problem.duration_s, [model])
    unchanged = problem.zero_velocity_weight + change[0]
    return replace(problem, bound_weight=bound[0], zero_velocity_weight=unchanged)


def _precisions(
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
    prior = _diagonal(chain.bound_weight, chain.zero_velocity_weight)
    log_weights = 3.0 * _sums(
        np.log(lapack.dpttrf(prior, -chain.zero_velocity_weight)[0]), count
    )
    side = chain.zero_velocity_weight + chain.velocity_weight
    vertical = vertical_right_sides(problem)
    main, _, solved, _ = lapack.dptsv(
        _diagonal(chain.bound_weight, side), -side, np.tile(vertical, count).T
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
    bound, change = _precisions(problem.duration_s, models)

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


def _diagonal(at_nodes: Floats, between: Floats) -> Floats:
    main = at_nodes.copy()
    main[1:] += between
    main[:-1] += between
    return main


def _sums(values: Floats, parts: int) -> Floats:
    return np.asarray(values.reshape(parts, -1).sum(axis=1))
