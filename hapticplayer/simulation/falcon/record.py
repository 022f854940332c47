"""State of the simulated Falcon at each tick, in memory that outlives every process.

A ring in a file or memfd: a benchmark that holds the descriptor reads when the zero
arrived, also when player, loop and device have died meanwhile.
"""

import mmap
import os
import struct

from hapticplayer.simulation.falcon.simulation import Simulation

RING_RECORDS = 1 << 16
RECORD_FIELDS = struct.Struct("<dd9fI")
MAGIC = b"HPsimrec"
RING_AT = 64
RECORD_BYTES = RING_AT + RING_RECORDS * RECORD_FIELDS.size


class PlantRecorder:
    """Writer of the ring, into a file or memfd that is given its size."""

    def __init__(self, descriptor: int) -> None:
        os.ftruncate(descriptor, RECORD_BYTES)
        self._map = mmap.mmap(descriptor, RECORD_BYTES)
        self._map[:8] = MAGIC
        self._head = memoryview(self._map)[8:16].cast("Q")
        self._head[0] = 0

    def write(self, now_s: float, simulation: Simulation) -> None:
        """Append one tick, then publish it."""
        count = self._head[0]
        at = RING_AT + (count % RING_RECORDS) * RECORD_FIELDS.size
        RECORD_FIELDS.pack_into(
            self._map,
            at,
            now_s,
            simulation.applied_since_s,
            *simulation.commanded_n,
            *simulation.applied_n,
            *simulation.position_m,
            simulation.refused,
        )
        self._head[0] = count + 1
