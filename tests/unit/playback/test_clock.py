"""The media clock on virtual time: it converges, never jumps, and survives a loss."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.playback.clock import (
    HORIZON_S,
    MAX_BEND,
    REPORT_TIMEOUT_S,
    AudioReport,
    ClockSource,
    MediaClock,
)

T0 = 500.0


def led_by_sound(offset_s=0.0):
    clock = MediaClock()
    clock.seek(10.0)
    clock.start_with(AudioReport(clock.epoch, T0, 10.0 + offset_s))
    return clock


def feed(clock, seconds, error_s=0.0, drift=0.0, start_s=T0, jitter=None):
    """Report every 10 ms a sound that is off by an error and drifts."""
    positions = []
    for k in range(round(seconds * 100)):
        now = start_s + 0.01 * k
        heard = 10.0 + (now - T0) * (1.0 + drift) + error_s
        heard += 0.0 if jitter is None else float(jitter[k])
        clock.report(AudioReport(clock.epoch, now, heard), now)
        clock.check(now)
        positions.append((now, clock.media_s(now)))
    return np.array(positions)


def test_a_standing_clock_stands():
    clock = MediaClock()
    clock.seek(3.0)
    assert clock.media_s(T0) == clock.media_s(T0 + 100.0) == 3.0
    assert clock.snapshot(T0).rate == 0.0


def test_the_clock_runs_from_the_first_sound_even_if_ahead():
    clock = led_by_sound()
    assert clock.media_s(T0 - 0.1) == 10.0
    assert clock.media_s(T0 + 1.0) == pytest.approx(11.0)
    assert clock.source is ClockSource.AUDIO


def test_a_published_clock_expires():
    snapshot = led_by_sound().snapshot(T0)
    assert snapshot.valid_until_s == T0 + HORIZON_S == pytest.approx(T0 + 0.150)


@pytest.mark.parametrize("error_s", [-0.05, -0.01, 0.003, 0.02, 0.05])
def test_an_error_is_bent_away_without_a_jump(error_s):
    clock = led_by_sound()
    positions = feed(clock, 8.0, error_s)
    speed = np.diff(positions[:, 1]) / np.diff(positions[:, 0])
    assert np.abs(speed - 1.0).max() <= MAX_BEND + 1e-6
    left = 10.0 + 8.0 - 0.01 + error_s - positions[-1, 1]
    assert abs(left) < 0.0006


@pytest.mark.parametrize("drift", [-2e-4, 1e-4])
def test_a_drifting_sound_card_is_followed_within_1_ms(drift):
    clock = led_by_sound()
    positions = feed(clock, 60.0, drift=drift)
    heard = 10.0 + (positions[:, 0] - T0) * (1.0 + drift)
    assert np.abs(positions[:, 1] - heard).max() < 0.001


def test_jitter_of_the_reports_does_not_shake_the_clock(rng):
    clock = led_by_sound()
    positions = feed(clock, 20.0, jitter=rng.normal(0.0, 0.0002, 2000))
    error = positions[:, 1] - (10.0 + positions[:, 0] - T0)
    assert np.abs(error).max() < 0.0006


def test_when_the_sound_is_lost_the_clock_goes_on_without_a_jump():
    clock = led_by_sound()
    feed(clock, 2.0, error_s=0.004)
    before = clock.media_s(T0 + 2.0)
    clock.check(T0 + 2.0 + REPORT_TIMEOUT_S + 0.01)
    assert clock.source is ClockSource.MONOTONIC
    later = clock.media_s(T0 + 3.0)
    assert later - before == pytest.approx(1.0, abs=0.002)


def test_when_the_sound_comes_back_it_leads_again():
    clock = led_by_sound()
    feed(clock, 1.0)
    clock.check(T0 + 2.0)
    feed(clock, 5.0, error_s=-0.03, start_s=T0 + 3.0)
    assert clock.source is ClockSource.AUDIO
    assert clock.media_s(T0 + 8.0) == pytest.approx(18.0 - 0.03, abs=0.001)


def test_a_sound_far_off_asks_for_a_seek():
    clock = led_by_sound()
    assert not clock.report(AudioReport(clock.epoch, T0 + 1.0, 99.0), T0 + 1.0)
    assert clock.media_s(T0 + 1.0) == pytest.approx(11.0)


def test_reports_of_an_older_epoch_are_ignored():
    clock = led_by_sound()
    old = clock.epoch
    clock.seek(50.0)
    clock.start(T0 + 1.0)
    assert clock.report(AudioReport(old, T0 + 1.5, 10.0), T0 + 1.5)
    assert clock.media_s(T0 + 2.0) == pytest.approx(51.0)


def test_pausing_keeps_the_position_and_begins_an_epoch():
    clock = led_by_sound()
    epoch = clock.epoch
    clock.pause(T0 + 2.5)
    assert clock.epoch == epoch + 1
    assert clock.media_s(T0 + 9.0) == pytest.approx(12.5)


actions = st.lists(
    st.one_of(
        st.tuples(st.just("seek"), st.floats(0.0, 100.0)),
        st.tuples(st.just("play"), st.just(0.0)),
        st.tuples(st.just("pause"), st.just(0.0)),
        st.tuples(st.just("wait"), st.floats(0.001, 3.0)),
        st.tuples(st.just("report"), st.floats(-0.2, 0.2)),
    ),
    max_size=40,
)


@given(actions)
@settings(max_examples=200)
def test_the_position_only_jumps_with_a_new_epoch(script):
    clock, now = MediaClock(), T0
    for name, value in script:
        before, epoch = clock.media_s(now), clock.epoch
        if name == "seek":
            clock.seek(value)
        elif name == "play" and not clock.is_running:
            clock.start(now)
        elif name == "pause":
            clock.pause(now)
        elif name == "report":
            clock.report(AudioReport(clock.epoch, now, before + value), now)
        if clock.epoch == epoch:
            assert clock.media_s(now) == pytest.approx(before, abs=1e-6)
        if name == "wait":
            now += value
            clock.check(now)
            moved = clock.media_s(now) - before
            limit = (1.0 + MAX_BEND) * value if clock.is_running else 0.0
            assert -1e-6 <= moved <= limit + 1e-6
