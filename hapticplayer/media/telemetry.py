"""A camera's telemetry packets: taken out of a clip without reading its video, or added."""

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import av
from av.container import InputContainer, OutputContainer
from av.packet import Packet
from av.stream import DataStream, Stream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_bytes import AnyClip
from hapticplayer.media.mp4 import ClipTrack, Edit, hidden_s, shown_at, tracks_of
from hapticplayer.media.opening import media_errors, open_media, origin_s, read_only
from hapticplayer.model.limits import (
    MAX_TELEMETRY_BYTES,
    MAX_TELEMETRY_PACKET_BYTES,
    MAX_TELEMETRY_PACKETS,
)
from hapticplayer.untrusted import COPY_AGAIN

_TICKS_PER_S = 1000
"""GoPro's own time base for the track."""

HANDLER, MARK = "GoPro MET", "gpmd"
"""In the track's handler name, after a length byte or a tab; of its samples."""

RAW_MAGIC = b"DEVC"
"""With which GPMF begins."""

_ANY_METADATA = frozenset({"", "mebx", "mett", "metx"})
"""Marks that leave open whose it is (ISO/IEC 14496-12, 12.3.3; QuickTime)."""


@dataclass(frozen=True, slots=True)
class TelemetryPacket:
    """One payload of a camera's telemetry track, as the camera wrote it.

    It covers a span of media time, whose duration is nominal in the last payload.
    """

    start_s: float
    duration_s: float
    payload: bytes


def is_gopro(track: ClipTrack) -> bool:
    """Whether a track is GPMF; other programs change its name, and its mark."""
    is_named = track.mark == MARK or HANDLER in track.name
    is_open = track.mark in _ANY_METADATA
    return is_named or (is_open and track.begins.startswith(RAW_MAGIC))


def find_telemetry(container: InputContainer, clip: AnyClip) -> DataStream | None:
    """Return the camera's motion track, or None."""
    if not container.streams.data:
        return None
    numbers = {track.number for track in tracks_of(clip) if is_gopro(track)}
    return next((one for one in container.streams.data if one.id in numbers), None)


def data_tracks(path: str | os.PathLike[str]) -> tuple[ClipTrack, ...]:
    """The tracks of an MP4 that are neither video nor sound; MediaError if unreadable."""
    open_media(path).close()
    return tuple(t for t in tracks_of(path) if t.kind not in {"vide", "soun"})


def read_telemetry_packets(path: str | os.PathLike[str]) -> list[TelemetryPacket]:
    """Return the telemetry payloads of a clip in the order they are stored.

    A clip without a telemetry track gives an empty list. Video and sound are not read
    from disk: 0.1 s for 43 min in 810 MB.
    """
    damaged = Message("its telemetry track is damaged")
    with open_media(path) as container, media_errors(path, damaged):
        stream = find_telemetry(container, path)
        if stream is None:
            return []
        # asked of the index itself: a few bytes declare millions of entries
        _check_limits(0, 0, len(stream.index_entries) - 1, path)
        start_s = origin_s(container)
        edits = _edits_of(path, stream)
        if not edits:
            return list(_packets(container, stream, start_s, path))
    with (
        open_media(path, has_edits=False) as container,
        media_errors(path, damaged),
    ):
        track = find_telemetry(container, path)
        assert track is not None
        found = _packets(container, track, 0.0, path)
        places = [(p, shown_at(edits, p.start_s, p.duration_s)) for p in found]
    shown = [replace(p, start_s=at - start_s) for p, at in places if at is not None]
    return sorted(shown, key=lambda packet: packet.start_s)


def _edits_of(path: str | os.PathLike[str], stream: Stream) -> tuple[Edit, ...]:
    """The edit list of a track, empty where it changes nothing.

    FFmpeg shifts telemetry by whole packets, which are 1 s long.
    """
    own = [track.edits for track in tracks_of(path) if track.number == stream.id]
    edits = own[0] if own else ()
    is_plain = len(edits) == 1 and edits[0][1:] == (0.0, 1.0)
    return () if is_plain else edits


def _packets(
    container: InputContainer,
    stream: DataStream,
    start_s: float,
    path: str | os.PathLike[str],
) -> Iterator[TelemetryPacket]:
    read_only(container, stream)
    tick, total_bytes, count = stream.time_base or Fraction(0), 0, 0
    for packet in container.demux(stream):
        if packet.size == 0 or packet.pts is None:
            continue
        total_bytes += packet.size
        _check_limits(packet.size, total_bytes, count, path)
        count += 1
        begin_s = float(packet.pts * tick) - start_s
        length_s = float((packet.duration or 0) * tick)
        yield TelemetryPacket(begin_s, length_s, bytes(packet))


def hidden_start_s(path: str | os.PathLike[str]) -> float:
    """How much of the video an edit list hides at its beginning, but not of the motion.

    0 where the telemetry has an edit list of its own.
    """
    tracks = tracks_of(path)
    telemetry = next((one for one in tracks if is_gopro(one)), None)
    video = next((one for one in tracks if one.kind == "vide"), None)
    if telemetry is None or video is None or hidden_s(telemetry):
        return 0.0
    return hidden_s(video)


def _check_limits(
    size_bytes: int, total_bytes: int, count: int, path: str | os.PathLike[str]
) -> None:
    if (
        size_bytes > MAX_TELEMETRY_PACKET_BYTES
        or total_bytes > MAX_TELEMETRY_BYTES
        or count >= MAX_TELEMETRY_PACKETS
    ):
        raise MediaError(
            "its telemetry is larger than any camera's (payload {count} has "
            "{size_bytes} bytes)",
            where=str(path),
            remedy=COPY_AGAIN,
            count=count,
            size_bytes=size_bytes,
        )


def add_telemetry(
    source: str | os.PathLike[str],
    target: str | os.PathLike[str],
    packets: Sequence[TelemetryPacket],
) -> None:
    """Copy a clip without encoding it again, with a telemetry track beside it.

    The target is an MP4 file, another one than the source; the payloads are GPMF.
    """
    if Path(source).resolve() == Path(target).resolve():
        raise MediaError("a clip cannot be copied onto itself", where=str(target))
    with (
        open_media(source) as clip,
        media_errors(
            target, Message("cannot be written"), Message("choose another folder")
        ),
        av.open(
            str(target), "w", format="mp4", options={"movflags": "+faststart"}
        ) as copy,
    ):
        streams = {
            stream.index: copy.add_stream_from_template(stream)
            for stream in (*clip.streams.video, *clip.streams.audio)
        }
        track = copy.add_data_stream("bin_data")
        track.codec_tag = MARK
        track.metadata["handler_name"] = f"\t{HANDLER}"
        track.time_base = Fraction(1, _TICKS_PER_S)
        for packet in packets:
            copy.mux(_data_packet(packet, track, origin_s(clip)))
        _copy_packets(clip, copy, streams)


def _data_packet(
    packet: TelemetryPacket, track: Stream, start_s: float
) -> "Packet[Stream]":
    data = Packet(packet.payload)
    data.stream = track
    data.pts = data.dts = round((packet.start_s + start_s) * _TICKS_PER_S)
    data.duration = round(packet.duration_s * _TICKS_PER_S)
    data.time_base = Fraction(1, _TICKS_PER_S)
    return data


def _copy_packets(
    clip: InputContainer, copy: OutputContainer, streams: dict[int, Stream]
) -> None:
    for packet in clip.demux():
        if packet.dts is not None and packet.stream_index in streams:
            packet.stream = streams[packet.stream_index]
            copy.mux(packet)
