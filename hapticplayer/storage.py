"""Files and folders that the program writes: whole or not at all.

Each is written aside, synced and renamed; nothing that exists is overwritten unless its
writer says how it knows its own files.
"""

import atexit
import contextlib
import errno
import fcntl
import hashlib
import json
import os
import shutil
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import InputError, Message, message_of
from hapticplayer.untrusted import ESCAPED, HeldFile, open_regular

FOLDER, FILE = Message("folder"), Message("file")
PRIVATE_FOLDER, PRIVATE_FILE = 0o700, 0o600
"""Modes of what only its owner may read."""

_HEAD_BYTES, _CHUNK_BYTES = 1 << 16, 1 << 20
_SCRATCH_BEGIN, _SCRATCH_END = ".hapticplayer-", ".part"
_OVERWRITE = Message("choose another file, or replace it (--overwrite)")
_LOCK_WAIT_S, _LOCK_POLL_S = 5.0, 0.02
_held = threading.local()

IsOurs = Callable[[bytes], bool]
"""Whether a file begins as what is to be written there does."""


class StorageError(InputError):
    """A file or folder cannot be written; what was there is unchanged."""

    @classmethod
    def of(cls, problem: OSError, path: Path) -> "StorageError":
        """The error for a failed call; what was written aside has been removed."""
        if problem.errno not in _FULL:
            return cls(
                "cannot be written ({reason})",
                where=str(path),
                remedy=_REMEDIES.get(problem.errno or 0, _ANOTHER_FOLDER),
                reason=write_problem(problem, path),
            )
        return cls(
            "cannot be written ({reason}); what was there before is unchanged, and "
            "what had been written was removed",
            where=str(path),
            remedy="free some space there, or choose a folder on another disk",
            reason=write_problem(problem, path),
        )


_ANOTHER_FOLDER = Message("choose a folder with write permission")
_NO_FOLDER = Message("choose a folder; a part of this path is a file or a dead link")
_REMEDIES = {
    errno.ENAMETOOLONG: Message("choose a shorter name"),
    errno.ENOTDIR: _NO_FOLDER,
    errno.EEXIST: _NO_FOLDER,
}

_FULL = {
    errno.ENOSPC: Message("the disk at {disk} is full"),
    errno.EDQUOT: Message("your quota of the disk at {disk} is used up"),
    errno.EFBIG: Message("larger than a file on the disk at {disk} may be (ulimit -f)"),
}


def write_problem(problem: OSError, path: Path) -> Message:
    """Why a file cannot be written, with the place of its disk where that is full."""
    sentence = _FULL.get(problem.errno or 0)
    if sentence is None:
        return message_of(problem)
    disk = disk_of(path)
    return Message(sentence, disk=disk)


def raise_if_full(problem: BaseException, path: Path) -> None:
    """Raise StorageError for what a full disk has done, whatever reports it."""
    if isinstance(problem, OSError) and problem.errno in _FULL:
        with _named(path):
            raise problem


def disk_of(path: Path) -> Path:
    """Where the disk is mounted on which a path is, or would be."""
    place = next(one for one in (path, *path.absolute().parents) if one.exists())
    return next(
        one for one in (place.resolve(), *place.resolve().parents) if one.is_mount()
    )


def cache_home() -> Path:
    """The user's cache folder, which may not exist; RuntimeError without a home."""
    return _home("XDG_CACHE_HOME", ".cache")


def config_home() -> Path:
    """The user's settings folder, which may not exist; RuntimeError without a home."""
    return _home("XDG_CONFIG_HOME", ".config")


def data_home() -> Path:
    """The user's data folder, which may not exist; RuntimeError without a home."""
    return _home("XDG_DATA_HOME", ".local/share")


def cache_root() -> Path:
    """The cache folder, created; a temporary one if it cannot be written."""
    try:
        root = cache_home()
        root.mkdir(parents=True, exist_ok=True)
    except (OSError, RuntimeError):
        root = Path(tempfile.mkdtemp(prefix="hapticplayer-"))
        atexit.register(shutil.rmtree, root, ignore_errors=True)
    return root


def _home(variable: str, usual: str) -> Path:
    chosen = Path(os.environ.get(variable, ""))
    # the XDG standard ignores paths that are not absolute
    return (chosen if chosen.is_absolute() else Path.home() / usual) / "hapticplayer"


def refuse_existing(
    target: Path, kind: str = FILE, is_ours: IsOurs | None = None
) -> None:
    """Raise InputError for a target that exists.

    Args:
        target: of the result.
        kind: FILE or FOLDER.
        is_ours: recognises a file that may be overwritten; None overwrites nothing.
    """
    if not os.path.lexists(target):
        return
    other = Message("choose another {kind}", kind=kind)
    if is_ours is None:
        remedy = _OVERWRITE if kind == FILE else other
        raise InputError(Message("already exists"), where=str(target), remedy=remedy)
    with open_regular(target, InputError, other) as reader:
        head = reader.read(_HEAD_BYTES)
    if not is_ours(head):
        raise InputError(
            Message(
                "is not overwritten, because it is not such a file written by hapticplayer"
            ),
            where=str(target),
            remedy=other,
        )


