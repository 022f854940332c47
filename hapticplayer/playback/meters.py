"""Measurements of playback: lateness of the loop, force against frames and sound."""

import math
import statistics
from collections import deque
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import LoopStats, SyncStats
from hapticplayer.model.device import ChannelLevel

HISTORY_TICKS = 12_000
STATS_TICKS = 10_000
TRACE_EVENTS = 1800  # 30 s of frames at 60 Hz
_LATEST_US, _LATENESS_STEP_US = 20_000.0, 1.0
_FARTHEST_MS, _DIFFERENCE_STEP_MS = 200.0, 0.02
# People do not notice a touch that comes up to 50 ms after what they see, but notice
# one that comes 15 ms before it (Di Luca & Mahnan 2019).
EARLY_MS, LATE_MS = -15.0, 50.0
BACK_MS = 5.0  # so far inside the limits an alarm ends
LEAST_EVENTS = 12  # half a second of frames or of reports of the sound
_ALARMS = {
    ("video", True): Message(
        "the force is {ms:.0f} ms ahead of the video: "
        "the computer may be overloaded; close other programs"
    ),
    ("video", False): Message(
        "the force is {ms:.0f} ms behind the video: "
        "the computer may be overloaded; close other programs"
    ),
    ("sound", True): Message(
        "the force is {ms:.0f} ms ahead of the sound: "
        "the computer may be overloaded; close other programs"
    ),
    ("sound", False): Message(
        "the force is {ms:.0f} ms behind the sound: "
        "the computer may be overloaded; close other programs"
    ),
}
"""By what the force is compared with, and whether it is early."""


class Histogram:
    """Counts values in even steps; those beyond the limits in the first and last one.

    A percentile is the mean of the values in its step (nearest rank): off by less than
    a step, and exact where all of them are equal.
    """

    def __init__(self, lowest: float, highest: float, step: float) -> None:
        self.count, self.most = 0, -math.inf
        self._lowest, self._step = lowest, step
        steps = math.ceil((highest - lowest) / step)
        self._counts = np.zeros(steps, np.int64)
        self._sums = np.zeros(steps)

    def add(self, values: NDArray[Any]) -> None:
        """Count more values."""
        if not len(values):
            return
        at = ((values - self._lowest) / self._step).astype(np.int64)
        at = np.minimum(np.maximum(at, 0), len(self._counts) - 1)
        np.add.at(self._counts, at, 1)
        np.add.at(self._sums, at, values)
        self.count += len(values)
        self.most = max(self.most, float(values.max()))

    def percentiles(self, *percent: float) -> list[float]:
        """Return them; there must be values."""
        ranks = np.ceil(np.array(percent) / 100.0 * self.count).clip(1, self.count)
        at = np.searchsorted(np.cumsum(self._counts), ranks)
        means: list[float] = (self._sums[at] / self._counts[at]).tolist()
        return means


class TickHistory:
    """The last ticks for plots and statistics, and the lateness of all of them."""

    def __init__(self) -> None:
        # as plain bytes: numpy copies records field by field, a hundred times slower;
        # with room for as many again, so that they are moved once in 12 s
        self._room = np.empty(2 * HISTORY_TICKS, (np.void, TICK.itemsize))
        self._end = 0
        self._latest: Any = None
        self._lateness_us = Histogram(0.0, _LATEST_US, _LATENESS_STEP_US)
        self._missed = 0
        self.lost = 0

    def add(self, records: NDArray[Any], lost: int) -> None:
        """Append what came from the ring."""
        self.lost += lost
        if len(records):
            self._append(records.view(self._room.dtype)[-HISTORY_TICKS:])
            self._latest = records[-1].copy()
            self._lateness_us.add(records["lateness_s"] * np.float32(1e6))
            self._missed += int(records["missed"].sum())

    def _append(self, rows: NDArray[Any]) -> None:
        if self._end + len(rows) > len(self._room):
            kept = self._rows
            self._room[: len(kept)], self._end = kept, len(kept)
        self._room[self._end : self._end + len(rows)] = rows
        self._end += len(rows)

    @property
    def _rows(self) -> NDArray[Any]:
        return self._room[max(0, self._end - HISTORY_TICKS) : self._end]

    @property
    def _ticks(self) -> NDArray[Any]:
        return self._rows.view(TICK)

    def since(self, monotonic_s: float) -> NDArray[Any]:
        """Return the ticks after a time, of the last 12 s, oldest first."""
        first = self._ticks["monotonic_s"].searchsorted(monotonic_s, side="right")
        return self._rows[int(first) :].copy().view(TICK)

    def latest(self) -> Any:
        """Return the newest tick, or None."""
        return self._latest

    def recent_stats(self) -> LoopStats | None:
        """Return the health over the last 10 s."""
        ticks = self._ticks[-STATS_TICKS:]
        if not len(ticks):
            return None
        lateness_us = ticks["lateness_s"] * 1e6
        p50, p99, p999 = np.percentile(lateness_us, [50.0, 99.0, 99.9]).tolist()
        missed, most_us = int(ticks["missed"].sum()), float(lateness_us.max())
        return LoopStats(len(ticks), missed, p50, p99, p999, most_us)

    def total_stats(self) -> LoopStats | None:
        """Return the health over everything."""
        late = self._lateness_us
        if not late.count:
            return None
        p50, p99, p999 = late.percentiles(50.0, 99.0, 99.9)
        return LoopStats(late.count, self._missed, p50, p99, p999, late.most)


