"""Synchronisation by the camera's rotation in its frames, beside three pats.

Clips of 28 s of simulated rides whose log has another clock (offset up to 60 s, rate up to
80 ppm off), any of 24 mountings and 2 degrees of misalignment; rolling shutters of 0 to
30 ms; handlebar, dashboard and the horse's head are in the frames. Each is also compared
with logs of other rides: then any confident answer is a wrong one. Films are drawn once
and kept in the folder for temporary files. Errors are those at the middle of the clip.
"""

import argparse
import time
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.common import DATA, Report, on_one_thread
from benchmarks.sync.picture_clips import (
    RATES_HZ,
    SCENES,
    PictureClip,
    picture_clip,
)
from hapticplayer.capture import read_recording
from hapticplayer.capture.sync.pictures import synchronize_pictures
from hapticplayer.capture.sync.result import CLEAR_RATIO, Synchronisation
from hapticplayer.capture.sync.synchronize import (
    Sound,
    SyncInput,
    by_pats,
    joined_findings,
)
from hapticplayer.capture.vision import FrameRotation, rotation
from hapticplayer.errors import InputError
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ImuLog
from hapticplayer.simulation.film.sound import RATE_HZ as SOUND_RATE_HZ

GROSS_S = 0.1
LIMITS_MS = {"median": 2.5, "p95": 5.0, "largest": 8.0}
MOST_CPU_S = 16.0
SURE = (0.5, 0.9)
# name, whether its frames can be trusted
REAL = (("karma.mp4", True), ("max-heromode.mp4", False))


@dataclass(frozen=True)
class Outcome:
    """One log: by each method the error in s, and its confidence."""

    scene: str
    rate_hz: int
    error_s: dict[str, float]
    confidence: dict[str, float]
    sigma_s: float
    drift_error_ppm: float
    fit_s: float
    strangers: list[float]
    mounting_ratio: float = np.nan
    mounting_is_right: bool = False


def middle_error_s(clip: PictureClip, found: Synchronisation) -> float:
    """Return the error in media time of what was logged at the middle of the clip."""
    middle_s = 0.5 * clip.duration_s
    log_s = (middle_s - clip.clock_map.offset_s) / clip.clock_map.rate
    return found.media_s(log_s) - middle_s


def outcome(
    scene: str, clip: PictureClip, frames: FrameRotation, strangers: list[ImuLog]
) -> Outcome:
    """Synchronise by pictures, pats and both."""
    sound = Sound(clip.audio.mean(axis=1), SOUND_RATE_HZ)
    start = time.process_time()
    pictures = synchronize_pictures(clip.imu, frames)
    fit_s = time.process_time() - start
    pats = by_pats(SyncInput(clip.imu, lambda: sound))
    found = {
        "pictures": pictures,
        "pats": pats,
        "both": joined_findings(pats, pictures),
    }
    return Outcome(
        scene,
        200 if clip.imu.rate_hz > 100 else 30,
        {name: middle_error_s(clip, one) for name, one in found.items()},
        {name: one.clock_map.confidence for name, one in found.items()},
        pictures.offset_sigma_s,
        pictures.drift_ppm - 1e6 * (clip.clock_map.rate - 1.0),
        fit_s,
        [synchronize_pictures(log, frames).clock_map.confidence for log in strangers],
        *(
            (mounting.ratio, mounting.axes == clip.axes)
            if (mounting := pictures.mounting) is not None
            else ()
        ),
    )


def simulated(seeds: range, scenes: tuple[str, ...], report: Report) -> list[Outcome]:
    """Run all clips; each has two logs, and three of other rides for each of them."""
    outcomes = []
    for seed in seeds:
        for scene in scenes:
            frames: FrameRotation | None = None
            for rate_hz in RATES_HZ:
                clip = picture_clip(scene, seed, rate_hz)
                if frames is None:
                    frames = rotation(clip.path)
                other = SCENES[(SCENES.index(scene) + 1) % len(SCENES)]
                strangers = [
                    picture_clip(scene, seed + 1000, rate_hz, draw=False).imu,
                    picture_clip(other, seed, rate_hz, draw=False).imu,
                    picture_clip(other, seed + 1000, rate_hz, draw=False).imu,
                ]
                outcomes.append(outcome(scene, clip, frames, strangers))
            print(f"seed {seed}: {scene}", flush=True)
    _tables(outcomes, report)
    return outcomes


def figures(outcomes: list[Outcome], method: str) -> dict[str, Any]:
    """Return how many are confident, and their errors in ms."""
    sure = [one for one in outcomes if one.confidence[method] >= SURE[0]]
    errors_ms = 1e3 * np.abs([one.error_s[method] for one in sure])
    some = len(errors_ms) > 0
    return {
        "logs": len(outcomes),
        "confident": len(sure),
        "median": float(np.median(errors_ms)) if some else np.nan,
        "p95": float(np.percentile(errors_ms, 95)) if some else np.nan,
        "largest": float(errors_ms.max()) if some else np.nan,
    }


