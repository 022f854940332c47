"""The answers that are counted, not compared: of people, of choices, yes and no."""

from collections import Counter
from collections.abc import Iterator
from statistics import median
from typing import Any

from hapticplayer.study.analysis.blocks import ReportBlock, ReportTable
from hapticplayer.study.answers import Answers, AnswersTo
from hapticplayer.study.questions import kind_of, range_of

_OF_PEOPLE = {"age", "gender", "handedness", "used_device_before"}
"""Questions that the table of participants has."""
_WORDS = {"true": "yes", "false": "no"}


def question_summary(answers: Answers) -> dict[str, Any]:
    """The counted answers as JSON, by question; of some by feedback."""
    found: dict[str, Any] = {}
    for one in answers.others:
        asked = one.question
        place = found.setdefault(
            asked.key, {"kind": asked.kind.value, "text": one.text}
        )
        part = {"n": len(one.values), **_summary(one)}
        if one.feedback:
            place.setdefault("feedbacks", {})[one.feedback] = part
        else:
            place.update(part)
    return found


def _summary(one: AnswersTo) -> dict[str, Any]:
    if range_of(one.question) is not None:
        if not one.values:
            return {"median": None, "low": None, "high": None}
        spread = {"low": min(one.values), "high": max(one.values)}
        return {"median": float(median(one.values)), **spread}
    counts: Counter[str] = Counter()
    for column in kind_of(one.question).columns:
        if column.of:
            counts[column.of] = sum(column.of in value for value in one.values)
        else:
            counts.update(dict.fromkeys(column.levels or (), 0))
            counts.update(str(value).lower() for value in one.values)
    return {"counts": dict(counts)}


def question_table(answers: Answers) -> Iterator[ReportBlock]:
    """Yield a table of the counted answers, if there are any."""
    rows = tuple(
        (one.text, one.feedback, str(len(one.values)), _said(_summary(one)))
        for one in answers.others
        if one.question.key not in _OF_PEOPLE
    )
    if rows:
        head = ("question", "feedback", "n", "answers")
        note = "Numbers: median (smallest to largest). These answers are not tested."
        yield ReportTable("Other answers", head, rows, note)


def _said(summary: dict[str, Any]) -> str:
    if "counts" in summary:
        counts = summary["counts"].items()
        return ", ".join(f"{count} {_WORDS.get(name, name)}" for name, count in counts)
    if summary["median"] is None:
        return "-"
    return f"{summary['median']:g} ({summary['low']} to {summary['high']})"
