"""Merging the sessions of a copy of the study on another machine."""

import re
import shutil
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from hapticplayer import storage
from hapticplayer.errors import Message, Progress, StudyError, no_progress, part_of
from hapticplayer.structures import KEY
from hapticplayer.structures import decode as decode_json
from hapticplayer.study.definition import read_file
from hapticplayer.study.definition_reader import DEFINITION
from hapticplayer.study.journal import MAX_BYTES, decode
from hapticplayer.study.plan import parse_plan_file
from hapticplayer.study.session_folder import (
    ANSWERS,
    PLAN,
    StoredSession,
    read_session,
    sha256,
)
from hapticplayer.study.sites import (
    SITE,
    SiteSummary,
    refuse_altered,
    refuse_other_package,
    site_content,
    site_of,
    site_summary,
)
from hapticplayer.study.study_folder import CONSENTS, SESSIONS, Consent, Study
from hapticplayer.untrusted import open_regular

_AT_ONCE = 8  # sessions: most of the time the disk is waited for


@dataclass(frozen=True, slots=True)
class Merged:
    """The result of a merge.

    Attributes:
        added: codes of new sessions.
        same: codes of sessions that were already here.
        conflicts: one sentence for each session that was not merged.
        notices: one sentence for each added session with other clips.
        site: what the added sessions show.
    """

    added: tuple[str, ...]
    same: tuple[str, ...]
    conflicts: tuple[Message, ...]
    notices: tuple[Message, ...]
    site: SiteSummary


def copies_in(folder: Path) -> list[tuple[str, Path]]:
    """(site, copy of a study) for each copy in a folder; the folder itself if it is one.

    Of several, the names of their folders are those of the sites, where they can be.
    """
    found = sorted(one.parent for one in folder.glob(f"*/{DEFINITION}"))
    if (folder / DEFINITION).is_file() or not found:
        return [("", folder)]
    return [(one.name if re.fullmatch(KEY, one.name) else "", one) for one in found]


def merge_copies(
    study: Study, copies: Sequence[tuple[str, Study]], progress: Progress = no_progress
) -> list[Merged]:
    """Add the sessions of several copies, each with its site; all are looked at first."""
    for site, other in copies:
        _refuse_other(study, other, site)
    made = []
    for number, (site, other) in enumerate(copies):
        report = part_of(progress, number, len(copies))
        made.append(merge_sessions(study, other, site, report))
    return made


def _refuse_other(study: Study, other: Study, site: str) -> None:
    """Refuse a copy of another study, of an altered one, and a site without a name."""
    if other.definition.id != study.definition.id:
        raise StudyError(
            "is the study {found}, not {expected}",
            where=str(other.folder),
            remedy="copy the study's folder to the other machine, then run it there",
            found=other.definition.id,
            expected=study.definition.id,
        )
    refuse_other_package(study, other)
    if site:
        site_content(site)


def merge_sessions(
    study: Study, other: Study, site: str = "", progress: Progress = no_progress
) -> Merged:
    """Copy the sessions of another copy of a study into this one.

    Existing sessions are not changed; different sessions of one code are a conflict, and
    so is one that is damaged, or ran something else than was packed; it stays where it is.

    Args:
        study: gets the sessions.
        other: has them.
        site: name of the place, which is kept with the sessions.
        progress: is told of each session; those before it raises are kept.
    """
    _refuse_other(study, other, site)
    storage.make_folder(study.folder / SESSIONS)
    storage.make_folder(study.folder / CONSENTS)
    added: list[StoredSession] = []
    same: list[str] = []
    conflicts: list[Message] = []
    with storage.locked(study.folder), ThreadPoolExecutor(_AT_ONCE) as pool:
        here = study.codes()
        taken, codes = set(here), other.codes()
        found = pool.map(lambda code: _taken_up(study, other, code, site, taken), codes)
        try:
            for number, (code, one) in enumerate(zip(codes, found, strict=True)):
                progress(number / len(codes), Message("copying the sessions"))
                if isinstance(one, StoredSession):
                    added.append(one)
                elif one:
                    conflicts.append(Message("{code}: {reason}", code=code, reason=one))
                else:
                    same.append(code)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return Merged(
        tuple(one.code for one in added),
        tuple(same),
        tuple(conflicts),
        tuple(_other_clips(study, here, added)),
        site_summary(site, added),
    )


