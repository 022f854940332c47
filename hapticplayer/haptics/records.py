"""Records of every tick on disk: the layout, and writing it.

A header that describes itself (JSON), then frames of some ticks each, then a frame
without ticks as the end. Each part has a checksum, so that what a crash or a loss of
power tore is recognised and everything else is read. Little-endian; docs/formats.md.
"""

import contextlib
import errno
import json
import os
import re
import struct
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer import __version__
from hapticplayer.clock import SystemClock, utc_now_iso
from hapticplayer.errors import InputError, Message
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.shared import RING_TICKS, TICK
from hapticplayer.linux import taken_away
from hapticplayer.untrusted import ANOTHER

MAGIC = b"\x89HPREC\r\n"  # no text survives its first and last bytes
VERSION = 1
MARKER = b"\xf5HPF"
MAX_HEADER_BYTES = 1 << 16
MAX_FRAME_TICKS = RING_TICKS
MAX_FRAME_BYTES = 16 << 20  # of ticks, whatever fields they may have in a record

PREFIX = struct.Struct("<8sII")  # magic, version, bytes of JSON; then JSON and CRC
FRAME = struct.Struct("<4sIQQI")  # marker, ticks, first, lost before, CRC of ticks
CRC = struct.Struct("<I")
FRAME_BYTES = FRAME.size + CRC.size
MAX_NUMBER = 1 << 53
_MAX_FIELDS, _MAX_ITEMS = 64, 16
_TYPES = {f"<{kind}" for kind in ("f4", "f8", "u2", "u4", "u8", "i2", "i4", "i8")}
_TYPES |= {"|u1", "|i1"}
_NAME = re.compile(r"[a-z][a-z0-9_]{0,31}")


def encode_header(provenance: Mapping[str, Any]) -> bytes:
    """Return the beginning of a record of TICK."""
    content = {**provenance, "dtype": TICK.descr}
    text = json.dumps(content, allow_nan=False).encode()
    if len(text) > MAX_HEADER_BYTES:
        raise ValueError("the header of the record is too long")
    head = PREFIX.pack(MAGIC, VERSION, len(text)) + text
    return head + CRC.pack(zlib.crc32(head))


def encode_frame(first: int, lost: int, ticks: NDArray[Any]) -> bytes:
    """Return a frame of at most MAX_FRAME_TICKS; one without ticks ends the record.

    `first` counts since the loop began; `lost` ticks are missing right before it.
    """
    payload = ticks.tobytes()
    head = FRAME.pack(MARKER, len(ticks), first, lost, zlib.crc32(payload))
    return head + CRC.pack(zlib.crc32(head)) + payload


def is_record(head: bytes) -> bool:
    """Whether a file begins as a record does."""
    return head.startswith(MAGIC)


def open_record(path: Path) -> int:
    """Create the file of a record and return its descriptor, owned by the caller."""
    flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_APPEND | os.O_CLOEXEC
    try:
        return os.open(path, flags, 0o666)
    except FileExistsError as problem:
        raise InputError("already exists", where=str(path), remedy=ANOTHER) from problem
    except (OSError, ValueError) as problem:
        raise InputError(
            "the record cannot be written ({reason})",
            reason=problem,
            where=str(path),
            remedy=ANOTHER,
        ) from problem


class RecordWriter:
    """Appends to a record; a part that could not be written whole is taken back.

    Every method raises OSError when the file cannot be written.
    """

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        self._end = os.lseek(descriptor, 0, os.SEEK_END)

    def begin(self, header: Mapping[str, Any]) -> None:
        """Write the header: what is always there, and what the caller knows."""
        provenance = {
            "program": f"hapticplayer {__version__}",
            "started_utc": utc_now_iso(),
            "started_monotonic_s": SystemClock.now_s(),
            "time": "seconds of CLOCK_MONOTONIC",
            "without": taken_away(),
            "axes": "x right, y up, z towards the user",
            "modes": {str(mode.value): mode.name.lower() for mode in Mode},
            "causes": {str(cause.value): cause.name.lower() for cause in Cause},
        }
        self._write(encode_header({**provenance, **header}))

    def append(self, first: int, lost: int, ticks: NDArray[Any]) -> None:
        """Write ticks in a row; see `encode_frame`. None at all is the end."""
        self._write(encode_frame(first, lost, ticks))

    def sync(self) -> None:
        """Make durable what has been written."""
        os.fdatasync(self._descriptor)
        if os.fstat(self._descriptor).st_nlink == 0:
            raise FileNotFoundError(errno.ENOENT, Message("the file was removed"))

    def _write(self, data: bytes) -> None:
        left = memoryview(data)
        try:
            while left:
                left = left[os.write(self._descriptor, left) :]
        except OSError:
            with contextlib.suppress(OSError):  # the torn part is recognised anyway
                os.ftruncate(self._descriptor, self._end)
            raise
        self._end += len(data)


def dtype_described(described: object) -> np.dtype[Any]:
    """Return the dtype that a header describes, plain little-endian numbers only."""
    if not isinstance(described, list) or not 0 < len(described) <= _MAX_FIELDS:
        raise ValueError("the fields of a tick are not listed")
    fields = [_field(entry) for entry in described]
    if len({name for name, *_ in fields}) < len(fields):
        raise ValueError("a field appears twice")
    return np.dtype(fields)


def _field(entry: object) -> tuple[str, str, tuple[int, ...]]:
    match entry:
        case [str(name), str(kind)]:
            shape: tuple[int, ...] = ()
        case [str(name), str(kind), [int(items)]] if 0 < items <= _MAX_ITEMS:
            shape = (int(items),)
        case _:
            raise ValueError("a field is described in an unknown way")
    if not _NAME.fullmatch(name) or kind not in _TYPES:
        raise ValueError("a field has an unknown type or an unusual name")
    return name, kind, shape
