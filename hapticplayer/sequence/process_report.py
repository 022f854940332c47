"""The report of the command `process`: a recording's quality, and the methods compared."""

import dataclasses
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer import motion, rendering
from hapticplayer.capture.recording import Recording, find_gaps
from hapticplayer.clock import Clock
from hapticplayer.errors import Message, Progress, no_progress
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.model.motion import DEFAULT_METHOD
from hapticplayer.sequence.description import ExcursionEntry, unstructured
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.processing import (
    Processed,
    Processing,
    describe_motion,
    lowpassed,
    median_of,
    plain,
)

_RUNS, _ENOUGH_S = 3, 3.0  # a method is timed again while that is quick


@dataclass(frozen=True, slots=True)
class MethodRow:
    """The result of one method for a recording.

    Attributes:
        method: its name.
        rms_mps2: of the gravity-free motion.
        leak_at_rest_mps2: gravity left in stationary spans; None without one.
        difference_mps2: RMS between its gravity vector and the default method's.
        gravity_sigma_mps2: median of its error estimate, or None.
        us_per_sample: the fastest of up to three runs.
    """

    method: str
    rms_mps2: float | None
    leak_at_rest_mps2: float | None
    difference_mps2: float | None
    gravity_sigma_mps2: float | None
    us_per_sample: float


def describe_quality(
    recording: Recording,
    processed: Processed,
    progress: Progress = no_progress,
) -> dict[str, Any]:
    """Return the quality report of a recording: plain numbers, lists and texts.

    Args:
        recording: as read.
        processed: its motion.
        progress: called while excursions are predicted.
    """
    imu = recording.imu
    steps_s, gaps = np.diff(imu.time_s), find_gaps(imu)
    return plain(
        {
            "recording": {
                "source": Path(imu.source).name,
                "camera": recording.camera,
                "samples": len(imu),
                "duration_s": float(imu.time_s[-1] - imu.time_s[0]),
                "rate_hz": imu.rate_hz,
                "gaps": len(gaps),
                "longest_gap_s": float(steps_s[gaps].max()) if len(gaps) else 0.0,
                "notes": recording.notes,
            },
            "conditioning": processed.conditioning,
            "gravity_removal": processed.summary,
            "motion": describe_motion(processed.track),
            "excursion": unstructured(_predicted(processed.track, progress)),
        }
    )


def _predicted(track: MotionTrack, progress: Progress) -> ExcursionEntry:
    """Return the predicted excursion with the default mapping."""
    from_start = dataclasses.replace(track, time_s=track.time_s - track.time_s[0])
    force = rendering.render_force(from_start)
    return predict(
        force,
        force.end_s,
        lambda done: progress(done, Message("predicting excursions")),
    )


def compare_methods(
    imu: ImuLog,
    processing: Processing,
    clock: Clock,
    *,
    elsewhere: SensorCalibration | None = None,
    part: slice = slice(None),
) -> Iterator[MethodRow]:
    """Yield a row for each method, the default's first.

    Args:
        imu: conditioned as for `processing`, see `Processed`.
        processing: its time constant goes to the smoother, its low-pass to all.
        clock: to time the methods.
        elsewhere: what other parts of the log tell of the sensor.
        part: samples that are compared.
    """
    reference: MotionTrack | None = None
    for name in sorted(motion.METHODS, key=lambda name: name != DEFAULT_METHOD):
        is_chosen = name == processing.method
        parameters = processing.parameters(elsewhere) if is_chosen else None
        whole, summary, took_s = _timed(imu, name, parameters, clock)
        track = whole.part(part)
        reference = reference or track
        difference = (
            _rms_difference(track, reference) if name != DEFAULT_METHOD else 0.0
        )
        yield MethodRow(
            method=name,
            rms_mps2=describe_motion(lowpassed(whole, processing).part(part))[
                "rms_mps2"
            ],
            leak_at_rest_mps2=summary["leak_at_rest_mps2"],
            difference_mps2=difference,
            gravity_sigma_mps2=median_of(track.gravity_sigma_mps2),
            us_per_sample=1e6 * took_s / len(imu),
        )


def _timed(
    imu: ImuLog, method: str, parameters: Any, clock: Clock
) -> tuple[MotionTrack, dict[str, Any], float]:
    took_s: list[float] = []
    while True:
        begin_s = clock.now_s()
        done = motion.analyse(imu, method, parameters=parameters)
        took_s.append(clock.now_s() - begin_s)
        if sum(took_s) > _ENOUGH_S or len(took_s) == _RUNS:
            return done.track, plain(done.summary), min(took_s)


def _rms_difference(track: MotionTrack, reference: MotionTrack) -> float | None:
    valid = track.valid & reference.valid
    if not valid.any():
        return None
    apart = track.gravity_mps2[valid] - reference.gravity_mps2[valid]
    return float(np.sqrt(np.einsum("ij,ij->i", apart, apart).mean()))
