"""Lateness of the haptic loop under load, beside cyclictest, and commands too old.

    python benchmarks/loop.py [--rounds 6] [--seconds 20] [--loads playback stress]
                              [--device falcon-simulated]

Each round plays the same 720p30 clip with sound in a window with its live plots:
once with our loop (FIFO), once without a device while `cyclictest -m -p80 -i1000`
runs beside it, once with our loop (slice). Their order changes from round to round, and
so does that of the loads: a machine that was worked hard may be slower for a while. Under the load `stress` the window's
interpreter is held for 2 s every 7 s and makes garbage all the time (loop_load).
Reported are the medians over the rounds of the ratios to cyclictest, and how many
commands were older than 20 ms: withheld by the loop, or refused by the device; and
how old the answers were that the loop acted on. With `--device falcon-simulated` the
loop speaks through the Falcon's own driver, pyusb and the chip's 1 ms latency timer;
the result is a file of its own.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from common import moving_clip, need, save, screen, sound_server, table
from loop_load import LOADS, STARTING_S, loaded_player

MEASURES = ("p50", "p99", "p999", "max", "missed_per_min")
AGE = "age_p99_us"
RATIOS = ("p99", "p999", "missed_per_min")
OLD = ("withheld", "refused")
DEVICES = ("simulated", "falcon-simulated")
REFERENCE = "cyclictest -m -p80"
Rounds = list[dict[str, dict[str, float]]]


def our_loop(
    clip: Path, load: str, kind: str, seconds: float, environment: dict[str, str]
) -> dict[str, float]:
    """Play with a device, `DEVICE SCHEDULING`, and return lateness, us, and old commands."""
    device, scheduling = kind.split()
    with tempfile.TemporaryDirectory() as folder:
        force, log = Path(folder) / "force.csv", Path(folder) / "log.jsonl"
        seen = Path(folder) / "seen.json"
        rows = [
            f"{t:.3f},{np.sin(9 * t):.4f},{2 * np.sin(5 * t):.4f},0"
            for t in np.arange(0, seconds, 0.005)
        ]
        force.write_text("time_s,fx_n,fy_n,fz_n\n" + "\n".join(rows) + "\n")
        command = loaded_player(
            load, seen, seconds + STARTING_S, "play", str(clip), "--force", str(force)
        )
        command += ["--device", device, "--scheduling", scheduling, "--log", str(log)]
        subprocess.run(
            command, env={**os.environ, **environment}, check=True, capture_output=True
        )
        with log.open() as lines:
            summary = json.loads(list(lines)[-1])
        counted = json.loads(seen.read_text())
    if summary["scheduling"] != scheduling:
        return {}
    return dict(counted)


def cyclictest(
    clip: Path,
    load: str,
    arguments: list[str],
    seconds: float,
    environment: dict[str, str],
) -> dict[str, float]:
    """Play without a device beside cyclictest and return its lateness, us."""
    with tempfile.TemporaryDirectory() as folder:
        seen, histogram = Path(folder) / "seen.json", Path(folder) / "histogram"
        command = loaded_player(
            load, seen, seconds + STARTING_S + 2, "play", str(clip), "--device", "none"
        )
        player = subprocess.Popen(
            command,
            env={**os.environ, **environment},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        time.sleep(STARTING_S)
        test = ["cyclictest", *arguments, "-i1000", "-q", "-D", str(int(seconds))]
        test += ["-h", "60000", f"--histfile={histogram}"]
        subprocess.run(test, check=True, capture_output=True)
        with histogram.open() as lines:
            counts = [
                [int(value) for value in line.split()]
                for line in lines
                if line.strip() and not line.startswith("#")
            ]
        player.wait()
    late_us, count = np.array(counts).T
    return _percentiles(late_us, count)


def _percentiles(late_us: Any, count: Any) -> dict[str, float]:
    share = np.cumsum(count) / count.sum()
    found = {
        name: float(late_us[np.searchsorted(share, q)])
        for name, q in (("p50", 0.5), ("p99", 0.99), ("p999", 0.999))
    }
    found["max"] = float(late_us[count > 0].max())
    missed = float((late_us // 1000 * count).sum())
    found["missed_per_min"] = missed / (count.sum() / 60_000)
    return found


def main() -> int:
    """Run the rounds and print the ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--loads", nargs="+", choices=LOADS, default=list(LOADS))
    parser.add_argument("--device", choices=DEVICES, default="simulated")
    options = parser.parse_args()
    need("Xvfb", "cyclictest", "pulseaudio", "pactl")
    rounds: dict[str, Rounds] = {load: [] for load in options.loads}
    with tempfile.TemporaryDirectory() as folder, screen() as x, sound_server() as s:
        clip = moving_clip(Path(folder), options.seconds + 6)
        environment = {**x, **s, "XDG_CONFIG_HOME": folder}
        for number in range(options.rounds):
            for load in options.loads[:: -1 if number % 2 else 1]:
                rounds[load].append(
                    one_round(
                        *(number, clip, load),
                        *(options.device, options.seconds, environment),
                    )
                )
            print(f"round {number + 1} of {options.rounds} done", file=sys.stderr)
    figures = {load: compared(rounds[load]) for load in options.loads}
    for load in options.loads:
        report(load, figures[load])
    load_average = os.getloadavg()
    print(f"load average of the machine at the end: {load_average}")
    name = "loop" if options.device == "simulated" else f"loop_{options.device}"
    saved = save(
        name, {"seconds": options.seconds, "load_average": load_average, **figures}
    )
    print(f"saved {saved.name}")
    return 0


