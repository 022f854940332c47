"""CPU of playing 30 s of a moving 720p30 clip with sound, beside mpv --vo=x11.

    python benchmarks/playback.py [--rounds 3] [--seconds 30]

Same window size (the whole screen under Xvfb), same null sink. Our process tree is
measured from start to exit, the haptics process and the player without it apart;
once more with the live plots on, in a window. Dropped pictures are our own count.
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
    sound_server,
    table,
)


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
    """Play once and return CPU seconds and frames."""
    command = player_command("play", str(clip), "--force", str(force))
    command += ["--close-at-end", "--json"]
    command += [] if plots else ["--fullscreen", "--no-plots"]
    usage, total_s, printed = run_measured(command, environment, 120.0)
    summary = json.loads(printed)
    haptics_s = usage.of("hapticplayer.haptics")
    played_s = summary["ticks"] / 1000.0
    return {
        "total_s": total_s,
        "haptics_s": haptics_s,
        "player_s": total_s - haptics_s,
        "haptics_percent_of_core": 100.0 * haptics_s / played_s,
        "shown": summary["frames"]["shown"],
        "dropped": summary["frames"]["dropped"],
        "clock_is_audio": float(summary["clock"] == "audio"),
    }


def mpv(clip: Path, environment: dict[str, str]) -> dict[str, float]:
    """Play once with mpv's plain X11 output."""
    command = ["mpv", "--no-config", "--vo=x11", "--ao=pulse", "--fs", "--osc=no"]
    command += ["--no-terminal", str(clip)]
    _usage, total_s, _printed = run_measured(command, environment, 120.0)
    return {"total_s": total_s, "player_s": total_s}


def start_up(environment: dict[str, str]) -> float:
    """Return the CPU seconds of opening and closing the window on a short clip."""
    with tempfile.TemporaryDirectory() as folder:
        clip = moving_clip(Path(folder), 1.0)
        command = player_command("play", str(clip), "--close-at-end", "--fullscreen")
        command += ["--device", "none", "--no-plots"]
        return run_measured(command, environment, 60.0)[1]


def main() -> int:
    """Run the rounds and print CPU seconds and ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=30.0)
    options = parser.parse_args()
    need("Xvfb", "mpv", "pulseaudio", "pactl")
    rounds: list[dict[str, dict[str, float]]] = []
    with tempfile.TemporaryDirectory() as name, screen() as x, sound_server() as s:
        folder = Path(name)
        clip = moving_clip(folder, options.seconds)
        force = force_file(folder, options.seconds)
        environment = {**x, **s, "XDG_CONFIG_HOME": name}
        start_s = start_up(environment)
        for number in range(options.rounds):
            rounds.append(
                {
                    "hapticplayer": ours(clip, force, environment, plots=False),
                    "mpv --vo=x11": mpv(clip, environment),
                    "with plots": ours(clip, force, environment, plots=True),
                }
            )
            print(f"round {number + 1} of {options.rounds} done", file=sys.stderr)
    report(rounds, start_s, options)
    return 0


def report(rounds: list[dict[str, Any]], start_s: float, options: Any) -> None:
    """Print and save the medians and the ratios to mpv."""

    def median(name: str, key: str) -> float:
        return float(statistics.median(r[name].get(key, 0.0) for r in rounds))

    def ratio(name: str, key: str) -> float:
        pairs = [r[name][key] / r["mpv --vo=x11"]["total_s"] for r in rounds]
        return float(statistics.median(pairs))

    names = list(rounds[0])
    keys = ("total_s", "player_s", "haptics_s", "haptics_percent_of_core", "dropped")
    rows = [
        [name, *[median(name, key) for key in keys], ratio(name, "player_s")]
        for name in names
    ]
    header = ["", "tree CPU s", "player CPU s", "haptics CPU s", "haptics % of a core"]
    print(table([*header, "dropped", "player / mpv"], rows))
    print(f"of which start and end of the program: {start_s:.2f} s (with a 1 s clip)")
    figures = {
        "seconds": options.seconds,
        "rounds": rounds,
        "start_and_end_cpu_s": start_s,
        "player_to_mpv": {name: ratio(name, "player_s") for name in names},
        "haptics_percent_of_core": median("hapticplayer", "haptics_percent_of_core"),
    }
    print(f"saved {save('playback', figures).name}")


if __name__ == "__main__":
    sys.exit(main())
