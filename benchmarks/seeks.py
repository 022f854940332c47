"""From a seek to its picture: how long, and whether it is the right one.

    python benchmarks/seeks.py [--seeks 50] [--seed 1]

A 720p30 clip with a key frame every 2 s, paused; the time from `Player.seek` to the
frame that is handed to the screen, and the CPU that this takes. Bars: median at most
60 ms, and each frame the one that covers the position.
"""

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from common import need, save, scrolling_clip

SECONDS, RATE_HZ = 30.0, 30
MOST_MEDIAN_MS, PATIENCE_S = 60.0, 5.0
TOLERANCE_S = 1e-4


class Seen:
    """Keeps the newest picture (FrameSink)."""

    def __init__(self) -> None:
        self.pts_s = -1.0
        self.count = 0

    def show(self, frame: object) -> None:
        """Note it."""
        self.pts_s, self.count = frame.pts_s, self.count + 1  # type: ignore[attr-defined]


def main() -> int:
    """Seek, and say whether the bars hold."""
    from hapticplayer.clock import SystemClock
    from hapticplayer.playback.player import Player
    from hapticplayer.playback.source import open_source

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeks", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    need("ffmpeg")
    clock, seen = SystemClock(), Seen()
    player = Player(clock, seen, audio=None)

    def wait(count: int) -> None:
        until_s = clock.now_s() + PATIENCE_S
        while seen.count == count and clock.now_s() < until_s:
            player.poll()
            clock.sleep_until(clock.now_s() + 0.0005)

    took_ms, cpu_ms, exact = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        clip = scrolling_clip(Path(folder), SECONDS, "1280x720", RATE_HZ)
        player.open(open_source(clip))
        wait(0)
        rng = np.random.default_rng(options.seed)
        for target_s in rng.uniform(0.0, SECONDS - 0.1, options.seeks):
            count, begin_s, cpu_s = seen.count, clock.now_s(), time.process_time()
            player.seek(float(target_s))
            wait(count)
            took_ms.append(1e3 * (clock.now_s() - begin_s))
            cpu_ms.append(1e3 * (time.process_time() - cpu_s))
            late_s = target_s - seen.pts_s
            exact += int(-TOLERANCE_S <= late_s < 1.0 / RATE_HZ + TOLERANCE_S)
        player.close()
    median, p95 = np.percentile(took_ms, [50.0, 95.0]).tolist()
    print(f"{exact} of {options.seeks} exact, median {median:.1f} ms, p95 {p95:.1f} ms")
    cpu = float(np.median(cpu_ms))
    print(f"CPU: median {cpu:.1f} ms; load {os.getloadavg()[0]:.1f}")
    figures = {"exact": exact, "median_ms": median, "p95_ms": p95, "cpu_ms": cpu}
    figures["took_ms"] = took_ms
    print(f"saved {save('seeks', figures).name}")
    return 0 if exact == options.seeks and median <= MOST_MEDIAN_MS else 1


if __name__ == "__main__":
    sys.exit(main())
