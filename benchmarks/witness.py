"""Independent witnesses of what the machine took from a measurement.

A 1 kHz sleeper of the highest priority on each core tells when that core stalled;
the kernel's account of each thread tells which processes were ready and had no core.
"""

import contextlib
import itertools
import mmap
import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

PERIOD_S, STALL_S = 0.001, 0.001
SENTINEL_PRIORITY = 99
MOST_STALLS = 200_000
_BYTES = 8 * (1 + 2 * MOST_STALLS)
ACCOUNT_PERIOD_S, FIND_EVERY_S = 0.04, 1.0
ACCOUNT_PRIORITY = 50  # below every loop, above whatever starves others
Stall = tuple[float, float]
"""Monotonic time of the missed wake-up, and how late it was, s."""


class Sentinel:
    """The stalls seen so far by the sleepers on all cores."""

    def __init__(self, blocks: Sequence[mmap.mmap]) -> None:
        self._blocks = blocks
        self._seen: list[list[Stall]] = [[] for _ in blocks]

    def by_core(self) -> list[list[Stall]]:
        """Return the stalls of each core in the order of time."""
        for block, seen in zip(self._blocks, self._seen, strict=True):
            values = memoryview(block)[:_BYTES].cast("d")
            for k in range(len(seen), int(values[0])):
                seen.append((values[1 + 2 * k], values[2 + 2 * k]))
        return self._seen

    def summary(self) -> dict[str, float]:
        """Return how many stalls there were, and the longest."""
        late_s = [late_s for _, late_s in itertools.chain(*self.by_core())]
        return {"count": len(late_s), "longest_ms": 1e3 * max(late_s, default=0.0)}

    def stalled_s(self, begin_s: float, end_s: float) -> float:
        """Return for how long the worst core stalled within a span, s."""

        def common_s(stall: Stall) -> float:
            due_s, late_s = stall
            return max(0.0, min(end_s, due_s + late_s) - max(begin_s, due_s))

        return max(sum(map(common_s, stalls)) for stalls in self.by_core())


@contextlib.contextmanager
def sentinel() -> Iterator[Sentinel]:
    """Run a sleeper on each core beside what is measured."""
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


def _sleep_and_note(descriptor: int, core: int) -> None:
    values = memoryview(mmap.mmap(descriptor, _BYTES)).cast("d")
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, {core})
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(SENTINEL_PRIORITY))
    count, due_s = 0, time.monotonic()
    while True:
        due_s += PERIOD_S
        time.sleep(max(0.0, due_s - time.monotonic()))
        late_s = time.monotonic() - due_s
        if late_s > STALL_S and count < MOST_STALLS:
            values[1 + 2 * count], values[2 + 2 * count] = due_s, late_s
            count += 1
            values[0] = count
            due_s += int(late_s / PERIOD_S) * PERIOD_S


class Starved:
    """When processes below this one, or their threads, were ready and had no core."""

    def __init__(self) -> None:
        self._spans: list[tuple[float, float, float]] = []  # begin, end, longest wait
        self._waited: dict[Path, float] = {}
        self._files: list[Path] = []
        self._found_s = self._sampled_s = float("-inf")
        with contextlib.suppress(OSError):
            policy = os.SCHED_FIFO | os.SCHED_RESET_ON_FORK
            os.sched_setscheduler(0, policy, os.sched_param(ACCOUNT_PRIORITY))

    def sample(self) -> None:
        """Note which threads waited since the last call, every `ACCOUNT_PERIOD_S`."""
        now_s = time.monotonic()
        if now_s > self._found_s + FIND_EVERY_S:
            self._files, self._found_s = _threads_below(os.getpid()), now_s
        waited = {file: seconds for file in self._files if (seconds := _waited_s(file))}
        more_s = [s - self._waited.get(file, s) for file, s in waited.items()]
        longest_s = max(more_s, default=0.0)
        if longest_s > 0.1 * ACCOUNT_PERIOD_S:
            self._spans.append((self._sampled_s, now_s, longest_s))
        self._waited, self._sampled_s = waited, now_s

    def waited_s(self, begin_s: float, end_s: float) -> float:
        """Return for how long a thread had no core within a span, s."""
        total_s = 0.0
        for since_s, until_s, longest_s in self._spans:
            common_s = min(end_s, until_s) - max(begin_s, since_s)
            total_s += min(max(0.0, common_s), longest_s)
        return total_s


def _waited_s(file: Path) -> float:
    try:
        return 1e-9 * int(file.read_text().split()[1])
    except (OSError, IndexError):
        return 0.0  # it has ended


def _threads_below(pid: int) -> list[Path]:
    found = []
    with contextlib.suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            for child in (task / "children").read_text().split():
                threads = Path(f"/proc/{child}/task").iterdir()
                found += [thread / "schedstat" for thread in threads]
                found += _threads_below(int(child))
    return found


if __name__ == "__main__":
    _sleep_and_note(int(sys.argv[1]), int(sys.argv[2]))
