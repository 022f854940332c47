"""Takes a camera's motion packets out of a video without reading the video."""

import os
from dataclasses import dataclass
from fractions import Fraction

from av.container import InputContainer
from av.stream import DataStream

from hapticplayer.errors import MediaError
from hapticplayer.media.files import COPY_AGAIN
from hapticplayer.media.limits import (
    MAX_TELEMETRY_BYTES,
    MAX_TELEMETRY_PACKET_BYTES,
    MAX_TELEMETRY_PACKETS,
)
from hapticplayer.media.opening import (
    media_errors,
    open_media,
    origin_s,
    read_only,
)

HANDLER = "GoPro MET"
"""In the track's handler name, after a length byte or a tab."""


@dataclass(frozen=True, slots=True)
class TelemetryPacket:
    """One payload of a camera's telemetry track.

    Attributes:
        start_s: media time of the span it covers.
        duration_s: length of that span; nominal in the last payload.
        payload: the bytes as the camera wrote them.
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


def data_track_names(path: str | os.PathLike[str]) -> tuple[str, ...]:
    """Return the names of a clip's data tracks, to tell why there is no motion.

    Raises:
        MediaError: when the file cannot be opened.
    """
    with open_media(path) as container:
        names = [s.metadata.get("handler_name", "") for s in container.streams.data]
    return tuple(name.strip("\t\v\0 ") for name in names)


def read_telemetry_packets(path: str | os.PathLike[str]) -> list[TelemetryPacket]:
    """Return the telemetry payloads of a clip in the order they are stored.

    A clip without a telemetry track gives an empty list. Pictures and sound are
    not read from disk: 25 ms for 782 MB.

    Raises:
        MediaError: when the file cannot be opened, or its telemetry is damaged or
            larger than the limits.
    """
    with (
        open_media(path) as container,
        media_errors(path, "its telemetry track is damaged"),
    ):
        stream = find_telemetry(container)
        if stream is None:
            return []
        start_s = origin_s(container)
        read_only(container, stream)
        base = (stream.time_base or Fraction(0)).as_integer_ratio()
        packets: list[TelemetryPacket] = []
        total_bytes = 0
        for packet in container.demux(stream):
            size_bytes, pts = packet.size, packet.pts
            if size_bytes == 0 or pts is None:
                continue
            total_bytes += size_bytes
            _check_limits(size_bytes, total_bytes, len(packets), path)
            packets.append(
                TelemetryPacket(
                    start_s=pts * base[0] / base[1] - start_s,
                    duration_s=(packet.duration or 0) * base[0] / base[1],
                    payload=bytes(packet),
                )
            )
        return packets


def _check_limits(
    size_bytes: int, total_bytes: int, count: int, path: str | os.PathLike[str]
) -> None:
    if (
        size_bytes > MAX_TELEMETRY_PACKET_BYTES
        or total_bytes > MAX_TELEMETRY_BYTES
        or count >= MAX_TELEMETRY_PACKETS
    ):
        raise MediaError(
            f"its telemetry is larger than any camera's (payload {count} has "
            f"{size_bytes} bytes)",
            where=str(path),
            remedy=COPY_AGAIN,
        )
