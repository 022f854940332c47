"""From force to two motors: how strong, and how rough.

The large motor turns slowly and follows the magnitude of the force; the small one
turns fast and follows what in that magnitude changes faster than about 10 Hz.
"""

import math

from hapticplayer.model.device import Vector

FULL_N = 4.5
"""Force at which the large motor runs as fast as it can."""
SPLIT_HZ = 10.0
HOLD_S = 0.03
"""A short jolt stays on the small motor for so long, or it would not spin up."""
FULL_LEVEL = 255


class Rumble:
    """Follows a force, one value at a time."""

    def __init__(self) -> None:
        self._slow_n = self._rough_n = 0.0
        self._last_s: float | None = None

    def levels(self, force_n: Vector, now_s: float) -> tuple[int, int]:
        """Return levels (large, small) of 0 to 255; zero force is zero at once."""
        x, y, z = force_n
        size_n = math.hypot(x, y, z)
        if not 0.0 < size_n < math.inf:
            self._slow_n = self._rough_n = 0.0
            self._last_s = now_s
            return 0, 0
        elapsed_s = 0.0 if self._last_s is None else now_s - self._last_s
        self._last_s = now_s
        share = -math.expm1(-2.0 * math.pi * SPLIT_HZ * elapsed_s)
        self._slow_n += share * (size_n - self._slow_n)
        fading = math.exp(-elapsed_s / HOLD_S)
        self._rough_n = max(abs(size_n - self._slow_n), fading * self._rough_n)
        return _level(size_n), _level(self._rough_n)


def _level(force_n: float) -> int:
    return min(FULL_LEVEL, round(FULL_LEVEL * force_n / FULL_N))
