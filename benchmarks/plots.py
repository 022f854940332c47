"""What the live plots cost, as a share of one core, and how often they are drawn.

    python benchmarks/plots.py [--rounds 3] [--seconds 6]

One window plays a clip whose motion and force have 1000 samples a second, with the
simulated device; its CPU time is taken with the plots, without the grip beside them, and
with the plots hidden, in turns. The difference is what they cost.
"""

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

os.environ["QT_QPA_PLATFORM"] = os.environ.get("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from common import moving_clip, save, table
from PySide6.QtCore import QEventLoop, QTimer

from app.bridge.settings import Settings
from app.player.application import make_application
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer.capture.recording import Recording
from hapticplayer.clock import SystemClock
from hapticplayer.media.clip_info import probe
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.build import Choices, write_sequence

RATE_HZ = 1000
SETTLE_S = 1.0
WAYS = {"plots and grip": (True, True), "plots": (True, False), "hidden": (False, True)}


def sequence(folder: Path, seconds: float) -> Path:
    """Write a clip that is shaken in three directions, sampled at 1 kHz."""
    clip = moving_clip(folder, seconds)
    time_s = np.arange(0.0, seconds, 1.0 / RATE_HZ)
    shake = [np.sin(2 * np.pi * f * time_s) for f in (2.3, 3.1, 7.7)]
    force = 2.0 * np.stack(shake, axis=1)
    force[:, 2] += STANDARD_GRAVITY_MPS2
    log = ImuLog(time_s, force, np.zeros_like(force), source="shake")
    made = Recording(log, ClockMap(), "made for this")
    choices = Choices(title="shake", seed=1)
    return write_sequence(probe(clip), made, folder / "sequence", choices=choices)


def main() -> int:
    """Take the rounds, and print shares of a core."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=6.0)
    options = parser.parse_args()
    application, clock, surface = make_application(), SystemClock(), VideoSurface()
    player = Player(clock, SurfaceSink(surface), device="simulated", audio=None)
    window = PlayerWindow(player, surface, clock, Settings(None))
    window.show()
    rows: list[dict[str, Any]] = []
    with tempfile.TemporaryDirectory(prefix="hp-plots-") as name:
        source = open_source(sequence(Path(name), 3.0 * (options.seconds + 2.0)))
        samples = source.motion.time_s if source.motion else np.zeros(1)
        window.session.show_source(source)
        for _ in range(options.rounds):
            player.seek(0.0)
            player.play()
            rows += [measured(window, way, options.seconds) for way in WAYS]
        window.close()
    application.processEvents()
    return report(rows, float(1.0 / np.median(np.diff(samples))))


def measured(window: PlayerWindow, way: str, seconds: float) -> dict[str, Any]:
    """Play for a while, and return what it took."""
    plots, grip = WAYS[way]
    window.show_plots(are_wanted=plots)
    window.plots.show_grip(is_wanted=grip)
    _run(SETTLE_S)
    panel = window.plots.panel
    assert panel is not None
    drawn, draw = [0], panel.force.drawForeground

    def counted(*arguments: Any) -> None:
        drawn[0] += 1
        draw(*arguments)

    panel.force.drawForeground = counted
    shown = window.player.snapshot().frames_shown
    cpu_s, wall_s = time.process_time(), time.monotonic()
    _run(seconds)
    cpu_s, wall_s = time.process_time() - cpu_s, time.monotonic() - wall_s
    shown = window.player.snapshot().frames_shown - shown
    panel.force.drawForeground = draw
    return {
        "way": way,
        "percent": 100.0 * cpu_s / wall_s,
        "drawn_hz": drawn[0] / wall_s,
        "pictures_hz": shown / wall_s,
    }


def _run(seconds: float) -> None:
    loop = QEventLoop()
    QTimer.singleShot(round(1e3 * seconds), loop.quit)
    loop.exec()


def report(rows: list[dict[str, Any]], rate_hz: float) -> int:
    """Print and save the medians."""
    keys = ("percent", "drawn_hz", "pictures_hz")
    medians = {
        way: {
            k: float(np.median([r[k] for r in rows if r["way"] == way])) for k in keys
        }
        for way in WAYS
    }
    print(f"motion at {rate_hz:.0f} Hz, ticks at 1000 Hz")
    header = ["", "% of a core", "plots drawn, Hz", "pictures, Hz"]
    print(table(header, [[w, *(m[k] for k in keys)] for w, m in medians.items()]))
    rest = medians["hidden"]["percent"]
    cost = {way: medians[way]["percent"] - rest for way in list(WAYS)[:2]}
    for way, percent in cost.items():
        print(f"{way}: {percent:.1f} % of a core")
    print(f"saved {save('plots', {'medians': medians, 'cost_percent': cost}).name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