def _tables(outcomes: list[Outcome], report: Report) -> None:
    rows, columns = [], ["clips", "method"]
    groups = {f"{rate_hz} Hz": (None, rate_hz) for rate_hz in RATES_HZ}
    groups |= {
        scene: (scene, None) for scene in dict.fromkeys(o.scene for o in outcomes)
    }
    for name, (scene, rate_hz) in groups.items():
        chosen = [
            one
            for one in outcomes
            if scene in (None, one.scene) and rate_hz in (None, one.rate_hz)
        ]
        for method in ("pictures", "pats", "both"):
            found = figures(chosen, method)
            rows.append([name, method, *found.values()])
            columns = ["clips", "method", *found]
            if method == "pictures" and scene is None:
                for key, limit in LIMITS_MS.items():
                    what = f"{name}: error of confident ones, {key}, ms"
                    report.target(what, found[key], ("<=", limit))
    report.table("Errors of confident results, ms", columns, rows)
    report.figures |= {"columns": columns, "rows": rows}
    strangers = [confidence for one in outcomes for confidence in one.strangers]
    accepted = sum(confidence >= SURE[0] for confidence in strangers)
    report.target(f"accepted of {len(strangers)} wrong pairs", accepted, ("<=", 0))
    report.figures["outcomes"] = [vars(one) for one in outcomes]
    clear = [one for one in outcomes if one.mounting_ratio >= CLEAR_RATIO]
    right = sum(one.mounting_is_right for one in clear)
    what = f"wrong of {len(clear)} mountings with a ratio of {CLEAR_RATIO:g} or more"
    report.target(what, len(clear) - right, ("<=", 0))
    levels = []
    for low, high in ((0.0, 0.1), (0.1, 0.5), (0.5, 0.9), (0.9, 1.01)):
        here = [
            abs(one.error_s["pictures"]) <= 1e-3 * LIMITS_MS["largest"]
            for one in outcomes
            if low <= one.confidence["pictures"] < high
        ]
        levels.append([f"{low:g} to {min(high, 1.0):g}", len(here), sum(here)])
    report.table(
        "Confidence of pictures", ["confidence", "logs", "within 8 ms"], levels
    )
    report.figures["levels"] = levels


def cost(clip: PictureClip, report: Report) -> None:
    """Measure the CPU time of telling the rotation."""
    start = time.process_time()
    frames = rotation(clip.path)
    per_frame_s = (time.process_time() - start) / len(frames)
    report.figures["cpu_s_per_minute"] = 1800 * per_frame_s
    what = "CPU s per minute at 30 Hz, small frames"
    report.target(what, 1800 * per_frame_s, ("<=", MOST_CPU_S))


def real(report: Report) -> None:
    """Synchronise real clips with their own gyro, whose offset is near zero."""
    rows = []
    for name, is_usable in REAL:
        path = DATA / "capture" / "gopro" / name
        if not path.exists():
            print(f"without {name}, which is not on this machine")
            continue
        imu = read_recording(path).imu
        try:
            found = synchronize_pictures(imu, rotation(path))
        except InputError as problem:
            print(f"{name}: {problem}")
            continue
        middle_s = 0.5 * probe(path).duration_s
        shift_s = found.media_s(middle_s) - middle_s
        explained = found.pictures.explained if found.pictures else 0.0
        confidence = found.clock_map.confidence
        rows.append([name, 1e3 * shift_s, 1e3 * found.offset_sigma_s, explained,
                     confidence])  # fmt: skip
        if not is_usable:
            what = f"{name} (stabilised): confidence"
            report.target(what, confidence, ("<=", 0.49))
    header = ["real clip", "offset ms", "sigma ms", "explained", "confidence"]
    report.table("Real clips against their own gyro", header, rows)
    report.figures["real"] = [dict(zip(header, row, strict=True)) for row in rows]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--clips", type=int, help="of each scene (100; quick: 1)")
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--scenes", nargs="*", choices=SCENES, default=None)


def run(options: argparse.Namespace, report: Report) -> None:
    """Synchronise all clips."""
    on_one_thread()
    quick, first = options.quick, options.seed
    clips = (1 if quick else 100) if options.clips is None else options.clips
    scenes = tuple(options.scenes or (("horse", "bike") if quick else SCENES))
    report.figures |= {"clips": clips, "first_seed": first}
    simulated(range(first, first + clips), scenes, report)
    cost(picture_clip(scenes[0], first, RATES_HZ[0]), report)
    real(report)
