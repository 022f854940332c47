"""From `./run` to the first moving frame of the demo, beside mpv on the same file.

Everything is set up already and compiled. A frame is what a part of the screen, read from
the X server's memory, holds for some milliseconds with many colours: one that is half
drawn is none. Ours is the time of the second frame, that of mpv its first, in the same
rounds; its second waits for its sound, for 0.1 to 2.3 s. Also `--help`, and what is
imported until the first frame (`-X importtime`): by package, the five largest.
"""

import argparse
import functools
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report, interleaved, ratio
from benchmarks.playback.players import MPV, PATIENCE_S, THEM, US, as_installed, start
from benchmarks.stage import need, rows_reader, screen, sound_server
from hapticplayer.shipped import DEMO

POLL_S, HELD_S = 0.001, 0.005
MANY_COLOURS = 200
FIRST_FRAME_LIMIT, HELP_LIMIT_S = 2.5, 0.15
OURS = [str(ROOT / "run")]
_LINE = re.compile(r"import time: +(\d+) \| +\d+ \| +(\S+)")
LARGEST = 5


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(9)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Start each in turn."""
    need("Xvfb", "mpv", "pulseaudio", "pactl")
    rounds = options.rounds or (2 if options.quick else 9)
    with tempfile.TemporaryDirectory() as kept, sound_server() as s:
        folder = Path(kept)
        with screen(folder) as x:
            environment = {**x, **s.environment, **as_installed(kept)}
            wait = functools.partial(_shown_s, environment=environment, folder=folder)
            contenders = {
                US: lambda: wait(OURS),
                THEM: lambda: wait([*MPV, str(DEMO)], frames=1),
            }
            # the first start compiles
            found = interleaved(contenders, rounds, warm_up=True)
            helps = [_help_s(environment) for _ in range(rounds)]
            imports = folder / "imports"
            timed = [sys.executable, "-X", "importtime", "-m", "app"]
            with imports.open("wb") as file:
                _shown_s(timed, environment=environment, folder=folder, errors=file)
            largest, modules = imported(imports.read_text(errors="replace"))
    beside = ratio(found[US], found[THEM])
    rows = [[name, float(np.median(each)), *np.sort(each)[[0, -1]].tolist()]
            for name, each in found.items()]  # fmt: skip
    report.table("Start to our second frame and the first of mpv, s", ["", "median", "least", "most"], rows)  # fmt: skip
    report.table("Imports until then, ms", ["", "ms"], largest)
    report.target(
        "first moving frame, of mpv", beside.median, ("<=", FIRST_FRAME_LIMIT)
    )
    report.target("--help, s", float(np.median(helps)), ("<=", HELP_LIMIT_S))
    report.figures |= {"rounds": rounds, "first_frame_s": found, "ratio": beside}
    report.figures |= {"help_s": helps, "modules": modules, "largest_ms": dict(largest)}


def _shown_s(
    command: list[str],
    *,
    environment: dict[str, str],
    folder: Path,
    errors: Any = subprocess.DEVNULL,
    frames: int = 2,
) -> float:
    """The time until the screen has shown so many frames, s."""
    read = rows_reader(folder / "Xvfb_screen0")
    begin_s = time.monotonic()
    process = start(command, environment, errors)
    try:
        seen = b""
        for _ in range(frames):
            seen = _wait_for(read, command, begin_s, seen)
        return time.monotonic() - begin_s - HELD_S
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(PATIENCE_S)
        while _colours(read()) > 1:  # the server paints its root again
            time.sleep(POLL_S)


def _wait_for(
    read: Callable[[], bytes], command: list[str], begin_s: float, before: bytes
) -> bytes:
    seen, since_s = read(), time.monotonic()
    while (
        seen == before
        or _colours(seen) < MANY_COLOURS
        or time.monotonic() < since_s + HELD_S
    ):
        if time.monotonic() > begin_s + PATIENCE_S:
            sys.exit(f"no moving frame from: {' '.join(command)}")
        time.sleep(POLL_S)
        if (now := read()) != seen:
            seen, since_s = now, time.monotonic()
    return seen


def _colours(pixels: bytes) -> int:
    return len(np.unique(np.frombuffer(pixels, "<u4")))


def _help_s(environment: dict[str, str]) -> float:
    begin_s = time.monotonic()
    process = start([*OURS, "--help"], environment)
    process.wait(PATIENCE_S)
    return time.monotonic() - begin_s


def imported(told: str) -> tuple[list[tuple[str, float]], int]:
    """The packages that took the longest to import, ms, and how many modules there were.

    Ours by room; of what Python brings, all together.
    """
    us: Counter[str] = Counter()
    lines = _LINE.findall(told)
    for own_us, module in lines:
        first, _, rest = module.partition(".")
        name = first
        if first in sys.stdlib_module_names:
            name = "standard library"
        elif first in {"app", "hapticplayer"}:
            name = f"{first}.{rest.partition('.')[0]}".rstrip(".")
        us[name] += int(own_us)
    return [(name, each / 1e3) for name, each in us.most_common(LARGEST)], len(lines)
