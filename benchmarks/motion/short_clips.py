"""Gravity left in clips of 10 to 30 s: right and spoilt sensors, and what helps.

Clips of 10, 20 and 30 s of every recording with a known vertical, native and at 30 Hz, as
they are and with one flaw of the sensor each, beside offlineVQF on the same samples. Then
clips of 10 s of the optical recordings at native rate: alone, cut from the estimate of
the whole log, and with the calibration of the half of the log which the clip is not in.
"""

import argparse
import itertools
import zlib
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from benchmarks.common import Report, on_one_thread, rms
from benchmarks.motion.recordings import (
    GRAVITY_MPS2,
    NATIVE,
    QUICK_NAMES,
    Family,
    TruthRecording,
    add_options,
    chosen,
)
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.motion import SmootherParameters, analyse, remove_gravity
from tools.optical import OPTICAL, offline_vqf_up

CLIP_S = 10.0
WAYS = ("alone", "whole log", "calibration", "offlineVQF alone")
# Of phones, whose gyro bias of 4 deg/s is what ten seconds do not tell.
LIMITS_MPS2 = {"whole log": 0.30, "calibration": 0.35}

LENGTHS_S = (10.0, 20.0, 30.0)
BIAS_RADPS, STEP_RADPS = np.radians(5.0), np.radians(1.0)
MAX_RATIO, COVERAGE, MAX_SIGMA = 1.1, (0.88, 0.99), 1.6
MANY_TIMES_WORSE = 1.5
# Of a clip at least so much must count for error figures.
MIN_SCORED_SHARE = 0.1


def _biased(imu: ImuLog, seed: int) -> ImuLog:
    axis = np.random.default_rng(seed).standard_normal(3)
    bias_radps = BIAS_RADPS * axis / np.linalg.norm(axis)
    return replace(imu, angular_rate_radps=imu.angular_rate_radps + bias_radps)


def _stepped(imu: ImuLog, _: int) -> ImuLog:
    steps = np.round(imu.angular_rate_radps / STEP_RADPS)
    return replace(imu, angular_rate_radps=STEP_RADPS * steps)


FLAWS: dict[str, Callable[[ImuLog, int], ImuLog]] = {
    "as is": lambda imu, _: imu,
    "bias 5 deg/s": _biased,
    "gyro 5 % fast": lambda imu, _: replace(
        imu, angular_rate_radps=1.05 * imu.angular_rate_radps
    ),
    "steps of 1 deg/s": _stepped,
    "accelerometer 4 % low": lambda imu, _: replace(
        imu, specific_force_mps2=0.96 * imu.specific_force_mps2
    ),
}


class ClipScore(NamedTuple):
    """One clip with one flaw: RMS errors, and how well sigma tells ours."""

    kind: str
    rate: str
    length_s: float
    flaw: str
    error_mps2: float
    peer_mps2: float
    within: float
    sigma_mps2: float
    samples: int


