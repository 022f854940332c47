"""The media clock under any sequence of play, pause, seek, loss and return of sound.

A sound card is modelled beside it: off by an offset, drifting, jittering, or silent.
"""

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from hapticplayer.playback.clock import (
    CORRECT_FROM_S,
    HORIZON_S,
    MAX_BEND,
    REPORT_TIMEOUT_S,
    RESYNC_S,
    AudioReport,
    ClockSource,
    MediaClock,
)

REPORT_PERIOD_S = 0.01
DRIFT = 2e-4  # worse than any sound card
JITTER_S = 0.0002
EXACT_S = 1e-9


class ClockMachine(RuleBasedStateMachine):
    """Drives the clock; `now` is virtual."""

    def __init__(self):
        super().__init__()
        self.clock = MediaClock()
        self.now = 1000.0
        self.sound_offset_s = 0.0  # of the card against the clock when it joined
        self.drift = 0.0
        self.is_heard = False
        self.sign = 1.0
        self.started_s = self.now
        self.published = self.clock.snapshot(self.now)
        self.position_s = 0.0

    def heard_s(self):
        """Where the card is: it started with the clock and runs by itself."""
        elapsed_s = self.now - self.started_s
        return self.card0_s + elapsed_s * (1.0 + self.drift)

    def keep(self, act):
        """Do something within an epoch: the position must not move at all."""
        before_s, epoch = self.clock.media_s(self.now), self.clock.epoch
        result = act()
        if self.clock.epoch == epoch:
            after_s = self.clock.media_s(self.now)
            assert after_s == pytest.approx(before_s, abs=EXACT_S)
        return result

    @rule(to_s=st.floats(0.0, 3600.0))
    def seek(self, to_s):
        epoch = self.clock.epoch
        self.clock.seek(to_s)
        assert self.clock.epoch == epoch + 1
        assert self.clock.media_s(self.now) == to_s
        self.is_heard = False

    @rule()
    def pause(self):
        before_s, epoch = self.clock.media_s(self.now), self.clock.epoch
        self.clock.pause(self.now)
        assert self.clock.epoch == epoch + 1
        assert self.clock.media_s(self.now) == pytest.approx(before_s, abs=EXACT_S)
        self.is_heard = False

    @rule()
    def renew(self):
        before = self.clock.snapshot(self.now)
        self.clock.renew()
        after = self.clock.snapshot(self.now)
        assert after.epoch == before.epoch + 1
        assert after.media_s(self.now + 1.0) == before.media_s(self.now + 1.0)

    @precondition(lambda self: not self.clock.is_running)
    @rule()
    def play_without_sound(self):
        self.keep(lambda: self.clock.start(self.now))
        assert self.clock.source is ClockSource.MONOTONIC

    @precondition(lambda self: not self.clock.is_running)
    @rule(ahead_s=st.floats(0.0, 0.2), drift=st.floats(-DRIFT, DRIFT))
    def play_with_sound(self, ahead_s, drift):
        """The first sound will be heard in a while; the clock waits for it."""
        at_s = self.clock.media_s(self.now)
        report = AudioReport(self.clock.epoch, self.now + ahead_s, at_s)
        self.keep(lambda: self.clock.start_with(report))
        self.started_s, self.card0_s = self.now + ahead_s, at_s
        self.drift, self.is_heard = drift, True
        assert self.clock.media_s(self.now + ahead_s) == pytest.approx(at_s)

    @precondition(lambda self: self.is_heard)
    @rule()
    def lose_the_device(self):
        self.is_heard = False

    @precondition(lambda self: self.clock.is_running and not self.is_heard)
    @rule(off_s=st.floats(-0.2, 0.2), drift=st.floats(-DRIFT, DRIFT))
    def the_device_comes_back(self, off_s, drift):
        self.started_s, self.drift, self.is_heard = self.now, drift, True
        self.card0_s = self.clock.media_s(self.now) + off_s

    @precondition(lambda self: self.clock.is_running)
    @rule(age=st.integers(1, 5), off_s=st.floats(-100.0, 100.0))
    def hear_of_an_older_epoch(self, age, off_s):
        report = AudioReport(self.clock.epoch - age, self.now, off_s)
        before = self.clock.snapshot(self.now)
        assert self.clock.report(report, self.now)
        assert self.clock.snapshot(self.now) == before

    @precondition(lambda self: self.clock.is_running)
    @rule(off_s=st.floats(RESYNC_S * 1.01, 100.0), sign=st.sampled_from([-1, 1]))
    def hear_something_absurd(self, off_s, sign):
        at_s = self.clock.media_s(self.now) + sign * off_s
        report = AudioReport(self.clock.epoch, self.now, at_s)
        assert not self.keep(lambda: self.clock.report(report, self.now))

    @rule(seconds=st.floats(0.01, 4.0))
    def time_goes_by(self, seconds):
        silent_s = 0.0
        for _ in range(max(1, round(seconds / REPORT_PERIOD_S))):
            before_s, old = self.clock.media_s(self.now), self.clock.snapshot(self.now)
            self.now += REPORT_PERIOD_S
            silent_s = 0.0 if self.is_heard else silent_s + REPORT_PERIOD_S
            if self.is_heard and self.now >= self.started_s:
                self.sign = -self.sign
                heard_s = self.heard_s() + self.sign * JITTER_S
                report = AudioReport(self.clock.epoch, self.now, heard_s)
                assert self.keep(lambda r=report: self.clock.report(r, self.now))
            self.keep(lambda: self.clock.check(self.now))
            moved_s = self.clock.media_s(self.now) - before_s
            most_s = (1.0 + MAX_BEND) * REPORT_PERIOD_S * self.clock.is_running
            assert -EXACT_S <= moved_s <= most_s + EXACT_S
            # who still uses the last published clock is not far off
            stale_s = old.media_s(self.now) - self.clock.media_s(self.now)
            assert abs(stale_s) <= 2.0 * MAX_BEND * HORIZON_S
        # a sound that was to come is waited for as long
        silent_s = min(silent_s, self.now - self.started_s)
        if silent_s > REPORT_TIMEOUT_S + 2.0 * REPORT_PERIOD_S:
            assert self.clock.source is ClockSource.MONOTONIC
        is_settled = self.is_heard and self.now - self.started_s > 12.0
        if is_settled and self.clock.source is ClockSource.AUDIO:
            off_s = self.heard_s() - self.clock.media_s(self.now)
            assert abs(off_s) < CORRECT_FROM_S + 2.0 * JITTER_S + 12.0 * DRIFT * 0.1

    @invariant()
    def its_rate_is_one_or_bent_a_little_or_zero(self):
        rate = self.clock.snapshot(self.now).rate
        if self.clock.is_running:
            assert abs(rate - 1.0) <= MAX_BEND + EXACT_S
        else:
            assert rate == 0.0

    @invariant()
    def what_it_publishes_expires(self):
        assert self.clock.snapshot(self.now).valid_until_s == self.now + HORIZON_S


TestClockMachine = ClockMachine.TestCase
TestClockMachine.settings = settings(max_examples=15, stateful_step_count=15)


def test_jitter_below_the_threshold_bends_nothing():
    """The hysteresis: correction begins at 0.5 ms and ends below 0.1 ms."""
    clock, now = MediaClock(), 1000.0
    clock.start_with(AudioReport(clock.epoch, now, 0.0))
    for k in range(500):
        now = 1000.0 + 0.01 * k
        off_s = 0.9 * CORRECT_FROM_S * (-1) ** k
        clock.report(AudioReport(clock.epoch, now, now - 1000.0 + off_s), now)
        assert clock.snapshot(now).rate == 1.0
