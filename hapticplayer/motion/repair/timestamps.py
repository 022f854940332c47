"""Strictly increasing times from those that a logger wrote.

A clock that was set back in the middle of a recording is refused: no order of the
rows would be right. Smaller flaws are repaired and reported.
"""

import enum
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import (
    MAX_GAP_S,
    MAX_RATE_HZ,
    MAX_TIME,
    MAX_USUAL_RATE_HZ,
    MIN_RATE_HZ,
)
from hapticplayer.model.timing import TIME, time_unit_remedy

Rows = NDArray[np.intp]

# A sensor at exactly the lowest rate has times that are rounded.
ROUNDING = 0.99

# Steps below this part of an interval are one moment for the sensor.
SAME_MOMENT = 0.05
# A time that is late by this part of its packet (or sample) has lost some.
LOST = 0.6
# Stamps within this of whole seconds have no fractions.
WHOLE_S = 1e-6
# The interval is measured over this many rows, so that packets do not hide it.
INTERVAL_ROWS = 64


class RepairKind(enum.StrEnum):
    """What was wrong with some rows."""

    TIME_FILLED = "time filled"
    TIME_DROPPED = "time dropped"
    SWAPPED = "swapped"
    DUPLICATE = "duplicate"
    MERGED = "merged"
    SPREAD = "spread"
    LOST = "lost"
    FORCE_FILLED = "force filled"
    RATE_FILLED = "rate filled"
    FIELD_FILLED = "field filled"
    FIELD_DROPPED = "field dropped"
    NO_ROTATION = "no rotation"


@dataclass(frozen=True, slots=True)
class Repair:
    """One kind of flaw and what was done about it.

    Attributes:
        kind: of the flaw.
        count: of rows (of missing samples for LOST).
        first_row: of the arrays as they were given, counted from 0.
        text: a sentence for people.
    """

    kind: RepairKind
    count: int
    first_row: int
    text: Message


def row_of(number: int) -> Message:
    """Return the place of a sample, in an array; a reader names the line of its file."""
    return Message("row {number}", number=number)


@dataclass(frozen=True, slots=True, eq=False)
class Timeline:
    """Rows in order with strictly increasing times.

    Attributes:
        time_s: (M,) strictly increasing.
        rows: (K,) rows of the given arrays, in order of time; K >= M.
        starts: (M,) where in `rows` the rows of each time begin; several rows of
            one time are to be averaged.
        repairs: what was done.
    """

    time_s: Floats
    rows: Rows
    starts: Rows
    repairs: tuple[Repair, ...]

    def averaged(self, values: Floats) -> Floats:
        """Return one row (M, 3) for each time of the given (N, 3); several are averaged."""
        is_in_order = len(self.rows) == len(values) and (np.diff(self.rows) == 1).all()
        ordered = values if is_in_order else values[self.rows]
        if len(self.starts) == len(self.rows):
            return ordered
        sizes = np.diff(self.starts, append=len(self.rows))
        # one by one, because infinities of both signs may meet in a sum
        finite = np.where(np.isfinite(ordered), ordered, np.nan)
        return np.asarray(np.add.reduceat(finite, self.starts) / sizes[:, None])

    def first_row(self, flags: NDArray[np.bool_]) -> int:
        """Return the given row of the first time that is flagged, (M,)."""
        return int(self.rows[self.starts[int(np.argmax(flags))]])


def repair_times(
    time_s: Floats, sensors: Sequence[Floats], source: str = ""
) -> Timeline:
    """Bring rows into order and give each its own time.

    Swapped neighbours are put in order; single stamps that are missing or out of
    order are interpolated; equal rows of one time are kept once, different ones
    averaged; packets that carry one stamp are spread over the time since the
    packet before. Jitter is kept.

    Args:
        time_s: (N,) as recorded, N >= 2; may hold NaN. Its wild stamps are set to NaN.
        sensors: (N, 3) each; only compared.
        source: for error messages.
    """
    steps_s = np.diff(time_s)
    steps_s = steps_s[np.isfinite(steps_s)]
    if len(steps_s) > 1 and np.median(steps_s) < 0.0:
        return _reversed(time_s, sensors, source)
    repairs: list[Repair] = []
    rows = _in_order(time_s, repairs, source)
    time_s, rows = _filled(time_s, rows, repairs, source)
    time_s, rows = _trimmed(time_s, rows, repairs)
    _refuse_disorder(time_s, rows, source)
    interval_s = _interval(time_s)
    if interval_s <= 0.0:
        raise InputError(
            "from {place} on all rows carry the same time",
            where=source,
            remedy="write the time of each sample with all its digits",
            place=row_of(rows[0]),
        )
    _check_steps(time_s, rows, interval_s, source)
    groups = _groups(time_s, interval_s)
    _count_lost(groups, rows, repairs)
    time_s, rows, starts = _one_row_a_time(time_s, rows, sensors, groups, repairs)
    return Timeline(time_s, rows, starts, tuple(repairs))


