"""Samples of the force tracks around the position, reduced to what a plot can show."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from hapticplayer.model import ForceTrack


class ViewSpan(QObject):
    """Zoom and pan, shared by plots that go together."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.half_s = HALF_WINDOW_S
        self.offset_s = 0.0

    def around(self, media_s: float) -> tuple[float, float]:
        """Return the first and the last second for a playhead."""
        middle_s = media_s + self.offset_s
        return middle_s - self.half_s, middle_s + self.half_s

    def zoom(self, factor: float) -> None:
        """Show more (above 1) or fewer seconds, around the middle of the view."""
        half_s = min(LONGEST_HALF_S, max(SHORTEST_HALF_S, self.half_s * factor))
        if half_s != self.half_s:
            self.half_s = half_s
            self.changed.emit()

    def pan(self, by_s: float) -> None:
        """Show later (+) or earlier (-) seconds than those around the playhead."""
        self.offset_s += by_s
        self.changed.emit()

    def reset(self) -> None:
        """Show the seconds around the playhead again."""
        self.half_s, self.offset_s = HALF_WINDOW_S, 0.0
        self.changed.emit()


Floats = NDArray[np.float64]

HALF_WINDOW_S = 4.0
SHORTEST_HALF_S, LONGEST_HALF_S = 0.5, 30.0  # by zooming
PAGE_MARGIN_S = 2.0
MOST_POINTS = 800
TRACK_RATE_HZ = 200.0  # of the recordings; finer than a pixel after thinning
TRAIL_STEP_S = 0.010  # of media time between two points of what was sent
JUMP_S = 0.100
_TRAIL_MARGIN_S = 0.2  # behind the view, between two refreshes


class Page(NamedTuple):
    """Values (N, 3) at media times (N,), drawn around a playhead."""

    time_s: Floats
    values: Floats


EMPTY = Page(np.empty(0), np.empty((0, 3)))


def cut(time_s: Floats, values: Floats, first_s: float, last_s: float) -> Page:
    """Return the rows from `first_s` to `last_s`, and one more at either side."""
    first = max(0, int(np.searchsorted(time_s, first_s, side="left")) - 1)
    last = int(np.searchsorted(time_s, last_s, side="right")) + 1
    return Page(time_s[first:last], values[first:last])


def thin(page: Page, most_points: int = MOST_POINTS) -> Page:
    """Return at most `most_points` rows in which every peak is still there.

    Each block of rows becomes its lowest and its highest value, in their order.
    """
    count = len(page.time_s)
    if count <= most_points:
        return page
    size = -(-count // (most_points // 2))
    blocks = count // size
    kept = blocks * size
    rows = page.values[:kept].reshape(blocks, size, -1)
    low, high = rows.min(axis=1), rows.max(axis=1)
    low_first = rows.argmin(axis=1) <= rows.argmax(axis=1)
    values = np.empty((2 * blocks, rows.shape[2]))
    values[0::2] = np.where(low_first, low, high)
    values[1::2] = np.where(low_first, high, low)
    times = np.empty(2 * blocks)
    times[0::2] = page.time_s[:kept:size]
    times[1::2] = page.time_s[size // 2 : kept : size]
    if kept == count:
        return Page(times, values)
    rest = thin(Page(page.time_s[kept:], page.values[kept:]), 2)
    return Page(np.append(times, rest.time_s), np.append(values, rest.values, axis=0))


def sampled(track: ForceTrack, first_s: float, last_s: float) -> Page:
    """Return a force track as it will be played, on a regular grid."""
    first, last = round(first_s * TRACK_RATE_HZ), round(last_s * TRACK_RATE_HZ)
    time_s = np.arange(max(0, first), max(0, last) + 1) / TRACK_RATE_HZ
    return thin(Page(time_s, track.at(time_s)))


def half_range(peak: float, least: float) -> float:
    """Return a round number that the peak fits under, for an axis around zero."""
    wanted = max(least, 1.05 * peak)
    decade = 10.0 ** np.floor(np.log10(wanted))
    steps = np.array([1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0]) * decade
    return float(steps[np.searchsorted(steps, wanted * (1.0 - 1e-9))])


class Trail:
    """What was sent to the device, over media time, since the last jump."""

    def __init__(self) -> None:
        self._rows = EMPTY
        self._head = EMPTY
        self.last_tick_s = float("-inf")

    def add(self, ticks: NDArray[Any]) -> bool:
        """Append records of TICK that are newer; return whether there is more to see."""
        ticks = ticks[ticks["monotonic_s"] > self.last_tick_s]
        if not len(ticks):
            return False
        self.last_tick_s = float(ticks["monotonic_s"][-1])
        if len(self._head.time_s) and self._stands(ticks):
            return False
        time_s = np.append(self._rows.time_s, ticks["media_s"])
        values = np.append(self._rows.values, ticks["force_n"], axis=0)
        known = len(self._rows.time_s)
        step_s = np.diff(time_s)
        # a pause steps back by what the loop had extrapolated: no jump
        jumps = np.flatnonzero(np.abs(step_s) > JUMP_S)
        start = int(jumps[-1]) + 1 if len(jumps) else 0
        oldest_s = time_s[-1] - LONGEST_HALF_S - _TRAIL_MARGIN_S
        start = max(start, int(np.searchsorted(time_s[start:], oldest_s)) + start)
        keep = _spaced(time_s, max(start, known), last_kept=known - 1 >= start)
        rows = np.concatenate([np.arange(start, known), keep]).astype(np.intp)
        self._rows = Page(time_s[rows], values[rows])
        self._head = Page(time_s[-1:], values[-1:])
        return True

    def _stands(self, ticks: NDArray[Any]) -> bool:
        """Whether all of these are as the newest one."""
        head, is_there = self._head, ticks["media_s"] == self._head.time_s
        return bool(is_there.all() and (ticks["force_n"] == head.values).all())

    def page(self) -> Page:
        """Return the points, the newest tick last."""
        return Page(
            np.append(self._rows.time_s, self._head.time_s),
            np.append(self._rows.values, self._head.values, axis=0),
        )


def _spaced(time_s: Floats, first: int, *, last_kept: bool) -> NDArray[np.intp]:
    """Return rows from `first` on, one for each step of the grid of media time."""
    cells = np.maximum.accumulate(np.floor(time_s[first:] / TRAIL_STEP_S))
    before = np.floor(time_s[first - 1] / TRAIL_STEP_S) if last_kept else -np.inf
    cells = np.maximum(cells, before)
    is_new = np.diff(cells, prepend=before) > 0
    return np.flatnonzero(is_new) + first
