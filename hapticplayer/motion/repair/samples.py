"""Raw arrays of a flawed recording to an ImuLog: repaired, marked or refused.

What can be corrected without guessing is, and is reported; what has to be filled in is
marked as not valid; what would make every number wrong (units, a clock set back) is
refused with the remedy.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, Sampling
from hapticplayer.model.arrays import Floats, all_of_rows
from hapticplayer.model.limits import (
    LEAST_REPEATS,
    MAX_ANY_FIELD,
    MAX_ANY_FORCE,
    MAX_ANY_RATE,
    MAX_MISSING,
    MAX_SAMPLES,
    are_unpaired,
)
from hapticplayer.motion.repair.timestamps import (
    Repair,
    RepairKind,
    Timeline,
    repair_times,
    row_of,
)
from hapticplayer.motion.repair.units import check_force_unit

Flags = NDArray[np.bool_]

MIN_SAMPLES = 2

# Over this time a hand moves nearly straight; longer gaps take means of both sides.
MAX_LINE_S = 0.1
SIDE_S = 0.25
# An exact zero beside a force above this is a placeholder, not free fall.
PLACEHOLDER_MPS2 = 0.3 * STANDARD_GRAVITY_MPS2


class Repaired(NamedTuple):
    """A valid log, and what was repaired.

    Attributes:
        imu: the log; its `valid` is False where force or rate was filled in, and
            None where nothing was.
        repairs: one entry for each kind of flaw; empty for a clean recording.
    """

    imu: ImuLog
    repairs: tuple[Repair, ...]


class _Sensor(NamedTuple):
    name: str
    kind: RepairKind
    largest: float


_SPECIFIC_FORCE = _Sensor("specific_force_mps2", RepairKind.FORCE_FILLED, MAX_ANY_FORCE)
_ANGULAR_RATE = _Sensor("angular_rate_radps", RepairKind.RATE_FILLED, MAX_ANY_RATE)
_MAGNETIC_FIELD = _Sensor("magnetic_field_ut", RepairKind.FIELD_FILLED, MAX_ANY_FIELD)


def repair_samples(
    time_s: ArrayLike,
    specific_force_mps2: ArrayLike,
    angular_rate_radps: ArrayLike,
    magnetic_field_ut: ArrayLike | None = None,
    *,
    sampling: Sampling = Sampling.INSTANT,
    source: str = "",
) -> Repaired:
    """Turn raw samples into a log, with every flaw repaired, marked or refused.

    Times: see `repair_times`. A specific force or angular rate that is not finite, or
    an exact zero force between real ones, is filled: up to 0.1 s by straight lines,
    longer between the means of the quarter seconds beside the gap; it is marked as
    not valid. The magnetometer is filled the same way and does not make the motion
    invalid; without useful samples it is left out. Gaps in the times stay gaps.

    Args:
        time_s: (N,) seconds of any epoch.
        specific_force_mps2: (N, 3) in frame A.
        angular_rate_radps: (N, 3) in frame A.
        magnetic_field_ut: (N, 3) or None.
        sampling: what one sample stands for.
        source: where it came from, for messages.
    """
    times, sensors = _arrays(
        time_s, specific_force_mps2, angular_rate_radps, magnetic_field_ut, source
    )
    line = repair_times(times, sensors, source)
    repairs = list(line.repairs)
    sensors = [line.averaged(values) for values in sensors]
    force, rate = sensors[0], sensors[1]
    lost_force = _missing(force, _SPECIFIC_FORCE) | _placeholders(force)
    lost_rate = _missing(rate, _ANGULAR_RATE)
    _refuse_unpaired(lost_force, lost_rate, source)
    for sensor, values, lost in (
        (_SPECIFIC_FORCE, force, lost_force),
        (_ANGULAR_RATE, rate, lost_rate),
    ):
        _refuse_missing(sensor, lost, line, source)
        _fill(values, lost, line, repairs, sensor)
    field = _field(sensors[2], line, repairs) if len(sensors) > 2 else None
    _check_motion(line, force, rate, repairs, source)
    is_valid = ~(lost_force | lost_rate)
    for own in (force, rate, *([] if field is None else [field])):
        own.setflags(write=False)  # then the log takes it instead of another copy
    imu = ImuLog(
        time_s=line.time_s,
        specific_force_mps2=force,
        angular_rate_radps=rate,
        magnetic_field_ut=field,
        sampling=sampling,
        source=source,
        valid=None if is_valid.all() else is_valid,
    )
    return Repaired(imu, tuple(repairs))


def _arrays(
    time_s: ArrayLike,
    specific_force_mps2: ArrayLike,
    angular_rate_radps: ArrayLike,
    magnetic_field_ut: ArrayLike | None,
    source: str,
) -> tuple[Floats, list[Floats]]:
    """Return own copies as float64; the caller's arrays stay as they are."""
    times = _numbers(time_s, "time_s", source)
    if times.ndim != 1:
        raise InputError(
            "time_s has {ndim} axes, expected one", where=source, ndim=times.ndim
        )
    if not MIN_SAMPLES <= len(times) <= MAX_SAMPLES:
        raise InputError(
            "the number of samples is {count}; {least} to {most} can be used",
            where=source,
            remedy=Message("give a recording of at least a few seconds")
            if len(times) < MIN_SAMPLES
            else Message("cut it into parts"),
            count=len(times),
            least=MIN_SAMPLES,
            most=MAX_SAMPLES,
        )
    given = [
        (_SPECIFIC_FORCE, specific_force_mps2),
        (_ANGULAR_RATE, angular_rate_radps),
    ]
    if magnetic_field_ut is not None:
        given.append((_MAGNETIC_FIELD, magnetic_field_ut))
    sensors = []
    for sensor, values in given:
        array = _numbers(values, sensor.name, source)
        if array.shape != (len(times), 3):
            got = " x ".join(map(str, array.shape))
            raise InputError(
                "{name} has the shape {shape}, expected {count} x 3",
                where=source,
                remedy="give three axes for each time",
                name=sensor.name,
                shape=got,
                count=len(times),
            )
        sensors.append(array)
    return times, sensors