def make_way(target: Path, is_ours: IsOurs | None = None) -> None:
    """Remove the file that is overwritten; raises InputError as `refuse_existing`."""
    refuse_existing(target, FILE, is_ours)
    with _named(target):
        target.unlink(missing_ok=True)


def make_folder(folder: Path, mode: int = PRIVATE_FOLDER) -> None:
    """Make a folder unless it exists; raises StorageError."""
    with _named(folder):
        folder.mkdir(mode=mode, parents=True, exist_ok=True)


@contextmanager
def folder_written_aside(target: Path, mode: int = 0o755) -> Iterator[Path]:
    """Yield a new folder that becomes `target`, with this mode, if the block succeeds.

    Otherwise nothing remains.
    """
    target = Path.cwd() / target
    refuse_existing(target, FOLDER)
    with _named(target), scratch_beside(target) as aside:
        yield aside
        aside.chmod(mode)
        sync_folder(aside)
        target.parent.mkdir(parents=True, exist_ok=True)
        _rename_new(aside, target)
        sync_folder(target.parent)


def _rename_new(aside: Path, target: Path) -> None:
    """Rename a folder, unless another process has made the target meanwhile."""
    try:
        if not os.path.lexists(target):
            aside.rename(target)
            return
    except OSError as problem:
        if problem.errno not in (errno.EEXIST, errno.ENOTEMPTY, errno.ENOTDIR):
            raise
    raise StorageError(
        "was made by another process meanwhile",
        where=str(target),
        remedy="choose another folder",
    )


@contextmanager
def file_written_aside(
    target: Path, is_ours: IsOurs | None = None, mode: int | None = None
) -> Iterator[Path]:
    """Yield the path of a new file that becomes `target` if the block succeeds.

    Otherwise nothing remains. For `is_ours` see `refuse_existing`.

    Raises:
        InputError: when the target exists or cannot be written.
    """
    refuse_existing(target, FILE, is_ours)
    with file_replaced(target, mode) as part:
        yield part
        refuse_existing(target, FILE, is_ours)


@contextmanager
def file_replaced(target: Path, mode: int | None = None) -> Iterator[Path]:
    """Yield the path of a new file that replaces `target` if the block succeeds.

    Raises:
        StorageError: when it cannot be written; what was there remains.
    """
    target = Path.cwd() / target
    with _named(target), scratch_beside(target) as scratch:
        part = scratch / target.name
        yield part
        if mode is not None:
            part.chmod(mode)
        sync_folder(part)
        target.parent.mkdir(parents=True, exist_ok=True)
        part.replace(target)
        sync_folder(target.parent)


def replace_file(path: Path, content: bytes, mode: int | None = None) -> None:
    """Replace a file, or write a new one; raises StorageError."""
    with file_replaced(path, mode) as part:
        part.write_bytes(content)


