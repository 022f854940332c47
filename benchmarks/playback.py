"""CPU of playing 30 s of a moving clip with sound, beside mpv --vo=x11 and ffplay.

    python benchmarks/playback.py [--clip 720p30 ...] [--rounds 3] [--seconds 30]

Same window size (the whole screen under Xvfb), same null sink; from start to exit. The
loop, its guard and the simulated device are measured apart; once more with the live
plots on, in a window. Dropped pictures are our own count. `720p30` has 20 Mbit/s of
grain, where decoding is nearly all there is; the others scroll at usual bit rates.
From start to the first picture: until a pixel of the X server's memory has its colour.

    python benchmarks/playback.py --memory 20

plays looped, us and mpv side by side, and tells how the memory grows in so many minutes
after the first five.
"""

import argparse
import json
import os
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from common import (
    as_installed,
    moving_clip,
    need,
    player_command,
    run_measured,
    save,
    screen,
    scrolling_clip,
    sound_server,
    table,
)
from playback_watch import first_picture_s, green_clip, slope_of, watch_memory

CLIPS = {
    "720p30": ("1280x720", 30),
    "720p30-scrolling": ("1280x720", 30),
    "1080p60": ("1920x1080", 60),
}
DEVICE = "hapticplayer.devices"
PARTS = {
    "window": "-m app",
    "sound": "sound_device",
    "loop": "hapticplayer.haptics ",
    "guard": "haptics.guard",
    "device": DEVICE,
}
STARTS = 5
LOOPED_S = 10.0
MPV = ["mpv", "--no-config", "--vo=x11", "--ao=pulse", "--fs", "--osc=no"]
MPV += ["--no-terminal"]
FFPLAY = ["ffplay", "-loglevel", "error", "-autoexit", "-fs"]


def force_file(folder: Path, seconds: float) -> Path:
    """Write a force track that is never zero."""
    path = folder / "force.csv"
    rows = [
        f"{t:.3f},{1.5 + np.sin(9 * t):.4f},{np.sin(5 * t):.4f},0"
        for t in np.arange(0, seconds, 0.005)
    ]
    path.write_text("time_s,fx_n,fy_n,fz_n\n" + "\n".join(rows) + "\n")
    return path


def ours(
    clip: Path, force: Path, environment: dict[str, str], *, plots: bool
) -> dict[str, float]:
    """Play once and return CPU seconds, memory and frames."""
    command = player_command("play", str(clip), "--force", str(force))
    command += ["--close-at-end", "--json"]
    command += [] if plots else ["--fullscreen", "--no-plots"]
    usage, total_s, printed = run_measured(command, environment, 120.0)
    summary = json.loads(printed)
    played_s = summary["ticks"] / 1000.0
    haptics_s, device_s = usage.of("hapticplayer.haptics"), usage.of(DEVICE)
    return {
        "total_s": total_s,
        "player_s": total_s - haptics_s - device_s,
        "sound_s": usage.of("hapticplayer.playback.sound_device"),
        "haptics_percent": 100.0 * haptics_s / played_s,
        "device_percent": 100.0 * device_s / played_s,
        "peak_mb": usage.peak_mb,
        **{f"{name}_mb": usage.memory_of(part) for name, part in PARTS.items()},
        "shown": summary["frames"]["shown"],
        "dropped": summary["frames"]["dropped"],
        "clock_is_audio": float(summary["clock"] == "audio"),
    }


def other(command: list[str], environment: dict[str, str]) -> dict[str, float]:
    """Play once with another player."""
    usage, total_s, _printed = run_measured(command, environment, 120.0)
    return {"total_s": total_s, "player_s": total_s, "peak_mb": usage.peak_mb}


def start_up(environment: dict[str, str]) -> float:
    """Return the CPU seconds of opening and closing the window on a short clip."""
    with tempfile.TemporaryDirectory() as folder:
        clip = scrolling_clip(Path(folder), 1.0, "640x360", 30)
        command = player_command("play", str(clip), "--close-at-end", "--fullscreen")
        command += ["--device", "none", "--no-plots"]
        run_measured(command, environment, 60.0)  # compiles, where nothing has yet
        return run_measured(command, environment, 60.0)[1]


def first_picture(environment: dict[str, str], folder: Path) -> dict[str, list[float]]:
    """Return the seconds from start to first picture of some starts of each player."""
    clip, framebuffer = str(green_clip(folder, "1280x720")), folder / "Xvfb_screen0"
    commands = {
        "hapticplayer": player_command("play", clip, "--fullscreen", "--no-plots"),
        "mpv --vo=x11": [*MPV, clip],
    }
    return {
        name: [
            first_picture_s(command, environment, framebuffer) for _ in range(STARTS)
        ]
        for name, command in commands.items()
    }


