"""Parses a GoPro's telemetry packets and keeps those of the camera itself.

A drone or a gimbal may write into the same track as a device of its own.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from hapticplayer.capture.gopro_streams import Payload, streams_of
from hapticplayer.capture.gpmf import Entry, parse
from hapticplayer.capture.limits import MAX_PAYLOADS
from hapticplayer.errors import TelemetryError

RAW_MAGIC = b"DEVC"

RAW_PAYLOAD_S = 1.001
"""Length of a payload where a raw dump does not tell: 30 frames at 29.97 Hz."""

OTHER_CAMERA = "record with a camera that stores its motion, or give an IMU log"


class Packet(Protocol):
    """What is needed of a telemetry packet (`media.TelemetryPacket` has it)."""

    @property
    def start_s(self) -> float:
        """Media time of the span it covers."""
        ...

    @property
    def duration_s(self) -> float:
        """Length of that span."""
        ...

    @property
    def payload(self) -> bytes:
        """GPMF."""
        ...


@dataclass(frozen=True, slots=True)
class RawPacket:
    """A payload of a raw dump with an assumed time."""

    start_s: float
    duration_s: float
    payload: bytes


def split_raw(content: bytes) -> list[RawPacket]:
    """Cut a dump into its DEVC entries, which follow one another."""
    packets: list[RawPacket] = []
    offset = 0
    while content[offset : offset + 4] == RAW_MAGIC and offset + 8 <= len(content):
        struct_bytes = content[offset + 5]
        repeat = int.from_bytes(content[offset + 6 : offset + 8], "big")
        end = offset + 8 + -(-struct_bytes * repeat // 4) * 4
        start_s = len(packets) * RAW_PAYLOAD_S
        packets.append(RawPacket(start_s, RAW_PAYLOAD_S, content[offset:end]))
        offset = end
    return packets


def parse_packets(packets: Sequence[Packet]) -> tuple[list[Payload], int]:
    """Return the payloads of the device with the accelerometer, and the damaged ones.

    Raises:
        TelemetryError: when no device has an accelerometer.
    """
    if len(packets) > MAX_PAYLOADS:
        raise TelemetryError(f"has {len(packets)} telemetry payloads, too many")
    parsed = [(packet, parse(packet.payload)) for packet in packets]
    camera = next((d for _, root in parsed for d in _devices(root, "ACCL")), None)
    if camera is None:
        raise TelemetryError(
            "its telemetry holds no accelerometer samples", remedy=OTHER_CAMERA
        )
    identity = _identity(camera)
    payloads = [
        Payload(packet.start_s, packet.duration_s, device, streams_of(device))
        for packet, root in parsed
        for device in root.find_all("DEVC")
        if _identity(device) == identity
    ]
    return payloads, sum(root.is_cut for _, root in parsed)


def _devices(root: Entry, key: str) -> Iterator[Entry]:
    for device in root.find_all("DEVC"):
        if any(stream.find(key) for stream in device.find_all("STRM")):
            yield device


def _identity(device: Entry) -> bytes:
    """Return what tells the camera from the drone that carries it."""
    entry = device.find("DVID")
    return b"" if entry is None else bytes(entry.payload)
