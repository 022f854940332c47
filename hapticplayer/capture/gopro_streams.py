"""From a GoPro's telemetry packets to one sensor's samples and time marks.

A drone or a gimbal may write into the same track as another device; only the camera's
entries are kept.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.gpmf import (
    GpmfEntry,
    first_number_of,
    numbers_of,
    parse,
    text_of,
)
from hapticplayer.errors import Message, TelemetryError
from hapticplayer.media.telemetry import RAW_MAGIC, TelemetryPacket
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_PAYLOADS, MAX_SAMPLES

RAW_PAYLOAD_S = 1.001
"""Assumed length of a payload in a raw dump: 30 frames at 29.97 Hz."""

OTHER_CAMERA = Message(
    "record with a camera that stores its motion, or give an IMU log"
)


def split_raw(content: bytes) -> list[TelemetryPacket]:
    """Split a dump into payloads, which hold one DEVC entry of each device.

    A payload ends where a device comes again: a drone or a Bluetooth sensor need not
    be in all of them. A DEVC entry that does not begin with its DVID is a payload.
    """
    starts: list[int] = []
    devices: set[bytes] = set()
    offset = 0
    while content[offset : offset + 4] == RAW_MAGIC and offset + 8 <= len(content):
        device = content[offset + 8 : offset + 20]
        if not starts or device in devices or not device.startswith(b"DVID"):
            starts.append(offset)
            devices = set()
        devices.add(device)
        struct_bytes = content[offset + 5]
        repeat = int.from_bytes(content[offset + 6 : offset + 8], "big")
        offset += 8 + -(-struct_bytes * repeat // 4) * 4
    ends = [*starts, offset][1:]
    return [
        TelemetryPacket(number * RAW_PAYLOAD_S, RAW_PAYLOAD_S, content[begin:end])
        for number, (begin, end) in enumerate(zip(starts, ends, strict=True))
    ]


@dataclass(frozen=True, slots=True)
class GpmfPayload:
    """A parsed GPMF payload.

    Attributes:
        start_s: media time of its start.
        device: the camera's DEVC entry.
        streams: by key, the first STRM entry that holds it.
    """

    start_s: float
    device: GpmfEntry
    streams: dict[str, GpmfEntry]


def parse_packets(packets: Sequence[TelemetryPacket]) -> tuple[list[GpmfPayload], int]:
    """Return the payloads of the device with the accelerometer, and how many are damaged."""
    if len(packets) > MAX_PAYLOADS:
        raise TelemetryError(
            "has {count} telemetry payloads, too many", count=len(packets)
        )
    parsed = [(packet, parse(packet.payload)) for packet in packets]
    camera = next((d for _, root in parsed for d in _devices(root, "ACCL")), None)
    if camera is None:
        raise TelemetryError(
            "its telemetry holds no accelerometer samples", remedy=OTHER_CAMERA
        )
    identity = _identity(camera)
    payloads = [
        GpmfPayload(packet.start_s, device, _streams_of(device))
        for packet, root in parsed
        for device in root.find_all("DEVC")
        if _identity(device) == identity
    ]
    return payloads, sum(root.is_cut for _, root in parsed)


def _devices(root: GpmfEntry, key: str) -> Iterator[GpmfEntry]:
    for device in root.find_all("DEVC"):
        if any(stream.find(key) for stream in device.find_all("STRM")):
            yield device


def _identity(device: GpmfEntry) -> bytes:
    """Return the id of a device, to separate the camera from a drone."""
    entry = device.find("DVID")
    return b"" if entry is None else bytes(entry.payload)


def _streams_of(device: GpmfEntry) -> dict[str, GpmfEntry]:
    """Return the first STRM entry that holds each key."""
    found: dict[str, GpmfEntry] = {}
    for stream in device.find_all("STRM"):
        for child in stream.children:
            found.setdefault(child.key, stream)
    return found


@dataclass(frozen=True, slots=True, eq=False)
class GoproStream:
    """All samples of one sensor with their time marks.

    One row per payload that holds samples of the sensor.

    Attributes:
        values: (N, elements) in SI, in stored order.
        first_index: (P,) index of the payload's first sample, lost samples counted.
        counts: (P,) samples.
        start_s: (P,) media time of the payload's start.
        stamp_us: (P,) the camera's own time of the first sample, or NaN.
        first: the first STRM entry, for its axes.
    """

    values: Floats
    first_index: NDArray[np.int64]
    counts: NDArray[np.int64]
    start_s: Floats
    stamp_us: Floats
    first: GpmfEntry

    @property
    def index(self) -> NDArray[np.int64]:
        """(N,) index of each sample since the start."""
        within = np.arange(len(self.values)) - np.repeat(
            np.cumsum(self.counts) - self.counts, self.counts
        )
        return np.asarray(np.repeat(self.first_index, self.counts) + within)


def collect(payloads: Sequence[GpmfPayload], key: str) -> GoproStream | None:
    """Return a sensor's stream, or None if the recording has none.

    Raises:
        TelemetryError: when the scale is unusable or there are too many samples.
    """
    rows: list[tuple[GpmfPayload, GpmfEntry]] = []
    parts: list[Floats] = []
    for payload in payloads:
        stream = payload.streams.get(key)
        values = np.zeros((0, 0)) if stream is None else _scaled(stream, key)
        if (
            stream
            and values.size
            and values.shape[1] == (parts or [values])[0].shape[1]
        ):
            rows.append((payload, stream))
            parts.append(values)
    if not rows:
        return None
    counts = np.array([len(part) for part in parts], dtype=np.int64)
    if counts.sum() > MAX_SAMPLES:
        raise TelemetryError(
            "{key} has {count} samples, too many", key=key, count=counts.sum()
        )
    totals, stamps_us = (
        np.array([first_number_of(stream.find(mark)) for _, stream in rows])
        for mark in ("TSMP", "STMP")
    )
    return GoproStream(
        values=np.concatenate(parts),
        first_index=_first_index(counts, totals),
        counts=counts,
        start_s=np.array([payload.start_s for payload, _ in rows]),
        stamp_us=stamps_us,
        first=rows[0][1],
    )


def first_stamp_us(
    payloads: Sequence[GpmfPayload], keys: Sequence[str]
) -> float | None:
    """Return the camera's time of frame 0: the first stamp of a per-frame stream."""
    for stream in (payloads[0].streams.get(key) for key in keys):
        stamp_us = first_number_of(stream.find("STMP")) if stream else math.nan
        if math.isfinite(stamp_us):
            return stamp_us
    return None


