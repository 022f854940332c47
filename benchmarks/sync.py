"""Picture, sound and force of one moment, measured from outside, beside mpv.

    python benchmarks/sync.py [--case plain ...] [--seconds 14] [--rounds 1] [--no-mpv]

A clip flashes, beeps and pushes every half second. One pixel of the X server's memory is
read at 1 kHz, the null sink's monitor is recorded, the simulated device keeps what
reached it; all on CLOCK_MONOTONIC. Sound is corrected by the recorder's own constant,
measured before with beeps whose time PulseAudio itself tells. mpv plays the same clip in
the same run. Positive figures: the first named comes later. `--case all` runs all but
`long`: 20 minutes, of which the drift is told: the median of the last quarter less that
of the first, times 4/3.
"""

import argparse
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import sync_clips as clips
from common import SoundServer, mortal_sound_server, need, save, screen, table
from numpy.typing import NDArray
from sentinel import sentinel
from sync_stalls import LASTS_S, standstills
from sync_watch import flashes, onsets, watcher

Floats = NDArray[np.float64]

SPEEDS = ("speed-0.5", "speed-0.75", "speed-1.25", "speed-1.5", "speed-2")
CASES = (
    *("plain", "pause", "seek", "server", "no-device", "silent", "vfr", "late"),
    *("freeze", "hold", *LASTS_S, *SPEEDS),
)
LONG, LONG_SECONDS, MOST_DRIFT_MS = "long", 1200.0, 1.0
READ_S = 20.0  # the device's record keeps a minute
NEAR_S = 0.2
MOST_WHITE_S = 0.45
SECONDS = {"seek": 54.0, LONG: LONG_SECONDS}
NO_SOUND = ("no-device", "silent")
HUNG = ("freeze", "hold")
# (least median, most median, most p95 of the magnitude), ms
BARS = {
    "sound - picture": (-3.0, 3.0, 6.0),
    "force - picture": (0.0, 3.0, 5.0),
    "force - sound": (-2.0, 2.0, 4.0),
}
WORSE_THAN_MPV_MS = 2.0


@dataclass(frozen=True, slots=True)
class Place:
    """Where the players play."""

    folder: Path
    environment: dict[str, str]
    monitor_s: float  # the recorder hears so much later than PulseAudio says
    sound: SoundServer


@dataclass(frozen=True, slots=True)
class Seen:
    """When one player flashed, beeped and pushed, s."""

    flashes: Floats
    beeps: Floats
    pushes: Floats
    summary: dict[str, Any]
    unseen: int  # flashes that began while the watcher itself stood still


@contextlib.contextmanager
def watching(place: Place) -> Iterator[tuple[Path, Path]]:
    """Watch screen and sound inside the block."""
    pixel, sound = place.folder / "pixel.npz", place.folder / "sound.npz"
    framebuffer = str(place.folder / "Xvfb_screen0")
    with (
        watcher("pixel", framebuffer, str(pixel)),
        watcher("sound", str(sound), environment=place.environment),
    ):
        yield pixel, sound


def calibrate(folder: Path, environment: dict[str, str]) -> float:
    """Return by how much the recorder is later than what PulseAudio says, s."""
    said, sound = folder / "said.npz", folder / "heard.npz"
    with (
        watcher("sound", str(sound), environment=environment),
        watcher("beeps", str(said), environment=environment),
    ):
        time.sleep(8.0)
    differences_s = _differences(np.load(said)["said"], onsets(sound))
    print(
        f"the recorder is {1e3 * np.median(differences_s):+.2f} ms off what PulseAudio "
        f"says (sd {1e3 * differences_s.std():.2f} ms, {len(differences_s)} beeps)",
        file=sys.stderr,
    )
    return float(np.median(differences_s))


def watch_us(place: Place, case: str, clip: Path, force: Path, seconds: float) -> Seen:
    """Play with our player."""
    record = os.memfd_create("sync")
    script = Path(__file__).with_name("sync_player.py")
    command = [sys.executable, str(script), str(clip), str(force), str(record)]
    environment = {**os.environ, **place.environment}
    if case == "no-device":
        environment["PULSE_SERVER"] = "unix:/nowhere"
    with watching(place) as (pixel, sound):
        player = subprocess.Popen(
            [*command, case, str(seconds)],
            env=environment,
            pass_fds=(record,),
            stdout=subprocess.PIPE,
        )
        if case == "server":
            time.sleep(0.4 * seconds)
            place.sound.restart(2.0)
        with standstills(case, player, place.sound.pid) as unheard:
            printed, pushes = _follow(player, record, seconds + 60.0)
    if player.returncode:
        sys.exit(f"our player ended with {player.returncode}")
    os.close(record)
    shown, unseen = flashes(pixel, MOST_WHITE_S)
    summary = json.loads(printed.splitlines()[-1])
    summary["hung"] += unheard
    return Seen(shown, onsets(sound) - place.monitor_s, pushes, summary, unseen)


