"""Reads the motion that GoPro cameras embed in their recordings.

Accelerometer and gyro have clocks of their own; the log has the accelerometer's
times, and the gyro becomes the mean rate over each of its intervals. Time 0 is the
first picture.
"""

import contextlib
import gc
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.cleaning import Reals, clean
from hapticplayer.capture.gopro_axes import (
    FRAME_A_FROM_CAMERA,
    frame_a_from_stored,
    is_order_known,
)
from hapticplayer.capture.gopro_magnetometer import magnetic_field
from hapticplayer.capture.gopro_packets import (
    OTHER_CAMERA,
    Packet,
    parse_packets,
    split_raw,
)
from hapticplayer.capture.gopro_streams import (
    Payload,
    SensorStream,
    collect,
    first_stamp_us,
)
from hapticplayer.capture.gopro_timing import SampleTimes, sample_times
from hapticplayer.capture.gpmf import Entry, text_of
from hapticplayer.capture.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_RAW_GPMF_BYTES,
)
from hapticplayer.capture.resample import mean_rate_with_holes
from hapticplayer.errors import InputError, TelemetryError
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

_FRAME_KEYS = ("SHUT", "CORI", "IORI", "ISOE", "WBAL")
"""Streams with one sample per picture; their first stamp is the first picture."""

_LEAST_SAMPLES_PER_PAYLOAD = 10


@dataclass(frozen=True, slots=True, eq=False)
class GoProTelemetry:
    """The motion of a GoPro recording.

    Attributes:
        imu: in frame A, time 0 at the first picture.
        camera: device name.
        accelerometer_rate_hz: measured, not nominal.
        gyro_rate_hz: measured, before it was brought to the accelerometer's times.
        gravity_time_s: (M,) times of the camera's own gravity estimate, or empty.
        gravity_direction: (M, 3) unit, frame A, where the specific force points at
            rest (up); the camera's opinion, which is not the truth.
        notes: what a person should know about the quality.
    """

    imu: ImuLog
    camera: str
    accelerometer_rate_hz: float
    gyro_rate_hz: float
    gravity_time_s: Floats
    gravity_direction: Floats
    notes: tuple[str, ...]


def read_gopro(
    packets: Sequence[Packet], source: str = "", *, has_packet_times: bool = True
) -> GoProTelemetry:
    """Return the motion in GPMF payloads.

    Args:
        packets: in the order of the recording.
        source: the file, for messages and provenance.
        has_packet_times: whether the packets' times were measured.

    Raises:
        TelemetryError: when there is no usable motion, and why.
    """
    try:
        with _uncollected():
            return _read(packets, source, has_packet_times=has_packet_times)
    except TelemetryError as error:
        if error.where:
            raise
        remedy = error.remedy or "copy the recording again from the camera"
        raise TelemetryError(error.what, where=source, remedy=remedy) from error


@contextlib.contextmanager
def _uncollected() -> Iterator[None]:
    """Leave out the search for garbage, which takes a fifth of the time: there is none."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def read_raw_gopro(path: Path) -> GoProTelemetry:
    """Return the motion in a raw GPMF dump (`.gpmf`, `.bin`, `.raw`).

    Raises:
        TelemetryError: when there is no usable motion, and why.
    """
    size_bytes = path.stat().st_size
    if size_bytes > MAX_RAW_GPMF_BYTES:
        raise TelemetryError(f"has {size_bytes} bytes, too many", where=str(path))
    packets = split_raw(path.read_bytes())
    return read_gopro(packets, str(path), has_packet_times=False)


def _read(
    packets: Sequence[Packet], source: str, *, has_packet_times: bool
) -> GoProTelemetry:
    payloads, damaged = parse_packets(packets)
    camera = text_of(payloads[0].device.find("DVNM")) or "GoPro"
    clock = _Clock(first_stamp_us(payloads, _FRAME_KEYS), has_packet_times)
    force = _sensor(payloads, _FORCE, camera, clock)
    rate = _sensor(payloads, _RATE, camera, clock)
    force_times, force_first = force.times, force.first
    rows, mean = mean_rate_with_holes(
        force_times.time_s, rate.times.time_s, rate.values
    )
    if len(rows) < 2:
        raise TelemetryError("its accelerometer and gyro do not overlap in time")
    covered = slice(rows[0], rows[-1] + 1)  # they follow one another
    time_s, gyro_rate_hz = force_times.time_s[covered], rate.times.rate_hz
    field, field_notes = magnetic_field(
        payloads, time_s, clock.frame0_us, has_packet_times=has_packet_times
    )
    gravity_time_s, gravity = _gravity(
        payloads, clock.frame0_us, has_packet_times=has_packet_times
    )
    # no sensor has the 24 bits of float32, and ten hours fill half a gigabyte
    small = force.values[covered].astype(np.float32), mean.astype(np.float32)
    del force, rate, mean, payloads
    imu, repairs = _cleaned(time_s, *small, field, source)
    return GoProTelemetry(
        imu=imu,
        camera=camera,
        accelerometer_rate_hz=force_times.rate_hz,
        gyro_rate_hz=gyro_rate_hz,
        gravity_time_s=gravity_time_s,
        gravity_direction=gravity,
        notes=(
            *_notes(force_first, camera, force_times, damaged),
            *field_notes,
            *repairs,
        ),
    )


def _cleaned(
    time_s: Floats, force: Reals, rate: Reals, field: Floats | None, source: str
) -> tuple[ImuLog, tuple[str, ...]]:
    try:
        return clean(time_s, force, rate, field, source=source)
    except InputError as error:
        raise TelemetryError(
            error.what, where=error.where, remedy=error.remedy
        ) from error


class _Clock(NamedTuple):
    """What the times of all sensors are measured by."""

    frame0_us: float | None
    has_packet_times: bool


class _Kind(NamedTuple):
    """A sensor, and what no such sensor measures."""

    key: str
    name: str
    limit: float
    unit: str


_FORCE = _Kind("ACCL", "accelerometer", MAX_ACCELERATION_MPS2, "m/s2")
_RATE = _Kind("GYRO", "gyro", MAX_ANGULAR_RATE_RADPS, "rad/s")


class _Sensor(NamedTuple):
    """A sensor's samples in frame A, their times and its first STRM entry."""

    times: SampleTimes
    values: Floats
    first: Entry


