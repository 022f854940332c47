"""How often the ticks are read: seldom while nobody looks and nothing is the matter."""

import math

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.force_output import (
    READ_PERIOD_S,
    UNSEEN_PERIOD_S,
    ForceOutput,
)
from hapticplayer.playback.log import Reporter

BEAT_S, BEATS = 0.01, 400


class Processes:
    """A loop that ticks by the virtual clock."""

    health, device = Health.READY, "simulated"

    def __init__(self, clock, _device, **_options):
        self.clock, self.mode, self.reads_s = clock, Mode.FOLLOWING, []
        self.begin_s, self.read = clock.now_s(), 0

    def poll(self):
        return self.health

    def read_ticks(self):
        self.reads_s.append(self.clock.now_s())
        done = round((self.clock.now_s() - self.begin_s) / 0.001)
        ticks = np.zeros(done - self.read, dtype=TICK)
        ticks["monotonic_s"] = self.begin_s + 0.001 * np.arange(self.read, done)
        ticks["mode"], self.read = self.mode, done
        return ticks, 0


@pytest.fixture
def output():
    clock = ManualClock()
    return ForceOutput(clock, Reporter(clock), "simulated", None, Processes)


def periods_s(output, look=lambda: None):
    """Beat for a while and return the times between two reads."""
    for _ in range(BEATS):
        output.processes.clock.advance(BEAT_S)
        output.poll()
        look()
    return np.diff(output.processes.reads_s)[2:]


def test_nobody_looks(output):
    assert periods_s(output) == pytest.approx(UNSEEN_PERIOD_S, abs=1.1 * BEAT_S)


def test_somebody_follows(output):
    periods = periods_s(output, lambda: output.history.since(0.0))
    assert periods == pytest.approx(READ_PERIOD_S, abs=1.1 * BEAT_S)


def test_a_look_now_and_then_changes_nothing(output):
    def look():
        output.history.latest()
        output.history.recent_stats()

    assert periods_s(output, look) == pytest.approx(UNSEEN_PERIOD_S, abs=1.1 * BEAT_S)


@pytest.mark.parametrize("mode", [mode for mode in Mode if mode is not Mode.FOLLOWING])
def test_a_loop_that_does_not_follow_is_watched(output, mode):
    output.processes.mode = mode
    assert periods_s(output) == pytest.approx(READ_PERIOD_S, abs=1.1 * BEAT_S)


def test_no_tick_is_lost_by_reading_seldom(output):
    periods_s(output)
    ticks = output.history.read_since(-math.inf)
    assert np.diff(ticks["monotonic_s"]) == pytest.approx(0.001)
    assert len(ticks) >= 1e3 * (BEATS * BEAT_S - UNSEEN_PERIOD_S - BEAT_S)
