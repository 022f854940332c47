"""Counts what a live stream delivers, and marks where it delivers nothing."""

from collections import deque

import numpy as np

from hapticplayer.capture.recorded import MOST_GAPS, Gap
from hapticplayer.model.arrays import Floats

_STEPS = 20
_LATE = 1.5  # of the usual step: something is missing before it
_MARKED_S = 0.2
"""Shorter gaps are counted, longer ones marked as well."""


class StreamWatch:
    """One stream; all times are media times.

    Args:
        name: for the gaps.
        stall_s: nothing for so long is a stall.
    """

    def __init__(self, name: str, stall_s: float) -> None:
        self.name, self.stall_s = name, stall_s
        self.count = self.dropped = 0
        self.gaps: list[Gap] = []
        self.is_stalled = False
        self._steps: deque[float] = deque(maxlen=_STEPS)
        self._last: tuple[float, float] | None = None
        self._seen_s: float | None = None

    @property
    def usual_step_s(self) -> float:
        """Median of the last steps; 0 before there are any."""
        return float(np.median(list(self._steps))) if self._steps else 0.0

    @property
    def rate_hz(self) -> float:
        return 1.0 / self.usual_step_s if self.usual_step_s else 0.0

    def take(self, at_s: Floats, seen_s: float, stamp_s: Floats | None = None) -> None:
        """Count what was taken at these times and came at `seen_s`.

        Steps are those of the stamps, where its own clock is known only roughly yet.
        """
        stamps_s = at_s if stamp_s is None else stamp_s
        for one_s, own_s in zip(at_s.tolist(), stamps_s.tolist(), strict=True):
            self._take(one_s, own_s)
        self._seen_s, self.is_stalled = seen_s, False

    def _take(self, at_s: float, stamp_s: float) -> None:
        self.count += 1
        before, self._last = self._last, (at_s, stamp_s)
        if before is None or stamp_s <= before[1]:
            return
        step_s, usual_s = stamp_s - before[1], self.usual_step_s
        if usual_s and step_s > _LATE * usual_s:
            self._miss(before[0], at_s, round(step_s / usual_s) - 1)
        self._steps.append(step_s)

    def drop(self) -> None:
        """Count what came and could not be used."""
        self.dropped += 1

    def _miss(self, begin_s: float, end_s: float, missing: int) -> None:
        self.dropped += missing
        if end_s - begin_s > _MARKED_S and len(self.gaps) < MOST_GAPS:
            self.gaps.append(
                Gap(self.name, round(begin_s, 6), round(end_s, 6), missing)
            )

    def stalls(self, now_s: float) -> bool:
        """Whether it has just fallen silent."""
        if self._seen_s is None:
            self._seen_s = now_s
        if self.is_stalled or now_s - self._seen_s < self.stall_s:
            return False
        self.is_stalled = True
        return True

    def lose(self) -> None:
        """It is gone, and somebody knows: its silence is no news."""
        self.is_stalled = True

    def end(self, end_s: float) -> None:
        """Mark a gap that lasts until the end of the recording."""
        last_s = end_s if self._last is None else self._last[0]
        if end_s - last_s > max(_MARKED_S, self.stall_s):
            self._miss(last_s, end_s, round((end_s - last_s) * self.rate_hz))
