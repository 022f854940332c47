"""Frame, sound and force of one moment, measured from outside, beside mpv.

A clip flashes, beeps and pushes every half second. One pixel of the X server's memory
is read at 1 kHz, the null sink's monitor is recorded, the simulated device keeps what
reached it; all on CLOCK_MONOTONIC. Sound is corrected by the recorder's own constant,
measured before with beeps whose time PulseAudio states. mpv plays the same clip in the
same run. Positive: the first named comes later. `--case all` runs all but `long`, 20
minutes, of which the drift is judged: the median of the last quarter less that of the
first, times 4/3. Speeds other than 1 are reported, not judged.
"""

import argparse
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import ROOT, Report
from benchmarks.stage import Usage, need, screen, sound_server
from benchmarks.sync import staging
from benchmarks.sync.staging import flashes, onsets, watcher
from tests.material.plant_record import read_record
from tools.sound_server import SoundServer
from tools.witness import machine_witness

Floats = NDArray[np.float64]
Span = tuple[float, float]

SPEEDS = ("speed-0.5", "speed-0.75", "speed-1.25", "speed-1.5", "speed-2")
# stops of the sound server, for less than it holds; of our sound process, for more
STOPS = {"stalled": ((0.05, 0.1), (0.5, 1.5)), "starved": ((0.1, 0.3), (2.0, 6.0))}
CASES = (
    *("plain", "pause", "seek", "server", "no-device", "silent", "vfr", "late"),
    *("freeze", "hold", *STOPS, *SPEEDS),
)
LONG, LONG_SECONDS, MOST_DRIFT_MS = "long", 1200.0, 1.0
SECONDS = {"seek": 54.0, LONG: LONG_SECONDS}
READ_S = 20.0  # the device's record keeps a minute
NEAR_S = 0.2
FIRST_STOP_S, HEARD_AFTER_S = 4.0, 0.15
NO_SOUND = ("no-device", "silent")
BESIDE_MPV = ("plain", "vfr", "late", *SPEEDS)
# (least median, most median, most p95 of the magnitude), ms
LIMITS = {
    "sound - frame": (-3.0, 3.0, 6.0),
    "force - frame": (0.0, 3.0, 5.0),
    "force - sound": (-2.0, 2.0, 4.0),
}
WORSE_THAN_MPV_MS = 2.0


@dataclass(frozen=True, slots=True)
class Place:
    """Where the players play; the recorder hears `monitor_s` later than is said."""

    folder: Path
    environment: dict[str, str]
    monitor_s: float
    sound: SoundServer


@dataclass(frozen=True, slots=True)
class Seen:
    """When one player flashed, beeped and pushed, s.

    Attributes:
        summary: of our player.
        unseen: flashes that began while the watcher itself stalled.
    """

    flashes: Floats
    beeps: Floats
    pushes: Floats
    summary: dict[str, Any]
    unseen: int


