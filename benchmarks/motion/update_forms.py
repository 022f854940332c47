# ruff: noqa: N803, N806 - matrices as in the papers
"""Update forms of a Kalman filter in several precisions, many filters at once.

A multiplicative filter (three rotation errors about the earth's axes, three gyro
biases) with the specific force as its measurement, as small as it can be. Filters that
differ in their assumptions and noise run side by side in one batch.
"""

import contextlib
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from benchmarks.common import Report, rms

Array = NDArray[Any]
GRAVITY, INTERVAL_S, STATES = 9.80665, 0.01, 6
STEPS, CHECK_EVERY = 3000, 50
# P g^2 / sigma^2 of the first update: by so much it has to shrink
RATIOS = 10.0 ** np.arange(2, 21)
RATE_SIGMA_RADPS, BIAS_STEP_RADPS = 0.005, 1e-6
WRONG_DEG = 0.1


class Data(NamedTuple):
    """What M sensors measure on one motion: rates and forces (N, M, 3), up (N, 3)."""

    rate_radps: Array
    force_mps2: Array
    up: Array


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


def _gain(P: Array, H: Array, variance: Array) -> Array:
    PH = P @ H.swapaxes(1, 2)
    S = H @ PH
    S[:, range(3), range(3)] += variance[:, None]
    right = PH.swapaxes(1, 2)
    try:
        found = np.linalg.solve(S, right)
    except np.linalg.LinAlgError:  # NaN for those whose S has become singular
        found = np.full_like(right, np.nan)
        for k in range(len(S)):
            with contextlib.suppress(np.linalg.LinAlgError):
                found[k] = np.linalg.solve(S[k], right[k])
    return np.asarray(found.swapaxes(1, 2))


def naive(P: Array, H: Array, residual: Array, variance: Array) -> tuple[Array, Array]:
    """P - K H P, as most textbooks print it."""
    K = _gain(P, H, variance)
    return _times(K, residual), P - K @ (H @ P)


def symmetrised(
    P: Array, H: Array, residual: Array, variance: Array
) -> tuple[Array, Array]:
    """The same, and then the mean of P and its transpose."""
    dx, P = naive(P, H, residual, variance)
    return dx, P.dtype.type(0.5) * (P + P.swapaxes(1, 2))


def joseph(P: Array, H: Array, residual: Array, variance: Array) -> tuple[Array, Array]:
    """(I - K H) P (I - K H)' + K R K'."""
    K = _gain(P, H, variance)
    keep = np.eye(STATES, dtype=P.dtype) - K @ H
    noise = variance[:, None, None] * (K @ K.swapaxes(1, 2))
    return _times(K, residual), keep @ P @ keep.swapaxes(1, 2) + noise


def sequential(
    P: Array, H: Array, residual: Array, variance: Array
) -> tuple[Array, Array]:
    """Three scalar updates that take w w' off P, as the project's `ekf` does."""
    dx, P = np.zeros(P.shape[:2], P.dtype), P.copy()
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


class Run(NamedTuple):
    """What became of M filters.

    Verticals (N, M, 3), NaN once a filter has died; (M,) largest |P - P'| over the
    largest |P|, and smallest eigenvalue of P with a diagonal of ones (-1 for a variance
    that is not positive), at any checked step.
    """

    up: Array
    asymmetry: Array
    least: Array