def one_round(
    number: int,
    clip: Path,
    load: str,
    device: str,
    seconds: float,
    environment: dict[str, str],
) -> dict[str, dict[str, float]]:
    """Measure all three, one after the other; each comes first in every third round."""
    given = seconds, environment
    calls: dict[str, Callable[[], dict[str, float]]] = {
        "loop fifo": lambda: our_loop(clip, load, f"{device} fifo", *given),
        REFERENCE: lambda: cyclictest(clip, load, ["-m", "-p80"], *given),
        "loop slice": lambda: our_loop(clip, load, f"{device} slice", *given),
    }
    first = number % len(calls)
    found = {name: calls[name]() for name in [*calls][first:] + [*calls][:first]}
    return {name: found[name] for name in calls}


def compared(rounds: Rounds) -> dict[str, Any]:
    """Return medians over the rounds, and medians of the ratios within each."""
    names = [name for name in rounds[0] if all(r[name] for r in rounds)]
    medians = {
        name: {m: statistics.median(r[name][m] for r in rounds) for m in MEASURES}
        for name in names
    }
    # with nothing missed on either side the ratio is 1 by definition
    ratios = {
        name: {
            m: statistics.median(
                (r[name][m] + 1e-9) / (r[REFERENCE][m] + 1e-9) for r in rounds
            )
            for m in RATIOS
        }
        for name in names
    }
    old = {
        name: {kind: sum(r[name][kind] for r in rounds) for kind in OLD}
        for name in names
        if name != REFERENCE
    }
    ages = {
        name: statistics.median(r[name][AGE] for r in rounds)
        for name in names
        if name != REFERENCE
    }
    return {
        "medians": medians,
        "reply_age_p99_us": ages,
        "ratios_to_cyclictest": ratios,
        "old_commands": old,
        "rounds": rounds,
    }


def report(load: str, figures: dict[str, Any]) -> None:
    """Print medians, ratios, and the commands that grew too old."""
    medians, ratios = figures["medians"], figures["ratios_to_cyclictest"]
    rows = [
        [name, *medians[name].values(), *ratios[name].values()]
        + [figures["old_commands"].get(name, {}).get(kind, "") for kind in OLD]
        + [figures["reply_age_p99_us"].get(name, "")]
        for name in medians
    ]
    header = [load, "p50 us", "p99 us", "p99.9 us", "max us", "missed/min"]
    compared_by = ["p99 ratio", "p99.9 ratio", "missed ratio"]
    print(table([*header, *compared_by, *OLD, "answer p99 us"], rows))


if __name__ == "__main__":
    sys.exit(main())
