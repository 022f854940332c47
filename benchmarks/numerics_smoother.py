"""How well conditioned the smoother's equations are, and what rounding costs them."""

import contextlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any
from unittest import mock

import numpy as np
from motion_document import Document
from motion_time import head
from numpy.typing import NDArray
from recordings import TruthRecording
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded
from scipy.sparse.linalg import LinearOperator, eigsh

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.motion import SmootherParameters, remove_gravity
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother import block
from hapticplayer.motion.smoother.calibrated import (
    Problem,
    horizontal_band,
    minimise,
)

Floats = NDArray[np.float64]
# one block, however long the recording is
UNDIVIDED = SmootherParameters(block_s=1e9)


@contextlib.contextmanager
def collected() -> Iterator[list[Problem]]:
    """Collect the problems that the smoother minimises, in order."""
    held: list[Problem] = []

    def minimised(problem: Problem) -> Any:
        held.append(problem)
        return minimise(problem)

    with mock.patch.object(block, "minimise", minimised):
        yield held


def last_problem(log: ImuLog, parameters: SmootherParameters = UNDIVIDED) -> Problem:
    """Return the final problem of a log in one block."""
    with collected() as held:
        remove_gravity(log, parameters=parameters)
    return held[-1]


@dataclass(frozen=True, slots=True)
class Conditioning:
    """Condition numbers of one problem, and errors of its solution.

    Attributes:
        unknowns: of the band.
        band: largest over smallest eigenvalue of the banded normal matrix.
        band_scaled: the same with a diagonal of ones, which is what counts for
            Cholesky's factor: units cost no digits.
        calibration: of the calibration's covariance, with a diagonal of ones.
        error64_mps2: largest error of the gravity by rounding in float64.
        error32_mps2: the same in float32; infinite when the factor fails.
    """

    unknowns: int
    band: float
    band_scaled: float
    calibration: float
    error64_mps2: float
    error32_mps2: float


def conditioning(problem: Problem) -> Conditioning:
    """Return what rounding does to a problem."""
    band = horizontal_band(problem)
    return Conditioning(
        unknowns=band.shape[1],
        band=_condition(band),
        band_scaled=_scaled_condition(band),
        calibration=_calibration_condition(problem),
        error64_mps2=rounding_mps2(band, np.float64),
        error32_mps2=rounding_mps2(band, np.float32),
    )


def _scaled(band: Floats, scale: Floats) -> Floats:
    """Return D A D for a lower band A and the diagonal D."""
    out = np.zeros_like(band)
    count = band.shape[1]
    for below in range(len(band)):
        left = scale[below:]
        out[below, : count - below] = band[below, : count - below] * left
        out[below, : count - below] *= scale[: count - below]
    return out


def _times(band: Floats, vector: Any) -> Any:
    """Return A x for a lower band, in the precision of x."""
    out = band[0] * vector
    for below in range(1, len(band)):
        part = band[below, :-below]
        out[below:] += part * vector[:-below]
        out[:-below] += part * vector[below:]
    return out


def _condition(band: Floats) -> float:
    count = band.shape[1]
    factor = cholesky_banded(band, lower=True)

    def largest(product: Callable[[Floats], Floats]) -> float:
        operator = LinearOperator((count, count), matvec=product, dtype=np.float64)
        start = np.random.default_rng(1).standard_normal(count)
        found = eigsh(
            operator, k=1, which="LA", tol=1e-3, v0=start, return_eigenvectors=False
        )
        return float(found[0])

    top = largest(lambda x: np.asarray(_times(band, np.ravel(x))))
    inverse = largest(
        lambda x: np.asarray(cho_solve_banded((factor, True), np.ravel(x)))
    )
    return top * inverse


def _calibration_condition(problem: Problem) -> float:
    covariance = minimise(problem).covariance
    scale = 1.0 / np.sqrt(np.diag(covariance))
    return float(np.linalg.cond(covariance * scale * scale[:, None]))


def rounding_mps2(band: Floats, dtype: Any) -> float:
    """Return the error of gravity when a band is solved in one precision.

    The right side belongs to a known solution, tilts of a hundredth of a radian, and
    is made from it in long double.
    """
    rng = np.random.default_rng(1)
    wanted = 0.01 * rng.standard_normal(band.shape[1])
    right = _times(band.astype(np.longdouble), wanted.astype(np.longdouble))
    try:
        factor = cholesky_banded(band.astype(dtype), lower=True)
    except LinAlgError:
        return float("inf")
    found = cho_solve_banded((factor, True), right.astype(dtype))
    miss = np.abs(found.astype(np.float64) - wanted)[0::2]
    return float(STANDARD_GRAVITY_MPS2 * miss.max())


def by_family(
    families: Sequence[tuple[str, Sequence[TruthRecording]]], document: Document
) -> dict[str, Any]:
    """Print and return the worst recording of each family."""
    rows, figures = [], {}
    for key, held in families:
        found = [conditioning(last_problem(one.imu)) for one in held]
        worst = max(found, key=lambda one: one.band_scaled)
        rows.append([key, *_cells(worst)])
        figures[key] = _plain(worst)
    document.table(
        "condition",
        "Condition numbers of the smoother's last problem, worst recording, and the "
        "largest error of gravity by rounding, m/s^2",
        ["recordings", *_HEADER],
        rows,
    )
    return figures


