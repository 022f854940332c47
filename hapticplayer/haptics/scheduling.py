"""What the kernel is asked for, so that processes wake in time.

The best scheduling class: FIFO, else slice, else normal (wake-ups more than 1 ms late
per minute under playback load: 3, 22, 437). Locked memory, so that no thread waits for
a disk. Processors that do not sleep deeply while a force may be on.
"""

import contextlib
import ctypes
import enum
import os
import resource
import signal
import struct

FIFO_PRIORITY = 80
GUARD_PRIORITY = 81  # it has next to nothing to do, but must not wait for the loop
DEVICE_PRIORITY = 79  # a real device is not starved by the player either
OWN_LOOP_PRIORITY = 78  # of what needs no 1 kHz: after the loop and its device
SLICE_NS = 100_000
WINDOW_SLICE_NS = 400_000  # shorter than others' 1.4 to 3 ms; the loop comes first
_PR_SET_TIMERSLACK = 29
_MCL_CURRENT, _MCL_FUTURE, _MCL_ONFAULT = 1, 2, 4
_SCHED_SETATTR = {"x86_64": 314, "aarch64": 274, "riscv64": 274}
# struct sched_attr, version 0: size, policy, flags, nice, priority, runtime,
# deadline, period. For SCHED_OTHER the runtime is the EEVDF slice (Linux >= 6.12).
_SCHED_ATTR = struct.Struct("=IIQiIQQQ")
_RESET_ON_FORK = 1
_SLICE_SINCE = (6, 12)
CPU_LATENCY = "/dev/cpu_dma_latency"
_NO_SLEEP, _NO_REQUEST = struct.pack("=i", 0), struct.pack("=i", -1)


class Scheduling(enum.StrEnum):
    """The class that is active."""

    FIFO = "fifo"
    SLICE = "slice"
    NORMAL = "normal"


def acquire(
    wanted: Scheduling | None = None, priority: int = FIFO_PRIORITY
) -> Scheduling:
    """Take the best class that this process may have, lock its memory, return the class.

    `wanted` is a class to be measured apart; the priority is within SCHED_FIFO.
    """
    ctypes.CDLL(None).prctl(_PR_SET_TIMERSLACK, 1, 0, 0, 0)
    taken = grant(0, wanted, priority)
    if taken is Scheduling.FIFO:
        lock_memory(on_fault=False)  # these processes are small
    return taken


def grant(
    pid: int, wanted: Scheduling | None = None, priority: int = FIFO_PRIORITY
) -> Scheduling:
    """Give a process the best class that it may have, and return the class.

    Its number is 0 for this one; else as in `acquire`.
    """
    if wanted in (None, Scheduling.FIFO) and _give_fifo(pid, priority):
        return Scheduling.FIFO
    if wanted in (None, Scheduling.FIFO, Scheduling.SLICE) and _give_slice(pid):
        return Scheduling.SLICE
    return Scheduling.NORMAL


def lock_memory(*, on_fault: bool = True) -> bool:
    """Keep the memory of this process from being paged out, mlockall(2).

    Under memory pressure the kernel drops pages of mapped files, code among them; a
    thread that needs one waits for the disk, often with the interpreter's lock in its
    hand: windows froze for 0.1 to 1.1 s (`benchmarks.robustness eviction`). With
    `on_fault` each page is locked from its first use on; else all present ones are at
    once, and later ones from their first use on.

    Returns:
        False where the process may not lock without limit: later allocations would
        fail at a limit.
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    is_unlimited = hard == resource.RLIM_INFINITY
    # under a limit of 0 the kernel grants it only to CAP_IPC_LOCK, which has no limit
    resource.setrlimit(resource.RLIMIT_MEMLOCK, (hard if is_unlimited else 0, hard))
    mlockall = ctypes.CDLL(None).mlockall
    flags = _MCL_CURRENT | _MCL_FUTURE | (_MCL_ONFAULT if on_fault else 0)
    is_locked = bool(mlockall(flags) == 0)
    if is_locked:
        # to lock all of a long track when it is mapped would stall the loop
        mlockall(_MCL_FUTURE | _MCL_ONFAULT)
    if not is_unlimited:
        resource.setrlimit(resource.RLIMIT_MEMLOCK, (soft, hard))
    return is_locked


def outlive_the_player() -> None:
    """Ignore the signals that are meant for the player, and come to its whole group."""
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM, signal.SIGQUIT):
        signal.signal(number, signal.SIG_IGN)


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


class CpuLatencyRequest:
    """Asks the kernel to keep the processors out of deep sleep, which delays wake-ups.

    `/dev/cpu_dma_latency` takes the longest wake-up time, us as a signed 32-bit number,
    for as long as it is open (Linux, Documentation/power/pm_qos_interface.rst);
    cyclictest asks for 0 as well. It costs power, so it is asked for only while a force
    may be on. The kernel drops the request when the process ends. The device is root's,
    unless a udev rule gives it away.
    """

    def __init__(self, path: str | os.PathLike[str] = CPU_LATENCY) -> None:
        self._is_active = False
        try:
            self._file: int | None = os.open(path, os.O_WRONLY | os.O_CLOEXEC)
        except OSError:
            self._file = None  # not Linux, or not allowed: `doctor` reports it

    def set_active(self, *, is_active: bool) -> None:
        """Make or withdraw the request; free of cost while nothing changes."""
        if is_active == self._is_active:
            return
        self._is_active = is_active
        if self._file is not None:
            with contextlib.suppress(OSError):  # a refused request must not end a force
                os.write(self._file, _NO_SLEEP if is_active else _NO_REQUEST)