def account_of(one: Merged, named: Callable[[str], str] = str) -> list[Message]:
    """What came of a copy: sessions, trials, devices, versions and latencies.

    Args:
        one: the copy.
        named: what a device is called.
    """
    of = one.site
    lines = [
        Message(
            "{added} sessions added, {same} were here already",
            added=len(one.added),
            same=len(one.same),
        )
    ]
    if of.sessions:
        lines.append(
            Message(
                "{complete} complete, {simulated} simulated; {invalid} of {trials} "
                "trials not valid",
                complete=of.complete,
                simulated=of.simulated,
                invalid=of.invalid,
                trials=of.trials,
            )
        )
    lines += [
        Message("{count} trials on {device}", count=count, device=named(name))
        for name, count in of.devices.items()
    ]
    lines += [
        Message("{count} sessions by {program}", count=count, program=name)
        for name, count in of.programs.items()
    ]
    video, sound = (Message("video"), of.video_ms), (Message("sound"), of.sound_ms)
    for what, latency in (video, sound):
        if latency is not None:
            lines.append(
                Message(
                    "force minus {what}: median {middle:+.1f} ms, worst trial "
                    "{worst:+.1f} ms",
                    what=what,
                    middle=latency[0],
                    worst=latency[1],
                )
            )
    return lines


def _taken_up(
    study: Study, other: Study, code: str, site: str, taken: Collection[str]
) -> StoredSession | Message:
    """A session that is copied, what is wrong with it, or "" if it is here already."""
    if code in taken:
        return _difference(study.session_folder(code), other.session_folder(code))
    try:
        return _copied(study, other, code, site)
    except StudyError as problem:
        return Message("cannot be read there ({problem})", problem=problem)


def _other_clips(
    study: Study, here: Sequence[str], added: Sequence[StoredSession]
) -> Iterator[Message]:
    """Yield which added sessions played other clips than the existing ones."""
    known: dict[str, set[str]] = {}
    for code in here if added else ():
        path = study.session_folder(code) / PLAN
        with suppress(StudyError):  # a damaged plan is told where sessions are listed
            for key, checksum in parse_plan_file(read_file(path), code).clips.items():
                known.setdefault(key, set()).add(checksum)
    for session in added:
        for key, checksum in session.plan.clips.items():
            if key in known and checksum not in known[key]:
                yield Message(
                    "{code}: played another sequence '{key}' than the sessions here",
                    code=session.code,
                    key=key,
                )


def _copied(study: Study, other: Study, code: str, site: str) -> StoredSession:
    """Copy a session that is sound; raise StudyError why it is left out."""
    folder = other.session_folder(code)
    consent = _consent(other, code)
    with storage.folder_written_aside(
        study.session_folder(code), storage.PRIVATE_FOLDER
    ) as aside:
        for path in sorted(folder.iterdir()):
            if path.is_file() and not path.is_symlink():
                _copy(path, aside / path.name)
        if site:
            storage.replace_file(aside / SITE, site_content(site), storage.PRIVATE_FILE)
        found = _refuse_damaged(aside, study, code)
        if consent:
            target = study.folder / CONSENTS / f"{code}.json"
            storage.replace_file(target, consent, storage.PRIVATE_FILE)
    return found


def _refuse_damaged(copied: Path, study: Study, code: str) -> StoredSession:
    """A copied session; StudyError if it holds more than this program wrote, or less."""
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
    refuse_altered(study, found)
    site_of(copied)  # is readable
    return found


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


def _difference(ours: Path, theirs: Path) -> Message:
    """How two sessions of one code differ; empty if they do not."""
    try:
        left, right = (read_file(f / ANSWERS, MAX_BYTES) for f in (ours, theirs))
    except StudyError as problem:
        return Message("cannot be compared ({problem})", problem=problem)
    return _different(left, right)


def _different(ours: bytes, theirs: bytes) -> Message:
    """How two journals of one code differ; empty if they do not."""
    left, right = decode(ours).intact, decode(theirs).intact
    shared = min(len(left), len(right))
    if left[:shared] != right[:shared]:
        return Message(
            "two sessions of one code ({here} here, {there} there)",
            here=sha256(ours)[:8],
            there=sha256(theirs)[:8],
        )
    if len(left) >= len(right):
        return Message("")  # the same, or an earlier copy of ours
    return Message(
        "is longer there ({count} more records); "
        "move the shorter one here out of the study and merge again",
        count=len(right) - shared,
    )
