"""Which processes were ready and had no core: the share of a delay that is the load's.

Read from outside, from the kernel's own account of each thread, so that neither the
interpreter of those watched nor a lock that one of them holds hides anything.
"""

import contextlib
import os
import time
from pathlib import Path

PERIOD_S = 0.04
FIND_EVERY_S = 1.0
PRIORITY = 50  # below every loop, above all that starves others


class Starved:
    """Watches all processes under this one, and their threads."""

    def __init__(self) -> None:
        self._spans: list[tuple[float, float, float]] = []  # begin, end, longest wait
        self._waited: dict[Path, float] = {}
        self._files: list[Path] = []
        self._found_s = self._looked_s = float("-inf")
        with contextlib.suppress(OSError):
            os.sched_setscheduler(
                0,
                os.SCHED_FIFO | os.SCHED_RESET_ON_FORK,
                os.sched_param(PRIORITY),
            )

    def look(self) -> None:
        """Note who has waited since the last call; call it every `PERIOD_S`."""
        now_s = time.monotonic()
        if now_s > self._found_s + FIND_EVERY_S:
            self._files, self._found_s = _threads_below(os.getpid()), now_s
        waited = {file: seconds for file in self._files if (seconds := _waited_s(file))}
        more_s = [
            s - self._waited[file] for file, s in waited.items() if file in self._waited
        ]
        longest_s = max(more_s, default=0.0)
        if longest_s > 0.1 * PERIOD_S:
            self._spans.append((self._looked_s, now_s, longest_s))
        self._waited, self._looked_s = waited, now_s

    def waited_s(self, begin_s: float, end_s: float) -> float:
        """Return for how long somebody had no core within a span, s."""
        total_s = 0.0
        for since_s, until_s, longest_s in self._spans:
            common_s = min(end_s, until_s) - max(begin_s, since_s)
            if common_s > 0.0:
                total_s += min(common_s, longest_s)
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
