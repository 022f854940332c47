"""What an experimenter should know before using a sequence, in sentences."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from hapticplayer.capture.limits import UPRIGHT
from hapticplayer.capture.mounting import fallen_text, mean_up
from hapticplayer.capture.recording import Recording
from hapticplayer.media import ClipInfo
from hapticplayer.model import Feedback, ForceTrack, ImuLog, MotionTrack

LARGE_LEAK_MPS2 = 0.05
"""A person feels this much as a steady pull at the usual gain."""

_UNCOVERED_S = 0.5  # shorter ends without motion go unnoticed
_RATE_PARTS = 10
_LEAST_PART = 50  # samples; fewer give no rate to compare
_RATE_CHANGE = 0.02  # a camera's quartz keeps 0.01 %, a phone's scheduler does not


def notes_on_motion(imu: ImuLog, summary: Mapping[str, Any]) -> list[str]:
    """Return what the samples and the gravity removal give reason to say.

    Args:
        imu: the log that gravity was removed from.
        summary: of hapticplayer.motion.analyse.
    """
    notes = []
    clipped, invalid = summary["saturated_share"], summary["invalid_share"]
    leak_mps2 = summary["leak_at_rest_mps2"]
    if clipped > 0.0:
        notes.append(f"{_percent(clipped)} of the samples are at the sensor's limit")
    if invalid > 0.0:
        notes.append(
            f"{_percent(invalid)} of the motion is not to be trusted (gaps, missing or "
            "clipped samples); there is no force there"
        )
    if leak_mps2 is not None and leak_mps2 > LARGE_LEAK_MPS2:
        notes.append(
            f"{leak_mps2:.2f} m/s2 of gravity are left where the recording stands still"
        )
    up = mean_up(imu)
    if up is not None and up[2] < UPRIGHT:
        notes.append(f"{fallen_text(up)}; see --mounting")
    return notes + _notes_on_rate(imu)


def notes_on_sequence(
    recording: Recording,
    track: MotionTrack,
    tracks: Mapping[str, ForceTrack],
    clip: ClipInfo,
) -> list[str]:
    """Return what clip, motion and force together give reason to say."""
    notes = []
    if recording.clock_map.confidence == 0.0:
        notes.append("no --offset was given: the log's clock is taken as media time")
    first_s = max(0.0, float(track.time_s[0]))
    last_s = min(clip.duration_s, float(track.time_s[-1]))
    if clip.duration_s - (last_s - first_s) > _UNCOVERED_S:
        notes.append(
            f"the motion covers {first_s:.1f} to {last_s:.1f} s of the clip's "
            f"{clip.duration_s:.1f} s; there is no force outside"
        )
    saturated = tracks[Feedback.REALISTIC.value].provenance["saturated_share"]
    if saturated > 0.0:
        notes.append(f"{saturated:.1%} of the force samples reach the force limit")
    return notes


def _notes_on_rate(imu: ImuLog) -> list[str]:
    """Compare the sampling rates of ten parts of a recording."""
    part = len(imu) // _RATE_PARTS
    if part < _LEAST_PART:
        return []
    steps_s = np.diff(imu.time_s)[: _RATE_PARTS * part - 1]
    steps_s = np.append(steps_s, steps_s[-1]).reshape(_RATE_PARTS, part)
    rates_hz = 1.0 / np.median(steps_s, axis=1)
    lowest_hz, highest_hz = float(rates_hz.min()), float(rates_hz.max())
    if highest_hz - lowest_hz <= _RATE_CHANGE * imu.rate_hz:
        return []
    change = f"from {lowest_hz:.1f} to {highest_hz:.1f} Hz"
    return [f"the sampling rate changes over the recording, {change}"]


def _percent(share: float) -> str:
    return f"{100.0 * share:.2g} %"
