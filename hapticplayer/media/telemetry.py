"""A camera's telemetry packets: taken out of a clip without reading its video, or added."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import av
from av.container import InputContainer, OutputContainer
from av.packet import Packet
from av.stream import DataStream, Stream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.mp4 import ClipTrack, tracks_of
from hapticplayer.media.opening import media_errors, open_media, origin_s, read_only
from hapticplayer.model.limits import (
    MAX_TELEMETRY_BYTES,
    MAX_TELEMETRY_PACKET_BYTES,
    MAX_TELEMETRY_PACKETS,
)
from hapticplayer.untrusted import COPY_AGAIN

_TICKS_PER_S = 1000
"""GoPro's own time base for the track."""

HANDLER = "GoPro MET"
"""In the track's handler name, after a length byte or a tab."""


@dataclass(frozen=True, slots=True)
class TelemetryPacket:
    """One payload of a camera's telemetry track, as the camera wrote it.

    It covers a span of media time, whose duration is nominal in the last payload.
    """

    start_s: float
    duration_s: float
    payload: bytes


def find_telemetry(container: InputContainer) -> DataStream | None:
    """Return the camera's motion track, or None."""
    for stream in container.streams.data:
        if HANDLER in stream.metadata.get("handler_name", ""):
            return stream
    return None


def data_tracks(path: str | os.PathLike[str]) -> tuple[ClipTrack, ...]:
    """The tracks of an MP4 that are neither video nor sound; MediaError if unreadable."""
    open_media(path).close()
    return tuple(t for t in tracks_of(path) if t.kind not in {"vide", "soun"})


def read_telemetry_packets(path: str | os.PathLike[str]) -> list[TelemetryPacket]:
    """Return the telemetry payloads of a clip in the order they are stored.

    A clip without a telemetry track gives an empty list. Video and sound are not read
    from disk: 0.1 s for 43 min in 810 MB.
    """
    with (
        open_media(path) as container,
        media_errors(path, Message("its telemetry track is damaged")),
    ):
        stream = find_telemetry(container)
        if stream is None:
            return []
        # asked of the index itself: a few bytes declare millions of entries
        _check_limits(0, 0, len(stream.index_entries) - 1, path)
        read_only(container, stream)
        start_s, tick = origin_s(container), stream.time_base or Fraction(0)
        found: list[TelemetryPacket] = []
        total_bytes = 0
        for packet in container.demux(stream):
            if packet.size == 0 or packet.pts is None:
                continue
            total_bytes += packet.size
            _check_limits(packet.size, total_bytes, len(found), path)
            begin_s = float(packet.pts * tick) - start_s
            length_s = float((packet.duration or 0) * tick)
            found.append(TelemetryPacket(begin_s, length_s, bytes(packet)))
        return found


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
        track.codec_tag = "gpmd"
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
