"""What the window does when the kernel takes its code away from memory.

    python benchmarks/eviction.py [--rounds 3] [--evictions 4] [--offscreen]

The demo plays with the simulated device; every few seconds all pages that are files are
taken away from this control group (memory.force_empty, or memory.reclaim; root only),
as on a machine whose memory is short. The window locks its code as it always does, or
not, in turns. Told are the gaps between heartbeats and what the loop did.
"""

import argparse
import contextlib
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from common import save
from nuisance import stage

from hapticplayer.haptics.contract import HEARTBEAT_RAMP_S

NUISANCE = Path(__file__).with_name("nuisance.py")
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
    sys.exit("no control group of memory: nothing can be taken away here")


def run(
    environment: dict[str, str], options: argparse.Namespace, *, is_locked: bool
) -> dict[str, Any]:
    """Play with one kind of window, and return what was seen."""
    taker, word = control_group()
    seconds = STARTING_S + BETWEEN_S * (options.evictions + 1)
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, str(NUISANCE), "--only", "watch_it"]
        command += ["--minutes", str(seconds / 60.0), "--folder", folder]
        window = subprocess.Popen(
            command + ([] if is_locked else ["--unlocked"]),
            env=environment,
            start_new_session=True,
        )
        time.sleep(STARTING_S)
        for _ in range(options.evictions):
            with contextlib.suppress(BlockingIOError):  # there were not that many
                taker.write_text(word)
            time.sleep(BETWEEN_S)
        if window.wait():
            sys.exit(f"the window ended with {window.returncode}")
        seen: dict[str, Any] = json.loads((Path(folder) / "seen.json").read_text())
        return seen


def figures_of(seen: dict[str, Any]) -> dict[str, Any]:
    """Return what matters of one run, after its start."""
    gaps_s = np.array(seen["gaps_s"])
    gaps_s = gaps_s[np.cumsum(gaps_s) > STARTED_S]
    from_s = seen["end_s"] - 60.0 * seen["minutes"] + STARTED_S
    reactions = [
        r for r in seen["reactions"] if not r["by"] and r["monotonic_s"] > from_s
    ]
    return {
        "longest_gap_ms": 1e3 * float(gaps_s.max()),
        "too_long": int(np.count_nonzero(gaps_s > HEARTBEAT_RAMP_S)),
        "by_heartbeat": sum(r["cause"].startswith("HEARTBEAT") for r in reactions),
        "reactions": len(reactions),
    }


def main() -> int:
    """Run both kinds of window in turns, and print what they did."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--evictions", type=int, default=4, help="in each run")
    parser.add_argument("--offscreen", action="store_true")
    options = parser.parse_args()
    runs: dict[str, list[dict[str, Any]]] = {"locked": [], "not locked": []}
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        environment = stage(stack, folder, offscreen=options.offscreen, with_sound=True)
        for number in range(options.rounds):
            for kind in sorted(runs, reverse=bool(number % 2)):
                seen = run(environment, options, is_locked=kind == "locked")
                runs[kind].append(figures_of(seen))
                print(kind, runs[kind][-1])
    evictions = options.rounds * options.evictions
    for kind, of_kind in runs.items():
        print(
            f"{kind}: {evictions} evictions, heartbeats later than "
            f"{1e3 * HEARTBEAT_RAMP_S:.0f} ms {sum(r['too_long'] for r in of_kind)}, "
            f"longest gap {max(r['longest_gap_ms'] for r in of_kind):.0f} ms, "
            f"reactions by heartbeat {sum(r['by_heartbeat'] for r in of_kind)}"
        )
    print(f"saved {save('eviction', {'evictions': evictions, 'runs': runs}).name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
