"""Rounding and invariance: precisions, condition numbers, cuts.

What must not depend on how a recording is turned, reversed, stamped, stored, divided,
cut or resampled; how well conditioned the smoother's equations are, and what rounding
costs them. `--long` adds 10^7 samples (14 hours at 200 Hz) through the smoother, VQF and
offlineVQF: 5 GB and two minutes.
"""

import argparse
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded
from scipy.sparse.linalg import LinearOperator, eigsh
from scipy.spatial.transform import Rotation

from benchmarks.common import Report, on_one_thread, rms
from benchmarks.motion.recordings import Family, add_options, chosen
from benchmarks.motion.run_time import head
from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, Sampling
from hapticplayer.motion import SmootherParameters, remove_gravity
from hapticplayer.motion.smoother import state
from hapticplayer.motion.smoother.least_squares import (
    Problem,
    horizontal_band,
    minimise,
)

Floats = NDArray[np.float64]
LENGTHS_S = (60.0, 600.0, 3600.0, 36000.0)
LONG, LONG_HZ = 10_000_000, 200.0
ROTATIONS, SINCE_1970_S, SHORT_BLOCK_S = 3, 1.7e9, 60.0
UNDIVIDED = SmootherParameters(block_s=1e9)
TURNED_LIMIT_MPS2, ROUNDING_LIMIT_MPS2 = 1e-3, 1e-6


def options(parser: argparse.ArgumentParser) -> None:
    add_options(parser, seeds=1)
    parser.add_argument("--long", action="store_true", help="add 10^7 samples")


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure everything."""
    on_one_thread()
    families = chosen(options)
    lengths_s = LENGTHS_S[:2] if options.quick else LENGTHS_S
    conditions(families, lengths_s, report)
    changes(families, INVARIANCES, "invariance RMS", "processed so", report)
    changes(families, CUTS, "cut moved", "cut or resampled", report)
    for key, found in report.figures["invariance RMS"].items():
        what, limit = (
            f"{key}: change in a turned frame, m/s^2",
            ("<=", TURNED_LIMIT_MPS2),
        )
        report.target(what, found["turned frame"], limit)
    if options.long:
        long_run(report)


# --- what must not change the gravity ----------------------------------------------

Change = Callable[[ImuLog], tuple[Floats, Floats] | None]
"""A log to the gravity found the other way and the usual one, (N, 3) each."""


def gravity(log: ImuLog, parameters: SmootherParameters | None = None) -> Floats:
    """The gravity that is taken off, m/s^2 in the sensor frame."""
    return remove_gravity(log, parameters=parameters).gravity_mps2


def _with(log: ImuLog, time_s: Floats, force: Floats, rate: Floats) -> ImuLog:
    return replace(
        log,
        time_s=time_s,
        specific_force_mps2=force,
        angular_rate_radps=rate,
        magnetic_field_ut=None,
    )


def part(log: ImuLog, first: int, last: int) -> ImuLog:
    """Return the samples from first to before last."""
    force, rate = log.specific_force_mps2, log.angular_rate_radps
    return _with(log, log.time_s[first:last], force[first:last], rate[first:last])


def in_two_parts(overlap_s: float) -> Change:
    """Cut in the middle; each part reaches so far beyond the cut, and is used up to it."""

    def found(log: ImuLog) -> tuple[Floats, Floats]:
        middle, reach = len(log) // 2, round(overlap_s * log.rate_hz)
        first = gravity(part(log, 0, min(len(log), middle + reach)))
        start = max(0, middle - reach)
        second = gravity(part(log, start, len(log)))
        return np.concatenate([first[:middle], second[middle - start :]]), gravity(log)

    return found


def backwards(log: ImuLog) -> tuple[Floats, Floats]:
    """Run time backwards: rates change their sign, forces stay.

    A rate that holds up to its sample then holds up to the sample before, so without
    averaging the last sample has none.
    """
    count = len(log) if log.sampling is Sampling.AVERAGED else len(log) - 1
    rate = -log.angular_rate_radps[len(log) - count :][::-1]
    force = log.specific_force_mps2[:count][::-1]
    time_s = (log.time_s[count - 1] - log.time_s[:count])[::-1]
    return gravity(_with(log, time_s, force, rate))[::-1], gravity(log)[:count]


def in_turned_frames(log: ImuLog) -> tuple[Floats, Floats]:
    """Turn the sensor's frame at random, several times; return the worst, turned back."""
    usual = gravity(log)
    found = []
    for turn in Rotation.random(ROTATIONS, rng=np.random.default_rng(5)):
        force = turn.apply(np.array(log.specific_force_mps2))
        rate = turn.apply(np.array(log.angular_rate_radps))
        turned = gravity(_with(log, log.time_s, force, rate))
        found.append(turn.inv().apply(np.array(turned)))
    return max(found, key=lambda one: float(np.abs(one - usual).max())), usual


