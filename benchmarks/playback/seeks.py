"""From a seek to its frame: how long, and whether it is the right one.

A 720p30 clip with a key frame every 2 s, paused; the time from `Player.seek` to the
frame that is handed to the screen, and the CPU time that this takes.
"""

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

from benchmarks.common import Report
from benchmarks.stage import scrolling_clip
from hapticplayer.clock import SystemClock
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source

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


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--seeks", type=int, help="(50)")
    parser.add_argument("--seed", type=int, default=1)


def run(options: argparse.Namespace, report: Report) -> None:
    """Seek at random."""
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
