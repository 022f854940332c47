"""The linear heart of the smoother: tilt, velocity and calibration at once.

Unknown at each node: the tilt s (x, y of the vertical in the node's level frame) and
the velocity v. Between nodes
    s[k+1] - s[k] = r[k] + (A[k] b + S[k] m) turned by a quarter + w_s
    v[k+1] - v[k] = (1 - e) dv[k] - g T (s[k] + s[k+1]) / 2 - A[k] c + w_v
with the gyro's bias b, its error matrix m, the accelerometer's bias c and error of
scale e, which are constant within a block; at each node v is small, v = 0 + w_b, and where the sensor
rests it does not change, v[k+1] - v[k] = 0 + w_r. For given
calibration the two horizontal axes are two problems with one banded matrix (4
diagonals), so the calibration is found by least squares over the solutions for each
of its columns: all of it costs one Cholesky factor of a band, whatever the length.
Being a normal matrix with positive weights, it is positive definite by construction.
"""

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lapack

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.rotations import Complexes

GYRO_BIAS = slice(0, 3)
FORCE_BIAS = slice(3, 6)
FORCE_SCALE = 6
GYRO_MATRIX = slice(7, 16)
BIASES_ONLY = 7
CALIBRATION = 16


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """One linearised block; K intervals, K + 1 nodes, C calibration parameters.

    Attributes:
        duration_s: (K,).
        rows: (K, 5, 1 + C) what changes from node to node: the known part, then that
            per unit of calibration. First the vertical's x and y, that is r; then
            the velocity, m/s, in the level frames, gravity taken off. Columns beyond
            those that something is expected of are there for `again`.
        tilt_weight: (K,) 1 / variance of w_s.
        velocity_weight: (K,) 1 / variance of w_v.
        bound_weight: (K + 1,) 1 / variance of w_b.
        rest_weight: (K,) 1 / variance of v[k+1] - v[k] = 0, where the sensor rests.
        prior: (C,) where the calibration is expected.
        prior_weight: (C,) 1 / variance of that.
    """

    duration_s: Floats
    rows: Floats
    tilt_weight: Floats
    velocity_weight: Floats
    bound_weight: Floats
    rest_weight: Floats
    prior: Floats
    prior_weight: Floats

    @property
    def tilt(self) -> Floats:
        """Change of the vertical, (2, 1 + C, K), a view."""
        return self.rows[:, :2].transpose(1, 2, 0)

    @property
    def impulse(self) -> Floats:
        """Change of the velocity, (3, 1 + C, K), a view."""
        return self.rows[:, 2:].transpose(1, 2, 0)


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """The minimum of a Problem.

    Attributes:
        tilt: (2, K + 1) of the vertical, first order.
        velocity_mps: (2, K + 1) horizontal.
        calibration: (C,).
        factor: (C, C) upper Cholesky factor of the calibration's information.
        states: (4 (K + 1), 1 + C or more) tilt x and y, then velocity x and y of each
            node, for each column of the problem alone.
        normal: (1 + C or more, the same) normal matrix of those columns.
    """

    tilt: Floats
    velocity_mps: Floats
    calibration: Floats
    factor: Floats
    states: Floats
    normal: Floats

    @property
    def tilt_per_calibration(self) -> Floats:
        """How the tilt moves with the calibration, (2, C, K + 1), a view."""
        columns = self.states.shape[1]
        by_node = self.states.reshape(-1, 4, columns)[..., 1 : 1 + len(self.factor)]
        return by_node[:, :2].transpose(1, 2, 0)

    @property
    def covariance(self) -> Floats:
        """Covariance (C, C) of the calibration."""
        return covariance(self.factor)

    def per_information(self, information: Floats) -> Floats:
        """Return the covariance times a matrix (C, columns)."""
        found, _ = lapack.dpotrs(self.factor, information)
        return np.asarray(found)


def covariance(factor: Floats) -> Floats:
    """Return the inverse (C, C) of what has this upper Cholesky factor."""
    root, _ = lapack.dtrtri(factor)
    root *= _upper(len(root))  # below is what the factor was made of
    return np.asarray(root @ root.T)


@functools.cache
def _upper(count: int) -> Floats:
    """Return a matrix of so many rows with ones on and above the diagonal."""
    return np.triu(np.ones((count, count)))


def minimise(problem: Problem) -> Solution:
    """Return tilt, velocity and calibration of least squares."""
    states, normal = _horizontal(problem)
    normal += _vertical_normal(problem)
    axes = np.stack([states.real, states.imag])  # (2, 1 + C, K + 1, tilt and velocity)
    flat = axes.transpose(2, 3, 0, 1).reshape(-1, len(states))
    return with_best_calibration(flat, normal, problem.prior, problem.prior_weight)


def again(solution: Solution, prior: Floats, prior_weight: Floats) -> Solution:
    """Return the minimum of a solved problem of whose columns something else is expected.

    Args:
        solution: of the problem.
        prior: (C,) see there; of more columns, or of fewer.
        prior_weight: (C,).
    """
    return with_best_calibration(solution.states, solution.normal, prior, prior_weight)


def with_best_calibration(
    states: Floats, normal: Floats, prior: Floats, prior_weight: Floats
) -> Solution:
    """Return the minimum over the calibration that something is expected of.

    Args:
        states: of the columns, see `Solution`.
        normal: the same.
        prior: (C,) see `Problem`.
        prior_weight: (C,).
    """
    used = 1 + len(prior)
    matrix = normal[1:used, 1:used].copy()  # of which the factor takes one half
    matrix.reshape(-1)[::used] += prior_weight  # a view
    right = prior_weight * prior
    right -= normal[1:used, 0]
    factor, calibration, failed = lapack.dposv(matrix, right)
    if failed:
        raise inseparable()
    weights = np.empty(used)
    weights[0], weights[1:] = 1.0, calibration
    found = states[:, :used].dot(weights).reshape(-1, 4).T
    return Solution(found[:2], found[2:], calibration, factor, states, normal)


