"""A witness of the machine's own stalls: a 1 kHz sleeper at the highest FIFO priority.

It knows nothing of the program. What it could not do in time, nobody could. Run beside
a measurement, it tells which outliers were stalls of the machine.
"""

import array
import contextlib
import mmap
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator

PERIOD_S = 0.001
STALL_S = 0.001
PRIORITY = 99
MOST = 100_000
_BYTES = 8 * (1 + 2 * MOST)


class Sentinel:
    """What it has seen so far."""

    def __init__(self, block: mmap.mmap) -> None:
        self._block = block

    def stalls(self) -> list[tuple[float, float]]:
        """Return (monotonic time of the missed wake-up, how late it was), s."""
        values = array.array("d")
        values.frombytes(self._block[:_BYTES])
        count = int(values[0])
        return [(values[1 + 2 * k], values[2 + 2 * k]) for k in range(count)]

    def stalled_s(self, begin_s: float, end_s: float) -> float:
        """Return for how long the machine stood still within a span, s."""
        total_s = 0.0
        for due_s, late_s in self.stalls():
            total_s += max(0.0, min(end_s, due_s + late_s) - max(begin_s, due_s))
        return total_s


@contextlib.contextmanager
def sentinel() -> Iterator[Sentinel]:
    """Run it beside what is measured."""
    descriptor = os.memfd_create("sentinel")
    os.ftruncate(descriptor, _BYTES)
    process = subprocess.Popen(
        [sys.executable, "-S", "-E", __file__, str(descriptor)],
        pass_fds=(descriptor,),
    )
    try:
        yield Sentinel(mmap.mmap(descriptor, _BYTES))
    finally:
        process.send_signal(signal.SIGKILL)
        process.wait()
        os.close(descriptor)


def watch(descriptor: int) -> None:
    """Sleep from deadline to deadline, and note when that fails."""
    block = mmap.mmap(descriptor, _BYTES)
    values = memoryview(block).cast("d")
    with contextlib.suppress(OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(PRIORITY))
    count, due_s = 0, time.monotonic()
    while True:
        due_s += PERIOD_S
        time.sleep(max(0.0, due_s - time.monotonic()))
        late_s = time.monotonic() - due_s
        if late_s > STALL_S and count < MOST:
            values[1 + 2 * count], values[2 + 2 * count] = due_s, late_s
            count += 1
            values[0] = count
            due_s += int(late_s / PERIOD_S) * PERIOD_S


if __name__ == "__main__":
    watch(int(sys.argv[1]))
