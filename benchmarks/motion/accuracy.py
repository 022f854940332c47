"""Gravity left in the motion, beside offlineVQF; how well sigma tells it; leak at rest.

The error of a recording is the RMS of 9.81 ||u_est - u_true|| over its moving samples,
that of a family the mean over its recordings. Calibration of sigma on simulated rides
is judged by many seeds: what a family gives hangs on the few rides that go wrong.
"""

import argparse
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import Report, on_one_thread, rms
from benchmarks.motion.recordings import (
    Family,
    TruthRecording,
    add_options,
    chosen,
    scenes_of,
    simulated,
)
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion import DEFAULT_METHOD, METHODS, analyse, remove_gravity
from hapticplayer.motion.smoother import SmootherParameters
from tools.optical import offline_vqf_up

Floats = NDArray[np.float64]
REFERENCE = "offlineVQF"
TAUS_S = (1.0, 10.0, 20.0)  # other settings of the reference; its default is 3 s
# What is asked of the default method: m/s^2, or a multiple of offlineVQF's error.
LIMITS_MPS2 = {"broad native": 0.073, "broad 30 Hz": 0.097, "car native": 0.2}
LIMITS_RATIO = {
    "tumvi native": 0.65,
    "tumvi 30 Hz": 0.65,
    "tyrex native": 0.45,
    "tyrex 30 Hz": 0.5,
    "repoimu_TStick native": 1.1,
    "repoimu_TStick 30 Hz": 0.8,
    "repoimu_Pendulum native": 1.1,
    "repoimu_Pendulum 30 Hz": 0.8,
}
# What --leave-one-out chooses from.
CANDIDATES = tuple(
    SmootherParameters(gyro_evidence=evidence, floor_sigmas=sigmas)
    for evidence in (1.0, 2.5, 5.0, 1e9)
    for sigmas in (1.5, 1.75, 2.0, 2.5)
)
LEAK_LIMIT_MPS2 = 0.05
COVERAGE, SIGMA_LIMIT = (0.90, 0.99), 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Score:
    """One method on one recording.

    Attributes:
        name: of the recording.
        scene: of a simulated one, else its family.
        errors_mps2: of each scored sample.
        sigma_mps2: what the method says of it, or None.
        leak_mps2: at rest, or None without a stationary span.
        still_s: time of the stationary spans.
    """

    name: str
    scene: str
    errors_mps2: Floats
    sigma_mps2: Floats | None = None
    leak_mps2: float | None = None
    still_s: float = 0.0


Scores = dict[str, dict[str, list[Score]]]
"""By family key and method; the reference is one of the methods."""


def score(recording: TruthRecording, method: str) -> Score:
    """The result of a method for a recording."""
    if method.startswith(REFERENCE):
        tau_s = float(method.partition("tauAcc ")[2] or 3.0)
        errors = recording.errors_mps2(offline_vqf_up(recording.imu, tau_s=tau_s))
        return Score(recording.name, recording.scene, errors)
    done = analyse(recording.imu, method)
    track, summary = done.track, done.summary
    sigma = track.gravity_sigma_mps2
    return Score(
        recording.name,
        recording.scene,
        recording.errors_mps2(track.gravity_mps2 / STANDARD_GRAVITY_MPS2),
        None if sigma is None else sigma[recording.scored],
        summary["leak_at_rest_mps2"],
        summary["still_s"],
    )


def mean_error_mps2(scores: Iterable[Score]) -> float:
    """Return the mean over recordings of their gravity errors."""
    return float(np.mean([rms(one.errors_mps2) for one in scores]))


class Calibration(NamedTuple):
    """Share within 2 sigma, in all and in the worst one; median sigma over RMS."""

    within: float
    lowest: float
    sigma_over_rms: float


