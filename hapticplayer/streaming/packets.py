"""Force in packets of 128 ms, each of which says what it holds and whether it is whole.

A packet is 24 bytes of header and 128 samples, little-endian: magic `HPF1`, number of the
track, samples, packet, first sample, rate in Hz, CRC-32 of all that and of the samples;
then three float32 in N per sample (frame D). The last packet is filled up with zeros.
"""

import struct
import zlib
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.streamed_track import PACKET_SAMPLES, RATE_HZ
from hapticplayer.model import ForceTrack

_MAGIC = b"HPF1"
_HEADER = struct.Struct("<4sHHIII")
_CHECKSUM = struct.Struct("<I")
_SAMPLES_AT = _HEADER.size + _CHECKSUM.size
PACKET_BYTES = _SAMPLES_AT + 12 * PACKET_SAMPLES


class Packet(NamedTuple):
    """Force (128, 3) float32 in N at the samples from 128 * number on, all finite."""

    number: int
    force_n: NDArray[np.float32]


def packets_of(samples: int) -> int:
    """Return how many packets so many samples need."""
    return -(-samples // PACKET_SAMPLES)


def encoded(track: ForceTrack, track_number: int, packet: int, end: int) -> bytes:
    """Return the packets from one to before another, one after the other."""
    first = packet * PACKET_SAMPLES
    media_s = np.arange(first, end * PACKET_SAMPLES) / RATE_HZ
    force_n = track.at(media_s).astype("<f4")
    return b"".join(
        _encode(track_number, number, force_n[at : at + PACKET_SAMPLES].tobytes())
        for at, number in zip(
            range(0, len(force_n), PACKET_SAMPLES), range(packet, end), strict=True
        )
    )


def _encode(track_number: int, number: int, samples: bytes) -> bytes:
    header = _HEADER.pack(
        _MAGIC,
        track_number,
        PACKET_SAMPLES,
        number,
        number * PACKET_SAMPLES,
        int(RATE_HZ),
    )
    return header + _CHECKSUM.pack(zlib.crc32(samples, zlib.crc32(header))) + samples


def decoded(content: bytes, track_number: int, packets: int) -> Iterator[Packet]:
    """Yield what is whole of a row of packets, in the order in which they come.

    Args:
        content: from outside; what is damaged or of another track is left out.
        track_number: of the track that was asked for.
        packets: of the whole track.
    """
    for at in range(0, len(content) - PACKET_BYTES + 1, PACKET_BYTES):
        packet = _decode(content[at : at + PACKET_BYTES], track_number)
        if packet is not None and packet.number < packets:
            yield packet


def _decode(content: bytes, track_number: int) -> Packet | None:
    header, samples = content[: _HEADER.size], content[_SAMPLES_AT:]
    magic, track, count, number, first, rate_hz = _HEADER.unpack(header)
    (checksum,) = _CHECKSUM.unpack_from(content, _HEADER.size)
    is_expected = (magic, track, count, first, rate_hz) == (
        _MAGIC,
        track_number,
        PACKET_SAMPLES,
        number * PACKET_SAMPLES,
        RATE_HZ,
    )
    if not is_expected or zlib.crc32(samples, zlib.crc32(header)) != checksum:
        return None
    force_n = np.frombuffer(samples, "<f4").reshape(-1, 3).astype(np.float32)
    return Packet(number, force_n) if np.isfinite(force_n).all() else None
