"""Sessions that no person sat through, such as simulated ones; marked as such."""

import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from hapticplayer.clock import Clock
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import Condition
from hapticplayer.study.journal import Journal
from hapticplayer.study.plan import describe
from hapticplayer.study.session_folder import ANSWERS
from hapticplayer.study.steps import SHEET, trial_step
from hapticplayer.study.study_folder import Study, begin_session

Values = Mapping[str, Any]


def write_scripted_session(
    study: Study,
    sheet: Values,
    rate: Callable[[Condition], Values | None],
    clock: Clock,
    *,
    origin: Mapping[str, Any],
) -> str:
    """Write a whole session as if a participant had taken part, and return its code.

    `sheet` answers the information sheet, `rate` a condition's questions; None leaves
    the trial out, as if it had been skipped. `origin` says why there was no
    participant, such as `{"simulated": true, "seed": 1}`.
    """
    session = begin_session(study, study.definition.languages[0], {}, clock)
    journal = Journal(session.folder / ANSWERS, clock)
    with _removed_on_failure([session.folder]), closing(journal):
        journal.append("begin", scripted=dict(origin))
        journal.append("answers", step=SHEET, values=dict(sheet))
        for number, condition in enumerate(session.plan.order):
            _write_trial(journal, number + 1, condition, rate(condition))
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
    study: Study, answers: Answers, clock: Clock, *, origin: Mapping[str, Any]
) -> list[str]:
    """Add simulated participants to a study, all or none, and return their codes."""
    found: dict[tuple[str, str, str], dict[str, int | None]] = {}
    for one in answers.ratings:
        cell = found.setdefault((one.participant, one.sequence, one.feedback), {})
        cell[one.factor] = one.value
    written: list[Path] = []
    with _removed_on_failure(written):
        for person in answers.participants:
            sheet = {
                "age": person.age,
                "gender": person.gender,
                "handedness": person.handedness,
                "used_device_before": person.used_device_before,
            }

            def rate(condition: Condition, code: str = person.code) -> Values:
                return found[code, condition.sequence, condition.feedback]

            made = write_scripted_session(study, sheet, rate, clock, origin=origin)
            written.append(study.session_folder(made))
    return [folder.name for folder in written]


def _write_trial(
    journal: Journal, position: int, condition: Condition, values: Values | None
) -> None:
    step, described = trial_step(position), describe(condition)
    if values is None:
        journal.append("skip", step=step, reason="scripted")
        return
    journal.append(
        "trial",
        step=step,
        attempt=1,
        condition=described,
        is_valid=True,
        reasons=[],
        playback={},
    )
    journal.append(
        "answers", step=step, attempt=1, condition=described, values=dict(values)
    )
