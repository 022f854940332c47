"""Lateness of the haptic loop with and without a record of every tick.

Each round plays the same 720p30 clip with sound in a window with its live plots twice,
with `--record` and without. BackgroundLookup the ratios stand those of rounds without a record to
each other, which is what chance alone makes of them. The record is read back: ticks,
lost ones, whether it is complete.
"""

import argparse
import itertools
import json
import os
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report, interleaved, medians, ratio
from benchmarks.stage import (
    moving_clip,
    player_command,
    screen,
    sound_server,
    waves_file,
)
from hapticplayer.haptics.record_reader import read_record

MEASURES = ("p50", "p99", "p999")
Figures = dict[str, Any]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--rounds", type=int, help="(6)")
    parser.add_argument("--seconds", type=float, default=10.0)
    text = "where the record lies, to try another disk"
    parser.add_argument("--folder", type=Path, help=text)


def run(options: argparse.Namespace, report: Report) -> None:
    """Run the rounds and compare."""
    rounds = options.rounds or (1 if options.quick else 6)
    seconds = 4.0 if options.quick else options.seconds
    with tempfile.TemporaryDirectory() as name, screen() as x, sound_server() as s:
        folder = Path(name)
        clip, force = moving_clip(folder, seconds + 6), waves_file(folder, seconds)
        environment = {**os.environ, **x, **s.environment, "XDG_CONFIG_HOME": name}
        record = (options.folder or folder) / "benchmark.record"

        def play(*more: str) -> Figures:
            log = folder / "log.jsonl"
            log.unlink(missing_ok=True)
            command = player_command("play", str(clip), "--force", str(force), *more)
            command += ["--duration", str(seconds), "--close-at-end", "--log", str(log)]
            subprocess.run(
                command, env=environment, cwd=ROOT, check=True, capture_output=True
            )
            summary = json.loads(log.read_text().splitlines()[-1])
            missed = summary["missed"] / (summary["ticks"] / 60_000)
            return {**summary["lateness_us"], "missed_per_min": missed}

        def play_recorded() -> Figures:
            try:
                figures = play("--record", str(record))
                found, size = read_record(record), record.stat().st_size
            finally:
                record.unlink(missing_ok=True)
            each = size / len(found.ticks)
            whole = {"lost": found.lost, "is_complete": int(found.is_complete)}
            return {**figures, **whole, "bytes_per_tick": each}

        found = interleaved({"without": play, "with": play_recorded}, rounds)
    show(found, report)
    report.figures |= {"rounds": rounds, "seconds": seconds}


def show(found: dict[str, list[Figures]], report: Report) -> None:
    """Show medians, ratios, and what chance makes of them."""
    middle = {name: medians(rounds) for name, rounds in found.items()}
    keys = (*MEASURES, "max", "missed_per_min")
    rows = [[f"{name} a record", *(m[k] for k in keys)] for name, m in middle.items()]
    report.table("Lateness, us", ["", *keys], rows)
    rows = []
    for key in MEASURES:
        plain, recorded = ([r[key] for r in found[n]] for n in ("without", "with"))
        each = ratio(recorded, plain)
        pairs = [a / b for a, b in itertools.permutations(plain, 2)] or [np.nan]
        chance = np.percentile(pairs, [5, 95]).tolist()
        rows.append([key, *each, *chance])
        report.figures[f"{key}_ratio"] = {**each._asdict(), "chance_5_to_95": chance}
    header = ["with / without", "median", "least", "largest", "chance 5 %", "95 %"]
    report.table("Ratios", header, rows)
    recorded = found["with"]
    report.target("ticks lost", sum(r["lost"] for r in recorded), ("<=", 0))
    least = min(r["is_complete"] for r in recorded)
    report.target("records complete (1: all)", least, (">=", 1))
    report.figures["medians"] = middle
