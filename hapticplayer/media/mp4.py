"""The boxes of an MP4 file: its tracks with their marks and edit lists.

What FFmpeg does not tell: the mark (four letters) of tracks that it does not know, and
the edit list, which it rounds to whole packets in a track of telemetry.
"""

import dataclasses
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import BinaryIO, NamedTuple

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_bytes import AnyClip, open_clip, size_of
from hapticplayer.model.limits import MAX_BOXES

TOP = frozenset(
    b"ftyp moov mdat free skip wide pnot moof mfra sidx styp uuid udta meta".split()
)
_NESTED = frozenset(b"moov trak edts mdia minf stbl moof traf".split())
_COUNT_AT = {b"stsz": 8, b"stz2": 8, b"trun": 4}
"""Where the number of samples stands in the box's content."""
_MAX_EDITS = 10_000
_MAX_NAME_BYTES, _BEGIN_BYTES = 100, 8
_OFFSETS = {b"stco": 4, b"co64": 8}
"""The size of an entry."""


class Box(NamedTuple):
    """A box: its kind, where it begins, its content, where it ends, and how deep it is."""

    kind: bytes
    at: int
    content_at: int
    end: int
    level: int


class Declared(NamedTuple):
    """What the header of a file declares; 0 where it does not."""

    samples: int = 0
    end: int = 0


class Edit(NamedTuple):
    """A part of a track as it is shown.

    Attributes:
        length_s: of what is shown.
        media_s: the track's own time of its beginning; None where nothing is shown.
        rate: of playback; 0 for a frame that stands still.
    """

    length_s: float
    media_s: float | None
    rate: float = 1.0


@dataclass(frozen=True, slots=True)
class ClipTrack:
    """A track of an MP4 file.

    Attributes:
        number: its id.
        kind: of its handler: "vide", "soun", "meta" ...
        name: of its handler.
        mark: of its samples, such as "avc1" or "rtmd".
        ticks_per_s: of its own time.
        delay_s: of its first sample, which is decoded before it is shown.
        edits: its edit list; empty where all is shown.
        begins: the first bytes of a track that is neither video nor sound.
    """

    number: int = 0
    kind: str = ""
    name: str = ""
    mark: str = ""
    ticks_per_s: int = 0
    delay_s: float = 0.0
    edits: tuple[Edit, ...] = ()
    begins: bytes = b""


def hidden_s(track: ClipTrack) -> float:
    """How much of a track's beginning its edit list hides."""
    begins = (edit.media_s for edit in track.edits if edit.media_s is not None)
    return max(0.0, next(begins, 0.0) - track.delay_s)


def shown_at(edits: tuple[Edit, ...], begin_s: float, length_s: float) -> float | None:
    """Where an edit list shows what a track has at a time; None where it does not.

    By the edit that holds most of it.
    """
    best_s, place_s, at_s = 0.0, None, 0.0
    for edit in edits:
        if edit.media_s is not None and edit.rate > 0.0:
            end_s = edit.media_s + edit.length_s * edit.rate
            held_s = min(end_s, begin_s + length_s) - max(edit.media_s, begin_s)
            if held_s > best_s:
                best_s = held_s
                place_s = at_s + (begin_s - edit.media_s) / edit.rate
        at_s += edit.length_s
    return place_s


def boxes(stream: BinaryIO, nested: frozenset[bytes] = _NESTED) -> Iterator[Box]:
    """Step over the boxes of an MP4, none of another container, and into the nested ones.

    As in FFmpeg no box is longer than the one that it is in.

    Raises:
        MediaError: for more than any camera writes.
    """
    stream.seek(0)
    is_mp4 = stream.read(8)[4:] in TOP
    at, ends = 0, [size_of(stream) * is_mp4]
    for _ in range(MAX_BOXES):
        while at >= ends[-1] and len(ends) > 1:
            ends.pop()
        stream.seek(at)
        header = stream.read(16)
        if at >= ends[-1] or len(header) < 8:
            return
        length, content_at = int.from_bytes(header[:4], "big"), at + 8
        if length == 1:
            length, content_at = int.from_bytes(header[8:], "big"), at + 16
        box = Box(header[4:8], at, content_at, at + length, len(ends) - 1)
        yield box
        if box.end < content_at:
            return
        at = end = min(box.end, ends[-1])
        if box.kind in nested:
            at = content_at
            ends.append(end)
    raise MediaError(
        "it has more than {most} boxes",
        where=str(getattr(stream, "name", "")),
        remedy="remux it with FFmpeg (-c copy)",
        most=MAX_BOXES,
    )


def declared_in(stream: BinaryIO) -> Declared:
    """The samples of all tables and fragments, and where the last box ends."""
    samples, end, is_known = 0, 0, True
    for box in boxes(stream):
        if box.kind in _COUNT_AT:
            stream.seek(box.content_at + _COUNT_AT[box.kind])
            samples += int.from_bytes(stream.read(4), "big")
        elif box.level == 0 and is_known:
            is_known = box.kind in TOP  # some cameras append data that is no box
            is_ended = box.end >= box.content_at  # 0: with the file, else it is damaged
            end = box.end * is_ended if is_known else box.at
    return Declared(samples, end)