@contextmanager
def private_writer(path: Path) -> Iterator[BinaryIO]:
    """Write a new file that only its owner may read, then sync it; raises StorageError."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW
    with _named(path), os.fdopen(os.open(path, flags, PRIVATE_FILE), "wb") as writer:
        os.fchmod(writer.fileno(), PRIVATE_FILE)  # independent of the umask
        yield writer
        writer.flush()
        os.fsync(writer.fileno())


def write_private(path: Path, content: bytes) -> None:
    """Write and sync a new file that only its owner may read; raises StorageError."""
    with private_writer(path) as writer:
        writer.write(content)


@contextmanager
def scratch_beside(target: Path) -> Iterator[Path]:
    """Yield a temporary folder on the file system of a target.

    It is removed after the block, unless it was renamed; after a kill, by the next
    block in the same place. Raises StorageError when nothing can be written there.
    """
    target = Path.cwd() / target
    home = next(parent for parent in target.parents if parent.exists())
    with _named(home):
        scratch, lock = _locked_scratch(home)
    try:
        with _holding(lock):
            yield scratch
    finally:
        if scratch.exists():
            shutil.rmtree(scratch, ignore_errors=True)
        os.close(lock)


def _locked_scratch(home: Path) -> tuple[Path, int]:
    """A new folder, and the descriptor whose lock tells that it is in use."""
    _remove_abandoned(home)
    while True:
        scratch = Path(tempfile.mkdtemp(_SCRATCH_END, _SCRATCH_BEGIN, home))
        # somebody may take it for abandoned before it is locked
        with contextlib.suppress(FileNotFoundError):
            lock = os.open(scratch, os.O_RDONLY | os.O_DIRECTORY)
            if _try_lock(lock) and scratch.exists():
                return scratch, lock
            os.close(lock)


def _remove_abandoned(home: Path) -> None:
    """Remove the scratch folders of programs that were killed: nobody locks them."""
    for scratch in home.glob(f"{_SCRATCH_BEGIN}*{_SCRATCH_END}"):
        with contextlib.suppress(OSError):
            lock = os.open(scratch, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(scratch, ignore_errors=True)
            finally:
                os.close(lock)


def _try_lock(descriptor: int) -> bool:
    """Whether no other program holds the lock."""
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as problem:  # some network file systems have no locks
        return problem.errno not in (errno.EWOULDBLOCK, errno.EACCES)
    return True


@contextmanager
def locked(folder: Path, clock: Clock | None = None) -> Iterator[None]:
    """Change a folder while no other program or thread does.

    The lock ends with the process that holds it, even if that is killed; a thread that
    has it may take it again.

    Raises:
        StorageError: when others hold the lock for 5 s in which nothing is written.
    """
    with _named(folder):
        lock = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        if _identity(lock) in _folders_held():
            yield
        else:
            _wait_for(lock, folder, clock or SystemClock())
            with _holding(lock):
                yield
    finally:
        os.close(lock)


def lock_folder(folder: Path) -> int | None:
    """A descriptor that locks a folder until it is closed; None while another has it."""
    lock = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    if _try_lock(lock):
        return lock
    os.close(lock)
    return None


@contextmanager
def _holding(lock: int) -> Iterator[None]:
    """Note that this thread has a lock."""
    name = _identity(lock)
    _folders_held().add(name)
    try:
        yield
    finally:
        _folders_held().discard(name)


def _folders_held() -> set[tuple[int, int]]:
    held: set[tuple[int, int]] = _held.__dict__.setdefault("folders", set())
    return held


def _identity(descriptor: int) -> tuple[int, int]:
    status = os.fstat(descriptor)
    return status.st_dev, status.st_ino


def _wait_for(lock: int, folder: Path, clock: Clock) -> None:
    seen, until_s = 0, 0.0
    while not _try_lock(lock):
        changed, now_s = os.fstat(lock).st_mtime_ns, clock.now_s()
        if changed != seen:
            seen, until_s = changed, now_s + _LOCK_WAIT_S
        elif now_s > until_s:
            raise StorageError(
                "is being changed by another program",
                where=str(folder),
                remedy="wait until that has finished, or close it, then try again",
            )
        clock.sleep_until(now_s + _LOCK_POLL_S)


@contextmanager
def _named(path: Path) -> Iterator[None]:
    """Raise StorageError for a call that failed."""
    try:
        yield
    except OSError as problem:
        if any(part.startswith(_SCRATCH_BEGIN) for part in path.parts):
            raise  # the one who made the temporary folder knows what it is to become
        raise StorageError.of(problem, path) from problem


def sync_folder(path: Path) -> None:
    """Sync the entries of a folder, or the content of a file, to disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def copy_file(source: HeldFile, target: Path, report: Callable[[float], None]) -> str:
    """Copy in blocks, reporting the done fraction, and sync to disk.

    Returns:
        SHA-256 of what was copied.
    """
    digest, done = hashlib.sha256(), 0
    with target.open("xb") as writer:
        while chunk := source.reader.read(_CHUNK_BYTES):
            writer.write(chunk)
            digest.update(chunk)
            done += len(chunk)
            report(min(1.0, done / max(1, source.size_bytes)))
        writer.flush()
        os.fsync(writer.fileno())
    source.refuse_changed()
    return digest.hexdigest()


def sha256_of(path: Path, report: Callable[[float], None] = lambda _f: None) -> str:
    """The checksum of a file, reporting the done fraction."""
    digest, done = hashlib.sha256(), 0
    with open_regular(path) as reader:
        total = max(1, os.fstat(reader.fileno()).st_size)
        while chunk := reader.read(_CHUNK_BYTES):
            digest.update(chunk)
            done += len(chunk)
            report(done / total)
    return digest.hexdigest()


def json_text(content: Any, errors: str = ESCAPED) -> bytes:
    """Indented JSON without NaN for people to read."""
    text = json.dumps(content, indent=2, allow_nan=False, ensure_ascii=False)
    return f"{text}\n".encode(errors=errors)


def write_json(path: Path, content: dict[str, Any]) -> None:
    """Write new JSON as `json_text` does, and sync to disk."""
    with path.open("xb") as writer:
        writer.write(json_text(content))
        writer.flush()
        os.fsync(writer.fileno())


def replace_json(path: Path, content: dict[str, Any]) -> None:
    """Replace a JSON file; raises StorageError."""
    replace_file(path, json_text(content))
