"""Reads the motion that GoPro cameras embed in their recordings.

Accelerometer and gyro have clocks of their own; the log has the accelerometer's
times, and the gyro becomes the mean rate over each of its intervals. Time 0 is the
first picture.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hapticplayer.capture.cleaning import clean
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
from hapticplayer.capture.gpmf import text_of
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
        return _read(packets, source, has_packet_times=has_packet_times)
    except TelemetryError as error:
        if error.where:
            raise
        remedy = error.remedy or "copy the recording again from the camera"
        raise TelemetryError(error.what, where=source, remedy=remedy) from error


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
    accelerometer = _require(collect(payloads, "ACCL"), "accelerometer", camera)
    gyro = _require(collect(payloads, "GYRO"), "gyro", camera)
    _refuse_time_lapse(accelerometer)
    frame0_us = first_stamp_us(payloads, _FRAME_KEYS)
    force_times = sample_times(
        accelerometer, frame0_us, has_packet_times=has_packet_times
    )
    rate_times = sample_times(gyro, frame0_us, has_packet_times=has_packet_times)
    force = _in_frame_a(accelerometer, camera, MAX_ACCELERATION_MPS2, "m/s2")
    rate = _in_frame_a(gyro, camera, MAX_ANGULAR_RATE_RADPS, "rad/s")
    rows, mean = mean_rate_with_holes(force_times.time_s, rate_times.time_s, rate)
    if len(rows) < 2:
        raise TelemetryError("its accelerometer and gyro do not overlap in time")
    time_s = force_times.time_s[rows]
    field, field_notes = magnetic_field(
        payloads, time_s, frame0_us, has_packet_times=has_packet_times
    )
    imu, repairs = _cleaned(time_s, force[rows], mean, field, source)
    gravity_time_s, gravity = _gravity(
        payloads, frame0_us, has_packet_times=has_packet_times
    )
    return GoProTelemetry(
        imu=imu,
        camera=camera,
        accelerometer_rate_hz=force_times.rate_hz,
        gyro_rate_hz=rate_times.rate_hz,
        gravity_time_s=gravity_time_s,
        gravity_direction=gravity,
        notes=(
            *_notes(accelerometer, camera, force_times, damaged),
            *field_notes,
            *repairs,
        ),
    )


def _cleaned(
    time_s: Floats, force: Floats, rate: Floats, field: Floats | None, source: str
) -> tuple[ImuLog, tuple[str, ...]]:
    try:
        return clean(time_s, force, rate, field, source=source)
    except InputError as error:
        raise TelemetryError(
            error.what, where=error.where, remedy=error.remedy
        ) from error


def _require(stream: SensorStream | None, name: str, camera: str) -> SensorStream:
    if stream is None or stream.values.shape[1] != 3:
        raise TelemetryError(
            f"its telemetry ({camera}) holds no {name} samples", remedy=OTHER_CAMERA
        )
    return stream


def _refuse_time_lapse(stream: SensorStream) -> None:
    if np.median(stream.counts) < _LEAST_SAMPLES_PER_PAYLOAD:
        raise TelemetryError(
            f"it holds {len(stream.values)} motion samples in {len(stream.counts)} "
            "payloads, as time-lapse recordings do",
            remedy="record normal video",
        )


def _in_frame_a(stream: SensorStream, camera: str, limit: float, unit: str) -> Floats:
    rotation = frame_a_from_stored(stream.first, camera)
    values = np.where(np.isfinite(stream.values), stream.values, np.nan) @ rotation.T
    finite = np.isfinite(values)
    # single samples that are missing are filled in and marked later
    largest = float(np.abs(values[finite]).max()) if finite.any() else np.inf
    if largest > limit:
        raise TelemetryError(
            f"its telemetry claims {largest:.3g} {unit}, beyond what sensors measure"
        )
    return values


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
    stream: SensorStream, camera: str, times: SampleTimes, damaged: int
) -> tuple[str, ...]:
    notes = []
    if not times.is_stamped:
        notes.append(
            "This camera does not stamp its samples: they may lie 10 to 30 ms off "
            "the picture."
        )
    if not is_order_known(stream.first, camera):
        notes.append(
            f"The file does not say how the sensor sits in {camera!r}: the axes of a "
            "HERO5 are assumed."
        )
    if damaged:
        notes.append(f"{damaged} telemetry payloads are damaged; the rest was read.")
    return tuple(notes)
