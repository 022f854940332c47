"""The folder of a session: plan and definition, then the journal; append-only."""

import enum
import hashlib
from dataclasses import dataclass
from pathlib import Path

from hapticplayer import storage
from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import Message, StudyError
from hapticplayer.study.definition import Definition, read_file
from hapticplayer.study.definition_reader import parse_definition
from hapticplayer.study.journal import Records, encode, read_journal
from hapticplayer.study.plan import (
    Plan,
    describe,
    parse_plan_file,
    plan_file,
    plan_of_record,
)

PLAN, DEFINITION_COPY, ANSWERS = "session.json", "study.json", "answers.jsonl"


class SessionState(enum.StrEnum):
    """State of a session."""

    UNFINISHED = "unfinished"
    """Running, or interrupted and can be resumed."""
    COMPLETE = "complete"
    STOPPED = "stopped"
    """Ended early; its order is assigned again."""


@dataclass(frozen=True, slots=True)
class StoredSession:
    """A stored session.

    Attributes:
        folder: of the session.
        plan: of the session.
        definition: of the study when the session began.
        records: of the journal.
        notices: one sentence for each damage.
    """

    folder: Path
    plan: Plan
    definition: Definition
    records: Records
    notices: tuple[str, ...]

    @property
    def code(self) -> str:
        return self.plan.code

    @property
    def state(self) -> SessionState:
        """State of the session, by its last end."""
        ends = [r for r in self.records.intact if r.kind == "end"]
        if not ends:
            return SessionState.UNFINISHED
        return (
            SessionState.COMPLETE
            if ends[-1].content.get("complete")
            else SessionState.STOPPED
        )


def create_session(folder: Path, plan: Plan, definition: bytes, clock: Clock) -> None:
    """Make the folder of a session with definition, plan and journal."""
    utc = utc_now_iso("milliseconds")
    first = encode(1, utc, clock.now_s(), "plan", {"plan": describe(plan)})
    with storage.folder_written_aside(folder, storage.PRIVATE_FOLDER) as aside:
        storage.write_private(aside / DEFINITION_COPY, definition)
        storage.write_private(aside / PLAN, plan_file(plan))
        storage.write_private(aside / ANSWERS, first)


def read_session(folder: Path, study_definition: bytes = b"") -> StoredSession:
    """Return a session, recovered as far as it is intact.

    Args:
        folder: of the session.
        study_definition: content of the definition of the study, which replaces a
            damaged copy if it is unchanged.
    """
    records = read_journal(folder / ANSWERS)
    name = f"{folder.name}/{ANSWERS}"
    notices = [f"{name}: {what}" for what in records.damaged]
    plan = _plan(folder, records, notices)
    content = _definition(folder, plan, study_definition, notices)
    definition = parse_definition(content, f"{folder.name}/{DEFINITION_COPY}")
    return StoredSession(folder, plan, definition, records, tuple(notices))


def _plan(folder: Path, records: Records, notices: list[str]) -> Plan:
    where = f"{folder.name}/{PLAN}"
    try:
        return parse_plan_file(read_file(folder / PLAN), where)
    except StudyError as problem:
        first = next((r for r in records.intact if r.kind == "plan"), None)
        if first is None:
            raise
        notices.append(
            Message("{reason}; the copy in the journal was used", reason=problem)
        )
        return plan_of_record(first.content.get("plan"), f"{folder.name}/{ANSWERS}")


def _definition(
    folder: Path, plan: Plan, study_definition: bytes, notices: list[str]
) -> bytes:
    try:
        content = read_file(folder / DEFINITION_COPY)
    except StudyError:
        content = b""
    if sha256(content) == plan.definition_sha256:
        return content
    where = f"{folder.name}/{DEFINITION_COPY}"
    if sha256(study_definition) != plan.definition_sha256:
        raise StudyError(
            "is damaged or missing, and the definition of the study has changed",
            where=where,
            remedy="copy the session again",
        )
    notices.append(
        Message("{file}: is damaged; the definition of the study was used", file=where)
    )
    return study_definition


def sha256(content: bytes) -> str:
    """Return the SHA-256 of some bytes in hexadecimal."""
    return hashlib.sha256(content).hexdigest()
