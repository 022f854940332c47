"""What a session's records must hold: files can be edited, or come from another site.

A checksum says that a record is as it was written, not that this program wrote it. A
record that this program would not have written is left out and named, and so is an
answer that its question does not allow.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Annotated, Any

from msgspec import Meta, Struct

from hapticplayer.clock import is_time
from hapticplayer.errors import InputError, Message, StudyError
from hapticplayer.structures import convert
from hapticplayer.study.definition import (
    Amount,
    Condition,
    Definition,
    FeedbackLevel,
)
from hapticplayer.study.journal import JournalRecord, Records
from hapticplayer.study.pages import AskedQuestion, PageMaker
from hapticplayer.study.plan import Plan
from hapticplayer.study.questions import kind_of
from hapticplayer.study.steps import (
    BEFORE,
    INTERVAL,
    pages_before,
    pages_of,
    position_of,
)

_Count = Annotated[int, Meta(ge=0, le=10**9)]
_Number = Annotated[float, Meta(ge=-1e9, le=1e9)]
_Attempt = Annotated[int, Meta(ge=1, le=10_000)]


class _Event(Struct):
    step: str = ""
    reason: str = ""
    text: str = ""
    by: str = ""
    program: str = ""
    scripted: dict[str, Any] = {}


class _OfTrial(Struct):
    step: str
    attempt: _Attempt
    condition: Condition


class _Playback(Struct):
    """Figures of `stage`; sessions that nobody sat through have none."""

    begun_mono_s: Amount | None = None
    ended_mono_s: Amount | None = None
    media_s: _Number | None = None
    duration_s: Amount | None = None
    first_frame_mono_s: Amount | None = None
    frames_shown: _Count | None = None
    frames_dropped: _Count | None = None
    silence_s: Amount | None = None
    clock: str = ""
    force_minus_video_ms: dict[str, _Number] | None = None
    force_minus_sound_ms: dict[str, _Number] | None = None
    ticks: _Count | None = None
    missed: _Count | None = None
    force_rms_n: tuple[Amount, ...] = ()
    faults: tuple[dict[str, Any], ...] = ()
    outputs: tuple[str, ...] = ()
    output_faults: dict[str, str] = {}
    scheduling: str = ""
    record: str = ""


class _Trial(_OfTrial):
    is_valid: bool
    reasons: tuple[str, ...]
    playback: _Playback
    presented: tuple[FeedbackLevel, ...] = ()


class _Answers(Struct):
    step: str
    page: str
    values: dict[str, Any]
    response_s: Amount | None = None


class _TrialAnswers(_Answers, kw_only=True):
    attempt: _Attempt
    condition: Condition


class _Checks(Struct):
    checks: tuple[dict[str, Any], ...]
    overridden: bool


class _Replay(Struct):
    sequence: str
    feedback: str


class _End(Struct):
    complete: bool
    reason: str
    by: str = ""


_EVENTS = ("begin", "resume", "passed", "skip", "repeat", "pause", "go-on")
_KINDS: dict[str, type[Struct]] = {
    **dict.fromkeys((*_EVENTS, "demonstration", "note"), _Event),
    "checks": _Checks,
    "trial-begin": _OfTrial,
    "trial": _Trial,
    INTERVAL: _Trial,
    "answers": _Answers,
    BEFORE: _TrialAnswers,
    "replay": _Replay,
    "end": _End,
}


def sound_records(
    records: Records, plan: Plan, definition: Definition
) -> tuple[Records, list[str]]:
    """The records that this program can have written, and a sentence for each other."""
    check = _RecordCheck(plan, definition)
    kept: list[JournalRecord] = []
    notices: list[str] = list(_missing(records))
    for record in records.intact:
        try:
            kept.append(check.sound(record, notices.append))
        except StudyError as problem:
            notices.append(
                Message(
                    "record {number} ({kind}) was left out: {reason}",
                    number=record.number,
                    kind=record.kind if record.kind in _KINDS else "?",
                    reason=problem,
                )
            )
    return replace(records, intact=tuple(kept)), notices


def _missing(records: Records) -> Iterator[Message]:
    """Name records that were taken out; behind damage the numbers go on later."""
    found = {record.number for record in records.intact}
    last = max(found, default=0)
    if records.damaged or len(found) >= last:
        return
    yield Message(
        "{count} records are missing, the first is number {number}",
        count=last - len(found),
        number=next(one for one in range(1, last) if one not in found),
    )


class _RecordCheck:
    def __init__(self, plan: Plan, definition: Definition) -> None:
        self._plan, self._definition = plan, definition
        maker = PageMaker(definition, plan)
        self._questions: dict[str, dict[str, AskedQuestion]] = {
            page.key: {one.name: one for one in maker.asked(page)}
            for page in definition.pages
        }
        self._seen: dict[int, JournalRecord] = {}

    def sound(
        self, record: JournalRecord, notify: Callable[[str], None]
    ) -> JournalRecord:
        """The record, without answers that are not allowed; StudyError for a wrong one."""
        self._refuse_repeated(record)
        if not is_time(record.utc):
            raise StudyError("utc is not a time with its zone")
        if not _is_unicode(record.content):
            raise StudyError("it holds half a character")
        if record.kind == "plan":
            if record.number != 1:
                raise StudyError("a session has one plan")
            return record
        if record.kind not in _KINDS:
            raise StudyError("the kind is not known")
        found = _read(record, _KINDS[record.kind])
        if isinstance(found, _OfTrial):
            self._refuse_other_trial(found.step, found.condition)
        if isinstance(found, _Trial) and found.is_valid == bool(found.reasons):
            raise StudyError("is_valid and reasons contradict each other")
        if isinstance(found, _Trial) and found.presented:
            self._refuse_other_forces(found.presented)
        if isinstance(found, _Answers):
            return self._answers(record, found, notify)
        return record

    def _refuse_repeated(self, record: JournalRecord) -> None:
        """Refuse a line that is there twice, after a failed sync or by hand."""
        before = self._seen.setdefault(record.number, record)
        if before is not record:
            is_same = (before.kind, before.content) == (record.kind, record.content)
            raise StudyError(
                "it appears twice" if is_same else "another record has this number"
            )

    def _refuse_other_trial(self, step: str, condition: Condition) -> None:
        position = position_of(step)
        if position is None or not 1 <= position <= len(self._plan.order):
            raise StudyError("there is no trial {step!r}", step=step[:40])
        if self._plan.order[position - 1] != condition:
            raise StudyError(
                "{key} is not the condition of {step}", key=condition.key, step=step
            )

    def _refuse_other_forces(self, presented: tuple[FeedbackLevel, ...]) -> None:
        """Refuse forces that no trial of this study has."""
        standard, known = self._definition.standard, self._definition.feedback_keys
        if standard not in presented or len(presented) != 2:
            raise StudyError("the standard is not one of two forces")
        if not {one.feedback for one in presented} <= set(known):
            raise StudyError("a force is not of this study")

    def _answers(
        self, record: JournalRecord, found: _Answers, notify: Callable[[str], None]
    ) -> JournalRecord:
        pages_in = pages_before if record.kind == BEFORE else pages_of
        pages = {page.key for page in pages_in(self._definition, found.step)}
        if position_of(found.step) or not pages:
            trial = _read(record, _TrialAnswers)
            self._refuse_other_trial(trial.step, trial.condition)
        if found.page not in pages:
            raise StudyError(
                "there is no page {page!r} in {step}",
                page=found.page[:40],
                step=found.step,
            )
        questions = self._questions[found.page]
        wrong = dict(_wrong(found.values, questions))
        for name, reason in wrong.items():
            notify(
                Message(
                    "record {number}: the answer to {name!r} in {step} was left out: {reason}",
                    number=record.number,
                    name=name[:40],
                    step=found.step,
                    reason=reason,
                )
            )
        values = {name: one for name, one in found.values.items() if name not in wrong}
        return replace(record, content={**record.content, "values": values})


def _wrong(
    values: dict[str, Any], questions: dict[str, AskedQuestion]
) -> Iterator[tuple[str, Message]]:
    """Yield answers that are not allowed, with the reason."""
    for name, value in values.items():
        if name not in questions:
            yield name, Message("is not a question of this page")
        elif value is not None and not kind_of(questions[name].question).allows(value):
            shown = repr(value)[:40]
            yield name, Message("{value} is not allowed", value=shown)


def _read(record: JournalRecord, kind: type[Any]) -> Any:
    try:
        return convert(dict(record.content), kind, "", StudyError)
    except InputError as problem:
        raise StudyError(problem.what, where=problem.where) from None


def _is_unicode(content: Any) -> bool:
    """Whether texts can be written; the journal replaces what cannot."""
    try:
        json.dumps(dict(content), ensure_ascii=False).encode()
    except UnicodeEncodeError:
        return False
    return True
