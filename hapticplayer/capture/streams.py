"""The streams of a log as stored, and resampled to common times.

AlignedSamples are never paired by index: the angular rate becomes its mean over each interval of
the accelerometer (no rotation is lost), the slow magnetic field is interpolated. Missing
samples remain missing (NaN).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.csv_table import Shape, read_table
from hapticplayer.capture.source import LogSource
from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats, all_of_rows
from hapticplayer.model.limits import MAX_REACH_S, are_gaps, are_unpaired

NANO = 1e-9
_MOSTLY = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class SensorStream:
    """One sensor on its own times.

    Attributes:
        time_s: (N,) as recorded: may jump, repeat or be NaN.
        values: (N, 3) in the file's unit; may be NaN.
    """

    time_s: Floats
    values: Floats


@dataclass(frozen=True, slots=True, eq=False)
class RawLog:
    """A log before anything was checked.

    Attributes:
        name: of the format, for people.
        accel: accelerometer; +1 g on the axis that points up at rest.
        rate: gyroscope, or None.
        field: magnetometer, or None.
        accel_unit: see `choices.ACCEL_UNITS`.
        rate_unit: see `choices.RATE_UNITS`.
        field_unit: see `choices.FIELD_UNITS`.
        axes: right, front and up of frame A in the stored axes, such as "x,-z,y".
        axes_words: the stored axes in words.
        back_axis: of a phone held upright, the axis opposite to the camera's view; ""
            without a camera.
        frames_s: when the first frame began and the last ended, on the log's clock.
        is_gravity_free: gravity was removed by the recorder.
        scale_ratio: of the accelerometer's scale to the gyro's, where the reader has
            applied scales of a file, each to its columns.
        time_names: of the column of times, and of what scales it, for errors.
        notes: of the reader.
    """

    name: str
    accel: SensorStream
    rate: SensorStream | None
    field: SensorStream | None = None
    accel_unit: str = "m/s2"
    rate_unit: str = "rad/s"
    field_unit: str = "uT"
    axes: str = "x,y,z"
    axes_words: str = ""
    back_axis: str = ""
    frames_s: tuple[float, float] | None = None
    is_gravity_free: bool = False
    scale_ratio: float = 1.0
    time_names: tuple[str, str] = (Message("its time"), Message("its time"))
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Sensor:
    """A member with one sensor.

    Attributes:
        stream: with times in seconds since `origin_ns`.
        origin_ns: of the recorder's clock.
        notes: on damaged lines.
    """

    stream: SensorStream
    origin_ns: int
    notes: tuple[str, ...]

    def since(self, origin_ns: int) -> SensorStream:
        shift_s = (self.origin_ns - origin_ns) * NANO
        return SensorStream(self.stream.time_s + shift_s, self.stream.values)


def read_sensor(source: LogSource, name: str, shape: Shape) -> Sensor:
    """Return a member whose columns are a time in ns, x, y, z."""
    numbers = read_table(source, name, shape)
    values = numbers.values
    stream = SensorStream(values[:, 0] * NANO, values[:, 1:4].copy())
    notes = tuple(f"{name}: {note}" for note in numbers.notes)
    return Sensor(stream, numbers.origin, notes)


def split(
    values: Floats, time_s: Floats, starts: Sequence[int]
) -> tuple[SensorStream, SensorStream, SensorStream | None]:
    """Return accelerometer, gyroscope and magnetometer of one table.

    Args:
        values: (rows, columns).
        time_s: (rows,), shared by all three.
        starts: the columns of their x; the third may be missing.
    """
    accel, rate, *field = (
        SensorStream(time_s, values[:, at : at + 3]) for at in starts
    )
    return accel, rate, field[0] if field else None


def split_sensors(
    time_s: Floats, parts: Mapping[str, Floats]
) -> dict[str, SensorStream]:
    """Return the sensors of one table; rows with only one become separate streams.

    Args:
        time_s: (rows,).
        parts: (rows, 3) by sensor ("accel", "rate", ...), NaN in empty cells.
    """
    if {"accel", "rate"} <= set(parts):
        has_accel, has_rate = (
            all_of_rows(np.isfinite(parts[kind])) for kind in ("accel", "rate")
        )
        if are_unpaired(has_accel, has_rate):
            return {kind: _own_rows(time_s, part) for kind, part in parts.items()}
    return {kind: SensorStream(time_s, part) for kind, part in parts.items()}


def _own_rows(time_s: Floats, part: Floats) -> SensorStream:
    held = ~np.isnan(part).all(axis=1)
    return SensorStream(time_s[held], part[held])


_COUNTERS = (2.0**16, 2.0**24, 2.0**32)
_NEAR = 0.01
"""Of a counter's turn: how near to both ends it is seen before and after."""


