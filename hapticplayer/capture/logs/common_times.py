"""Brings sensors with times of their own to the accelerometer's times.

Samples are never paired by their place in the file: the angular rate becomes its
mean over each interval of the accelerometer (no rotation is lost), the slow magnetic
field is interpolated. What was missing in a stream stays marked as missing (NaN).
"""

from typing import NamedTuple

import numpy as np

from hapticplayer.capture.logs.raw import Stream
from hapticplayer.capture.resample import mean_rate_with_holes
from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats

_REACH_S = 1.0
"""What a slow sensor said is not carried farther than this."""


class Samples(NamedTuple):
    """Rows of all sensors at common times; NaN where something was missing."""

    time_s: Floats
    force: Floats
    rate: Floats
    field: Floats | None
    notes: tuple[str, ...]


def on_common_times(
    force: Stream, rate: Stream, field: Stream | None, where: str
) -> Samples:
    """Return all sensors at the times of the accelerometer.

    Streams that share their times are left as they are, faults included.

    Raises:
        InputError: when the clock of a stream cannot be relied on, or the streams
            do not overlap.
    """
    if rate.time_s is force.time_s and (field is None or field.time_s is force.time_s):
        values = None if field is None else field.values
        return Samples(force.time_s, force.values, rate.values, values, ())
    force, notes = _ordered(force, "accelerometer", where)
    rate, rate_notes = _ordered(rate, "gyroscope", where)
    rows, mean = mean_rate_with_holes(force.time_s, rate.time_s, rate.values)
    if len(rows) < 2:
        raise InputError(
            "its accelerometer and gyroscope do not overlap in time",
            where=where,
            remedy="record both at once",
        )
    time_s = force.time_s[rows]
    at_times = None if field is None else interpolated(time_s, field, where)
    all_notes = (*notes, *rate_notes)
    return Samples(time_s, force.values[rows], mean, at_times, all_notes)


def _ordered(stream: Stream, name: str, where: str) -> tuple[Stream, tuple[str, ...]]:
    """Return a stream whose times increase strictly, and what it took."""
    from hapticplayer.motion.repair.timestamps import repair_times  # brings scipy

    line = repair_times(
        np.array(stream.time_s, dtype=np.float64), [stream.values], where
    )
    is_in_order = (
        len(line.rows) == len(stream.values) and (np.diff(line.rows) == 1).all()
    )
    values = stream.values if is_in_order else stream.values[line.rows]
    if len(line.starts) < len(line.rows):
        sizes = np.diff(line.starts, append=len(line.rows))
        finite = np.where(np.isfinite(values), values, np.nan)
        values = np.add.reduceat(finite, line.starts) / sizes[:, None]
    notes = tuple(f"{name}: {repair.text}" for repair in line.repairs)
    return Stream(line.time_s, np.asarray(values)), notes


def interpolated(time_s: Floats, field: Stream, where: str) -> Floats | None:
    """Return a slow sensor at other times, NaN where none was measured near.

    Args:
        time_s: (M,) may hold NaN.
        field: magnetic field, gravity.
        where: the file.

    Returns:
        (M, 3), or None when the sensor cannot be used.
    """
    finite = np.isfinite(field.values).all(axis=1) & np.isfinite(field.time_s)
    if np.count_nonzero(finite) < 2:
        return None
    try:
        kept, _ = _ordered(
            Stream(field.time_s[finite], field.values[finite]), "slow sensor", where
        )
    except InputError:
        return None  # a broken compass is no reason to refuse the motion
    columns = [np.interp(time_s, kept.time_s, column) for column in kept.values.T]
    after = np.searchsorted(kept.time_s, time_s).clip(1, len(kept.time_s) - 1)
    to_next = np.abs(kept.time_s[after] - time_s)
    to_last = np.abs(time_s - kept.time_s[after - 1])
    values = np.stack(columns, axis=1)
    values[~(np.minimum(to_next, to_last) <= _REACH_S)] = np.nan
    return values
