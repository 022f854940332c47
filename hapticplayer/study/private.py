"""Writing participants' files: private (0600, folders 0700), atomic and synced."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO, NoReturn

from hapticplayer.errors import SequenceError, StudyError
from hapticplayer.sequence import files

FOLDER_MODE, FILE_MODE = 0o700, 0o600
SCRATCH = ".part"


def make_folder(folder: Path) -> None:
    """Make a folder that only its owner can read, unless it exists."""
    try:
        folder.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    except OSError as problem:
        raise_write_error(problem, folder)


def write_new(path: Path, content: bytes) -> None:
    """Write and sync a new file; its folder is not synced."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW
    descriptor = os.open(path, flags, FILE_MODE)
    with os.fdopen(descriptor, "wb") as writer:
        os.fchmod(descriptor, FILE_MODE)  # independent of the umask
        writer.write(content)
        sync_file(writer)


def replace(path: Path, content: bytes) -> None:
    """Replace a file atomically.

    Raises:
        StudyError: when it cannot be written; the old file is kept.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}{SCRATCH}")
    try:
        with suppress(FileNotFoundError):
            aside.unlink()
        write_new(aside, content)
        aside.replace(path)
        files.sync_folder(path.parent)
    except OSError as problem:
        with suppress(OSError):
            aside.unlink()
        raise_write_error(problem, path)


@contextmanager
def folder_written_aside(target: Path) -> Iterator[Path]:
    """Yield a new folder (0700) that becomes `target` if the block succeeds.

    Raises:
        StudyError: when the target exists or cannot be written.
    """
    try:
        with files.written_aside(target, FOLDER_MODE) as aside:
            yield aside
    except SequenceError as problem:
        raise StudyError(
            problem.what, where=problem.where, remedy=problem.remedy
        ) from problem


def sync_file(writer: BinaryIO) -> None:
    """Flush and sync a file."""
    writer.flush()
    os.fsync(writer.fileno())


def raise_write_error(problem: OSError, path: Path) -> NoReturn:
    """Raise StudyError for an OSError."""
    raise StudyError(
        "cannot be written ({reason})",
        where=str(path),
        remedy="free some space, or choose a folder with write permission",
        reason=problem,
    ) from problem