def _reversed(time_s: Floats, sensors: Sequence[Floats], source: str) -> Timeline:
    """Repair a recording whose newest row is the first."""
    found = repair_times(time_s[::-1], [values[::-1] for values in sensors], source)
    last = len(time_s) - 1
    what = Message("the rows, of which the newest came first, were put in order")
    repairs = [Repair(RepairKind.SWAPPED, len(time_s), 0, what)]
    repairs += [replace(one, first_row=last - one.first_row) for one in found.repairs]
    return replace(found, rows=last - found.rows, repairs=tuple(repairs))


def _in_order(time_s: Floats, repairs: list[Repair], source: str) -> Rows:
    """Return all rows with swapped neighbours exchanged; mark wild stamps as NaN.

    `time_s` is changed in place.
    """
    rows = np.arange(len(time_s))
    time_s[~(np.abs(time_s) <= MAX_TIME)] = np.nan
    good = rows[np.isfinite(time_s)]
    if len(good) < 2:
        raise InputError(
            "only {count} of {total} times can be used",
            where=source,
            remedy="give the time of each sample in seconds",
            count=len(good),
            total=len(time_s),
        )
    t = np.concatenate([[-np.inf], time_s[good], [np.inf]])
    back = np.flatnonzero(np.diff(t) < 0.0)  # t[back] > t[back + 1]
    before, high, low, after = t[back - 1], t[back], t[back + 1], t[back + 2]
    is_swap = (before <= low) & (high <= after)
    is_low = ~is_swap & (high <= after)
    is_high = ~is_swap & ~is_low & (before <= low)
    jump = ~(is_swap | is_low | is_high)
    if jump.any():
        first = int(np.argmax(jump))
        row = int(good[back[first]])
        raise InputError(
            "{time} jumps back by {jump_s:.6g} s at {place}",
            where=source,
            time=TIME,
            remedy="cut the recording there and give the parts one by one",
            jump_s=high[first] - low[first],
            place=row_of(row),
        )
    time_s[good[back[is_low]]] = np.nan
    time_s[good[back[is_high] - 1]] = np.nan
    left, right = good[back[is_swap] - 1], good[back[is_swap]]
    rows[left], rows[right] = right, left
    if len(left):
        what = Message(
            "{count} pairs of rows were swapped in time and put in order",
            count=len(left),
        )
        repairs.append(Repair(RepairKind.SWAPPED, len(left), int(left[0]), what))
    return rows


def _filled(
    time_s: Floats, rows: Rows, repairs: list[Repair], source: str
) -> tuple[Floats, Rows]:
    """Return times in the order of `rows`, missing ones interpolated or dropped."""
    t = time_s[rows]
    good = np.flatnonzero(np.isfinite(t))
    if 2 * len(good) < len(t):
        raise InputError(
            "only {count} of {total} times can be used",
            where=source,
            remedy="give the time of each sample in seconds",
            count=len(good),
            total=len(t),
        )
    if len(good) == len(t):
        return t, rows
    index = np.arange(len(t))
    interval_s = max(_interval(t[good]), 0.0)
    inner = np.interp(index, good, t[good])
    filled = inner + interval_s * (
        np.minimum(index - good[0], 0) + np.maximum(index - good[-1], 0)
    )
    # rows that stand in a gap of the clock could be from any time in it
    left = np.maximum(np.searchsorted(good, index, "right") - 1, 0)
    pace = np.diff(t[good], append=t[good[-1]]) / np.diff(good, append=good[-1] + 1)
    is_lost = ~np.isfinite(t) & (pace[left] > 2.0 * interval_s)
    count, lost = len(t) - len(good), int(np.count_nonzero(is_lost))
    first = int(rows[np.argmax(~np.isfinite(t))])
    if count > lost:
        what = Message(
            "{count} missing or implausible times were interpolated", count=count - lost
        )
        repairs.append(Repair(RepairKind.TIME_FILLED, count - lost, first, what))
    if lost:
        what = Message(
            "{count} rows without a time were left out, as they are in a gap",
            count=lost,
        )
        row = int(rows[np.argmax(is_lost)])
        repairs.append(Repair(RepairKind.TIME_DROPPED, lost, row, what))
    return filled[~is_lost], rows[~is_lost]


