"""Copies the streams of a clip into another container, bit for bit, with files attached.

Whether a copy is the same video is told by `media.identity`.
"""

import itertools
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

import av
from av.container import InputContainer, OutputContainer
from av.stream import DataStream, Stream
from av.video.stream import VideoStream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_bytes import AnyClip
from hapticplayer.media.clip_info import require_video
from hapticplayer.media.identity import ANOTHER, CLOSE_MS, Counter, VideoDigest
from hapticplayer.media.matroska import Attachment
from hapticplayer.media.opening import context_of, media_errors, open_media, read_only
from hapticplayer.media.packets import AnyPacket
from hapticplayer.media.telemetry import HANDLER, MARK, find_telemetry
from hapticplayer.model.limits import MAX_AHEAD_PACKETS

MATROSKA, MP4 = "matroska", "mp4"
_OPTIONS = {
    MATROSKA: {
        "cluster_time_limit": "2000",
        "cues_to_front": "1",
        "fflags": "+bitexact",  # no random identifiers: the same bytes each time
    },
    MP4: {"movflags": "+faststart+use_metadata_tags"},
}
"""The index comes first: a player of a web server's file need not leap to the end."""
REPORT_BYTES = 4 << 20
"""Between two reports."""

Report = Callable[[float], None]
"""Called with the done fraction; raises Cancelled to stop."""


class Additions(NamedTuple):
    """What a copy holds beside video and sound.

    Attributes:
        attached: files, in Matroska.
        metadata: texts by key, of the file; those of the clip are not kept.
        with_motion: whether an MP4 keeps a GoPro's motion track, which also holds places.
    """

    attached: tuple[Attachment, ...] = ()
    metadata: Mapping[str, str] = MappingProxyType({})
    with_motion: bool = False


NOTHING_MORE = Additions()


def video_payload(
    path: str | os.PathLike[str], report: Report = lambda _share: None
) -> VideoDigest:
    """Return the identity of the video of a clip, reporting the done fraction.

    39 MB in 0.09 s on a 2 GHz server.
    """
    whole, done = max(1, Path(path).stat().st_size), 0
    with _counted(path) as (_, counter, packets):
        for packet in packets:
            counter.add(packet)
            done += packet.size
            if done % REPORT_BYTES < packet.size:
                report(min(1.0, done / whole))
        return counter.digest()


def other_head(clip: AnyClip, expected: VideoDigest) -> Message | None:
    """How a video does not begin like the expected one, or is not as long; None if it does.

    Where its index tells where they are, some key frames are compared, too.
    """
    with _counted(clip) as (container, counter, packets):
        for packet in packets:
            counter.add(packet)
            if counter.has_head:
                break
        if counter.promised not in (0, expected.packets):
            return ANOTHER
        why = expected.other_head(counter.digest(), counter.ends_ms)
        return why or _other_key(container, counter, expected)


def _other_key(
    container: InputContainer, counter: Counter, expected: VideoDigest
) -> Message | None:
    video = counter.video
    container.seek(0, stream=video)  # Matroska's index is read now
    known = [entry.timestamp for entry in video.index_entries[-1:]]
    for at_ms, sha256 in expected.keys:
        ticks = counter.ticks(at_ms)
        if ticks > max(known, default=0):
            return None  # FFmpeg would read everything up to there
        container.seek(ticks, stream=video)
        near = itertools.islice(container.demux(video), MAX_AHEAD_PACKETS)
        until = (one for one in near if abs(counter.at_ms(one) - at_ms) <= CLOSE_MS)
        found = next(until, None)
        if found is None or counter.sha256(found) != sha256:
            return ANOTHER
    return None


@contextmanager
def _counted(
    clip: AnyClip,
) -> Iterator[tuple[InputContainer, Counter, Iterator[AnyPacket]]]:
    """Yield the packets that tell a clip's identity, and what takes them."""
    with (
        open_media(clip) as container,
        media_errors(clip, Message("its video cannot be read")),
    ):
        counter = Counter(container, require_video(container, clip))
        read_only(container, *counter.streams)
        packets = container.demux(counter.streams)
        yield container, counter, (packet for packet in packets if packet.size)


