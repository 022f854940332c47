r"""The journal of a session: lines of JSON, synced before the session continues.

A line is `{"record":7,"v":1,"utc":...,"mono_s":...,"kind":...,...,"crc":"89abcdef"}`:
the CRC-32 covers the bytes before `,"crc"`. Quotation marks inside texts are escaped, so
`{"record":` and `,"crc":"` occur elsewhere only as the name of an answer.
"""

import errno
import fcntl
import itertools
import json
import os
import re
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from msgspec import Meta, Struct

from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import InputError, Message, StudyError
from hapticplayer.storage import StorageError, write_problem
from hapticplayer.structures import convert
from hapticplayer.structures import decode as decode_json
from hapticplayer.study.definition import read_file

VERSION = 1
MAX_BYTES, MAX_RECORD_BYTES = 64 << 20, 1 << 20
_HEAD = b'{"record":'
_MAX_TRIES = 16
_TAIL = re.compile(rb',"crc":"([0-9a-f]{8})"\}')
_WAS_WHOLE = re.compile(rb',"crc":"|"[0-9a-f]{8}"\}')


_Whole = Annotated[int, Meta(ge=0, le=10**9)]


class _Head(Struct):
    record: _Whole
    v: _Whole
    utc: str
    mono_s: Annotated[float, Meta(ge=0.0, le=1e9)]
    kind: str


_NAMES = _Head.__struct_fields__


@dataclass(frozen=True, slots=True)
class JournalRecord:
    """One intact record.

    Attributes:
        number: counted from 1.
        utc: ISO 8601.
        monotonic_s: of the machine's clock.
        kind: of the event.
        content: other members.
    """

    number: int
    utc: str
    monotonic_s: float
    kind: str
    content: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Records:
    """The records of a journal.

    Attributes:
        intact: in the order of the file.
        damaged: one sentence for each damaged range of bytes.
        torn: how many of these an interrupted write left, so that nothing is lost.
        size_bytes: of what was read.
        is_torn: whether the last line is incomplete.
        newest_version: of the records; 0 without records.
    """

    intact: tuple[JournalRecord, ...]
    damaged: tuple[str, ...]
    torn: int
    size_bytes: int
    is_torn: bool
    newest_version: int

    @property
    def next_number(self) -> int:
        last = max((record.number for record in self.intact), default=0)
        return last + len(self.damaged) + 1


def encode(
    number: int, utc: str, monotonic_s: float, kind: str, content: Mapping[str, Any]
) -> bytes:
    """Return one record as a line.

    Raises:
        ValueError: for NaN, or a reserved name.
    """
    head = {
        "record": number,
        "v": VERSION,
        "utc": utc,
        "mono_s": round(monotonic_s, 6),
        "kind": kind,
    }
    if taken := (head.keys() | {"crc"}) & content.keys():
        raise ValueError(f"{sorted(taken)} are reserved names")
    text = json.dumps(
        {**head, **content},
        ensure_ascii=False,
        allow_nan=False,
        separators=(",", ":"),
    )
    body = text.encode("utf-8", errors="replace")[:-1]  # half a character: "?"
    return body + b',"crc":"%08x"}\n' % zlib.crc32(body)


def decode(data: bytes) -> Records:
    """Find all intact records and describe what is damaged, in linear time.

    A record is accepted only if its checksum is right. It lies within a line, but where a
    line break is damaged a line holds two; so a few beginnings are tried in each.
    """
    intact: list[JournalRecord] = []
    gaps = _Gaps(data, intact)
    newest = begin = 0
    while begin < len(data):
        end = data.find(b"\n", begin) + 1 or len(data)
        for at, record, version, after in _records_in(data, begin, end):
            gaps.close(at, after)
            intact.append(record)
            newest = max(newest, version)
        begin = end
    gaps.close(len(data), len(data))
    is_torn = bool(data) and not data.endswith(b"\n")
    damaged = tuple(gaps.damaged)
    return Records(tuple(intact), damaged, gaps.torn, len(data), is_torn, newest)


def _records_in(
    data: bytes, begin: int, end: int
) -> Iterator[tuple[int, JournalRecord, int, int]]:
    """Yield beginning, record, version and end of the intact records of a line."""
    if end - begin > 2 * MAX_RECORD_BYTES:
        return
    at, tries = begin, 0
    while tries < _MAX_TRIES and (at := data.find(_HEAD, at, end)) >= 0:
        found = _record_at(data, at, min(end, at + MAX_RECORD_BYTES))
        if found is None:
            at, tries = at + 1, tries + 1
            continue
        yield at, *found
        at = found[2]


