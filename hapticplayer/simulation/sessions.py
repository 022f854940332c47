"""Sessions that no person sat through, such as simulated ones; marked as such."""

import shutil
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.clock import Clock
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import (
    OF_TRIALS,
    Condition,
    Definition,
    QuestionKind,
    QuestionPage,
    When,
)
from hapticplayer.study.intervals import presented
from hapticplayer.study.journal import Journal
from hapticplayer.study.pages import PageMaker
from hapticplayer.study.plan import describe
from hapticplayer.study.questions import kind_of
from hapticplayer.study.session_folder import ANSWERS
from hapticplayer.study.steps import BEFORE, AnsweredTrial, trial_step
from hapticplayer.study.study_folder import Study, begin_session

if TYPE_CHECKING:
    from hapticplayer.simulation.ratings import Raters

Values = Mapping[str, Any]


def write_scripted_session(
    study: Study,
    sheet: Values,
    rate: Callable[..., Values | None],
    clock: Clock,
    *,
    origin: Mapping[str, Any],
    watch: Callable[[Path, int, Condition], tuple[str, ...]] | None = None,
) -> str:
    """Write a whole session as if a participant had taken part, and return its code.

    `sheet` answers questions of the pages before and after the clips, `rate` a
    condition's questions, or those to the two that a trial plays; None leaves the trial
    out, as if it had been skipped. `origin`
    says why there was no participant, such as `{"simulated": true, "seed": 1}`. `watch`
    writes what is rated while a clip plays, and says why the trial is not valid.
    """
    definition = study.definition
    session = begin_session(study, definition.languages[0], {}, clock)
    maker = PageMaker(definition, session.plan)
    journal = Journal(session.folder / ANSWERS, clock)

    def answer(
        page: QuestionPage, values: Values, kind: str = "answers", **of: Any
    ) -> None:
        names = [one.name for one in maker.asked(page)]
        given = {name: values[name] for name in names if name in values}
        if given:
            about = {"step": page.key, **of, "page": page.key}
            journal.append(kind, **about, values=given)

    with _removed_on_failure([session.folder]), closing(journal):
        journal.append("begin", scripted=dict(origin))
        for page in definition.pages_at(When.BEFORE):
            answer(page, sheet)
        answered: list[AnsweredTrial] = []
        for number, condition in enumerate(session.plan.order):
            played = presented(definition, session.plan, number + 1, 1, answered)
            values = rate(*played)
            coming = {"step": trial_step(number + 1), "attempt": 1}
            coming["condition"] = describe(condition)
            for page in definition.pages_at(When.BEFORE_CLIP):
                answer(page, values or {}, BEFORE, **coming)
            reasons: tuple[str, ...] = ()
            if watch is not None and values is not None:
                journal.append("trial-begin", **coming)
                reasons = watch(session.folder, number + 1, condition)
            of = _write_trial(journal, number + 1, condition, values, played, reasons)
            for page in definition.pages_at(When.AFTER_CLIP):
                answer(page, values or {}, **of)
            made = AnsweredTrial(
                *(number + 1, 1, condition, values or {}, not reasons, reasons, {}),
                presented=tuple(one.level for one in played) * (len(played) > 1),
            )
            answered.append(made)
        for page in definition.pages_at(When.AFTER):
            answer(page, sheet)
        journal.append("end", complete=True, reason="")
    return session.code


@contextmanager
def _removed_on_failure(written: Sequence[Path]) -> Iterator[None]:
    """Leave no part of what nobody answered; what a full disk says is an OSError."""
    try:
        yield
    except BaseException as problem:
        for folder in written:
            shutil.rmtree(folder, ignore_errors=True)
        if isinstance(problem.__cause__, OSError):
            raise problem.__cause__ from problem
        raise


def write_answers(
    study: Study,
    answers: Answers,
    clock: Clock,
    *,
    origin: Mapping[str, Any],
    raters: "Raters | None" = None,
) -> list[str]:
    """Add simulated participants to a study, all or none, and return their codes.

    Questions that the answers do not have are answered at random; `raters` rate while clips
    play.
    """
    found: dict[tuple[str, str, str], dict[str, float | None]] = {}
    for one in answers.ratings:
        cell = found.setdefault((one.participant, one.sequence, one.feedback), {})
        cell[one.factor] = one.value
    written: list[Path] = []
    rng = np.random.default_rng(origin.get("seed", 0))
    with _removed_on_failure(written):
        for person in answers.participants:
            known = {
                "age": person.age,
                "gender": person.gender,
                "handedness": person.handedness,
                "used_device_before": person.used_device_before,
            }
            sheet = _completed(study, known, (When.BEFORE, When.AFTER), rng)

            def rate(condition: Condition, code: str = person.code) -> Values:
                cell = found.get((code, condition.sequence, condition.feedback), {})
                return _completed(study, cell, OF_TRIALS, rng)

            watch = raters.person(clock.now_s()).watch if raters else None
            made = write_scripted_session(
                study, sheet, rate, clock, origin=origin, watch=watch
            )
            written.append(study.session_folder(made))
    return [folder.name for folder in written]


def _completed(
    study: Study,
    known: Values,
    when: tuple[When, ...],
    rng: np.random.Generator,
) -> Values:
    """Answers to all questions of some pages, at random where none is known.

    What is known and missing stays so; texts that need not be written are not.
    """
    made = {}
    for asked in study.definition.questions_at(*when):
        kind = kind_of(asked)
        value = known.get(asked.key)
        if asked.key in known and (value is None or kind.allows(value)):
            made[asked.key] = value
        elif asked.required or asked.kind is not QuestionKind.TEXT:
            feedbacks = study.definition.feedback_keys
            each = [f"{asked.key}@{feedback}" for feedback in feedbacks]
            names = each if asked.for_each_feedback else [asked.key]
            made |= {name: kind.drawn(rng) for name in names}
    return made


def random_questions(definition: Definition, known: Collection[str]) -> list[str]:
    """The questions before and after a clip that are answered at random."""
    asked = definition.questions_at(*OF_TRIALS)
    return [one.key for one in asked if one.key not in known]


def _write_trial(
    journal: Journal,
    position: int,
    condition: Condition,
    values: Values | None,
    played: tuple[Condition, ...],
    reasons: tuple[str, ...],
) -> dict[str, Any]:
    """Write a trial, and return what its answers belong to."""
    step, described = trial_step(position), describe(condition)
    if values is None:
        journal.append("skip", step=step, reason="scripted")
        return {}
    journal.append(
        "trial",
        step=step,
        attempt=1,
        condition=described,
        is_valid=not reasons,
        reasons=list(reasons),
        playback={},
        **({"presented": [describe(p.level) for p in played]} if played[1:] else {}),
    )
    return {"step": step, "attempt": 1, "condition": described}
