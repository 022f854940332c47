"""The linear problem of the smoother: tilt, velocity and calibration at once.

Unknown at each node: the tilt s (x, y of the vertical in the node's level frame) and
the velocity v. Between nodes
    s[k+1] - s[k] = r[k] + (A[k] b + S[k] m) rotated by 90 degrees + w_s
    v[k+1] - v[k] = (1 - e) dv[k] - g T (s[k] + s[k+1]) / 2 - A[k] c + w_v
with the gyro's bias b and error matrix m, the accelerometer's bias c and scale error
e, which are constant within a block. At each node the velocity is bounded,
v = 0 + w_b; over a zero-velocity interval it does not change, v[k+1] - v[k] = 0 + w_z.
For a given calibration the two horizontal axes are two problems with one banded matrix
(4 diagonals), so the calibration is found by least squares over the solutions for each
of its columns: one Cholesky factor of a band, whatever the length. A normal matrix
with positive weights is positive definite by construction.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lapack

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.rotations import Complexes

GYRO_BIAS = slice(0, 3)
ACCEL_BIAS = slice(3, 6)
ACCEL_SCALE = 6
GYRO_MATRIX = slice(7, 16)
GYRO_SCALE = slice(7, 16, 4)  # its diagonal
BIAS_COLUMNS = 7
ALL_COLUMNS = 16


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """One linearised block; K intervals, K + 1 nodes, C calibration parameters.

    Attributes:
        duration_s: (K,).
        tilt: (1 + C, 2, K) change of the vertical's x and y from node to node, that is
            r: the known part, then that per unit of calibration.
        impulse: (1 + C, 3, K) the same for the velocity, m/s, in the level frames,
            without gravity. Columns beyond the prior are there for `with_prior`.
        tilt_weight: (K,) 1 / variance of w_s.
        velocity_weight: (K,) 1 / variance of w_v.
        bound_weight: (K + 1,) 1 / variance of w_b.
        zero_velocity_weight: (K,) 1 / variance of w_z; 0 where the sensor moves.
        prior: (C,) expected calibration.
        prior_weight: (C,) 1 / variance of that.
    """

    duration_s: Floats
    tilt: Floats
    impulse: Floats
    tilt_weight: Floats
    velocity_weight: Floats
    bound_weight: Floats
    zero_velocity_weight: Floats
    prior: Floats
    prior_weight: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """The minimum of a Problem.

    Attributes:
        tilt: (2, K + 1) of the vertical, first order.
        velocity_mps: (2, K + 1) horizontal.
        calibration: (C,).
        factor: (C, C) upper Cholesky factor of the calibration's information.
        states: (1 + C or more, 2, K + 1, 2) tilt and velocity of each axis and node,
            for each column of the problem alone.
        normal: (1 + C or more, the same) normal matrix of those columns.
    """

    tilt: Floats
    velocity_mps: Floats
    calibration: Floats
    factor: Floats
    states: Floats
    normal: Floats

    def covariance_times(self, matrix: Floats) -> Floats:
        """Return the covariance of the calibration times a matrix (C, columns)."""
        found, _ = lapack.dpotrs(self.factor, matrix)
        return np.asarray(found)


def minimise(problem: Problem, upwards: Problem | None = None) -> Solution:
    """Return tilt, velocity and calibration of least squares.

    Args:
        problem: the block.
        upwards: the same with other weights of the vertical velocity.
    """
    half = 0.5 * STANDARD_GRAVITY_MPS2 * problem.duration_s
    tilt, push = problem.tilt, problem.impulse[:, :2]
    weighted_tilt = problem.tilt_weight * tilt
    weighted_push = problem.velocity_weight * push
    columns = len(tilt)
    states = _right_sides(weighted_tilt, weighted_push, half)
    _solve_band(problem, states.reshape(2 * columns, -1))
    s, v = states[..., 0], states[..., 1]
    rest = tilt - s[..., 1:]
    rest += s[..., :-1]
    normal = weighted_tilt.reshape(columns, -1) @ rest.reshape(columns, -1).T
    rest = push - v[..., 1:]
    rest += v[..., :-1]
    rest -= half * (s[..., 1:] + s[..., :-1])
    normal += weighted_push.reshape(columns, -1) @ rest.reshape(columns, -1).T
    normal += _vertical_normal(upwards or problem)
    return _with_best_calibration(states, normal, problem.prior, problem.prior_weight)


def right_sides(problem: Problem) -> Floats:
    """Return the right sides of one axis each, (1 + C, 2, 2 (K + 1)).

    Order of the unknowns as in `horizontal_band`.
    """
    sides = _right_sides(
        problem.tilt_weight * problem.tilt,
        problem.velocity_weight * problem.impulse[:, :2],
        0.5 * STANDARD_GRAVITY_MPS2 * problem.duration_s,
    )
    return sides.reshape(len(sides), 2, -1)


def _right_sides(weighted_tilt: Floats, weighted_push: Floats, half: Floats) -> Floats:
    columns, _, count = weighted_tilt.shape
    sides = np.zeros((columns, 2, count + 1, 2))
    s, v = sides[..., 0], sides[..., 1]
    sloped = half * weighted_push
    s[..., 1:] = sloped + weighted_tilt
    s[..., :-1] += sloped - weighted_tilt
    v[..., 1:] = weighted_push
    v[..., :-1] -= weighted_push
    return sides


def with_prior(solution: Solution, prior: Floats, prior_weight: Floats) -> Solution:
    """Return the minimum of a solved problem under another prior.

    Args:
        solution: of the problem.
        prior: (C,) see `Problem`; of more columns than before, or of fewer.
        prior_weight: (C,).
    """
    return _with_best_calibration(solution.states, solution.normal, prior, prior_weight)


def with_tighter_bound(problem: Problem, solution: Solution, factor: Floats) -> Problem:
    """Return the problem with the velocity bound divided by `factor` (K + 1,).

    The gyro matrix stays as it was found.
    """
    fixed = with_fixed_calibration(problem, solution.calibration, BIAS_COLUMNS)
    return replace(fixed, bound_weight=problem.bound_weight * factor**2)


def with_fixed_calibration(problem: Problem, calibration: Floats, free: int) -> Problem:
    """Return the problem for the first `free` columns, the others as they are given.

    Args:
        problem: of at least so many.
        calibration: (C,).
        free: how many to solve for.
    """
    used = 1 + free
    tilt, impulse = problem.tilt[:used], problem.impulse[:used]
    fixed = calibration[free:]
    if len(fixed):
        tilt, impulse = tilt.copy(), impulse.copy()
        for known, all_columns in (tilt, problem.tilt), (impulse, problem.impulse):
            columns = all_columns[used : used + len(fixed)]
            known[0] += fixed.dot(columns.reshape(len(fixed), -1)).reshape(
                known[0].shape
            )
    return replace(
        problem,
        tilt=tilt,
        impulse=impulse,
        prior=problem.prior[:free],
        prior_weight=problem.prior_weight[:free],
    )


def tilt_variances(problem: Problem, nodes: NDArray[np.intp]) -> Floats:
    """Return the variance of one tilt at some nodes, for a known calibration."""
    right = np.zeros((len(nodes), 2 * len(problem.bound_weight)))
    right[np.arange(len(nodes)), 2 * nodes] = 1.0
    pairs = _in_pairs(right)
    half_solve(horizontal_factor(problem), pairs)
    found = np.stack([np.vecdot(x, x) for x in (pairs.real, pairs.imag)], axis=1)
    return found.reshape(-1)[: len(nodes)]


def horizontal_band(problem: Problem) -> Floats:
    """Return the lower band (4, 2 (K + 1)) of the normal matrix of one axis.

    Order of the unknowns: s[0], v[0], s[1], v[1], ...
    """
    half = 0.5 * STANDARD_GRAVITY_MPS2 * problem.duration_s
    wt, wv = problem.tilt_weight, problem.velocity_weight
    slope = wv * half
    square = slope * half
    unchanged = wv + problem.zero_velocity_weight
    band = np.zeros((4, 2 * (len(half) + 1)), order="F")
    s, v = band[:, 0::2], band[:, 1::2]
    s[0, :-1] = wt + square
    s[0, 1:] += wt + square
    v[0] = problem.bound_weight
    v[0, :-1] += unchanged
    v[0, 1:] += unchanged
    s[1, :-1] = -slope  # (v[k], s[k])
    s[1, 1:] += slope  # (v[k+1], s[k+1])
    v[1, :-1] = -slope  # (s[k+1], v[k])
    s[2, :-1] = square - wt  # (s[k+1], s[k])
    v[2, :-1] = -unchanged  # (v[k+1], v[k])
    s[3, :-1] = slope  # (v[k+1], s[k])
    return band


def horizontal_factor(problem: Problem) -> Floats:
    """Return the Cholesky factor L of one axis, like its band."""
    factor, failed = lapack.dpbtrf(horizontal_band(problem), lower=1, overwrite_ab=1)
    if failed:
        raise _singular()
    return np.asarray(factor)


def half_solve(factor: Floats, pairs: Complexes) -> None:
    """Replace the rows b of `pairs` (n, 2 (K + 1)) by L^-1 b, in place.

    Their scalar products are b' A^-1 b for the normal matrix A = L L'.
    """
    lapack.ztbtrs(factor.astype(complex), pairs.T, uplo="L", overwrite_b=1)


def _solve_band(problem: Problem, right: Floats) -> None:
    """Solve one axis in place for the rows of `right`, (n, 2 (K + 1))."""
    pairs = _in_pairs(right)
    factor = horizontal_factor(problem).astype(complex)
    lapack.zpbtrs(factor, pairs.T, lower=1, overwrite_b=1)
    right[0::2], right[1::2] = pairs.real, pairs.imag[: len(right) // 2]


def _in_pairs(rows: Floats) -> Complexes:
    """Return rows (n, m) two by two as complex numbers.

    LAPACK solves for one after another, and for a complex one in the time of a real.
    """
    pairs = np.zeros((-(-len(rows) // 2), rows.shape[1]), complex)
    pairs.real, pairs.imag[: len(rows) // 2] = rows[0::2], rows[1::2]
    return pairs


def vertical_right_sides(problem: Problem) -> Floats:
    """Return the right sides of the vertical velocity, (1 + C, K + 1)."""
    weighted = problem.velocity_weight * problem.impulse[:, 2]
    sides = np.zeros((len(weighted), weighted.shape[1] + 1))
    sides[:, 1:] = weighted
    sides[:, :-1] -= weighted
    return sides


def tridiagonal(at_nodes: Floats, between: Floats) -> Floats:
    """Return the diagonal (K + 1,) of weights at nodes and of changes (K,)."""
    main = at_nodes.copy()
    main[1:] += between
    main[:-1] += between
    return main


def _vertical_normal(problem: Problem) -> Floats:
    """The part of the vertical velocity in the normal equations of the calibration."""
    push = problem.impulse[:, 2]
    weighted = problem.velocity_weight * push
    side = problem.velocity_weight + problem.zero_velocity_weight
    main = tridiagonal(problem.bound_weight, side)
    right = vertical_right_sides(problem)
    *_, found, failed = lapack.dptsv(main, -side, right.T, overwrite_b=1)
    if failed:
        raise _singular()
    return np.asarray(weighted @ (push.T - found[1:] + found[:-1]))


def _with_best_calibration(
    states: Floats, normal: Floats, prior: Floats, prior_weight: Floats
) -> Solution:
    used = 1 + len(prior)
    matrix = normal[1:used, 1:used].copy()
    matrix.reshape(-1)[::used] += prior_weight  # its diagonal
    right = prior_weight * prior
    right -= normal[1:used, 0]
    factor, calibration, failed = lapack.dposv(matrix, right)
    if failed:
        raise _singular()
    weights = np.append(1.0, calibration)
    found = weights.dot(states[:used].reshape(used, -1)).reshape(states.shape[1:])
    return Solution(found[..., 0], found[..., 1], calibration, factor, states, normal)


def _singular() -> InputError:
    return InputError(
        "the motion cannot be separated from gravity",
        remedy="look for values far beyond what a sensor can measure",
    )
