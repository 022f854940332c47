"""A shaker on a real sound server: channels, times, and silence at every end."""

import contextlib
import shutil

import numpy as np
import pytest

from hapticplayer.haptics.contract import Mode
from hapticplayer.model import ForceTrack
from tools import shaker_sound
from tools.sound_server import PROGRAMS, Monitor, sound_server

pytestmark = pytest.mark.realtime

LATENCY_S, SILENCE_S, ONSET_S = 0.08, 0.020, 0.005
DEVICE = "shaker:pulse,channels=3+4,band=50-200-100,latency_ms=80"
GAP_N, LOUD_N = 0.05, 0.4
TRIES = 3
"""A busy machine may be late once; what is always late is a fault."""


@pytest.fixture(scope="module")
def monitor():
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if missing:
        pytest.skip(f"needs {' and '.join(missing)}: apt-get install pulseaudio-utils")
    with sound_server(channels=4) as made, pytest.MonkeyPatch.context() as patch:
        for name, value in made.environment.items():
            patch.setenv(name, value)
        with contextlib.closing(Monitor(made.environment)) as listening:
            yield listening


def bursts(seconds):
    """Return 0.2 s of 60 Hz after as long a gap, in turns; never quite zero."""
    t = np.arange(0.0, seconds, 0.001)
    is_loud = t % 0.4 > 0.2
    size_n = GAP_N + 1.5 * is_loud * (1.0 - np.cos(2.0 * np.pi * 60.0 * t))
    return ForceTrack(t, np.stack([0.0 * t, size_n, 0.0 * t], axis=1))


def silent_after_s(heard):
    return shaker_sound.silent_after_s(heard.times, heard.samples[:, 2], heard.end_s)


def killed_loop(monitor):
    return shaker_sound.played(
        monitor, DEVICE, bursts(2.0), shaker_sound.kill_loop, 0.45
    )


def killed_player(monitor):
    return shaker_sound.killed_player(monitor, DEVICE)


@pytest.mark.parametrize("killed", [killed_player, killed_loop])
def test_a_process_that_is_killed_is_cut_off(killed, monitor):
    """Without the guard's cut a server notices a loop's death after 25 to 35 ms."""
    found = []
    for _ in range(TRIES):
        found.append(silent_after_s(killed(monitor)))
        if found[-1] <= SILENCE_S:
            return
    raise AssertionError(f"silent after {found} s")


def late_s(heard):
    """Return by how much each burst came later than its force and the stated latency."""
    ticks = heard.ticks[heard.ticks["mode"] == Mode.FOLLOWING]  # has faded in
    force_n = ticks["force_n"][:, 1]
    planned_s = shaker_sound.onsets_s(ticks["monotonic_s"], force_n, LOUD_N)
    sounded_s = shaker_sound.onsets_s(heard.times, heard.samples[:, 2], 0.03)
    return sounded_s[-len(planned_s) :] - planned_s - LATENCY_S


def test_its_channels_sound_when_they_should_until_stop(monitor):
    found = []
    for _ in range(TRIES):
        heard = shaker_sound.played(
            monitor, DEVICE, bursts(3.0), shaker_sound.stop, 1.2
        )
        peaks = np.abs(heard.samples).max(axis=0)
        assert peaks[:2].tolist() == [0.0, 0.0]
        assert peaks[2:].min() > 0.1
        late, silent = late_s(heard), silent_after_s(heard)
        found.append((late, silent, heard.problem))
        is_in_time = len(late) == 2 and np.abs(late).max() < ONSET_S
        if is_in_time and silent <= SILENCE_S and not heard.problem:
            return
    raise AssertionError(f"late by, and silent after, s: {found}")
