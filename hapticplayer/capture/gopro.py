"""Reads the motion that GoPro cameras embed in their recordings.

Accelerometer and gyro have clocks of their own; the log has the accelerometer's
times, and the gyro becomes the mean rate over each of its intervals. Time 0 is the
first frame.
"""

import dataclasses
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.assemble import Reals, as_answered
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.clock_lag import ClockLag, unstamped
from hapticplayer.capture.formats import Confidence, Reader
from hapticplayer.capture.gopro_axes import (
    frame_a_from_stored,
    has_own_axes,
    is_order_known,
)
from hapticplayer.capture.gopro_cori import clock_by_cori
from hapticplayer.capture.gopro_placing import PayloadRun, parts_of, placing
from hapticplayer.capture.gopro_streams import (
    OTHER_CAMERA,
    GoproStream,
    collect,
    parse_packets,
    split_raw,
)
from hapticplayer.capture.gopro_timing import SampleTimes, sample_times
from hapticplayer.capture.gpmf import GpmfEntry, text_of
from hapticplayer.capture.log_checks import norm_at_rest
from hapticplayer.capture.recording import Recording, gap_notes
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import (
    SensorStream,
    interpolated,
    mean_rate_with_holes,
)
from hapticplayer.capture.stuck import working
from hapticplayer.errors import InputError, Message, TelemetryError
from hapticplayer.media.telemetry import (
    RAW_MAGIC,
    TelemetryPacket,
    data_tracks,
    hidden_start_s,
    is_gopro,
    read_telemetry_packets,
)
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    MAX_ACCELERATION_MPS2,
    MAX_ANGULAR_RATE_RADPS,
    MAX_RAW_GPMF_BYTES,
    REST_MPS2,
)
from hapticplayer.untrusted import read_regular

_MIN_SAMPLES_PER_PAYLOAD = 10

_SHOWN_SAMPLES = 60_000
"""For the norm at rest: five minutes."""


def recognises(source: LogSource) -> Confidence:
    """A GoPro telemetry track in a video, or the magic of a raw dump."""
    if source.is_one_file and _is_raw(source):
        return Confidence.CERTAIN
    tracks = data_tracks(source.path) if source.is_binary else ()
    return Confidence.CERTAIN if any(map(is_gopro, tracks)) else Confidence.NO


def _is_raw(source: LogSource) -> bool:
    return source.beginning(source.names[0]).startswith(RAW_MAGIC)


def read(source: LogSource, choices: LogChoices) -> Recording:
    """Return the motion in a video, or in a raw dump (`.gpmf`, `.bin`, `.raw`).

    Raises:
        TelemetryError: when there is no usable motion.
    """
    path, where = source.path, str(source.path)
    if not _is_raw(source):
        packets = read_telemetry_packets(path)
        found = read_gopro(packets, where, hidden_s=hidden_start_s(path))
        return as_answered(found, choices)
    content = read_regular(path, MAX_RAW_GPMF_BYTES, TelemetryError)
    return as_answered(read_gopro(split_raw(content), where, is_raw=True), choices)


READER = Reader(recognises, read)


def read_gopro(
    packets: Sequence[TelemetryPacket],
    source: str = "",
    *,
    is_raw: bool = False,
    hidden_s: float = 0.0,
) -> Recording:
    """Return the motion in GPMF payloads.

    Args:
        packets: in the order of the recording.
        source: the file, for messages and provenance.
        is_raw: the packets' times are assumed, not measured.
        hidden_s: of the video's beginning, but not of the motion's, by an edit list.
    """
    try:
        return _read(packets, source, is_raw=is_raw, hidden_s=hidden_s)
    except InputError as error:
        raise TelemetryError(
            error.what,
            where=error.where or source,
            remedy=error.remedy or Message("copy the recording again from the camera"),
        ) from error


