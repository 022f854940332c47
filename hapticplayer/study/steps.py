"""The steps of a session, and which of them its records contain."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from msgspec import Struct

from hapticplayer.errors import InputError, Message
from hapticplayer.structures import convert
from hapticplayer.study.definition import (
    Condition,
    Definition,
    FeedbackLevel,
    QuestionPage,
    When,
)
from hapticplayer.study.journal import Records

CONSENT, DEMONSTRATION = "consent", "demonstration"
Kind = TypeVar("Kind")
_TRIAL = "trial-"
_TRIAL_STEP = re.compile(r"trial-([0-9]{1,6})")


@dataclass(frozen=True, slots=True)
class AnsweredTrial:
    """A trial with its answers, or those to some of its pages.

    Attributes:
        position: in the participant's order, from 1.
        attempt: from 1; more if the trial was repeated.
        condition: of the trial.
        values: answers by key of the question.
        is_valid: whether the playback was valid.
        reasons: why it was not.
        playback: its figures.
        response_s: time from pages to answers, s; None if not measured.
        pages: number of those that were answered.
        presented: the forces of a two-interval trial, in the order in which they were
            played.
    """

    position: int
    attempt: int
    condition: Condition
    values: Mapping[str, Any]
    is_valid: bool
    reasons: tuple[str, ...]
    playback: Mapping[str, Any]
    response_s: float | None = None
    pages: int = 1
    presented: tuple[FeedbackLevel, ...] = ()


def trial_step(position: int) -> str:
    return f"{_TRIAL}{position:02d}"


def position_of(step: str) -> int | None:
    """Return the position of a trial step; None for other steps."""
    found = _TRIAL_STEP.fullmatch(step)
    return int(found[1]) if found else None


INTERVAL = "interval"
"""The kind of a record: the first of two plays of a trial has ended."""
MARKED = {
    "trial-begin": "begin",
    INTERVAL: "interval",
    "trial": "end",
    "pause": "pause",
    "go-on": "go on",
    "repeat": "repeat",
    "skip": "skip",
    "resume": "resume",
    "end": "session end",
}
"""What records are called as markers for other programs, by their kind."""
FIRST_FRAME = "first frame"
BEFORE = "answers-before"
"""The kind of a record: answers to a page before a clip, with the coming attempt."""


def marker_text(step: str, what: str, order: Sequence[Condition]) -> str:
    """A marker, such as `trial-03 begin bike/random`; without answers."""
    position = position_of(step)
    key = order[position - 1].key if position else ""
    return " ".join(filter(None, (step, what, key)))


def steps_of(definition: Definition, trials: int) -> list[str]:
    """Return the names of all steps in order; those of pages are their keys."""
    return [
        CONSENT,
        *(page.key for page in definition.pages_at(When.BEFORE)),
        DEMONSTRATION,
        *(trial_step(position) for position in range(1, trials + 1)),
        *(page.key for page in definition.pages_at(When.AFTER)),
    ]


def pages_before(definition: Definition, step: str) -> tuple[QuestionPage, ...]:
    return definition.pages_at(When.BEFORE_CLIP) if position_of(step) else ()


def pages_of(definition: Definition, step: str) -> tuple[QuestionPage, ...]:
    """The pages of questions of a step; of a trial those after its clip."""
    if position_of(step):
        return definition.pages_at(When.AFTER_CLIP)
    return tuple(page for page in definition.pages if page.key == step)


def answered_pages(
    records: Records, kinds: Sequence[str] = ("answers",)
) -> set[tuple[str, int, str]]:
    """The pages that were answered: step, attempt (0 where there is none), key."""
    found = set()
    for record in records.intact:
        if record.kind in kinds and (one := _read(record.content, _Page)):
            found.add((one.step, one.attempt, one.page))
    return found


def steps_done(records: Records, definition: Definition) -> set[str]:
    """Return the steps that were answered, passed or skipped."""
    answered: dict[tuple[str, int], set[str]] = {}
    for step, attempt, page in answered_pages(records):
        answered.setdefault((step, attempt), set()).add(page)
    done = {
        step
        for (step, _), found in answered.items()
        if found >= {page.key for page in pages_of(definition, step)}
    }
    return done | {
        str(record.content.get("step"))
        for record in records.intact
        if record.kind in ("passed", "skip")
    }


def attempts_of(records: Records, step: str) -> int:
    """Return how often a trial was started."""
    return sum(
        record.kind == "trial-begin" and record.content.get("step") == step
        for record in records.intact
    )


def page_values(records: Records, page: str) -> Mapping[str, Any]:
    """Return the last answers to a page other than a trial."""
    found: Mapping[str, Any] = {}
    for record in records.intact:
        if record.kind == "answers" and record.content.get("step") == page:
            values = record.content.get("values")
            found = values if isinstance(values, dict) else {}
    return found


def answered_trials(records: Records) -> Iterator[AnsweredTrial]:
    """Yield the answered trials, in the order of their first answers."""
    played: dict[tuple[str, int], _Played] = {}
    before: dict[tuple[str, int], dict[str, Any]] = {}
    found: dict[tuple[str, int], AnsweredTrial] = {}
    for record in records.intact:
        if record.kind == BEFORE and (asked := _read(record.content, _Answered)):
            of = before.setdefault((asked.step, asked.attempt), {})
            of |= asked.values
        if record.kind == "trial" and (trial := _read(record.content, _Played)):
            played[trial.step, trial.attempt] = trial
        if record.kind == "answers" and (answered := _read(record.content, _Answered)):
            position = position_of(answered.step)
            if position is not None:
                made = _trial(position, answered, played)
                key = answered.step, answered.attempt
                made = replace(made, values={**before.get(key, {}), **made.values})
                found[key] = _joined(found[key], made) if key in found else made
    yield from found.values()


def _joined(first: AnsweredTrial, next_page: AnsweredTrial) -> AnsweredTrial:
    times_s = first.response_s, next_page.response_s
    return replace(
        next_page,
        values={**first.values, **next_page.values},
        pages=first.pages + 1,
        response_s=None if None in times_s else round(sum(filter(None, times_s)), 3),
    )


class _Played(Struct):
    step: str
    attempt: int
    is_valid: bool
    reasons: tuple[str, ...]
    playback: dict[str, Any] = {}
    presented: tuple[FeedbackLevel, ...] = ()


class _Page(Struct):
    step: str
    page: str
    attempt: int = 0


class _Answered(Struct):
    step: str
    attempt: int
    condition: Condition
    values: dict[str, Any]
    response_s: float | None = None


def _read(content: Mapping[str, Any], kind: type[Kind]) -> Kind | None:
    """The content of a record; None for another one."""
    try:
        return convert(dict(content), kind, "")
    except InputError:
        return None


def _trial(
    position: int,
    answers: _Answered,
    played: Mapping[tuple[str, int], _Played],
) -> AnsweredTrial:
    """Return a trial; without a playback record it is not marked as valid."""
    lost = _Played("", 0, is_valid=False, reasons=(Message("record damaged"),))
    trial = played.get((answers.step, answers.attempt), lost)
    return AnsweredTrial(
        position,
        answers.attempt,
        answers.condition,
        answers.values,
        trial.is_valid,
        trial.reasons,
        trial.playback,
        answers.response_s,
        presented=trial.presented,
    )
