"""What of a player can be told from outside: its first picture, its memory over time.

    python benchmarks/playback_watch.py play CLIP ...

plays a clip again and again until it is ended, for benchmarks/playback.py --memory.
"""

import mmap
import os
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from common import Usage

GREEN = "0x10E030"
POLL_S, PATIENCE_S = 0.001, 20.0
ASIDE_PX = 100  # in the very middle is the mouse pointer
BLOCKS = 20
WARM_S = 300.0
SAMPLE_S = 1.0
LOOP_END_S = 0.3  # before the end of the clip


def green_clip(folder: Path, size: str) -> Path:
    """Write a clip of one colour, with sound."""
    path = folder / f"green-{size}.mp4"
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-f", "lavfi", "-i"]
    command += [f"color=c={GREEN}:size={size}:rate=30", "-f", "lavfi", "-i"]
    command += ["sine=220:sample_rate=48000", "-t", "5", "-c:v", "libx264"]
    command += ["-pix_fmt", "yuv420p", "-ac", "2", str(path)]
    subprocess.run(command, check=True)
    return path


def first_picture_s(
    command: list[str], environment: dict[str, str], framebuffer: Path
) -> float:
    """Return the time from the start of a program to a green pixel, s."""
    is_green = _pixel(framebuffer)
    begin_s = time.monotonic()
    process = subprocess.Popen(
        command,
        env={**os.environ, **environment},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        while not is_green():
            if time.monotonic() > begin_s + PATIENCE_S:
                sys.exit(f"no picture from: {' '.join(command)}")
            time.sleep(POLL_S)
        return time.monotonic() - begin_s
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(PATIENCE_S)
        while is_green():  # the server paints its root again
            time.sleep(POLL_S)


def _pixel(framebuffer: Path) -> Any:
    """Return what tells whether a pixel near the middle of Xvfb's memory is green."""
    with framebuffer.open("rb") as file:
        memory = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
    # XWD header, big-endian: size, version, format, depth, width, height, ...
    header = struct.unpack(">25I", memory[:100])
    row, column = header[5] // 2 - ASIDE_PX, header[4] // 2 - ASIDE_PX
    at = header[0] + 12 * header[19] + row * header[12] + 4 * column

    def is_green() -> bool:
        blue, green, red = memory[at : at + 3]
        return green > 180 and red < 90 and blue < 110

    return is_green


class Slope(NamedTuple):
    """Growth of memory.

    Attributes:
        mb_per_hour: of the whole process tree, without files.
        sure_mb_per_hour: half the width of its 95 % confidence interval.
        mean_mb: over the time that was looked at.
    """

    mb_per_hour: float
    sure_mb_per_hour: float
    mean_mb: float

    def __str__(self) -> str:
        is_zero = abs(self.mb_per_hour) <= self.sure_mb_per_hour
        told = "not distinguishable from 0" if is_zero else "NOT 0"
        return (
            f"{self.mb_per_hour:+.2f} +- {self.sure_mb_per_hour:.2f} MB an hour "
            f"(95 %), {told}; mean {self.mean_mb:.0f} MB"
        )


def watch_memory(
    players: dict[str, tuple[list[str], dict[str, str]]], minutes: float
) -> dict[str, list[tuple[float, float]]]:
    """Run programs side by side for WARM_S and more, and return (s, MB) of each.

    Args:
        players: name to command and environment.
        minutes: that are looked at.
    """
    running = {
        name: subprocess.Popen(
            command,
            env={**os.environ, **environment},
            stdout=subprocess.DEVNULL,
            start_new_session=True,
        )
        for name, (command, environment) in players.items()
    }
    samples: dict[str, list[tuple[float, float]]] = {name: [] for name in players}
    begin_s = time.monotonic()
    try:
        while (elapsed_s := time.monotonic() - begin_s) < WARM_S + 60.0 * minutes:
            for name, process in running.items():
                if process.poll() is not None:
                    sys.exit(f"{name} ended after {elapsed_s:.0f} s")
                samples[name].append((elapsed_s, Usage(process.pid).written_mb()))
            time.sleep(SAMPLE_S)
    finally:
        for process in running.values():
            process.send_signal(signal.SIGTERM)
            process.wait(PATIENCE_S)
    return samples


def slope_of(samples: list[tuple[float, float]]) -> Slope:
    """Return the growth in samples of (s, MB), once caches and heap have filled.

    Memory goes up and down in steps, so that samples are not independent: the line is
    fitted to the means of 20 spans.
    """
    from scipy import stats

    whole = np.array(samples)
    kept = whole[whole[:, 0] >= WARM_S]
    hour, mb = np.array([part.mean(axis=0) for part in np.array_split(kept, BLOCKS)]).T
    line = stats.linregress(hour / 3600.0, mb)
    sure = float(stats.t.ppf(0.975, BLOCKS - 2) * line.stderr)
    return Slope(float(line.slope), sure, float(mb.mean()))


def _play_again_and_again(arguments: list[str]) -> int:
    """Run the player with its clip looped from its first picture to its last."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from app.__main__ import main
    from app.player import application
    from app.player.window import PlayerWindow

    begin = application._run_until_closed  # noqa: SLF001

    def looped(qt: QApplication, window: PlayerWindow, options: Any) -> int:
        def loop() -> None:
            window.player.set_loop((0.0, window.player.snapshot().end_s - LOOP_END_S))

        QTimer.singleShot(0, loop)
        return begin(qt, window, options)

    application._run_until_closed = looped  # noqa: SLF001
    return main(arguments)


if __name__ == "__main__":
    sys.exit(_play_again_and_again(sys.argv[1:]))