def remux(
    source: str | os.PathLike[str],
    target: str | os.PathLike[str],
    container_format: str,
    additions: Additions = NOTHING_MORE,
    report: Report = lambda _share: None,
) -> VideoDigest:
    """Copy the first video and all sound into a new file; return the video's checksum.

    Nothing is encoded. Matroska rounds times to 1 ms.

    Args:
        source: the clip.
        target: the new file.
        container_format: MATROSKA or MP4.
        additions: what it holds beside them.
        report: called with the done fraction.
    """
    whole = max(1, Path(source).stat().st_size)
    with (
        open_media(source) as clip,
        media_errors(
            target,
            Message("its streams cannot be copied into {kind}", kind=container_format),
            Message("choose the other kind of file, or convert the clip first"),
        ),
        av.open(
            str(target),
            "w",
            format=container_format,
            options=_OPTIONS[container_format],
        ) as copy,
    ):
        video = require_video(clip, source)
        has_motion = additions.with_motion and container_format == MP4
        motion = find_telemetry(clip, source) if has_motion else None
        sound = (one for one in clip.streams.audio if context_of(one))
        streams = _added([video, *sound, *([motion] if motion else [])], copy)
        copy.metadata.update(additions.metadata)
        for one in additions.attached:
            copy.add_attachment(one.name, one.media_type, one.content)
        return _copy(
            clip, streams, copy, video, lambda done: report(min(1.0, done / whole))
        )


def write_attachments(target: Path, attached: Iterable[Attachment]) -> None:
    """Write a Matroska file that holds nothing but attached files."""
    what, remedy = Message("cannot be written"), Message("choose another folder")
    with (
        media_errors(target, what, remedy),
        av.open(str(target), "w", format=MATROSKA) as file,
    ):
        for one in attached:
            file.add_attachment(one.name, one.media_type, one.content)
        file.start_encoding()


def _added(kept: list[Stream], copy: OutputContainer) -> dict[int, Stream]:
    streams: dict[int, Stream] = {}
    for stream in kept:
        if isinstance(stream, DataStream):
            track = copy.add_data_stream("bin_data")
            track.codec_tag = MARK
            track.metadata["handler_name"] = f"\t{HANDLER}"
            track.time_base = stream.time_base
            streams[stream.index] = track
        else:
            streams[stream.index] = copy.add_stream_from_template(stream)
    return streams


def _copy(
    clip: InputContainer,
    streams: Mapping[int, Stream],
    copy: OutputContainer,
    video: VideoStream,
    report: Report,
) -> VideoDigest:
    counter, done = Counter(clip, video), 0
    wanted = [stream for stream in clip.streams if stream.index in streams]
    for packet in _with_decoding_times(clip.demux(wanted)):
        if packet.stream_index == video.index and packet.is_discard:
            raise MediaError(
                "its beginning is hidden by an edit list, which no copy keeps",
                where=clip.name,
                remedy="convert it to MP4 (H.264 and AAC) and import it again",
            )
        counter.add(packet)
        done += packet.size
        packet.stream = streams[packet.stream_index]
        copy.mux(packet)
        if done % REPORT_BYTES < packet.size:
            report(done)
    return counter.digest()


def _with_decoding_times(packets: Iterator[AnyPacket]) -> Iterator[AnyPacket]:
    """Yield the packets that hold something; all with a decoding time.

    Matroska stores none, and FFmpeg knows it only from the third packet or so on.
    """
    held: dict[int, list[AnyPacket]] = {}
    for packet in packets:
        if not packet.size:
            continue
        waiting = held.setdefault(packet.stream_index, [])
        if packet.dts is None:
            waiting.append(packet)
            continue
        for before, one in zip(range(len(waiting), 0, -1), waiting, strict=True):
            one.dts = packet.dts - before
            yield one
        waiting.clear()
        yield packet
    for waiting in held.values():
        for number, one in enumerate(waiting):  # of a few frames, none has a time
            one.dts = (waiting[0].pts or 0) - len(waiting) + number
            yield one
