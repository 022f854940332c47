"""Joins the sensors of a phone, each with times of its own, as they come."""

import bisect
import math
from collections.abc import Sequence

from hapticplayer.capture.live.source import Samples

ACCEL, RATE, GRAVITY = "accel", "rate", "gravity"
_WAIT_S, _MOST_GAP_S, _BEFORE_S, _MOST = 0.25, 0.1, 1.0, 20_000
_ANEW_S = 5.0  # stamps that go back so far are those of another clock
_NONE = (math.nan,) * 3
_Sample = tuple[float, float, tuple[float, float, float]]


class SensorJoin:
    """Samples at the times of the accelerometer, with the angular rate interpolated.

    A sample waits until the gyroscope has gone past it, at most 0.25 s by the
    accelerometer's clock; then it goes without a rate.

    Args:
        with_gravity: whether gravity comes by itself, and is added.
    """

    def __init__(self, with_gravity: bool = False) -> None:
        self._accel: list[_Sample] = []
        self._others: dict[str, list[_Sample]] = {RATE: []}
        if with_gravity:
            self._others[GRAVITY] = []
        self._last_s = -math.inf

    def add(
        self, sensor: str, stamp_s: float, values: Sequence[float], arrival_s: float
    ) -> None:
        """Take a sample of a sensor; those that are not finite, or late, are left out."""
        held = self._accel if sensor == ACCEL else self._others.get(sensor)
        whole = (stamp_s, arrival_s, *values)
        if held is None or len(whole) != 5 or not all(map(math.isfinite, whole)):
            return
        newest_s = self._accel[-1][0] if self._accel else self._last_s
        if sensor == ACCEL and stamp_s < newest_s - _ANEW_S:
            self._begin_anew()
        first_s = self._last_s if sensor == ACCEL else self._last_s - _BEFORE_S
        # one far ahead would stand before all that follow
        is_ahead = stamp_s > self._last_s + _ANEW_S > -math.inf and sensor != ACCEL
        if stamp_s > first_s and not is_ahead:
            x, y, z = values
            bisect.insort(held, (stamp_s, arrival_s, (x, y, z)))
            del held[:-_MOST]

    def _begin_anew(self) -> None:
        """Forget what came by another clock, as before an app or a phone restarted."""
        for one in (self._accel, *self._others.values()):
            one.clear()
        self._last_s = -math.inf

    def without_gravity(self) -> None:
        """Take the accelerometer as it is from now on."""
        self._others.pop(GRAVITY, None)

    def take(self) -> Samples:
        """The samples that are complete now."""
        rows = []
        done = 0
        for stamp_s, arrival_s, accel in self._accel:
            is_late = self._accel[-1][0] - stamp_s > _WAIT_S
            if not (is_late or self._are_past(stamp_s)):
                break
            done += 1
            if stamp_s <= self._last_s:
                continue
            self._last_s = stamp_s
            rate = _between(self._others[RATE], stamp_s)
            x, y, z = self._gravity(stamp_s)
            force = accel[0] + x, accel[1] + y, accel[2] + z
            if not math.isnan(force[0]):
                rows.append((arrival_s, stamp_s, *force, *rate))
        del self._accel[:done]
        for held in self._others.values():
            del held[: bisect.bisect_left(held, (self._last_s - _BEFORE_S,))]
        return Samples.of(rows)

    def _gravity(self, stamp_s: float) -> tuple[float, float, float]:
        held = self._others.get(GRAVITY)
        return (0.0, 0.0, 0.0) if held is None else _between(held, stamp_s)

    def _are_past(self, stamp_s: float) -> bool:
        return all(held and held[-1][0] >= stamp_s for held in self._others.values())


def _between(held: list[_Sample], stamp_s: float) -> tuple[float, float, float]:
    """The values of a sensor at a time, NaN where none are near."""
    after = bisect.bisect_left(held, (stamp_s,))
    if after < len(held) and held[after][0] == stamp_s:
        return held[after][2]
    if not 0 < after < len(held):
        return _NONE
    (before_s, _, low), (after_s, _, high) = held[after - 1], held[after]
    if after_s - before_s > _MOST_GAP_S:
        return _NONE
    share = (stamp_s - before_s) / (after_s - before_s)
    x, y, z = (a + share * (b - a) for a, b in zip(low, high, strict=True))
    return x, y, z
