"""Memory of pictures that stays with this process while it decodes.

glibc gives a freed picture back to the kernel and asks for the next one page by page,
all of them set to zero: 0.75 ms for each picture of 720p whose colours take 0.2 ms.
"""

import ctypes
import functools
import sys
from collections.abc import Callable

_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8  # malloc.h
_MOST_KEPT_BYTES = 128 * 1024**2
_LARGEST_BYTES = 32 * 1024**2  # the most that glibc takes


@functools.cache
def keep_freed() -> None:
    """Use freed memory again from now on, where the C library is glibc.

    Threads that are started later share one heap: their own would be given back
    whenever it is empty.
    """
    if set_option := _function("mallopt"):
        set_option(_ARENA_MAX, 1)
        set_option(_MMAP_THRESHOLD, _LARGEST_BYTES)
        set_option(_TRIM_THRESHOLD, _MOST_KEPT_BYTES)


def give_back() -> None:
    """Give what is free at present back to the kernel."""
    if trim := _function("malloc_trim"):
        trim(0)


@functools.cache
def _function(name: str) -> Callable[..., int] | None:
    if not sys.platform.startswith("linux"):
        return None
    found: Callable[..., int] | None = getattr(ctypes.CDLL(None), name, None)
    return found
