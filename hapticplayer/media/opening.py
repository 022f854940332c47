"""Opens media files that are not trusted.

FFmpeg follows references: playlists, `concat:` names and network addresses. So a
file is opened by an absolute path with the `file:` prefix, only with demuxers that
read one file, and only if it is a regular file (a FIFO would hang for ever). It keeps
attachments and tables in memory, too: a file is looked at by a `HeaderReader` first, and
read by one if it has attachments or is remote (`ClipBytes`); FFmpeg opens nothing then.
Every failure becomes one MediaError that says what to do.
"""

import contextlib
import ctypes
import functools
import io
import os
from collections.abc import Iterator
from pathlib import Path
from typing import cast

import av
import av.error
from av.container import InputContainer
from av.stream import Discard as _Discard
from av.stream import Disposition, Stream
from av.video.stream import VideoStream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_bytes import (
    AnyClip,
    ClipBytes,
    HeaderReader,
    open_clip,
    path_of,
)
from hapticplayer.media.containers import CONTAINERS, refuse_others
from hapticplayer.media.matroska import EBML, attachments_at, segment_end
from hapticplayer.media.mp4 import Declared, declared_in
from hapticplayer.model.limits import (
    INDEX_TAIL,
    MAX_BLOCK_BYTES,
    MAX_INDEXED,
    MAX_PIXELS,
    MAX_SIDE_PX,
    MAX_STREAMS,
)
from hapticplayer.storage import raise_if_full
from hapticplayer.untrusted import COPY_AGAIN, FileState, resolve_regular

_HEADERS_ONLY = {"probesize": "5000", "analyzeduration": "1"}
OPTIONS = {
    "format_whitelist": ",".join(name for c in CONTAINERS for name in c.demuxers),
}
CONVERT = Message(
    "copy it again, convert it to MP4 (H.264 and AAC), or choose another file"
)


def open_media(path: AnyClip, *, has_edits: bool = True) -> InputContainer:
    """Open a media file; the container closes at the end of a `with` block.

    It is one of `CONTAINERS`; symbolic links are followed. Without `has_edits` the
    tracks have their own times, whatever the edit lists say.
    """
    file = path if isinstance(path, ClipBytes) else resolve_regular(path)
    with media_errors(
        file, Message("it is not a video or sound file that can be read"), CONVERT
    ):
        refuse_others(file)
        is_remote = isinstance(file, ClipBytes)
        found = (
            declared(file) if is_remote else _declared_by(FileState.of(path_of(file)))
        )
        _check_tables(file, found.samples)
        container = _opened(file, {} if has_edits else {"ignore_editlist": "1"})
    try:
        with media_errors(file, Message("its headers are damaged")):
            _check_streams(container, file)
            _check_length(container, file, found.end)
    except BaseException:
        container.close()
        raise
    return container


def _opened(clip: Path | ClipBytes, more: dict[str, str]) -> InputContainer:
    _limit_blocks()
    if isinstance(clip, ClipBytes):
        with clip.open() as reader:
            hidden = attachments_at(reader, clip.size_bytes, is_remote=True)
        return _opened_by(HeaderReader(clip.open(), hidden), more)
    if hidden := _hidden_in(FileState.of(clip)):
        return _opened_by(_reader_of(clip, hidden), more)
    options = {**OPTIONS, **more, "protocol_whitelist": "file"}
    return av.open(f"file:{clip}", "r", options=options, metadata_errors="ignore")


def _opened_by(reader: HeaderReader, more: dict[str, str]) -> InputContainer:
    """Let FFmpeg read by us; it opens nothing itself then: no protocol has this name."""
    options = {**OPTIONS, **more, "protocol_whitelist": "none"}
    container = av.open(reader, "r", options=options, metadata_errors="ignore")
    reader.is_opening = False
    return container


def _reader_of(file: Path, hidden: tuple[int, ...]) -> HeaderReader:
    with open_clip(file) as reader:
        descriptor = os.dup(reader.fileno())
    return HeaderReader(io.FileIO(descriptor, closefd=False), hidden, descriptor)


@functools.lru_cache(maxsize=16)
def _hidden_in(state: FileState) -> tuple[int, ...]:
    """Where the attachments of a file are; its headers are refused if they are too large."""
    with open_clip(state.path) as reader:
        hidden = attachments_at(reader, state.size_bytes)
    reader_of_headers = _reader_of(state.path, hidden)
    with contextlib.suppress(av.error.FFmpegError):  # the next one names it
        _opened_by(reader_of_headers, _HEADERS_ONLY).close()
    return hidden


@functools.cache
def _limit_blocks() -> None:
    """Let FFmpeg request no larger piece of memory, however large a file says that it is."""
    maps = Path("/proc/self/maps").read_text(encoding="utf-8", errors="replace")
    for line in maps.splitlines():
        path = line.split(maxsplit=5)[5:]
        if path and "libavutil" in path[0]:
            ctypes.CDLL(path[0]).av_max_alloc(ctypes.c_size_t(MAX_BLOCK_BYTES))
            return


