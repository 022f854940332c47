"""Keeps freed memory in the process for the next frame, and returns it now and then.

The C library returns large blocks to the kernel when they are freed and requests them
again, cleared and page by page, for the next frame: 1400 page faults for 1080p, 2.5 ms.
What is kept grows with every peak of use and fragments the heap; hence all free pages are
returned twice a minute.
"""

import ctypes

_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8  # mallopt(3)
_LARGEST_BYTES = 32 << 20
"""The most that glibc takes for its M_MMAP_THRESHOLD; a frame of 4K has a little more."""
_KEPT_BYTES = 64 << 20
"""What may stay free at the end of the heap: eight frames of 1080p."""


def keep_freed_memory() -> None:
    """Change how the C library handles large blocks; other libraries than glibc may refuse.

    To be called before the first thread: they share one heap then, so that what one
    has freed another can use.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is None:
        return
    mallopt(_MMAP_THRESHOLD, _LARGEST_BYTES)
    mallopt(_TRIM_THRESHOLD, _KEPT_BYTES)
    mallopt(_ARENA_MAX, 1)


def give_back_freed_memory() -> None:
    """Return all free pages to the kernel, in 1 ms; with glibc only."""
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)