def options(parser: argparse.ArgumentParser) -> None:
    add_options(parser, seeds=1)
    text = "clips of each recording and length, evenly spread (6)"
    parser.add_argument("--clips", type=int, default=6, help=text)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure the clips of each family."""
    on_one_thread()
    families = chosen(options)
    beside_peer(families, 1 if options.quick else options.clips, report)
    optical = [f for f in families if f.name in OPTICAL and f.rate == NATIVE]
    if optical:
        what_helps(optical, report, is_quick=options.quick)


def beside_peer(families: list[Family], clips: int, report: Report) -> None:
    """Measure clips of each length with each flaw beside offlineVQF."""
    jobs = [(r, f.name, f.rate, clips) for f in families for r in f.recordings]
    with ProcessPoolExecutor() as pool:
        found = [one for part in pool.map(clip_scores, jobs) for one in part]
    rows, cells = [], dict[str, list[dict[str, float]]]()
    by_place = sorted(found, key=lambda one: one[:3])
    for place, group in itertools.groupby(by_place, key=lambda one: one[:3]):
        held, shown = list(group), list[str]()
        for flaw in FLAWS:
            cell = summary([one for one in held if one.flaw == flaw])
            cells.setdefault(flaw, []).append(cell)
            ratio = f"{cell['ratio']:.2f}, {cell['within']:.2f}"
            if flaw == "as is":
                shown += [f"{cell['error_mps2']:.3f}", f"{cell['peer_mps2']:.3f}"]
                shown += [f"{cell['above']:.2f}", f"{cell['sigma_over_rms']:.2f}"]
            shown.append(ratio)
            key = f"{place[0]} {place[1]}, {place[2]:g} s, {flaw}"
            report.figures.setdefault("clips", {})[key] = cell
        kind, rate, length_s = place
        rows.append(
            [f"{kind} {rate}", f"{length_s:g} s", len(held) // len(FLAWS), *shown]
        )
    header = ["recordings", "clip", "n", "error", "offlineVQF", "above 1.5", "sigma"]
    title = "Clips, m/s^2; error of offlineVQF's and share within 2 sigma by flaw"
    report.table(title, [*header, *FLAWS], rows, mark="short")
    for flaw, held in cells.items():
        _judge(flaw, held, report)


def _judge(flaw: str, cells: list[dict[str, float]], report: Report) -> None:
    """Note the worst of all families and lengths with a flaw."""
    within = [cell["within"] for cell in cells]
    worst = max(cell["ratio"] for cell in cells)
    report.target(f"{flaw}: worst error, of offlineVQF", worst, ("<=", MAX_RATIO))
    report.target(f"{flaw}: least within 2 sigma", min(within), (">=", COVERAGE[0]))
    report.target(f"{flaw}: most within 2 sigma", max(within), ("<=", COVERAGE[1]))
    sigmas = [cell["sigma_over_rms"] for cell in cells]
    report.target(f"{flaw}: most median sigma / RMS", max(sigmas), ("<=", MAX_SIGMA))
    told = np.mean(
        [
            COVERAGE[0] <= inside <= COVERAGE[1] and sigma <= MAX_SIGMA
            for inside, sigma in zip(within, sigmas, strict=True)
        ]
    )
    what = f"{flaw}: share of families and lengths with such sigmas"
    report.target(what, float(told), (">=", 1.0))


def summary(scores: list[ClipScore]) -> dict[str, float]:
    """The figures of some clips; errors are means over them."""
    ours = np.array([one.error_mps2 for one in scores])
    peer = np.array([one.peer_mps2 for one in scores])
    weight = np.array([one.samples for one in scores], dtype=float)
    overall = np.sqrt(np.average(np.square(ours), weights=weight))
    sigma = np.median([one.sigma_mps2 for one in scores])
    return {
        "error_mps2": float(ours.mean()),
        "peer_mps2": float(peer.mean()),
        "ratio": float(ours.mean() / peer.mean()),
        "above": float(np.mean(ours > MANY_TIMES_WORSE * peer)),
        "within": float(np.average([one.within for one in scores], weights=weight)),
        "sigma_over_rms": float(sigma / overall),
    }


def clip_scores(job: tuple[TruthRecording, str, str, int]) -> list[ClipScore]:
    """The scores of a recording's clips, so many of each length, with each flaw."""
    recording, family, rate, clips = job
    kind, time_s = _kind(family, recording.scene), recording.imu.time_s
    found = []
    for length_s in LENGTHS_S:
        starts = np.arange(time_s[0], time_s[-1] - length_s + 0.5, length_s)
        count = min(clips, len(starts))
        chosen_at = np.linspace(0, len(starts) - 1, count).round().astype(int)
        for start_s in starts[chosen_at].tolist():
            ends = np.searchsorted(time_s, [start_s, start_s + length_s])
            part = slice(*ends.tolist())
            if recording.scored[part].mean() < MIN_SCORED_SHARE:
                continue
            seed = zlib.crc32(f"{recording.name} {start_s:.3f}".encode())
            for flaw, spoil in FLAWS.items():
                clip = spoil(recording.imu.part(part), seed)
                scores = _scores(recording, part, clip)
                found.append(ClipScore(kind, rate, length_s, flaw, *scores))
    return found