@contextlib.contextmanager
def media_errors(path: AnyClip, what: str, remedy: str = COPY_AGAIN) -> Iterator[None]:
    """Turn whatever PyAV raises inside the block into a MediaError."""
    try:
        yield
    except MediaError:
        raise
    except (
        av.error.FFmpegError,
        OSError,
        EOFError,
        MemoryError,
        UnicodeError,
        ValueError,
        OverflowError,
        AttributeError,  # PyAV looks into a codec context that is not there
    ) as error:
        raise_if_full(error, Path(str(path)))
        raise MediaError(
            "{what} ({reason})",
            where=str(path),
            remedy=remedy,
            what=what,
            reason=error,
        ) from error


def _check_tables(file: Path | ClipBytes, samples: int) -> None:
    """Refuse an index that FFmpeg would fill the memory with."""
    if samples > _size_bytes(file):
        raise MediaError(
            "its index lists more samples than it has bytes",
            where=str(file),
            remedy=COPY_AGAIN,
        )
    if samples > MAX_INDEXED:
        raise MediaError(
            "its index lists {count} frames and pieces of sound, which is too much "
            "(limit: {most})",
            where=str(file),
            remedy="cut it into parts of some hours",
            count=samples,
            most=MAX_INDEXED,
        )


def _check_streams(container: InputContainer, file: Path | ClipBytes) -> None:
    """Refuse absurd sizes before anything is allocated for them."""
    if not len(container.streams) or len(container.streams) > MAX_STREAMS:
        raise MediaError(
            "it holds {count} streams, expected 1 to {most}",
            where=str(file),
            remedy=COPY_AGAIN,
            count=len(container.streams),
            most=MAX_STREAMS,
        )
    if not any(context_of(s) or s.type == "data" for s in container.streams):
        raise MediaError(
            "none of its streams can be decoded, because its headers are damaged",
            where=str(file),
            remedy=COPY_AGAIN,
        )
    for stream in container.streams.video:
        if context_of(stream) is None:
            continue
        width, height = stream.width, stream.height
        if width * height > MAX_PIXELS or max(width, height) > MAX_SIDE_PX:
            raise MediaError(
                "its frames of {width} x {height} pixels are too large (up to 8192 "
                "x 4320 are shown)",
                where=str(file),
                remedy="convert it to a smaller size",
                width=width,
                height=height,
            )


def _check_length(
    container: InputContainer, file: Path | ClipBytes, promised_bytes: int
) -> None:
    """Refuse a file that ends before the last sample of its index.

    FFmpeg plays such a file to where it ends and reports nothing.
    """
    size_bytes = _size_bytes(file)
    indexed_bytes = max(
        (
            entry.pos + entry.size
            for stream in container.streams
            for entry in stream.index_entries[-INDEX_TAIL:]
        ),
        default=0,
    )
    if indexed_bytes > size_bytes:
        raise MediaError(
            "the file ends at byte {size_bytes} but its index needs {indexed_bytes}",
            where=str(file),
            remedy="copy it again",
            size_bytes=size_bytes,
            indexed_bytes=indexed_bytes,
        )
    if promised_bytes > size_bytes:
        raise MediaError(
            "the file ends at byte {size_bytes} but its header promises "
            "{promised_bytes}",
            where=str(file),
            remedy="copy it again",
            size_bytes=size_bytes,
            promised_bytes=promised_bytes,
        )


def _size_bytes(clip: Path | ClipBytes) -> int:
    return clip.size_bytes if isinstance(clip, ClipBytes) else clip.stat().st_size


def context_of(stream: Stream) -> object | None:
    """Return the stream's codec context, or None where there is no decoder."""
    return cast("object | None", stream.codec_context)


def find_video(container: InputContainer) -> VideoStream | None:
    """Return the first decodable video stream that is not a cover picture."""
    for stream in container.streams.video:
        is_cover = stream.disposition & Disposition.attached_pic
        if context_of(stream) is not None and not is_cover:
            return stream
    return None


def origin_s(container: InputContainer) -> float:
    """Return the container time of media time 0, s.

    Media time starts where the first frame is shown; without video, where
    the first sound is heard.
    """
    stream: Stream | None = find_video(container)
    if stream is None:
        stream = next(iter(container.streams.audio), None)
    if stream is None or stream.start_time is None or stream.time_base is None:
        return 0.0
    return float(stream.start_time * stream.time_base)


def read_only(container: InputContainer, *wanted: Stream) -> None:
    """Let the demuxer skip all other streams, so that they are not even read."""
    kept = {stream.index for stream in wanted}
    for stream in container.streams:
        is_wanted = stream.index in kept
        stream.discard = _Discard.default if is_wanted else _Discard.all


_RIFF_UNKNOWN = (0, 0xFFFFFFFF)


def declared(clip: AnyClip) -> Declared:
    """What the header of a clip declares."""
    with open_clip(clip) as stream:
        head = stream.read(8)
        if head.startswith(b"RIFF") and len(head) == 8:
            size = int.from_bytes(head[4:], "little")
            return Declared(end=0 if size in _RIFF_UNKNOWN else size + 8)
        if head.startswith(EBML):
            return Declared(end=segment_end(stream))
        return declared_in(stream)


@functools.lru_cache(maxsize=16)
def _declared_by(state: FileState) -> Declared:
    return declared(state.path)