def _trimmed(time_s: Floats, rows: Rows, repairs: list[Repair]) -> tuple[Floats, Rows]:
    """Leave out a first or last row that stands more than an hour apart."""
    begin = int(len(time_s) > 2 and time_s[1] - time_s[0] > MAX_GAP_S)
    end = len(time_s) - int(len(time_s) > 2 and time_s[-1] - time_s[-2] > MAX_GAP_S)
    for row in [*rows[:begin], *rows[end:]]:
        what = Message(
            "{place} was left out, as its time is more than an hour apart",
            place=row_of(row),
        )
        repairs.append(Repair(RepairKind.TIME_DROPPED, 1, int(row), what))
    return time_s[begin:end], rows[begin:end]


def _refuse_disorder(time_s: Floats, rows: Rows, source: str) -> None:
    back = np.diff(time_s) < 0.0
    if back.any():
        row = int(rows[int(np.argmax(back)) + 1])
        raise InputError(
            "{time} runs backwards at {place}, and no order can be found",
            where=source,
            time=TIME,
            remedy="sort the rows by time or cut the recording there",
            place=row_of(row),
        )


def _interval(time_s: Floats) -> float:
    """Return the median interval, with packets of one stamp seen as spread."""
    span = min(INTERVAL_ROWS, max(1, (len(time_s) - 1) // 4))
    return float(np.median(time_s[span:] - time_s[:-span])) / span


class _Groups(NamedTuple):
    """Rows that share a time, one entry for each time, and the time of one row."""

    starts: Rows
    sizes: Rows
    stamp_s: Floats
    since_s: Floats
    interval_s: float


def _groups(time_s: Floats, interval_s: float) -> _Groups:
    is_new = np.diff(time_s, prepend=-np.inf) > SAME_MOMENT * interval_s
    starts = np.flatnonzero(is_new)
    sizes = np.diff(starts, append=len(time_s))
    stamp_s = time_s[starts + sizes - 1]
    if len(starts) > 2 and np.median(sizes) > 2 and _are_whole(stamp_s):
        # cut off: the rows follow their second, packets precede their stamp
        interval_s = float(np.median(np.diff(stamp_s) / sizes[:-1]))
        next_s = np.append(stamp_s[1:], stamp_s[-1] + sizes[-1] * interval_s)
        stamp_s = next_s - interval_s
    if len(starts) > 1:
        interval_s = float(np.median(np.diff(stamp_s) / sizes[1:]))
    since_s = np.diff(stamp_s, prepend=stamp_s[0] - sizes[0] * interval_s)
    return _Groups(starts, sizes, stamp_s, since_s, interval_s)


def _are_whole(stamp_s: Floats) -> bool:
    """Whether all stamps are whole seconds."""
    return bool((np.abs(stamp_s - np.rint(stamp_s)) < WHOLE_S).all())


def _one_row_a_time(
    time_s: Floats,
    rows: Rows,
    sensors: Sequence[Floats],
    groups: _Groups,
    repairs: list[Repair],
) -> tuple[Floats, Rows, Rows]:
    """Resolve rows that share a time; return times, rows and group starts."""
    starts, sizes, stamp_s, since_s, interval_s = groups
    if len(starts) == len(rows):
        return time_s, rows, starts
    in_packets = 2 * int(sizes[sizes > 1].sum()) >= len(rows)
    is_spread = (sizes > 1) & (in_packets | (since_s >= (sizes - 0.5) * interval_s))
    group = np.repeat(np.arange(len(starts)), sizes)
    place = np.arange(len(rows)) - starts[group]
    late = sizes[group] - 1 - place
    spread_s = stamp_s[group] - since_s[group] * late / sizes[group]
    in_spread = is_spread[group]
    _note(RepairKind.SPREAD, in_spread, rows, repairs)
    # what remains of a group is averaged, after exact repetitions are left out
    rest = (place > 0) & ~in_spread
    same = rest & _equals_first(sensors, rows, rows[starts][group])
    _note(RepairKind.DUPLICATE, same, rows, repairs)
    _note(RepairKind.MERGED, rest & ~same, rows, repairs)
    times = np.where(in_spread, spread_s, time_s[starts][group])
    keep = ~same
    is_start = ((place == 0) | in_spread)[keep]
    return times[keep][is_start], rows[keep], np.flatnonzero(is_start)


def _equals_first(
    sensors: Sequence[Floats], rows: Rows, first: Rows
) -> NDArray[np.bool_]:
    same = rows != first
    repeated = np.flatnonzero(same)
    for values in sensors:
        here, there = values[rows[repeated]], values[first[repeated]]
        is_equal = (here == there) | (np.isnan(here) & np.isnan(there))
        same[repeated] &= is_equal.all(axis=1)
    return np.asarray(same)


_DONE = {
    RepairKind.SPREAD: Message("carry the time of their packet and were spread evenly"),
    RepairKind.DUPLICATE: Message("repeat the one before and were left out"),
    RepairKind.MERGED: Message("share the time of another and were averaged with it"),
}


def _note(
    kind: RepairKind, flags: NDArray[np.bool_], rows: Rows, repairs: list[Repair]
) -> None:
    count = int(np.count_nonzero(flags))
    if count:
        what = Message(
            "{count} of {total} rows {done}",
            count=count,
            total=len(rows),
            done=_DONE[kind],
        )
        repairs.append(Repair(kind, count, int(rows[np.argmax(flags)]), what))


def _check_steps(time_s: Floats, rows: Rows, interval_s: float, source: str) -> None:
    rate_hz = 1.0 / interval_s
    least_hz = ROUNDING * MIN_RATE_HZ
    if rate_hz < least_hz:
        other_unit = time_unit_remedy(
            lambda per_s: least_hz <= per_s * rate_hz <= MAX_USUAL_RATE_HZ
        )
        raise InputError(
            "{time} runs at {rate_hz:.3g} samples a second",
            where=source,
            time=TIME,
            remedy=other_unit
            or Message(
                "give at least {least_hz:g} samples a second", least_hz=MIN_RATE_HZ
            ),
            rate_hz=rate_hz,
        )
    if rate_hz > MAX_RATE_HZ:
        usual = (k for k in (1e3, 1e6, 1e9) if rate_hz / k <= MAX_USUAL_RATE_HZ)
        raise InputError(
            "{time} runs at {rate_hz:.3g} samples a second, faster than any sensor",
            where=source,
            remedy="if it is not in seconds, multiply {scale} by {per_s:.0f}; else "
            "average to {most_hz:g} samples a second",
            time=TIME,
            scale=TIME,
            rate_hz=rate_hz,
            per_s=next(usual, 1e9),
            most_hz=MAX_RATE_HZ,
        )
    steps = np.diff(time_s)
    if len(steps) and steps.max() > MAX_GAP_S:
        at = int(np.argmax(steps))
        raise InputError(
            "nothing was recorded for {gap_s:.0f} s after {place}",
            where=source,
            remedy="cut the recording there and give the parts one by one",
            gap_s=steps[at],
            place=row_of(rows[at]),
        )


def _count_lost(groups: _Groups, rows: Rows, repairs: list[Repair]) -> None:
    """Count the samples that gaps have swallowed; there is nothing to repair."""
    typical = float(np.median(groups.sizes))
    missing = groups.since_s / groups.interval_s - groups.sizes
    # jitter makes a long step between two short ones, a loss does not
    early = np.minimum(np.pad(missing, 1), 0.0)
    wide = missing + early[:-2] + early[2:] > LOST * typical
    if wide.any():
        count = int(np.round(missing[wide]).sum())
        what = Message(
            "about {count} samples were never recorded; the longest gap is "
            "{longest_s:.3g} s; nothing was put in their place",
            count=count,
            longest_s=groups.since_s.max(),
        )
        row = int(rows[groups.starts[int(np.argmax(wide))]])
        repairs.append(Repair(RepairKind.LOST, count, row, what))
