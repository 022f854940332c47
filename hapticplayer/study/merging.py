"""Merging the sessions of a copy of the study on another machine."""

import shutil
from dataclasses import dataclass
from pathlib import Path

from hapticplayer import storage
from hapticplayer.errors import StudyError
from hapticplayer.structures import decode as decode_json
from hapticplayer.study.definition import read_file
from hapticplayer.study.journal import MAX_BYTES, decode
from hapticplayer.study.session_folder import ANSWERS, read_session, sha256
from hapticplayer.study.study_folder import CONSENTS, SESSIONS, Consent, Study
from hapticplayer.untrusted import open_regular


@dataclass(frozen=True, slots=True)
class Merged:
    """The result of a merge.

    Attributes:
        added: codes of new sessions.
        same: codes of sessions that were already here.
        conflicts: one sentence for each session that was not merged.
        notices: one sentence for each added session with other clips.
    """

    added: tuple[str, ...]
    same: tuple[str, ...]
    conflicts: tuple[str, ...]
    notices: tuple[str, ...] = ()


def merge_sessions(study: Study, other: Study) -> Merged:
    """Copy the sessions of another copy of a study into this one.

    Existing sessions are not changed; different sessions of one code are a conflict, and
    so is one that is damaged, which stays where it is.
    """
    if other.definition.id != study.definition.id:
        raise StudyError(
            "is the study {found}, not {expected}",
            where=str(other.folder),
            remedy="copy the study's folder to the other machine, then run it there",
            found=other.definition.id,
            expected=study.definition.id,
        )
    storage.make_folder(study.folder / SESSIONS)
    storage.make_folder(study.folder / CONSENTS)
    here = set(study.codes())
    added: list[str] = []
    same: list[str] = []
    conflicts: list[str] = []
    for code in other.codes():
        theirs = other.session_folder(code)
        with storage.locked(study.folder):
            is_here = code in study.codes()
            problem = (
                _difference(study.session_folder(code), theirs)
                if is_here
                else _copy_session(study, other, code)
            )
        if problem:
            conflicts.append(f"{code}: {problem}")
        else:
            (same if is_here else added).append(code)
    notices = _other_clips(study, here, added)
    return Merged(tuple(added), tuple(same), tuple(conflicts), notices)


def _other_clips(study: Study, here: set[str], added: list[str]) -> tuple[str, ...]:
    """Return which added sessions played other clips than the existing ones."""
    sessions, _ = study.sessions()
    known: dict[str, set[str]] = {}
    for session in sessions:
        for key, checksum in session.plan.clips.items():
            if session.code in here:
                known.setdefault(key, set()).add(checksum)
    return tuple(
        f"{session.code}: played another sequence {key!r} than the sessions here"
        for session in sessions
        for key, checksum in session.plan.clips.items()
        if session.code in added and key in known and checksum not in known[key]
    )


def _copy_session(study: Study, other: Study, code: str) -> str:
    """Copy a session that is sound; return why it is left out, or ""."""
    folder = other.session_folder(code)
    try:
        consent = _consent(other, code)
        with storage.folder_written_aside(
            study.session_folder(code), storage.PRIVATE_FOLDER
        ) as aside:
            for path in sorted(folder.iterdir()):
                if path.is_file() and not path.is_symlink():
                    _copy(path, aside / path.name)
            _refuse_damaged(aside, study, code)
            if consent:
                target = study.folder / CONSENTS / f"{code}.json"
                storage.replace_file(target, consent, storage.PRIVATE_FILE)
    except StudyError as problem:
        return f"cannot be read there ({problem})"
    return ""


def _refuse_damaged(copied: Path, study: Study, code: str) -> None:
    """Raise StudyError for a copy that holds more than this program wrote, or less."""
    found = read_session(copied, study.content, code)
    if found.plan.study != study.definition.id:
        raise StudyError("it belongs to the study {found}", found=found.plan.study)
    if not found.is_sound:
        raise StudyError(
            "{count} places are damaged: {first}",
            remedy="copy it from the other machine again; to use what is intact, move "
            "its folder into sessions",
            count=len(found.notices) - found.records.torn,
            first=found.notices[0],
        )


def _consent(other: Study, code: str) -> bytes:
    """The file of a participant's consent, checked; empty without one."""
    path = other.folder / CONSENTS / f"{code}.json"
    if not path.is_file():
        return b""
    content = read_file(path)
    found = decode_json(content, Consent, f"{CONSENTS}/{code}.json", StudyError)
    if found.code != code:
        raise StudyError(
            "is the consent of {code}", where=f"{CONSENTS}/{code}.json", code=found.code
        )
    return content


def _copy(source: Path, target: Path) -> None:
    with (
        open_regular(source, StudyError) as reader,
        storage.private_writer(target) as writer,
    ):
        shutil.copyfileobj(reader, writer)


def _difference(ours: Path, theirs: Path) -> str:
    """Return how two sessions of one code differ, or ""."""
    try:
        left, right = (read_file(f / ANSWERS, MAX_BYTES) for f in (ours, theirs))
    except StudyError as problem:
        return f"cannot be compared ({problem})"
    return _different(left, right)


def _different(ours: bytes, theirs: bytes) -> str:
    """Return how two journals of one code differ, or ""."""
    left, right = decode(ours).intact, decode(theirs).intact
    if left == right:
        return ""
    shared = min(len(left), len(right))
    if left[:shared] == right[:shared]:
        if len(left) > len(right):
            return ""  # an earlier copy of ours
        return (
            f"is longer there ({len(right) - shared} more records); "
            "move the shorter one here out of the study and merge again"
        )
    return (
        f"two sessions of one code ({sha256(ours)[:8]} here, "
        f"{sha256(theirs)[:8]} there)"
    )
