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
    check_plan,
    describe,
    parse_plan_file,
    plan_file,
    plan_of_record,
)
from hapticplayer.study.record_check import sound_records

PLAN, DEFINITION_COPY, ANSWERS = "session.json", "study.json", "answers.jsonl"
LEAVING = ".leaving-"  # begins the name of a session that is being deleted


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
        records: of the journal, those that this program can have written.
        notices: one sentence for each damage.
        is_sound: whether nothing is damaged but by an interrupted write.
    """

    folder: Path
    plan: Plan
    definition: Definition
    records: Records
    notices: tuple[str, ...]
    is_sound: bool

    @property
    def code(self) -> str:
        return self.plan.code

    @property
    def is_simulated(self) -> bool:
        """Whether no person took part."""
        begun = [r for r in self.records.intact if r.kind == "begin"]
        return any("scripted" in record.content for record in begun)

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


def read_session(
    folder: Path, study_definition: bytes = b"", code: str = ""
) -> StoredSession:
    """Return a session, recovered as far as it is intact.

    Args:
        folder: of the session.
        study_definition: content of the definition of the study, which replaces a
            damaged copy if it is unchanged.
        code: of the participant, by default the name of the folder.
    """
    code = code or folder.name
    records = read_journal(folder / ANSWERS)
    name = f"{code}/{ANSWERS}"
    notices = [f"{name}: {what}" for what in records.damaged]
    plan = _plan(folder, code, records, notices)
    content = _definition(folder, plan, study_definition, notices)
    definition = parse_definition(content, f"{code}/{DEFINITION_COPY}")
    check_plan(plan, definition, code, f"{code}/{PLAN}")
    if not _holds(records, plan):
        notices.append(Message("{file}: holds another plan", file=name))
    records, wrong = sound_records(records, plan, definition)
    notices += [f"{name}: {what}" for what in wrong]
    is_sound = len(notices) == records.torn
    return StoredSession(folder, plan, definition, records, tuple(notices), is_sound)


def _plan(folder: Path, code: str, records: Records, notices: list[str]) -> Plan:
    try:
        return parse_plan_file(read_file(folder / PLAN), f"{code}/{PLAN}")
    except StudyError as problem:
        first = next((r for r in records.intact if r.kind == "plan"), None)
        if first is None:
            raise
        notices.append(
            Message("{reason}; the copy in the journal was used", reason=problem)
        )
        return plan_of_record(first.content.get("plan"), f"{code}/{ANSWERS}")


def _holds(records: Records, plan: Plan) -> bool:
    """Whether a journal that begins with an intact plan begins with this one."""
    try:
        return all(
            plan_of_record(record.content.get("plan"), "") == plan
            for record in records.intact[:1]
            if record.number == 1
        )
    except StudyError:
        return False


def _definition(
    folder: Path, plan: Plan, study_definition: bytes, notices: list[str]
) -> bytes:
    try:
        content = read_file(folder / DEFINITION_COPY)
    except StudyError:
        content = b""
    if sha256(content) == plan.definition_sha256:
        return content
    where = f"{plan.code}/{DEFINITION_COPY}"
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
