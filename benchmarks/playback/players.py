"""CPU and memory of playing 30 s of a moving clip with sound, beside mpv and ffplay.

Same window size (the whole screen under Xvfb), same null sink; from start to exit. CPU
and memory (PSS) are those of the whole tree: player, sound, loop, guard and simulated
device, which are also told apart; again with the live plots on, in a window. `720p30`
has 20 Mbit/s of grain, where decoding is nearly all there is; the others scroll at usual
bit rates. `--memory 20` plays looped, us and mpv side by side, and fits a line to the
memory in so many minutes after the first five.
"""

import argparse
import functools
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report, interleaved, medians, ratio
from benchmarks.stage import (
    memory_mb,
    moving_clip,
    need,
    player_command,
    run_measured,
    screen,
    scrolling_clip,
    sound_server,
    tree,
    waves_file,
)

CLIPS = {
    "720p30": ("1280x720", 30),
    "720p30-scrolling": ("1280x720", 30),
    "1080p60": ("1920x1080", 60),
}
CPU_LIMITS = {"720p30": 1.3, "1080p60": 0.85}
MEMORY_LIMIT, PLOTS_LIMIT = 3.0, 1.8
PARTS = {
    "window": "-m app",
    "sound": "sound_device",
    "loop": "hapticplayer.haptics ",
    "guard": "haptics.guard",
    "device": "hapticplayer.simulation",
}
MPV = ["mpv", "--no-config", "--vo=x11", "--ao=pulse", "--fs", "--osc=no"]
MPV += ["--no-terminal"]
FFPLAY = ["ffplay", "-loglevel", "error", "-autoexit", "-fs"]
US, THEM = "hapticplayer", "mpv --vo=x11"
PATIENCE_S = 20.0
WARM_S, LOOPED_S, LOOP_END_S, SPANS = 300.0, 10.0, 0.3, 20


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--clip", nargs="+", default=["720p30"], choices=[*CLIPS])
    parser.add_argument("--rounds", type=int, help="(3)")
    parser.add_argument("--seconds", type=float, help="(30)")
    parser.add_argument("--memory", type=float, metavar="MINUTES")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run the rounds with each clip."""
    need("Xvfb", "mpv", "ffmpeg", "pulseaudio", "pactl")
    if options.memory is not None:
        report.name = "memory"
        watch_memory(options.memory, report)
        return
    rounds = options.rounds or (1 if options.quick else 3)
    seconds = options.seconds or (6.0 if options.quick else 30.0)
    report.figures |= {"rounds": rounds, "seconds": seconds}
    for name in options.clip:
        show(name, measure(name, rounds, seconds, quick=options.quick), report)


def measure(
    name: str, rounds: int, seconds: float, *, quick: bool
) -> dict[str, list[dict[str, float]]]:
    """Play one clip; return the rounds by player."""
    size, rate_hz = CLIPS[name]
    width, height = map(int, size.split("x"))
    with (
        tempfile.TemporaryDirectory() as kept,
        screen(size=(width, height)) as x,
        sound_server() as s,
    ):
        folder = Path(kept)
        clip = (
            moving_clip(folder, seconds)
            if name == "720p30"
            else scrolling_clip(folder, seconds, size, rate_hz)
        )
        force = waves_file(folder, seconds)
        environment = {**x, **s.environment, **as_installed(kept)}
        _compile(environment, folder)
        play = functools.partial(_ours, clip, force, environment)
        contenders = {
            US: functools.partial(play, plots=False),
            THEM: functools.partial(_other, [*MPV, str(clip)], environment),
        }
        if not quick:
            ffplay = functools.partial(_other, [*FFPLAY, str(clip)], environment)
            contenders["ffplay"] = ffplay
            contenders["with plots"] = functools.partial(play, plots=True)
        return interleaved(contenders, rounds)


def as_installed(folder: str) -> dict[str, str]:
    """Return the environment in which modules are compiled once, as by an installer."""
    compiled = {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": folder}
    return {"XDG_CONFIG_HOME": folder, **compiled}


def _ours(
    clip: Path, force: Path, environment: dict[str, str], *, plots: bool
) -> dict[str, float]:
    """Play once and return CPU seconds, memory and frames."""
    command = player_command("play", str(clip), "--force", str(force))
    command += ["--device", "simulated", "--close-at-end", "--json"]
    command += [] if plots else ["--fullscreen", "--no-plots"]
    usage, total_s, printed = run_measured(command, environment, 120.0)
    summary = json.loads(printed)
    seconds = {name: usage.seconds_of(part) for name, part in PARTS.items()}
    # what one used between its last sample and its end counts as the window's
    seconds["window"] = total_s - sum(seconds.values()) + seconds["window"]
    played_s = summary["ticks"] / 1000.0
    return {
        "total_s": total_s,
        **{f"{name}_percent": 100.0 * s / played_s for name, s in seconds.items()},
        "peak_mb": usage.peak_mb,
        **{f"{name}_mb": usage.memory_of(part) for name, part in PARTS.items()},
        "dropped": summary["frames"]["dropped"],
    }


def _other(command: list[str], environment: dict[str, str]) -> dict[str, float]:
    usage, total_s, _ = run_measured(command, environment, 120.0)
    return {"total_s": total_s, "peak_mb": usage.peak_mb}


def _compile(environment: dict[str, str], folder: Path) -> None:
    """Open and close the window once, which compiles what nothing has compiled yet."""
    clip = scrolling_clip(folder, 1.0, "640x360", 30)
    command = player_command("play", str(clip), "--close-at-end", "--fullscreen")
    run_measured([*command, "--device", "simulated"], environment, 60.0)


def start(
    command: list[str], environment: dict[str, str], errors: Any = subprocess.DEVNULL
) -> "subprocess.Popen[bytes]":
    """Start a player that says nothing, `errors` to a file."""
    return subprocess.Popen(
        command,
        env={**os.environ, **environment},
        cwd=ROOT,
        stdout=subprocess.DEVNULL,
        stderr=errors,
        start_new_session=True,
    )


def show(
    name: str,
    found: dict[str, list[dict[str, float]]],
    report: Report,
) -> None:
    """Show medians and ratios to mpv."""
    keys = ("total_s", *(f"{part}_percent" for part in PARTS), "peak_mb", "dropped")
    figures: dict[str, Any] = {}
    rows = []
    for player, rounds in found.items():
        middle = medians(rounds)
        cpu, memory = (
            ratio([r[key] for r in rounds], [r[key] for r in found[THEM]])
            for key in ("total_s", "peak_mb")
        )
        figures[player] = {**middle, "cpu_ratio": cpu, "memory_ratio": memory}
        cells = [middle.get(key, "-") for key in keys]
        rows.append([player, *cells, cpu.median, memory.median])
    header = ["", "tree CPU s", *(f"{part} %" for part in PARTS)]
    header += ["PSS MB", "dropped", "CPU / mpv", "memory / mpv"]
    report.table(name, header, rows)
    parts = (f"{part} {figures[US][f'{part}_mb']:.0f}" for part in PARTS)
    print(f"PSS by process, MB: {', '.join(parts)}")
    if name in CPU_LIMITS:
        cpu = figures[US]["cpu_ratio"].median
        report.target(f"{name}: CPU, of mpv", cpu, ("<=", CPU_LIMITS[name]))
    memory = figures[US]["memory_ratio"].median
    report.target(f"{name}: memory, of mpv", memory, ("<=", MEMORY_LIMIT))
    report.target(f"{name}: frames dropped", figures[US]["dropped"], ("<=", 0))
    if name == "720p30" and "with plots" in figures:
        cpu = figures["with plots"]["cpu_ratio"].median
        report.target(f"{name}: CPU with plots, of mpv", cpu, ("<=", PLOTS_LIMIT))
    report.figures[name] = figures


# --- memory over time --------------------------------------------------------------


def watch_memory(minutes: float, report: Report) -> None:
    """Play looped, each on a screen of its own, and show how the memory grows."""
    with (
        tempfile.TemporaryDirectory() as kept,
        screen() as first,
        screen() as second,
        sound_server() as s,
    ):
        folder = Path(kept)
        clip = scrolling_clip(folder, LOOPED_S, "1280x720", 30)
        force = waves_file(folder, LOOPED_S)
        environment = {**s.environment, **as_installed(kept)}
        looped = [sys.executable, "-m", "benchmarks.playback.players"]
        running = {
            US: start([*looped, str(clip), str(force)], {**environment, **first}),
            THEM: start(
                [*MPV, "--loop-file=inf", str(clip)], {**environment, **second}
            ),
        }
        samples: dict[str, list[tuple[float, float]]] = {name: [] for name in running}
        begin_s = time.monotonic()
        try:
            while (after_s := time.monotonic() - begin_s) < WARM_S + 60.0 * minutes:
                for name, process in running.items():
                    if process.poll() is not None:
                        sys.exit(f"{name} ended after {after_s:.0f} s")
                    # what is no file: only that can grow
                    kinds = ("Pss_Anon:", "Pss_Shmem:")
                    mb = sum(memory_mb(pid, *kinds) for pid in tree(process.pid))
                    samples[name].append((after_s, mb))
                time.sleep(1.0)
        finally:
            for process in running.values():
                process.send_signal(signal.SIGTERM)
                process.wait(PATIENCE_S)
    rows = [[name, *slope_of(each)] for name, each in samples.items()]
    header = ["", "MB an hour", "+- (95 %)", "mean MB"]
    report.table(f"Memory that is no file, {minutes:g} minutes", header, rows)
    report.figures |= {"minutes": minutes, "columns": header, "rows": rows}


def slope_of(samples: list[tuple[float, float]]) -> tuple[float, float, float]:
    """Return growth, MB an hour, half its 95 % interval, and the mean, MB.

    Memory goes up and down in steps, so that samples are not independent: the line is
    fitted to the means of 20 spans.
    """
    from scipy import stats

    whole = np.array(samples)
    kept = whole[whole[:, 0] >= WARM_S]
    s, mb = np.array([part.mean(axis=0) for part in np.array_split(kept, SPANS)]).T
    line = stats.linregress(s / 3600.0, mb)
    sure = float(stats.t.ppf(0.975, SPANS - 2) * line.stderr)
    return float(line.slope), sure, float(mb.mean())


def _play_looped(clip: str, force: str) -> None:
    from benchmarks.window import open_window
    from hapticplayer.playback.source import open_source

    opened = open_window(Path(clip).parent / "settings.json", sound=True)
    opened.window.session.show_source(open_source(clip, force))
    end_s = opened.player.snapshot().end_s - LOOP_END_S
    opened.player.set_loop((0.0, end_s))
    opened.player.play()
    opened.application.exec()


if __name__ == "__main__":
    _play_looped(*sys.argv[1:])
