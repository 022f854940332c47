"""What live plots cost, and how long a seek takes to its frame."""

import argparse
import functools
import os
import tempfile
import time
from pathlib import Path
from typing import Any

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


import numpy as np

from app.player.window import PlayerWindow
from benchmarks.common import Report, interleaved, medians
from benchmarks.stage import moving_clip, scrolling_clip
from benchmarks.window import open_window, run_for
from hapticplayer.capture.recording import Recording
from hapticplayer.clock import SystemClock
from hapticplayer.media.clip_info import probe
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from hapticplayer.sequence.build import Choices, write_sequence

SAMPLES_HZ = 1000
SETTLE_S = 1.0
WAYS = {"plots and grip": (True, True), "plots": (True, False), "hidden": (False, True)}
LIMIT_PERCENT = 15.0


def shaken_sequence(folder: Path, seconds: float) -> Path:
    """Write a clip that is shaken in three directions, sampled at 1 kHz."""
    clip = moving_clip(folder, seconds)
    time_s = np.arange(0.0, seconds, 1.0 / SAMPLES_HZ)
    shake = [np.sin(2 * np.pi * f * time_s) for f in (2.3, 3.1, 7.7)]
    force = 2.0 * np.stack(shake, axis=1)
    force[:, 2] += STANDARD_GRAVITY_MPS2
    log = ImuLog(time_s, force, np.zeros_like(force), source="shake")
    made, choices = Recording(log, ClockMap(), "made"), Choices(title="shake", seed=1)
    return write_sequence(probe(clip), made, folder / "sequence", choices=choices)


def plots_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(3)")
    parser.add_argument("--seconds", type=float, help="(6)")


def plots(options: argparse.Namespace, report: Report) -> None:
    """What the live plots cost, as a share of one core.

    One window plays a clip whose motion and force have 1000 samples a second, with the
    simulated device; its CPU time is taken with the plots, without the grip beside them, and
    with the plots hidden, alternating: the difference is what they cost.
    """
    rounds = options.rounds or (1 if options.quick else 3)
    seconds = options.seconds or (2.0 if options.quick else 6.0)
    opened = open_window(None)
    window, player = opened.window, opened.player
    with tempfile.TemporaryDirectory(prefix="hp-plots-") as name:
        length_s = len(WAYS) * (seconds + SETTLE_S) * rounds + 2.0
        sequence = shaken_sequence(Path(name), min(length_s, 24.0))
        window.session.show_source(open_source(sequence))
        contenders = {
            way: functools.partial(_measured, window, way, seconds) for way in WAYS
        }
        found = interleaved(contenders, rounds)
        window.close()
    opened.application.processEvents()
    middle = {way: medians(each) for way, each in found.items()}
    header = ["", "% of a core", "plots drawn, Hz", "frames, Hz"]
    report.table("Plots", header, [[w, *m.values()] for w, m in middle.items()])
    rest = middle["hidden"]["percent"]
    cost = {way: middle[way]["percent"] - rest for way in list(WAYS)[:2]}
    what = "plots and grip, % of a core"
    report.target(what, cost["plots and grip"], ("<=", LIMIT_PERCENT))
    player.close()
    report.figures |= {"medians": middle, "cost_percent": cost}


def _measured(window: PlayerWindow, way: str, seconds: float) -> dict[str, float]:
    """Play for a while, and return what it took."""
    plots, grip = WAYS[way]
    window.player.seek(0.0)
    window.player.play()
    window.plots.prepare()
    window.show_plots(are_wanted=plots)
    window.plots.show_grip(is_wanted=grip)
    run_for(SETTLE_S)
    panel = window.plots.panel
    assert panel is not None
    drawn, draw = [0], panel.force.drawForeground

    def counted(*arguments: Any) -> None:
        drawn[0] += 1
        draw(*arguments)

    panel.force.drawForeground = counted
    shown = window.player.snapshot().frames_shown
    cpu_s, wall_s = time.process_time(), time.monotonic()
    run_for(seconds)
    cpu_s, wall_s = time.process_time() - cpu_s, time.monotonic() - wall_s
    shown = window.player.snapshot().frames_shown - shown
    panel.force.drawForeground = draw
    drawn_hz = drawn[0] / wall_s
    percent = 100.0 * cpu_s / wall_s
    return {"percent": percent, "drawn_hz": drawn_hz, "frames_hz": shown / wall_s}


# --- seeks ------------------------------------------------------------------------

SECONDS, RATE_HZ = 30.0, 30
MOST_MEDIAN_MS, PATIENCE_S = 60.0, 5.0
TOLERANCE_S = 1e-4


class Newest:
    """Keeps the time of the newest frame (FrameSink)."""

    def __init__(self) -> None:
        self.pts_s = -1.0
        self.count = 0

    def show(self, frame: object) -> None:
        """Note it."""
        self.pts_s, self.count = frame.pts_s, self.count + 1  # type: ignore[attr-defined]


class PausedPlayer:
    """A player without a window that seeks, and waits for the frame."""

    def __init__(self, source: Source, audio: object = None) -> None:
        self.clock, self.seen = SystemClock(), Newest()
        self.player = Player(self.clock, self.seen, audio=audio)
        self.player.open(source)
        self._wait(0)

    def seek(self, to_s: float) -> None:
        """Seek, and wait until a frame has come."""
        count = self.seen.count
        self.player.seek(to_s)
        self._wait(count)

    def _wait(self, count: int) -> None:
        until_s = self.clock.now_s() + PATIENCE_S
        while self.seen.count == count and self.clock.now_s() < until_s:
            self.player.poll()
            self.clock.sleep_until(self.clock.now_s() + 0.0005)


def seeks_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seeks", type=int, help="(50)")
    parser.add_argument("--seed", type=int, default=1)


def seeks(options: argparse.Namespace, report: Report) -> None:
    """From a seek to its frame: how long, and whether it is the right one.

    A 720p30 clip with a key frame every 2 s, paused; the time from `Player.seek` to the
    frame that is handed to the screen, and the CPU time that this takes.
    """
    count = options.seeks or (10 if options.quick else 50)
    took_ms, cpu_ms, exact = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        clip = scrolling_clip(Path(folder), SECONDS, "1280x720", RATE_HZ)
        paused = PausedPlayer(open_source(clip))
        rng = np.random.default_rng(options.seed)
        for target_s in rng.uniform(0.0, SECONDS - 0.1, count):
            begin_s, cpu_s = time.monotonic(), time.process_time()
            paused.seek(float(target_s))
            took_ms.append(1e3 * (time.monotonic() - begin_s))
            cpu_ms.append(1e3 * (time.process_time() - cpu_s))
            late_s = target_s - paused.seen.pts_s
            exact += int(-TOLERANCE_S <= late_s < 1.0 / RATE_HZ + TOLERANCE_S)
        paused.player.close()
    p50, p95 = np.percentile(took_ms, [50.0, 95.0]).tolist()
    cpu = float(np.median(cpu_ms))
    report.table("Seeks", ["n", "exact", "p50 ms", "p95 ms", "CPU ms"],
                 [[count, exact, p50, p95, cpu]])  # fmt: skip
    report.target("seeks to the wrong frame", count - exact, ("<=", 0))
    report.target("seek to frame, median ms", p50, ("<=", MOST_MEDIAN_MS))
    report.figures |= {"exact": exact, "p50_ms": p50, "p95_ms": p95, "cpu_ms": cpu}
