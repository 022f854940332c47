"""What the comparison of films with logs gave, as tables."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from benchmarks.common import Report
from benchmarks.motion.budget import make_ride, shifted
from benchmarks.sync.frame_clips import RATES_HZ
from hapticplayer.capture.frames import FrameRotation
from hapticplayer.capture.mounting import gravity_agrees, mean_up
from hapticplayer.capture.sync.result import CLEAR_RATIO, Synchronisation
from hapticplayer.errors import InputError
from hapticplayer.extras.frames.synchronizing import synchronize_frames
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

METHODS = ("frames", "pats", "both")
LIMITS_MS = {"median": 2.5, "p95": 5.0, "largest": 8.0}
WINDOW_LIMITS_MS = {"median": 3.0, "p95": 8.0}
MOST_CPU_S = 16.0
SURE = 0.5
MIRRORED = "mirrored"
PAPER_SCENES = ("bike", "horse", "car-turning", "car-braking")


@dataclass(frozen=True)
class Outcome:
    """One log: by each method the error in s and its confidence; and the windows."""

    scene: str
    rate_hz: int
    error_s: dict[str, float]
    confidence: dict[str, float]
    drift_error_ppm: float
    fit_s: float
    read_out_error_s: float = np.nan
    mounting_ratio: float = np.nan
    mounting_is_right: bool = False
    window_error_s: Floats = field(default_factory=lambda: np.zeros(0))


@dataclass
class Found:
    """What all films and logs gave: outcomes, and confidences by wrong kind."""

    outcomes: list[Outcome] = field(default_factory=list)
    wrong: dict[str, list[float]] = field(default_factory=dict)
    cpu_s_per_minute: list[float] = field(default_factory=list)

    def note(self, kind: str, log: ImuLog, frames: FrameRotation) -> None:
        """Synchronise what does not belong together.

        A mirrored clip rotates as one that stands on its head: its time is right, and
        what has to be flagged is the mounting.
        """
        try:
            found = synchronize_frames(log, frames)
            confidence = found.clock_map.confidence
            if kind == MIRRORED and _is_upside_down(log, found):
                confidence = 0.0
        except InputError:  # refused
            confidence = 0.0
        self.wrong.setdefault(kind, []).append(confidence)


def _is_upside_down(log: ImuLog, found: Synchronisation) -> bool:
    """Whether gravity contradicts the mounting, as `sequence.mounting_by_frames` asks."""
    up = mean_up(log)
    if found.mounting is None or up is None:
        return True
    return not gravity_agrees(up, found.mounting.axes)


def figures(outcomes: list[Outcome], method: str) -> dict[str, Any]:
    sure = [one for one in outcomes if one.confidence[method] >= SURE]
    errors_ms = 1e3 * np.abs([one.error_s[method] for one in sure])
    return {"logs": len(outcomes), "confident": len(sure), **_spread(errors_ms)}


def _spread(errors_ms: Floats) -> dict[str, float]:
    if not len(errors_ms):
        return dict.fromkeys(LIMITS_MS, float("nan"))
    return {
        "median": float(np.median(errors_ms)),
        "p95": float(np.percentile(errors_ms, 95)),
        "largest": float(errors_ms.max()),
    }


def write_tables(found: Found, report: Report) -> None:
    """Write errors, windows, wrong pairs, mountings and confidence levels."""
    outcomes = found.outcomes
    rows, columns = [], ["clips", "method"]
    for name, chosen in _groups(outcomes).items():
        for method in METHODS:
            one = figures(chosen, method)
            rows.append([name, method, *one.values()])
            columns = ["clips", "method", *one]
            if method == "frames" and name.endswith("Hz"):
                for key, limit in LIMITS_MS.items():
                    what = f"{name}: error of confident ones, {key}, ms"
                    report.target(what, one[key], ("<=", limit))
    report.table("Errors of confident results, ms", columns, rows)
    report.figures |= {"columns": columns, "rows": rows}
    _windows(outcomes, report)
    wrong = [
        [kind, len(levels), sum(level >= SURE for level in levels), max(levels)]
        for kind, levels in found.wrong.items()
    ]
    header = ["what does not belong together", "pairs", "accepted", "most confident"]
    report.table("Wrong pairs", header, wrong)
    report.figures["wrong"] = wrong
    for kind, pairs, accepted, _ in wrong:
        report.target(f"accepted of {pairs}: {kind}", accepted, ("<=", 0))
    _mountings(outcomes, report)
    report.figures["errors_ms"] = {
        f"{scene}, {rate_hz} Hz": [
            round(1e3 * one.error_s["frames"], 2)
            for one in outcomes
            if (one.scene, one.rate_hz) == (scene, rate_hz)
        ]
        for scene in dict.fromkeys(one.scene for one in outcomes)
        for rate_hz in RATES_HZ
    }
    report.figures["read_out_error_ms"] = _spread(
        1e3 * np.abs([one.read_out_error_s for one in outcomes])
    )
    what = "CPU s per minute at 30 Hz, small frames"
    report.target(what, float(np.median(found.cpu_s_per_minute)), ("<=", MOST_CPU_S))


def _groups(outcomes: list[Outcome]) -> dict[str, list[Outcome]]:
    groups = {
        f"{rate_hz} Hz": [one for one in outcomes if one.rate_hz == rate_hz]
        for rate_hz in RATES_HZ
    }
    for scene in dict.fromkeys(one.scene for one in outcomes):
        groups[scene] = [one for one in outcomes if one.scene == scene]
    return groups


def _windows(outcomes: list[Outcome], report: Report) -> None:
    rows = []
    for name, chosen in _groups(outcomes).items():
        errors_ms = np.abs(np.concatenate([1e3 * one.window_error_s for one in chosen]))
        spread = _spread(errors_ms)
        rows.append([name, len(errors_ms), *spread.values()])
        if name.endswith("Hz"):
            for key, limit in WINDOW_LIMITS_MS.items():
                what = f"{name}: error of windows of 4 s, {key}, ms"
                report.target(what, spread[key], ("<=", limit))
    header = ["clips", "windows", *LIMITS_MS]
    report.table("Windows of 4 s with 1 deg/s or more, ms", header, rows)
    report.figures["windows"] = rows


def _mountings(outcomes: list[Outcome], report: Report) -> None:
    clear = [one for one in outcomes if one.mounting_ratio >= CLEAR_RATIO]
    right = sum(one.mounting_is_right for one in clear)
    what = f"wrong of {len(clear)} mountings with a ratio of {CLEAR_RATIO:g} or more"
    report.target(what, len(clear) - right, ("<=", 0))
    asked = [one for one in outcomes if one.mounting_ratio < CLEAR_RATIO]
    report.figures["mountings"] = {
        "clear": len(clear),
        "right": right,
        "asked": len(asked),
        "asked_right": sum(one.mounting_is_right for one in asked),
    }
    levels = []
    for low, high in ((0.0, 0.1), (0.1, 0.5), (0.5, 0.9), (0.9, 1.01)):
        row: list[Any] = [f"{low:g} to {min(high, 1.0):g}"]
        for method in METHODS:
            here = [
                abs(one.error_s[method]) <= 1e-3 * LIMITS_MS["largest"]
                for one in outcomes
                if low <= one.confidence[method] < high
            ]
            row += [len(here), sum(here)]
        levels.append(row)
    header = ["confidence"]
    for method in METHODS:
        header += [method, "within 8 ms"]
    report.table("What confidence means", header, levels)
    report.figures["levels"] = levels


def write_budget(outcomes: list[Outcome], report: Report) -> None:
    """Compare the part that synchronisation has in the error of the force."""
    rows = []
    for scene in dict.fromkeys(one.scene for one in outcomes):
        if scene not in PAPER_SCENES:
            continue
        ride = make_ride(scene, 1)
        for rate_hz in RATES_HZ:
            row: list[Any] = [scene, rate_hz]
            for method in ("pats", "frames"):
                errors_s = [
                    one.error_s[method]
                    for one in outcomes
                    if (one.scene, one.rate_hz) == (scene, rate_hz)
                    and one.confidence[method] >= SURE
                ]
                rms_s = float(np.sqrt(np.mean(np.square(errors_s))))
                square = shifted(ride, rms_s, is_fine=rate_hz > 100)
                row += [1e3 * rms_s, float(np.sqrt(square))]
            rows.append(row)
            if scene == "horse":
                what = f"horse, {rate_hz} Hz: force error by sync, frames / pats"
                report.target(what, row[5] / row[3], ("<=", 0.5))
    header = ["clips", "Hz", "pats ms", "mN", "frames ms", "mN"]
    report.table("RMS error of confident results, and of the force", header, rows)
    report.figures["budget"] = rows
