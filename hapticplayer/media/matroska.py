"""Takes attached files out of a Matroska file by its elements, without FFmpeg.

FFmpeg reads all attachments into memory when it opens a file, looks at its streams first,
and refuses a file without any. Here sizes are compared with a limit before anything is read.

Source: RFC 8794 (EBML), RFC 9559 (Matroska) 5.1.6 Attachments.
"""

import itertools
from collections.abc import Iterator
from typing import BinaryIO, NamedTuple

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_bytes import AnyClip, ClipBytes, size_of
from hapticplayer.untrusted import (
    MAX_ATTACHED_BYTES,
    MAX_ATTACHED_FILES,
    HeldFile,
)

EBML = b"\x1a\x45\xdf\xa3"
_SEGMENT, _ATTACHMENTS, _ATTACHED_FILE = 0x18538067, 0x1941A469, 0x61A7
_CLUSTER, _CUES, _TRACKS = 0x1F43B675, 0x1C53BB6B, 0x1654AE6B
_TAGS, _CHAPTERS = 0x1254C367, 0x1043A770
_MOST_BYTES = {_CUES: 16 << 20, _TRACKS: 4 << 20, _TAGS: 4 << 20, _CHAPTERS: 4 << 20}
"""48 h with a cue every half second have 7 MB; FFmpeg needs up to 25 times as much."""

_NAME, _MEDIA_TYPE, _DATA = 0x466E, 0x4660, 0x465C
_MAX_ELEMENTS = 500_000
"""Clusters of 48 h are 35,000; of a live stream without sizes, each block is counted."""

_MAX_TEXT_BYTES = 1024


class Attachment(NamedTuple):
    """A file within a media file.

    Attributes:
        name: as it is stored; any text.
        media_type: as it is stored; nothing follows from it.
        content: of the file.
    """

    name: str
    media_type: str
    content: bytes


class _Element(NamedTuple):
    """An element: its number, where it and its content begin, where it ends; None: unknown."""

    number: int
    at: int
    content_at: int
    end: int | None


def read_attachments(clip: AnyClip, marker: str) -> list[Attachment]:
    """Return the attached files in the order in which they are stored.

    Args:
        clip: a file of any kind; of a remote one only what lies before its frames is read.
        marker: the name of one of them; without it, [] is returned and nothing is read.
    """
    if isinstance(clip, ClipBytes):
        with clip.open() as reader:
            before = {_CLUSTER}
            return _attachments(reader, clip.size_bytes, marker, str(clip), before)
    with HeldFile(clip, MediaError) as file:
        found = _attachments(file.reader, file.size_bytes, marker, str(clip), set())
        if found:
            file.refuse_changed()
        return found


def _attachments(
    reader: BinaryIO, size_bytes: int, marker: str, where: str, before: set[int]
) -> list[Attachment]:
    if reader.read(len(EBML)) != EBML:
        return []
    attached = _attached(reader, size_bytes, before)
    found = [_parts(reader, one, size_bytes) for one in attached]
    names = [_text(reader, parts.get(_NAME)) for parts in found]
    if marker not in names:
        return []
    _check_size(found, where)
    return [
        Attachment(
            name,
            _text(reader, parts.get(_MEDIA_TYPE)),
            _content(reader, parts.get(_DATA)),
        )
        for name, parts in zip(names, found, strict=True)
    ]


def attachments_at(
    reader: BinaryIO, size_bytes: int, *, is_remote: bool = False
) -> tuple[int, ...]:
    """Return where attachments begin; of a remote file those before its frames."""
    if reader.read(len(EBML)) != EBML:
        return ()
    found = []
    for element in _elements(reader, 0, size_bytes, {_SEGMENT}):
        if is_remote and element.number == _CLUSTER:
            break
        if element.number == _ATTACHMENTS:
            found.append(element.at)
        elif _length(element) > _MOST_BYTES.get(element.number, _length(element)):
            raise MediaError(
                "its index, tags or chapters are too large ({size_mb} MB)",
                where=str(getattr(reader, "name", "")),
                remedy="remux it with MKVToolNix or FFmpeg, without them",
                size_mb=_length(element) >> 20,
            )
    return tuple(found)


