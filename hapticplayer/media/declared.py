"""What a file says of its own size, read before FFmpeg does.

The length that it gives tells a truncated copy from a whole one. The number of samples
tells a file that was made to do harm: a table for samples of one size has a few bytes and
declares billions, and FFmpeg keeps 24 bytes for each.

Source: ISO/IEC 14496-12, 4.2 (boxes), 8.7.3 (stsz, stz2) and 8.8.8 (trun).
"""

import math
from collections.abc import Iterator
from typing import BinaryIO, NamedTuple

from hapticplayer.media.clip_bytes import AnyClip, open_clip, size_of

_RIFF_UNKNOWN = (0, 0xFFFFFFFF)
_EBML, _SEGMENT = b"\x1a\x45\xdf\xa3", b"\x18\x53\x80\x67"
_HEAD_BYTES = 64
_TOP = frozenset(
    b"ftyp moov mdat free skip wide pnot moof mfra sidx styp uuid udta meta".split()
)
_NESTED = frozenset(b"moov trak mdia minf stbl moof traf".split())
_COUNT_AT = {b"stsz": 8, b"stz2": 8, b"trun": 4}
"""Where the number of samples stands behind the box's header."""

MAX_BOXES = 1_000_000  # 48 h in fragments of 2 s


class _Box(NamedTuple):
    """A box of an MP4 file: its kind, where it begins, its content, and where it ends."""

    kind: bytes
    at: int
    content_at: int
    end: int


def declared_bytes(clip: AnyClip) -> int:
    """Return the length that a file declares, 0 where it does not."""
    with open_clip(clip) as stream:
        head = stream.read(_HEAD_BYTES)
        if head[4:8] in _TOP:
            return _end_of_boxes(stream, size_of(stream))
    if head.startswith(b"RIFF") and len(head) >= 8:
        size = int.from_bytes(head[4:8], "little")
        return 0 if size in _RIFF_UNKNOWN else size + 8
    if head.startswith(_EBML):
        return _segment_end(head)
    return 0


def declared_samples(clip: AnyClip) -> float:
    """Return how many samples the tables and fragments of an MP4 declare together.

    0 for other containers, infinite where there are more boxes than any camera writes.
    """
    total = 0
    with open_clip(clip) as stream:
        if stream.read(8)[4:] not in _TOP:
            return 0
        boxes = _boxes(stream, size_of(stream), _NESTED)
        for number, box in enumerate(boxes):
            if number == MAX_BOXES:
                return math.inf
            if box.kind in _COUNT_AT:
                stream.seek(box.content_at + _COUNT_AT[box.kind])
                total += int.from_bytes(stream.read(4), "big")
    return total


def _end_of_boxes(stream: BinaryIO, size_bytes: int) -> int:
    """Return where the last box of an MP4 file ends, 0 for one without an end."""
    end = 0
    for box in _boxes(stream, size_bytes, frozenset()):
        if box.kind not in _TOP:
            return box.at  # some cameras append data that is no box
        if box.end < box.content_at:  # 0: to the end of the file, else it is damaged
            return 0
        end = box.end
    return end


def _boxes(
    stream: BinaryIO, size_bytes: int, nested: frozenset[bytes]
) -> Iterator[_Box]:
    """Step over boxes and into the nested ones, whose ends are not trusted."""
    at = 0
    while at < size_bytes:
        stream.seek(at)
        header = stream.read(16)
        if len(header) < 8:
            return
        length, content_at = int.from_bytes(header[:4], "big"), at + 8
        if length == 1:
            length, content_at = int.from_bytes(header[8:], "big"), at + 16
        box = _Box(header[4:8], at, content_at, at + length)
        yield box
        if box.end < content_at:
            return
        at = content_at if box.kind in nested else box.end


def _segment_end(head: bytes) -> int:
    """Return where a Matroska segment ends; live streams leave that open."""
    size, at = _ebml_size(head, len(_EBML))
    at += size
    if head[at : at + 4] != _SEGMENT:
        return 0
    size, at = _ebml_size(head, at + 4)
    return at + size if size else 0


def _ebml_size(head: bytes, at: int) -> tuple[int, int]:
    """Return a size of variable length and where it ends; 0 when it is unknown."""
    if at >= len(head) or head[at] == 0:
        return 0, at
    width = 9 - head[at].bit_length()
    bits = 7 * width
    value = int.from_bytes(head[at : at + width], "big") & ((1 << bits) - 1)
    is_unknown = value == (1 << bits) - 1
    return (0 if is_unknown else value), at + width
