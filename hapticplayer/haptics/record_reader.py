"""Reads records, which may be damaged, truncated, or still being written."""

import json
import os
import zlib
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message, joined
from hapticplayer.haptics.records import (
    CRC,
    FRAME,
    FRAME_BYTES,
    MAGIC,
    MARKER,
    MAX_FRAME_BYTES,
    MAX_FRAME_TICKS,
    MAX_HEADER_BYTES,
    MAX_NUMBER,
    PREFIX,
    VERSION,
    dtype_described,
)
from hapticplayer.untrusted import open_regular

_REMEDY = Message("use a record of the haptic loop (`hapticplayer play --record FILE`)")
MAX_WHOLE_BYTES = 4 << 30
"""More is not read into memory at once; `RecordReader` has no such limit."""

# What searching behind a damaged place may cost; beyond it the rest is given up.
_MAX_DAMAGED = 1000
MAX_SEARCH_BYTES = 256 << 20
_FALSE_HEAD_BYTES = 4096  # as much as looking at one costs
CHUNK_BYTES = 1 << 20


class Record(NamedTuple):
    """A record as a whole."""

    # structured array with the fields of the header's dtype; now TICK
    ticks: NDArray[Any]
    header: dict[str, Any]  # provenance, see docs/formats.md
    lost: int  # ticks of the loop that are missing, overrun or damaged
    is_complete: bool  # whether the recording came to its end and nothing is damaged
    notice: str  # one sentence about what is not as it should be, "" if all is well


class Frame(NamedTuple):
    """Ticks in a row; `first` is the number of the first since the loop began."""

    first: int
    ticks: NDArray[Any]


