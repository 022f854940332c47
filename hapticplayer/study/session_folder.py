"""One participant's folder: the plan first, then answers, nothing ever rewritten."""

import enum
import hashlib
from dataclasses import dataclass
from pathlib import Path

from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import Message, StudyError
from hapticplayer.study import private
from hapticplayer.study.definition import Definition
from hapticplayer.study.definition_reader import parse_definition
from hapticplayer.study.journal import Records, encode, read_journal
from hapticplayer.study.json_files import read_file
from hapticplayer.study.plan import (
    Plan,
    describe,
    parse_plan_file,
    plan_file,
    plan_of_record,
)

PLAN, DEFINITION_COPY, ANSWERS = "session.json", "study.json", "answers.jsonl"


class SessionState(enum.StrEnum):
    """How far a session is."""

    UNFINISHED = "unfinished"
    """It has no end: it runs, or was interrupted and can be resumed."""
    COMPLETE = "complete"
    STOPPED = "stopped"
    """It ended early: its place in the balance is given to another."""


@dataclass(frozen=True, slots=True)
class StoredSession:
    """A session as it lies on the disk.

    Attributes:
        folder: of the session.
        plan: what was fixed first.
        definition: of the study as it was then.
        records: what happened.
        remarks: what is damaged, one sentence each.
    """

    folder: Path
    plan: Plan
    definition: Definition
    records: Records
    remarks: tuple[str, ...]

    @property
    def code(self) -> str:
        """Of the participant."""
        return self.plan.code

    @property
    def state(self) -> SessionState:
        """How far it is; the last end counts."""
        ends = [r for r in self.records.intact if r.kind == "end"]
        if not ends:
            return SessionState.UNFINISHED
        return (
            SessionState.COMPLETE
            if ends[-1].content.get("complete")
            else SessionState.STOPPED
        )


def create_session(folder: Path, plan: Plan, definition: bytes, clock: Clock) -> None:
    """Make a session's folder with everything that is known before it begins.

    Raises:
        StudyError: when it cannot be written; nothing is left then.
    """
    utc = utc_now_iso("milliseconds")
    first = encode(1, utc, clock.now_s(), "plan", {"plan": describe(plan)})
    with private.folder_written_aside(folder) as aside:
        private.write_new(aside / DEFINITION_COPY, definition)
        private.write_new(aside / PLAN, plan_file(plan))
        private.write_new(aside / ANSWERS, first)


def read_session(folder: Path, study_definition: bytes = b"") -> StoredSession:
    """Return a session, recovering what is intact.

    Args:
        folder: of the session.
        study_definition: content of the study's own definition, which stands in for
            a damaged copy where it is still the same.

    Raises:
        StudyError: when neither copy of the plan, or no copy of the definition, is
            intact.
    """
    records = read_journal(folder / ANSWERS)
    name = f"{folder.name}/{ANSWERS}"
    remarks = [f"{name}: {what}" for what in records.damaged]
    plan = _plan(folder, records, remarks)
    content = _definition(folder, plan, study_definition, remarks)
    definition = parse_definition(content, f"{folder.name}/{DEFINITION_COPY}")
    return StoredSession(folder, plan, definition, records, tuple(remarks))


def _plan(folder: Path, records: Records, remarks: list[str]) -> Plan:
    where = f"{folder.name}/{PLAN}"
    try:
        return parse_plan_file(read_file(folder / PLAN), where)
    except StudyError as problem:
        first = next((r for r in records.intact if r.kind == "plan"), None)
        if first is None:
            raise
        remarks.append(
            Message("{reason}; the copy among the answers was used", reason=problem)
        )
        return plan_of_record(first.content["plan"], f"{folder.name}/{ANSWERS}")


def _definition(
    folder: Path, plan: Plan, study_definition: bytes, remarks: list[str]
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
            "is damaged or missing, and the study's own definition is another one now",
            where=where,
            remedy="copy the session again",
        )
    remarks.append(
        Message("{file}: is damaged; the study's own definition was used", file=where)
    )
    return study_definition


def sha256(content: bytes) -> str:
    """Return the checksum of some bytes."""
    return hashlib.sha256(content).hexdigest()
