"""Reports the death of a process at once: the player's to its loop, the loop's to its guard.

A player's line closes only after the kernel has torn down its memory: 15 ms for a
window, 80 ms on a busy machine; a loop, whose memory is locked, takes up to 10 ms. A
robust mutex is released before that: the kernel marks the word of memory behind it when
the thread that holds it begins to end, and wakes the waiter (get_robust_list(2),
FUTEX_OWNER_DIED). Reading that word costs the loop no system call, and the guard sleeps
on it. Without such a mutex, and at a regular end, closed lines report the end.
"""

import ctypes
import errno
import mmap
import os
import signal
import threading
from collections.abc import Callable
from functools import cache, partial

from hapticplayer.linux import anonymous_memory, taken_away

LIFELINE_BYTES = 64  # more than any pthread_mutex_t has, and the mark behind it
_MARK_AT = LIFELINE_BYTES - 4
_ROBUST, _SHARED = 1, 1  # PTHREAD_MUTEX_ROBUST, PTHREAD_PROCESS_SHARED
_ATTRIBUTES_BYTES = 64  # more than any platform's pthread_mutexattr_t has
_WAITED_FOR, _OWNER_DIED = 0x8000_0000, 0x4000_0000  # bits of the word, futex(2)
_FUTEX = {"x86_64": 202, "aarch64": 98, "riscv64": 98}
_WAIT, _WAKE = 0, 1  # FUTEX_WAIT and FUTEX_WAKE, between processes
_ALL = 0x7FFF_FFFF
_NO_END_OF_WAITING = (errno.ETIMEDOUT, errno.EAGAIN, errno.EINTR)
_held: list[mmap.mmap] = []  # never unmapped: the kernel's list leads through it


class _Timespec(ctypes.Structure):
    _fields_ = (("seconds", ctypes.c_long), ("nanoseconds", ctypes.c_long))


class Lifeline:
    """The side of those who watch LIFELINE_BYTES that are shared with the holder."""

    def __init__(self, memory: memoryview) -> None:
        self._word = memory[:4].cast("I")
        self._mark = memory[_MARK_AT:LIFELINE_BYTES].cast("I")
        self._futex = _FUTEX.get(os.uname().machine, 0)
        self._seen, self._timeout = ctypes.c_uint(), _Timespec()
        call = partial(
            ctypes.CDLL(None, use_errno=True).syscall,
            ctypes.c_long(self._futex),
            ctypes.byref(ctypes.c_char.from_buffer(memory)),
        )
        timeout = ctypes.byref(self._timeout)
        self._sleep = partial(call, ctypes.c_int(_WAIT), self._seen, timeout, None)
        self._wake = partial(call, ctypes.c_int(_WAKE), ctypes.c_int(_ALL))

    def is_cut(self) -> bool:
        """Whether the thread that held it has ended."""
        return bool(self._word[0] & _OWNER_DIED)

    def wakes(self) -> bool:
        """Whether there is a holder whose end will wake a waiter."""
        return self._futex > 0 and self._mark[0] != 0

    def end(self) -> None:
        """End the waiting of those who watch; they find it as it is."""
        if self.wakes():
            self._wake()

    def wait(self, timeout_s: float) -> bool:
        """Wait until it is cut; False after the timeout, or where that is ended.

        Only where it `wakes`; a system that refuses the call is not called again.
        """
        self._seen.value = word = self._word[0]
        if word & _OWNER_DIED:
            return True
        seconds = int(timeout_s)
        self._timeout.seconds = seconds
        self._timeout.nanoseconds = int(1e9 * (timeout_s - seconds))
        if self._sleep() and ctypes.get_errno() not in _NO_END_OF_WAITING:
            self._futex = 0
        return self.is_cut()


def map_lifeline(descriptor: int) -> Lifeline:
    """Return the lifeline behind a descriptor from `hold_lifeline`, which is closed."""
    page = mmap.mmap(descriptor, mmap.PAGESIZE)
    os.close(descriptor)
    return Lifeline(memoryview(page))


@cache
def hold_lifeline() -> int:
    """Return the descriptor of the lifeline of this process, for its loops to watch.

    There is one for all of them, held by the main thread until its end, owned by this
    module. Called first by another thread, or without robust mutexes, it is not held and
    never cut.
    """
    descriptor = anonymous_memory("hapticplayer-lifeline", mmap.PAGESIZE)
    page = mmap.mmap(descriptor, mmap.PAGESIZE)
    _held.append(page)
    if threading.current_thread() is threading.main_thread():
        hold(memoryview(page))
    return descriptor


def hold(memory: memoryview) -> Callable[[], None]:
    """Take a robust mutex there for this thread; return what gives it back.

    The memory, LIFELINE_BYTES of zeros that are shared with the watchers, may not be
    unmapped before that.
    """
    library = ctypes.CDLL(None)
    has = hasattr(library, "pthread_mutexattr_setrobust")
    if not has or "robust-mutex" in taken_away():
        return lambda: None
    mutex = ctypes.c_char.from_buffer(memory)
    attributes = ctypes.create_string_buffer(_ATTRIBUTES_BYTES)
    library.pthread_mutexattr_init(attributes)
    library.pthread_mutexattr_setrobust(attributes, _ROBUST)
    library.pthread_mutexattr_setpshared(attributes, _SHARED)
    library.pthread_mutex_init(ctypes.byref(mutex), attributes)
    library.pthread_mutexattr_destroy(attributes)
    library.pthread_mutex_lock(ctypes.byref(mutex))
    word = memory[:4].cast("I")
    mark = memory[_MARK_AT:LIFELINE_BYTES].cast("I")
    if word[0] == threading.get_native_id():  # else it is elsewhere in the mutex
        word[0] |= _WAITED_FOR  # while alive: the kernel wakes later waiters
        mark[0] = 1

    def release() -> None:
        mark[0] = 0
        library.pthread_mutex_unlock(ctypes.byref(mutex))

    return release


def outlive_the_player() -> None:
    """Ignore the signals that are meant for the player, and come to its whole group."""
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM, signal.SIGQUIT):
        signal.signal(number, signal.SIG_IGN)
