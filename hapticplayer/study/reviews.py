"""Answers in words may name someone: a person reads them before they are exported."""

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path

from hapticplayer.errors import StudyError
from hapticplayer.study import private
from hapticplayer.study.tree import parse, read_file

REVIEWED = "reviewed.json"


def text_digest(code: str, name: str, text: str) -> str:
    """Return what stands for one text: another text has to be read anew."""
    return hashlib.sha256(f"{code}\n{name}\n{text}".encode()).hexdigest()


def read_reviewed(session_folder: Path) -> set[str]:
    """Return the digests of the texts that were let pass; none where it is damaged."""
    path = session_folder / REVIEWED
    if not path.exists():
        return set()
    try:
        return parse(
            read_file(path),
            str(path),
            lambda root: {entry.text() for entry in root.each("passed")},
        )
    except StudyError:
        return set()  # the safe side: they are read once more


def keep_reviewed(session_folder: Path, digests: Iterable[str]) -> None:
    """Remember that a person let these texts pass.

    Raises:
        StudyError: when it cannot be written.
    """
    passed = sorted(read_reviewed(session_folder) | set(digests))
    content = json.dumps({"passed": passed}, indent=1) + "\n"
    private.replace(session_folder / REVIEWED, content.encode())