def _scores(
    recording: TruthRecording, part: slice, clip: ImuLog
) -> tuple[float, float, float, float, int]:
    track, counted = remove_gravity(clip), recording.scored[part]
    errors = _errors(recording, part, track.gravity_mps2 / STANDARD_GRAVITY_MPS2)
    assert track.gravity_sigma_mps2 is not None
    sigma = track.gravity_sigma_mps2[counted]
    peer = _errors(recording, part, offline_vqf_up(clip))
    within = float(np.mean(errors <= 2.0 * sigma))
    return rms(errors), rms(peer), within, float(np.median(sigma)), len(errors)


def _kind(family: str, scene: str) -> str:
    if not family.startswith("sim-"):
        return family
    if scene.startswith("car"):
        return "sim-cars"
    if scene in ("walk", "run"):
        return "sim-walking"
    return "sim-hands" if scene.startswith("handheld") else "sim-bikes"


# --- what helps clips of 10 s -------------------------------------------------------


def what_helps(families: list[Family], report: Report, *, is_quick: bool) -> None:
    """Measure clips alone, cut from the whole log, and with a calibration."""
    rows = []
    for family in families:
        held = family.recordings
        if is_quick:
            held = [one for one in held if one.name in QUICK_NAMES]
        errors = np.array([clip for one in held for clip in clips(one)])
        means = dict(zip(WAYS, errors.mean(axis=0).tolist(), strict=True))
        report.figures.setdefault("error_mps2", {})[family.name] = means
        rows.append([family.name, len(errors), *(f"{v:.3f}" for v in means.values())])
        if family.name == "tyrex" and not is_quick:
            for way, limit in LIMITS_MPS2.items():
                report.target(f"tyrex, 10 s, {way}: m/s^2", means[way], ("<=", limit))
    header = ["recordings", "clips", *WAYS]
    report.table("Gravity error of clips of 10 s, m/s^2", header, rows, mark="clips")


def clips(recording: TruthRecording) -> Iterator[tuple[float, float, float, float]]:
    """Yield the errors of each clip that counts, in the order of WAYS."""
    imu = recording.imu
    begin_s, end_s = float(imu.time_s[0]), float(imu.time_s[-1])
    middle_s = 0.5 * (begin_s + end_s)
    whole = remove_gravity(imu).gravity_mps2 / STANDARD_GRAVITY_MPS2
    middle = int(np.searchsorted(imu.time_s, middle_s))
    of_first = analyse(imu.part(slice(middle))).calibration
    of_second = analyse(imu.part(slice(middle, None))).calibration
    for start_s in np.arange(begin_s, end_s - CLIP_S, CLIP_S).tolist():
        low, high = np.searchsorted(imu.time_s, [start_s, start_s + CLIP_S]).tolist()
        part = slice(low, high)
        is_across = start_s < middle_s < start_s + CLIP_S
        if is_across or not recording.scored[part].any():
            continue
        other = of_second if start_s < middle_s else of_first
        clip = imu.part(part)
        ups = (
            _up(clip, None),
            whole[part],
            _up(clip, other),
            offline_vqf_up(clip),
        )
        alone, cut, known, peer = (_error(recording, part, up) for up in ups)
        yield alone, cut, known, peer


def _up(clip: ImuLog, calibration: SensorCalibration | None) -> Floats:
    known = calibration and calibration.for_another_recording()
    parameters = SmootherParameters(calibration=known)
    gravity = remove_gravity(clip, parameters=parameters).gravity_mps2
    return gravity / STANDARD_GRAVITY_MPS2


def _error(recording: TruthRecording, part: slice, up: Floats) -> float:
    return rms(_errors(recording, part, up))


def _errors(recording: TruthRecording, part: slice, up: Floats) -> Floats:
    miss = (up - recording.up[part])[recording.scored[part]]
    return np.asarray(GRAVITY_MPS2 * np.linalg.norm(miss, axis=1))
