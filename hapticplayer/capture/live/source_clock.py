"""The clock of a live source, seen through the delays of its link.

A sample arrives later than it was measured, by a delay that is never below a least one.
So pairs of stamp and arrival lie above a line; its slope is the rate of the clock. Of each
window the pair with the least delay counts: their delays above the line are exponential,
whatever those of the link are, and the line is the likeliest one with the rate that
oscillators have. The least delay itself stays in the offset; taps or frames correct it.

Source: Moon, Skelly, Towsley, Estimation and removal of clock skew from network delay
measurements, 1999 (the line below all pairs); the prior of the rate is ours.
"""

import math

import numpy as np

from hapticplayer.model.arrays import Floats

QUARTZ_SIGMA, COUNTED_SIGMA = 50e-6, 5e-3
"""Relative SD of rates: of a crystal, and of samples counted by a nominal period."""

_WINDOW_S = 2.0
_LEAST_SCALE_S = 1e-4
_BISECTIONS = 40


class SourceClock:
    """From stamps of a source to the machine's monotonic clock; better with each pair.

    The estimate uses what has been added so far: asked while samples come it is causal,
    asked at the end it is that of all pairs.

    Args:
        rate_sigma: relative SD of its rate.
        least_delay_s: what its link may take at least.
    """

    def __init__(
        self, rate_sigma: float = QUARTZ_SIGMA, least_delay_s: float = 0.001
    ) -> None:
        self._sigma, self._least_s = rate_sigma, least_delay_s
        self._minima: list[tuple[float, float]] = []
        self._origin = (0.0, 0.0)
        self._window = -1
        self._slope, self._offset_s, self._scale_s = 0.0, math.nan, math.nan
        self._is_current = True

    def add(self, stamp_s: Floats, arrival_s: Floats) -> None:
        """Take pairs (n,) of both clocks, in their order."""
        if not len(stamp_s):
            return
        if self._window < 0:
            self._origin = float(stamp_s[0]), float(arrival_s[0])
        since_s = stamp_s - self._origin[0]
        delay_s = arrival_s - self._origin[1] - since_s
        windows = np.floor(since_s / _WINDOW_S)
        for window in np.unique(windows).tolist():
            rows = np.flatnonzero(windows == window)
            above = delay_s[rows] - self._slope * since_s[rows]
            least = rows[int(np.argmin(above))]
            self._take(window, float(since_s[least]), float(delay_s[least]))

    def _take(self, window: float, since_s: float, delay_s: float) -> None:
        if window > self._window:
            self._minima.append((since_s, delay_s))
            self._window = int(window)
        elif window == self._window:
            held_s, held_delay_s = self._minima[-1]
            if delay_s - held_delay_s >= self._slope * (since_s - held_s):
                return
            self._minima[-1] = since_s, delay_s
        else:
            return  # a stamp that is out of order tells no more than its window did
        self._is_current = False

    def host_s(self, stamp_s: Floats) -> Floats:
        """When stamps (n,) were, on the machine's clock; NaN before the first pair."""
        self._solve()
        since_s = np.asarray(stamp_s) - self._origin[0]
        return np.asarray(
            self._origin[1] + self._offset_s + (1.0 + self._slope) * since_s
        )

    @property
    def rate_ppm(self) -> float:
        """By how much the machine's clock is faster than the source's."""
        self._solve()
        return 1e6 * self._slope

    @property
    def residual_s(self) -> float:
        """How far stamps may be off: the envelope's own scatter and the least delay.

        Infinite before the first pair.
        """
        self._solve()
        return math.hypot(self._scale_s, self._least_s) if self._minima else math.inf

    def line(self) -> tuple[float, float]:
        """Offset and rate: machine's time = rate * stamp + offset."""
        rate = 1.0 + self.rate_ppm * 1e-6
        return float(self.host_s(np.zeros(1))[0]), rate

    def _solve(self) -> None:
        if self._is_current or not self._minima:
            return
        self._is_current = True
        at_s, delay_s = np.array(self._minima).T
        scale_s = _scale_s(delay_s)
        for _ in range(2):  # the scale is that above the line, which goes by the scale
            self._slope = _likeliest_slope(at_s, delay_s, scale_s, self._sigma)
            above = delay_s - self._slope * at_s
            self._offset_s = float(above.min())
            scale_s = _scale_s(above)
        self._scale_s = scale_s


def _scale_s(delay_s: Floats) -> float:
    """The scale of exponential delays, by their median: a link that was down is none."""
    median_s = float(np.median(delay_s) - delay_s.min())
    return max(_LEAST_SCALE_S, median_s / math.log(2.0))


def _likeliest_slope(
    at_s: Floats, delay_s: Floats, scale_s: float, sigma: float
) -> float:
    """The slope of the line below all points that is likeliest, given its prior.

    The log likelihood is concave in the slope: its derivative is bisected.
    """
    count, mean_s = len(at_s), float(at_s.mean())

    def derivative(slope: float) -> float:
        touched_s = float(at_s[int(np.argmin(delay_s - slope * at_s))])
        return count * (mean_s - touched_s) / scale_s - slope / sigma**2

    low, high = -8.0 * sigma, 8.0 * sigma
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        if derivative(middle) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
