"""Witnesses of the machine's own stalls: a 1 kHz sleeper on each core, highest priority.

They know nothing of the program. What they could not do in time, nobody on that core
could. Run beside a measurement, they tell which outliers were stalls of the machine: a
virtual machine's cores stand still one by one.
"""

import contextlib
import itertools
import mmap
import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence

PERIOD_S = 0.001
STALL_S = 0.001
PRIORITY = 99
MOST = 200_000
_BYTES = 8 * (1 + 2 * MOST)
Stall = tuple[float, float]
"""Monotonic time of the missed wake-up, and how late it was, s."""


class Sentinel:
    """What they have seen so far.

    Args:
        blocks: of each core.
    """

    def __init__(self, blocks: Sequence[mmap.mmap]) -> None:
        self._blocks = blocks
        self._seen: list[list[Stall]] = [[] for _ in blocks]

    def of_cores(self) -> list[list[Stall]]:
        """Return the stalls of each core in the order of time."""
        for block, seen in zip(self._blocks, self._seen, strict=True):
            values = memoryview(block)[:_BYTES].cast("d")
            for k in range(len(seen), int(values[0])):
                seen.append((values[1 + 2 * k], values[2 + 2 * k]))
        return self._seen

    def stalls(self) -> list[Stall]:
        """Return the stalls of all cores in the order of time."""
        return sorted(itertools.chain(*self.of_cores()))

    def stalled_s(self, begin_s: float, end_s: float) -> float:
        """Return for how long one core, the worst, stood still within a span, s."""

        def common_s(stall: Stall) -> float:
            due_s, late_s = stall
            return max(0.0, min(end_s, due_s + late_s) - max(begin_s, due_s))

        return max(sum(map(common_s, stalls)) for stalls in self.of_cores())


@contextlib.contextmanager
def sentinel() -> Iterator[Sentinel]:
    """Run one on each core beside what is measured."""
    blocks = []
    with contextlib.ExitStack() as stack:
        for core in sorted(os.sched_getaffinity(0)):
            descriptor = os.memfd_create("sentinel")
            stack.callback(os.close, descriptor)
            os.ftruncate(descriptor, _BYTES)
            command = [sys.executable, "-S", "-E", __file__, str(descriptor), str(core)]
            process = subprocess.Popen(command, pass_fds=(descriptor,))
            stack.callback(process.wait)
            stack.callback(process.kill)
            blocks.append(mmap.mmap(descriptor, _BYTES))
        yield Sentinel(blocks)


def watch(descriptor: int, core: int) -> None:
    """Sleep from deadline to deadline, and note when that fails."""
    block = mmap.mmap(descriptor, _BYTES)
    values = memoryview(block).cast("d")
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, {core})
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
    watch(int(sys.argv[1]), int(sys.argv[2]))
