"""Tells the loop at once that the player has been killed.

Its line closes only after the kernel has taken its memory down: 15 ms for a window, and
80 ms where other programs compute. A robust mutex is given back before that: the kernel
marks the word of memory behind it when the thread that holds it begins to end
(get_robust_list(2), FUTEX_OWNER_DIED). To look at that word costs the loop no call.
Where there is no such mutex (not glibc), and at a regular end, the line alone tells.
"""

import functools
import mmap
import os
import threading

from hapticplayer.haptics.track import anonymous_memory

_BYTES = mmap.PAGESIZE
_ROBUST, _SHARED = 1, 1  # PTHREAD_MUTEX_ROBUST, PTHREAD_PROCESS_SHARED
_ATTRIBUTES_BYTES = 64  # more than any platform's pthread_mutexattr_t has
_OWNER_DIED = 0x4000_0000
_held: list[mmap.mmap] = []  # never unmapped: the kernel's list leads through it


class Lifeline:
    """What the loop has of it.

    Args:
        descriptor: from `hold_lifeline`; it is closed here.
    """

    def __init__(self, descriptor: int) -> None:
        self._map = mmap.mmap(descriptor, _BYTES)
        os.close(descriptor)
        self._word = memoryview(self._map)[:4].cast("I")

    def is_cut(self) -> bool:
        """Whether the player's main thread has ended."""
        return bool(self._word[0] & _OWNER_DIED)


def hold_lifeline() -> int:
    """Return the descriptor of the lifeline of this process, for its loops to watch.

    It is one for all of them, held by the main thread until its end, and belongs to this
    module. Called first by another thread, or without robust mutexes, nobody holds it and
    it is never cut.
    """
    return _hold()


@functools.cache
def _hold() -> int:
    descriptor = anonymous_memory("hapticplayer-lifeline", _BYTES)
    page = mmap.mmap(descriptor, _BYTES)
    _held.append(page)
    if threading.current_thread() is threading.main_thread():
        _lock(page)
    return descriptor


def _lock(page: mmap.mmap) -> None:
    """Take a robust mutex at the beginning of a page, where that is what it looks like."""
    import ctypes  # the loop has no use for it

    library = ctypes.CDLL(None)
    if not hasattr(library, "pthread_mutexattr_setrobust"):
        return
    mutex = ctypes.c_char.from_buffer(page)
    attributes = ctypes.create_string_buffer(_ATTRIBUTES_BYTES)
    library.pthread_mutexattr_init(attributes)
    library.pthread_mutexattr_setrobust(attributes, _ROBUST)
    library.pthread_mutexattr_setpshared(attributes, _SHARED)
    library.pthread_mutex_init(ctypes.byref(mutex), attributes)
    library.pthread_mutexattr_destroy(attributes)
    library.pthread_mutex_lock(ctypes.byref(mutex))
