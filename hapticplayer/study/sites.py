"""A study that several sites run: its signed package, and what each of them did.

A package is the folder of a study with its sequences and a manifest, which has the
SHA-256 of every file and of itself. A copy of the manifest stays with the study: sessions
that ran another definition, or played other clips, are not merged.
"""

import hashlib
import json
import statistics
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import msgspec
from msgspec import Meta

from hapticplayer import __version__, storage
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import (
    Message,
    Progress,
    StudyError,
    message_of,
    no_progress,
    part_of,
)
from hapticplayer.sequence.store import DESCRIPTION, copy_files
from hapticplayer.structures import SHA256, convert, decode
from hapticplayer.study.definition import JsonObject, Key, read_file, refuse
from hapticplayer.study.definition_reader import DEFINITION, to_be_worded
from hapticplayer.study.orders import ORDERS
from hapticplayer.study.sequence_folders import clip_checksums, sequence_folder
from hapticplayer.study.session_folder import SessionState, StoredSession, sha256
from hapticplayer.study.study_folder import Study

MANIFEST, PACKED, SITE = "manifest.json", "packed.json", "site.json"
"""Of a package, of the study that was packed, of a session."""
_SEQUENCES = "sequences"
_Sha256 = Annotated[str, Meta(pattern=SHA256)]
_PACK_AGAIN = Message("get the package again, or pack the study again")


class Manifest(JsonObject, frozen=True, kw_only=True):
    """What a package holds.

    Attributes:
        study: its id.
        definition_sha256: of its `study.json`.
        clips: SHA-256 of each sequence's description, as plans have it.
        files: SHA-256 of each file, by its path.
        packed_utc: ISO 8601.
        program: name and version.
    """

    study: Key
    definition_sha256: _Sha256
    clips: dict[Key, _Sha256]
    files: dict[str, _Sha256]
    packed_utc: str
    program: str


class SiteSession(JsonObject, frozen=True):
    """Where a session took place."""

    site: Key


class SiteSummary(NamedTuple):
    """What the sessions of a site show.

    Attributes:
        site: name; empty where none was given.
        sessions, complete, simulated: their numbers.
        trials, invalid: of these sessions.
        devices: number of trials by device.
        programs: number of sessions by version of the program.
        video_ms: median, and largest of the medians of trials, of force minus video.
        sound_ms: of force minus sound; None without any.
    """

    site: str
    sessions: int
    complete: int
    simulated: int
    trials: int
    invalid: int
    devices: Mapping[str, int]
    programs: Mapping[str, int]
    video_ms: tuple[float, float] | None
    sound_ms: tuple[float, float] | None


def pack_study(
    study: Study, target: Path, progress: Progress = no_progress
) -> Manifest:
    """Write a package into a new folder, and keep a copy of its manifest here."""
    for field in to_be_worded(study.definition):
        path = str(study.folder / DEFINITION)
        refuse(path, field, Message("is to be worded"), Message("enter the wording"))
    content: dict[str, Any] = json.loads(study.content)
    with storage.folder_written_aside(target) as aside:
        (aside / _SEQUENCES).mkdir()
        entries = content["sequences"]
        for number, entry in enumerate(entries):
            key, copied = entry["key"], part_of(progress, number, len(entries))
            folder = sequence_folder(study, key)
            entry["folder"] = f"{_SEQUENCES}/{key}"
            (aside / _SEQUENCES / key).mkdir()
            copy_files(folder, aside / _SEQUENCES / key, copied)
        definition = storage.json_text(content)
        (aside / DEFINITION).write_bytes(definition)
        if (study.folder / ORDERS).is_file():
            (aside / ORDERS).write_bytes(read_file(study.folder / ORDERS))
        made = _manifest(aside, study, sha256(definition))
        written = _signed(made)
        (aside / MANIFEST).write_bytes(written)
    storage.replace_file(study.folder / PACKED, written)
    return made


def _manifest(folder: Path, study: Study, definition_sha256: str) -> Manifest:
    files = {
        str(path.relative_to(folder)): storage.sha256_of(path)
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }
    return Manifest(
        study=study.definition.id,
        definition_sha256=definition_sha256,
        clips={
            one.key: files[f"{_SEQUENCES}/{one.key}/{DESCRIPTION}"]
            for one in study.definition.sequences
        },
        files=files,
        packed_utc=utc_now_iso(),
        program=f"hapticplayer {__version__}",
    )


