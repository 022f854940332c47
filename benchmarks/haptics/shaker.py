"""A shaker on a sound card of four channels: which sound, when, and when they are silent.

The haptics process plays bursts into channels 3 and 4 of a PulseAudio null sink, whose
monitor is recorded. The recording is laid over what the forces of each tick should
sound like; then STOP, and SIGKILL of the loop and of the player, with the sound on,
several times: the worst counts.
"""

import argparse
import contextlib
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import Report
from benchmarks.stage import need, sound_server
from hapticplayer.extras.shakers.driver import BLOCK
from hapticplayer.extras.shakers.settings import shaker_settings
from hapticplayer.extras.shakers.signal import SAMPLE_HZ, ShakerSignal
from hapticplayer.model import ForceTrack
from tools.shaker_sound import (
    End,
    Heard,
    kill_loop,
    killed_player,
    played,
    silent_after_s,
    stop,
)
from tools.sound_server import Monitor

SETTINGS = "pulse,channels=3+4,band=15-80-40"
DEVICE = f"shaker:{SETTINGS}"
LATE_MS, SILENCE_MS = 5.0, 20.0
WINDOW_S, SEARCH_S, GRID_HZ = 1.0, 0.06, 4000.0
ENDS, ENDED_S = 5, 2.75
"""How often each end is tried; after so long, with the sound on."""


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seconds", type=float, help="(20) of bursts")


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure in one session of the sound server each."""
    need("pulseaudio", "pactl", "parec")
    seconds = options.seconds or (5.0 if options.quick else 20.0)
    with contextlib.ExitStack() as stack:
        server = stack.enter_context(sound_server(4))
        os.environ.update(server.environment)
        monitor = stack.enter_context(contextlib.closing(Monitor(server.environment)))
        whole = played(monitor, DEVICE, bursts(seconds))
        if whole.problem:
            print(whole.problem)
        played_and_heard(report, whole)

        def end(how: End) -> Heard:
            return played(monitor, DEVICE, bursts(4.0), how, ENDED_S)

        for name, ended in (
            ("STOP", lambda: end(stop)),
            ("SIGKILL of the loop", lambda: end(kill_loop)),
            (
                "SIGKILL of the player",
                lambda: killed_player(monitor, DEVICE),
            ),
        ):
            tries = [_silent_after_ms(ended()) for _ in range(ENDS)]
            report.figures[f"{name}, ms"] = [round(one, 1) for one in tries]
            worst = float(np.max(tries))
            report.target(f"{name}: silent after, ms", worst, ("<=", SILENCE_MS))


def _silent_after_ms(ended: Heard) -> float:
    return 1e3 * silent_after_s(ended.times, ended.samples[:, 2], ended.end_s)


def bursts(seconds: float) -> ForceTrack:
    """Return half a second of 3 N up, swelling, and half a second of 0.3 N, in turns."""
    t = np.arange(0.0, seconds, 0.005)
    size = 0.3 + 2.7 * (t % 1.0 > 0.5) * (1.0 - np.exp(-((t - 0.5) % 1.0) / 0.01))
    return ForceTrack(t, np.stack([0.0 * t, size, 0.0 * t], axis=1))


def played_and_heard(report: Report, whole: Heard) -> None:
    """Compare with what the forces of the ticks should sound like."""
    ticks, times, samples, *_ = whole
    ticks = ticks[ticks["monotonic_s"] > 0.0]
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
