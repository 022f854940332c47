"""What a clip offers beside its first sound: other audio tracks, and subtitles as text."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from av.container import InputContainer
from av.stream import Stream

from hapticplayer.errors import MediaError, Message, Progress
from hapticplayer.media.opening import (
    context_of,
    media_errors,
    open_media,
    origin_s,
    read_only,
)
from hapticplayer.untrusted import without_controls

MOST_CAPTIONS, LONGEST_CAPTION = 20_000, 500
_MOST_TRACKS, _LONGEST_NAME = 64, 80
_STYLE = re.compile(r"\{[^{}]*\}|<[^<>]*>")
_UNKNOWN = frozenset({"", "und"})


class OfferedTrack(NamedTuple):
    """A stream of a clip; `number` counts those of its kind that can be decoded."""

    number: int
    language: str
    title: str


class ClipTracks(NamedTuple):
    """All that can be chosen."""

    sound: tuple[OfferedTrack, ...] = ()
    subtitles: tuple[OfferedTrack, ...] = ()


class Caption(NamedTuple):
    """A text that is shown from one media time to another."""

    start_s: float
    end_s: float
    text: str


def tracks_of(path: Path) -> ClipTracks:
    """The audio tracks and text subtitles of a clip; raises MediaError."""
    with (
        open_media(path) as container,
        media_errors(path, Message("its tracks cannot be listed")),
    ):
        sound = [one for one in container.streams.audio if context_of(one)]
        return ClipTracks(_described(sound), _described(_texts(container)))


def read_subtitles(path: Path, index: int, *, progress: Progress) -> list[Caption]:
    """The captions of a track in the order of their times.

    Raises:
        MediaError: where there is no such track, or it cannot be read.
    """
    found: list[Caption] = []
    with (
        open_media(path) as container,
        media_errors(path, Message("its subtitles cannot be read")),
    ):
        streams = _texts(container)
        if not 0 <= index < len(streams):
            raise MediaError(
                "has no such subtitles", where=str(path), remedy="choose another track"
            )
        stream, zero_s = streams[index], origin_s(container)
        read_only(container, stream)
        for packet in container.demux(stream):
            if packet.pts is None or not packet.duration:
                continue
            progress(0.0, "")
            start_s = float(packet.pts * packet.time_base) - zero_s
            end_s = start_s + float(packet.duration * packet.time_base)
            texts = [_plain(rect.dialogue) for rect in packet.decode()]  # type: ignore[union-attr]
            if text := "\n".join(filter(None, texts)):
                found.append(Caption(start_s, end_s, text))
            if len(found) >= MOST_CAPTIONS:
                break
    return sorted(found)


def _texts(container: InputContainer) -> list[Stream]:
    """Subtitles that are text; pictures of text cannot be shown."""
    return [
        one
        for one in container.streams.subtitles
        if context_of(one) and one.codec_context.codec.text_sub
    ]


def _described(streams: Sequence[Stream]) -> tuple[OfferedTrack, ...]:
    return tuple(
        OfferedTrack(number, _word(one, "language"), _word(one, "title", "name"))
        for number, one in enumerate(streams[:_MOST_TRACKS])
    )


def _word(stream: Stream, *keys: str) -> str:
    said = (without_controls(stream.metadata.get(key, "")).strip() for key in keys)
    return next((text[:_LONGEST_NAME] for text in said if text not in _UNKNOWN), "")


def _plain(dialogue: bytes) -> str:
    """The words of an event, without its styles."""
    text = _STYLE.sub("", dialogue.decode(errors="replace")).replace("\\N", "\n")
    lines = (without_controls(line).strip() for line in text.split("\n"))
    return "\n".join(filter(None, lines))[:LONGEST_CAPTION]
