"""What an experimenter should know before using a sequence, in sentences."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from hapticplayer.capture.limits import UPRIGHT
from hapticplayer.capture.mounting import fallen_text, mean_up
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import Message, from_json, to_json
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
    notes: list[str] = []
    clipped, invalid = summary["saturated_share"], summary["invalid_share"]
    leak_mps2 = summary["leak_at_rest_mps2"]
    if clipped > 0.0:
        notes.append(
            Message(
                "{share} of the samples are at the sensor's limit",
                share=_percent(clipped),
            )
        )
    if invalid > 0.0:
        notes.append(
            Message(
                "{share} of the motion is not to be trusted (gaps, missing or clipped "
                "samples); there is no force there",
                share=_percent(invalid),
            )
        )
    if leak_mps2 is not None and leak_mps2 > LARGE_LEAK_MPS2:
        notes.append(
            Message(
                "{leak_mps2:.2f} m/s2 of gravity are left where the recording stands "
                "still",
                leak_mps2=leak_mps2,
            )
        )
    up = mean_up(imu)
    if up is not None and up[2] < UPRIGHT:
        notes.append(Message("{what}; see --mounting", what=fallen_text(up)))
    return notes + _notes_on_rate(imu)


def notes_on_sequence(
    recording: Recording,
    track: MotionTrack,
    tracks: Mapping[str, ForceTrack],
    clip: ClipInfo,
) -> list[str]:
    """Return what clip, motion and force together give reason to say."""
    notes: list[str] = []
    if recording.clock_map.confidence == 0.0:
        notes.append(
            Message("no --offset was given: the log's clock is taken as media time")
        )
    first_s = max(0.0, float(track.time_s[0]))
    last_s = min(clip.duration_s, float(track.time_s[-1]))
    if clip.duration_s - (last_s - first_s) > _UNCOVERED_S:
        notes.append(
            Message(
                "the motion covers {first_s:.1f} to {last_s:.1f} s of the clip's "
                "{duration_s:.1f} s; there is no force outside",
                first_s=first_s,
                last_s=last_s,
                duration_s=clip.duration_s,
            )
        )
    saturated = tracks[Feedback.REALISTIC.value].provenance["saturated_share"]
    if saturated > 0.0:
        notes.append(
            Message(
                "{share:.1%} of the force samples reach the force limit",
                share=saturated,
            )
        )
    return notes


def describe_notes(notes: Sequence[str]) -> dict[str, Any]:
    """Return notes as they are stored: in English, and as what can be translated."""
    return {
        "notes": [str(note) for note in notes],
        "note_messages": [to_json(note) for note in notes],
    }


def stored_notes(provenance: Mapping[str, Any]) -> list[str]:
    """Return the notes of a sequence; an older one has them in English alone."""
    return [from_json(n) for n in provenance.get("note_messages", provenance["notes"])]


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
    change = Message(
        "from {lowest_hz:.1f} to {highest_hz:.1f} Hz",
        lowest_hz=lowest_hz,
        highest_hz=highest_hz,
    )
    return [
        Message("the sampling rate changes over the recording, {change}", change=change)
    ]


def _percent(share: float) -> str:
    return f"{100.0 * share:.2g} %"
