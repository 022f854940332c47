"""What came of a study so far: its sessions, texts to be read, what a deletion erases."""

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from hapticplayer.errors import Message, Progress, StudyError, no_progress
from hapticplayer.study.answers import (
    collect_answers,
)
from hapticplayer.study.orders import Balance
from hapticplayer.study.reviewing import save_reviewed, text_digest
from hapticplayer.study.sequence_folders import sequence_folder
from hapticplayer.study.session_folder import SessionState, StoredSession
from hapticplayer.study.steps import answered_trials
from hapticplayer.study.study_folder import CONSENTS, Study, open_study


class InvalidTrial(NamedTuple):
    """A trial whose answers follow a playback that was not valid."""

    position: int
    condition: str
    reasons: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SessionSummary:
    """A session in a list.

    Attributes:
        code: of the participant.
        created_utc: ISO 8601.
        state: of the session.
        simulated: whether no person took part.
        devices: that trials were played on, by the engine's names.
        answered, planned: trials.
        invalid: the answered trials whose last playback was not valid.
        resumed: how often it was.
        damaged: places in its records.
    """

    code: str
    created_utc: str
    state: SessionState
    simulated: bool
    devices: tuple[str, ...]
    answered: int
    planned: int
    invalid: tuple[InvalidTrial, ...]
    resumed: int
    damaged: int


class UnreviewedText(NamedTuple):
    """A text answer that nobody has approved for export."""

    code: str
    question: str
    text: str


@dataclass(frozen=True, slots=True)
class StudyOverview:
    """What came of a study so far.

    Attributes:
        sessions: by time.
        deleted: number of deleted participants.
        unreviewed: text answers.
        missing: keys of sequences without a recording.
        balance: of the orders.
        notices: what cannot be used, and why.
    """

    sessions: tuple[SessionSummary, ...]
    deleted: int
    unreviewed: tuple[UnreviewedText, ...]
    missing: tuple[str, ...]
    balance: Balance
    notices: tuple[str, ...]


def study_overview(folder: Path, *, progress: Progress = no_progress) -> StudyOverview:
    """The state of the study in a folder."""
    progress(0.0, Message("reading the sessions"))
    study = open_study(folder)
    sessions, notices = study.sessions()
    return StudyOverview(
        sessions=tuple(session_summary(session) for session in sessions),
        deleted=study.deleted_count(),
        unreviewed=tuple(unreviewed_texts(study)),
        missing=tuple(missing_sequences(study)),
        balance=study.balance(),
        notices=(*notices, *study.order_notices()),
    )


def session_summary(session: StoredSession) -> SessionSummary:
    """What the records of a session contain."""
    last = {trial.position: trial for trial in answered_trials(session.records)}
    outputs = [trial.playback.get("outputs") for trial in last.values()]
    named = [name for names in outputs if isinstance(names, list) for name in names]
    return SessionSummary(
        code=session.code,
        created_utc=session.plan.created_utc,
        state=session.state,
        simulated=session.is_simulated,
        devices=tuple(dict.fromkeys(str(name) for name in named)),
        answered=len(last),
        planned=len(session.plan.order),
        invalid=tuple(
            InvalidTrial(trial.position, trial.condition.key, trial.reasons)
            for _, trial in sorted(last.items())
            if not trial.is_valid
        ),
        resumed=sum(r.kind == "resume" for r in session.records.intact),
        damaged=len(session.records.damaged),
    )


def missing_sequences(study: Study) -> list[str]:
    """The keys of sequences without a recording."""
    missing = []
    for sequence in study.definition.sequences:
        try:
            sequence_folder(study, sequence.key)
        except StudyError:
            missing.append(sequence.key)
    return missing


def unreviewed_texts(study: Study) -> list[UnreviewedText]:
    """The text answers that nobody has approved for export."""
    return [
        UnreviewedText(
            answer.participant,
            answer.name,
            answer.text,
        )
        for answer in collect_answers(study).open_answers
        if not answer.reviewed
    ]


def approve_texts(study: Study, code: str, question: str = "") -> None:
    """Allow text answers of a participant to be exported; all, or those to a question."""
    folder = study.session(code).folder
    digests = [
        text_digest(*one)
        for one in unreviewed_texts(study)
        if one.code == folder.name and question in ("", one.question)
    ]
    if not digests:
        raise StudyError(f"{code}:{question} has no answer in words to pass")
    save_reviewed(folder, digests)


def traces_of(study: Study, code: str) -> list[Path]:
    """The files that the deletion of a participant erases."""
    folder = study.session_folder(code)
    consent = study.folder / CONSENTS / f"{folder.name}.json"
    found = sorted(path for path in folder.rglob("*") if path.is_file())
    return [*found, *([consent] if consent.is_file() else [])]