def _follow(
    player: "subprocess.Popen[bytes]", record: int, patience_s: float
) -> tuple[bytes, Floats]:
    """Wait for the player; return what it printed, and when it pushed."""
    from hapticplayer.simulation.falcon.record_reader import read_record

    until_s, pushes, printed = time.monotonic() + patience_s, [np.empty(0)], b""
    while player.returncode is None and time.monotonic() < until_s:
        with contextlib.suppress(subprocess.TimeoutExpired):
            printed, _ = player.communicate(timeout=READ_S)
        device = read_record(record)
        up_n = device["commanded_n"][:, 1]
        rising = np.flatnonzero(np.diff(up_n) > 0.5 * clips.FORCE_N) + 1
        times = device["monotonic_s"][rising]
        known_s = max((float(part[-1]) for part in pushes if len(part)), default=0.0)
        pushes.append(times[times > known_s + 1e-3])
    if player.returncode is None:
        player.kill()
        sys.exit("our player did not end")
    return printed, np.concatenate(pushes)


def watch_mpv(place: Place, case: str, clip: Path, seconds: float) -> Seen:
    """Play with mpv; of the cases it knows only clips and speeds."""
    command = ["mpv", "--no-config", "--vo=x11", "--ao=pulse", "--fs", "--osc=no"]
    command += ["--no-terminal", str(clip)]
    if case.startswith("speed-"):
        command += [f"--speed={case.removeprefix('speed-')}"]
    environment = {**os.environ, **place.environment}
    with watching(place) as (pixel, sound):
        player = subprocess.Popen(command, env=environment)
        with contextlib.suppress(subprocess.TimeoutExpired):
            player.wait(seconds)
        player.send_signal(signal.SIGTERM)
        player.wait()
    shown, unseen = flashes(pixel, MOST_WHITE_S)
    return Seen(shown, onsets(sound) - place.monitor_s, np.empty(0), {}, unseen)


def _differences(first: Floats, later: Floats) -> Floats:
    """Return `later` minus `first` for those that are each other's nearest."""
    if not len(first) or not len(later):
        return np.empty(0)
    apart = later[None, :] - first[:, None]
    partner = np.abs(apart).argmin(axis=1)
    is_mutual = np.abs(apart).argmin(axis=0)[partner] == np.arange(len(first))
    best = apart[np.arange(len(first)), partner]
    return np.asarray(best[is_mutual & (np.abs(best) < NEAR_S)])


def differences_ms(seen: Seen) -> dict[str, Floats]:
    """Return the three differences of each moment."""
    hung = seen.summary.get("hung", [])

    def kept(times: Floats) -> Floats:
        outside = [(times < begin) | (times > end) for begin, end in hung]
        return times[np.all(outside, axis=0)] if hung else times

    pairs = {
        "sound - picture": (seen.flashes, seen.beeps),
        "force - picture": (seen.flashes, seen.pushes),
        "force - sound": (seen.beeps, seen.pushes),
    }
    return {
        name: 1e3 * _differences(kept(first), later)
        for name, (first, later) in pairs.items()
    }


def row(name: str, what: str, values_ms: Floats) -> dict[str, Any]:
    """Return the figures of one difference and whether they pass."""
    if len(values_ms) < 3:
        return {"player": name, "what": what, "count": len(values_ms), "holds": False}
    p05, p50, p95 = np.percentile(values_ms, [5.0, 50.0, 95.0])
    magnitude_p95 = float(np.percentile(np.abs(values_ms), 95.0))
    least, most, most_p95 = BARS[what]
    return {
        "player": name,
        "what": what,
        "count": len(values_ms),
        "p05": float(p05),
        "p50": float(p50),
        "p95": float(p95),
        "abs_p95": magnitude_p95,
        "max": float(np.abs(values_ms).max()),
        "drift": drift_ms(values_ms),
        "holds": bool(least <= p50 <= most and magnitude_p95 <= most_p95),
    }


