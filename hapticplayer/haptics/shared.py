"""The block of memory that the player and the haptics process share.

One writer per field. The clock lives in two slots (see `slots`), so that a player
killed in mid-write cannot make the loop spin. Ticks go through a ring that the loop
never waits for.
"""

import mmap
import os
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.slots import Slots
from hapticplayer.model import PlaybackClock

TICK = np.dtype(
    [
        ("monotonic_s", "<f8"),
        ("media_s", "<f8"),
        ("planned_n", "<f4", (3,)),
        ("force_n", "<f4", (3,)),
        ("position_m", "<f4", (3,)),
        ("velocity_mps", "<f4", (3,)),
        ("centring_n", "<f4", (3,)),
        ("lateness_s", "<f4"),
        ("reply_age_s", "<f4"),
        ("heat_n", "<f4"),
        ("missed", "<u4"),
        ("mode", "u1"),
        ("cause", "u1"),
        ("buttons", "<u2"),
    ]
)
"""One exchange with the device, as it is kept in the ring and in records.

`planned_n` is what the track says, `force_n` what went to the device, `centring_n`
the share of it that keeps the grip inside, `heat_n` the RMS force of the last 10 s.
"""

RING_TICKS = 1 << 15  # 32 s: a reader may sleep that long without losing a tick
_TICK = struct.Struct("<dd18fIBBH")
_CLOCK = struct.Struct("<qqdddd")  # track id, epoch, the four numbers of the clock
_SLOTS_AT = (64, 128)
# a cache line for each writer
_NEWEST_AT, _HEARTBEAT_AT, _HEAD_AT, _GUARD_AT = 192, 256, 320, 384
_RING_AT = 4096
BLOCK_BYTES = _RING_AT + RING_TICKS * TICK.itemsize

assert _TICK.size == TICK.itemsize == 96


class SharedBlock:
    """Typed access to the block; both sides hold one."""

    def __init__(self, descriptor: int) -> None:
        if os.fstat(descriptor).st_size != BLOCK_BYTES:
            raise ValueError("the shared block has another size; versions differ")
        self._map = mmap.mmap(descriptor, BLOCK_BYTES)
        view = memoryview(self._map)
        self._clock = Slots(self._map, _CLOCK, _SLOTS_AT, _NEWEST_AT)
        self.clock_bytes = self._clock.raw  # for the loop: equal bytes, equal clock
        self._heartbeat = view[_HEARTBEAT_AT : _HEARTBEAT_AT + 8].cast("d")
        self._head = view[_HEAD_AT : _HEAD_AT + 8].cast("Q")
        self._last_tick = view[_HEAD_AT + 8 : _HEAD_AT + 16].cast("d")
        self._guard = view[_GUARD_AT : _GUARD_AT + 8].cast("d")
        self._ticks: NDArray[Any] = np.frombuffer(
            self._map, dtype=TICK, count=RING_TICKS, offset=_RING_AT
        )

    def write_clock(self, clock: PlaybackClock, track_id: int) -> None:
        """Publish the clock and the track it belongs to (player)."""
        self._clock.write(
            track_id,
            clock.epoch,
            clock.monotonic0_s,
            clock.media0_s,
            clock.rate,
            clock.valid_until_s,
        )

    def read_clock(self) -> tuple[PlaybackClock, int] | None:
        """Return the newest clock and its track, or None if none could be read."""
        fields = self._clock.read()
        return None if fields is None else (PlaybackClock(*fields[1:]), fields[0])

    def beat(self, now_s: float) -> None:
        """Say that the player's main thread is alive (player)."""
        self._heartbeat[0] = now_s

    def heartbeat_s(self) -> float:
        """Return the time of the last beat."""
        return self._heartbeat[0]

    def beat_guard(self, now_s: float) -> None:
        """Say that the guard watches (guard)."""
        self._guard[0] = now_s

    def guard_s(self) -> float:
        """Return the time of the guard's last beat."""
        return self._guard[0]

    def last_tick_s(self) -> float:
        """Return the time of the loop's last exchange; 0 before the first."""
        return self._last_tick[0]

    def beat_loop(self, now_s: float) -> None:
        """Say that a program without ticks is alive; 0: it holds no force (loop)."""
        self._last_tick[0] = now_s

    def write_tick(self, count: int, now_s: float, *fields: float) -> None:
        """Store tick number `count`, done at `now_s`, and publish it (loop)."""
        at = _RING_AT + (count % RING_TICKS) * _TICK.size
        _TICK.pack_into(self._map, at, now_s, *fields)
        self._last_tick[0] = now_s
        self._head[0] = count + 1

    def read_ticks(self, tail: int) -> tuple[NDArray[Any], int, int]:
        """Return ticks since `tail`: (records, new tail, number lost).

        Never blocks the writer; ticks that it overwrote meanwhile count as lost.
        """
        head = int(self._head[0])
        first = max(tail, head - RING_TICKS)
        begin, count = first % RING_TICKS, head - first
        records = self._ticks[begin : begin + count].copy()
        if len(records) < count:  # around the end of the ring
            rest = self._ticks[: count - len(records)]
            whole = np.empty(count, dtype=TICK)
            whole[: len(records)], whole[len(records) :] = records, rest
            records = whole
        # the slot of tick `head` may be half written while we copy
        safe = int(self._head[0]) - RING_TICKS + 1
        if safe > first:
            records = records[min(safe - first, len(records)) :]
            first = safe
        return records, head, max(0, min(first, head) - tail)
