"""The steps of a session, and which of them its records contain."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message, StudyError
from hapticplayer.structures import convert
from hapticplayer.study.definition import Condition, Definition
from hapticplayer.study.journal import Records

CONSENT, SHEET, DEMONSTRATION, POST_TEST = (
    "consent",
    "sheet",
    "demonstration",
    "post-test",
)
_TRIAL = "trial-"


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
    return int(step.removeprefix(_TRIAL)) if step.startswith(_TRIAL) else None


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
    played: dict[tuple[str, int], Mapping[str, Any]] = {}
    for record in records.intact:
        content = record.content
        if record.kind not in ("trial", "answers"):
            continue
        step, attempt = str(content.get("step")), content.get("attempt")
        if not isinstance(attempt, int) or not step.startswith(_TRIAL):
            continue
        if record.kind == "trial":
            played[step, attempt] = content
        elif (trial := _trial(step, attempt, content, played)) is not None:
            yield trial


def _trial(
    step: str,
    attempt: int,
    answers: Mapping[str, Any],
    played: Mapping[tuple[str, int], Mapping[str, Any]],
) -> AnsweredTrial | None:
    """Return a trial; without a playback record it is not marked as valid."""
    trial = played.get((step, attempt), {})
    position, values = position_of(step), answers.get("values")
    try:
        condition = convert(answers.get("condition"), Condition, step, StudyError)
    except StudyError:
        return None
    if position is None or not isinstance(values, dict):
        return None
    return AnsweredTrial(
        position,
        attempt,
        condition,
        values,
        trial.get("is_valid") is True,
        tuple(
            str(reason) for reason in trial.get("reasons", [Message("record damaged")])
        ),
        trial.get("playback", {}),
        answers.get("response_s"),
    )
