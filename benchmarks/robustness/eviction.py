"""What the window does when the kernel takes its code out of memory.

The demo plays with the simulated device; every few seconds all pages that are files are
taken from this control group (memory.force_empty or memory.reclaim; root only), as on a
machine that is short of memory. The window locks its code as it always does, or not,
alternating.
"""

import argparse
import contextlib
import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report, interleaved
from benchmarks.robustness.nuisance import stage, window_command
from hapticplayer.haptics.contract import HEARTBEAT_RAMP_S

STARTING_S, STARTED_S, BETWEEN_S = 12.0, 10.0, 6.0
ALL_BYTES = 1 << 34


def control_group() -> tuple[Path, str]:
    """Return the file that takes pages away, and what to write to it."""
    for line in Path("/proc/self/cgroup").read_text().splitlines():
        _, kinds, path = line.split(":", 2)
        if kinds == "memory":
            return Path(f"/sys/fs/cgroup/memory{path}/memory.force_empty"), "0"
        if not kinds and Path(f"/sys/fs/cgroup{path}/memory.reclaim").exists():
            return Path(f"/sys/fs/cgroup{path}/memory.reclaim"), str(ALL_BYTES)
    sys.exit("there is no memory control group to take pages from")


def play(options: argparse.Namespace, *, is_locked: bool) -> dict[str, Any]:
    """Play with one kind of window; return what matters after its start."""
    taker, word = control_group()
    minutes = (STARTING_S + BETWEEN_S * (options.evictions + 1)) / 60.0
    chosen = {"seed": 1, "only": "watch", "sound": True, "quick": False}
    with stage(is_offscreen=options.offscreen, has_sound=True) as (folder, environment):
        command = window_command(folder, minutes, locked=is_locked, **chosen)
        window = subprocess.Popen(command, env=environment, cwd=ROOT)
        time.sleep(STARTING_S)
        for _ in range(options.evictions):
            with contextlib.suppress(BlockingIOError):  # there were not that many
                taker.write_text(word)
            time.sleep(BETWEEN_S)
        if window.wait():
            sys.exit(f"the window ended with {window.returncode}")
        seen = json.loads((folder / "seen.json").read_text())
    gaps_s = np.array(seen["gaps_s"])
    gaps_s = gaps_s[np.cumsum(gaps_s) > STARTED_S]
    from_s = seen["end_s"] - 60.0 * seen["minutes"] + STARTED_S
    causes = [
        r["cause"]
        for r in seen["reactions"]
        if not r["by"] and r["monotonic_s"] > from_s
    ]
    return {
        "longest_gap_ms": 1e3 * float(gaps_s.max()),
        "late": int(np.count_nonzero(gaps_s > HEARTBEAT_RAMP_S)),
        "by_heartbeat": sum(cause.startswith("HEARTBEAT") for cause in causes),
        "reactions": len(causes),
    }


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(3)")
    parser.add_argument("--evictions", type=int, default=4, help="in each run")
    parser.add_argument("--offscreen", action="store_true")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run both kinds of window alternating."""
    rounds = options.rounds or (1 if options.quick else 3)
    kinds = {
        "locked": lambda: play(options, is_locked=True),
        "not locked": lambda: play(options, is_locked=False),
    }
    runs = interleaved(kinds, rounds)
    rows = [
        [kind, rounds * options.evictions, sum(r["late"] for r in found),
         max(r["longest_gap_ms"] for r in found), sum(r["by_heartbeat"] for r in found)]
        for kind, found in runs.items()
    ]  # fmt: skip
    header = ["window", "evictions", f"later than {1e3 * HEARTBEAT_RAMP_S:.0f} ms"]
    report.table("Heartbeats", [*header, "longest gap ms", "reactions"], rows)
    report.target("late heartbeats, locked", rows[0][2], ("<=", 0))
    report.figures |= {"evictions": options.evictions, "runs": runs}
