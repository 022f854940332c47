"""Plain arrays as .npz files, which are never unpickled."""

import os
import struct
import zipfile
import zlib
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message, SequenceError
from hapticplayer.untrusted import open_regular

MAX_ARRAYS_BYTES = 2 << 30
_KINDS = "biufU"
"""Numbers, flags and names; of a complex number numpy would drop a part."""

_IMPORT_AGAIN = Message("import it again")
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


def write_arrays(path: Path, **arrays: Any) -> None:
    """Write arrays, and sync to disk."""
    with path.open("xb") as writer:
        np.savez(writer, allow_pickle=False, **arrays)
        writer.flush()
        os.fsync(writer.fileno())


def read_arrays(path: Path) -> dict[str, NDArray[Any]]:
    """The arrays of a file; raises SequenceError."""
    with open_regular(path, SequenceError, _IMPORT_AGAIN) as reader:
        return arrays_in(reader, str(path), MAX_ARRAYS_BYTES)


def arrays_in(
    reader: IO[bytes], where: str, most_bytes: int = MAX_ARRAYS_BYTES
) -> dict[str, NDArray[Any]]:
    """The arrays of a file that is open."""
    try:
        with zipfile.ZipFile(reader) as archive:
            total = sum(entry.file_size for entry in archive.infolist())
        if total > most_bytes:
            raise SequenceError("is too large", where=where)
        reader.seek(0)
        with np.load(reader, allow_pickle=False) as archive:
            found = {name: archive[name] for name in archive.files}
    except OSError as problem:
        what = Message("cannot be read ({reason})", reason=problem)
        raise SequenceError(what, where=where, remedy=_IMPORT_AGAIN) from problem
    except _DAMAGED as problem:
        what = Message("is damaged ({reason})", reason=problem)
        raise SequenceError(what, where=where, remedy=_IMPORT_AGAIN) from problem
    for name, array in found.items():
        if array.dtype.kind not in _KINDS:
            what = Message("{name} must hold real numbers", name=name)
            raise SequenceError(what, where=where, remedy=_IMPORT_AGAIN)
        owner: Any = array
        while isinstance(owner, np.ndarray):  # so that nobody has to copy it
            owner.setflags(write=False)
            owner = owner.base
    return found
