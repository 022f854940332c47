"""When sound is heard, from samples and from times that are sometimes wrong."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.playback.sound_device import (
    LONGEST_HELD_S,
    NEAR_S,
    STEADY_S,
    DacClock,
)

RATE_HZ = 48_000
COUNT = 1440  # PulseAudio through ALSA asks for 30 ms at once
BLOCK_S = COUNT / RATE_HZ
AHEAD_S = 0.120
BEGIN_S = 1000.0


class Output:
    """An output that plays without a break; what it states may be wrong."""

    def __init__(self, drift=0.0, jitter_s=0.0002):
        self.line, self.errors_s = DacClock(RATE_HZ), []
        self.true_s = BEGIN_S + AHEAD_S  # when the next block sounds
        self.drift, self.jitter_s = drift, jitter_s
        self.random = np.random.default_rng(4)

    def block(self, wrong_s=0.0, silence_s=0.0, *, ran_dry=False):
        self.true_s += silence_s
        stated_s = self.true_s + wrong_s + self.jitter_s * self.random.normal()
        asked_s = self.true_s - (0.0 if ran_dry else AHEAD_S)
        dac_s, silent_s = self.line.place(asked_s, stated_s, COUNT, ran_dry=ran_dry)
        self.errors_s.append(dac_s - self.true_s)
        self.true_s += BLOCK_S * (1.0 + self.drift)
        return silent_s

    def run(self, seconds, wrong_s=lambda _t_s: 0.0):
        """Play for so long; return the largest error."""
        count = round(seconds / BLOCK_S)
        for number in range(count):
            self.block(wrong_s(number * BLOCK_S))
        return np.abs(self.errors_s[-count:]).max()


def after_a_standstill(t_s):
    """What a server was measured to state after 43 ms of standing still: too late."""
    climb_s = 0.012 + 0.0036 * min(t_s, 3.0)
    steps = max(0, int((t_s - 3.0) / 1.5) + 1) if t_s > 3.0 else 0
    return climb_s * 0.55**steps


def test_stated_times_are_passed_on_until_they_are_steady():
    output = Output(jitter_s=0.0)
    assert output.run(0.9 * STEADY_S, lambda t_s: 0.03 - 0.01 * t_s) > 0.029
    assert not output.line.is_known
    output.run(STEADY_S + 0.1)
    assert output.line.is_known


def test_a_standstill_of_the_server_moves_nothing():
    """22 ms would be seen for seconds; the clock would follow them."""
    output = Output()
    output.run(3.0)
    worst_s = output.run(12.0, after_a_standstill)
    assert max(map(after_a_standstill, np.linspace(0.0, 12.0, 400))) > 0.022
    assert worst_s < NEAR_S + 0.001
    assert output.run(3.0) < 0.001


def test_another_output_is_followed_once_certain():
    output = Output()
    output.run(3.0)
    output.run(STEADY_S + 0.2, lambda _t_s: 0.080)
    assert output.errors_s[-1] == pytest.approx(0.080, abs=0.001)


def test_an_output_that_ran_dry_is_followed_at_once():
    """It says so, and reports how much silence there was."""
    output = Output()
    output.run(3.0)
    silent_s = output.block(silence_s=0.111, ran_dry=True)
    assert silent_s == pytest.approx(0.111, abs=0.001)
    assert abs(output.errors_s[-1]) < 0.001
    assert output.run(1.0) < 0.001
    assert output.block(silence_s=0.07, ran_dry=True) == pytest.approx(0.07, abs=0.001)
    assert output.run(12.0, after_a_standstill) < NEAR_S + 0.001


def test_without_a_word_of_it_nothing_is_left_out():
    """Some outputs always ask at the last moment; that is no silence."""
    output = Output(jitter_s=0.0)
    output.run(3.0)
    line, now_s = output.line, output.true_s + 0.004
    dac_s, silent_s = line.place(now_s, now_s, COUNT)
    assert (dac_s, silent_s) == (now_s, 0.0)
    assert not line.is_known


@pytest.mark.parametrize("drift", [-5e-4, -3e-5, 3e-5, 5e-4])
def test_clocks_that_differ_are_followed(drift):
    output = Output(drift)
    output.run(5.0)
    assert output.run(60.0) < 5e-4 * 1.2 + 0.0003
    assert output.line.is_known


def test_an_output_whose_times_only_jitter_is_taken_at_its_word():
    """A driver that counts in periods states 10 ms to and fro for ever."""
    output = Output(jitter_s=0.0)
    output.run(3.0)
    output.run(LONGEST_HELD_S + 1.0, lambda t_s: 0.01 * (round(t_s / BLOCK_S) % 3))
    assert not output.line.is_known
    assert abs(output.errors_s[-1] - 0.01 * ((len(output.errors_s) - 101) % 3)) < 0.011


@given(st.lists(st.floats(-0.5, 0.5), max_size=40))
def test_the_clock_comes_back_after_any_wrong_time(wrongs_s):
    output = Output()
    output.run(3.0)
    for wrong_s in wrongs_s:
        output.block(wrong_s)
    output.run(LONGEST_HELD_S + STEADY_S + 0.2)
    assert np.abs(output.errors_s[-5:]).max() < 0.0025