_HEADER = (
    *("unknowns", "band", "band, scaled", "calibration, scaled"),
    *("error float64", "error float32"),
)


def _cells(one: Conditioning) -> list[str]:
    numbers = (one.band, one.band_scaled, one.calibration)
    errors = (one.error64_mps2, one.error32_mps2)
    return [
        str(one.unknowns),
        *(f"{value:.1e}" for value in numbers),
        *("factor fails" if np.isinf(value) else f"{value:.0e}" for value in errors),
    ]


def _plain(one: Conditioning) -> dict[str, Any]:
    return {
        "unknowns": one.unknowns,
        "band": one.band,
        "band_scaled": one.band_scaled,
        "calibration_scaled": one.calibration,
        "error_float64_mps2": one.error64_mps2,
        "error_float32_mps2": _finite(one.error32_mps2),
    }


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def by_length(
    log: ImuLog, lengths_s: Sequence[float], document: Document
) -> dict[str, Any]:
    """Print and return conditions over the length of one undivided block."""
    rows, figures = [], {}
    for length_s in lengths_s:
        part = head(log, round(length_s * log.rate_hz))
        found = conditioning(last_problem(part))
        rows.append([f"{length_s / 60:g} min", *_cells(found)])
        figures[f"{length_s:g} s"] = _plain(found)
    document.table(
        "condition by length",
        "The same for one recording (simulated, hand-held) in one undivided block",
        ["length", *_HEADER],
        rows,
    )
    return figures


def where_it_breaks(problem: Problem, document: Document) -> dict[str, Any]:
    """Loosen the bound on the velocity until rounding tells, or the factor fails."""
    rows, figures = [], {}
    for exponent in range(0, 19, 3):
        loose = replace(problem, bound_weight=problem.bound_weight * 10.0**-exponent)
        band = horizontal_band(loose)
        errors = [rounding_mps2(band, dtype) for dtype in (np.float32, np.float64)]
        condition = _scaled_condition(band)
        cells = ["factor fails" if np.isinf(e) else f"{e:.0e}" for e in errors]
        size = "beyond 1e16" if np.isinf(condition) else f"{condition:.0e}"
        rows.append([f"1e{exponent}", size, *cells])
        figures[f"1e{exponent}"] = {
            "band_scaled": _finite(condition),
            "error_float32_mps2": _finite(errors[0]),
            "error_float64_mps2": _finite(errors[1]),
        }
    document.table(
        "band breaks",
        "Where the banded factor breaks: the weight of the bounded velocity divided by "
        "so much, largest error of gravity by rounding, m/s^2",
        ["divided by", "condition, scaled", "float32", "float64"],
        rows,
    )
    return figures


def _scaled_condition(band: Floats) -> float:
    """Return it, or infinity once the smallest eigenvalue is lost in rounding."""
    try:
        return _condition(_scaled(band, 1.0 / np.sqrt(band[0])))
    except LinAlgError:
        return float("inf")


def open_loop(document: Document) -> dict[str, Any]:
    """Multiply rotations in both precisions, without ever normalising."""
    rng = np.random.default_rng(3)
    rows, figures = [], {}
    for count in (10**4, 10**5, 10**6, 10**7):
        steps = rot.exponential(0.02 * rng.standard_normal((3, count)))
        exact, rough = (
            rot.cumulative((steps[0].astype(kind), steps[1].astype(kind)))
            for kind in (np.complex128, np.complex64)
        )
        norms = [float(np.abs(_norm(pair) - 1.0).max()) for pair in (exact, rough)]
        off = STANDARD_GRAVITY_MPS2 * _angle_between_ends(exact, rough)
        shown = [f"{value:.0e}" for value in (*norms, off)]
        rows.append([f"1e{round(np.log10(count))}", *shown])
        figures[str(count)] = {
            "norm_error_float64": norms[0],
            "norm_error_float32": norms[1],
            "float32_off_mps2": off,
        }
    document.table(
        "products",
        "Products of so many rotations, never normalised: largest error of the norm, "
        "and by how much gravity is off at the end with float32, m/s^2",
        ["rotations", "norm, float64", "norm, float32", "gravity, float32"],
        rows,
    )
    return figures


def _norm(pair: rot.Pair) -> Floats:
    return np.asarray(np.sqrt(np.abs(pair[0]) ** 2 + np.abs(pair[1]) ** 2), float)


def _angle_between_ends(one: rot.Pair, other: rot.Pair) -> float:
    ends = [
        rot.unit((pair[0][-1:].astype(complex), pair[1][-1:].astype(complex)))
        for pair in (one, other)
    ]
    first, second = rot.multiply(rot.inverse(ends[0]), ends[1])
    sine = float(np.hypot(first.imag[0], np.abs(second[0])))
    return 2.0 * float(np.arcsin(min(1.0, sine)))
