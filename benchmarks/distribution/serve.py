"""A stream beside its file: time to the first force, seeks, and a bad network.

A 720p30 clip with force from its first second is packed and served by a process of its own,
on this machine. File and stream are opened in turn up to the first tick with a force on the
simulated device, which is ready all the time; the same seeks are timed in both, paused. Then
the stream is played through networks that lose, damage, swap and delay: what the haptic loop
has planned at each tick in which it follows is compared with the track of the file at that
time. `slew` is by how much the planned force changes per millisecond more than the track
itself does, also while it enters.
"""

import argparse
import contextlib
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report, interleaved
from benchmarks.distribution.one_file import felt_since, spread, until
from benchmarks.playback.plots_and_seeks import PausedPlayer, shaken_sequence
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.model import ForceTrack
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from hapticplayer.sequence.pack import pack
from hapticplayer.simulation.network import BadNetwork, NetworkFaults
from hapticplayer.streaming.opening import open_stream

MOST_START_MS, MOST_RATIO, MOST_ERROR, MOST_SLEW_N = 1000.0, 1.5, 0.05, 0.1
_CLOCK = SystemClock()
_MOVING = (Mode.ENTERING, Mode.FOLLOWING)
_NETWORKS = {
    "none": NetworkFaults(),
    "5 % lost": NetworkFaults(lost=0.05),
    "5 % damaged": NetworkFaults(damaged=0.05),
    "500 ms late": NetworkFaults(delay_s=0.5),
    "any order": NetworkFaults(is_reordered=True),
    "all of these": NetworkFaults(0.05, 0.0, 0.5, is_reordered=True, damaged=0.05),
    "5 % never come": NetworkFaults(gone=0.05),
}


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--rounds", type=int, help="(15)")
    parser.add_argument("--seeks", type=int, help="(40)")
    parser.add_argument("--seconds", type=float, help="played over each network (10)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Serve a ride and compare the stream with the file."""
    seconds = options.seconds or (2.0 if options.quick else 10.0)
    with tempfile.TemporaryDirectory(prefix="hp-serve-") as name:
        place = Path(name)
        os.environ["XDG_CACHE_HOME"] = str(place / "cache")
        file = place / "ride.mkv"
        pack(shaken_sequence(place, max(20.0, seconds + 5.0)), file)
        report.figures["clip_mb"] = 1e-6 * file.stat().st_size
        with _served(file) as url:
            ways: dict[str, Callable[[], Source]] = {
                "file": partial(open_source, file),
                "stream": partial(open_stream, url, _CLOCK),
            }
            rounds = options.rounds or (3 if options.quick else 15)
            _first_force(ways, rounds, report)
            _seeks(ways, options.seeks or (8 if options.quick else 40), report)
            track = open_source(file).tracks["realistic"]
            _networks(url, track, seconds, report)


@contextlib.contextmanager
def _served(file: Path) -> Iterator[str]:
    words = [sys.executable, "-m", "app", "serve", str(file), "--json"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, cwd=ROOT) as server:
        assert server.stdout is not None
        try:
            yield json.loads(server.stdout.readline())["url"]
        finally:
            server.terminate()


# --- time to the first force ---------------------------------------------------------


def _first_force(
    ways: dict[str, Callable[[], Source]], rounds: int, report: Report
) -> None:
    """Open file and stream in turn, until a tick has a force."""
    player = Player(_CLOCK, device="simulated", audio=None)
    player.wait_ready()
    contenders: dict[str, Callable[[], float]] = {
        name: partial(_opened_ms, player, way) for name, way in ways.items()
    }
    found = interleaved(contenders, rounds, warm_up=True)
    player.close()
    ratio = statistics.median(
        a / b for a, b in zip(found["stream"], found["file"], strict=True)
    )
    rows = [[name, *spread(each)] for name, each in found.items()]
    header = ["opened", "median ms", "least", "largest"]
    report.table("From opening to the first force", header, rows)
    report.target("stream: first force, median ms", rows[1][1], ("<=", MOST_START_MS))
    report.figures["first_force"] = {"columns": header, "rows": rows}
    report.target("stream: first force over the file's", ratio, ("<=", MOST_RATIO))


def _opened_ms(player: Player, way: Callable[[], Source]) -> float:
    """Return how long it takes from opening to the first tick with a force."""
    until(player, _CLOCK, lambda: not felt_since(player, _CLOCK.now_s() - 0.2))
    begin_s = _CLOCK.now_s()
    player.open(way())
    player.play()
    until(player, _CLOCK, lambda: felt_since(player, begin_s))
    ticks = player.ticks_since(begin_s)
    active = np.linalg.norm(ticks["force_n"], axis=1) > 0.0
    player.pause()
    return 1e3 * (float(ticks["monotonic_s"][active][0]) - begin_s)


# --- seeks -------------------------------------------------------------------------


def _seeks(ways: dict[str, Callable[[], Source]], count: int, report: Report) -> None:
    """Seek to the same places in both, paused, in turn."""
    players = {name: PausedPlayer(way()) for name, way in ways.items()}
    duration_s = players["file"].player.snapshot().duration_s
    took: dict[str, list[float]] = {name: [] for name in players}
    places = np.random.default_rng(1).uniform(0.0, duration_s - 0.1, count)
    for number, target_s in enumerate(places):
        for name in list(players)[:: 1 if number % 2 else -1]:
            begin_s = time.monotonic()
            players[name].seek(float(target_s))
            took[name].append(1e3 * (time.monotonic() - begin_s))
    for one in players.values():
        one.player.close()
    rows = [[name, *np.percentile(each, [50.0, 95.0])] for name, each in took.items()]
    report.table("Seeks, paused", ["in", "p50 ms", "p95 ms"], rows)
    report.figures["seeks"] = {"columns": ["in", "p50 ms", "p95 ms"], "rows": rows}


# --- a bad network -----------------------------------------------------------------


def _networks(url: str, track: ForceTrack, seconds: float, report: Report) -> None:
    """Play over each network and compare what is planned with the track."""
    rows = []
    for name, faults in _NETWORKS.items():
        with BadNetwork(url, faults, _CLOCK) as network:
            found = _played(network.url, seconds)
        rows.append([name, *_error(found, track)])
    header = ["network", "error, share of RMS", "largest N", "slew N/ms", "trips"]
    report.table("Force over a bad network", header, rows)
    report.figures["networks"] = {"columns": header, "rows": rows}
    lost = next(row for row in rows if row[0] == "5 % lost")
    report.target("5 % lost: RMS error over RMS force", lost[1], ("<=", MOST_ERROR))
    slew_n = max(row[3] for row in rows)
    report.target("slew beyond the track's, N per ms", slew_n, ("<=", MOST_SLEW_N))
    report.target("trips", sum(row[4] for row in rows), ("<=", 0))


def _played(url: str, seconds: float) -> Any:
    """Return the ticks of some seconds of a stream."""
    player = Player(_CLOCK, device="simulated", audio=None)
    player.wait_ready()
    player.open(open_stream(url, _CLOCK))
    player.play()
    until(player, _CLOCK, lambda: felt_since(player, 0.0))
    end_s = _CLOCK.now_s() + seconds
    while _CLOCK.now_s() < end_s:
        _CLOCK.sleep_until(player.poll())
    ticks = player.ticks_since(end_s - seconds)
    player.close()
    return ticks


def _error(ticks: Any, track: ForceTrack) -> tuple[float, float, float, int]:
    trips = int(np.any(ticks["mode"] == Mode.TRIPPED))
    ticks = ticks[np.isin(ticks["mode"], _MOVING)]
    whole = track.at(ticks["media_s"])
    follows = ticks["mode"] == Mode.FOLLOWING  # an entry is gentler than the track
    error = np.linalg.norm(ticks["planned_n"] - whole, axis=1)[follows]
    size = np.linalg.norm(whole, axis=1)[follows]
    share = float(np.sqrt(np.mean(error**2) / np.mean(size**2)))
    change, own = (
        np.linalg.norm(np.diff(each, axis=0), axis=1)
        for each in (ticks["planned_n"], whole)
    )
    gap_ms = 1e3 * np.diff(ticks["monotonic_s"])
    is_next = gap_ms < 1.5
    slew_n = float(np.max(((change - own) / gap_ms)[is_next], initial=0.0))
    return share, float(np.max(error)), slew_n, trips
