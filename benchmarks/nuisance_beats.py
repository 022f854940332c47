"""What the window's thread did between two heartbeats, without disturbing it."""

import resource
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np

LONG_GAP_S = 0.1
SAMPLE_S = 0.02
SILENT_S = 0.06
MOST_SAMPLES = 10
DEPTH = 10


class Beats:
    """When the window's thread was heard, and what it did in between.

    Args:
        long_s: of longer gaps everything is kept.
        silent_s: after so long the thread's functions are noted.
    """

    def __init__(self, long_s: float = LONG_GAP_S, silent_s: float = SILENT_S) -> None:
        self._long_s, self._silent_s = long_s, silent_s
        self.gaps_s: list[float] = []
        self.long: list[dict[str, Any]] = []
        self.resyncs_s: list[float] = []
        self.doing = ""
        self._last_s = 0.0
        self._before, self._faults_before = (0.0, 0.0), 0
        task = f"/proc/self/task/{threading.get_native_id()}/schedstat"
        self._schedstat = Path(task).open()  # noqa: SIM115 - open as long as we run
        self._watched = threading.get_ident()
        self._stacks: list[dict[str, Any]] = []
        self._is_over = threading.Event()
        self._sampler = threading.Thread(target=self._sample, daemon=True)
        self._sampler.start()

    def beat(self) -> None:
        """Call at each heartbeat; the next may be `long_s` away."""
        now_s, used = time.monotonic(), self._used()
        faults = resource.getrusage(resource.RUSAGE_SELF).ru_majflt
        gap_s = now_s - self._last_s if self._last_s else 0.0
        self.gaps_s.append(gap_s)
        if gap_s > self._long_s:
            computed_s, waited_s = np.subtract(used, self._before)
            self.long.append(
                {
                    "begin_s": self._last_s,
                    "gap_s": gap_s,
                    "computed_s": float(computed_s),
                    "waited_for_a_core_s": float(waited_s),
                    "waits_for_the_disk": faults - self._faults_before,
                    "script": self.doing,
                    "stacks": self._stacks,
                }
            )
        self._last_s, self._before, self._stacks = now_s, used, []
        self._faults_before = faults

    def end(self) -> None:
        """Look no more."""
        self._is_over.set()
        self._sampler.join()

    def _used(self) -> tuple[float, float]:
        self._schedstat.seek(0)
        ran, waited, _ = self._schedstat.read().split()
        return 1e-9 * int(ran), 1e-9 * int(waited)

    def _sample(self) -> None:
        """Note where the window's thread is while it is not heard."""
        while not self._is_over.wait(SAMPLE_S):
            after_s = time.monotonic() - self._last_s
            if after_s > self._silent_s and len(self._stacks) < MOST_SAMPLES:
                job = next((t for t in threading.enumerate() if t.name == "job"), None)
                self._stacks.append(
                    {
                        "after_s": after_s,
                        "window": _stack_of(self._watched),
                        "job": _stack_of(job.ident) if job else [],
                    }
                )


def _stack_of(thread: int | None) -> list[str]:
    """Return the innermost functions of a thread.

    In microseconds: while we hold a frame its locals live on, and a painter that
    outlives its paintEvent brings Qt down.
    """
    frame, places = sys._current_frames().get(thread or 0), []  # noqa: SLF001
    while frame is not None and len(places) < DEPTH:
        places.append((frame.f_code, frame.f_lineno))
        frame = frame.f_back
    return [f"{Path(c.co_filename).name}:{line} {c.co_name}" for c, line in places]