def memory(minutes: float) -> int:
    """Play looped, each on a screen of its own, and print how the memory grows."""
    figures: dict[str, Any] = {"minutes": minutes}
    with (
        tempfile.TemporaryDirectory() as kept,
        screen() as first,
        screen() as second,
        sound_server() as s,
    ):
        folder = Path(kept)
        clip = scrolling_clip(folder, LOOPED_S, "1280x720", 30)
        force = force_file(folder, LOOPED_S)
        environment = {**s, "XDG_CONFIG_HOME": kept, **as_installed(kept)}
        looped = str(Path(__file__).with_name("playback_watch.py"))
        ours_looped = [sys.executable, looped, "play", str(clip), "--force", str(force)]
        mpv_looped = [*MPV, "--loop-file=inf", str(clip)]
        players = {
            "hapticplayer": (ours_looped, {**environment, **first}),
            "mpv --vo=x11": (mpv_looped, {**environment, **second}),
        }
        for name, samples in watch_memory(players, minutes).items():
            slope = slope_of(samples)
            figures[name] = {**slope._asdict(), "samples": samples}
            print(f"{name}: {slope}")
    print(f"saved {save('playback_memory', figures).name}")
    return 0


def measure(name: str, options: argparse.Namespace) -> dict[str, Any]:
    """Run the rounds with one clip and return what was measured."""
    size, rate_hz = CLIPS[name]
    width, height = map(int, size.split("x"))
    rounds: list[dict[str, dict[str, float]]] = []
    with (
        tempfile.TemporaryDirectory() as kept,
        screen(Path(kept), size=(width, height)) as x,
        sound_server() as s,
    ):
        folder = Path(kept)
        is_grain = name == "720p30"
        clip = (
            moving_clip(folder, options.seconds)
            if is_grain
            else scrolling_clip(folder, options.seconds, size, rate_hz)
        )
        force = force_file(folder, options.seconds)
        environment = {**x, **s, "XDG_CONFIG_HOME": kept, **as_installed(kept)}
        start_s = start_up(environment)
        first_s = first_picture(environment, folder)
        for number in range(options.rounds):
            found = {
                "hapticplayer": ours(clip, force, environment, plots=False),
                "mpv --vo=x11": other([*MPV, str(clip)], environment),
            }
            if not options.quick:
                found["ffplay"] = other([*FFPLAY, str(clip)], environment)
                found["with plots"] = ours(clip, force, environment, plots=True)
            rounds.append(found)
            print(f"{name}: round {number + 1} done", file=sys.stderr)
    return {
        "seconds": options.seconds,
        "load": os.getloadavg()[1],
        "start_and_end_s": start_s,
        "first_picture_s": first_s,
        "rounds": rounds,
    }


def report(name: str, figures: dict[str, Any]) -> None:
    """Print the medians and the ratios to mpv, and keep them."""
    rounds = figures["rounds"]

    def median(player: str, key: str) -> float:
        return float(statistics.median(r[player].get(key, 0.0) for r in rounds))

    def ratio(player: str, key: str) -> float:
        return float(
            statistics.median(r[player][key] / r["mpv --vo=x11"][key] for r in rounds)
        )

    keys = ("total_s", "player_s", "sound_s", "haptics_percent", "device_percent")
    keys += ("peak_mb", "dropped")
    rows = [
        [player, *[median(player, key) for key in keys], ratio(player, "player_s")]
        for player in rounds[0]
    ]
    header = ["", "tree CPU s", "player CPU s", "of it sound", "haptics %", "device %"]
    print(f"\n{name}, {figures['seconds']:.0f} s, {len(rounds)} rounds:")
    print(table([*header, "peak PSS MB", "dropped", "player / mpv"], rows))
    parts = ", ".join(f"{p} {median('hapticplayer', f'{p}_mb'):.0f}" for p in PARTS)
    print(f"peak PSS MB by process: {parts}")
    print(f"of which start and end of the program: {figures['start_and_end_s']:.2f} s")
    first_s = {p: statistics.median(s) for p, s in figures["first_picture_s"].items()}
    told = ", ".join(f"{player} {seconds:.2f}" for player, seconds in first_s.items())
    print(f"start to first picture, s: {told}; load {figures['load']:.1f}")
    figures["player_to_mpv"] = {p: ratio(p, "player_s") for p in rounds[0]}
    figures["memory_to_mpv"] = ratio("hapticplayer", "peak_mb")


def main() -> int:
    """Run the rounds and print CPU seconds and ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--clip", nargs="+", default=["720p30"], choices=[*CLIPS])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--memory", type=float, nargs="?", const=20.0, metavar="MIN")
    parser.add_argument("--quick", action="store_true", help="us and mpv only")
    options = parser.parse_args()
    need("Xvfb", "mpv", "ffmpeg", "pulseaudio", "pactl")
    if options.memory is not None:
        return memory(options.memory)
    figures = {}
    for name in options.clip:
        figures[name] = measure(name, options)
        report(name, figures[name])
    print(f"saved {save('playback', figures).name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
