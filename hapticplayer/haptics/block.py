"""The block of memory that the player and the haptics process share.

One writer per field. The clock lives in two slots (see `slots`), so that a player
killed in mid-write cannot make the loop spin. Ticks go through a ring that the loop
never waits for; `shared` reads them. Without numpy: loop and guard load this.
"""

import mmap
import os
import struct
from collections.abc import Iterable
from typing import Any

from hapticplayer.haptics.lifeline import LIFELINE_BYTES
from hapticplayer.haptics.slots import Slots
from hapticplayer.model.device import MOST_CHANNELS, ChannelLevel
from hapticplayer.model.timing import PlaybackClock

RING_TICKS = 1 << 15  # 32 s: a reader may sleep that long without losing a tick
RESTING = -1.0
"""In place of the time of the loop's last exchange: no force until the guard has beaten."""
SENT, REFUSED = 1, 2
"""Bits of `buttons` where motion is sent: a packet belongs to the tick; nobody listens."""
TICK_FIELDS = struct.Struct("<dd18fIBBH")
_CLOCK = struct.Struct("<qqdddd")  # track id, epoch, the four numbers of the clock
_SLOTS_AT = (64, 128)
# a cache line for each writer
_NEWEST_AT, _HEARTBEAT_AT, _HEAD_AT, _GUARD_AT = 192, 256, 320, 384
_LIFELINE_AT = 448
_LEVELS = struct.Struct(f"<{MOST_CHANNELS}fBB")  # peaks; masks: played, limited
_LEVELS_AT = 512
RING_AT = 4096
BLOCK_BYTES = RING_AT + RING_TICKS * TICK_FIELDS.size


class LoopBlock:
    """Typed access to the block, but for the reading of ticks."""

    def __init__(self, descriptor: int) -> None:
        if os.fstat(descriptor).st_size != BLOCK_BYTES:
            raise ValueError("the shared block has another size; versions differ")
        self._map = mmap.mmap(descriptor, BLOCK_BYTES)
        view = memoryview(self._map)
        self._clock = Slots(self._map, _CLOCK, _SLOTS_AT, _NEWEST_AT)
        self._newest = view[_NEWEST_AT : _NEWEST_AT + 8].cast("Q")
        self._heartbeat = view[_HEARTBEAT_AT : _HEARTBEAT_AT + 8].cast("d")
        self._head = view[_HEAD_AT : _HEAD_AT + 8].cast("Q")
        self._last_tick = view[_HEAD_AT + 8 : _HEAD_AT + 16].cast("d")
        self._guard = view[_GUARD_AT : _GUARD_AT + 8].cast("d")
        self.lifeline = view[_LIFELINE_AT:][:LIFELINE_BYTES]  # of the loop

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
        """Report that the player's main thread is alive (player)."""
        self._heartbeat[0] = now_s

    def signs(self) -> tuple[int, float, float]:
        """Return the number of clocks, player's and guard's last beat (loop).

        The same number means the same clock.
        """
        return self._newest[0], self._heartbeat[0], self._guard[0]

    def beat_guard(self, now_s: float) -> None:
        """Report that the guard watches (guard)."""
        self._guard[0] = now_s

    def guard_s(self) -> float:
        """Return the time of the guard's last beat."""
        return self._guard[0]

    def last_tick_s(self) -> float:
        """Return the time of the loop's last exchange; 0 before the first, or RESTING."""
        return self._last_tick[0]

    def last_tick(self) -> tuple[Any, ...] | None:
        """Return the last tick of a loop that stands still, None before the first."""
        count = self._head[0]
        if not count:
            return None
        at = RING_AT + ((count - 1) % RING_TICKS) * TICK_FIELDS.size
        return TICK_FIELDS.unpack_from(self._map, at)

    def beat_loop(self, now_s: float) -> None:
        """Report that a program without ticks is alive; 0 or RESTING: no force (loop)."""
        self._last_tick[0] = now_s

    def write_levels(self, levels: Iterable[ChannelLevel]) -> None:
        """Publish how loud the channels of a sound card are (loop).

        Without a checksum: a meter may show two updates mixed.
        """
        peaks, played, limited = [0.0] * MOST_CHANNELS, 0, 0
        for channel, peak, is_limited in levels:
            peaks[channel - 1] = peak
            played |= 1 << channel - 1
            limited |= is_limited << channel - 1
        _LEVELS.pack_into(self._map, _LEVELS_AT, *peaks, played, limited)

    def levels(self) -> tuple[ChannelLevel, ...]:
        """Return the last levels, by channel; none from a device that has no sound."""
        *peaks, played, limited = _LEVELS.unpack_from(self._map, _LEVELS_AT)
        return tuple(
            ChannelLevel(number + 1, peak, bool(limited >> number & 1))
            for number, peak in enumerate(peaks)
            if played >> number & 1
        )

    def write_tick(self, count: int, now_s: float, *fields: float) -> None:
        """Store tick number `count`, done at `now_s`, and publish it (loop)."""
        at = RING_AT + (count % RING_TICKS) * TICK_FIELDS.size
        TICK_FIELDS.pack_into(self._map, at, now_s, *fields)
        self._last_tick[0] = now_s
        self._head[0] = count + 1