def tighter(problem: Problem, solution: Solution, factor: Floats) -> Problem:
    """Return the problem with the velocity bound divided by `factor` (K + 1,).

    The gyro matrix is kept as it was found.
    """
    rows = problem.rows[..., : 1 + BIASES_ONLY].copy()
    found = solution.calibration[BIASES_ONLY:]
    flat = problem.rows.reshape(-1, problem.rows.shape[-1])
    rows[..., 0] += flat[:, 1 + BIASES_ONLY :].dot(found).reshape(rows.shape[:-1])
    return Problem(
        problem.duration_s,
        rows,
        problem.tilt_weight,
        problem.velocity_weight,
        problem.bound_weight * factor**2,
        problem.rest_weight,
        problem.prior[:BIASES_ONLY],
        problem.prior_weight[:BIASES_ONLY],
    )


def _horizontal(problem: Problem) -> tuple[Complexes, Floats]:
    """Return the states per column (1 + C, K + 1, 2) and their normal matrix.

    Both axes have the same matrix: x + iy goes through the solver at once.
    """
    half = 0.5 * STANDARD_GRAVITY_MPS2 * problem.duration_s
    tilt = problem.tilt[0] + 1j * problem.tilt[1]
    speed = problem.impulse[0] + 1j * problem.impulse[1]
    weighted_tilt = problem.tilt_weight * tilt
    weighted_speed = problem.velocity_weight * speed
    sloped = half * weighted_speed
    columns, count = tilt.shape
    right = np.zeros((columns, count + 1, 2), complex)
    right[:, 1:, 0] = weighted_tilt + sloped
    right[:, :-1, 0] += sloped - weighted_tilt
    right[:, 1:, 1] = weighted_speed
    right[:, :-1, 1] -= weighted_speed
    solve_band(horizontal_band(problem), right.reshape(columns, -1))
    s, v = right[..., 0], right[..., 1]
    tilt -= s[:, 1:]
    tilt += s[:, :-1]
    speed -= v[:, 1:]
    speed += v[:, :-1]
    speed -= half * (s[:, 1:] + s[:, :-1])
    normal = (weighted_tilt.conj() @ tilt.T).real
    normal += (weighted_speed.conj() @ speed.T).real
    return right, normal


def horizontal_band(problem: Problem) -> Floats:
    """Return the lower band (4, 2 (K + 1)) of the normal matrix of one axis.

    Order of the unknowns: s[0], v[0], s[1], v[1], ...
    """
    half = 0.5 * STANDARD_GRAVITY_MPS2 * problem.duration_s
    wt, wv = problem.tilt_weight, problem.velocity_weight
    slope = wv * half
    square = slope * half
    band = np.zeros((4, 2 * (len(half) + 1)))
    s, v = band[:, 0::2], band[:, 1::2]
    s[0, :-1] = wt + square
    s[0, 1:] += wt + square
    v[0] = problem.bound_weight
    v[0, :-1] += wv + problem.rest_weight
    v[0, 1:] += wv + problem.rest_weight
    s[1, :-1] = -slope  # (v[k], s[k])
    s[1, 1:] += slope  # (v[k+1], s[k+1])
    v[1, :-1] = -slope  # (s[k+1], v[k])
    s[2, :-1] = square - wt  # (s[k+1], s[k])
    v[2, :-1] = -wv - problem.rest_weight  # (v[k+1], v[k])
    s[3, :-1] = slope  # (v[k+1], s[k])
    return band


def tilt_variances(problem: Problem, chosen: NDArray[np.intp]) -> Floats:
    """Return the variance of one tilt at some nodes, for a known calibration."""
    right = np.zeros((len(chosen), 2 * len(problem.bound_weight)))
    rows = np.arange(len(chosen))
    right[rows, 2 * chosen] = 1.0
    solve_band(horizontal_band(problem), right)
    return np.asarray(right[rows, 2 * chosen])


def _vertical_normal(problem: Problem) -> Floats:
    """Return what the vertical velocity says about the calibration."""
    wv, speed = problem.velocity_weight, problem.impulse[2]
    weighted = wv * speed
    main = problem.bound_weight.copy()
    side = wv + problem.rest_weight
    main[1:] += side
    main[:-1] += side
    right = np.zeros((len(speed), len(wv) + 1))
    right[:, 1:] = weighted
    right[:, :-1] -= weighted
    *_, found, failed = lapack.dptsv(main, -side, right.T)
    if failed:
        raise inseparable()
    return np.asarray(weighted @ (speed - np.diff(found.T, axis=1)).T)


def solve_band(band: Floats, right: Floats | Complexes) -> None:
    """Solve in place for the rows of `right`; `band` is the lower one.

    Raises:
        InputError: when the matrix is singular to working precision.
    """
    routines = {
        "f": (lapack.dpbtrf, lapack.dpbtrs),
        "c": (lapack.zpbtrf, lapack.zpbtrs),
    }
    factorise, substitute = routines[right.dtype.kind]
    factor, failed = factorise(np.asfortranarray(band, right.dtype), lower=1)
    if failed:
        raise inseparable()
    solved, _ = substitute(factor, right.T, lower=1, overwrite_b=1)
    if not np.shares_memory(solved, right):
        right[:] = solved.T


def inseparable() -> InputError:
    """Return the error for a problem without a solution."""
    return InputError(
        "the motion cannot be separated from gravity",
        remedy="look for values far beyond what a sensor can measure",
    )
