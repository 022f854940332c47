"""Deletes what is kept of a participant; an interrupted deletion is finished later."""

import json
import os
import secrets
import shutil
from pathlib import Path

from hapticplayer import storage
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import StudyError
from hapticplayer.study.session_folder import LEAVING
from hapticplayer.untrusted import open_regular


def mark(session: Path, consent: Path, deleted: Path) -> None:
    """Remove the consent, and give the session a name without the code."""
    storage.make_folder(deleted)
    try:
        consent.unlink(missing_ok=True)
        if session.exists():
            leaving = session.with_name(f"{LEAVING}{secrets.token_hex(8)}")
            session.rename(leaving)
        for changed in (consent.parent, session.parent):
            if changed.is_dir():
                storage.sync_folder(changed)
    except OSError as problem:
        raise storage.StorageError.of(problem, session) from problem


def finish(sessions: Path, deleted: Path) -> None:
    """Remove and count sessions that are marked for deletion; a full disk has room then."""
    for leaving in sessions.glob(f"{LEAVING}*"):
        name = leaving.name.removeprefix(LEAVING)
        stone = {"deleted_utc": utc_now_iso()}
        try:
            for path in list(leaving.iterdir()):
                is_folder = path.is_dir() and not path.is_symlink()
                shutil.rmtree(path) if is_folder else path.unlink()
            storage.make_folder(deleted)
            storage.replace_file(
                deleted / f"{name}.json",
                json.dumps(stone).encode(),
                storage.PRIVATE_FILE,
            )
            leaving.rmdir()
            storage.sync_folder(sessions)
        except OSError as problem:
            raise storage.StorageError.of(problem, leaving) from problem


def files_with(folder: Path, code: bytes) -> list[str]:
    """Files below a folder that have a code in their name or content."""
    found = []
    for path in sorted(folder.rglob("*")):
        if path.is_symlink() or not path.is_file():
            continue
        if code in os.fsencode(path.name) or _contains(path, code):
            found.append(str(path.relative_to(folder)))
    return found


def _contains(path: Path, code: bytes) -> bool:
    kept = b""
    with open_regular(path, StudyError) as reader:
        while chunk := reader.read(1 << 20):
            if code in kept + chunk:
                return True
            kept = chunk[-len(code) :]
    return False
