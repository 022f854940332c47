"""What the simulated device felt, in memory that outlives every process.

A ring in a file or memfd: a benchmark that holds the descriptor reads when the zero
arrived, also when player, loop and device have died meanwhile.
"""

import mmap
import os
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.device import Vector

RECORD = np.dtype(
    [
        ("monotonic_s", "<f8"),
        ("applied_since_s", "<f8"),
        ("commanded_n", "<f4", (3,)),
        ("applied_n", "<f4", (3,)),
        ("position_m", "<f4", (3,)),
        ("refused", "<u4"),
    ]
)
"""One turn of the device: at `monotonic_s` it had `applied_n` on its motors, since
`applied_since_s`; `commanded_n` is the newest accepted command, `position_m` the true
position, `refused` the number of commands that came too late or made no sense."""

RING_RECORDS = 1 << 16
_RECORD = struct.Struct("<dd9fI")
_MAGIC = b"HPsimrec"
_RING_AT = 64
RECORD_BYTES = _RING_AT + RING_RECORDS * RECORD.itemsize

assert _RECORD.size == RECORD.itemsize


class Recorder:
    """Writer of the ring.

    Args:
        descriptor: of a file or memfd, open for writing; it is given its size.
    """

    def __init__(self, descriptor: int) -> None:
        os.ftruncate(descriptor, RECORD_BYTES)
        self._map = mmap.mmap(descriptor, RECORD_BYTES)
        self._map[:8] = _MAGIC
        self._head = memoryview(self._map)[8:16].cast("Q")
        self._head[0] = 0

    def write(
        self,
        now_s: float,
        since_s: float,
        commanded_n: Vector,
        applied_n: Vector,
        position_m: Vector,
        refused: int,
    ) -> None:
        """Append one turn, then publish it."""
        count = self._head[0]
        at = _RING_AT + (count % RING_RECORDS) * _RECORD.size
        _RECORD.pack_into(
            self._map,
            at,
            now_s,
            since_s,
            *commanded_n,
            *applied_n,
            *position_m,
            refused,
        )
        self._head[0] = count + 1


def read_record(descriptor: int) -> NDArray[Any]:
    """Return the newest turns, dtype RECORD, oldest first.

    While the device still writes, the oldest of a full ring may be torn.

    Raises:
        ValueError: when nothing was ever recorded there.
    """
    data = os.pread(descriptor, RECORD_BYTES, 0)
    if len(data) != RECORD_BYTES or data[:8] != _MAGIC:
        raise ValueError("this is no record of the simulated device")
    head = int.from_bytes(data[8:16], "little")
    ring: NDArray[Any] = np.frombuffer(data, RECORD, RING_RECORDS, _RING_AT)
    if head <= RING_RECORDS:
        return ring[:head].copy()
    return np.roll(ring, -(head % RING_RECORDS))
