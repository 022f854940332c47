"""Lateness of the haptic loop under playback load, beside cyclictest.

    python benchmarks/loop.py [--rounds 4] [--seconds 20]

Each round plays the same 720p30 clip with sound in a window with its live plots:
once with our loop (FIFO), once with our loop (slice), and once without a device
while `cyclictest -m -p80 -i1000` runs beside it. Reported are the medians over the
rounds of the ratios to cyclictest.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from common import moving_clip, need, player_command, save, screen, sound_server, table

MEASURES = ("p50", "p99", "p999", "max", "missed_per_min")


def our_loop(
    clip: Path, scheduling: str, seconds: float, environment: dict[str, str]
) -> dict[str, float]:
    """Play with the simulated device and return the lateness, us."""
    with tempfile.TemporaryDirectory() as folder:
        force, log = Path(folder) / "force.csv", Path(folder) / "log.jsonl"
        rows = [
            f"{t:.3f},{np.sin(9 * t):.4f},{2 * np.sin(5 * t):.4f},0"
            for t in np.arange(0, seconds, 0.005)
        ]
        force.write_text("time_s,fx_n,fy_n,fz_n\n" + "\n".join(rows) + "\n")
        command = player_command(
            "play", str(clip), "--force", str(force), "--scheduling", scheduling
        )
        command += ["--duration", str(seconds), "--close-at-end", "--log", str(log)]
        subprocess.run(
            command, env={**os.environ, **environment}, check=True, capture_output=True
        )
        with log.open() as lines:
            summary = json.loads(list(lines)[-1])
    if summary["scheduling"] != scheduling:
        return {}
    minutes = summary["ticks"] / 60_000
    return {**summary["lateness_us"], "missed_per_min": summary["missed"] / minutes}


def cyclictest(
    clip: Path, seconds: float, environment: dict[str, str], arguments: list[str]
) -> dict[str, float]:
    """Play without a device beside cyclictest and return its lateness, us."""
    command = player_command("play", str(clip), "--device", "none", "--close-at-end")
    command += ["--duration", str(seconds + 4)]
    player = subprocess.Popen(
        command,
        env={**os.environ, **environment},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    with tempfile.NamedTemporaryFile("r") as histogram:
        subprocess.run(["sleep", "1"], check=True)  # as long as ours takes to start
        test = ["cyclictest", *arguments, "-i1000", "-q", "-D", str(int(seconds))]
        test += ["-h", "60000", f"--histfile={histogram.name}"]
        subprocess.run(test, check=True, capture_output=True)
        counts = [
            [int(value) for value in line.split()]
            for line in histogram
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
    parser.add_argument("--rounds", type=int, default=4)
    parser.add_argument("--seconds", type=float, default=20.0)
    options = parser.parse_args()
    need("Xvfb", "cyclictest", "pulseaudio", "pactl")
    rounds: list[dict[str, dict[str, float]]] = []
    with tempfile.TemporaryDirectory() as folder, screen() as x, sound_server() as s:
        clip = moving_clip(Path(folder), options.seconds + 6)
        environment = {**x, **s, "XDG_CONFIG_HOME": folder}
        for number in range(options.rounds):
            rounds.append(
                {
                    "loop fifo": our_loop(clip, "fifo", options.seconds, environment),
                    "cyclictest -m -p80": cyclictest(
                        clip, options.seconds, environment, ["-m", "-p80"]
                    ),
                    "loop slice": our_loop(clip, "slice", options.seconds, environment),
                }
            )
            print(f"round {number + 1} of {options.rounds} done", file=sys.stderr)
    report(rounds, options)
    return 0


def report(rounds: list[dict[str, dict[str, float]]], options: Any) -> None:
    """Print and save medians and ratios."""
    names = [name for name in rounds[0] if rounds[0][name]]
    medians = {
        name: {m: statistics.median(r[name][m] for r in rounds) for m in MEASURES}
        for name in names
    }
    ratios: dict[str, dict[str, float]] = {}
    for name in names:
        ratios[name] = {}
        for measure in ("p99", "p999", "missed_per_min"):
            pairs = [
                (r[name][measure], r["cyclictest -m -p80"][measure]) for r in rounds
            ]
            # with nothing missed on either side the ratio is 1 by definition
            values = [(a + 1e-9) / (b + 1e-9) for a, b in pairs]
            ratios[name][measure] = statistics.median(values)
    rows = [
        [name, *[medians[name][m] for m in MEASURES], *ratios[name].values()]
        for name in names
    ]
    header = [
        "",
        *[f"{m} us" if m[0] in "pm" and "mis" not in m else m for m in MEASURES],
    ]
    header += ["p99 ratio", "p99.9 ratio", "missed ratio"]
    print(table(header, rows))
    figures = {
        "seconds": options.seconds,
        "rounds": rounds,
        "medians": medians,
        "ratios_to_cyclictest": ratios,
    }
    print(f"saved {save('loop', figures).name}")


if __name__ == "__main__":
    sys.exit(main())