@contextlib.contextmanager
def watching(place: Place) -> Iterator[tuple[Path, Path]]:
    """Watch screen and sound inside the block."""
    pixel, sound = place.folder / "pixel.npz", place.folder / "sound.npz"
    framebuffer = str(place.folder / "Xvfb_screen0")
    with (
        watcher("pixel", str(pixel), framebuffer),
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
    print(f"recorder's constant {1e3 * np.median(differences_s):+.2f} ms")
    return float(np.median(differences_s))


def watch_us(place: Place, case: str, clip: Path, force: Path, seconds: float) -> Seen:
    """Play with our player."""
    record = os.memfd_create("sync")
    command = [
        sys.executable,
        "-m",
        "benchmarks.sync.staging",
        "player",
        str(clip),
        str(force),
    ]
    environment = {**os.environ, **place.environment}
    if case == "no-device":
        environment["PULSE_SERVER"] = "unix:/nowhere"
    with watching(place) as (pixel, sound):
        player = subprocess.Popen(
            [*command, str(record), case, str(seconds)],
            env=environment,
            cwd=ROOT,
            pass_fds=(record,),
            stdout=subprocess.PIPE,
        )
        if case == "server":
            time.sleep(0.4 * seconds)
            place.sound.restart(2.0)
        with stops(case, player.pid, place.sound) as unheard:
            printed, pushes = _follow(player, record, seconds + 60.0)
    if player.returncode:
        sys.exit(f"our player ended with {player.returncode}")
    os.close(record)
    shown, unseen = flashes(pixel)
    summary = json.loads(printed.splitlines()[-1])
    summary["hung"] += unheard
    return Seen(shown, onsets(sound) - place.monitor_s, pushes, summary, unseen)


def _follow(
    player: "subprocess.Popen[bytes]", record: int, patience_s: float
) -> tuple[bytes, Floats]:
    """Wait for the player; return what it printed, and when it pushed."""
    until_s, pushes, printed = time.monotonic() + patience_s, [np.empty(0)], b""
    while player.returncode is None and time.monotonic() < until_s:
        with contextlib.suppress(subprocess.TimeoutExpired):
            printed, _ = player.communicate(timeout=READ_S)
        device = read_record(record)
        up_n = device["commanded_n"][:, 1]
        rising = np.flatnonzero(np.diff(up_n) > 0.5 * staging.FORCE_N) + 1
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
    shown, unseen = flashes(pixel)
    return Seen(shown, onsets(sound) - place.monitor_s, np.empty(0), {}, unseen)


@contextlib.contextmanager
def stops(case: str, player: int, server: SoundServer) -> Iterator[list[Span]]:
    """Stop the sound server or our sound process now and then inside the block.

    Yields:
        The times in which a beep can't be heard, complete at the end.
    """
    spans: list[Span] = []
    if case not in STOPS:
        yield spans
        return
    is_over = threading.Event()

    def pids() -> list[int]:
        return [server.process.pid] if case == "stalled" else _sound_processes(player)

    arguments = (pids, case, spans, is_over)
    thread = threading.Thread(target=_stop_now_and_then, args=arguments)
    thread.start()
    try:
        yield spans
    finally:
        is_over.set()
        thread.join()
        if case == "stalled":
            spans.clear()  # nothing is too late then


def _stop_now_and_then(
    pids: Callable[[], list[int]], case: str, spans: list[Span], is_over: Any
) -> None:
    random, wait_s = np.random.default_rng(7), FIRST_STOP_S
    lasts_s, every_s = STOPS[case]
    while not is_over.wait(wait_s):
        begin_s = time.monotonic()
        with contextlib.ExitStack() as stopped:
            for pid in pids():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGSTOP)
                    stopped.callback(_continue, pid)
            time.sleep(random.uniform(*lasts_s))
        spans.append((begin_s, time.monotonic() + HEARD_AFTER_S))
        wait_s = random.uniform(*every_s)


def _continue(pid: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGCONT)


def _sound_processes(player: int) -> list[int]:
    usage = Usage(player)
    usage.sample_cpu()
    named = usage.by_pid.items()
    return [pid for pid, (command, _) in named if "playback.sound_device" in command]


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
    """Return the three differences of each moment, outside what hung."""
    hung = seen.summary.get("hung", [])

    def kept(times: Floats) -> Floats:
        outside = [(times < begin) | (times > end) for begin, end in hung]
        return times[np.all(outside, axis=0)] if hung else times

    pairs = {
        "sound - frame": (seen.flashes, seen.beeps),
        "force - frame": (seen.flashes, seen.pushes),
        "force - sound": (seen.beeps, seen.pushes),
    }
    return {
        name: 1e3 * _differences(kept(first), later)
        for name, (first, later) in pairs.items()
    }


