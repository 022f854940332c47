"""Files of participants: 0600 in folders 0700, whole or not at all, durable."""

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO, NoReturn

from hapticplayer.errors import StudyError

FOLDER_MODE, FILE_MODE = 0o700, 0o600
SCRATCH = ".part"


def make_folder(folder: Path) -> None:
    """Make a folder that only its owner can look into; one that exists stays."""
    try:
        folder.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    except OSError as problem:
        failed(problem, folder)


def write_new(path: Path, content: bytes) -> None:
    """Write a file that does not exist yet, durable; its folder is not synced."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW
    descriptor = os.open(path, flags, FILE_MODE)
    with os.fdopen(descriptor, "wb") as writer:
        os.fchmod(descriptor, FILE_MODE)  # whatever the umask
        writer.write(content)
        sync_file(writer)


def replace(path: Path, content: bytes) -> None:
    """Write a file in place of an older one: a reader sees the one or the other.

    Raises:
        StudyError: when it cannot be written; the older one is still there.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}{SCRATCH}")
    try:
        with suppress(FileNotFoundError):
            aside.unlink()
        write_new(aside, content)
        aside.replace(path)
        sync(path.parent)
    except OSError as problem:
        with suppress(OSError):
            aside.unlink()
        failed(problem, path)


@contextmanager
def folder_written_aside(target: Path) -> Iterator[Path]:
    """Yield a new folder, 0700, that becomes `target` when the block ends well.

    Raises:
        StudyError: when the target exists or cannot be written; nothing is left.
    """
    if os.path.lexists(target):
        raise StudyError(
            "already exists", where=str(target), remedy="choose another name"
        )
    scratch: Path | None = None
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        made = tempfile.mkdtemp(prefix=".", suffix=SCRATCH, dir=target.parent)
        scratch = Path(made)
        yield scratch
        sync(scratch)
        scratch.rename(target)
        sync(target.parent)
    except OSError as problem:
        failed(problem, target)
    finally:
        if scratch is not None and scratch.exists():
            shutil.rmtree(scratch, ignore_errors=True)


def remove_scratch(folder: Path) -> None:
    """Remove what a program that was killed left half-written in a folder."""
    for left in folder.glob(f".*{SCRATCH}"):
        if left.is_dir() and not left.is_symlink():
            shutil.rmtree(left, ignore_errors=True)
        else:
            with suppress(OSError):
                left.unlink()


def sync_file(writer: BinaryIO) -> None:
    """Make what was written durable."""
    writer.flush()
    os.fsync(writer.fileno())


def sync(folder: Path) -> None:
    """Make the entries of a folder durable."""
    descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def failed(problem: OSError, path: Path) -> NoReturn:
    """Raise StudyError for what the system refused."""
    raise StudyError(
        "cannot be written ({reason})",
        where=str(path),
        remedy="free some space, or choose a folder that you may write to",
        reason=problem,
    ) from problem
