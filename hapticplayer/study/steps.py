"""The steps of a session, and which of them its records contain."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from msgspec import Struct

from hapticplayer.errors import InputError, Message
from hapticplayer.structures import convert
from hapticplayer.study.definition import Condition, Definition
from hapticplayer.study.journal import Records

CONSENT, SHEET, DEMONSTRATION, POST_TEST = (
    "consent",
    "sheet",
    "demonstration",
    "post-test",
)
Kind = TypeVar("Kind")
_TRIAL = "trial-"
_TRIAL_STEP = re.compile(r"trial-([0-9]{1,6})")


@dataclass(frozen=True, slots=True)
class AnsweredTrial:
    """A trial with its answers.

    Attributes:
        position: in the participant's order, from 1.
        attempt: from 1; more if the trial was repeated.
        condition: of the trial.
        values: answers by key of the question.
        is_valid: whether the playback was valid.
        reasons: why it was not.
        playback: its figures.
        response_s: time from page to answer, s; None if not measured.
    """

    position: int
    attempt: int
    condition: Condition
    values: Mapping[str, Any]
    is_valid: bool
    reasons: tuple[str, ...]
    playback: Mapping[str, Any]
    response_s: float | None = None


def trial_step(position: int) -> str:
    return f"{_TRIAL}{position:02d}"


def position_of(step: str) -> int | None:
    """Return the position of a trial step; None for other steps."""
    found = _TRIAL_STEP.fullmatch(step)
    return int(found[1]) if found else None


MARKED = {
    "trial-begin": "begin",
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


def marker_text(step: str, what: str, order: Sequence[Condition]) -> str:
    """A marker, such as `trial-03 begin bike/random`; without answers."""
    position = position_of(step)
    key = order[position - 1].key if position else ""
    return " ".join(filter(None, (step, what, key)))


def steps_of(definition: Definition, trials: int) -> list[str]:
    """Return the names of all steps in order."""
    steps = [CONSENT]
    if definition.sheet:
        steps.append(SHEET)
    steps.append(DEMONSTRATION)
    steps += [trial_step(position) for position in range(1, trials + 1)]
    if definition.post_test:
        steps.append(POST_TEST)
    return steps


def steps_done(records: Records) -> set[str]:
    """Return the steps that were answered, passed or skipped."""
    kinds = ("answers", "passed", "skip")
    return {
        str(record.content.get("step"))
        for record in records.intact
        if record.kind in kinds
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
    """Yield the answered trials, in the order of their answers."""
    played: dict[tuple[str, int], _Played] = {}
    for record in records.intact:
        if record.kind == "trial" and (trial := _read(record.content, _Played)):
            played[trial.step, trial.attempt] = trial
        if record.kind == "answers" and (answered := _read(record.content, _Answered)):
            position = position_of(answered.step)
            if position is not None:
                yield _trial(position, answered, played)


class _Played(Struct):
    step: str
    attempt: int
    is_valid: bool
    reasons: tuple[str, ...]
    playback: dict[str, Any] = {}


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
    )
