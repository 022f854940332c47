# ruff: noqa: N803, N806 - matrices as in the papers
"""Update forms of a Kalman filter in three precisions, many filters at once.

A multiplicative filter (three rotation errors about the earth's axes, three gyro
biases) with the specific force as its measurement, as small as it can be: nothing of
the project's own filter is in it but the equations. Filters that differ in their
assumptions and noise run side by side in one batch.
"""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[Any]
GRAVITY = 9.80665
INTERVAL_S = 0.01
STATES = 6


@dataclass(frozen=True, slots=True, eq=False)
class Data:
    """What M sensors measure on one motion, N samples.

    Attributes:
        rate_radps: (N, M, 3).
        force_mps2: (N, M, 3).
        up: (N, 3) true vertical in the sensor frame.
    """

    rate_radps: Array
    force_mps2: Array
    up: Array


@dataclass(frozen=True, slots=True, eq=False)
class Assumptions:
    """What M filters believe; all (M,).

    Attributes:
        start_variance: of every state, rad^2 and (rad/s)^2.
        force_sigma_mps2: of each sample.
        rate_sigma_radps: of each sample.
        bias_step_radps: by which the bias moves from sample to sample.
    """

    start_variance: Array
    force_sigma_mps2: Array
    rate_sigma_radps: Array
    bias_step_radps: Array


def motion(count: int, sensors: int, seed: int = 1) -> Data:
    """Return a sensor that swings on the spot, with white noise and a bias."""
    rng = np.random.default_rng(seed)
    t = np.arange(-1, count) * INTERVAL_S
    angles = [0.9 * np.sin(0.5 * t), 0.6 * np.sin(0.9 * t), 0.7 * np.sin(1.3 * t)]
    turned = Rotation.from_euler("ZYX", np.stack(angles, axis=1))
    rate = (turned[:-1].inv() * turned[1:]).as_rotvec() / INTERVAL_S
    up = turned[1:].inv().apply([0.0, 0.0, 1.0])
    shape = (count, sensors, 3)
    bias = np.radians([0.8, -0.5, 0.3])
    return Data(
        rate[:, None] + bias + 0.001 * rng.standard_normal(shape),
        GRAVITY * up[:, None] + 0.02 * rng.standard_normal(shape),
        up,
    )


Update = Callable[[Array, Array, Array, Array], tuple[Array, Array]]
"""(P, H, residual, variance) -> (dx, P), batched over the filters."""


def _gain(P: Array, H: Array, variance: Array) -> tuple[Array, Array]:
    PH = P @ H.swapaxes(1, 2)
    S = H @ PH
    S[:, range(3), range(3)] += variance[:, None]
    return _solved(S, PH.swapaxes(1, 2)).swapaxes(1, 2), PH


def _solved(S: Array, right: Array) -> Array:
    """Solve for every filter; NaN for those whose S has become singular."""
    try:
        return np.asarray(np.linalg.solve(S, right))
    except np.linalg.LinAlgError:
        found = np.full_like(right, np.nan)
        for k in range(len(S)):
            with contextlib.suppress(np.linalg.LinAlgError):
                found[k] = np.linalg.solve(S[k], right[k])
        return found


def naive(P: Array, H: Array, residual: Array, variance: Array) -> tuple[Array, Array]:
    """P - K H P, as most textbooks print it."""
    K, _ = _gain(P, H, variance)
    return _times(K, residual), P - K @ (H @ P)


def symmetrised(
    P: Array, H: Array, residual: Array, variance: Array
) -> tuple[Array, Array]:
    """The same, and then the mean of P and its transpose."""
    dx, P = naive(P, H, residual, variance)
    return dx, P.dtype.type(0.5) * (P + P.swapaxes(1, 2))


def joseph(P: Array, H: Array, residual: Array, variance: Array) -> tuple[Array, Array]:
    """(I - K H) P (I - K H)' + K R K'."""
    K, _ = _gain(P, H, variance)
    keep = np.eye(STATES, dtype=P.dtype) - K @ H
    noise = variance[:, None, None] * (K @ K.swapaxes(1, 2))
    return _times(K, residual), keep @ P @ keep.swapaxes(1, 2) + noise


def sequential(
    P: Array, H: Array, residual: Array, variance: Array
) -> tuple[Array, Array]:
    """Three scalar updates that take w w' off P, as the project's `ekf` does."""
    dx = np.zeros(P.shape[:2], P.dtype)
    P = P.copy()
    for row in range(3):
        h = H[:, row]
        Ph = _times(P, h)
        scale = 1.0 / np.sqrt((h * Ph).sum(axis=1) + variance)
        w = Ph * scale[:, None]
        left = residual[:, row] - (h * dx).sum(axis=1)
        dx = dx + w * (left * scale)[:, None]
        P -= w[:, :, None] * w[:, None, :]
    return dx, P


UPDATES: dict[str, Update] = {
    "naive": naive,
    "symmetrised": symmetrised,
    "Joseph": joseph,
    "sequential": sequential,
}


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """What became of M filters.

    Attributes:
        up: (N, M, 3) estimated verticals; NaN once a filter has died.
        asymmetry: (M,) largest |P - P'| over the largest |P|, at any checked step.
        least: (M,) smallest eigenvalue of P with a diagonal of ones, at any checked
            step: a variance that is not positive counts as -1.
    """

    up: Array
    asymmetry: Array
    least: Array


