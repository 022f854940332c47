"""Lateness of the haptic loop under load, beside cyclictest, and commands too old.

Each round plays the same 720p30 clip with sound in a window with its live plots: with
our loop (FIFO), without a device while `cyclictest -m -p80 -i1000` runs beside it, and
with our loop (slice). Under the load `stress` the window's interpreter is held for 2 s
every 7 s and makes garbage all the time. Old commands were older than 20 ms: withheld
by the loop, or refused by the device. `--device falcon-simulated` speaks through the
Falcon's own driver, pyusb and the chip's 1 ms latency timer.
"""

import argparse
import functools
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report, interleaved, medians, ratio
from benchmarks.stage import (
    moving_clip,
    need,
    player_command,
    screen,
    sound_server,
    waves_file,
)
from hapticplayer.haptics.record_reader import read_record

LOADS = ("playback", "stress")
DEVICES = ("simulated", "falcon-simulated")
REFERENCE, OURS = "cyclictest -m -p80", "loop, fifo"
LIMITS = {"p99": 1.2, "p999": 1.5}
HOLD_S, EVERY_S = 2.0, 7.0
# A window that opens costs what no loop can help; held up meanwhile, it would be closed
# before it plays.
STARTING_S = 2.0
REARM_S = 0.5
_TRIAL = 200_000
Figures = dict[str, float]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--rounds", type=int, help="(6)")
    parser.add_argument("--seconds", type=float, help="(20)")
    parser.add_argument("--loads", nargs="+", choices=LOADS, default=list(LOADS))
    parser.add_argument("--device", choices=DEVICES, default="simulated")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run the rounds and compare."""
    need("cyclictest")
    quick, loads = options.quick, options.loads
    rounds, seconds = options.rounds or (1 if quick else 6), options.seconds
    seconds = seconds or (4.0 if quick else 20.0)
    report.name += "" if options.device == "simulated" else f"_{options.device}"
    with tempfile.TemporaryDirectory() as folder, screen() as x, sound_server() as s:
        clip = moving_clip(Path(folder), seconds + 6)
        waves_file(Path(folder), seconds)
        environment = {**os.environ, **x, **s.environment, "XDG_CONFIG_HOME": folder}
        run = functools.partial(_Run, clip, seconds, environment)
        contenders = {
            (load, name): call
            for load in loads
            for name, call in (
                (OURS, functools.partial(run(load).ours, options.device, "fifo")),
                (REFERENCE, run(load).cyclictest),
                (
                    "loop, slice",
                    functools.partial(run(load).ours, options.device, "slice"),
                ),
            )
        }
        found = interleaved(contenders, rounds)
    for load in loads:
        compare(load, {n: f for (one, n), f in found.items() if one == load}, report)
    report.figures |= {"rounds": rounds, "seconds": seconds, "device": options.device}


def compare(load: str, found: dict[str, list[Figures]], report: Report) -> None:
    """Show medians over the rounds, and medians of the ratios within each."""
    rows, figures = [], {}
    for name, rounds in found.items():
        if not all(rounds):  # the machine does not grant this scheduling class
            continue
        middle = medians(rounds)
        ratios = {
            key: ratio([r[key] for r in rounds], [r[key] for r in found[REFERENCE]])
            for key in LIMITS
        }
        old = {k: sum(r.get(k, 0) for r in rounds) for k in ("withheld", "refused")}
        figures[name] = {
            **middle,
            **{f"{k}_ratio": v for k, v in ratios.items()},
            **old,
        }
        cells = [middle.get(k, "-") for k in ("p50", "p99", "p999", "max", "missed")]
        cells += [*(r.median for r in ratios.values()), *old.values()]
        rows.append([name, *cells, middle.get("age_p99", "-")])
        if name == OURS:
            for key, limit in LIMITS.items():
                what = f"{load}: {key} of cyclictest's"
                report.target(what, ratios[key].median, ("<=", limit))
            report.target(f"{load}: commands refused", old["refused"], ("<=", 0))
    header = [load, "p50 us", "p99 us", "p99.9 us", "max us", "missed/min", "p99 ratio"]
    header += ["p99.9 ratio", "withheld", "refused", "answer p99 us"]
    report.table("Lateness", header, rows)
    report.figures[load] = figures


class _Run:
    """What is played, under which load."""

    def __init__(
        self, clip: Path, seconds: float, environment: dict[str, str], load: str
    ) -> None:
        self._clip, self._seconds = clip, seconds
        self._environment, self._load = environment, load

    def _player(self, seen: Path, more_s: float, *arguments: str) -> list[str]:
        """Return the command of a player that is closed after some seconds."""
        lasts = str(self._seconds + STARTING_S + more_s)
        command = [sys.executable, "-m", "benchmarks.haptics.loop", self._load]
        return [*command, str(seen), lasts, "play", str(self._clip), *arguments]

    def ours(self, device: str, scheduling: str) -> Figures:
        """Play with a device; return lateness, us, and old commands."""
        with tempfile.TemporaryDirectory() as folder:
            log, seen = Path(folder) / "log.jsonl", Path(folder) / "seen.json"
            force = str(self._clip.parent / "force.csv")
            command = self._player(seen, 0.0, "--force", force, "--device", device)
            command += ["--scheduling", scheduling, "--log", str(log)]
            subprocess.run(
                command,
                env=self._environment,
                cwd=ROOT,
                check=True,
                capture_output=True,
            )
            with log.open() as lines:
                summary = json.loads(list(lines)[-1])
            granted = summary["scheduling"] == scheduling
            return json.loads(seen.read_text()) if granted else {}

    def cyclictest(self) -> Figures:
        """Play without a device beside cyclictest; return its lateness, us."""
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        with tempfile.TemporaryDirectory() as folder:
            seen, histogram = Path(folder) / "seen.json", Path(folder) / "histogram"
            command = self._player(seen, 2.0, "--device", "none")
            player = subprocess.Popen(command, env=self._environment, cwd=ROOT, **quiet)
            time.sleep(STARTING_S)
            test = ["cyclictest", "-m", "-p80", "-i1000", "-q", "-h", "60000"]
            test += ["-D", str(int(self._seconds)), f"--histfile={histogram}"]
            subprocess.run(test, check=True, capture_output=True)
            late_us, count = np.loadtxt(histogram, comments="#", dtype=int).T
            player.wait()
        share = np.cumsum(count) / count.sum()
        found = {
            name: float(late_us[np.searchsorted(share, q)])
            for name, q in (("p50", 0.5), ("p99", 0.99), ("p999", 0.999))
        }
        missed = float((late_us // 1000 * count).sum()) / (count.sum() / 60_000)
        return {**found, "max": float(late_us[count > 0].max()), "missed": missed}


# --- with a record of every tick --------------------------------------------------

MEASURES = ("p50", "p99", "p999")


def recorder_options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--rounds", type=int, help="(6)")
    parser.add_argument("--seconds", type=float, default=10.0)
    text = "where the record lies, to try another disk"
    parser.add_argument("--folder", type=Path, help=text)


def recorder(options: argparse.Namespace, report: Report) -> None:
    """Lateness of the haptic loop with and without a record of every tick.

    Each round plays the same 720p30 clip with sound in a window with its live plots twice,
    with `--record` and without. Beside the ratios stand those of rounds without a record to
    each other, which is what chance alone makes of them. The record is read back: ticks,
    lost ones, whether it is complete.
    """
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
    show_recorded(found, report)
    report.figures |= {"rounds": rounds, "seconds": seconds}


def show_recorded(found: dict[str, list[Figures]], report: Report) -> None:
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


# --- the player under a load -------------------------------------------------------


def _hold_interpreter() -> None:
    """Sort long lists for ever: one call of C that lets no other thread run."""
    time.sleep(STARTING_S)
    dice = random.Random(1)  # noqa: S311 - chance, not secrecy
    values = [dice.random() for _ in range(_TRIAL)]
    begun_s = time.monotonic()
    sorted(values)
    values *= max(1, round(HOLD_S / (time.monotonic() - begun_s)))
    dice.shuffle(values)
    while True:
        begun_s = time.monotonic()
        sorted(values)
        time.sleep(max(0.0, EVERY_S - (time.monotonic() - begun_s)))


def _make_garbage() -> None:
    """Make dicts and cycles for ever, for the collector of garbage to find."""
    time.sleep(STARTING_S)
    kept: dict[int, Any] = {}
    for number in range(sys.maxsize):
        entry: dict[str, Any] = {"number": number, "text": str(number)}
        entry["self"] = entry
        kept[number % 50_000] = entry
        if number % 2000 == 0:
            time.sleep(0.005)


def _play_under_load(load: str, seen: str, seconds: str, *arguments: str) -> int:
    """Play as `python -m app` does; write lateness and old commands."""
    begun_s = time.monotonic()
    from app.__main__ import main as play
    from hapticplayer.haptics.contract import Cause, Mode
    from hapticplayer.haptics.processes import HapticsProcesses
    from hapticplayer.playback import player as player_module
    from tests.material.plant_record import read_record

    withheld: list[int] = []
    ages_s: list[Any] = []
    lateness_s: list[Any] = []

    class Counted(HapticsProcesses):
        """Re-arms after each hold, so that there is a force to be late with."""

        _rearmed_s = 0.0

        def read_ticks(self) -> tuple[Any, int]:
            ticks, lost = super().read_ticks()
            ages_s.append(ticks["reply_age_s"][ticks["mode"] == Mode.FOLLOWING])
            is_old = (ticks["cause"] == Cause.COMMAND_STALE).astype(int)
            withheld.append(int(np.count_nonzero(np.diff(is_old, prepend=0) > 0)))
            after_s = ticks["monotonic_s"] - begun_s
            is_settled = (after_s > STARTING_S) & (after_s < float(seconds))
            lateness_s.append(ticks["lateness_s"][is_settled].copy())
            is_tripped = len(ticks) and ticks["mode"][-1] == Mode.TRIPPED
            if is_tripped and time.monotonic() > self._rearmed_s + REARM_S:
                self._rearmed_s = time.monotonic()
                self.rearm()
            return ticks, lost

    descriptor = os.memfd_create("device")
    player_module.HapticsProcesses = functools.partial(  # type: ignore[assignment,misc]
        Counted,
        device_options=["--record", str(descriptor)],
        device_descriptors=[descriptor],
    )
    for work in (_hold_interpreter, _make_garbage) if load == "stress" else ():
        threading.Thread(target=work, daemon=True).start()
    end = threading.Timer(float(seconds), os.kill, args=(os.getpid(), signal.SIGTERM))
    end.daemon = True
    end.start()
    status = play(list(arguments))
    has_device = os.fstat(descriptor).st_size > 0
    refused = int(read_record(descriptor)["refused"][-1]) if has_device else 0
    found = {"withheld": sum(withheld), "refused": refused, "age_p99": _p99_us(ages_s)}
    Path(seen).write_text(json.dumps({**found, **_percentiles_us(lateness_s)}))
    return status


def _p99_us(ages_s: list[Any]) -> float:
    """Return the 99th percentile of how old the answers were that were acted on."""
    joined = np.concatenate([*ages_s, np.empty(0)])
    return 1e6 * float(np.percentile(joined, 99)) if len(joined) else 0.0


def _percentiles_us(lateness_s: list[Any]) -> Figures:
    """Return how late the ticks were, and how many periods a minute were missed."""
    late_us = 1e6 * np.concatenate([*lateness_s, np.empty(0)])
    if not len(late_us):
        return {}
    p50, p99, p999 = np.percentile(late_us, (50.0, 99.0, 99.9)).tolist()
    missed = 60_000 * float((late_us // 1000).sum()) / len(late_us)
    figures = {"p50": p50, "p99": p99, "p999": p999}
    return {**figures, "max": float(late_us.max()), "missed": missed}


if __name__ == "__main__":
    sys.exit(_play_under_load(*sys.argv[1:]))
