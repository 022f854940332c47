# ruff: noqa: N803, N806 - matrices as in the papers
"""Update forms of a Kalman filter in two precisions, many filters at once.

Three rotation errors about the earth's axes and three gyro biases, with the specific
force as the measurement, linearised along the true motion. The filters that run side by
side differ in how much their first update has to shrink the covariance P.
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
Update = Callable[[Array, Array, Array, Array], tuple[Array, Array]]
"""(P, H, residual, variance) -> (dx, P), batched over the filters."""


def _gain(P: Array, H: Array, variance: Array) -> Array:
    S = H @ P @ H.T
    S[:, range(3), range(3)] += variance[:, None]
    right = H @ P.swapaxes(1, 2)
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
        h = H[row]
        Ph = P @ h
        scale = 1.0 / np.sqrt(Ph @ h + variance)
        w = Ph * scale[:, None]
        dx = dx + w * ((residual[:, row] - dx @ h) * scale)[:, None]
        P -= w[:, :, None] * w[:, None, :]
    return dx, P


UPDATES: dict[str, Update] = {
    "naive": naive,
    "symmetrised": symmetrised,
    "Joseph": joseph,
    "sequential": sequential,
}


def _times(matrices: Array, vectors: Array) -> Array:
    return np.asarray((matrices @ vectors[:, :, None])[:, :, 0])


class Run(NamedTuple):
    """What became of M filters.

    Rotation errors (N, M, 3), NaN once a filter has died; (M,) largest |P - P'| over the
    largest |P|, and smallest eigenvalue of P with a diagonal of ones (-1 for a variance
    that is not positive), at any checked step.
    """

    error_rad: Array
    asymmetry: Array
    least: Array


def filtered(update: Update, dtype: Any) -> Run:
    """Filter 30 s of a sensor that swings on the spot, in one precision."""
    rng, filters, sigma = np.random.default_rng(1), len(RATIOS), RATIOS**-0.25
    t = np.arange(STEPS) * INTERVAL_S
    angles = [0.9 * np.sin(0.5 * t), 0.6 * np.sin(0.9 * t), 0.7 * np.sin(1.3 * t)]
    matrices = Rotation.from_euler("ZYX", np.stack(angles, axis=1)).inv().as_matrix()
    noise = 0.02 * rng.standard_normal((STEPS, filters, 3)).astype(dtype)
    start = sigma**2 * RATIOS / GRAVITY**2
    P = (start[:, None, None] * np.eye(STATES)).astype(dtype)
    variance = np.square(sigma).astype(dtype)
    steps = [INTERVAL_S * RATE_SIGMA_RADPS] * 3 + [BIAS_STEP_RADPS] * 3
    process = np.diag(np.square(steps)).astype(dtype)
    x = np.zeros((filters, STATES), dtype)
    x[:, :3] = 0.01  # a wrong start, to be corrected
    errors = np.empty((STEPS, filters, 3))
    asymmetry, least = np.zeros(filters), np.full(filters, np.inf)
    for k, turned in enumerate(matrices.astype(dtype)):
        F = np.eye(STATES, dtype=dtype)
        F[:3, 3:] = -dtype(INTERVAL_S) * turned.T
        x, P = x @ F.T, F @ P @ F.T + process
        H = np.zeros((3, STATES), dtype)  # a = g R' z for errors about the earth's axes
        H[:, 0], H[:, 1] = GRAVITY * turned[:, 1], -GRAVITY * turned[:, 0]
        dx, P = update(P, H, noise[k] - x @ H.T, variance)
        x = x + dx
        errors[k] = x[:, :3]
        if k < CHECK_EVERY or k % CHECK_EVERY == 0 or k == STEPS - 1:
            apart = np.abs(P - P.swapaxes(1, 2)).max(axis=(1, 2))
            apart = np.asarray(apart / np.abs(P).max(axis=(1, 2)), float)
            asymmetry, least = np.fmax(asymmetry, apart), np.fmin(least, _least(P))
    return Run(errors, asymmetry, least)


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
    late = slice(STEPS // 2, None)
    rows = []
    with np.errstate(all="ignore"):
        exact = filtered(sequential, np.longdouble)
        for precision in (np.float32, np.float64):
            for name, update in UPDATES.items():
                found = filtered(update, precision)
                apart = found.error_rad[late] - exact.error_rad[late]
                wrong = [rms(np.linalg.norm(m, axis=1)) for m in apart.swapaxes(0, 1)]
                broken = [
                    ~(np.degrees(wrong) <= WRONG_DEG),
                    # just below zero is the rounding of the eigenvalues themselves
                    found.least < -1e-15,
                    ~np.isfinite(found.error_rad[-1]).all(axis=1),
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
