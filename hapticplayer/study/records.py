r"""Records as lines of JSON, each with a checksum that no damage gets past.

A line is `{"record":7,"v":1,"utc":...,"mono_s":...,"kind":...,...,"crc":"89abcdef"}`:
the CRC-32 is that of the bytes before `,"crc"`. A quotation mark inside a text is
escaped, so `{"record":` and `,"crc":"` stand nowhere else but in an answer's own name.
"""

import json
import re
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message

VERSION = 1
MAX_RECORD_BYTES = 1 << 20
_HEAD = b'{"record":'
_TAIL = re.compile(rb',"crc":"([0-9a-f]{8})"\}')


@dataclass(frozen=True, slots=True)
class Record:
    """One intact record.

    Attributes:
        number: 1 and up in the order of writing.
        utc: ISO 8601.
        monotonic_s: of the machine's clock.
        kind: what it tells.
        content: its other members.
    """

    number: int
    utc: str
    monotonic_s: float
    kind: str
    content: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Records:
    """What a file holds.

    Attributes:
        intact: in the order of the file.
        damaged: one sentence for each damaged place.
        size_bytes: of what was read.
        is_torn: whether the last line has no end.
        newest_version: of the records, 0 where there are none.
    """

    intact: tuple[Record, ...]
    damaged: tuple[str, ...]
    size_bytes: int
    is_torn: bool
    newest_version: int

    @property
    def next_number(self) -> int:
        """What the next record is called."""
        last = max((record.number for record in self.intact), default=0)
        return last + len(self.damaged) + 1


def encode(
    number: int, utc: str, monotonic_s: float, kind: str, content: Mapping[str, Any]
) -> bytes:
    """Return one record as a line.

    Raises:
        ValueError: for what JSON cannot hold (NaN), or a name that is taken.
    """
    head = {
        "record": number,
        "v": VERSION,
        "utc": utc,
        "mono_s": round(monotonic_s, 6),
        "kind": kind,
    }
    if taken := (head.keys() | {"crc"}) & content.keys():
        raise ValueError(f"{sorted(taken)} are the record's own names")
    text = json.dumps(
        {**head, **content},
        ensure_ascii=False,
        allow_nan=False,
        separators=(",", ":"),
    )
    body = text.encode("utf-8", errors="replace")[:-1]  # half a character: "?"
    line = body + b',"crc":"%08x"}\n' % zlib.crc32(body)
    if len(line) > MAX_RECORD_BYTES:
        raise ValueError("the record is too long")
    return line


def decode(data: bytes) -> Records:
    """Find every intact record, wherever damage lies, and name the damage.

    A record is taken only where its checksum holds, so nothing that was changed is
    ever read as if it were right.
    """
    intact: list[Record] = []
    damaged: list[str] = []
    newest = at = covered = 0
    while (at := data.find(_HEAD, at)) >= 0:
        found = _record_at(data, at)
        if found is None:
            at += 1
            continue
        record, version, end = found
        _name_gap(data, covered, at, intact, damaged)
        intact.append(record)
        newest = max(newest, version)
        at = covered = end
    _name_gap(data, covered, len(data), intact, damaged)
    is_torn = bool(data) and not data.endswith(b"\n")
    return Records(tuple(intact), tuple(damaged), len(data), is_torn, newest)


def _record_at(data: bytes, at: int) -> tuple[Record, int, int] | None:
    """Return the intact record that begins at a place, its version and its end."""
    # an answer may be called "crc", too: the first tail is not always the record's
    for tail in _TAIL.finditer(data, at, at + MAX_RECORD_BYTES):
        body = data[at : tail.start()]
        if zlib.crc32(body) == int(tail[1], 16):
            break
    else:
        return None
    try:
        content = json.loads(body + b"}")
        number, version = content.pop("record"), content.pop("v")
        utc, monotonic_s = content.pop("utc"), content.pop("mono_s")
        kind = content.pop("kind")
    except (ValueError, KeyError, RecursionError):
        return None  # written by nobody: a checksum can be forged
    record = Record(int(number), str(utc), float(monotonic_s), str(kind), content)
    return record, int(version), tail.end()


def _name_gap(
    data: bytes, begin: int, end: int, intact: list[Record], damaged: list[str]
) -> None:
    """Name what lies between two intact records, unless it is one line break."""
    gap = data[begin:end]
    if gap.strip(b"\n") == b"" and len(gap) <= 2:
        return
    line = 1 + data.count(b"\n", 0, begin + (len(gap) - len(gap.lstrip(b"\n"))))
    after = (
        Message("after record {number}", number=intact[-1].number)
        if intact
        else Message("at the beginning")
    )
    damaged.append(
        Message(
            "bytes {begin} to {end} (line {line}, {after}) are damaged",
            begin=begin,
            end=end,
            line=line,
            after=after,
        )
    )
