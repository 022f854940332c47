"""Keeps the memory of pictures in the process for those that follow, and no more of it.

The C library gives large blocks back to the kernel when they are freed, and gets them
anew, cleared and page by page, for the next picture: some 200 page faults for 1080p, where
large pages are to be had, else 2000. What is kept then becomes more with every moment that
needs much at once, and lies about between blocks that are in use; hence, now and then, all
of it goes back.
"""

import ctypes

_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8  # mallopt(3)
_LARGEST_BYTES = 32 << 20
"""The most that glibc takes for its M_MMAP_THRESHOLD; a picture of 4K has a little more."""
_KEPT_BYTES = 64 << 20
"""What may lie free at the end of the heap: a queue of pictures of 1080p."""


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
    """Let the kernel have all pages that nobody uses, in 1 ms; where it is glibc."""
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)
