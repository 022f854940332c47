"""Local level, slope and spread of a signal, robust against a few outliers.

A Hampel test compares a sample with the median of its window in units of the median
absolute deviation (Hampel 1974; Pearson 2002). Motion has slopes, on which the plain
MAD grows until nothing stands out, so the window is first straightened: the slope is
the difference between the medians of its halves, over their distance.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Indices, Mask

SIGMA_PER_MAD = 1.4826
"""Standard deviation over MAD of a Gaussian."""
BLOCK_ROWS = 1 << 16


@dataclass(frozen=True, slots=True, eq=False)
class Deviations:
    """Windows around rows, straightened.

    Attributes:
        index: (R, W) sample numbers of each window.
        value: (R, W) deviation from the window's line.
        line: (R, W) that line.
        sigma: (R,) robust standard deviation of `value`.
    """

    index: Indices
    value: Floats
    line: Floats
    sigma: Floats

    def at(self, rows: Indices) -> tuple[Floats, Floats]:
        """Return deviation and line (R,) at the rows themselves."""
        place = (rows - self.index[:, 0])[:, None]
        value = np.take_along_axis(self.value, place, axis=1)[:, 0]
        return value, np.take_along_axis(self.line, place, axis=1)[:, 0]


@dataclass(frozen=True, slots=True, eq=False)
class Neighbourhood:
    """Windows of 2 half + 1 samples that don't reach across gaps.

    Attributes:
        half: samples on each side; near an end the window is shifted inwards.
        begins: (K,) first sample of each stretch without gaps.
        ends: (K,) one past its last.
    """

    half: int
    begins: Indices
    ends: Indices

    @classmethod
    def of(cls, time_s: Floats, half: int) -> "Neighbourhood":
        """Return the windows of a recording with times (N,), N >= 2."""
        cuts = np.flatnonzero(timing.gaps(time_s, timing.median_step_s(time_s))) + 1
        begins = np.concatenate(([0], cuts)).astype(np.intp)
        return cls(half, begins, np.concatenate((cuts, [len(time_s)])).astype(np.intp))

    def bounds(self, rows: Indices) -> tuple[Indices, Indices]:
        """Return first and one-past-last sample (R,) of the stretches of `rows`."""
        stretch = np.searchsorted(self.begins, rows, side="right") - 1
        return self.begins[stretch], self.ends[stretch]

    def has_window(self, rows: Indices) -> Mask:
        """Return (R,) True where the stretch is long enough for a window."""
        begin, end = self.bounds(rows)
        return np.asarray(end - begin > 2 * self.half)

    def deviations(self, column: Floats, rows: Indices) -> Deviations:
        """Return the straightened windows of (N,) around rows that have one."""
        begin, end = self.bounds(rows)
        width = 2 * self.half + 1
        first = np.clip(rows - self.half, begin, end - width)
        index = first[:, None] + np.arange(width)
        window = column[index]
        left = np.median(window[:, : self.half], axis=1)
        right = np.median(window[:, self.half + 1 :], axis=1)
        slope = (right - left) / (self.half + 1)
        line = slope[:, None] * np.arange(-self.half, self.half + 1)
        line += np.median(window - line, axis=1)[:, None]
        value = window - line
        sigma = SIGMA_PER_MAD * np.median(np.abs(value), axis=1)
        return Deviations(index, value, line, sigma)


def blocks(rows: Indices) -> Iterator[slice]:
    """Yield slices of `rows`, so that the windows of all never exist at once."""
    for begin in range(0, len(rows), BLOCK_ROWS):
        yield slice(begin, begin + BLOCK_ROWS)