def unwrapped(times: Floats, turn: float) -> Floats:
    """Return times that start again after each turn, continued."""
    steps, half = np.diff(times), 0.5 * turn
    turns: Floats = np.cumsum(steps < -half) - np.cumsum(steps > half)
    return np.concatenate([times[:1], times[1:] + turns * turn])


def counted_on(counts: Floats) -> Floats:
    """Return counts of a clock of 16, 24 or 32 bits, signed or not, continued."""
    known = counts[np.isfinite(counts)]
    if not len(known):
        return counts
    before, after, low = known[:-1], known[1:], float(known.min())
    for turn in _COUNTERS:
        first = -0.5 * turn if low < 0.0 else 0.0
        is_inside = first <= low and float(known.max()) < first + turn
        is_last = before >= first + (1.0 - _NEAR) * turn
        if is_inside and (is_last & (after < first + _NEAR * turn)).any():
            return unwrapped(counts, turn)
    return counts


class AlignedSamples(NamedTuple):
    """Rows of all sensors at common times; NaN where something was missing."""

    time_s: Floats
    accel: Floats
    rate: Floats
    field: Floats | None
    notes: tuple[str, ...]


def on_common_times(
    accel: SensorStream, rate: SensorStream, field: SensorStream | None, where: str
) -> AlignedSamples:
    """Return all sensors at the times of the accelerometer.

    Streams that share their times are unchanged, flaws included.
    """
    if rate.time_s is accel.time_s and (field is None or field.time_s is accel.time_s):
        values = None if field is None else field.values
        return AlignedSamples(accel.time_s, accel.values, rate.values, values, ())
    accel, notes = ordered(accel, "accelerometer", where)
    rate, rate_notes = ordered(rate, "gyroscope", where)
    accel, clock_notes = _on_even_clock(accel, "accelerometer", force=accel.values)
    rate, rate_clock_notes = _on_even_clock(rate, "gyroscope", rate=rate.values)
    rows, mean = mean_rate_with_holes(accel.time_s, rate.time_s, rate.values)
    if len(rows) < 2:
        raise InputError(
            "its accelerometer and gyroscope do not overlap in time",
            where=where,
            remedy="record both at once",
        )
    time_s = accel.time_s[rows]
    at_times = None if field is None else interpolated(time_s, field, where)
    notes = (*notes, *rate_notes, *clock_notes, *rate_clock_notes)
    return AlignedSamples(time_s, accel.values[rows], mean, at_times, notes)


def ordered(
    stream: SensorStream, name: str, where: str
) -> tuple[SensorStream, tuple[str, ...]]:
    """Return a stream with strictly increasing times, and notes."""
    from hapticplayer.motion.repair.timestamps import repair_times  # brings scipy

    line = repair_times(
        np.array(stream.time_s, dtype=np.float64), [stream.values], where
    )
    notes = tuple(f"{name}: {repair.text}" for repair in line.repairs)
    return SensorStream(line.time_s, line.averaged(stream.values)), notes


def _on_even_clock(
    stream: SensorStream, name: str, **values: Floats
) -> tuple[SensorStream, tuple[str, ...]]:
    """Return a stream without the jitter of its stamps, and notes."""
    from hapticplayer.motion.even_clock import even_clock, jitter_text

    even_s = even_clock(stream.time_s, **values)
    if even_s is None:
        return stream, ()
    text = jitter_text(stream.time_s, even_s)
    return SensorStream(even_s, stream.values), (f"{name}: {text}",)


