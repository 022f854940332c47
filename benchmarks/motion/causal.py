"""Filters that know only the past: gravity left at rest and in turns.

The error of a recording is the RMS of 9.81 ||u_est - u_true||, that of a family the mean over
its recordings. `live` is what `feel` uses, sample by sample; it begins once the sensor has
been at rest, so some recordings have none of it, and it is compared where all have begun.
"""

import argparse
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import Report, on_one_thread, rms
from benchmarks.motion.recordings import (
    NATIVE,
    TruthRecording,
    add_options,
    chosen,
)
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion import analyse
from hapticplayer.motion.causal import CausalFilter

LIVE, OTHERS = "live", ("vqf", "ekf")
TURN_RADPS = 1.0
_LEAST_SAMPLES = 50
Floats = NDArray[np.float64]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    add_options(parser, seeds=1)
    parser.set_defaults(families=("broad", "tumvi", "tyrex", "repoimu_TStick",
                                  "repoimu_Pendulum"))  # fmt: skip


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure each filter on every recording."""
    on_one_thread()
    found: dict[tuple[str, str], dict[str, list[float]]] = {}
    costs_us = []
    for family in chosen(options):
        for recording in family.recordings if family.rate == NATIVE else ():
            live, cost_us = live_up(recording)
            costs_us.append(cost_us)
            ups = {name: method_up(recording, name) for name in OTHERS}
            ups = {LIVE: live, **ups} if np.isfinite(live).any() else ups
            for part, errors in parts(recording, ups).items():
                held = found.setdefault((family.name, part), {})
                for name, error in errors.items():
                    held.setdefault(name, []).append(error)
    rows = []
    for (family, part), errors in found.items():
        means = {name: float(np.mean(all_)) for name, all_ in errors.items()}
        counts = f"{len(errors.get(LIVE, ()))} of {len(errors[OTHERS[0]])}"
        shown = [
            f"{means[name]:.3f}" if name in means else "" for name in (LIVE, *OTHERS)
        ]
        rows.append([family, part, counts, *shown])
        report.figures.setdefault("error_mps2", {})[f"{family}, {part}"] = means
        if family == "broad":
            what = f"{family}, {part}: error of {LIVE}, of ekf"
            report.target(what, means[LIVE] / means["ekf"], ("<=", 1.0))
    header = ["recordings", "", "with live", LIVE, *OTHERS]
    report.table("Mean gravity error, m/s^2", header, rows, mark="causal")
    cost_us = float(np.median(costs_us))
    report.target("live: time of a sample, us", cost_us, ("<=", 200.0))


def parts(recording: TruthRecording, ups: dict[str, Floats]) -> dict[str, Any]:
    """The errors of each filter at rest, in turns and over all that is scored."""
    rate = np.linalg.norm(recording.imu.angular_rate_radps, axis=1)
    known = np.isfinite(recording.up).all(axis=1)
    for up in ups.values():
        known &= np.isfinite(up).all(axis=1)
    miss = {name: 9.81 * np.linalg.norm(up - recording.up, axis=1)
            for name, up in ups.items()}  # fmt: skip
    masks = {
        "at rest": known & ~recording.counts,
        "in turns": known & (rate > TURN_RADPS),
        "moving": known & recording.counts,
    }
    return {
        part: {name: rms(error[mask]) for name, error in miss.items()}
        for part, mask in masks.items()
        if np.count_nonzero(mask) >= _LEAST_SAMPLES
    }


def method_up(recording: TruthRecording, method: str) -> Floats:
    """The vertical by a method for whole recordings that only looks back."""
    track = analyse(recording.imu, method).track
    return np.asarray(track.gravity_mps2 / STANDARD_GRAVITY_MPS2)


def live_up(recording: TruthRecording) -> tuple[Floats, float]:
    """The vertical as `feel` has it, NaN before it begins; and us a sample."""
    imu, causal = recording.imu, CausalFilter()
    up = np.full((len(imu), 3), np.nan)
    columns = imu.time_s, imu.specific_force_mps2, imu.angular_rate_radps
    began_s = time.perf_counter()
    for row, (time_s, force, rate) in enumerate(zip(*columns, strict=True)):
        if causal.add(time_s, force, rate) is not None:
            up[row] = causal.up
    cost_s = time.perf_counter() - began_s
    return up, 1e6 * cost_s / len(imu)