def calibration(scores: Sequence[Score]) -> Calibration | None:
    """Return how well a method knows its own error; None without sigmas."""
    if any(one.sigma_mps2 is None for one in scores):
        return None
    inside = [one.errors_mps2 <= 2.0 * np.asarray(one.sigma_mps2) for one in scores]
    errors = np.concatenate([one.errors_mps2 for one in scores])
    sigma = np.concatenate([np.asarray(one.sigma_mps2) for one in scores])
    lowest = float(min(part.mean() for part in inside))
    within = float(np.mean(np.concatenate(inside)))
    return Calibration(within, lowest, float(np.median(sigma)) / rms(errors))


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    add_options(parser, seeds=3)
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=list(METHODS))
    many = "simulated rides of each scene to judge sigma by (24)"
    left = "choose the parameters of a noisy gyro on all families but one, for each"
    parser.add_argument("--leave-one-out", action="store_true", help=left)
    parser.add_argument("--sigma-seeds", type=int, default=24, help=many)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure every method on every recording."""
    on_one_thread()
    families = chosen(options)
    if options.leave_one_out:
        leave_one_out(families, report)
        return
    others = [f"{REFERENCE}, tauAcc {tau:g}" for tau in TAUS_S]
    methods = [*options.methods, REFERENCE, *([] if options.quick else others)]
    scores: Scores = {}
    for family in families:
        for key, held in (
            (family.key, family.recordings),
            (f"{family.key}, one with a hole", family.apart),
        ):
            if held:
                scores[key] = {m: [score(r, m) for r in held] for m in methods}
    errors(scores, options.methods, report, is_whole=not options.quick)
    scenes(families, scores, report)
    if DEFAULT_METHOD in options.methods:
        leaks(scores, report)
        rides = {} if options.quick else many_rides(families, options.sigma_seeds)
        sigmas(scores, rides, report, is_whole=not options.quick)


def errors(
    scores: Scores, methods: Sequence[str], report: Report, *, is_whole: bool
) -> None:
    """Show the mean errors; the limits are those of all recordings."""
    rows = []
    for key, held in scores.items():
        means = {name: mean_error_mps2(held[name]) for name in held}
        ours = means.get(DEFAULT_METHOD, np.nan)
        ratio = ours / means[REFERENCE]
        best = min(mean for name, mean in means.items() if name.startswith(REFERENCE))
        ratios = {"default": ratio, "best of its settings": ours / best}
        report.figures.setdefault("ratio", {})[key] = ratios
        limit = ""
        if key in LIMITS_MPS2:
            limit = f"{LIMITS_MPS2[key]:.3f}"
        elif key in LIMITS_RATIO:
            limit = f"{LIMITS_RATIO[key]:.2f} x"
        if is_whole and key in LIMITS_MPS2:
            report.target(f"{key}: error, m/s^2", ours, ("<=", LIMITS_MPS2[key]))
        elif is_whole and key in LIMITS_RATIO:
            what = f"{key}: error, of {REFERENCE}"
            report.target(what, ratio, ("<=", LIMITS_RATIO[key]))
        shown = [f"{means[name]:.4f}" for name in (*methods, REFERENCE)]
        shown += [f"{one:.2f}" for one in ratios.values()]
        rows.append([key, len(held[REFERENCE]), *shown, limit])
        report.figures.setdefault("error_mps2", {})[key] = means
    header = ["recordings", "n", *methods, REFERENCE, "ratio", "of its best", "limit"]
    report.table("Mean gravity error, m/s^2", header, rows)


def leave_one_out(families: Sequence[Family], report: Report) -> None:
    """Show the error of each family with the parameters that suit the others best."""
    names = list(dict.fromkeys(family.name for family in families))
    reference = {f.key: mean_error_mps2(score(r, REFERENCE) for r in f.recordings)
                 for f in families}  # fmt: skip
    ratios = []
    for candidate in CANDIDATES:
        ours = {f.key: np.mean([rms(_error_mps2(r, candidate)) for r in f.recordings])
                for f in families}  # fmt: skip
        ratios.append({key: float(ours[key] / reference[key]) for key in ours})
    rows = []
    for name in names:
        kept = [f.key for f in families if f.name != name]
        costs = [np.mean([np.log(one[key]) for key in kept]) for one in ratios]
        best = int(np.argmin(costs))
        chosen_here = CANDIDATES[best]
        for family in families:
            if family.name == name:
                row = [family.key, chosen_here.gyro_evidence]
                row += [chosen_here.floor_sigmas, f"{ratios[best][family.key]:.2f}"]
                rows.append(row)
                what = f"{family.key}: error left out, of {REFERENCE}"
                limit = LIMITS_RATIO.get(family.key, 1.1)
                report.target(what, ratios[best][family.key], ("<=", limit))
    header = ["left out", "evidence", "sigmas", f"error, of {REFERENCE}"]
    report.table("One family left out", header, rows)


def _error_mps2(recording: TruthRecording, parameters: SmootherParameters) -> Floats:
    track = remove_gravity(recording.imu, parameters=parameters)
    return recording.errors_mps2(track.gravity_mps2 / STANDARD_GRAVITY_MPS2)


def scenes(families: Sequence[Family], scores: Scores, report: Report) -> None:
    """Show simulated rides scene by scene."""
    rows = []
    for family in families:
        held = scores[family.key]
        if DEFAULT_METHOD not in held or not family.name.startswith("sim-"):
            continue
        for scene in dict.fromkeys(one.scene for one in held[REFERENCE]):
            ours, theirs = (
                mean_error_mps2(one for one in held[name] if one.scene == scene)
                for name in (DEFAULT_METHOD, REFERENCE)
            )
            rows.append([scene, family.rate, f"{ours:.3f}", f"{theirs:.3f}",
                         f"{ours / theirs:.2f}"])  # fmt: skip
    if rows:
        header = ["scene", "rate", DEFAULT_METHOD, REFERENCE, "ratio"]
        report.table("Simulated rides, m/s^2", header, rows)


def leaks(scores: Scores, report: Report) -> None:
    """Show what is left of gravity where the sensor is stationary."""
    rows = [
        [one.name, key, f"{one.still_s:.1f}", one.leak_mps2]
        for key, held in scores.items()
        for one in held[DEFAULT_METHOD]
        if one.leak_mps2 is not None
    ]
    report.table("Leak at rest, m/s^2", ["recording", "", "s", "leak"], rows)
    if rows:
        worst = max(row[-1] for row in rows)
        report.target("leak at rest, m/s^2", worst, ("<=", LEAK_LIMIT_MPS2))


Rides = dict[str, dict[int, list[Score]]]
"""By family key and seed."""


def many_rides(families: Sequence[Family], seeds: int) -> Rides:
    """Score the default method on many simulated rides, on all cores."""
    rides = [
        (family.key, (scene, sensor, seed))
        for family in families
        if family.name.startswith("sim-")
        for scene, sensor in scenes_of(family.name, family.rate)
        for seed in range(1, seeds + 1)
    ]
    found: Rides = {}
    with ProcessPoolExecutor() as pool:
        scores = pool.map(_score_ride, [ride for _, ride in rides], chunksize=4)
        for (key, (_, _, seed)), one in zip(rides, scores, strict=True):
            found.setdefault(key, {}).setdefault(seed, []).append(one)
    return found


def _score_ride(ride: tuple[str, str, int]) -> Score:
    return score(simulated(*ride), DEFAULT_METHOD)


def sigmas(scores: Scores, rides: Rides, report: Report, *, is_whole: bool) -> None:
    """Show how well sigma tells the error."""
    rows: list[list[Any]] = []
    for key, held in scores.items():
        for name in held:
            is_ours = name == DEFAULT_METHOD
            by_seed = rides.get(key, {}) if is_ours else {}
            judged = [one for seed in by_seed.values() for one in seed] or held[name]
            known = calibration(judged)
            if known is None:
                continue
            shown = [f"{known.within:.3f}", f"{known.lowest:.3f}"]
            rows.append([key, name, len(judged), *shown, f"{known.sigma_over_rms:.2f}"])
            if is_ours:
                report.figures.setdefault("sigma", {})[key] = known._asdict()
            if is_ours and is_whole and "hole" not in key:
                what = f"{key}: within 2 sigma"
                report.target(what, known.within, (">=", COVERAGE[0]))
                report.target(what, known.within, ("<=", COVERAGE[1]))
                what = f"{key}: median sigma / RMS"
                report.target(what, known.sigma_over_rms, ("<=", SIGMA_LIMIT))
    report.table(
        "How well sigma tells the error",
        ["recordings", "method", "n", "within 2 sigma", "worst", "sigma / RMS"],
        rows,
    )
