"""What it costs to wake a little early and spin to the deadline, 1000 times a second.

The loop once did so for its last 18 us. A process with SCHED_FIFO that does nothing but
wake, as the loop does now and with the spin, in turn, and cyclictest beside them: how
late, and which share of a core. Nobody feels 20 us.
"""

import argparse
import subprocess
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from benchmarks.common import Report, interleaved, medians
from benchmarks.stage import need
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.limiter import PERIOD_S
from hapticplayer.linux import FIFO_PRIORITY, acquire

EARLY_S = 18e-6
MOST_US = 100.0
"""A tenth of a period."""


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(6)")
    parser.add_argument("--seconds", type=float, help="(5) of each in a round")


def run(options: argparse.Namespace, report: Report) -> None:
    """Wake in both ways, beside cyclictest."""
    need("cyclictest")
    rounds = options.rounds or (2 if options.quick else 6)
    seconds = options.seconds or (1.0 if options.quick else 5.0)
    scheduling = acquire(priority=FIFO_PRIORITY)
    contenders = {
        "sleep": partial(_woken, SystemClock.sleep_until, seconds),
        "spin for the last 18 us": partial(_woken, _spin_until, seconds),
        "cyclictest -m -p80": partial(_cyclictest, seconds),
    }
    middle = {
        name: medians(each) for name, each in interleaved(contenders, rounds).items()
    }
    rows = [
        [name, *(one.get(key, "-") for key in ("p50", "p99", "p999", "percent"))]
        for name, one in middle.items()
    ]
    header = ["", "p50 us", "p99 us", "p99.9 us", "% of a core"]
    report.table("Waking", header, rows, "waking")
    report.target("sleep: lateness, median us", middle["sleep"]["p50"], ("<=", MOST_US))
    report.figures |= {"rounds": rounds, "seconds": seconds, "medians": middle}
    report.figures |= {"scheduling": scheduling.value}


def _spin_until(deadline_s: float) -> None:
    SystemClock.sleep_until(deadline_s - EARLY_S)
    while time.monotonic() < deadline_s:
        pass


def _woken(wait: Callable[[float], None], seconds: float) -> dict[str, float]:
    late_s, deadline_s = [], time.monotonic() + PERIOD_S
    begin_s, cpu_s = time.monotonic(), time.thread_time()
    for _ in range(round(seconds / PERIOD_S)):
        wait(deadline_s)
        now_s = time.monotonic()
        late_s.append(now_s - deadline_s)
        deadline_s += (1 + int(late_s[-1] / PERIOD_S)) * PERIOD_S
    took_s, cpu_s = time.monotonic() - begin_s, time.thread_time() - cpu_s
    p50, p99, p999 = (1e6 * np.percentile(late_s, (50.0, 99.0, 99.9))).tolist()
    return {"p50": p50, "p99": p99, "p999": p999, "percent": 100.0 * cpu_s / took_s}


def _cyclictest(seconds: float) -> dict[str, float]:
    with tempfile.TemporaryDirectory() as folder:
        histogram = Path(folder) / "histogram"
        test = ["cyclictest", "-m", "-p80", "-i1000", "-q", "-h", "60000"]
        test += ["-D", str(max(1, int(seconds))), f"--histfile={histogram}"]
        subprocess.run(test, check=True, capture_output=True)
        late_us, count = np.loadtxt(histogram, comments="#", dtype=int).T
    share = np.cumsum(count) / count.sum()
    p50, p99, p999 = (
        float(late_us[np.searchsorted(share, q)]) for q in (0.5, 0.99, 0.999)
    )
    return {"p50": p50, "p99": p99, "p999": p999}
