"""A shaker on a sound card of four channels: which sound, when, and when they are silent.

The haptics process plays bursts into channels 3 and 4 of a PulseAudio null sink, whose
monitor is recorded. The recording is laid over what the forces of each tick should
sound like; then STOP, and SIGKILL of the process, with the sound on.
"""

import argparse
import os
import signal
import subprocess
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import Report
from benchmarks.stage import FOUR_CHANNELS, need, sound_server
from hapticplayer.clock import SystemClock
from hapticplayer.devices.transducer.driver import BLOCK
from hapticplayer.devices.transducer.settings import shaker_settings
from hapticplayer.devices.transducer.signal import SAMPLE_HZ, ShakerSignal
from hapticplayer.haptics.contract import Mode
from hapticplayer.model import ForceTrack
from hapticplayer.playback.forces import ForcePlayer

SETTINGS = "pulse,channels=3+4,band=15-80-40"
WIDTH = 4
READ_FRAMES = 48
POLL_S = 0.01
AUDIBLE = 0.01
LATE_MS, SILENCE_MS = 5.0, 20.0
WINDOW_S, SEARCH_S, GRID_HZ = 1.0, 0.06, 4000.0


class Monitor:
    """What the sink plays, with the time at which each piece was heard."""

    def __init__(self, environment: dict[str, str]) -> None:
        command = ["parec", "-d", "null.monitor", "--format=float32le"]
        command += ["--rate=48000", f"--channels={WIDTH}", "--latency-msec=5"]
        command += [f"--channel-map={FOUR_CHANNELS}"]
        self._process = subprocess.Popen(
            command, stdout=subprocess.PIPE, env={**os.environ, **environment}
        )
        self._clock = SystemClock()
        self._pieces: list[tuple[float, bytes]] = []
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        pipe = self._process.stdout
        while pipe and (data := pipe.read(4 * WIDTH * READ_FRAMES)):
            self._pieces.append((self._clock.now_s(), data))

    def close(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """End, and return times and samples.

        The pieces that came soonest tell the time of a sample: others waited.
        """
        self._process.kill()
        self._process.wait()
        heard_s = np.array([at_s for at_s, _ in self._pieces])
        samples = np.concatenate(
            [np.frombuffer(data, np.float32) for _, data in self._pieces]
        ).reshape(-1, WIDTH)
        count_s = READ_FRAMES / SAMPLE_HZ * np.arange(1, len(heard_s) + 1)
        start_s = np.percentile(heard_s - count_s, 2)
        return start_s + np.arange(len(samples)) / SAMPLE_HZ, samples


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--seconds", type=float, help="(20) of bursts")


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure in one session of the sound server each."""
    need("pulseaudio", "pactl", "parec")
    seconds = options.seconds or (5.0 if options.quick else 20.0)
    with sound_server(WIDTH) as server:
        os.environ.update(server.environment)
        ticks, times, samples, _ = played(server.environment, seconds)
        ticks = ticks[ticks["monotonic_s"] > 0.0]
        played_and_heard(report, ticks, times, samples)
        for name, what in (("STOP", _stop), ("SIGKILL", _kill)):
            _, times, samples, at_s = played(server.environment, 3.0, what)
            report.target(
                f"{name}: silent after, ms",
                1e3 * silent_after_s(times, samples[:, 2], at_s),
                ("<=", SILENCE_MS),
            )


def silent_after_s(times: NDArray[Any], heard: NDArray[Any], at_s: float) -> float:
    """Return how long after a moment there was sound; not a number without any before."""
    loud_s = times[np.abs(heard) > AUDIBLE]
    if not np.any((loud_s > at_s - 0.1) & (loud_s <= at_s)):
        return float("nan")
    return max(0.0, float(loud_s[-1]) - at_s)


def played(
    environment: dict[str, str],
    seconds: float,
    end: Callable[[ForcePlayer], None] | None = None,
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], float]:
    """Play bursts; return ticks, times and samples of the monitor, and the end's time."""
    monitor = Monitor(environment)
    clock = SystemClock()
    player = ForcePlayer(clock, f"shaker:{SETTINGS}", bursts(seconds + 1.0))
    ticks, at_s = [], 0.0
    try:
        player.wait_ready()
        while not player.is_over:
            ticks.append(player.poll())
            if end and not at_s and player.media_s > seconds - 0.25:
                at_s = clock.now_s()
                end(player)
                break
            clock.sleep_until(clock.now_s() + POLL_S)
        clock.sleep_until(clock.now_s() + 0.4)
        if player.problem or (player.mode is Mode.TRIPPED and not at_s):
            print(player.problem, player.cause)
    finally:
        player.close()
    times, samples = monitor.close()
    return np.concatenate(ticks), times, samples, at_s


def _stop(player: ForcePlayer) -> None:
    player.stop()


def _kill(player: ForcePlayer) -> None:
    os.kill(player.pids["loop"], signal.SIGKILL)


def bursts(seconds: float) -> ForceTrack:
    """Return half a second of 3 N up, swelling, and half a second of 0.3 N, in turns."""
    t = np.arange(0.0, seconds, 0.005)
    size = 0.3 + 2.7 * (t % 1.0 > 0.5) * (1.0 - np.exp(-((t - 0.5) % 1.0) / 0.01))
    return ForceTrack(t, np.stack([0.0 * t, size, 0.0 * t], axis=1))


def played_and_heard(
    report: Report, ticks: NDArray[Any], times: NDArray[Any], samples: NDArray[Any]
) -> None:
    """Compare with what the forces of the ticks should sound like."""
    peaks = np.abs(samples).max(axis=0)
    rows = [[f"channel {n + 1}", float(peak)] for n, peak in enumerate(peaks)]
    report.table("Largest sample, 1 is full", ["", "peak"], rows)
    report.target("channels 1 and 2, peak", float(peaks[:2].max()), ("<=", 0.0))
    report.target("channels 3 and 4, peak", float(peaks[2:].min()), (">=", 0.2))
    wanted_s, wanted = expected(ticks)
    late_ms = np.array(
        [
            1e3 * lateness_s(wanted_s, wanted, times, samples[:, 2], begin_s)
            for begin_s in np.arange(wanted_s[0] + 1.5, wanted_s[-1] - 1.5, 1.0)
        ]
    )
    middle = float(np.median(late_ms))
    spread = float(np.percentile(np.abs(late_ms - middle), 95))
    report.figures |= {"late_ms": [round(float(one), 2) for one in late_ms]}
    report.target("sound off its stated time, median, ms", abs(middle), ("<=", LATE_MS))
    report.target("its spread, p95, ms", spread, ("<=", LATE_MS))


def expected(ticks: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return times and samples that the ticks' forces should sound like."""
    settings = shaker_settings(SETTINGS)
    made, parts = ShakerSignal(settings), []
    next_s = begin_s = float(ticks["monotonic_s"][0]) + settings.latency_s
    for tick in ticks:
        x, y, z = tick["force_n"].tolist()
        now_s = float(tick["monotonic_s"])
        made.push((x, y, z), now_s)
        while next_s + BLOCK / SAMPLE_HZ <= now_s + settings.latency_s:
            parts.append(made.samples(next_s, BLOCK)[:, 2])
            next_s += BLOCK / SAMPLE_HZ
    samples = np.concatenate(parts)
    return begin_s + np.arange(len(samples)) / SAMPLE_HZ, samples


def lateness_s(
    wanted_s: NDArray[Any],
    wanted: NDArray[Any],
    times: NDArray[Any],
    heard: NDArray[Any],
    begin_s: float,
) -> float:
    """Return by how much a second of the sound is late: the best of +-60 ms."""
    grid = begin_s + np.arange(round(WINDOW_S * GRID_HZ)) / GRID_HZ
    model = np.interp(grid, wanted_s, wanted)
    shifts = np.arange(-SEARCH_S, SEARCH_S, 1.0 / GRID_HZ)
    found = [np.dot(model, np.interp(grid + s, times, heard)) for s in shifts]
    return float(shifts[int(np.argmax(found))])
