"""Reads and writes the files of a sequence, atomically and checked."""

import atexit
import contextlib
import errno
import fcntl
import hashlib
import json
import os
import shutil
import struct
import tempfile
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message, SequenceError
from hapticplayer.outputs import FILE, FOLDER, IsOurs, refuse_existing
from hapticplayer.untrusted import (
    ESCAPED,
    HeldFile,
    open_regular,
    parse_json,
    read_regular,
)

MAX_JSON_BYTES = 4 << 20
MAX_ARRAYS_BYTES = 2 << 30
_CHUNK_BYTES = 1 << 20
_SCRATCH_BEGIN, _SCRATCH_END = ".hapticplayer-", ".part"
_DAMAGED = (
    ValueError,
    EOFError,
    KeyError,
    MemoryError,
    OverflowError,
    RuntimeError,  # encrypted, or packed in an unknown way
    struct.error,
    zlib.error,
    zipfile.BadZipFile,
)
"""Raised by numpy and zipfile for a damaged archive."""

_GIVE_SEQUENCE = Message("give the folder of a sequence")
_IMPORT_AGAIN = Message("import it again")


def no_progress(_fraction: float, _step: str) -> None:
    """Ignore the progress."""


def cache_home() -> Path:
    """Return the user's cache folder; it may not exist yet.

    Raises:
        RuntimeError: when the home folder is unknown.
    """
    home = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    return Path(home).expanduser() / "hapticplayer"


def config_home() -> Path:
    """Return the user's settings folder; it may not exist yet.

    Raises:
        RuntimeError: when the home folder is unknown.
    """
    home = os.environ.get("XDG_CONFIG_HOME") or "~/.config"
    return Path(home).expanduser() / "hapticplayer"


@contextmanager
def written_aside(target: Path, mode: int = 0o755) -> Iterator[Path]:
    """Yield a new folder that becomes `target`, with this mode, if the block succeeds.

    Otherwise nothing remains.

    Raises:
        SequenceError: when the target exists or its parent cannot be written.
    """
    target = Path.cwd() / target
    with scratch_beside(target) as aside:
        try:
            yield aside
            aside.chmod(mode)
            sync_folder(aside)
            target.parent.mkdir(parents=True, exist_ok=True)
            _rename_new(aside, target)
            sync_folder(target.parent)
        except OSError as problem:
            raise _writing_failed(problem, target) from problem


def _rename_new(aside: Path, target: Path) -> None:
    """Rename a folder, unless another process has made the target meanwhile."""
    try:
        if not os.path.lexists(target):
            aside.rename(target)
            return
    except OSError as problem:
        if problem.errno not in (errno.EEXIST, errno.ENOTEMPTY, errno.ENOTDIR):
            raise
    raise SequenceError(
        "was made by another process meanwhile",
        where=str(target),
        remedy="choose another folder",
    )


@contextmanager
def file_written_aside(target: Path, is_ours: IsOurs | None = None) -> Iterator[Path]:
    """Yield the path of a new file that becomes `target` if the block succeeds.

    Otherwise nothing remains; `is_ours` is that of `refuse_existing`.

    Raises:
        SequenceError: when the target exists or cannot be written.
    """
    target = Path.cwd() / target
    with scratch_beside(target, FILE, is_ours) as scratch:
        part = scratch / target.name
        try:
            yield part
            _sync(part)
            refuse_existing(target, FILE, is_ours, SequenceError)
            target.parent.mkdir(parents=True, exist_ok=True)
            part.replace(target)
            sync_folder(target.parent)
        except OSError as problem:
            raise _writing_failed(problem, target) from problem


@contextmanager
def scratch_beside(
    target: Path, kind: str = FOLDER, is_ours: IsOurs | None = None
) -> Iterator[Path]:
    """Yield a temporary folder on the file system of a target that does not exist yet.

    It is removed after the block, unless it was renamed; after a kill, by the next
    block in the same place.

    Raises:
        SequenceError: when the target exists or nothing can be written there.
    """
    target = Path.cwd() / target
    refuse_existing(target, kind, is_ours, SequenceError)
    home = next(parent for parent in target.parents if parent.exists())
    try:
        scratch, lock = _locked_scratch(home)
    except OSError as problem:
        raise SequenceError(
            "cannot be written ({reason})",
            where=str(home),
            remedy="choose a folder with write permission",
            reason=problem,
        ) from problem
    try:
        yield scratch
    finally:
        _remove_scratch(scratch, lock)


def _locked_scratch(home: Path) -> tuple[Path, int]:
    """Return a new folder, and the descriptor whose lock tells that it is in use."""
    _remove_abandoned(home)
    while True:
        scratch = Path(tempfile.mkdtemp(_SCRATCH_END, _SCRATCH_BEGIN, home))
        lock = os.open(scratch, os.O_RDONLY | os.O_DIRECTORY)
        with contextlib.suppress(OSError):  # some network file systems have no locks
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if scratch.exists():  # nobody took it for abandoned before it was locked
            return scratch, lock
        os.close(lock)