class SyncMeter:
    """How much later the force of a moment comes than its frame or its sound.

    An event (a frame shown, a sound heard) at monotonic time t belongs to media
    time m. The loop's own record says which media time m_h it played at t; the
    force that belongs to m is m - m_h later than the event.
    """

    def __init__(self) -> None:
        self._pending: list[tuple[float, float]] = []
        self._total_ms = Histogram(-_FARTHEST_MS, _FARTHEST_MS, _DIFFERENCE_STEP_MS)
        self._recent_ms: deque[float] = deque(maxlen=600)
        self._trace: deque[tuple[float, float]] = deque(maxlen=TRACE_EVENTS)

    @property
    def oldest_s(self) -> float:
        """Monotonic time of the oldest event that waits, infinity without one."""
        return min((event[0] for event in self._pending), default=float("inf"))

    @property
    def is_waiting(self) -> bool:
        """Whether there are events to compare."""
        return bool(self._pending)

    def event(self, monotonic_s: float, media_s: float) -> None:
        """Note that something belonging to `media_s` came at `monotonic_s`."""
        self._pending.append((monotonic_s, media_s))

    def compare(self, ticks: NDArray[Any]) -> list[float]:
        """Compare the noted events with ticks, oldest first; return what is new, ms.

        Events newer than the last tick wait.
        """
        if not self._pending or not len(ticks):
            return []
        last_s = float(ticks["monotonic_s"][-1])
        ready = [event for event in self._pending if event[0] <= last_s]
        self._pending = [event for event in self._pending if event[0] > last_s]
        if not ready:
            return []
        at_s, media_s = np.array(ready).T
        row = np.searchsorted(ticks["monotonic_s"], at_s, side="right") - 1
        mode = ticks["mode"][row]
        moving = (mode == Mode.ENTERING) | (mode == Mode.FOLLOWING)
        moving &= row >= 0
        row = row[moving]
        elapsed_s = at_s[moving] - ticks["monotonic_s"][row]
        played_s = ticks["media_s"][row] + elapsed_s
        difference_ms = 1e3 * (media_s[moving] - played_s)
        self._total_ms.add(difference_ms)
        fresh_ms: list[float] = difference_ms.tolist()
        self._recent_ms.extend(fresh_ms)
        self._trace.extend(zip(at_s[moving].tolist(), fresh_ms, strict=True))
        return fresh_ms

    def trace(self) -> NDArray[np.float64]:
        """Return (monotonic s, difference ms) of the last events, (n, 2), oldest first."""
        return np.array(self._trace).reshape(-1, 2)

    def recent(self) -> SyncStats | None:
        """Return the last 600 events (20 s of frames at 30 Hz)."""
        return _sync_stats(np.array(self._recent_ms))

    def total(self) -> SyncStats | None:
        total = self._total_ms
        if not total.count:
            return None
        p05, p50, p95 = total.percentiles(5.0, 50.0, 95.0)
        return SyncStats(total.count, p05, p50, p95)


class SyncAlarm:
    """Watches the difference from "video" or "sound".

    `is_on` is whether the median of the last half second, `p50_ms`, lies outside the
    limits.
    """

    def __init__(self, against: str) -> None:
        self.is_on = False
        self.p50_ms = 0.0
        self._against = against
        self._last_ms: deque[float] = deque(maxlen=LEAST_EVENTS)

    def add(self, difference_ms: list[float]) -> bool:
        """Note how much later the force came; True when the alarm starts or ends."""
        self._last_ms.extend(difference_ms)
        if len(self._last_ms) < LEAST_EVENTS:
            return False
        self.p50_ms = statistics.median(self._last_ms)
        margin_ms = BACK_MS if self.is_on else 0.0
        was_on = self.is_on
        inside = EARLY_MS + margin_ms <= self.p50_ms <= LATE_MS - margin_ms
        self.is_on = not inside
        return self.is_on is not was_on

    def sentence(self) -> Message:
        template = _ALARMS[self._against, self.p50_ms < 0.0]
        return Message(template, ms=abs(self.p50_ms))


def _sync_stats(difference_ms: NDArray[np.float64]) -> SyncStats | None:
    if not len(difference_ms):
        return None
    p05, p50, p95 = np.percentile(difference_ms, [5.0, 50.0, 95.0])
    return SyncStats(len(difference_ms), float(p05), float(p50), float(p95))


class Loudest:
    """The largest level of each channel of a sound card; ask at 10 Hz or more.

    Peaks fall so slowly (`devices.transducer.meter`) that 50 ms cost 0.6 dB.
    """

    def __init__(self) -> None:
        self._channels: dict[int, ChannelLevel] = {}

    def add(self, levels: Iterable[ChannelLevel]) -> None:
        """Take what a meter shows now."""
        for now in levels:
            before = self._channels.get(now.channel, now)
            is_limited = now.is_limited or before.is_limited
            peak = max(now.peak, before.peak)
            self._channels[now.channel] = ChannelLevel(now.channel, peak, is_limited)

    def described(self) -> list[dict[str, Any]]:
        """Return channel, peak_db and is_limited of each, for logs and reports."""
        return [
            {
                "channel": one.channel,
                "peak_db": round(one.peak_db, 1),
                "is_limited": one.is_limited,
            }
            for one in self._channels.values()
        ]


def described(stats: SyncStats | None) -> dict[str, float] | None:
    """Return the figures of a difference, ms, for logs and records."""
    if stats is None:
        return None
    figures = {"p05": stats.p05_ms, "p50": stats.p50_ms, "p95": stats.p95_ms}
    rounded = {name: round(value, 3) for name, value in figures.items()}
    return {"count": stats.count, **rounded}
