"""Lateness of the haptic loop with and without a record of every tick.

    python benchmarks/recorder.py [--rounds 6] [--seconds 10] [--folder DIR]

Each round plays the same 720p30 clip with sound in a window with its live plots
twice, with `--record` and without, the other one first in every other round.
Reported are the medians over the rounds and of the ratios with to without; beside
them the same ratios of rounds without a record to each other, which is what chance
alone makes of them. The record is read back: ticks, lost ones, whether it is whole.
The load average before each round is kept, for on a busy machine chance hides
everything but the worst. `--folder` says where the record lies, to try another disk.
"""

import argparse
import itertools
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

from hapticplayer.haptics.record_reader import read_record

MEASURES = ("p50", "p99", "p999", "max", "missed_per_min")
RATIOS = ("p50", "p99", "p999")

Figures = dict[str, Any]


def play(
    clip: Path, seconds: float, environment: dict[str, str], record: Path | None
) -> Figures:
    """Play with the simulated device and return the lateness, us."""
    with tempfile.TemporaryDirectory() as folder:
        force, log = Path(folder) / "force.csv", Path(folder) / "log.jsonl"
        rows = [
            f"{t:.3f},{np.sin(9 * t):.4f},{2 * np.sin(5 * t):.4f},0"
            for t in np.arange(0, seconds, 0.005)
        ]
        force.write_text("time_s,fx_n,fy_n,fz_n\n" + "\n".join(rows) + "\n")
        command = player_command("play", str(clip), "--force", str(force))
        command += ["--duration", str(seconds), "--close-at-end", "--log", str(log)]
        command += ["--record", str(record)] if record else []
        subprocess.run(
            command, env={**os.environ, **environment}, check=True, capture_output=True
        )
        with log.open() as lines:
            summary = json.loads(list(lines)[-1])
    missed_per_min = summary["missed"] / (summary["ticks"] / 60_000)
    return {
        **summary["lateness_us"],
        "missed_per_min": missed_per_min,
        "ticks": summary["ticks"],
        "scheduling": summary["scheduling"],
    }


def play_recorded(
    clip: Path, seconds: float, environment: dict[str, str], folder: Path
) -> Figures:
    """The same with a record, and what is in it."""
    path = folder / "benchmark.record"
    try:
        figures = play(clip, seconds, environment, path)
        record = read_record(path)
        size_bytes = path.stat().st_size
    finally:
        path.unlink(missing_ok=True)
    return {
        **figures,
        "recorded": len(record.ticks),
        "lost": record.lost,
        "is_complete": record.is_complete,
        "bytes_per_tick": round(size_bytes / len(record.ticks), 2),
    }


def ratios_of(
    above: list[Figures], below: list[Figures], measure: str
) -> dict[str, float]:
    """Return median, smallest and largest of the ratios pair by pair."""
    values = [a[measure] / b[measure] for a, b in zip(above, below, strict=True)]
    return {
        "median": statistics.median(values),
        "min": min(values),
        "max": max(values),
    }


def summarised(rounds: list[dict[str, Figures]]) -> Figures:
    """Return medians and ratios."""
    runs = {name: [r[name] for r in rounds] for name in ("without", "with")}
    pairs = list(itertools.permutations(runs["without"], 2))
    chance = {
        m: [float(x) for x in np.percentile([a[m] / b[m] for a, b in pairs], [5, 95])]
        for m in RATIOS
        if pairs
    }
    return {
        "medians": {
            name: {m: statistics.median(run[m] for run in each) for m in MEASURES}
            for name, each in runs.items()
        },
        "ratios": {m: ratios_of(runs["with"], runs["without"], m) for m in RATIOS},
        "chance_5_to_95": chance,
        "lost": sum(run["lost"] for run in runs["with"]),
        "all_complete": all(run["is_complete"] for run in runs["with"]),
    }


def main() -> int:
    """Run the rounds and print the ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--folder", type=Path)
    options = parser.parse_args()
    need("Xvfb", "pulseaudio", "pactl")
    rounds: list[dict[str, Figures]] = []
    with tempfile.TemporaryDirectory() as folder, screen() as x, sound_server() as s:
        clip = moving_clip(Path(folder), options.seconds + 6)
        environment = {**x, **s, "XDG_CONFIG_HOME": folder}
        target = options.folder or Path(folder)
        for number in range(options.rounds):
            found: dict[str, Figures] = {
                "machine": {"load_average": os.getloadavg()[0]}
            }
            for name in ("without", "with") if number % 2 else ("with", "without"):
                found[name] = (
                    play_recorded(clip, options.seconds, environment, target)
                    if name == "with"
                    else play(clip, options.seconds, environment, None)
                )
            rounds.append(found)
            print(f"round {number + 1} of {options.rounds} done", file=sys.stderr)
    report(rounds, options.seconds)
    return 0


def report(rounds: list[dict[str, Figures]], seconds: float) -> None:
    """Print and save medians and ratios."""
    figures = summarised(rounds)
    rows = [
        [f"{name} a record", *[each[m] for m in MEASURES]]
        for name, each in figures["medians"].items()
    ]
    print(table(["", *MEASURES], rows))
    for measure in RATIOS:
        ratio, chance = figures["ratios"][measure], figures["chance_5_to_95"]
        beside = chance.get(measure)
        print(
            f"{measure}: with / without {ratio['median']:.2f} "
            f"({ratio['min']:.2f} to {ratio['max']:.2f})"
            + (f"; by chance {beside[0]:.2f} to {beside[1]:.2f}" if beside else "")
        )
    busiest = max(r["machine"]["load_average"] for r in rounds)
    print(f"load average before the rounds: up to {busiest:.1f}")
    print(f"lost ticks {figures['lost']}, all complete: {figures['all_complete']}")
    path = save("recorder", {"seconds": seconds, "rounds": rounds, **figures})
    print(f"saved {path.name}")


if __name__ == "__main__":
    sys.exit(main())
