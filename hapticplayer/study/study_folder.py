"""The folder of a study: definition, sessions, consents, and deleted participants.

study.json   orders.csv   sessions/CODE/   consents/CODE.json   deleted/ID.json
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from hapticplayer import __version__, storage
from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import Message, StudyError
from hapticplayer.study.definition import (
    Condition,
    Definition,
    JsonObject,
    OrderMethod,
    read_file,
)
from hapticplayer.study.definition_reader import DEFINITION, parse_definition
from hapticplayer.study.journal import Journal, refuse_if_open
from hapticplayer.study.orders import ORDERS, Assignment, Balance, assign, balance_of
from hapticplayer.study.plan import Plan, checked_code, is_code, new_code
from hapticplayer.study.session_folder import (
    ANSWERS,
    LEAVING,
    SessionState,
    StoredSession,
    create_session,
    read_session,
    sha256,
)

SESSIONS, CONSENTS, DELETED = "sessions", "consents", "deleted"


@dataclass(frozen=True, slots=True)
class Study:
    """An opened study.

    Attributes:
        folder: of the study.
        definition: of the study.
        content: of the definition's file.
    """

    folder: Path
    definition: Definition
    content: bytes

    def session_folder(self, code: str) -> Path:
        return self.folder / SESSIONS / checked_code(code)

    def codes(self) -> list[str]:
        try:
            names = [entry.name for entry in (self.folder / SESSIONS).iterdir()]
        except FileNotFoundError:
            return []
        except OSError as problem:
            raise StudyError(
                "cannot be read ({reason})", where=str(self.folder), reason=problem
            ) from problem
        return sorted(name for name in names if is_code(name))

    def session(self, code: str) -> StoredSession:
        """Return one session.

        Raises:
            StudyError: when it does not exist or is too damaged.
        """
        folder = self.session_folder(code)
        if not folder.is_dir():
            raise StudyError(
                "no participant {code}",
                where=str(self.folder),
                remedy="`study status` lists them",
                code=checked_code(code),
            )
        found = read_session(folder, self.content)
        if found.plan.study != self.definition.id:
            raise StudyError(
                "is a session of the study {found}, not {expected}",
                where=f"{folder.name}",
                remedy="move it to its own study",
                found=found.plan.study,
                expected=self.definition.id,
            )
        return found

    def sessions(self) -> tuple[list[StoredSession], list[str]]:
        """Return all sessions by time, and notices.

        The notices name files by their path in the study, for reports.
        """
        found: list[StoredSession] = []
        notices: list[str] = []
        for code in self.codes():
            try:
                found.append(self.session(code))
            except StudyError as problem:
                where = problem.where.removeprefix(f"{self.folder}{os.sep}")
                what = StudyError(problem.what, where=where, remedy=problem.remedy)
                notices.append(
                    Message(
                        "session {code} cannot be used: {what}", code=code, what=what
                    )
                )
            else:
                notices += found[-1].notices
        found.sort(key=lambda session: (session.plan.created_utc, session.code))
        return found, notices

    def listed_orders(self) -> list[tuple[Condition, ...]]:
        """Return the orders of `orders.csv`; empty for other methods."""
        if self.definition.order.method is not OrderMethod.LIST:
            return []
        from hapticplayer.study.order_list import read_orders  # few studies have one

        return read_orders(self.folder / ORDERS, self.definition)

    def order_notices(self) -> list[str]:
        """What is wrong with `orders.csv`, or that it is not used."""
        path = self.folder / ORDERS
        method = self.definition.order.method
        if method is not OrderMethod.LIST and path.exists():
            return [
                Message(
                    "{file} is not used: order.method is {method}",
                    file=ORDERS,
                    method=method.value,
                )
            ]
        try:
            self.listed_orders()
        except StudyError as problem:
            return [str(problem)]
        return []

    def deleted_count(self) -> int:
        """Return the number of deleted participants."""
        folder = self.folder / DELETED
        return sum(1 for _ in folder.glob("*.json")) if folder.is_dir() else 0

    def balance(self) -> Balance:
        sessions, _ = self.sessions()
        orders = [s.plan.order for s in sessions if s.state != SessionState.STOPPED]
        return balance_of(self.definition, orders)


def open_study(folder: str | Path) -> Study:
    """Return the study in a folder; finishes interrupted deletions."""
    folder = Path(folder)
    content = read_file(folder / DEFINITION)
    definition = parse_definition(content, str(folder / DEFINITION))
    study = Study(folder, definition, content)
    if any((folder / SESSIONS).glob(f"{LEAVING}*")):
        from hapticplayer.study import removal

        with storage.locked(folder):
            removal.finish(folder / SESSIONS, folder / DELETED)
    return study


def begin_session(
    study: Study, language: str, clips: Mapping[str, str], clock: Clock
) -> StoredSession:
    """Create the session of a new participant, with a code and an order.

    Args:
        study: opened.
        language: of the pages.
        clips: SHA-256 of each sequence's description, by key.
        clock: of the machine.
    """
    if language not in study.definition.languages:
        raise StudyError(
            "is not available in {language!r}",
            where=str(study.folder),
            remedy="choose one of {known}",
            language=language,
            known=", ".join(study.definition.languages),
        )
    storage.make_folder(study.folder / SESSIONS)
    storage.make_folder(study.folder / CONSENTS)
    with storage.locked(study.folder):
        code = new_code(study.codes())
        made = _assignment(study, code)
        plan = Plan(
            code=code,
            study=study.definition.id,
            definition_sha256=sha256(study.content),
            program=f"hapticplayer {__version__}",
            created_utc=utc_now_iso("milliseconds"),
            language=language,
            method=made.method,
            seed=made.seed,
            row=made.row,
            order=made.conditions,
            labels=made.labels,
            clips=dict(clips),
        )
        create_session(study.session_folder(code), plan, study.content, clock)
    return study.session(code)


def _assignment(study: Study, code: str) -> Assignment:
    sessions, _ = study.sessions()
    used = [
        s.plan.row
        for s in sessions
        if s.state != SessionState.STOPPED
        and s.plan.definition_sha256 == sha256(study.content)
    ]
    return assign(study.definition, code, used, study.listed_orders())


def drop_session(study: Study, code: str, reason: str, clock: Clock) -> None:
    """End an unfinished session; its order is assigned again."""
    session = study.session(code)
    if session.state is SessionState.UNFINISHED:
        journal = Journal(session.folder / ANSWERS, clock)
        try:
            journal.append("end", complete=False, reason=reason, by="operator")
        finally:
            journal.close()


def delete_participant(study: Study, code: str) -> list[str]:
    """Delete a participant; only the number of deleted participants is kept.

    Returns:
        Files in the study's folder that still contain the code, such as earlier
        reports, which have to be made again.
    """
    from hapticplayer.study import removal  # a session has no use for it

    folder = study.session_folder(code)
    consent = study.folder / CONSENTS / f"{folder.name}.json"
    with storage.locked(study.folder):
        if not folder.exists() and not consent.exists():
            study.session(folder.name)
        refuse_if_open(folder / ANSWERS)
        removal.mark(folder, consent, study.folder / DELETED)
        removal.finish(folder.parent, study.folder / DELETED)
    return removal.files_with(study.folder, folder.name.encode())


class Consent(JsonObject, frozen=True, kw_only=True):
    """The decision of a participant, apart from the answers."""

    schema: Literal["hapticplayer.consent"] = "hapticplayer.consent"
    version: Literal[1] = 1
    code: str
    given: bool
    language: str
    text_sha256: str
    utc: str


def save_consent(
    study: Study, code: str, *, given: bool, text: str, language: str
) -> None:
    """Store the decision of a participant."""
    made = Consent(
        code=code,
        given=given,
        language=language,
        text_sha256=sha256(text.encode()),
        utc=utc_now_iso(),
    )
    storage.make_folder(study.folder / CONSENTS)
    path = study.folder / CONSENTS / f"{code}.json"
    content = storage.json_text(msgspec.to_builtins(made))
    storage.replace_file(path, content, storage.PRIVATE_FILE)
