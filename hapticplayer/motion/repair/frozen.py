"""Readings that repeat exactly for longer than the sensor's own noise allows.

A logger that lost its sensor writes the last readings again: all axes, one of them, or
a few rows in turn. A coarse sensor at rest repeats itself, too: there its noise does not
reach from one step of its values to the next. Both figures come from the rest of the
log, so that units do not matter.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats, all_of_rows

Flags = NDArray[np.bool_]

# A value whose noise is half a step repeats every other time: 2^-40 by chance.
RESOLVED_STEPS, LEAST_REPEATS = 0.5, 40
MAX_PERIOD_ROWS = 16
# Noise is that of the calmest tenth of the windows of so many readings.
WINDOW_READINGS, CALM_PERCENT = 16, 10.0
SHOWN_VALUES = 20_000  # for the step of the values
# What comes to rest and leaves it does so within this many steps at one end.
GENTLE_STEPS = 2.5
# A log begins at rest; a sensor that shows fewer levels in it may repeat itself there.
COARSE_LEVELS = 256
MIN_SHARE_OF_HELD = 0.9


class _Axes(NamedTuple):
    """What an axis of a sensor is like where it works, (3,) each."""

    step: Floats
    is_resolved: Flags
    levels: Floats


def readings_each(values: Floats) -> int:
    """Return how many rows hold each reading: 1, or more of a slow sensor's (N, 3)."""
    changes = np.flatnonzero(~all_of_rows(values[1:] == values[:-1]))
    lengths = np.diff(changes)
    if len(lengths) < WINDOW_READINGS:
        return 1
    usual = int(np.median(lengths))
    near = np.abs(lengths - usual) <= (1 if usual > 1 else 0)
    return usual if np.mean(near) >= MIN_SHARE_OF_HELD else 1


def frozen_rows(values: Floats) -> Flags:
    """Return the rows (N,) that repeat others of one sensor (N, 3), NaN where missing."""
    count, each = len(values), readings_each(values)
    frozen, least = np.zeros(count, np.bool_), LEAST_REPEATS * each
    if count < 2 * least:
        return frozen
    if _has_stuck_axis(values, each):
        frozen[:] = True
        return frozen
    found = list(_repeats(values, each, least))
    if not found:
        return frozen
    works = np.ones(values.shape, np.bool_)
    for one in found:
        works[one.begin : one.end + 1, one.axes] = False
    axes = _axes(values, works, each)
    for one in found:
        if one.is_frozen(values, axes, least):
            frozen[one.begin + one.period : one.end + one.period] = True
    return frozen


def _has_stuck_axis(values: Floats, each: int) -> bool:
    """Whether an axis has one value, not zero, throughout, and another has noise."""
    held = values[all_of_rows(np.isfinite(values))]
    if len(held) < LEAST_REPEATS:
        return False
    is_stuck = (held == held[0]).all(axis=0) & (held[0] != 0.0)
    if not is_stuck.any():
        return False
    return bool(_axes(held, np.ones(held.shape, np.bool_), each).is_resolved.any())


class _Repeats(NamedTuple):
    """Rows that are those of a period before.

    Attributes:
        begin: row that is repeated first.
        end: so many rows in all are, less the begin.
        period: in rows; 1 where one row is repeated.
        axes: of the sensor, in which they are.
    """

    begin: int
    end: int
    period: int
    axes: slice = slice(None)

    def is_frozen(self, values: Floats, axes: _Axes, least: int) -> bool:
        step, resolved = axes.step[self.axes], axes.is_resolved[self.axes]
        length = self.end - self.begin
        if length * np.count_nonzero(resolved) < least:
            return False
        used = values[:, self.axes]
        if self.period > 1:
            reach = np.ptp(used[self.begin : self.begin + self.period], axis=0)
            return bool((reach > GENTLE_STEPS * step)[resolved].any())
        if self.begin == 0 and (axes.levels[self.axes] < COARSE_LEVELS).all():
            return False
        # what comes to rest, or leaves it, does so gently at one end
        changes = [
            np.abs(used[after] - used[after - 1]) / step
            for after in (self.begin, self.end + 1)
            if 0 < after < len(values)
        ]
        return not any((change <= GENTLE_STEPS).all() for change in changes)


def _repeats(values: Floats, each: int, least: int) -> Iterator[_Repeats]:
    same = values[1:] == values[:-1]
    for begin, end in _long_runs(all_of_rows(same), least // 3):
        yield _Repeats(begin, end, 1)
    for axis in range(3):
        for begin, end in _long_runs(same[:, axis], 3 * least // 2):
            yield _Repeats(begin, end, 1, slice(axis, axis + 1))
    for period in range(2, MAX_PERIOD_ROWS * each + 1):
        first = values[period:, 0] == values[:-period, 0]
        if np.count_nonzero(first) < least:
            continue
        again = first & all_of_rows(values[period:] == values[:-period])
        for begin, end in _long_runs(again, max(least, 2 * period)):
            if np.ptp(values[begin : begin + period], axis=0).any():
                yield _Repeats(begin, end, period)


def _long_runs(flags: Flags, least: int) -> list[tuple[int, int]]:
    """Return begin and end of runs of at least so many."""
    edges = np.flatnonzero(np.diff(flags, prepend=False, append=False))
    begins, ends = edges[::2], edges[1::2]
    is_long = ends - begins >= least
    return list(zip(begins[is_long].tolist(), ends[is_long].tolist(), strict=True))


def _axes(values: Floats, works: Flags, each: int) -> _Axes:
    steps, noises, reach = np.full(3, np.inf), np.zeros(3), np.zeros(3)
    for axis in range(3):
        held = values[works[:, axis], axis]
        held = held[np.isfinite(held)][::each]
        levels = np.unique(held[:SHOWN_VALUES])
        apart = np.diff(levels)
        apart = apart[apart > 1e-9 * np.abs(levels).max(initial=0.0)]
        if not len(apart):
            continue
        steps[axis], reach[axis] = apart.min(), levels[-1] - levels[0]
        windows = len(held) // WINDOW_READINGS
        if not windows:
            continue
        rows = held[: windows * WINDOW_READINGS].reshape(windows, WINDOW_READINGS)
        rms = np.sqrt(np.square(np.diff(rows, axis=1)).mean(axis=1) / 2.0)
        noises[axis] = np.percentile(rms, CALM_PERCENT)
    return _Axes(steps, noises >= RESOLVED_STEPS * steps, reach / steps)
