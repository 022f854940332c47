"""What the kernel is asked for; `facilities` says what each thing gives.

The best scheduling class: FIFO, else slice, else normal (wake-ups more than 1 ms late
per minute under playback load: 3, 22, 437). Locked memory, so that no thread waits for
a disk. Processors that do not sleep deeply while a force may be on. Memory that processes
share without a name.
"""

import contextlib
import ctypes
import enum
import os
import re
import resource
import struct
import tempfile
from collections.abc import Iterator
from pathlib import Path

SWITCH = "HAPTICPLAYER_WITHOUT"
"""Names what a test does without, divided by commas; doctor, logs and records tell it."""
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
# deadline, period. For SCHED_OTHER the runtime is the EEVDF slice.
_SCHED_ATTR = struct.Struct("=IIQiIQQQ")
_RESET_ON_FORK = 1
_SLICE_SINCE = (6, 12)
CPU_LATENCY = "/dev/cpu_dma_latency"
_NO_SLEEP, _NO_REQUEST = struct.pack("=i", 0), struct.pack("=i", -1)


def taken_away() -> list[str]:
    """What SWITCH names."""
    return sorted(filter(None, os.environ.get(SWITCH, "").split(",")))


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
    if wanted in (None, Scheduling.FIFO) and give_fifo(pid, priority):
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


def give_fifo(pid: int, priority: int) -> bool:
    with contextlib.suppress(OSError):
        if "fifo" not in taken_away():
            os.sched_setscheduler(pid, os.SCHED_FIFO, os.sched_param(priority))
            return True
    return False


def knows_slices() -> bool:
    system = os.uname()
    release = tuple(map(int, re.findall(r"\d+", system.release)[:2]))  # 6.12-rc1
    return system.machine in _SCHED_SETATTR and release >= _SLICE_SINCE


def _give_slice(pid: int, slice_ns: int = SLICE_NS, flags: int = 0) -> bool:
    if "slice" in taken_away() or not knows_slices():
        return False
    attributes = _SCHED_ATTR.pack(
        _SCHED_ATTR.size, os.SCHED_OTHER, flags, 0, 0, slice_ns, 0, 0
    )
    number, libc = _SCHED_SETATTR[os.uname().machine], ctypes.CDLL(None)
    return int(libc.syscall(number, pid, attributes, 0)) == 0


class CpuLatencyRequest:
    """Asks the kernel to keep the processors out of deep sleep, which delays wake-ups.

    The device takes the longest wake-up time, us as a signed 32-bit number, for as long
    as it is open (Linux, Documentation/power/pm_qos_interface.rst). It costs power, so it
    is asked for only while a force may be on.
    """

    def __init__(self, path: str | os.PathLike[str] = CPU_LATENCY) -> None:
        self._is_active = False
        self._file: int | None = None
        with contextlib.suppress(OSError):  # not allowed: `doctor` reports it
            if "cpu-latency" not in taken_away():
                self._file = os.open(path, os.O_WRONLY | os.O_CLOEXEC)

    def set_active(self, *, is_active: bool) -> None:
        """Make or withdraw the request; free of cost while nothing changes."""
        if is_active == self._is_active:
            return
        self._is_active = is_active
        if self._file is not None:
            with contextlib.suppress(OSError):  # a refused request must not end a force
                os.write(self._file, _NO_SLEEP if is_active else _NO_REQUEST)


def anonymous_memory(name: str, size: int) -> int:
    """Return a descriptor of shared memory that no other process can find by name."""
    if "memfd" in taken_away() or not hasattr(os, "memfd_create"):
        in_memory = next(Path("/dev").glob("shm"), None)
        descriptor, path = tempfile.mkstemp(prefix=f"{name}-", dir=in_memory)
        Path(path).unlink()
    else:
        descriptor = os.memfd_create(name, os.MFD_CLOEXEC)
    os.ftruncate(descriptor, size)
    return descriptor


def lock_memory(*, on_fault: bool = True) -> bool:
    """Keep the memory of this process from being paged out, mlockall(2).

    Under memory pressure the kernel drops pages of mapped files, code among them; a
    thread that needs one waits for the disk, often with the interpreter's lock in its
    hand: windows froze for 0.1 to 1.1 s (`benchmarks.robustness eviction`). Pages are
    locked from their first use on; without `on_fault` all present ones are at once.
    False where a process may not lock without limit: later allocations would fail.
    """
    if "mlock" in taken_away():
        return False
    mlockall = ctypes.CDLL(None).mlockall
    with locking_without_limit():
        flags = _MCL_CURRENT | _MCL_FUTURE | (_MCL_ONFAULT if on_fault else 0)
        is_locked = bool(mlockall(flags) == 0)
        if is_locked:
            # to lock all of a long track when it is mapped would stall the loop
            mlockall(_MCL_FUTURE | _MCL_ONFAULT)
    return is_locked


@contextlib.contextmanager
def locking_without_limit() -> Iterator[None]:
    """Under a limit of 0 the kernel locks only for CAP_IPC_LOCK, which has no limit."""
    soft, hard = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    is_unlimited = hard == resource.RLIM_INFINITY
    resource.setrlimit(resource.RLIMIT_MEMLOCK, (hard if is_unlimited else 0, hard))
    yield
    if not is_unlimited:
        resource.setrlimit(resource.RLIMIT_MEMLOCK, (soft, hard))