def stored_as_float32(log: ImuLog) -> tuple[Floats, Floats]:
    """Keep the samples in half of the space."""
    force = log.specific_force_mps2.astype(np.float32).astype(np.float64)
    rate = log.angular_rate_radps.astype(np.float32).astype(np.float64)
    return gravity(_with(log, log.time_s, force, rate)), gravity(log)


INVARIANCES: dict[str, Change] = {
    "again": lambda log: (gravity(log), gravity(log)),
    "turned frame": in_turned_frames,
    "backwards": backwards,
    "time of day": lambda log: (
        gravity(replace(log, time_s=log.time_s + SINCE_1970_S)),
        gravity(log),
    ),
    "float32 storage": stored_as_float32,
    "blocks of 60 s": lambda log: (
        gravity(log, SmootherParameters(block_s=SHORT_BLOCK_S)),
        gravity(log),
    ),
    **{f"two parts, {s:g} s over": in_two_parts(s) for s in (0.0, 10.0, 40.0)},
}


def cut(first: float, last: float) -> Change:
    """Keep what lies between two shares of the samples; seconds where beyond 1."""

    def changed(log: ImuLog) -> tuple[Floats, Floats]:
        span_s = float(log.time_s[-1] - log.time_s[0])

        def at(place: float) -> int:
            share = abs(place) / span_s if abs(place) > 1.0 else abs(place)
            return round((1.0 - share if place < 0.0 else share) * len(log))

        begin, end = at(first), at(last)
        return gravity(part(log, begin, end)), gravity(log)[begin:end]

    return changed


def halved(log: ImuLog) -> tuple[Floats, Floats]:
    """Average pairs of samples, as a sensor would that gives means at half the rate."""
    rate, force = log.angular_rate_radps, log.specific_force_mps2
    if log.sampling is Sampling.AVERAGED:
        count = len(log) // 2 * 2

        def pairs(values: Floats) -> Floats:
            return np.asarray(0.5 * (values[:count:2] + values[1:count:2]))

        means = _with(log, pairs(log.time_s), pairs(force), pairs(rate))
        return gravity(means), pairs(gravity(log))
    count = (len(log) - 1) // 2 * 2 + 1

    def over(values: Floats, middle: float) -> Floats:
        ends = values[: count - 2 : 2] + values[2:count:2]
        inner = values[1 : count - 1 : 2]
        return np.asarray(0.5 * (1.0 - middle) * ends + middle * inner)

    mean_rate = 0.5 * (rate[1 : count - 1 : 2] + rate[2:count:2])
    means = _with(log, log.time_s[1 : count - 1 : 2], over(force, 0.5), mean_rate)
    # the mean of a curve over three samples, by Simpson's rule
    usual = over(gravity(log), 2.0 / 3.0)
    return gravity(replace(means, sampling=Sampling.AVERAGED)), usual


def resampled(factor: float) -> Change:
    """Give it another rate by straight lines, the angular rate by its integral."""

    def changed(log: ImuLog) -> tuple[Floats, Floats] | None:
        if log.sampling is Sampling.AVERAGED:
            return None
        count = int((len(log) - 1) * factor)
        time_s = np.linspace(log.time_s[0], log.time_s[-1], count + 1)

        def at(values: Floats) -> Floats:
            columns = [np.interp(time_s, log.time_s, row) for row in values.T]
            return np.stack(columns, axis=1)

        steps = np.diff(log.time_s, prepend=log.time_s[0])
        angle = at(np.cumsum(log.angular_rate_radps * steps[:, None], axis=0))
        rate = np.diff(angle, axis=0) / np.diff(time_s)[:, None]
        rate = np.concatenate([log.angular_rate_radps[:1], rate])
        other = _with(log, time_s, at(log.specific_force_mps2), rate)
        return gravity(other), at(gravity(log))

    return changed


