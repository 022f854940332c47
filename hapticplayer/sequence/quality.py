"""How good a recording's motion is, in figures; and the methods side by side on it."""

import dataclasses
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer import rendering
from hapticplayer.capture.recording import Recording, find_gaps
from hapticplayer.clock import Clock
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.sequence import files
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.processing import (
    DEFAULT_METHOD,
    Processed,
    Processing,
    lowpassed,
    plain,
)

# A method is timed again while that is quick; the first run also loads what it needs.
_RUNS = 3
_ENOUGH_S = 3.0


@dataclass(frozen=True, slots=True)
class MethodRow:
    """What one method makes of a recording.

    Attributes:
        method: its name.
        rms_mps2: of the gravity-free motion.
        leak_at_rest_mps2: gravity left in still spans; None without one.
        difference_mps2: RMS between its gravity vector and the default method's.
        gravity_sigma_mps2: median of what it says about its error, or None.
        us_per_sample: the quickest of up to three runs.
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
    progress: files.Progress = files.no_progress,
) -> dict[str, Any]:
    """Return the quality report of a recording: plain numbers, lists and texts.

    Args:
        recording: as it was read.
        processed: its motion.
        progress: told while the excursions are predicted.
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
            "excursion": _predicted(processed.track, progress),
            "from_cache": False,  # of earlier versions, for programs that read it
        }
    )


def _predicted(track: MotionTrack, progress: files.Progress) -> dict[str, Any]:
    """Return where the force of the default mapping would push a hand."""
    from_start = dataclasses.replace(track, time_s=track.time_s - track.time_s[0])
    force = rendering.render_force(from_start)
    return predict(
        force, force.end_s, lambda done: progress(done, "predicting excursions")
    )


def describe_motion(track: MotionTrack) -> dict[str, Any]:
    """Return RMS and peak of p[k] over the valid samples; None without any."""
    valid = np.flatnonzero(track.valid)
    if not len(valid):
        return {"rms_mps2": None, "peak_mps2": None, "peak_at_s": None}
    p = track.acceleration_mps2[valid]
    square = np.einsum("ij,ij->i", p, p)
    peak = int(np.argmax(square))
    return {
        "rms_mps2": float(np.sqrt(square.mean())),
        "rms_per_axis_mps2": np.sqrt(np.square(p).mean(axis=0)).tolist(),
        "peak_mps2": float(np.sqrt(square[peak])),
        "peak_at_s": float(track.time_s[valid[peak]]),
    }


def compare_methods(
    imu: ImuLog, processing: Processing, clock: Clock
) -> Iterator[MethodRow]:
    """Yield a row for each method, the default's first.

    Args:
        imu: conditioned as for `processing`, see `Processed`.
        processing: its time constant goes to the smoother, its low-pass to all.
        clock: to time the methods with.
    """
    from hapticplayer import motion

    reference: MotionTrack | None = None
    for name in sorted(motion.METHODS, key=lambda name: name != DEFAULT_METHOD):
        parameters = processing.parameters if name == processing.method else None
        track, summary, took_s = _timed(imu, name, parameters, clock)
        reference = reference or track
        difference = (
            _rms_difference(track, reference) if name != DEFAULT_METHOD else 0.0
        )
        yield MethodRow(
            method=name,
            rms_mps2=describe_motion(lowpassed(track, processing))["rms_mps2"],
            leak_at_rest_mps2=summary["leak_at_rest_mps2"],
            difference_mps2=difference,
            gravity_sigma_mps2=summary["gravity_sigma_mps2"],
            us_per_sample=1e6 * took_s / len(imu),
        )


def _timed(
    imu: ImuLog, method: str, parameters: Any, clock: Clock
) -> tuple[MotionTrack, dict[str, Any], float]:
    from hapticplayer import motion

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