def _record_at(data: bytes, at: int, end: int) -> tuple[JournalRecord, int, int] | None:
    """Return the intact record that begins here, its version and its end."""
    checksum, checked = 0, at
    # an answer may be named "crc": the first match is not always the end
    for tail in itertools.islice(_TAIL.finditer(data, at, end), _MAX_TRIES):
        checksum = zlib.crc32(data[checked : tail.start()], checksum)
        checked = tail.start()
        if checksum == int(tail[1], 16):
            break
    else:
        return None
    try:
        content = decode_json(data[at:checked] + b"}", dict[str, Any], "", StudyError)
        head = convert({name: content.pop(name) for name in _NAMES}, _Head, "")
    except (KeyError, InputError):
        return None  # not written by this program
    record = JournalRecord(head.record, head.utc, head.mono_s, head.kind, content)
    return record, head.v, tail.end()


class _Gaps:
    """Describes the bytes between intact records, unless they are a line break."""

    def __init__(self, data: bytes, intact: Sequence[JournalRecord]) -> None:
        self.damaged: list[str] = []
        self.torn = 0
        self._data, self._intact = data, intact
        self._covered, self._counted, self._line = 0, 0, 1

    def close(self, end: int, after: int) -> None:
        """Describe the gap before a record that goes from `end` to `after`."""
        begin, self._covered = self._covered, after
        gap = self._data[begin:end]
        left = gap.lstrip(b"\n")
        if not left and len(gap) <= 2:
            return
        at = end - len(left)
        self._line += self._data.count(b"\n", self._counted, at)
        self._counted = at
        self.torn += _WAS_WHOLE.search(gap) is None
        where = (
            Message("after record {number}", number=self._intact[-1].number)
            if self._intact
            else Message("at the beginning")
        )
        self.damaged.append(
            Message(
                "bytes {begin} to {end} (line {line}, {after}) are damaged",
                begin=begin,
                end=end,
                line=self._line,
                after=where,
            )
        )


class Journal:
    """Appends records to an existing file; locked for one program at a time.

    Args:
        path: made by `session_folder.create_session`.
        clock: of the machine.

    Raises:
        StudyError: when it cannot be written, is locked, or has a newer version.
    """

    def __init__(self, path: Path, clock: Clock) -> None:
        self._path, self._clock = path, clock
        try:
            self._file = os.open(path, os.O_RDWR | os.O_APPEND | os.O_NOFOLLOW)
        except OSError as problem:
            raise StorageError.of(problem, path) from problem
        try:
            _lock(self._file, path)
            found = read_journal(path)
        except BaseException:
            os.close(self._file)
            raise
        self.found = found
        self._next = found.next_number
        self._is_torn = found.is_torn

    def append(self, kind: str, **content: Any) -> JournalRecord:
        """Append a record and sync it to the disk.

        Raises:
            StudyError: when that failed; it can be retried.
        """
        monotonic_s, utc = round(self._clock.now_s(), 6), utc_now_iso("milliseconds")
        line = encode(self._next, utc, monotonic_s, kind, content)
        if len(line) > MAX_RECORD_BYTES:
            raise StudyError(
                "the text is too long to be saved ({found_kb} KB, at most {most_kb} KB)",
                where=str(self._path.parent.name),
                remedy="shorten it",
                found_kb=len(line) >> 10,
                most_kb=MAX_RECORD_BYTES >> 10,
            )
        # an incomplete line of an interrupted write stays separate
        line = b"\n" + line if self._is_torn else line
        try:
            self._is_torn = True
            write_whole(self._file, line)
            os.fsync(self._file)
            self._is_torn = False
            self._check_place()
        except OSError as problem:
            raise StudyError(
                "the answer could not be saved ({reason})",
                where=str(self._path.parent.name),
                remedy="call the experimenter",
                reason=write_problem(problem, self._path),
            ) from problem
        made = JournalRecord(self._next, utc, monotonic_s, kind, content)
        self._next += 1
        return made

    def _check_place(self) -> None:
        held, named = os.fstat(self._file), self._path.stat()
        if (held.st_dev, held.st_ino) != (named.st_dev, named.st_ino):
            raise FileNotFoundError(errno.ENOENT, Message("the folder was replaced"))

    def close(self) -> None:
        if self._file >= 0:
            os.close(self._file)
            self._file = -1


def refuse_if_open(path: Path) -> None:
    """Raise StudyError when another program has locked the file."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return  # a `Journal` could not open it either
    try:
        _lock(descriptor, path)
    finally:
        os.close(descriptor)


def _lock(descriptor: int, path: Path) -> None:
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as problem:
        raise StudyError(
            "is open in another window",
            where=str(path.parent),
            remedy="close it there first",
        ) from problem


def write_whole(descriptor: int, line: bytes) -> None:
    """Write a line; raises OSError when the disk takes only a part of it."""
    if os.write(descriptor, line) != len(line):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def read_journal(path: Path) -> Records:
    found = decode(read_file(path, MAX_BYTES))
    if found.newest_version > VERSION:
        raise StudyError(
            "has records of version {found}, this program reads {version}",
            where=str(path),
            remedy="update hapticplayer",
            found=found.newest_version,
            version=VERSION,
        )
    return found