def _read(
    packets: Sequence[TelemetryPacket], source: str, *, is_raw: bool, hidden_s: float
) -> Recording:
    from hapticplayer.motion.repair import repair_samples  # brings scipy along

    payloads, damaged = parse_packets(packets)
    camera = text_of(payloads[0].device.find("DVNM")) or "GoPro"
    parts = parts_of(payloads, has_packet_times=not is_raw)
    accel = _sensor(parts, _ACCEL, camera)
    rate = _sensor(parts, _RATE, camera)
    times, accel_first = accel.times, accel.first
    field, field_notes = _magnetic_field(parts)
    gyro_rate_hz = rate.times.rate_hz
    span_s = (float(times.time_s[0]), float(times.time_s[-1]))
    streams = working(accel.stream, rate.stream, field, source)
    at_s, gyro = streams.accel.time_s, streams.rate
    rows, mean = mean_rate_with_holes(at_s, gyro.time_s, gyro.values)
    if len(rows) < 2:
        raise TelemetryError("its accelerometer and gyro do not overlap in time")
    covered = slice(rows[0], rows[-1] + 1)  # they follow one another
    time_s = at_s[covered]
    compass = None
    if streams.field is not None:
        compass = interpolated(time_s, streams.field, source)
    # float32: no sensor has 24 bits, and ten hours take half a gigabyte
    small_accel: Reals = streams.accel.values[covered].astype(np.float32)
    small_rate: Reals = mean.astype(np.float32)
    repeats = streams.repeats
    del accel, rate, gyro, mean, streams
    imu, repairs = repair_samples(
        time_s, small_accel, small_rate, compass, source=source
    )
    clock_map, lag = _own_clock(parts, imu, is_stamped=times.is_stamped)
    return Recording(
        imu=imu,
        clock_map=clock_map,
        camera=camera,
        notes=(
            *_how_read(imu),
            *((lag.text,) if lag else ()),
            *_notes(accel_first, camera, damaged),
            *field_notes,
            *repeats.notes,
            *(repair.text for repair in repairs),
            *gap_notes(imu),
        ),
        provenance={
            "reader": "raw GPMF" if is_raw else Message("GPMF track"),
            "accelerometer_rate_hz": round(times.rate_hz, 3),
            "gyro_rate_hz": round(gyro_rate_hz, 3),
            **({"clock_lag": lag.described()} if lag else {}),
            **repeats.provenance,
        },
        lag=lag,
        placing=placing(parts, span_s, hidden_s),
    )


def _own_clock(
    parts: Sequence[PayloadRun], imu: ImuLog, *, is_stamped: bool
) -> tuple[ClockMap, ClockLag | None]:
    if not is_stamped:
        return ClockMap(), unstamped()
    if len(parts) > 1:  # the orientation jumps between them
        return ClockMap(), None
    return clock_by_cori(parts[0].payloads, imu, parts[0].clock) or (ClockMap(), None)


class _SensorKind(NamedTuple):
    """A sensor and its limit."""

    key: str
    name: str
    limit: float
    unit: str


_ACCEL = _SensorKind("ACCL", "accelerometer", MAX_ACCELERATION_MPS2, "m/s2")
_RATE = _SensorKind("GYRO", Message("gyro"), MAX_ANGULAR_RATE_RADPS, "rad/s")


class _SensorSamples(NamedTuple):
    """A sensor's samples in frame A, their times and its first STRM entry."""

    times: SampleTimes
    values: Floats
    first: GpmfEntry

    @property
    def stream(self) -> SensorStream:
        return SensorStream(self.times.time_s, self.values)


def _sensor(
    parts: Sequence[PayloadRun], kind: _SensorKind, camera: str
) -> _SensorSamples:
    """The samples of all parts; one that is too short to be timed is left out."""
    found: list[_SensorSamples] = []
    problem: TelemetryError | None = None
    for part in parts:
        try:
            found.append(_sensor_of(part, kind, camera))
        except TelemetryError as error:
            problem = problem or error
    if not found and problem is not None:
        raise problem
    if len(found) == 1:
        return found[0]
    time_s = np.concatenate([one.times.time_s for one in found])
    order = np.argsort(time_s, kind="stable")
    is_stamped = all(one.times.is_stamped for one in found)
    times = SampleTimes(time_s[order], found[0].times.rate_hz, is_stamped)
    values = np.concatenate([one.values for one in found])[order]
    return _SensorSamples(times, values, found[0].first)


def _sensor_of(part: PayloadRun, kind: _SensorKind, camera: str) -> _SensorSamples:
    stream = collect(part.payloads, kind.key)
    if stream is None or stream.values.shape[1] != 3:
        raise TelemetryError(
            "its telemetry ({camera}) holds no {kind} samples",
            remedy=OTHER_CAMERA,
            camera=camera,
            kind=kind.name,
        )
    if kind is _ACCEL:
        _refuse_time_lapse(stream)
    times, values = sample_times(stream, part.clock), _in_frame_a(stream, camera, kind)
    count = int(np.searchsorted(times.time_s, part.end_s))
    if count < len(values):  # the last payload goes on behind the cut
        times = dataclasses.replace(times, time_s=times.time_s[:count])
    return _SensorSamples(times, values[:count], stream.first)