def _sensor(
    payloads: Sequence[Payload], kind: _Kind, camera: str, clock: _Clock
) -> _Sensor:
    stream = collect(payloads, kind.key)
    if stream is None or stream.values.shape[1] != 3:
        raise TelemetryError(
            f"its telemetry ({camera}) holds no {kind.name} samples",
            remedy=OTHER_CAMERA,
        )
    if kind is _FORCE:
        _refuse_time_lapse(stream)
    times = sample_times(
        stream, clock.frame0_us, has_packet_times=clock.has_packet_times
    )
    return _Sensor(times, _in_frame_a(stream, camera, kind), stream.first)


def _refuse_time_lapse(stream: SensorStream) -> None:
    if np.median(stream.counts) < _LEAST_SAMPLES_PER_PAYLOAD:
        raise TelemetryError(
            f"it holds {len(stream.values)} motion samples in {len(stream.counts)} "
            "payloads, as time-lapse recordings do",
            remedy="record normal video",
        )


def _in_frame_a(stream: SensorStream, camera: str, kind: _Kind) -> Floats:
    rotation = frame_a_from_stored(stream.first, camera)
    values, largest = stream.values, _largest(stream.values)
    if not np.isfinite(largest):
        # single samples that are missing are filled in and marked later
        is_finite = np.isfinite(values)
        values = np.where(is_finite, values, np.nan)
        largest = float(np.nanmax(np.abs(values))) if is_finite.any() else np.inf
    values = _turned(values, rotation)
    if largest > kind.limit or np.isnan(largest):
        raise TelemetryError(
            f"its telemetry claims {largest:.3g} {kind.unit}, beyond what sensors "
            "measure"
        )
    return values


def _largest(values: Floats) -> float:
    """Return the largest size, not finite where one is not."""
    return max(float(values.max()), -float(values.min())) if values.size else np.inf


def _turned(values: Floats, rotation: Floats) -> Floats:
    """Return values @ rotation.T; where axes are only exchanged, in a fifth of the time."""
    source = np.argmax(np.abs(rotation), axis=1)
    signs = rotation[np.arange(3), source]
    if not np.array_equal(rotation, signs[:, None] * np.eye(3)[source]):
        return values @ rotation.T
    turned = np.empty_like(values)
    for column, (at, sign) in enumerate(zip(source, signs, strict=True)):
        np.multiply(values[:, at], sign, out=turned[:, column])
    return turned


def _gravity(
    payloads: Sequence[Payload], frame0_us: float | None, *, has_packet_times: bool
) -> tuple[Floats, Floats]:
    """Return times (M,) and directions (M, 3) of GRAV; HERO8 leaves it all zero.

    Its three values are the direction of the specific force along the camera's
    X, Z and Y (measured on MAX, HERO9 and HERO11).
    """
    stream = collect(payloads, "GRAV")
    if stream is None or stream.values.shape[1] != 3 or len(stream.values) < 2:
        return np.zeros(0), np.zeros((0, 3))
    times = sample_times(stream, frame0_us, has_packet_times=has_packet_times)
    camera_xyz = stream.values[:, [0, 2, 1]]
    norms = np.linalg.norm(camera_xyz, axis=1)
    is_given = norms > 0.5
    unit = camera_xyz[is_given] / norms[is_given, None]
    return times.time_s[is_given], unit @ FRAME_A_FROM_CAMERA.T


def _notes(
    stream: Entry, camera: str, times: SampleTimes, damaged: int
) -> tuple[str, ...]:
    notes = []
    if not times.is_stamped:
        notes.append(
            "This camera does not stamp its samples: they may lie 10 to 30 ms off "
            "the picture."
        )
    if not is_order_known(stream, camera):
        notes.append(
            f"The file does not say how the sensor sits in {camera!r}: the axes of a "
            "HERO5 are assumed."
        )
    if damaged:
        notes.append(f"{damaged} telemetry payloads are damaged; the rest was read.")
    return tuple(notes)
