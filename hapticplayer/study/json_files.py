"""Reads the JSON files of a study, which people edit."""

from pathlib import Path
from typing import Any, NoReturn

from hapticplayer.errors import Message, StudyError
from hapticplayer.untrusted import parse_json, read_regular

MAX_BYTES = 4 << 20
GIVE_STUDY = Message("give the folder of a study")
_CORRECT = Message("correct it")


def read_file(path: Path, max_bytes: int = MAX_BYTES) -> bytes:
    """Return the content of a small file.

    Raises:
        StudyError: when it cannot be read.
    """
    return read_regular(path, max_bytes, StudyError, GIVE_STUDY)


def parse(content: bytes, path: str) -> Any:
    """Parse a JSON text; `path` is for messages.

    Raises:
        StudyError: when it is not valid JSON or an object has a duplicate entry.
    """
    if len(content) > MAX_BYTES:
        raise StudyError("is too large", where=path)
    return parse_json(content, path, StudyError, Message("correct that line"))


def refuse(
    path: str, field: str, what: Message, remedy: Message = _CORRECT
) -> NoReturn:
    """Raise StudyError for a place in a file, such as `sequences[2].key`."""
    raise StudyError(what, where=f"{path}, {field}" if field else path, remedy=remedy)
