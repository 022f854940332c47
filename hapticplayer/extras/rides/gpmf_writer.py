"""Writes the telemetry of a GoPro-like camera: what `gopro` reads.

A payload a second, as a HERO9 has them: accelerometer and gyro as 16-bit counts in
the stored order Z,X,Y, each stream with the count of its samples so far (TSMP) and
the time of its first one (STMP), beside the shutter's stream, whose first stamp is
the first frame.

Source: github.com/gopro/gpmf-parser, README; scales and order as in real files.
"""

import struct
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model.arrays import Floats

CAMERA = "HERO9 Black"
_ACCL_SCALE, _GYRO_SCALE = 417, 939
_FIRST_PICTURE_US = 1_000_000
_FRAMES_PER_S = 30


def write_payloads(imu: ImuLog) -> Iterator[tuple[float, bytes]]:
    """Yield the media time and the bytes of each second's payload.

    The log's rate is the mean over the interval that ends at each time (INSTANT), so
    that a camera's gyro reads it half a step earlier.
    """
    assert imu.sampling is Sampling.INSTANT
    half_step_s = 0.5 / imu.rate_hz
    streams = (
        ("ACCL", imu.time_s, imu.specific_force_mps2, _ACCL_SCALE),
        ("GYRO", imu.time_s - half_step_s, imu.angular_rate_radps, _GYRO_SCALE),
    )
    for second in range(int(imu.time_s[-1]) + 1):
        parts = []
        for key, time_s, values, scale in streams:
            first = int(np.searchsorted(time_s, second)) if second else 0
            last = int(np.searchsorted(time_s, second + 1.0))
            if last > first:
                counts = np.rint(_stored(values[first:last]) * scale)
                stamp_us = _FIRST_PICTURE_US + round(1e6 * float(time_s[first]))
                parts.append(_stream(key, counts, scale, last, stamp_us))
        parts.append(_shutter(second))
        yield float(second), _nested("DEVC", _text("DVNM", CAMERA), *parts)


def _stored(values: Floats) -> Floats:
    """Return frame A as Z,X,Y of the camera's axes (X left, Y back, Z up)."""
    x, y, z = values.T
    return np.stack([z, -x, -y], axis=1)


def _stream(key: str, counts: Floats, scale: int, total: int, stamp_us: int) -> bytes:
    limited: NDArray[np.int16] = np.clip(counts, -32768, 32767).astype(">i2")
    return _nested(
        "STRM",
        _entry("STMP", "J", 8, struct.pack(">Q", stamp_us)),
        _entry("TSMP", "L", 4, struct.pack(">I", total)),
        _text("ORIN", "ZXY"),
        _entry("SCAL", "s", 2, struct.pack(">h", scale)),
        _entry(key, "s", 6, limited.tobytes()),
    )


def _shutter(second: int) -> bytes:
    exposures = np.full(_FRAMES_PER_S, 1.0 / 480.0, dtype=">f4")
    stamp_us = _FIRST_PICTURE_US + 1_000_000 * second
    return _nested(
        "STRM",
        _entry("STMP", "J", 8, struct.pack(">Q", stamp_us)),
        _entry("SHUT", "f", 4, exposures.tobytes()),
    )


def _text(key: str, value: str) -> bytes:
    return _entry(key, "c", 1, value.encode())


def _nested(key: str, *children: bytes) -> bytes:
    return _entry(key, "\0", 1, b"".join(children))


def _entry(key: str, kind: str, struct_bytes: int, payload: bytes) -> bytes:
    count = len(payload) // struct_bytes
    head = struct.pack(">4scBH", key.encode(), kind.encode(), struct_bytes, count)
    return head + payload + bytes(-len(payload) % 4)
