"""A value that one process publishes and others read, without a lock between them.

Two slots with a checksum each: a reader that meets a write in progress tries again a
bounded number of times and then continues with its last sample, so that a writer killed in
mid-write can never make a reader spin.
"""

import mmap
import struct
import zlib
from typing import Any

_CHECKSUM = struct.Struct("<I")
_TRIES = 3


class Slots:
    """One writer, any readers of a value in shared memory.

    Both slots have room for a checksum of 4 bytes. The 8 bytes at `newest_at` count the
    values; the last bit tells which slot is the newest. The same count needs no second
    reading.
    """

    def __init__(
        self,
        memory: mmap.mmap,
        layout: struct.Struct,
        slots_at: tuple[int, int],
        newest_at: int,
    ) -> None:
        self._memory, self._layout, self._slots_at = memory, layout, slots_at
        self._bytes = layout.size + _CHECKSUM.size
        self._newest = memoryview(memory)[newest_at : newest_at + 8].cast("Q")

    @property
    def count(self) -> int:
        """How many values there were: the same number means the same value."""
        return int(self._newest[0])

    def write(self, *fields: Any) -> None:
        """Publish a value."""
        count = self._newest[0] + 1
        payload = self._layout.pack(*fields)
        at = self._slots_at[count & 1]
        checksum = _CHECKSUM.pack(zlib.crc32(payload))
        self._memory[at : at + self._bytes] = payload + checksum
        self._newest[0] = count

    def read(self) -> tuple[Any, ...] | None:
        """Return the newest value, or None if none could be read."""
        for _ in range(_TRIES):
            at = self._slots_at[self._newest[0] & 1]
            raw = self._memory[at : at + self._bytes]
            payload = raw[: self._layout.size]
            if _CHECKSUM.unpack_from(raw, self._layout.size)[0] == zlib.crc32(payload):
                return self._layout.unpack(payload)
        return None
