"""Adds a GoPro-like telemetry track to a clip: for the simulator and the tests."""

import os
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import av
from av.container import InputContainer, OutputContainer
from av.packet import Packet
from av.stream import Stream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.opening import media_errors, open_media, origin_s
from hapticplayer.media.telemetry import HANDLER, TelemetryPacket

_TICKS_PER_S = 1000
"""GoPro's own time base for the track."""


def add_telemetry(
    source: str | os.PathLike[str],
    target: str | os.PathLike[str],
    packets: Sequence[TelemetryPacket],
) -> None:
    """Copy a clip without encoding it again, with a telemetry track beside it.

    Args:
        source: a clip with video.
        target: the MP4 file to write; another one than `source`.
        packets: payloads (GPMF) with media times.

    Raises:
        MediaError: when the clip cannot be read or the file not written.
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
