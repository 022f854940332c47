"""The quality report of a sequence, from its description, and the notes on an import.

The bounds follow from measurements: half a frame (16.7 ms) of synchronisation, gravity
left over that a hand feels as a steady pull (`LARGE_LEAK_MPS2`), the workspace of the
device.
"""

import enum
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hapticplayer.capture.mounting import fallen_text, mean_up
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import ENOUGH_CONFIDENCE
from hapticplayer.errors import Message, from_json, to_json
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import (
    ClockMap,
    ImuLog,
    MotionTrack,
    rendered_feedback,
)
from hapticplayer.model.limits import UPRIGHT
from hapticplayer.model.ranges import finite_number
from hapticplayer.sequence.description import Description, ExcursionEntry, TrackEntry

LARGE_LEAK_MPS2 = 0.05
"""Noticed as a steady pull at the default gain."""

_NO_DRIFT_PPM = 2e4
_UNCOVERED_S = 0.5  # shorter ends without motion are not noticed
_RATE_PARTS = 10
_LEAST_PART = 50  # samples; fewer give no rate
_RATE_CHANGE = 0.02  # a camera's quartz keeps 0.01 %, a phone's scheduler does not


class Mark(enum.IntEnum):
    """The mark of a figure; the worst of several is their maximum."""

    GOOD = 0
    DOUBTFUL = 1
    BAD = 2


@dataclass(frozen=True, slots=True)
class Finding:
    """One figure.

    Attributes:
        name: estimate, sync, drift, rate, leak, sensor, gaps, force, workspace, heat or cover.
        mark: of the figure.
        value: the figure; None if it could not be measured.
        more: further figures by name.
    """

    name: str
    mark: Mark
    value: float | None
    more: Mapping[str, Any]


_OF_RENDERING = {"force", "workspace", "heat"}
_BOUNDS = {
    "residual_s": (0.0167, 0.05),
    "drift_ppm": (150.0, 500.0),
    "rate_hz": (99.0, 29.0),
    "leak_mps2": (LARGE_LEAK_MPS2, 4 * LARGE_LEAK_MPS2),
    "sensor_share": (0.0, 0.01),
    "invalid_share": (0.002, 0.02),
    "longest_gap_s": (0.1, 1.0),
    "force_share": (0.001, 0.02),
    "reach": (0.8, 1.0),
    "thermal": (0.8, 1.0),
    "uncovered_share": (0.02, 0.2),
}
"""Up to the first a figure is good, up to the second doubtful; the rate from it on."""


def quality_report(description: Description) -> list[Finding]:
    """The findings on a sequence, the most important first."""
    made_of, feedbacks = description.provenance, description.feedbacks
    motion = _table(made_of, "motion_summary")
    rendered = feedbacks.get(rendered_feedback(feedbacks), TrackEntry())
    estimate = _table(made_of, "estimate")
    found = [
        _estimate(estimate),
        None
        if estimate
        else _sync(_table(made_of, "synchronisation"), description.clock_map),
        _drift(_table(made_of, "synchronisation")),
        _plain("rate", "rate_hz", _number(made_of, "imu_rate_hz"), is_low_bad=True),
        _leak(motion),
        _plain("sensor", "sensor_share", _number(motion, "saturated_share")),
        _gaps(made_of, motion),
        _plain("cover", "uncovered_share", _number(made_of, "uncovered_share")),
        _plain(
            "force",
            "force_share",
            rendered.saturated_share,
            peak_n=rendered.peak_n,
        ),
        *_workspace(rendered.excursion),
    ]
    return [one for one in found if one is not None]


def needs_recording(findings: list[Finding]) -> bool:
    """Whether any bad figure is of the recording, and not of how it is rendered."""
    return any(
        one.mark is Mark.BAD and one.name not in _OF_RENDERING for one in findings
    )


def worst(findings: list[Finding]) -> Mark:
    return max((one.mark for one in findings), default=Mark.DOUBTFUL)


def marked(bound: str, value: float, *, is_low_bad: bool = False) -> Mark:
    good, doubtful = _BOUNDS[bound]
    sign = -1.0 if is_low_bad else 1.0
    if sign * value <= sign * good:
        return Mark.GOOD
    return Mark.DOUBTFUL if sign * value <= sign * doubtful else Mark.BAD


def _estimate(found: Mapping[str, Any]) -> Finding | None:
    """Return that nothing measured the motion, with the shares of the clip kept."""
    if not found:
        return None
    kept = {name: _number(found, f"{name}_trust") for name in ("sway", "bounce")}
    return Finding("estimate", Mark.DOUBTFUL, _number(found, "gain"), kept)


def _sync(found: Mapping[str, Any], clock: ClockMap | None) -> Finding | None:
    if clock is None:
        return None
    residual_s, confidence = clock.residual_s, clock.confidence
    method = str(found.get("method", ""))
    mark = marked("residual_s", residual_s)
    is_seen = bool(found.get("seen_by_person"))  # who compared them knows better
    if confidence < ENOUGH_CONFIDENCE and not is_seen:
        mark = max(mark, Mark.DOUBTFUL if confidence > 0.0 else Mark.BAD)
    elif method == "offset" and not is_seen:
        mark = max(mark, Mark.DOUBTFUL)  # not confirmed by the recording
    is_confirmed = is_seen and (confidence < ENOUGH_CONFIDENCE or method == "offset")
    more = {"method": method, "confidence": confidence, "is_confirmed": is_confirmed}
    return Finding("sync", mark, residual_s, more)


