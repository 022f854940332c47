"""The window open with the demo paused, and hidden: which share of a core all take.

The real window with its plots, sound, the loop, its guard and the simulated device,
from when they have come to rest: nothing has played, and nobody was there, for 30 s.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.common import ROOT, Report
from benchmarks.playback.players import PARTS, PATIENCE_S, as_installed
from benchmarks.stage import Usage, need, screen, sound_server

AT_REST_S = 50.0
PARTS_HERE = {**PARTS, "window": "benchmarks.playback.idle"}
LIMITS = {"open": 3.0, "hidden": 1.0}


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seconds", type=float, help="(20) in each of both states")


def run(options: argparse.Namespace, report: Report) -> None:
    """Open the window, wait, measure; hide it, and measure again."""
    need("Xvfb", "pulseaudio", "pactl")
    seconds = options.seconds or (5.0 if options.quick else 20.0)
    with tempfile.TemporaryDirectory() as kept, screen() as x, sound_server() as s:
        environment = {**os.environ, **x, **s.environment, **as_installed(kept)}
        hide_after_s = AT_REST_S + seconds + 2.0
        command = [sys.executable, "-m", "benchmarks.playback.idle"]
        command += [str(Path(kept) / "settings.json"), str(hide_after_s)]
        begin_s = time.monotonic()
        window = subprocess.Popen(command, env=environment, cwd=ROOT)
        try:
            found = {"open": _shares(window.pid, begin_s + AT_REST_S, seconds)}
            hidden_s = begin_s + hide_after_s + 3.0
            found["hidden"] = _shares(window.pid, hidden_s, seconds)
        finally:
            window.terminate()
            window.wait(PATIENCE_S)
    rows = [[state, *one.values()] for state, one in found.items()]
    header = ["% of a core", *found["open"]]
    report.table("Nothing plays", header, rows)
    for state, one in found.items():
        what = f"{state}: all processes, % of a core"
        report.target(what, one["all"], ("<=", LIMITS[state]))
    report.figures |= {"seconds": seconds, "percent": found}


def _shares(pid: int, from_s: float, seconds: float) -> dict[str, float]:
    """The share of a core of each process from a time on, %."""
    time.sleep(max(0.0, from_s - time.monotonic()))
    before, after = Usage(pid), Usage(pid)
    before.sample_cpu()
    begin_s = time.monotonic()
    time.sleep(seconds)
    after.sample_cpu()
    per_s = 100.0 / (time.monotonic() - begin_s)
    shares = {
        name: per_s * (after.seconds_of(part) - before.seconds_of(part))
        for name, part in PARTS_HERE.items()
    }
    return {"all": sum(shares.values()), **shares}


def _stay_open(settings: str, hide_after_s: str) -> None:
    from PySide6.QtCore import QTimer

    from benchmarks.window import open_window
    from hapticplayer.playback.source import open_source
    from hapticplayer.shipped import DEMO

    opened = open_window(Path(settings), sound=True)
    opened.window.session.show_source(open_source(DEMO))
    QTimer.singleShot(round(1e3 * float(hide_after_s)), opened.window.showMinimized)
    opened.application.exec()


if __name__ == "__main__":
    _stay_open(*sys.argv[1:])
