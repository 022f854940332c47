"""Asks the kernel to keep the processors out of deep sleep while a force may be on.

A processor that sleeps deeply comes back late. `/dev/cpu_dma_latency` takes the longest
time, us as a signed 32-bit number, that waking up may take, for as long as it is open
(Linux, Documentation/power/pm_qos_interface.rst); cyclictest asks for 0 as well. It
costs power, so nothing is asked for while nothing plays.
"""

import contextlib
import os
import struct

CPU_LATENCY = "/dev/cpu_dma_latency"
_AT_ONCE, _NO_MATTER = struct.pack("=i", 0), struct.pack("=i", -1)


class Wakefulness:
    """One request of this process; the kernel drops it when the process ends.

    Args:
        path: where the kernel takes it; root's, unless a udev rule gives it away.
    """

    def __init__(self, path: str | os.PathLike[str] = CPU_LATENCY) -> None:
        self._is_awake = False
        try:
            self._file: int | None = os.open(path, os.O_WRONLY | os.O_CLOEXEC)
        except OSError:
            self._file = None  # not Linux, or not allowed: the doctor tells

    def keep(self, *, awake: bool) -> None:
        """Ask for quick waking, or for nothing; free of cost while nothing changes."""
        if awake == self._is_awake:
            return
        self._is_awake = awake
        if self._file is not None:
            with contextlib.suppress(OSError):  # no force may end with a wish refused
                os.write(self._file, _AT_ONCE if awake else _NO_MATTER)
