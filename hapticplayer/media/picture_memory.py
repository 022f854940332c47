"""Memory for pictures, used again by those that follow.

Blocks of a megabyte that come and go thirty times a second leave holes among what else
the heap has; what is put into a hole makes the next picture lie at the heap's end, and so
the heap grows for hours.
"""

from collections import deque
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

_ALIGNED_BYTES = 64
"""Of a cache line, and of the widest registers that swscale writes with."""


class Memory(NamedTuple):
    """Bytes and where they begin, aligned; 64 bytes more may be written."""

    bytes: NDArray[np.uint8]
    address: int


class PictureMemory:
    """Hands out blocks of one size; those of another size are left to their owners."""

    def __init__(self) -> None:
        self._free: deque[Memory] = deque()
        self._size_bytes = 0

    def take(self, size_bytes: int) -> "Block":
        """Return a block that nobody else has; its contents are of no meaning.

        Raises:
            MemoryError: when there is none.
        """
        if size_bytes != self._size_bytes:
            self._free, self._size_bytes = deque(), size_bytes
        try:
            memory = self._free.pop()
        except IndexError:
            memory = _aligned(size_bytes)
        return Block(memory, self._free)


class Block:
    """A block of memory; when this object is gone, others may have it."""

    __slots__ = ("_free", "memory")

    def __init__(self, memory: Memory, free: deque[Memory]) -> None:
        self.memory, self._free = memory, free

    def __del__(self) -> None:
        self._free.append(self.memory)  # in one step, whatever thread it is


def stride_of(width_px: int) -> int:
    """Return how many bytes the rows of a picture of 4 bytes a pixel lie apart."""
    return -(-4 * width_px // _ALIGNED_BYTES) * _ALIGNED_BYTES


def _aligned(size_bytes: int) -> Memory:
    room: Any = np.empty(size_bytes + 2 * _ALIGNED_BYTES, np.uint8)
    address: int = room.ctypes.data
    offset = -address % _ALIGNED_BYTES
    return Memory(room[offset : offset + size_bytes], address + offset)