def tracks_of(clip: AnyClip) -> tuple[ClipTrack, ...]:
    """The tracks of an MP4 file, in their order; none of another container."""
    found: list[ClipTrack] = []
    movie_ticks = 0
    with open_clip(clip) as stream:
        for box in boxes(stream):
            if box.kind == b"trak":
                found.append(ClipTrack())
            elif box.kind == b"mvhd":
                movie_ticks = _ticks_of(content_of(stream, box, 32))
            elif found and box.kind in (b"elst", *_OFFSETS, *_FIELDS):
                found[-1] = _with_field(found[-1], stream, box, movie_ticks)
    return tuple(map(_in_seconds, found))


def _in_seconds(track: ClipTrack) -> ClipTrack:
    tick_s = 1.0 / max(1, track.ticks_per_s)
    edits = tuple(
        e if e.media_s is None else e._replace(media_s=e.media_s * tick_s)
        for e in track.edits
    )
    return dataclasses.replace(track, delay_s=track.delay_s * tick_s, edits=edits)


def _with_field(
    track: ClipTrack, stream: BinaryIO, box: Box, movie_ticks: int
) -> ClipTrack:
    if box.kind == b"elst":
        return dataclasses.replace(track, edits=_edits(stream, box, movie_ticks))
    if box.kind in _OFFSETS:
        return _with_begin(track, stream, box)
    return _FIELDS[box.kind](track, content_of(stream, box, 20 + _MAX_NAME_BYTES))


def _with_begin(track: ClipTrack, stream: BinaryIO, box: Box) -> ClipTrack:
    first = content_of(stream, box, 8 + _OFFSETS[box.kind])[8:]
    if track.kind in ("vide", "soun") or not first:
        return track
    stream.seek(min(int.from_bytes(first, "big"), size_of(stream)))
    return dataclasses.replace(track, begins=stream.read(_BEGIN_BYTES))


def _with_number(track: ClipTrack, content: bytes) -> ClipTrack:
    at = 20 if content[:1] == b"\1" else 12
    number = int.from_bytes(content[at : at + 4], "big")
    return dataclasses.replace(track, number=number)


def _with_ticks(track: ClipTrack, content: bytes) -> ClipTrack:
    return dataclasses.replace(track, ticks_per_s=_ticks_of(content))


def _with_name(track: ClipTrack, content: bytes) -> ClipTrack:
    if track.kind:  # a second handler, of where the data are
        return track
    kind, name = _text(content[8:12]), _text(content[24:])
    return dataclasses.replace(track, kind=kind, name=name)


def _with_mark(track: ClipTrack, content: bytes) -> ClipTrack:
    return dataclasses.replace(track, mark=_text(content[12:16]))


def _with_delay(track: ClipTrack, content: bytes) -> ClipTrack:
    delay = int.from_bytes(content[12:16], "big", signed=True)
    return dataclasses.replace(track, delay_s=max(0.0, delay))


_FIELDS: dict[bytes, Callable[[ClipTrack, bytes], ClipTrack]] = {
    b"tkhd": _with_number,
    b"mdhd": _with_ticks,
    b"hdlr": _with_name,
    b"stsd": _with_mark,
    b"ctts": _with_delay,
}


def content_of(stream: BinaryIO, box: Box, most: int) -> bytes:
    """The content of a box, at most so many bytes."""
    stream.seek(box.content_at)
    return stream.read(max(0, min(box.end - box.content_at, most)))


def _text(content: bytes) -> str:
    text = content.decode("utf-8", "replace")
    return "".join(c for c in text if c.isprintable()).strip()


def _ticks_of(content: bytes) -> int:
    at = 20 if content[:1] == b"\1" else 12
    return int.from_bytes(content[at : at + 4], "big")


def _edits(stream: BinaryIO, box: Box, movie_ticks: int) -> tuple[Edit, ...]:
    """The edits of a list whose own times are still in ticks of the track."""
    content = content_of(stream, box, 8 + 20 * _MAX_EDITS)
    wide = 8 if content[:1] == b"\1" else 4
    size, found = 2 * wide + 4, []
    count = int.from_bytes(content[4:8], "big")
    for number in range(min(count, (len(content) - 8) // size)):
        entry = content[8 + number * size : 8 + (number + 1) * size]
        length = int.from_bytes(entry[:wide], "big")
        begin = int.from_bytes(entry[wide : 2 * wide], "big", signed=True)
        rate = int.from_bytes(entry[2 * wide :], "big", signed=True) / 65536
        is_empty = begin == -1
        found.append(
            Edit(length / max(1, movie_ticks), None if is_empty else float(begin), rate)
        )
    return tuple(found)