CUTS: dict[str, Change] = {
    "first half": cut(0.0, 0.5),
    "second half": cut(0.5, 1.0),
    "first 10 s off": cut(10.0, 1.0),
    "last 10 s off": cut(0.0, -10.0),
    "first 20% off": cut(0.2, 1.0),
    "last 20% off": cut(0.0, -0.2),
    "half the rate": halved,
    **{f"{factor:g} x the rate": resampled(factor) for factor in (0.8, 1.5)},
}


def changes(
    families: Sequence[Family],
    kinds: dict[str, Change],
    mark: str,
    text: str,
    report: Report,
) -> None:
    """Show by how much the gravity changes (RMS over all samples), by family."""
    figures: dict[str, dict[str, float]] = {}
    for family in families:
        figures[family.key] = {}
        for name, change in kinds.items():
            pairs = [pair for log in family.logs if (pair := change(log)) is not None]
            if pairs:
                apart = [np.linalg.norm(a - b, axis=1) for a, b in pairs]
                figures[family.key][name] = rms(np.concatenate(apart))
    rows = [
        [key, *(_short(found.get(name)) for name in kinds)]
        for key, found in figures.items()
    ]
    title = f"RMS change of the gravity when a recording is {text}, m/s^2"
    report.table(title, ["recordings", *kinds], rows)
    report.figures[mark] = figures


def _short(value: float | None) -> str:
    if value is None:
        return ""
    return "0" if value == 0.0 else f"{value:.0e}" if value < 1e-3 else f"{value:.3f}"


# --- condition of the smoother's equations -----------------------------------------


def problems(
    log: ImuLog, parameters: SmootherParameters | None = None
) -> list[Problem]:
    """Return the problems that the smoother minimises, in order."""
    held: list[Problem] = []

    def minimised(problem: Problem) -> Any:
        held.append(problem)
        return minimise(problem)

    with mock.patch.object(state, "minimise", minimised):
        remove_gravity(log, parameters=parameters)
    return held


def last_problem(log: ImuLog) -> Problem:
    """Return the final problem of a log in one block, however long it is."""
    return problems(log, UNDIVIDED)[-1]


def condition(band: Floats, *, scaled: bool) -> float:
    """Return largest over smallest eigenvalue of a lower band.

    Args:
        band: of a positive definite matrix.
        scaled: with a diagonal of ones, which is what counts for Cholesky's factor:
            units cost no digits. Infinite once the smallest is lost in rounding.
    """
    if scaled:
        scale, out = 1.0 / np.sqrt(band[0]), np.zeros_like(band)
        for below in range(len(band)):
            count = band.shape[1] - below
            out[below, :count] = band[below, :count] * scale[below:] * scale[:count]
        band = out
    try:
        factor = cholesky_banded(band, lower=True)
    except LinAlgError:
        return float("inf")

    def largest(product: Callable[[Floats], Floats]) -> float:
        size = band.shape[1]
        operator = LinearOperator((size, size), matvec=product, dtype=np.float64)
        start = np.random.default_rng(1).standard_normal(size)
        found = eigsh(operator, k=1, which="LA", tol=1e-3, v0=start)
        return float(found[0][0])

    top = largest(lambda x: np.asarray(_times(band, np.ravel(x))))
    return top * largest(
        lambda x: np.asarray(cho_solve_banded((factor, True), np.ravel(x)))
    )


def _times(band: Floats, vector: Any) -> Any:
    """Return A x for a lower band, in the precision of x."""
    out = band[0] * vector
    for below in range(1, len(band)):
        row = band[below, :-below]
        out[below:] += row * vector[:-below]
        out[:-below] += row * vector[below:]
    return out