def segment_end(reader: BinaryIO) -> int:
    """Where the segment ends by its size; 0 where that is left open, as live streams do."""
    reader.seek(0)
    first = itertools.islice(_elements(reader, 0, size_of(reader), set()), 2)
    return next((one.end or 0 for one in first if one.number == _SEGMENT), 0)


def _attached(
    reader: BinaryIO, size_bytes: int, before: set[int]
) -> Iterator[_Element]:
    """Step over the file and yield each attached file, at most one more than the limit.

    Elements `before` which they have to stand end the walk.
    """
    count = 0
    for element in _elements(reader, 0, size_bytes, {_SEGMENT}):
        if element.number in before:
            return
        if element.number != _ATTACHMENTS:
            continue
        end = min(element.end or size_bytes, size_bytes)
        for one in _elements(reader, element.content_at, end, set()):
            if one.number == _ATTACHED_FILE:
                yield one
                count += 1
            if count > MAX_ATTACHED_FILES:
                return


def _elements(
    reader: BinaryIO, at: int, end: int, entered: set[int]
) -> Iterator[_Element]:
    """Step over elements, and into those that are entered or whose end is unknown."""
    for _ in range(_MAX_ELEMENTS):
        if at >= end:
            return
        reader.seek(at)
        head = reader.read(12)
        number, used = _number(head)
        size, width = _size(head[used:])
        if not used or not width:
            return  # damaged from here on
        content_at = at + used + width
        end_at = None if size is None else content_at + size
        element = _Element(number, at, content_at, end_at)
        yield element
        is_entered = element.end is None or number in entered
        at = content_at if is_entered else element.end or content_at


def _number(head: bytes) -> tuple[int, int]:
    """Return the number of an element and its length in bytes, 0 where it is none."""
    width = 9 - head[0].bit_length() if head and head[0] else 0
    if not 1 <= width <= 4 or len(head) < width:
        return 0, 0
    return int.from_bytes(head[:width], "big"), width


def _size(head: bytes) -> tuple[int | None, int]:
    """Return a size, None if it is unknown, and its length in bytes, 0 if it is none."""
    width = 9 - head[0].bit_length() if head and head[0] else 0
    if not 1 <= width <= 8 or len(head) < width:
        return 0, 0
    most = (1 << 7 * width) - 1
    value = int.from_bytes(head[:width], "big") & most
    return (None if value == most else value), width


def _parts(reader: BinaryIO, one: _Element, size_bytes: int) -> dict[int, _Element]:
    """Return the parts of an attached file by number, without those that are damaged."""
    end = min(one.end or 0, size_bytes)
    inside = _elements(reader, one.content_at, end, set())
    return {part.number: part for part in inside if part.end and part.end <= end}


def _check_size(found: list[dict[int, _Element]], where: str) -> None:
    """Refuse more than the limits before any of it is read."""
    total = sum(_length(parts.get(_DATA)) for parts in found)
    if len(found) > MAX_ATTACHED_FILES or total > MAX_ATTACHED_BYTES:
        raise MediaError(
            "its attachments are too large (limit: {most_mb} MB in {files} files)",
            where=where,
            remedy="choose another file",
            most_mb=MAX_ATTACHED_BYTES >> 20,
            files=MAX_ATTACHED_FILES,
        )


def _length(element: _Element | None) -> int:
    if element is None or element.end is None:
        return 0
    return element.end - element.content_at


def _content(reader: BinaryIO, element: _Element | None) -> bytes:
    if element is None:
        return b""
    reader.seek(element.content_at)
    return reader.read(_length(element))


def _text(reader: BinaryIO, element: _Element | None) -> str:
    if _length(element) > _MAX_TEXT_BYTES:
        return ""
    return _content(reader, element).rstrip(b"\0").decode(errors="replace")
