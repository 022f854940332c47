"""Keeps the code that a process runs in memory, so that nobody waits for a disk to run it.

The kernel takes pages of mapped files away where memory is short, or where it is told to,
and reads them again when they are needed. A thread that meets such a page waits for the
disk, often with Python's lock in its hand: windows were still for 0.1 to 1.1 s, longer
than a heartbeat may be (benchmarks/eviction.py). A page that is locked on fault,
mlock2(2), stays from its first use on; what is never used is not even loaded.
"""

import ctypes
import sys

MAPS = "/proc/self/maps"
_ONFAULT = 1
_PATH_FIELD = 5  # of a line of proc(5) maps, which ends with it
_NO_FILES = ("/memfd:", "/dev/", "/SYSV")


class Residence:
    """Locks what this process has mapped of files, and again when it has loaded more.

    Without the right to lock (RLIMIT_MEMLOCK, CAP_IPC_LOCK), or on other systems than
    Linux, nothing is locked, and nothing is the worse for it.
    """

    def __init__(self) -> None:
        self._lock = getattr(ctypes.CDLL(None), "mlock2", None)
        if self._lock is not None:
            self._lock.argtypes = [ctypes.c_size_t, ctypes.c_size_t, ctypes.c_uint]
        self._seen = self._locked = 0

    def look(self) -> None:
        """Lock when modules have been loaded, and no more came since the last look.

        To be called now and then; free of cost while nothing is loaded, else 20 ms.
        """
        known = len(sys.modules)
        if known == self._seen and known != self._locked:
            self.lock()
        self._seen = known

    def lock(self) -> int:
        """Lock all files that are mapped now, and return how many bytes that are."""
        self._locked = len(sys.modules)
        if self._lock is None:
            return 0
        total = 0
        for first, length in _files():
            if self._lock(first, length, _ONFAULT) == 0:
                total += length
        if total == 0:
            self._lock = None  # nobody will give the right later
        return total


def _files() -> list[tuple[int, int]]:
    """Return address and length of each mapping of a file."""
    try:
        with open(MAPS, encoding="utf-8", errors="replace") as file:  # noqa: PTH123
            lines = file.readlines()  # without pathlib, which takes 6 ms to load
    except OSError:
        return []
    found = []
    for line in lines:
        fields = line.split(maxsplit=_PATH_FIELD)
        path = fields[_PATH_FIELD] if len(fields) > _PATH_FIELD else ""
        if path.startswith("/") and not path.startswith(_NO_FILES):
            first, end = (int(number, 16) for number in fields[0].split("-"))
            found.append((first, end - first))
    return found
