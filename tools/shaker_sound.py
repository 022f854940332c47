"""Plays forces on a shaker of a private sound server, and listens to what comes out."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.model import ForceTrack
from hapticplayer.playback.forces import ForcePlayer
from tools.sound_server import Monitor

AUDIBLE = 0.01
_POLL_S, _AFTER_S, _PATIENCE_S = 0.01, 0.15, 20.0
End = Callable[[ForcePlayer], None]


class Heard(NamedTuple):
    """What was played and what was heard of it.

    Attributes:
        ticks: of the loop (see TICK).
        times: of the samples, monotonic s, (n,).
        samples: of the sink's channels, -1 to 1, (n, 4).
        end_s: monotonic time at which it was ended, 0 if it was not.
        problem: what the player says, "" for nothing.
    """

    ticks: NDArray[Any]
    times: NDArray[Any]
    samples: NDArray[Any]
    end_s: float
    problem: str


def played(
    monitor: Monitor,
    device: str,
    track: ForceTrack,
    end: End | None = None,
    end_after_s: float = 0.0,
) -> Heard:
    """Play a track from its beginning; `end` it at a media time, or play all of it.

    The environment of the server must be this process's, which the loop inherits.
    """
    clock = SystemClock()
    monitor.forget()
    player = ForcePlayer(clock, device, track)
    ticks, end_s = [], 0.0
    try:
        player.wait_ready()
        while not player.is_over:
            ticks.append(player.poll())
            if end and player.media_s > end_after_s:
                end_s = clock.now_s()
                end(player)
                break
            clock.sleep_until(clock.now_s() + _POLL_S)
        clock.sleep_until(clock.now_s() + _AFTER_S)
        is_stopped = player.mode is Mode.TRIPPED and not end_s
        problem = player.problem or player.cause.name * is_stopped
    finally:
        player.close()
    times, samples = monitor.heard()
    return Heard(np.concatenate(ticks), times, samples, end_s, str(problem))


def stop(player: ForcePlayer) -> None:
    player.stop()


def kill_loop(player: ForcePlayer) -> None:
    """Kill the haptics process."""
    os.kill(player.pids["loop"], signal.SIGKILL)


def killed_player(monitor: Monitor, device: str) -> Heard:
    """Let the command line test a shaker, and kill it once the shaker sounds."""
    command = [sys.executable, "-m", "app", "device", "test", "--yes"]
    clock = SystemClock()
    monitor.forget()
    player = subprocess.Popen([*command, "--device", device], stdout=subprocess.DEVNULL)
    patient_until_s = clock.now_s() + _PATIENCE_S
    try:
        while monitor.peak() < 2.0 * AUDIBLE and clock.now_s() < patient_until_s:
            clock.sleep_until(clock.now_s() + _POLL_S)
        end_s = clock.now_s()
    finally:
        player.kill()
        player.wait()
        clock.sleep_until(clock.now_s() + _AFTER_S)
    times, samples = monitor.heard()
    return Heard(np.empty(0), times, samples, end_s, "")


def silent_after_s(times: NDArray[Any], heard: NDArray[Any], at_s: float) -> float:
    """Return how long after a moment there was sound; not a number without any before."""
    loud_s = times[np.abs(heard) > AUDIBLE]
    if not np.any((loud_s > at_s - 0.1) & (loud_s <= at_s)):
        return float("nan")
    return max(0.0, float(loud_s[-1]) - at_s)


def onsets_s(
    times: NDArray[Any], values: NDArray[Any], above: float, quiet_s: float = 0.1
) -> NDArray[Any]:
    """Return when the size of values (n,) passes a limit after so long a time below."""
    loud_s = times[np.abs(values) > above]
    if not len(loud_s):
        return loud_s
    quiet_before_s = np.diff(loud_s, prepend=times[0])
    return loud_s[quiet_before_s > quiet_s]
