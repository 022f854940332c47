"""How long a file says it is, which tells a truncated copy from a whole one.

AVI, WAV and Matroska give their length in the first bytes; MP4 is a chain of boxes
that each give their own.
"""

from pathlib import Path
from typing import BinaryIO

_RIFF_UNKNOWN = (0, 0xFFFFFFFF)
_EBML, _SEGMENT = b"\x1a\x45\xdf\xa3", b"\x18\x53\x80\x67"
_HEAD_BYTES = 64
_BOXES = frozenset(
    b"ftyp moov mdat free skip wide pnot moof mfra sidx styp uuid udta meta".split()
)
_MAX_BOXES = 10_000


def declared_bytes(file: Path) -> int:
    """Return the length that a file declares, 0 where it does not."""
    with file.open("rb") as stream:
        head = stream.read(_HEAD_BYTES)
        if head[4:8] in _BOXES:
            return _end_of_boxes(stream, file.stat().st_size)
    if head.startswith(b"RIFF") and len(head) >= 8:
        size = int.from_bytes(head[4:8], "little")
        return 0 if size in _RIFF_UNKNOWN else size + 8
    if head.startswith(_EBML):
        return _segment_end(head)
    return 0


def _end_of_boxes(stream: BinaryIO, size_bytes: int) -> int:
    """Return where the last box of an MP4 file ends, 0 for one without an end."""
    at = 0
    for _ in range(_MAX_BOXES):
        stream.seek(at)
        header = stream.read(16)
        if at >= size_bytes or header[4:8] not in _BOXES:
            return at  # some cameras append data that is no box
        length = int.from_bytes(header[:4], "big")
        if length == 1:
            length = int.from_bytes(header[8:], "big")
        if length < 8:  # 0: to the end of the file; anything else is damage
            return 0
        at += length
    return 0


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
