"""What a process runs stays in memory, where it may lock it."""

import ctypes
import json
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from hapticplayer.haptics import residence
from hapticplayer.haptics.residence import Residence

LOCKER = """
import json, mmap, os, sys
from hapticplayer.haptics.residence import Residence

def locked():
    found, name = {}, ""
    for line in open("/proc/self/smaps"):
        words = line.split(maxsplit=5)
        if "-" in words[0] and not words[0].endswith(":"):
            name = words[5].strip() if len(words) > 5 else ""
        elif words[0] == "VmFlags:" and "lo" in line.split():
            found[name] = True
    return list(found)

memory = os.memfd_create("track")
os.truncate(memory, 4096)
mapped = mmap.mmap(memory, 4096)
one = Residence()
told = {"first": one.lock()}
told["locked"] = locked()
for _ in range(3):
    one.look()
import sqlite3  # a library of its own
told["before"] = [name for name in locked() if "sqlite" in name]
one.look()  # more may come
told["at once"] = [name for name in locked() if "sqlite" in name]
one.look()
told["after"] = [name for name in locked() if "sqlite" in name]
json.dump(told, sys.stdout)
"""


@pytest.fixture(scope="module")
def told():
    if not hasattr(ctypes.CDLL(None), "mlock2"):
        pytest.skip("this system cannot lock pages on fault")
    if resource.getrlimit(resource.RLIMIT_MEMLOCK)[0] != resource.RLIM_INFINITY:
        capabilities = Path("/proc/self/status").read_text().split("CapEff:")[1]
        if not int(capabilities.split()[0], 16) >> 14 & 1:  # CAP_IPC_LOCK
            pytest.skip("this user may not lock memory")
    answer = subprocess.run(
        [sys.executable, "-c", LOCKER], capture_output=True, text=True, check=True
    )
    return json.loads(answer.stdout)


def test_files_are_locked_and_nothing_else(told):
    assert told["first"] > 1 << 20
    assert any("python" in name for name in told["locked"])
    assert any("libc" in name for name in told["locked"])
    assert not any(name.startswith(("/memfd:", "[")) for name in told["locked"])
    assert "" not in told["locked"]


def test_what_is_loaded_later_is_locked_once_no_more_comes(told):
    assert told["before"] == told["at once"] == []
    assert told["after"]


class Kernel:
    """Refuses, or counts."""

    def __init__(self, answer=0):
        self.answer, self.calls = answer, 0

    def mlock2(self, _first, _length, _flags):
        self.calls += 1
        return self.answer


@pytest.fixture
def kernel(monkeypatch):
    def put(answer):
        known = Kernel(answer)
        one = Residence()
        one._lock = known.mlock2
        return one, known

    return put


def test_nothing_is_done_while_nothing_is_loaded(kernel):
    one, known = kernel(0)
    one.look()
    assert known.calls == 0  # more may come
    one.look()
    after_one = known.calls
    assert after_one > 0
    for _ in range(5):
        one.look()
    assert known.calls == after_one


def test_who_may_not_lock_is_asked_once(kernel):
    one, known = kernel(-1)
    assert one.lock() == 0
    tried = known.calls
    assert tried > 0
    assert one.lock() == 0
    assert known.calls == tried


def test_a_system_without_such_a_list_locks_nothing(kernel, monkeypatch, tmp_path):
    monkeypatch.setattr(residence, "MAPS", tmp_path / "none")
    one, known = kernel(0)
    assert one.lock() == 0
    assert known.calls == 0