def filtered(data: Data, update: Update, dtype: Any) -> Run:
    """Filter all samples in one precision."""
    count, filters = data.rate_radps.shape[:2]
    sigma = RATIOS**-0.25
    rate, force = data.rate_radps.astype(dtype), data.force_mps2.astype(dtype)
    q = np.zeros((filters, 4), dtype)
    q[:, 0] = 1.0
    bias = np.zeros((filters, 3), dtype)
    start = sigma**2 * RATIOS / GRAVITY**2
    P = (start[:, None, None] * np.eye(STATES)).astype(dtype)
    variance = np.square(sigma).astype(dtype)
    steps = [INTERVAL_S * RATE_SIGMA_RADPS] * 3 + [BIAS_STEP_RADPS] * 3
    noise = np.diag(np.square(steps)).astype(dtype)
    ups = np.empty((count, filters, 3))
    asymmetry, least = np.zeros(filters), np.full(filters, np.inf)
    for k in range(count):
        q = _product(q, _rotation((rate[k] - bias) * dtype(INTERVAL_S)))
        R = _axes(q := _unit(q))
        F = np.tile(np.eye(STATES, dtype=dtype), (filters, 1, 1))
        F[:, :3, 3:] = -dtype(INTERVAL_S) * R
        P = np.asarray(F @ P @ F.swapaxes(1, 2) + noise)
        H = np.zeros(
            (filters, 3, STATES), dtype
        )  # a = g R' z, errors about earth's axes
        H[:, :, 0], H[:, :, 1] = GRAVITY * R[:, 1], -GRAVITY * R[:, 0]
        dx, P = update(P, H, force[k] - dtype(GRAVITY) * R[:, 2], variance)
        one = np.ones((filters, 1), dtype)
        q = _unit(_product(np.concatenate([one, dtype(0.5) * dx[:, :3]], axis=1), q))
        bias = bias + dx[:, 3:]
        ups[k] = _axes(q)[:, 2]
        if k < CHECK_EVERY or k % CHECK_EVERY == 0 or k == count - 1:
            size = np.abs(P).max(axis=(1, 2))
            apart = np.abs(P - P.swapaxes(1, 2)).max(axis=(1, 2)) / size
            asymmetry = np.fmax(asymmetry, np.asarray(apart, float))
            least = np.fmin(least, _least(P))
    return Run(ups, asymmetry, least)


def _times(matrices: Array, vectors: Array) -> Array:
    return np.asarray((matrices @ vectors[:, :, None])[:, :, 0])


def _unit(q: Array) -> Array:
    return np.asarray(q / np.sqrt((q * q).sum(axis=1))[:, None])


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


def _rotation(turn: Array) -> Array:
    """Return the quaternions of rotation vectors."""
    angle, half = np.sqrt((turn * turn).sum(axis=1)), turn.dtype.type(0.5)
    by = np.where(angle > 0, np.sin(half * angle) / np.maximum(angle, 1e-30), half)
    return np.concatenate([np.cos(half * angle)[:, None], by[:, None] * turn], axis=1)


def _axes(q: Array) -> Array:
    """Return east, north and up in the sensor frame, (M, 3, 3) by rows."""
    w, x, y, z = q.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=1) for row in rows], axis=1)


def _least(P: Array) -> Array:
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


def compare(report: Report) -> None:
    """Find the ratio of prior to measurement at which each update form breaks."""
    data, late = motion(STEPS, len(RATIOS)), slice(STEPS // 2, None)
    rows = []
    with np.errstate(all="ignore"):
        exact = filtered(data, sequential, np.longdouble)
        for precision in (np.float32, np.float64):
            for name, update in UPDATES.items():
                found = filtered(data, update, precision)
                apart = [
                    rms(inclination_deg(found.up[late, k], exact.up[late, k]))
                    for k in range(len(RATIOS))
                ]
                broken = [
                    ~(np.array(apart) <= WRONG_DEG),
                    # just below zero is the rounding of the eigenvalues themselves
                    found.least < -1e-15,
                    ~np.isfinite(found.up[-1]).all(axis=1),
                ]
                worst = np.nanmax(found.asymmetry[RATIOS <= 1e4])
                shown = [*map(_first, broken), f"{worst:.0e}"]
                rows.append([precision.__name__, name, *shown])
    report.table(
        "Ratio of prior to measurement variance from which an update form is off by "
        f"more than {WRONG_DEG} deg, has lost a positive P, or is NaN within {STEPS} "
        "samples; and the asymmetry of P up to 1e4",
        [
            "precision",
            "update",
            "off from",
            "indefinite from",
            "NaN from",
            "|P - P'|/|P|",
        ],
        rows,
        mark="updates",
    )
    report.figures["updates"] = rows


def _first(flags: Array) -> str:
    place = RATIOS[int(np.argmax(flags))] if flags.any() else RATIOS[-1]
    return f"{place:.0e}" if flags.any() else f"> {place:.0e}"


def inclination_deg(up: Array, true_up: Array) -> Array:
    """Return the angle between two sets of unit vectors (N, 3)."""
    chord = np.linalg.norm(up - true_up, axis=1)
    return np.asarray(np.degrees(2.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))))