def interpolated(time_s: Floats, field: SensorStream, where: str) -> Floats | None:
    """Return a slow sensor at other times, NaN if none is near.

    Args:
        time_s: (M,) may be NaN.
        field: magnetic field, gravity.
        where: the file.

    Returns:
        (M, 3), or None when the sensor cannot be used.
    """
    finite = np.isfinite(field.values).all(axis=1) & np.isfinite(field.time_s)
    if np.count_nonzero(finite) < 2:
        return None
    try:
        kept, _ = ordered(
            SensorStream(field.time_s[finite], field.values[finite]),
            "slow sensor",
            where,
        )
    except InputError:
        return None  # the motion is usable without a compass
    columns = [np.interp(time_s, kept.time_s, column) for column in kept.values.T]
    after = np.searchsorted(kept.time_s, time_s).clip(1, len(kept.time_s) - 1)
    to_next = np.abs(kept.time_s[after] - time_s)
    to_last = np.abs(time_s - kept.time_s[after - 1])
    values = np.stack(columns, axis=1)
    values[~(np.minimum(to_next, to_last) <= MAX_REACH_S)] = np.nan
    return values


def mean_rate(
    query_s: Floats, time_s: Floats, rate: Floats
) -> tuple[NDArray[np.intp], Floats]:
    """Return the mean rate over the interval that ends at each query time.

    The rate holds over the interval that ends at its sample (Sampling.INSTANT). Its
    integral is interpolated at the ends of the query intervals and differenced, so
    that the angle over any span is exact.

    Args:
        query_s: (M,) strictly increasing, M >= 2.
        time_s: (N,) strictly increasing, N >= 2.
        rate: (N, axes).

    Returns:
        The indices (K,) of the query times whose interval is covered, and the mean
        rates (K, axes).
    """
    slack_s = 0.5 * (time_s[-1] - time_s[0]) / (len(time_s) - 1)
    # extended at both ends, because two sensors start and stop up to a sample apart
    begin_s = 2.0 * time_s[0] - time_s[1]
    ends_s = np.concatenate(
        [[begin_s - slack_s, begin_s], time_s, [time_s[-1] + slack_s]]
    )
    edges_s = np.concatenate([[2.0 * query_s[0] - query_s[1]], query_s])
    is_inside = (edges_s >= ends_s[0]) & (edges_s <= ends_s[-1])
    rows = np.flatnonzero(is_inside[:-1] & is_inside[1:])
    # contiguous
    use = slice(rows[0], rows[-1] + 1) if len(rows) else slice(0)
    steps_s, widths_s = np.diff(edges_s)[use], np.diff(ends_s)
    mean = np.empty((len(rows), rate.shape[1]))
    for axis in range(rate.shape[1]):  # one by one, to save memory
        angle = _integral(widths_s, rate[:, axis])
        rotated = np.diff(np.interp(edges_s, ends_s, angle))[use]
        np.divide(rotated, steps_s, out=mean[:, axis])
    return rows, mean


def mean_rate_with_holes(
    query_s: Floats, time_s: Floats, rate: Floats
) -> tuple[NDArray[np.intp], Floats]:
    """Return the mean rate like `mean_rate`, NaN where most of it is missing.

    Args:
        query_s: (M,) strictly increasing, M >= 2.
        time_s: (N,) strictly increasing, N >= 2; a long step is a gap.
        rate: (N, axes); may be NaN.
    """
    finite = all_of_rows(np.isfinite(rate))
    steps_s = np.diff(time_s, prepend=time_s[0])
    is_gap = are_gaps(steps_s, float(np.median(np.diff(time_s))))
    missing = ~finite | is_gap
    if not missing.any():
        return mean_rate(query_s, time_s, rate)
    if not finite.all():
        good_s = time_s[finite] if finite.any() else time_s
        good = rate[finite] if finite.any() else np.zeros_like(rate)
        rate = np.stack([np.interp(time_s, good_s, axis) for axis in good.T], axis=1)
    rows, mean = mean_rate(query_s, time_s, rate)
    _, share = mean_rate(query_s, time_s, missing[:, None].astype(np.float64))
    mean[share[:, 0] > _MOSTLY] = np.nan
    return rows, mean


def _integral(widths_s: Floats, rate: Floats) -> Floats:
    """Return the integral of one axis at the ends of all intervals."""
    angle = np.zeros(len(widths_s) + 1)
    rate_s = np.concatenate([rate[:1], rate, rate[-1:]])
    rate_s *= widths_s
    np.cumsum(rate_s, out=angle[1:])
    return angle
