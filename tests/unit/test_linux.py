"""Scheduling of single threads, and locked memory."""

import ctypes
import json
import platform
import resource
import subprocess
import sys
import threading
from pathlib import Path
from types import SimpleNamespace

import pytest

from hapticplayer.linux import WINDOW_SLICE_NS, Scheduling, hasten_window, lock_memory

LOCKER = """
import json, sys
from hapticplayer.linux import lock_memory

def locked_kb():
    words = open("/proc/self/status").read().split()
    return int(words[words.index("VmLck:") + 1])

done = lock_memory()
before = locked_kb()
kept = bytearray(50_000_000)
json.dump({"done": done, "locked": before, "grown": locked_kb() - before}, sys.stdout)
"""
_SCHED_GETATTR = {"x86_64": 315, "aarch64": 275, "riscv64": 275}
_RUNTIME_AT, _ATTR_BYTES = 24, 48  # struct sched_attr, version 0


def slice_ns() -> int:
    """What the kernel says of the calling thread."""
    number = _SCHED_GETATTR.get(platform.machine())
    if number is None:
        pytest.skip("the number of sched_getattr is not known here")
    attributes = ctypes.create_string_buffer(_ATTR_BYTES)
    assert ctypes.CDLL(None).syscall(number, 0, attributes, _ATTR_BYTES, 0) == 0
    return int.from_bytes(attributes.raw[_RUNTIME_AT : _RUNTIME_AT + 8], "little")


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
    # 0 or the kernel's own, as a thread that never asked for one
    assert WINDOW_SLICE_NS not in (seen["before"], seen["child"])


def locked():
    answer = subprocess.run(
        [sys.executable, "-c", LOCKER],
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(answer.stdout)


def has_right_to_lock() -> bool:
    capabilities = Path("/proc/self/status").read_text().split("CapEff:")[1]
    has_capability = int(capabilities.split()[0], 16) >> 14 & 1  # CAP_IPC_LOCK
    limit = resource.getrlimit(resource.RLIMIT_MEMLOCK)[1]
    return bool(has_capability) or limit == resource.RLIM_INFINITY


def test_memory_is_locked_now_and_later():
    if not has_right_to_lock():
        pytest.skip("this user may not lock memory without limit")
    found = locked()
    assert found["done"]
    assert found["locked"] > 1000
    assert found["grown"] > 40_000


MAPPER = """
import json, mmap, sys
from hapticplayer.linux import lock_memory
from hapticplayer.linux import anonymous_memory

lock_memory(on_fault=False)
descriptor = anonymous_memory("track", 50_000_000)
mapped = mmap.mmap(descriptor, 50_000_000)
words = open("/proc/self/smaps").read().split("memfd:track")[1].split()
json.dump(int(words[words.index("Rss:") + 1]), sys.stdout)
"""


def test_a_long_track_is_not_paged_in_when_it_is_mapped():
    """That would stall the loop; its pages come while it is checked."""
    words = [sys.executable, "-c", MAPPER]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) < 100


def test_memory_stays_unlocked_where_a_limit_would_fail_later(monkeypatch):
    asked = []
    monkeypatch.setattr(resource, "getrlimit", lambda _: (1 << 23, 1 << 23))
    monkeypatch.setattr(resource, "setrlimit", lambda _, limits: asked.append(limits))
    refusing = SimpleNamespace(mlockall=lambda _flags: -1)
    monkeypatch.setattr(ctypes, "CDLL", lambda _name: refusing)
    assert not lock_memory()
    assert asked == [(0, 1 << 23), (1 << 23, 1 << 23)]  # asked under 0, and put back
