"""CPU of playing 30 s of a moving clip with sound, beside mpv --vo=x11 and ffplay.

    python benchmarks/playback.py [--clip 720p30 ...] [--rounds 3] [--seconds 30]

Same window size (the whole screen under Xvfb), same null sink; from start to exit. The
loop, its guard and the simulated device are measured apart; once more with the live
plots on, in a window. Dropped pictures are our own count. `720p30` has 20 Mbit/s of
grain, where decoding is nearly all there is; the others scroll at usual bit rates.
"""

import argparse
import json
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from common import (
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

CLIPS = {
    "720p30": ("1280x720", 30),
    "720p30-scrolling": ("1280x720", 30),
    "1080p60": ("1920x1080", 60),
}
DEVICE = "hapticplayer.devices"
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
        return run_measured(command, environment, 60.0)[1]


def measure(name: str, options: argparse.Namespace) -> dict[str, Any]:
    """Run the rounds with one clip and return what was measured."""
    size, rate_hz = CLIPS[name]
    width, height = map(int, size.split("x"))
    rounds: list[dict[str, dict[str, float]]] = []
    with (
        tempfile.TemporaryDirectory() as kept,
        screen(size=(width, height)) as x,
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
        environment = {**x, **s, "XDG_CONFIG_HOME": kept}
        start_s = start_up(environment)
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
    return {"seconds": options.seconds, "start_and_end_s": start_s, "rounds": rounds}


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
    print(f"of which start and end of the program: {figures['start_and_end_s']:.2f} s")
    figures["player_to_mpv"] = {p: ratio(p, "player_s") for p in rounds[0]}
    figures["memory_to_mpv"] = ratio("hapticplayer", "peak_mb")


def main() -> int:
    """Run the rounds and print CPU seconds and ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--clip", nargs="+", default=["720p30"], choices=[*CLIPS])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--quick", action="store_true", help="us and mpv only")
    options = parser.parse_args()
    need("Xvfb", "mpv", "ffmpeg", "pulseaudio", "pactl")
    figures = {}
    for name in options.clip:
        figures[name] = measure(name, options)
        report(name, figures[name])
    print(f"saved {save('playback', figures).name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