def _drift(found: Mapping[str, Any]) -> Finding | None:
    ppm = _number(found, "drift_ppm")
    if ppm is None or abs(ppm) > _NO_DRIFT_PPM:  # slow motion, as was answered
        return None
    is_fitted = bool(found.get("drift_is_fitted"))
    if found.get("method") == "embedded" and not is_fitted:
        return Finding("drift", Mark.GOOD, 0.0, {"is_fitted": True})
    mark = marked("drift_ppm", abs(ppm))
    return Finding("drift", mark, ppm if is_fitted else None, {"is_fitted": is_fitted})


def _leak(motion: Mapping[str, Any]) -> Finding | None:
    if "leak_at_rest_mps2" not in motion:
        return None
    leak_mps2 = _number(motion, "leak_at_rest_mps2")
    if leak_mps2 is None:  # no stationary span
        return Finding("leak", Mark.DOUBTFUL, None, {})
    return Finding("leak", marked("leak_mps2", leak_mps2), leak_mps2, {})


def _gaps(made_of: Mapping[str, Any], motion: Mapping[str, Any]) -> Finding | None:
    share = _number(motion, "invalid_share")
    if share is None:
        return None
    count = _number(made_of, "gaps")
    longest_s = _number(made_of, "longest_gap_s")
    mark = max(
        marked("invalid_share", share), marked("longest_gap_s", longest_s or 0.0)
    )
    more = {"gaps": count, "longest_gap_s": longest_s}
    return Finding("gaps", mark, share, more)


def _workspace(excursion: ExcursionEntry | None) -> list[Finding]:
    if excursion is None or not excursion.hands:
        return []
    known = {name: hand.reach for name, hand in excursion.hands.items()}
    reach = known.get("relaxed", max(known.values()))
    trips = [name for name, hand in excursion.hands.items() if hand.trip is not None]
    mark = Mark.BAD if trips else marked("reach", reach)
    share = excursion.thermal_share
    return [
        Finding("workspace", mark, reach, {"reaches": known, "trips": trips}),
        Finding("heat", marked("thermal", share), share, {}),
    ]


def _plain(
    name: str, bound: str, value: float | None, *, is_low_bad: bool = False, **more: Any
) -> Finding | None:
    if value is None:
        return None
    return Finding(name, marked(bound, value, is_low_bad=is_low_bad), value, more)


def _table(held: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    value = held.get(name)
    return value if isinstance(value, Mapping) else {}


def _number(held: Mapping[str, Any], name: str) -> float | None:
    return finite_number(held.get(name))


def notes_on_motion(imu: ImuLog, summary: Mapping[str, Any]) -> list[str]:
    """Return the notes on the samples and on the gravity removal.

    Args:
        imu: the log that gravity was removed from.
        summary: of hapticplayer.motion.analyse.
    """
    notes: list[str] = [summary["clock"]] if summary.get("clock") else []
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
                "{share} of the motion is not valid (gaps, missing or clipped samples) "
                "and has no force",
                share=_percent(invalid),
            )
        )
    if leak_mps2 is not None and leak_mps2 > LARGE_LEAK_MPS2:
        notes.append(
            Message(
                "{leak_mps2:.2f} m/s2 of gravity remain while the recorder is "
                "stationary",
                leak_mps2=leak_mps2,
            )
        )
    if summary.get("calibration_overruled"):
        notes.append(
            Message(
                "the recording contradicts the calibration, which was not used: it is of "
                "another sensor, or too old"
            )
        )
    up = mean_up(imu)
    if up is not None and up[2] < UPRIGHT:
        notes.append(
            Message("{what}; choose the mounting (--mounting)", what=fallen_text(up))
        )
    return notes + _notes_on_rate(imu)


def notes_on_sequence(
    recording: Recording, track: MotionTrack, clip: ClipInfo
) -> list[str]:
    notes: list[str] = []
    is_placed = "synchronisation" in recording.provenance
    if recording.clock_map.confidence == 0.0 and not is_placed:
        notes.append(
            Message(
                "the log is not synchronised: its clock is taken as media time; enter the "
                "offset (--offset S)"
            )
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
    return notes


def notes_on_force(rendered: TrackEntry) -> list[str]:
    if not rendered.saturated_share:
        return []
    percent = 100.0 * rendered.saturated_share
    text = "{percent:.2g} % of the time the force is at its limit"
    return [Message(text, percent=percent)]


def describe_notes(notes: Sequence[str]) -> dict[str, Any]:
    """Return notes as they are stored: in English, and as translatable messages."""
    return {
        "notes": [str(note) for note in notes],
        "note_messages": [to_json(note) for note in notes],
    }


def stored_notes(provenance: Mapping[str, Any]) -> list[str]:
    return [from_json(note) for note in provenance["note_messages"]]


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