def row(values_ms: Floats) -> dict[str, float]:
    """Return the figures of one difference."""
    if len(values_ms) < 3:
        return {"count": len(values_ms)}
    p05, p50, p95 = np.percentile(values_ms, [5.0, 50.0, 95.0]).tolist()
    quarter = max(1, len(values_ms) // 4)
    moved = np.median(values_ms[-quarter:]) - np.median(values_ms[:quarter])
    return {
        "count": len(values_ms),
        "p05": p05,
        "p50": p50,
        "p95": p95,
        "abs_p95": float(np.percentile(np.abs(values_ms), 95.0)),
        "max": float(np.abs(values_ms).max()),
        "drift": float(moved) * 4.0 / 3.0,
    }


def run_case(
    place: Place, case: str, clip: Path, options: argparse.Namespace
) -> dict[str, Any]:
    """Run one case with our player and, where it can, with mpv."""
    seconds, force = SECONDS.get(case, options.seconds), place.folder / "force.csv"
    if case in ("silent", "vfr", "late", LONG):
        clip = staging.variant(case, clip)
    parts: dict[str, list[dict[str, Floats]]] = {"hapticplayer": []}
    summaries, hung_beeps, unseen = [], [], 0
    for _ in range(options.rounds):
        seen = watch_us(place, case, clip, force, seconds)
        parts["hapticplayer"].append(differences_ms(seen))
        summaries.append(seen.summary)
        unseen += seen.unseen
        for begin, end in seen.summary["hung"] if case in ("freeze", "hold") else ():
            hung_beeps.append(int(((seen.beeps > begin) & (seen.beeps < end)).sum()))
        if case in BESIDE_MPV and options.mpv:
            theirs = differences_ms(watch_mpv(place, case, clip, seconds))
            only = {"sound - frame": theirs["sound - frame"]}
            parts.setdefault("mpv", []).append(only)
    rows = {
        player: {
            what: row(np.concatenate([part[what] for part in found]))
            for what in found[0]
            if not (case in NO_SOUND and "sound" in what)
        }
        for player, found in parts.items()
    }
    return {
        **rows,
        "beeps_while_hung": hung_beeps,
        "unseen": unseen,
        "frames": [s["frames"] for s in summaries],
        "sound_missing_s": [s["audio_underrun_s"] for s in summaries],
        "own_force_minus_frame_ms": [s["haptic_minus_video_ms"] for s in summaries],
    }


def judge(case: str, figures: dict[str, Any], report: Report) -> None:
    """Note what is asked of a case; of other speeds nothing is."""
    if case in SPEEDS:
        return
    for what, found in figures["hapticplayer"].items():
        least, most, most_p95 = LIMITS[what]
        name, nothing = f"{case}: {what}, ms", float("inf")
        report.target(f"{name}, median", found.get("p50", nothing), ("<=", most))
        report.target(f"{name}, median", found.get("p50", -nothing), (">=", least))
        report.target(f"{name}, 95 %", found.get("abs_p95", nothing), ("<=", most_p95))
        if case == LONG:
            drift = abs(found.get("drift", nothing))
            report.target(f"{name}, drift", drift, ("<=", MOST_DRIFT_MS))
    for what, theirs in figures.get("mpv", {}).items():
        if "p50" in theirs:
            mine = figures["hapticplayer"][what].get("p50", float("inf"))
            worse = abs(mine) - abs(theirs["p50"])
            limit = ("<=", WORSE_THAN_MPV_MS)
            report.target(f"{case}: {what}, ms worse than mpv", worse, limit)


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    names = [*CASES, LONG, "all"]
    parser.add_argument("--case", nargs="+", default=["plain"], choices=names)
    parser.add_argument("--seconds", type=float, default=14.0)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--no-mpv", dest="mpv", action="store_false")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run the cases."""
    need("Xvfb", "mpv", "pulseaudio", "pactl", "ffmpeg")
    cases = CASES if "all" in options.case else tuple(options.case)
    rows = []
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        fastest = max(float(c.partition("-")[2]) if c in SPEEDS else 1.0 for c in cases)
        length_s = max(SECONDS["seek"] * ("seek" in cases), options.seconds * fastest)
        length_s = staging.LOOP_S if LONG in cases else length_s + 2.0
        clip = staging.base_clip(folder, length_s)
        staging.force_file(folder, LONG_SECONDS if LONG in cases else length_s)
        shown = stack.enter_context(screen(folder))
        sound = stack.enter_context(sound_server())
        witness = stack.enter_context(machine_witness())
        environment = {**shown, **sound.environment, "XDG_CONFIG_HOME": str(folder)}
        place = Place(folder, environment, calibrate(folder, environment), sound)
        for case in cases:
            figures = report.figures[case] = run_case(place, case, clip, options)
            judge(case, figures, report)
            for player in ("hapticplayer", "mpv"):
                rows += [
                    [case, player, what, *list(found.values())[:6]]
                    for what, found in figures.get(player, {}).items()
                    if "p50" in found
                ]
            if figures["beeps_while_hung"]:
                print(f"{case}: beeps while it hung {figures['beeps_while_hung']}")
        report.figures["machine_stalls"] = witness.seen().summary()
    header = ["case", "player", "what", "n", "5 %", "median", "95 %", "|95 %|", "max"]
    report.table("Sync from outside, ms", header, rows)
    print(f"machine stalls {report.figures['machine_stalls']}")
    report.figures["recorder_offset_ms"] = 1e3 * place.monitor_s