def rounding_mps2(band: Floats, dtype: Any) -> float:
    """Return the error of gravity when a band is solved in one precision.

    The right side belongs to a known solution, tilts of a hundredth of a radian, and
    is made from it in long double; infinite where the factor fails.
    """
    wanted = 0.01 * np.random.default_rng(1).standard_normal(band.shape[1])
    right = _times(band.astype(np.longdouble), wanted.astype(np.longdouble))
    try:
        factor = cholesky_banded(band.astype(dtype), lower=True)
    except LinAlgError:
        return float("inf")
    found = cho_solve_banded((factor, True), right.astype(dtype))
    miss = np.abs(found.astype(np.float64) - wanted)[0::2]
    return float(STANDARD_GRAVITY_MPS2 * miss.max())


_HEADER = ["unknowns", "band", "band, scaled", "calibration, scaled", "error float64",
           "error float32"]  # fmt: skip


def _conditions(problem: Problem) -> list[Any]:
    band, solution = horizontal_band(problem), minimise(problem)
    covariance = solution.covariance_times(np.eye(len(solution.calibration)))
    scale = 1.0 / np.sqrt(np.diag(covariance))
    numbers = [condition(band, scaled=False), condition(band, scaled=True)]
    numbers.append(float(np.linalg.cond(covariance * scale * scale[:, None])))
    errors = [rounding_mps2(band, dtype) for dtype in (np.float64, np.float32)]
    shown = ["factor fails" if np.isinf(e) else f"{e:.0e}" for e in errors]
    return [band.shape[1], *(f"{value:.1e}" for value in numbers), *shown]


def conditions(families: Sequence[Family], lengths_s: Any, report: Report) -> None:
    """Show the worst recording of each family, and one undivided block by its length."""
    rows = []
    for family in families:
        found = [_conditions(last_problem(log)) for log in family.logs]
        rows.append([family.key, *max(found, key=lambda row: float(row[2]))])
    log = simulate_motion("handheld-brisk", 1, duration_s=lengths_s[-1]).imu
    for seconds in lengths_s:
        found = _conditions(last_problem(head(log, round(seconds * log.rate_hz))))
        rows.append([f"hand-held, {seconds / 60:g} min", *found])
    for name, *_, error, _rough in rows:
        limit = ("<=", ROUNDING_LIMIT_MPS2)
        report.target(f"{name}: rounding in float64, m/s^2", float(error), limit)
    title = (
        "Condition numbers of the smoother's last problem in one block, worst recording, "
        "and the largest error of gravity by rounding, m/s^2"
    )
    report.table(title, ["recordings", *_HEADER], rows)
    report.figures["condition"] = rows


def long_run(report: Report) -> None:
    """Process 10^7 samples; the error at the start, in the middle and at the end."""
    import vqf

    ride = simulate_motion("handheld-brisk", 1, duration_s=LONG / LONG_HZ)
    log, interval_s = ride.imu, 1.0 / ride.imu.rate_hz
    rate, force = np.array(log.angular_rate_radps), np.array(log.specific_force_mps2)
    q = {"smoother": remove_gravity(log).quaternion_wxyz}
    q["VQF"] = vqf.VQF(interval_s).updateBatch(rate, force)["quat6D"]
    q["offlineVQF"] = vqf.offlineVQF(rate, force, None, interval_s)["quat6D"]
    part = len(log) // 100
    ends = [slice(at, at + part) for at in (0, len(log) // 2, len(log) - part)]
    rows = []
    for name, quaternion in q.items():
        errors = []
        for end in ends:
            turned = Rotation.from_quat(quaternion[end], scalar_first=True)
            up = turned.inv().apply([0.0, 0.0, 1.0])
            chord = np.linalg.norm(up - ride.vertical[end], axis=1)
            errors.append(rms(np.degrees(2.0 * np.arcsin(0.5 * chord))))
        norm = float(np.abs(np.linalg.norm(quaternion, axis=1) - 1.0).max())
        rows.append([name, *(f"{error:.3f}" for error in errors), f"{norm:.0e}"])
    title = (
        f"{len(log):.0e} samples: RMS inclination error of the first, "
        "middle and last hundredth, deg, and the largest error of a quaternion's norm"
    )
    header = ["method", "first", "middle", "last", "norm"]
    report.table(title, header, rows)
    report.figures["long"] = rows
