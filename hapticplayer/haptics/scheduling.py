"""How the kernel is asked to wake the loop in time: FIFO, else slice, else normal.

Measured under playback load (wake-ups more than 1 ms late per minute): normal 437,
a 100 us slice 22, SCHED_FIFO with locked memory 3.
"""

import contextlib
import ctypes
import enum
import os
import struct

FIFO_PRIORITY = 80
GUARD_PRIORITY = 81  # it has next to nothing to do, but must not wait for the loop
DEVICE_PRIORITY = 79  # a real device is not starved by the player either
SLICE_NS = 100_000
WINDOW_SLICE_NS = 400_000  # shorter than others' 1.4 to 3 ms; the loop comes first
_PR_SET_TIMERSLACK = 29
_MCL_CURRENT, _MCL_FUTURE = 1, 2
_SCHED_SETATTR = {"x86_64": 314, "aarch64": 274, "riscv64": 274}
# struct sched_attr, version 0: size, policy, flags, nice, priority, runtime,
# deadline, period. For SCHED_OTHER the runtime is the EEVDF slice (Linux >= 6.12).
_SCHED_ATTR = struct.Struct("=IIQiIQQQ")
_RESET_ON_FORK = 1
_SLICE_SINCE = (6, 12)


class Scheduling(enum.StrEnum):
    """The class that is active."""

    FIFO = "fifo"
    SLICE = "slice"
    NORMAL = "normal"


def acquire(
    wanted: Scheduling | None = None, priority: int = FIFO_PRIORITY
) -> Scheduling:
    """Take the best class that this process may have, lock its memory, return the class.

    Args:
        wanted: None for the best; a class to be measured apart.
        priority: within SCHED_FIFO.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    libc.prctl(_PR_SET_TIMERSLACK, 1, 0, 0, 0)
    taken = grant(0, wanted, priority)
    if taken is Scheduling.FIFO:
        # in these small processes only: it would pin a gigabyte in the player
        libc.mlockall(_MCL_CURRENT | _MCL_FUTURE)
    return taken


def grant(
    pid: int, wanted: Scheduling | None = None, priority: int = FIFO_PRIORITY
) -> Scheduling:
    """Give a process the best class that it may have, and return the class.

    Args:
        pid: of the process; 0 for this one.
        wanted: None for the best; a class to be measured apart.
        priority: within SCHED_FIFO.
    """
    if wanted in (None, Scheduling.FIFO) and _give_fifo(pid, priority):
        return Scheduling.FIFO
    if wanted in (None, Scheduling.FIFO, Scheduling.SLICE) and _give_slice(pid):
        return Scheduling.SLICE
    return Scheduling.NORMAL


def hasten_window() -> Scheduling:
    """Give the window's thread a short slice: it is woken before others of its rank.

    What it starts, threads and processes, are as they would be without.
    """
    is_given = _give_slice(0, WINDOW_SLICE_NS, _RESET_ON_FORK)
    return Scheduling.SLICE if is_given else Scheduling.NORMAL


def _give_fifo(pid: int, priority: int) -> bool:
    with contextlib.suppress(OSError):
        os.sched_setscheduler(pid, os.SCHED_FIFO, os.sched_param(priority))
        return True
    return False


def _give_slice(pid: int, slice_ns: int = SLICE_NS, flags: int = 0) -> bool:
    system = os.uname()
    number = _SCHED_SETATTR.get(system.machine)
    release = tuple(int(part) for part in system.release.split(".")[:2])
    if number is None or release < _SLICE_SINCE:
        return False
    attributes = _SCHED_ATTR.pack(
        _SCHED_ATTR.size, os.SCHED_OTHER, flags, 0, 0, slice_ns, 0, 0
    )
    libc = ctypes.CDLL(None, use_errno=True)
    return int(libc.syscall(number, pid, attributes, 0)) == 0
