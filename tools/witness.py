"""Independent witnesses of what the machine took from a measurement or a test.

A sleeper of the highest priority on each core tells when that core stalled; a process
that reads the kernel's account of each thread tells which were ready and had no core.
"""

import contextlib
import mmap
import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

PERIOD_S, STALL_S = 0.001, 0.001
SENTINEL_PRIORITY = 99
ACCOUNT_PERIOD_S, FIND_EVERY_S = 0.04, 0.2
ACCOUNT_PRIORITY = 50  # below every loop, above whatever starves others
MOST_ROWS = 200_000
Stall = tuple[float, float]
"""Monotonic time of the missed wake-up, and how late it was, s."""
Wait = tuple[float, float, float]
"""A span of monotonic time, and how long a thread had no core in it, s."""


class Rows:
    """Rows of numbers in a file in memory: one process appends, another reads."""

    def __init__(self, descriptor: int, width: int) -> None:
        size = 8 * (1 + width * MOST_ROWS)
        os.ftruncate(descriptor, size)
        self._values = memoryview(mmap.mmap(descriptor, size)).cast("d")
        self._width, self._read = width, 0

    def append(self, *row: float) -> None:
        """Rows beyond `MOST_ROWS` are dropped."""
        count = int(self._values[0])
        if count < MOST_ROWS:
            for column, value in enumerate(row):
                self._values[1 + self._width * count + column] = value
            self._values[0] = count + 1

    def new(self) -> list[Any]:
        """The rows that came since the last call."""
        before, self._read = self._read, int(self._values[0])
        starts = range(1 + self._width * before, 1 + self._width * self._read)
        return [
            tuple(self._values[k : k + self._width]) for k in starts[:: self._width]
        ]


@dataclass
class Seen:
    """What was seen so far, in the order of time.

    Attributes:
        stalls: of each core.
        waits: of the thread that waited longest, whichever it was.
    """

    stalls: list[list[Stall]]
    waits: list[Wait] = field(default_factory=list)

    def summary(self) -> dict[str, float]:
        late_s = [late_s for core in self.stalls for _, late_s in core]
        return {"count": len(late_s), "longest_ms": 1e3 * max(late_s, default=0.0)}

    def stalled_s(self, begin_s: float, end_s: float) -> float:
        """For how long the worst core stalled within a span, s."""
        return max(
            sum(_common_s((at, at + late), (begin_s, end_s)) for at, late in core)
            for core in self.stalls
        )

    def waited_s(self, begin_s: float, end_s: float) -> float:
        """For how long a thread had no core within a span, s."""
        return sum(
            min(_common_s((since_s, until_s), (begin_s, end_s)), longest_s)
            for since_s, until_s, longest_s in self.waits
        )


def _common_s(one: tuple[float, float], other: tuple[float, float]) -> float:
    return max(0.0, min(one[1], other[1]) - max(one[0], other[0]))


class Witness:
    """The processes that watch: a sleeper on each core, and an account of threads."""

    def __init__(self, rows: Sequence[Rows]) -> None:
        *self._cores, self._account = rows
        self._seen = Seen([[] for _ in self._cores])

    def seen(self) -> Seen:
        """What was seen since the beginning, or since `forget`."""
        for stalls, rows in zip(self._seen.stalls, self._cores, strict=True):
            stalls.extend(rows.new())
        self._seen.waits += self._account.new()
        return self._seen

    def forget(self) -> None:
        """Begin anew."""
        self.seen()
        self._seen = Seen([[] for _ in self._cores])


@contextlib.contextmanager
def machine_witness(period_s: float = PERIOD_S) -> Iterator[Witness]:
    """Watch this process, those below it and all cores, from beside them."""
    watches = [["sleep", period_s, core] for core in sorted(os.sched_getaffinity(0))]
    with contextlib.ExitStack() as stack:
        rows = []
        for kind, *arguments in [*watches, ["account"]]:
            descriptor = os.memfd_create("witness")
            stack.callback(os.close, descriptor)
            rows.append(Rows(descriptor, len(arguments) or 3))
            command = [sys.executable, "-S", "-E", __file__, kind, descriptor]
            process = subprocess.Popen(
                [str(word) for word in (*command, *arguments)], pass_fds=(descriptor,)
            )
            stack.callback(process.wait)
            stack.callback(process.kill)
        yield Witness(rows)


def _sleep_and_note(rows: Rows, period_s: float, core: int) -> None:
    with contextlib.suppress(OSError):
        os.sched_setaffinity(0, {core})
    _ask_for_priority(SENTINEL_PRIORITY)
    parent, due_s = os.getppid(), time.monotonic()
    while os.getppid() == parent:
        due_s += period_s
        time.sleep(max(0.0, due_s - time.monotonic()))
        late_s = time.monotonic() - due_s
        if late_s > STALL_S:
            rows.append(due_s, late_s)
            due_s += int(late_s / period_s) * period_s


def _account(rows: Rows) -> None:
    """Note which threads of the parent and of all below it waited for a core."""
    _ask_for_priority(ACCOUNT_PRIORITY)
    parent, waited, files = os.getppid(), dict[Path, float](), list[Path]()
    found_s = sampled_s = float("-inf")
    while os.getppid() == parent:
        now_s = time.monotonic()
        if now_s > found_s + FIND_EVERY_S:
            files, found_s = _threads_of(parent), now_s
        now = {file: seconds for file in files if (seconds := _waited_s(file))}
        longest_s = max((s - waited.get(file, s) for file, s in now.items()), default=0)
        if longest_s > 0.1 * ACCOUNT_PERIOD_S:
            rows.append(sampled_s, now_s, longest_s)
        waited, sampled_s = now, now_s
        time.sleep(ACCOUNT_PERIOD_S)


def _ask_for_priority(priority: int) -> None:
    with contextlib.suppress(OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(priority))


def _waited_s(file: Path) -> float:
    try:
        return 1e-9 * int(file.read_text().split()[1])
    except (OSError, IndexError):
        return 0.0  # it has ended


def _threads_of(pid: int) -> list[Path]:
    found = []
    with contextlib.suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            found.append(task / "schedstat")
            for child in (task / "children").read_text().split():
                if int(child) != os.getpid():
                    found += _threads_of(int(child))
    return found


if __name__ == "__main__":
    kind, descriptor, *numbers = sys.argv[1:]
    if kind == "account":
        _account(Rows(int(descriptor), 3))
    else:
        _sleep_and_note(Rows(int(descriptor), 2), float(numbers[0]), int(numbers[1]))