def read_record(path: Path) -> Record:
    """Read all ticks that are intact."""
    with RecordReader(path) as reader:
        if reader.size_bytes > MAX_WHOLE_BYTES:
            raise InputError(
                "is too large to be read at once",
                where=str(path),
                remedy="convert it with 'hapticplayer export'",
            )
        itemsize = reader.dtype.itemsize
        ticks = np.empty(reader.size_bytes // itemsize, dtype=reader.dtype)
        plain = ticks.view(np.dtype((np.void, itemsize)))  # copies much faster
        count = 0
        for frame in reader.frames():
            plain[count : count + len(frame.ticks)] = frame.ticks.view(plain.dtype)
            count += len(frame.ticks)
        return Record(
            ticks[:count],
            reader.header,
            reader.lost,
            reader.is_complete,
            reader.notice,
        )


class RecordReader:
    """Reads a record frame by frame, in little memory.

    A record that is still being written can be read too, as far as it is. `done` is the
    share that has been read; lost, is_complete and notice, as in `Record`, are known
    once all frames have been read.

    Raises:
        InputError: when it is not a record, or its header is damaged.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = open_regular(path, remedy=_REMEDY)
        try:
            self.size_bytes = os.fstat(self._file.fileno()).st_size
            self.header, self._at = self._read_header()
            self.dtype = self._read_dtype()
        except BaseException:
            self._file.close()
            raise
        self.lost = 0
        self.is_complete = False
        self._next = 0
        self._overrun = 0
        self._damaged = 0
        self._is_ended = False
        self._searched_bytes = 0

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _problem: BaseException | None,
        _where: TracebackType | None,
    ) -> None:
        self._file.close()

    @property
    def done(self) -> float:
        """Share of the file that has been read, 0 to 1."""
        return self._at / self.size_bytes

    @property
    def notice(self) -> str:
        """One sentence about what is wrong, "" for nothing."""
        notices = []
        if not self._is_ended:
            notices.append(
                Message(
                    "the recording has no end: it was truncated, "
                    "or is still being written"
                )
            )
        elif not self.is_complete and not self._damaged:
            notices.append(Message("there is data after the end of the recording"))
        if self._damaged:
            notices.append(
                Message(
                    "damaged places: {places}, with {ticks} ticks",
                    places=self._damaged,
                    ticks=self.lost - self._overrun,
                )
            )
        return joined("; ", notices) if notices else ""

    def frames(self) -> Iterator[Frame]:
        """Yield all intact frames in order; raises InputError when reading fails."""
        while not self._is_ended and self._at < self.size_bytes:
            frame = self._read_frame()
            if frame is None:
                if not self._find_frame():
                    return
                self._damaged += 1
            elif len(frame.ticks):
                yield frame

    def _read_frame(self) -> Frame | None:
        """Return the frame here and step over it, or None if there is none intact."""
        head = self._read(self._at, FRAME_BYTES)
        if not is_frame_head(head):
            return None
        _, count, first, lost, checksum = FRAME.unpack_from(head)
        missing = first - self._next
        size_bytes = count * self.dtype.itemsize
        end = self._at + FRAME_BYTES + size_bytes
        is_small = count <= MAX_FRAME_TICKS and size_bytes <= MAX_FRAME_BYTES
        is_in_order = first < MAX_NUMBER and lost <= missing
        if not (is_small and is_in_order) or end > self.size_bytes:
            return None
        payload = self._read(self._at + FRAME_BYTES, size_bytes)
        if len(payload) != size_bytes or zlib.crc32(payload) != checksum:
            self._searched_bytes += size_bytes
            return None
        self._at, self._next = end, first + count
        self.lost += missing
        self._overrun += lost
        if not count:
            self._is_ended = True
            self.is_complete = not self._damaged and end == self.size_bytes
        return Frame(first, np.frombuffer(payload, dtype=self.dtype))

    def _find_frame(self) -> bool:
        """Go to the next place that begins like a frame; False if there is none."""
        at = self._at + 1
        while self._damaged < _MAX_DAMAGED and self._searched_bytes < MAX_SEARCH_BYTES:
            chunk = self._read(at, CHUNK_BYTES)
            found = self._find_head(chunk)
            if found >= 0:
                self._at = at + found
                return True
            if len(chunk) < CHUNK_BYTES:
                return False
            at += len(chunk) - FRAME_BYTES + 1  # a head may span two chunks
        return False

    def _find_head(self, chunk: bytes) -> int:
        found = chunk.find(MARKER)
        last = len(chunk) - FRAME_BYTES
        while 0 <= found <= last and self._searched_bytes < MAX_SEARCH_BYTES:
            if is_frame_head(chunk[found : found + FRAME_BYTES]):
                self._searched_bytes += found
                return found
            self._searched_bytes += _FALSE_HEAD_BYTES
            found = chunk.find(MARKER, found + 1)
        self._searched_bytes += len(chunk)
        return -1

    def _read_header(self) -> tuple[dict[str, Any], int]:
        prefix = self._read(0, PREFIX.size)
        if not prefix:
            raise self._refusal(Message("is empty"))
        if not MAGIC.startswith(prefix[: len(MAGIC)]):
            raise self._refusal(Message("is not a recording of a haptic loop"))
        if len(prefix) < PREFIX.size:
            raise self._refusal(Message("is truncated in its header"))
        _, version, length = PREFIX.unpack(prefix)
        if version != VERSION:
            raise InputError(
                "has version {found} of the format, not {version}",
                where=str(self._path),
                remedy="use the version of hapticplayer that wrote it",
                found=version,
                version=VERSION,
            )
        if length > MAX_HEADER_BYTES:
            raise self._refusal(Message("is damaged in its header"))
        text = self._read(PREFIX.size, length)
        checksum = self._read(PREFIX.size + length, CRC.size)
        if len(checksum) < CRC.size:
            raise self._refusal(Message("is truncated in its header"))
        if CRC.unpack(checksum)[0] != zlib.crc32(prefix + text):
            raise self._refusal(Message("is damaged in its header"))
        return self._parse(text), PREFIX.size + length + CRC.size

    def _parse(self, text: bytes) -> dict[str, Any]:
        try:
            header = json.loads(text)
            # what cannot be written again (NaN, infinity, too deep) is rejected, too
            json.dumps([[[[header]]]], allow_nan=False)
        except (ValueError, RecursionError) as problem:
            raise self._refusal(Message("has an invalid header")) from problem
        if not isinstance(header, dict):
            raise self._refusal(Message("has an invalid header"))
        return header

    def _read_dtype(self) -> np.dtype[Any]:
        try:
            return dtype_described(self.header.get("dtype"))
        except ValueError as problem:
            raise self._refusal(
                Message("has an invalid header: {reason}", reason=problem)
            ) from None

    def _read(self, at: int, size_bytes: int) -> bytes:
        try:
            self._file.seek(at)
            return self._file.read(max(0, min(size_bytes, self.size_bytes - at)))
        except OSError as problem:
            raise self._refusal(
                Message("cannot be read ({reason})", reason=problem)
            ) from problem

    def _refusal(self, what: Message) -> InputError:
        return InputError(what, where=str(self._path), remedy=_REMEDY)


def is_frame_head(head: bytes) -> bool:
    """Return whether a frame could begin with these bytes."""
    return (
        len(head) == FRAME_BYTES
        and head.startswith(MARKER)
        and CRC.unpack_from(head, FRAME.size)[0] == zlib.crc32(head[: FRAME.size])
    )