def _remove_scratch(scratch: Path, lock: int) -> None:
    if scratch.exists():
        shutil.rmtree(scratch, ignore_errors=True)
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


def _writing_failed(problem: OSError, target: Path) -> SequenceError:
    return SequenceError(
        "writing failed ({reason})",
        where=str(target),
        remedy="free some space or choose another folder",
        reason=problem,
    )


def sync_folder(folder: Path) -> None:
    """Sync the entries of a folder to disk."""
    _sync(folder)


def _sync(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def copy_file(source: HeldFile, target: Path, report: Callable[[float], None]) -> str:
    """Copy in blocks, reporting the done fraction, and sync to disk.

    Returns:
        SHA-256 of what was copied.

    Raises:
        InputError: when the source has changed.
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


def json_text(content: Any) -> bytes:
    """Return indented JSON without NaN for people to read."""
    text = json.dumps(content, indent=2, allow_nan=False, ensure_ascii=False)
    return f"{text}\n".encode(errors=ESCAPED)


def write_json(path: Path, content: dict[str, Any]) -> None:
    """Write JSON as `json_text` does, and sync to disk."""
    with path.open("xb") as writer:
        writer.write(json_text(content))
        writer.flush()
        os.fsync(writer.fileno())


def replace_json(path: Path, content: dict[str, Any]) -> None:
    """Replace a JSON file atomically.

    Raises:
        SequenceError: when it cannot be written; the old content remains.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        aside, lock = _locked_scratch(path.parent)
        try:
            write_json(aside / path.name, content)
            (aside / path.name).replace(path)
        finally:
            _remove_scratch(aside, lock)
        sync_folder(path.parent)
    except OSError as problem:
        raise _writing_failed(problem, path) from problem


def read_json(path: Path) -> dict[str, Any]:
    """Return the object in a JSON file.

    Raises:
        SequenceError: when it is missing, too large, not an object, or holds an entry
            twice or a number that is not finite.
    """
    text = read_regular(path, MAX_JSON_BYTES, SequenceError, _GIVE_SEQUENCE)
    content = parse_json(text, str(path), SequenceError, _IMPORT_AGAIN)
    if not isinstance(content, dict):
        raise SequenceError("is not a JSON object", where=str(path))
    return content


def write_arrays(path: Path, **arrays: Any) -> None:
    """Write plain arrays as an .npz, and sync to disk."""
    with path.open("xb") as writer:
        np.savez(writer, allow_pickle=False, **arrays)
        writer.flush()
        os.fsync(writer.fileno())


def read_arrays(path: Path) -> dict[str, NDArray[Any]]:
    """Return the arrays of an .npz; never unpickles.

    Raises:
        SequenceError: when it is missing, damaged or larger than the limit.
    """
    with open_regular(path, SequenceError, _IMPORT_AGAIN) as reader:
        return arrays_of(reader, str(path), MAX_ARRAYS_BYTES)


def arrays_of(
    reader: IO[bytes], where: str, most_bytes: int = MAX_ARRAYS_BYTES
) -> dict[str, NDArray[Any]]:
    """Return the arrays of an .npz that is open; never unpickles.

    Raises:
        SequenceError: when it is damaged or larger than the limit.
    """
    try:
        with zipfile.ZipFile(reader) as archive:
            total = sum(entry.file_size for entry in archive.infolist())
        if total > most_bytes:
            raise SequenceError("is too large", where=where)
        reader.seek(0)
        with np.load(reader, allow_pickle=False) as archive:
            return {name: archive[name] for name in archive.files}
    except OSError as problem:
        raise SequenceError(
            "cannot be read ({reason})",
            where=where,
            remedy="import it again",
            reason=problem,
        ) from problem
    except _DAMAGED as problem:
        raise SequenceError(
            "is damaged ({reason})",
            where=where,
            remedy="import it again",
            reason=problem,
        ) from problem


def sha256_of(path: Path, report: Callable[[float], None] = lambda _f: None) -> str:
    """Return the checksum of a file, reporting the done fraction."""
    digest, done = hashlib.sha256(), 0
    with open_regular(path, SequenceError, _IMPORT_AGAIN) as reader:
        total = max(1, os.fstat(reader.fileno()).st_size)
        while chunk := reader.read(_CHUNK_BYTES):
            digest.update(chunk)
            done += len(chunk)
            report(done / total)
    return digest.hexdigest()


def cache_root() -> Path:
    """Return the cache folder, created; a temporary one if it cannot be written."""
    root = cache_home()
    try:
        root.mkdir(parents=True, exist_ok=True)
    except OSError:
        root = Path(tempfile.mkdtemp(prefix="hapticplayer-"))
        atexit.register(shutil.rmtree, root, ignore_errors=True)
    return root
