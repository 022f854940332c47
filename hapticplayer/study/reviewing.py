"""Which text answers a person has approved for export."""

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

from msgspec import Meta

from hapticplayer import storage
from hapticplayer.errors import StudyError
from hapticplayer.structures import SHA256, read_json

REVIEWED = "reviewed.json"
_Digest = Annotated[str, Meta(pattern=SHA256)]


def text_digest(code: str, name: str, text: str) -> str:
    """Return the digest of a text answer; a changed text has to be reviewed again."""
    return hashlib.sha256(f"{code}\n{name}\n{text}".encode()).hexdigest()


def read_reviewed(session_folder: Path) -> set[str]:
    """Return the digests of the approved texts; none if the file is damaged."""
    path = session_folder / REVIEWED
    if not path.exists():
        return set()
    try:
        return read_json(path, dict[str, set[_Digest]], StudyError)["passed"]
    except (StudyError, KeyError):
        return set()  # the safe side: they have to be reviewed again


def save_reviewed(session_folder: Path, digests: Iterable[str]) -> None:
    """Store that a person has approved these texts."""
    with storage.locked(session_folder):
        passed = sorted(read_reviewed(session_folder) | set(digests))
        content = storage.json_text({"passed": passed})
        storage.replace_file(session_folder / REVIEWED, content, storage.PRIVATE_FILE)
