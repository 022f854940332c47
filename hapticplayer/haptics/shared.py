"""The shared block as the player has it: with the ticks of the loop."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.block import (
    BLOCK_BYTES,
    RING_AT,
    RING_TICKS,
    TICK_FIELDS,
    LoopBlock,
)

__all__ = ["BLOCK_BYTES", "RING_TICKS", "TICK", "SharedBlock"]

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

assert TICK_FIELDS.size == TICK.itemsize == 96


class SharedBlock(LoopBlock):
    """Typed access to the block."""

    def __init__(self, descriptor: int) -> None:
        super().__init__(descriptor)
        # as plain bytes: numpy copies records field by field
        self._ticks: NDArray[Any] = np.frombuffer(
            self._map, dtype=(np.void, TICK.itemsize), count=RING_TICKS, offset=RING_AT
        )

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
            whole = np.empty(count, dtype=self._ticks.dtype)
            whole[: len(records)], whole[len(records) :] = records, rest
            records = whole
        records = records.view(TICK)
        # the slot of tick `head` may be half written while we copy
        safe = int(self._head[0]) - RING_TICKS + 1
        if safe > first:
            records = records[min(safe - first, len(records)) :]
            first = safe
        return records, head, max(0, min(first, head) - tail)
