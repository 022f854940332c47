"""How many samples an MP4 says it holds, before FFmpeg makes room for them.

A table of samples of one size has a few bytes and declares billions; FFmpeg keeps 24
bytes for each. Neither a table's nor a fragment's samples can be more than the file
has bytes.

Source: ISO/IEC 14496-12, 8.7.3 (stsz, stz2) and 8.8.8 (trun).
"""

import math
from pathlib import Path
from typing import BinaryIO

_TOPS = frozenset(b"ftyp moov mdat free skip wide pnot moof styp sidx uuid".split())
_NESTED = frozenset(b"moov trak mdia minf stbl moof traf".split())
_COUNT_AT = {b"stsz": 8, b"stz2": 8, b"trun": 4}
"""Where the number of samples stands behind the box's header."""

_MAX_BOXES = 1_000_000  # 48 h in fragments of 2 s


def declared_samples(file: Path) -> float:
    """Return how many samples the tables and fragments of an MP4 declare together.

    0 for other containers, infinite where there are more boxes than any camera writes.
    """
    with file.open("rb") as stream:
        if stream.read(8)[4:] not in _TOPS:
            return 0
        return _count(stream, file.stat().st_size)


def _count(stream: BinaryIO, size_bytes: int) -> float:
    """Step over boxes and into those that hold tables; ends are not believed."""
    at = total = 0
    for _ in range(_MAX_BOXES):
        stream.seek(at)
        header = stream.read(24)
        if len(header) < 8:
            return total
        length, kind = int.from_bytes(header[:4], "big"), header[4:8]
        width = 16 if length == 1 else 8
        if length == 1:
            length = int.from_bytes(header[8:16], "big")
        if kind in _COUNT_AT:
            first = width + _COUNT_AT[kind]
            stream.seek(at + first)
            total += int.from_bytes(stream.read(4), "big")
        at += width if kind in _NESTED else length
        if length < width or at >= size_bytes:  # 0: the rest of the file
            return total
    return math.inf