def run(
    data: Data, believed: Assumptions, update: Update, dtype: Any, every: int = 50
) -> Run:
    """Filter all samples in one precision.

    P is looked at after each of the first `every` steps, then every so many.
    """
    count, filters = data.rate_radps.shape[:2]
    rate, force = data.rate_radps.astype(dtype), data.force_mps2.astype(dtype)
    q = np.zeros((filters, 4), dtype)
    q[:, 0] = 1.0
    bias = np.zeros((filters, 3), dtype)
    P = (believed.start_variance[:, None, None] * np.eye(STATES)).astype(dtype)
    variance = np.square(believed.force_sigma_mps2).astype(dtype)
    noise = _noise(believed).astype(dtype)
    ups = np.empty((count, filters, 3))
    asymmetry, least = np.zeros(filters), np.full(filters, np.inf)
    with np.errstate(all="ignore"):
        for k in range(count):
            q, R = _turned(q, (rate[k] - bias) * dtype(INTERVAL_S))
            P = _predicted(P, R, noise)
            H = _observes(R)
            residual = force[k] - dtype(GRAVITY) * R[:, 2]
            dx, P = update(P, H, residual, variance)
            q = _corrected(q, dx[:, :3])
            bias = bias + dx[:, 3:]
            ups[k] = _axes(q)[:, 2]
            if k < every or k % every == 0 or k == count - 1:
                asymmetry = np.fmax(asymmetry, _asymmetry(P))
                least = np.fmin(least, _least(P))
    return Run(ups, asymmetry, least)


def _noise(believed: Assumptions) -> Array:
    Q = np.zeros((len(believed.start_variance), STATES, STATES))
    turn = np.square(INTERVAL_S * believed.rate_sigma_radps)
    Q[:, range(3), range(3)] = turn[:, None]
    Q[:, range(3, 6), range(3, 6)] = np.square(believed.bias_step_radps)[:, None]
    return Q


def _predicted(P: Array, R: Array, noise: Array) -> Array:
    F = np.tile(np.eye(STATES, dtype=P.dtype), (len(P), 1, 1))
    F[:, :3, 3:] = -P.dtype.type(INTERVAL_S) * R
    return np.asarray(F @ P @ F.swapaxes(1, 2) + noise)


def _observes(R: Array) -> Array:
    """Return H of a = g R' z for an error about the earth's axes (rows of R)."""
    H = np.zeros((len(R), 3, STATES), R.dtype)
    H[:, :, 0] = GRAVITY * R[:, 1]
    H[:, :, 1] = -GRAVITY * R[:, 0]
    return H


def _times(matrices: Array, vectors: Array) -> Array:
    return np.asarray((matrices @ vectors[:, :, None])[:, :, 0])


def _product(p: Array, q: Array) -> Array:
    w, x, y, z = p.T
    a, b, c, d = q.T
    parts = [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]
    return np.stack(parts, axis=1)


def _turned(q: Array, turn: Array) -> tuple[Array, Array]:
    """Return the orientation after a rotation vector in the sensor frame, and R'."""
    angle = np.sqrt((turn * turn).sum(axis=1))
    half = q.dtype.type(0.5)
    by = np.where(angle > 0, np.sin(half * angle) / np.maximum(angle, 1e-30), half)
    step = np.concatenate([np.cos(half * angle)[:, None], by[:, None] * turn], axis=1)
    q = _product(q, step)
    q = q / np.sqrt((q * q).sum(axis=1))[:, None]
    return q, _axes(q)


def _corrected(q: Array, tilt: Array) -> Array:
    """Return the orientation after an error about the earth's axes."""
    one = np.ones((len(q), 1), q.dtype)
    q = _product(np.concatenate([one, q.dtype.type(0.5) * tilt], axis=1), q)
    return np.asarray(q / np.sqrt((q * q).sum(axis=1))[:, None])


def _axes(q: Array) -> Array:
    """Return east, north and up in the sensor frame, (M, 3, 3) by rows."""
    w, x, y, z = q.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=1) for row in rows], axis=1)


def _asymmetry(P: Array) -> Array:
    size = np.abs(P).max(axis=(1, 2))
    return np.asarray(np.abs(P - P.swapaxes(1, 2)).max(axis=(1, 2)) / size, float)


def _least(P: Array) -> Array:
    """Return the smallest eigenvalue of each correlation; NaN once P is."""
    even = 0.5 * (P + P.swapaxes(1, 2)).astype(np.float64)
    variance = np.einsum("mii->mi", even)
    alive = np.isfinite(even).all(axis=(1, 2))
    least = np.where(alive, -1.0, np.nan)
    good = alive & (variance > 0.0).all(axis=1)
    scale = 1.0 / np.sqrt(variance[good])
    if good.any():
        scaled = even[good] * scale[:, :, None] * scale[:, None, :]
        least[good] = np.linalg.eigvalsh(scaled)[:, 0]
    return least
