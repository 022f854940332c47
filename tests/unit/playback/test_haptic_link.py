"""How often the ticks are read: seldom while nobody looks and nothing is the matter."""

import math

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.process import Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.haptic_link import (
    NO_DEVICE,
    READ_PERIOD_S,
    UNSEEN_PERIOD_S,
    HapticLink,
)

BEAT_S, BEATS = 0.01, 400


class Process:
    """A loop that ticks by the virtual clock."""

    health = Health.READY

    def __init__(self, clock):
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
def link(monkeypatch):
    link = HapticLink(ManualClock(), NO_DEVICE)
    link._process = Process(link._clock)
    monkeypatch.setattr(link._residence, "look", lambda: None)
    return link


def periods_s(link, look=lambda: None):
    """Beat for a while and return the times between two reads."""
    for _ in range(BEATS):
        link._clock.advance(BEAT_S)
        assert link.poll(None)
        look()
    return np.diff(link._process.reads_s)[2:]


def test_nobody_looks(link):
    assert periods_s(link) == pytest.approx(UNSEEN_PERIOD_S, abs=1.1 * BEAT_S)


def test_somebody_follows(link):
    periods = periods_s(link, lambda: link.history.since(0.0))
    assert periods == pytest.approx(READ_PERIOD_S, abs=1.1 * BEAT_S)


def test_a_look_now_and_then_changes_nothing(link):
    def look():
        link.history.latest()
        link.history.recent_stats()

    assert periods_s(link, look) == pytest.approx(UNSEEN_PERIOD_S, abs=1.1 * BEAT_S)


@pytest.mark.parametrize("mode", [mode for mode in Mode if mode is not Mode.FOLLOWING])
def test_a_loop_that_does_not_follow_is_watched(link, mode):
    link._process.mode = mode
    assert periods_s(link) == pytest.approx(READ_PERIOD_S, abs=1.1 * BEAT_S)


def test_no_tick_is_lost_by_reading_seldom(link):
    periods_s(link)
    ticks = link.history.read_since(-math.inf)
    assert np.diff(ticks["monotonic_s"]) == pytest.approx(0.001)
    assert len(ticks) >= 1e3 * (BEATS * BEAT_S - UNSEEN_PERIOD_S - BEAT_S)
