"""What a report tells of the force that hands got, beside what was planned."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportTable,
)
from hapticplayer.study.analysis.statistic import listed, number
from hapticplayer.study.answers import Answers
from hapticplayer.study.conduct import AnsweredPlayback
from hapticplayer.study.trial_force import LEAST_FORCE_N, MOST_ERROR, TrialForce

ALL = "all"
_HEADS = (
    *("feedback", "trials", "error of the force", "reach, mm"),
    *("not in full, s", "saturated", "off"),
)
_NOTE = (
    "From the records of the device. Error: force sent less planned, RMS weighted by "
    "frequency (a constant difference counts 0.3, one of 0.5 to 10 Hz counts 1), as a "
    "share of the planned force; where none was planned, in newtons. Reach: largest "
    "distance of the grip from the centre. Not in full: entry, ramps, stops and the fade "
    "at the edge of the workspace. Saturated: share of the time at the force cap. Median "
    "and largest of the trials."
)
_BOUND = (
    f"A trial is marked as off where the error is above {100 * MOST_ERROR:.0f} % of the "
    f"planned force and above {LEAST_FORCE_N:g} N, that is, where a difference is "
    "probably noticed."
)


def trial_force_blocks(
    answers: Answers, feedbacks: Sequence[str]
) -> Iterator[ReportBlock]:
    """Yield the table of the forces that were felt, and the trials that are off."""
    trials = _recorded(answers)
    if not trials:
        return
    yield Heading("Force that was felt")
    rows = tuple(
        (name, *_row([force for one, force in trials if name in (ALL, one.feedback)]))
        for name in (*feedbacks, ALL)
    )
    yield ReportTable("Force sent beside force planned", _HEADS, rows, _NOTE)
    off = [f"{one.trial}: {_error(force)}" for one, force in trials if force.is_off]
    count = f"{len(off)} of {len(trials)} trials with a record are off"
    yield Paragraph(f"{_BOUND} {count}{f': {listed(off)}' if off else ''}.")


def trial_force_summary(answers: Answers) -> dict[str, Any]:
    """Return the same as JSON, by feedback; empty without records."""
    trials = _recorded(answers)
    found = {}
    for name in dict.fromkeys(one.feedback for one, _ in trials):
        each = [force for one, force in trials if one.feedback == name]
        found[name] = {
            "trials": len(each),
            "error": _middle_and_most([one.error for one in each]),
            "error_n": _middle_and_most([one.error_n for one in each]),
            "reach_m": _middle_and_most([one.reach_m for one in each]),
            "faded_s": _middle_and_most([one.faded_s for one in each]),
            "saturated_share": _middle_and_most([one.saturated_share for one in each]),
            "off": [
                o.trial for o, force in trials if o.feedback == name and force.is_off
            ],
        }
    return found


def _recorded(answers: Answers) -> list[tuple[AnsweredPlayback, TrialForce]]:
    return [
        (one, one.trial_force)
        for one in answers.conduct.playbacks
        if one.trial_force is not None
    ]


def _row(each: Sequence[TrialForce]) -> tuple[str, ...]:
    planned = [one.error for one in each if one.error is not None]
    free = [one.error_n for one in each if one.error is None]
    errors = [_pair(planned), _pair(free, " N")] if each else ["-"]
    return (
        str(len(each)),
        ", ".join(text for text in errors if text != "-") or "-",
        _pair([1e3 * one.reach_m for one in each if one.reach_m is not None]),
        _pair([one.faded_s for one in each]),
        _pair([one.saturated_share for one in each]),
        str(sum(one.is_off for one in each)),
    )


def _pair(values: Sequence[float], unit: str = "") -> str:
    if not values:
        return "-"
    return f"{number(float(np.median(values)))}, {number(max(values))}{unit}"


def _error(force: TrialForce) -> str:
    if force.error is None:
        return f"{force.error_n:.2f} N without a plan"
    return f"{100.0 * force.error:.0f} %"


def _middle_and_most(values: Sequence[float | None]) -> dict[str, float | None]:
    known = [one for one in values if one is not None]
    if not known:
        return {"median": None, "largest": None}
    return {"median": float(np.median(known)), "largest": max(known)}
