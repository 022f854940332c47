"""What only Linux gives: a row for each facility, and what is lost without it.

The doctor shows the rows. Tests take facilities away by `linux.SWITCH`, and play without.
"""

import ctypes
import mmap
import os
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from hapticplayer import linux
from hapticplayer.errors import Message, UsageError


class Facility(NamedTuple):
    """What it gives, what is lost without it, and whether this machine grants it.

    That is asked by doing, and leaves all as it was. `right` is what a person can get:
    "limits" for the loop's processes, "udev" for a device.
    """

    gives: Message
    without: Message
    is_granted: Callable[[], bool]
    right: str = ""


def has(name: str) -> bool:
    """Whether a facility is here, and not taken away."""
    return name not in linux.taken_away() and FACILITIES[name].is_granted()


def refuse_unknown() -> None:
    """Refuse a switch that names what is not a facility."""
    if unknown := [name for name in linux.taken_away() if name not in FACILITIES]:
        raise UsageError(
            "{switch} names {unknown}, which is not a facility; choose from {known}",
            switch=linux.SWITCH,
            unknown=", ".join(unknown),
            known=", ".join(FACILITIES),
        )


def session_bus() -> str:
    """The address of the session's D-Bus; "" without one, none is started."""
    if "session-bus" in linux.taken_away():
        return ""
    socket = Path(os.environ.get("XDG_RUNTIME_DIR", "/nowhere")) / "bus"
    found = f"unix:path={socket}" if socket.is_socket() else ""
    return os.environ.get("DBUS_SESSION_BUS_ADDRESS", "") or found


def _may_use_fifo() -> bool:
    policy, parameter = os.sched_getscheduler(0), os.sched_getparam(0)
    if not linux.give_fifo(0, linux.GUARD_PRIORITY):
        return False
    os.sched_setscheduler(0, policy, parameter)
    return True


def _may_lock() -> bool:
    with linux.locking_without_limit(), mmap.mmap(-1, mmap.PAGESIZE) as page:
        first = ctypes.c_char.from_buffer(page)
        refused = ctypes.CDLL(None).mlock(ctypes.byref(first), mmap.PAGESIZE)
        del first  # else the page cannot be unmapped
    return not refused


FACILITIES = {
    "memfd": Facility(
        Message("what the processes share is memory without a name"),
        Message("what the processes share is a file for a moment, in /dev/shm"),
        lambda: hasattr(os, "memfd_create"),
    ),
    "robust-mutex": Facility(
        Message("the death of the player or its loop ends the force at once"),
        Message("a death ends the force when the kernel has cleared up, 10 to 80 ms"),
        lambda: hasattr(ctypes.CDLL(None), "pthread_mutexattr_setrobust"),
    ),
    "fifo": Facility(
        Message("the loop comes before other programs: 3 late wake-ups a minute"),
        Message("the loop competes with other programs: 22 late wake-ups a minute"),
        _may_use_fifo,
        "limits",
    ),
    "slice": Facility(
        Message("the window, and without fifo the loop, have short time slices"),
        Message(
            "the window, and without fifo the loop, wait: 437 late wake-ups a minute"
        ),
        linux.knows_slices,
    ),
    "mlock": Facility(
        Message("no part of the program is paged out"),
        Message("while memory is short, the window freezes for up to a second"),
        _may_lock,
        "limits",
    ),
    "cpu-latency": Facility(
        Message("processors are kept out of deep sleep while a force may be on"),
        Message("processors may sleep deeply: the loop wakes up some 20 us later"),
        lambda: os.access(linux.CPU_LATENCY, os.W_OK),
        "udev",
    ),
    "idle": Facility(
        Message("work in the background takes only what nobody else wants"),
        Message("the window waits up to 80 ms for work in the background"),
        lambda: hasattr(os, "SCHED_IDLE"),
    ),
    "session-bus": Facility(
        Message("media keys; the screen stays awake while a clip plays"),
        Message("no media keys, and the screen may go dark while a clip plays"),
        lambda: bool(session_bus()),
    ),
}