def _numbers(values: ArrayLike, name: str, source: str) -> Floats:
    if isinstance(values, np.ma.MaskedArray):
        values = np.ma.filled(values.astype(np.float64), np.nan)
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "biufO":
            raise TypeError(f"{array.dtype} is not a real number")  # noqa: TRY301
        return np.array(array, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise InputError(
            "{name} does not hold numbers only ({reason})",
            where=source,
            name=name,
            reason=error,
        ) from error


def _missing(values: Floats, sensor: _Sensor) -> Flags:
    # a comparison with NaN is False, so that this finds NaN and infinity too
    return ~all_of_rows(np.abs(values) <= sensor.largest)


def _placeholders(specific_force_mps2: Floats) -> Flags:
    """Return spans of exact zeros that begin and end abruptly."""
    is_zero = all_of_rows(specific_force_mps2 == 0.0)
    if is_zero.all() or not is_zero.any():
        return np.asarray(is_zero)
    edges = np.flatnonzero(np.diff(is_zero, prepend=False, append=False))
    begins, ends = edges[::2], edges[1::2]
    loud = np.ones(len(is_zero) + 2, dtype=np.bool_)  # outside counts as loud
    norm = np.sqrt(np.einsum("ij,ij->i", specific_force_mps2, specific_force_mps2))
    loud[1:-1] = ~(norm <= PLACEHOLDER_MPS2)
    steps = np.zeros(len(is_zero) + 1, dtype=np.int64)
    is_abrupt = loud[begins] & loud[ends + 1]
    steps[begins[is_abrupt]] = 1
    steps[ends[is_abrupt]] = -1
    return np.asarray(np.cumsum(steps[:-1]) > 0)


def _refuse_unpaired(lost_force: Flags, lost_rate: Flags, source: str) -> None:
    """Refuse two streams of different times in one table."""
    if are_unpaired(~lost_force, ~lost_rate):
        raise InputError(
            "only {count} of {total} rows hold both specific force and angular rate",
            where=source,
            remedy="bring the streams to common times by interpolation first",
            count=np.count_nonzero(~lost_force & ~lost_rate),
            total=len(lost_force),
        )


def _refuse_missing(sensor: _Sensor, lost: Flags, line: Timeline, source: str) -> None:
    count = int(np.count_nonzero(lost))
    if count <= MAX_MISSING * len(lost):
        return
    raise InputError(
        "{name} is zero, not finite or beyond any sensor in {count} of "
        "{total} rows, first in {place}",
        where=source,
        remedy=Message(
            "give the unit of its numbers, or a recording of a sensor that worked"
        )
        if count == len(lost)
        else Message("give a recording of a sensor that worked"),
        name=sensor.name,
        count=count,
        total=len(lost),
        place=row_of(line.first_row(lost)),
    )


def _fill(
    values: Floats,
    lost: Flags,
    line: Timeline,
    repairs: list[Repair],
    sensor: _Sensor,
) -> None:
    """Fill the lost rows of `values` in place and say so."""
    if not lost.any():
        return
    good = np.flatnonzero(~lost)
    time_s, kept = line.time_s, values[good]
    after = np.searchsorted(good, np.flatnonzero(lost))
    before = np.maximum(after - 1, 0)
    after = np.minimum(after, len(good) - 1)
    is_long = time_s[good[after]] - time_s[good[before]] > MAX_LINE_S
    count = max(1, round(SIDE_S / float(np.median(np.diff(time_s)))))
    for axis in range(3):
        column = kept[:, axis]
        filled = np.interp(time_s[lost], time_s[good], column)
        if is_long.any():
            left, right = before[is_long], after[is_long]
            back, ahead = _side_means(column, left, right, count)
            span_s = time_s[good[right]] - time_s[good[left]]
            part = (time_s[lost][is_long] - time_s[good[left]]) / span_s
            filled[is_long] = back + part * (ahead - back)
        values[lost, axis] = filled
    number, first_row = int(np.count_nonzero(lost)), line.first_row(lost)
    what = Message(
        "{count} of {total} samples of {name} were missing, the first in "
        "{place}; they were filled in",
        count=number,
        total=len(lost),
        name=sensor.name,
        place=row_of(first_row),
    )
    if sensor is not _MAGNETIC_FIELD:
        what = Message("{what} and are marked as not valid", what=what)
    repairs.append(Repair(sensor.kind, number, first_row, what))


def _side_means(
    column: Floats, left: NDArray[np.intp], right: NDArray[np.intp], count: int
) -> tuple[Floats, Floats]:
    """Return the means of `count` samples up to `left` and from `right` on."""
    sums = np.concatenate([[0.0], np.cumsum(column)])
    low = np.maximum(left + 1 - count, 0)
    high = np.minimum(right + count, len(column))
    back = (sums[left + 1] - sums[low]) / (left + 1 - low)
    ahead = (sums[high] - sums[right]) / (high - right)
    return back, ahead


def _field(field: Floats, line: Timeline, repairs: list[Repair]) -> Floats | None:
    """Return the magnetic field without gaps, or None when most of it is missing."""
    lost = _missing(field, _MAGNETIC_FIELD) | ~field.any(axis=1)
    if np.count_nonzero(lost) > MAX_MISSING * len(lost):
        count = int(np.count_nonzero(lost))
        what = Message(
            "the magnetometer was left out: {count} of {total} samples are empty",
            count=count,
            total=len(lost),
        )
        repairs.append(
            Repair(RepairKind.FIELD_DROPPED, count, line.first_row(lost), what)
        )
        return None
    _fill(field, lost, line, repairs, _MAGNETIC_FIELD)
    return field


def _check_motion(
    line: Timeline,
    specific_force_mps2: Floats,
    angular_rate_radps: Floats,
    repairs: list[Repair],
    source: str,
) -> None:
    """Refuse stuck sensors and a wrong unit of the specific force; report a gyro that reads 0.

    A program's log of something at rest is the same throughout, and its gyro reads 0.
    """
    check_force_unit(line.time_s, specific_force_mps2, source)
    sensors = specific_force_mps2, angular_rate_radps
    is_constant = all((values == values[0]).all() for values in sensors)
    is_rest = len(angular_rate_radps) <= LEAST_REPEATS or not angular_rate_radps.any()
    if is_constant and not is_rest:
        raise InputError(
            "all samples are the same, so the sensor was stuck",
            where=source,
            remedy="give a recording of a sensor that worked",
        )
    if is_constant or not angular_rate_radps.any():
        what = Message("the angular rate is zero throughout, so no rotation is assumed")
        if is_constant:
            what = Message("all samples are the same: was the sensor stuck?")
        repairs.append(
            Repair(RepairKind.NO_ROTATION, len(line.time_s), int(line.rows[0]), what)
        )