def _scaled(stream: GpmfEntry, key: str) -> Floats:
    """Divide by SCAL, which has one value for all axes or one for each."""
    entry = stream.find(key)
    assert entry is not None  # the stream was found by it
    values = numbers_of(entry, text_of(stream.find("TYPE")))
    scale_entry = stream.find("SCAL")
    if scale_entry is None or not values.size:
        return values
    scale = numbers_of(scale_entry).ravel()
    is_fitting = scale.size in {1, values.shape[1]}
    if not is_fitting or not np.isfinite(scale).all() or (scale == 0.0).any():
        raise TelemetryError(
            "the scale of {key} is damaged ({scale})", key=key, scale=scale[:3].tolist()
        )
    return values / scale


def _first_index(counts: NDArray[np.int64], totals: Floats) -> NDArray[np.int64]:
    """Return the index of each payload's first sample, lost samples counted.

    TSMP counts the samples since the recording began, this payload included; in a later
    chapter it starts high. If it contradicts the payloads (decreases or jumps), only the
    payloads count.
    """
    plain = np.cumsum(counts) - counts
    if not np.isfinite(totals).all():
        return plain
    index = (totals - counts) - (totals[0] - counts[0])
    lost = np.diff(index - plain)
    is_sane = lost.size == 0 or (lost.min() >= 0.0 and lost.sum() <= counts.sum())
    return index.astype(np.int64) if is_sane else plain
