"""A packed file on a web server beside the file: time to the first force, and seeks.

A 720p30 clip with force from its first second is packed and offered by nginx (where
installed) and by `serve`, on this machine. Each is opened in turn with the file, up to the
first tick with a force on the simulated device, which is ready all the time; the same seeks
are timed in all, paused, with 8 MB of the clip in memory so that most go where nothing is.
Seeks are also timed through a network with a round trip of 50 ms.
"""

import argparse
import contextlib
import json
import os
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from unittest import mock

import numpy as np

from benchmarks.common import ROOT, Report, interleaved
from benchmarks.distribution.one_file import felt_since, spread, until
from benchmarks.playback.plots_and_seeks import PausedPlayer, shaken_sequence
from hapticplayer.clock import SystemClock
from hapticplayer.extras.web import http_clip
from hapticplayer.extras.web.http_clip import HttpClip
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from hapticplayer.sequence.pack import pack

MOST_LATER_MS, MOST_SEEK_LATER_MS, MOST_ROUND_TRIPS = 200.0, 20.0, 1.5
ROUND_TRIP_S = 0.05
QUIET_S = 0.2
"""After a seek: what one fetches ahead then does not slow the next one down."""
_CLOCK = SystemClock()
Ways = dict[str, Callable[[], Source]]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--rounds", type=int, help="(15)")
    parser.add_argument("--seeks", type=int, help="(40)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Offer a ride and compare what comes of it with the file."""
    with tempfile.TemporaryDirectory(prefix="hp-http-") as name:
        place = Path(name)
        os.environ["XDG_CACHE_HOME"] = str(place / "cache")
        file = place / "ride.mkv"
        pack(shaken_sequence(place, 20.0 if options.quick else 60.0), file)
        report.figures["clip_mb"] = 1e-6 * file.stat().st_size
        with contextlib.ExitStack() as servers:
            urls = {"serve": servers.enter_context(_served(file))}
            if program := shutil.which("nginx", path=f"{os.environ['PATH']}:/usr/sbin"):
                urls["nginx"] = servers.enter_context(_nginx(program, place))
            ways: Ways = {"file": partial(open_source, file)}
            ways |= {name: partial(_opened, url) for name, url in urls.items()}
            rounds = options.rounds or (3 if options.quick else 15)
            _first_force(ways, rounds, report)
            far = servers.enter_context(_far(next(reversed(urls.values()))))
            ways[f"{1e3 * ROUND_TRIP_S:g} ms away"] = partial(_opened, far)
            count = options.seeks or (8 if options.quick else 40)
            with mock.patch.object(http_clip, "KEPT_BLOCKS", 64):
                _seeks(ways, count, report)


def _opened(url: str) -> Source:
    return open_source(HttpClip(url, _CLOCK))


@contextlib.contextmanager
def _served(file: Path) -> Iterator[str]:
    words = [sys.executable, "-m", "app", "serve", str(file), "--json"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, cwd=ROOT) as server:
        assert server.stdout is not None
        try:
            yield json.loads(server.stdout.readline())["url"]
        finally:
            server.terminate()


@contextlib.contextmanager
def _nginx(program: str, place: Path) -> Iterator[str]:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    user = "user root; " if os.geteuid() == 0 else ""
    (place / "nginx.conf").write_text(
        f"{user}daemon off; pid {place}/pid; error_log {place}/errors; events {{}}\n"
        f"http {{ access_log off; server {{ listen 127.0.0.1:{port}; root {place}; }} }}"
    )
    words = [program, "-c", str(place / "nginx.conf"), "-e", str(place / "errors")]
    with subprocess.Popen(words) as server:
        try:
            time.sleep(0.5)
            yield f"http://127.0.0.1:{port}/ride.mkv"
        finally:
            server.terminate()


@contextlib.contextmanager
def _far(url: str) -> Iterator[str]:
    """Pass connections on to a server that is a round trip away."""
    host, port = url.split("/")[2].split(":")
    with socket.create_server(("127.0.0.1", 0)) as listener:

        def accept() -> None:
            with contextlib.suppress(OSError):  # the listener has been closed
                while True:
                    near, far = (
                        listener.accept()[0],
                        socket.create_connection((host, int(port))),
                    )
                    for one, other, wait_s in (
                        (near, far, ROUND_TRIP_S),
                        (far, near, 0.0),
                    ):
                        threading.Thread(
                            target=_pass_on, args=(one, other, wait_s), daemon=True
                        ).start()

        threading.Thread(target=accept, daemon=True).start()
        yield url.replace(f":{port}/", f":{listener.getsockname()[1]}/")
        listener.shutdown(socket.SHUT_RDWR)


def _pass_on(source: socket.socket, target: socket.socket, wait_s: float) -> None:
    """Pass on what comes, later; questions are short, so each waits for itself."""
    with contextlib.suppress(OSError):
        while content := source.recv(1 << 18):
            time.sleep(wait_s)
            target.sendall(content)
    for one in (source, target):
        with contextlib.suppress(OSError):
            one.shutdown(socket.SHUT_RDWR)


# --- time to the first force ---------------------------------------------------------


def _first_force(ways: Ways, rounds: int, report: Report) -> None:
    """Open all in turn, until a tick has a force."""
    player = Player(_CLOCK, outputs=["simulated"], audio=None)
    player.wait_ready()
    contenders: dict[str, Callable[[], float]] = {
        name: partial(_opened_ms, player, way) for name, way in ways.items()
    }
    found = interleaved(contenders, rounds, warm_up=True)
    player.close()
    rows = [[name, *spread(each)] for name, each in found.items()]
    header = ["opened", "median ms", "least", "largest"]
    report.table("From opening to the first force", header, rows)
    report.figures["first_force"] = {"columns": header, "rows": rows}
    for name in list(ways)[1:]:
        pairs = list(zip(found[name], found["file"], strict=True))
        later_ms = statistics.median(a - b for a, b in pairs)
        report.target(
            f"{name}: first force later than the file's, ms",
            later_ms,
            ("<=", MOST_LATER_MS),
        )
        ratio = statistics.median(a / b for a, b in pairs)
        report.figures[f"first_force_ratio_{name}"] = ratio


def _opened_ms(player: Player, way: Callable[[], Source]) -> float:
    """How long it takes from opening to the first tick with a force."""
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


def _seeks(ways: Ways, count: int, report: Report) -> None:
    """Seek to the same places in all, paused, in turn."""
    players = {name: PausedPlayer(way()) for name, way in ways.items()}
    duration_s = players["file"].player.snapshot().duration_s
    took: dict[str, list[float]] = {name: [] for name in players}
    places = np.random.default_rng(1).uniform(0.0, duration_s - 0.1, count)
    for number, target_s in enumerate(places):
        for name in list(players)[:: 1 if number % 2 else -1]:
            begin_s = time.monotonic()
            players[name].seek(float(target_s))
            took[name].append(1e3 * (time.monotonic() - begin_s))
            time.sleep(QUIET_S)
    for one in players.values():
        one.player.close()
    rows = [[name, *np.percentile(each, [50.0, 95.0])] for name, each in took.items()]
    report.table("Seeks, paused", ["in", "p50 ms", "p95 ms"], rows)
    report.figures["seeks"] = {"columns": ["in", "p50 ms", "p95 ms"], "rows": rows}
    far = list(ways)[-1]
    for name in list(ways)[1:]:
        later_ms = statistics.median(np.subtract(took[name], took["file"]))
        most_ms = MOST_SEEK_LATER_MS
        if name == far:
            most_ms += MOST_ROUND_TRIPS * 1e3 * ROUND_TRIP_S
        report.target(
            f"{name}: seek later than the file's, ms", later_ms, ("<=", most_ms)
        )