def drift_ms(values_ms: Floats) -> float:
    """Return how far differences have moved, in the order of time, ms."""
    quarter = max(1, len(values_ms) // 4)
    last, first = np.median(values_ms[-quarter:]), np.median(values_ms[:quarter])
    return float(last - first) * 4.0 / 3.0


def run_case(
    place: Place, case: str, clip: Path, options: argparse.Namespace
) -> dict[str, Any]:
    """Run one case with our player and, where it can, with mpv."""
    seconds = SECONDS.get(case, options.seconds)
    force = place.folder / "force.csv"
    kind = case if case in ("silent", "vfr", "late", LONG) else ""
    played = clips.variant(kind, clip) if kind else clip
    parts: dict[str, list[dict[str, Floats]]] = {"hapticplayer": []}
    summaries, hung_beeps, unseen = [], [], 0
    is_comparable = case in ("plain", "vfr", "late", *SPEEDS) and options.mpv
    for _ in range(options.rounds):
        seen = watch_us(place, case, played, force, seconds)
        parts["hapticplayer"].append(differences_ms(seen))
        summaries.append(seen.summary)
        unseen += seen.unseen
        for begin, end in seen.summary["hung"] if case in HUNG else ():
            inside = (seen.beeps > begin) & (seen.beeps < end)
            hung_beeps.append(int(inside.sum()))
        if is_comparable:
            theirs = differences_ms(watch_mpv(place, case, played, seconds))
            parts.setdefault("mpv", []).append(
                {"sound - picture": theirs["sound - picture"]}
            )
    rows = [
        row(name, what, np.concatenate([part[what] for part in found]))
        for name, found in parts.items()
        for what in found[0]
        if not (case in NO_SOUND and "sound" in what)
    ]
    return {
        "rows": rows,
        "summaries": summaries,
        "beeps_while_hung": hung_beeps,
        "unseen": unseen,
    }


def report(case: str, figures: dict[str, Any]) -> bool:
    """Print one case; return whether its bars hold."""
    keys = ("player", "what", "count", "p05", "p50", "p95", "abs_p95", "max")
    keys += ("drift", "holds") if case == LONG else ("holds",)
    rows = figures["rows"]
    print(f"\n{case}:")
    print(table([*keys], [[line.get(key, "-") for key in keys] for line in rows]))
    if figures["unseen"]:
        print(f"  {figures['unseen']} flashes began while the watcher stood still")
    if figures["beeps_while_hung"]:
        print("beeps heard while the window hung:", figures["beeps_while_hung"])
    for summary in figures["summaries"]:
        print(
            f"  frames {summary['frames']}, sound missing {summary['audio_underrun_s']} s,"
            f" told {summary['told']}\n  by its own record: "
            f"force - picture {summary['haptic_minus_video_ms']}"
        )
    ours = [line for line in rows if line["player"] == "hapticplayer"]
    holds = all(line["holds"] for line in ours)
    if case == LONG:
        holds = holds and all(abs(line["drift"]) <= MOST_DRIFT_MS for line in ours)
    theirs = [line for line in rows if line["player"] == "mpv" and "p50" in line]
    for line in theirs:
        mine = next(o for o in ours if o["what"] == line["what"])
        worse_ms = abs(mine.get("p50", np.inf)) - abs(line["p50"])
        print(f"  {mine['what']}: worse than mpv by {worse_ms:+.1f} ms")
        holds = holds and worse_ms <= WORSE_THAN_MPV_MS
    print("  holds" if holds else "  DOES NOT HOLD")
    return holds


def main() -> int:
    """Run the cases."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--case", nargs="+", default=["plain"], choices=[*CASES, LONG, "all"]
    )
    parser.add_argument("--seconds", type=float, default=14.0)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--no-mpv", dest="mpv", action="store_false")
    options = parser.parse_args()
    need("Xvfb", "mpv", "pulseaudio", "pactl", "ffmpeg")
    cases = CASES if "all" in options.case else options.case
    figures, holds = {}, []
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        fastest = max(float(c.partition("-")[2]) if c in SPEEDS else 1.0 for c in cases)
        length_s = max(SECONDS["seek"] * ("seek" in cases), options.seconds * fastest)
        length_s = clips.LOOP_S if LONG in cases else length_s + 2.0
        clip = clips.base_clip(folder, length_s)
        clips.force_file(folder, LONG_SECONDS if LONG in cases else length_s)
        shown = stack.enter_context(screen(folder))
        sound = stack.enter_context(mortal_sound_server())
        witness = stack.enter_context(sentinel())
        environment = {**shown, **sound.environment, "XDG_CONFIG_HOME": str(folder)}
        place = Place(folder, environment, calibrate(folder, environment), sound)
        for case in cases:
            figures[case] = run_case(place, case, clip, options)
            holds.append(report(case, figures[case]))
        stalls_ms = [1e3 * late_s for _, late_s in witness.stalls()]
    print(
        f"\nstalls of the machine: {len(stalls_ms)}, at most {max(stalls_ms, default=0):.1f} ms"
    )
    figures["recorder_offset_ms"] = 1e3 * place.monitor_s
    print(f"saved {save('sync', figures).name}")
    return 0 if all(holds) else 1


if __name__ == "__main__":
    sys.exit(main())