def _refuse_time_lapse(stream: GoproStream) -> None:
    if np.median(stream.counts) < _MIN_SAMPLES_PER_PAYLOAD:
        raise TelemetryError(
            "it holds {samples} motion samples in {payloads} payloads, as "
            "time-lapse recordings do",
            remedy="record normal video",
            samples=len(stream.values),
            payloads=len(stream.counts),
        )


def _in_frame_a(stream: GoproStream, camera: str, kind: _SensorKind) -> Floats:
    rotation = frame_a_from_stored(stream.first, camera)
    values, largest = stream.values, _largest(stream.values)
    if not np.isfinite(largest):
        # single missing samples are filled and marked later
        is_finite = np.isfinite(values)
        values = np.where(is_finite, values, np.nan)
        largest = float(np.nanmax(np.abs(values))) if is_finite.any() else np.inf
    values = values @ rotation.T
    if largest > kind.limit or np.isnan(largest):
        raise TelemetryError(
            "its telemetry claims {largest:.3g} {unit}, beyond what sensors measure",
            largest=largest,
            unit=kind.unit,
        )
    return values


def _largest(values: Floats) -> float:
    """Return the largest magnitude, not finite if a value is not."""
    return max(float(values.max()), -float(values.min())) if values.size else np.inf


def _magnetic_field(
    parts: Sequence[PayloadRun],
) -> tuple[SensorStream | None, tuple[str, ...]]:
    """Return the field of the GoPros that have a compass (Fusion, MAX), and notes.

    MAGN has three components in uT, or four on the MAX: another quantity before x, y
    and z, unreliable before firmware 2. It is used only if the stream declares its axes
    (Fusion's do not follow from its gyro: no signed permutation explains 15 s of rotation
    better than 1.3 uT). A broken compass is left out; the motion is still usable.

    Source: gopro/gpmf-parser, README (Fusion, MAX); measured.

    Returns:
        uT in frame A, or None.
    """
    try:
        stream = collect(parts[0].payloads, "MAGN") if len(parts) == 1 else None
        if stream is None or len(stream.values) < 2:
            return None, ()
        components = stream.values.shape[1]
        if components not in {3, 4} or not has_own_axes(stream.first):
            return None, (
                Message("The compass is ignored: the file does not declare its axes."),
            )
        at_s = sample_times(stream, parts[0].clock).time_s
        rotation = frame_a_from_stored(stream.first, "")
    except TelemetryError as error:
        return None, (Message("The compass is ignored: {what}.", what=error.what),)
    xyz = stream.values[:, -3:]
    values = np.where(np.isfinite(xyz), xyz, np.nan) @ rotation.T
    return SensorStream(at_s, values), ()


def _how_read(imu: ImuLog) -> tuple[str, ...]:
    """Return units, axes and the figures that support them."""
    few, rate = slice(_SHOWN_SAMPLES), imu.angular_rate_radps
    norm = norm_at_rest(
        ImuLog(imu.time_s[few], imu.specific_force_mps2[few], rate[few])
    )
    rest = "" if norm is None else Message(", {norm:.2f} m/s2 at rest", norm=norm)
    text = Message(
        "read as telemetry of the camera: specific force in m/s2, angular "
        "rate in rad/s; x right, y forward, z up{rest}; up to "
        "{largest_radps:.2f} rad/s",
        rest=rest,
        largest_radps=_largest(rate),
    )
    low, high = REST_MPS2
    if norm is None or low <= norm <= high:
        return (text,)
    return (
        text,
        Message(
            "the accelerometer reads {norm:.2f} m/s2 at rest instead of 9.81",
            norm=norm,
        ),
    )


def _notes(stream: GpmfEntry, camera: str, damaged: int) -> tuple[str, ...]:
    notes = []
    if not is_order_known(stream, camera):
        notes.append(
            Message(
                "The file does not declare the sensor axes of {camera!r}: those of "
                "a HERO5 are assumed.",
                camera=camera,
            )
        )
    if damaged:
        notes.append(
            Message(
                "{count} telemetry payloads are damaged; the rest was read.",
                count=damaged,
            )
        )
    return tuple(notes)