def signature_of(made: Manifest) -> str:
    """The SHA-256 by which sites compare what they have."""
    text = json.dumps(msgspec.to_builtins(made), sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def _signed(made: Manifest) -> bytes:
    described = {**msgspec.to_builtins(made), "sha256": signature_of(made)}
    return storage.json_text(described)


def read_manifest(path: Path) -> Manifest | None:
    """The manifest in a file; None if there is none."""
    if not path.is_file():
        return None
    described = decode(read_file(path), dict[str, Any], str(path), StudyError)
    signed = described.pop("sha256", None)
    made = convert(described, Manifest, str(path), StudyError)
    if signed != signature_of(made):
        what = Message("is damaged or was altered (its checksum differs)")
        raise StudyError(what, where=str(path), remedy=_PACK_AGAIN)
    return made


def check_package(study: Study) -> None:
    """Refuse a package that was altered; clips are checked where they are opened."""
    manifest = read_manifest(study.folder / MANIFEST)
    if manifest is None:
        return
    orders = study.folder / ORDERS
    found = {DEFINITION: sha256(study.content)}
    found |= {ORDERS: sha256(read_file(orders))} if orders.is_file() else {}
    for key, checksum in clip_checksums(study).items():
        found[f"{_SEQUENCES}/{key}/{DESCRIPTION}"] = checksum
    listed = {name: one for name, one in manifest.files.items() if name in found}
    listed |= {ORDERS: manifest.files[ORDERS]} if ORDERS in manifest.files else {}
    for name in sorted(found.keys() | listed.keys()):
        if found.get(name) != listed.get(name):
            what = Message("was altered since the study was packed")
            raise StudyError(what, where=str(study.folder / name), remedy=_PACK_AGAIN)


def refuse_other_package(study: Study, other: Study) -> None:
    """Refuse a copy whose definition is neither this one nor the one that was packed."""
    packed = read_manifest(study.folder / PACKED)
    if packed is not None and sha256(other.content) not in _allowed(study, packed):
        what = Message("its definition was altered since the study was packed")
        where = str(other.folder / DEFINITION)
        raise StudyError(what, where=where, remedy=_PACK_AGAIN)


def refuse_altered(study: Study, session: StoredSession) -> None:
    """Refuse a session that ran another definition than was packed, or other clips."""
    packed = read_manifest(study.folder / PACKED)
    if packed is None:
        return
    if session.plan.definition_sha256 not in _allowed(study, packed):
        raise StudyError(
            "it ran a definition that was altered after the study was packed"
        )
    for key, checksum in session.plan.clips.items():
        if packed.clips.get(key) != checksum:
            raise StudyError(
                "it played another sequence {key!r} than was packed", key=key
            )


def _allowed(study: Study, packed: Manifest) -> set[str]:
    return {packed.definition_sha256, sha256(study.content)}


def site_of(session_folder: Path) -> str:
    """Where a session took place; empty if that was not said."""
    path = session_folder / SITE
    if not path.is_file():
        return ""
    return decode(read_file(path), SiteSession, str(path), StudyError).site


def known_site(session_folder: Path, notices: list[str]) -> str:
    """The same; empty where the file is damaged, which adds to the notices."""
    try:
        return site_of(session_folder)
    except StudyError as problem:
        notices.append(message_of(problem))
        return ""


def site_content(site: str) -> bytes:
    """The file that says where a session took place."""
    made = convert({"site": site}, SiteSession, "site", StudyError)
    return storage.json_text(msgspec.to_builtins(made))


def site_summary(site: str, sessions: Sequence[StoredSession]) -> SiteSummary:
    """What the sessions of a site show."""
    trials = [
        record.content
        for session in sessions
        for record in session.records.intact
        if record.kind == "trial"
    ]
    playbacks = [one.get("playback", {}) for one in trials]
    return SiteSummary(
        site,
        len(sessions),
        sum(one.state is SessionState.COMPLETE for one in sessions),
        sum(one.is_simulated for one in sessions),
        len(trials),
        sum(not one["is_valid"] for one in trials),
        Counter((one.get("outputs") or ["none"])[0] for one in playbacks),
        Counter(one.plan.program for one in sessions),
        _latency(playbacks, "force_minus_video_ms"),
        _latency(playbacks, "force_minus_sound_ms"),
    )


def _latency(
    playbacks: Sequence[Mapping[str, Any]], name: str
) -> tuple[float, float] | None:
    measured = [one.get(name) or {} for one in playbacks]
    medians = [one["p50"] for one in measured if "p50" in one]
    if not medians:
        return None
    return statistics.median(medians), max(medians, key=abs)
