"""What is measured while playing: lateness of the loop, force against picture and sound."""

from collections import deque
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import LoopStats, SyncStats
from hapticplayer.playback.tally import Tally

HISTORY_TICKS = 12_000
STATS_TICKS = 10_000
TRACE_EVENTS = 1800  # 30 s of pictures at 60 Hz
_LATEST_US, _LATENESS_STEP_US = 20_000.0, 1.0
_FARTHEST_MS, _DIFFERENCE_STEP_MS = 200.0, 0.02
_COUNTED_TOGETHER = 20  # reads: a second
_EMPTY = np.empty(0, dtype=TICK)


class TickHistory:
    """The last ticks for plots and stats, and the lateness of all of them."""

    def __init__(self) -> None:
        self._chunks: deque[NDArray[Any]] = deque()
        self._kept = 0
        self._lateness_us = Tally(0.0, _LATEST_US, _LATENESS_STEP_US)
        self._uncounted: list[NDArray[Any]] = []
        self._missed = 0
        self._is_followed = False
        self.lost = 0

    def add(self, records: NDArray[Any], lost: int) -> None:
        """Append what came from the ring."""
        self.lost += lost
        if not len(records):
            return
        self._chunks.append(records)
        self._kept += len(records)
        while self._kept - len(self._chunks[0]) >= HISTORY_TICKS:
            self._kept -= len(self._chunks.popleft())
        self._uncounted.append(records)
        if len(self._uncounted) >= _COUNTED_TOGETHER:
            self._count()

    def _count(self) -> None:
        """Count what came: in few large pieces, where many small ones cost ten times."""
        reads, self._uncounted = self._uncounted, []
        self._lateness_us.add(_field(reads, "lateness_s") * np.float32(1e6))
        self._missed += int(_field(reads, "missed").sum())

    def recent(self) -> NDArray[Any]:
        """Return the last 12 s of ticks, oldest first."""
        return _joined(list(self._chunks))

    def since(self, monotonic_s: float) -> NDArray[Any]:
        """Return the reads that hold ticks after a time, oldest first, for who follows."""
        self._is_followed = True
        return self.read_since(monotonic_s)

    def was_followed(self) -> bool:
        """Whether somebody has asked for ticks since the last call of this."""
        was, self._is_followed = self._is_followed, False
        return was

    def read_since(self, monotonic_s: float) -> NDArray[Any]:
        """Return the same for a look now and then."""
        newer: list[NDArray[Any]] = []
        for chunk in reversed(self._chunks):
            if chunk["monotonic_s"][-1] <= monotonic_s:
                break
            newer.append(chunk)
        return _joined(newer[::-1])

    def latest(self) -> Any:
        """Return the newest tick, or None."""
        return self._chunks[-1][-1] if self._chunks else None

    def recent_stats(self) -> LoopStats | None:
        """Return the health over the last 10 s."""
        reads = list(self._chunks)
        lateness_s = _field(reads, "lateness_s")[-STATS_TICKS:]
        if not len(lateness_s):
            return None
        missed = _field(reads, "missed")[-STATS_TICKS:]
        return _loop_stats(lateness_s * 1e6, int(missed.sum()))

    def total_stats(self) -> LoopStats | None:
        """Return the health over everything."""
        self._count()
        late = self._lateness_us
        if not late.count:
            return None
        p50, p99, p999 = late.percentiles(50.0, 99.0, 99.9)
        return LoopStats(late.count, self._missed, p50, p99, p999, late.most)


class SyncMeter:
    """How much later the force of a moment comes than its picture or its sound.

    An event (a picture shown, a sound heard) at monotonic time t belongs to media
    time m. The loop's own record says which media time m_h it played at t; the
    force that belongs to m is m - m_h later than the event.
    """

    def __init__(self) -> None:
        self._pending: list[tuple[float, float]] = []
        self._total_ms = Tally(-_FARTHEST_MS, _FARTHEST_MS, _DIFFERENCE_STEP_MS)
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
        """Compare the noted events with the loop's record.

        Args:
            ticks: recent ticks, oldest first; events newer than the last one wait.

        Returns:
            The differences that are new, ms.
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
        """Return the last 600 events (20 s of pictures at 30 Hz)."""
        return _sync_stats(np.array(self._recent_ms))

    def total(self) -> SyncStats | None:
        """Return all events."""
        total = self._total_ms
        if not total.count:
            return None
        p05, p50, p95 = total.percentiles(5.0, 50.0, 95.0)
        return SyncStats(total.count, p05, p50, p95)


def _joined(chunks: list[NDArray[Any]]) -> NDArray[Any]:
    """Return chunks as one; as plain bytes, for numpy joins records 20 times slower."""
    if not chunks:
        return _EMPTY
    plain = np.dtype((np.void, TICK.itemsize))
    return np.concatenate([chunk.view(plain) for chunk in chunks]).view(TICK)


def _field(reads: list[NDArray[Any]], name: str) -> NDArray[Any]:
    """Return one field of all reads; a thirtieth of the memory that whole records take."""
    return np.concatenate([_EMPTY[name], *(read[name] for read in reads)])


def _loop_stats(lateness_us: NDArray[Any], missed: int) -> LoopStats:
    p50, p99, p999 = np.percentile(lateness_us, [50.0, 99.0, 99.9])
    return LoopStats(
        len(lateness_us),
        missed,
        float(p50),
        float(p99),
        float(p999),
        float(lateness_us.max()),
    )


def _sync_stats(difference_ms: NDArray[np.float64]) -> SyncStats | None:
    if not len(difference_ms):
        return None
    p05, p50, p95 = np.percentile(difference_ms, [5.0, 50.0, 95.0])
    return SyncStats(len(difference_ms), float(p05), float(p50), float(p95))
