"""The short slice: for one thread, and for nothing that it starts."""

import ctypes
import platform
import threading

import pytest

from hapticplayer.haptics.scheduling import (
    WINDOW_SLICE_NS,
    Scheduling,
    hasten_window,
)

_SCHED_GETATTR = {"x86_64": 315, "aarch64": 275, "riscv64": 275}
_RUNTIME_AT, _ATTR_BYTES = 24, 48  # struct sched_attr, version 0


def slice_ns() -> int:
    """What the kernel says of the calling thread."""
    number = _SCHED_GETATTR.get(platform.machine())
    if number is None:
        pytest.skip("the number of sched_getattr is not known here")
    told = ctypes.create_string_buffer(_ATTR_BYTES)
    assert ctypes.CDLL(None).syscall(number, 0, told, _ATTR_BYTES, 0) == 0
    return int.from_bytes(told.raw[_RUNTIME_AT : _RUNTIME_AT + 8], "little")


def test_a_thread_is_hastened_and_what_it_starts_is_not():
    seen = {}

    def hastened() -> None:
        seen["before"] = slice_ns()
        seen["got"] = hasten_window()
        seen["after"] = slice_ns()
        child = threading.Thread(target=lambda: seen.update(child=slice_ns()))
        child.start()
        child.join()

    thread = threading.Thread(target=hastened)
    thread.start()
    thread.join()
    if seen["got"] is Scheduling.NORMAL:
        pytest.skip("this kernel gives no slices")
    assert seen["after"] == WINDOW_SLICE_NS
    assert seen["child"] == seen["before"] != WINDOW_SLICE_NS
