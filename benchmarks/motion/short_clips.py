"""Gravity left in clips of 10 s: alone, cut from the whole log, and with a calibration.

Clips of 10 s every 10 s of the optical recordings at native rate, mean over clips. The
calibration is that of the half of the log which the clip is not in.
"""

import argparse
import sys
from collections.abc import Iterator

import numpy as np

from benchmarks.common import Report, on_one_thread, rms
from benchmarks.motion.recordings import (
    GRAVITY_MPS2,
    NATIVE,
    ORIENTATION,
    QUICK_NAMES,
    TruthRecording,
    load,
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


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--families", nargs="+", choices=OPTICAL, default=OPTICAL)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure the clips of each family."""
    if not ORIENTATION.is_dir():
        sys.exit(f"the recordings are not on this machine: {ORIENTATION}")
    on_one_thread()
    rows = []
    for family in load(options.families, 1):
        if family.rate != NATIVE:
            continue
        held = family.recordings
        if options.quick:
            held = [one for one in held if one.name in QUICK_NAMES]
        errors = np.array([clip for one in held for clip in clips(one)])
        means = dict(zip(WAYS, errors.mean(axis=0).tolist(), strict=True))
        report.figures.setdefault("error_mps2", {})[family.name] = means
        rows.append([family.name, len(errors), *(f"{v:.3f}" for v in means.values())])
        if family.name == "tyrex" and not options.quick:
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
    counted = recording.scored[part]
    miss = (up - recording.up[part])[counted]
    return rms(GRAVITY_MPS2 * np.linalg.norm(miss, axis=1))
