import math

import numpy as np
import pytest

from hapticplayer.capture.live.source_clock import COUNTED_SIGMA, SourceClock

LEAST_S = 0.002


def pairs(seconds, rate_hz=100.0, ppm=40.0, spread_s=0.015, seed=1, batch=1):
    """Stamps that begin at 5000 s, arrivals of a link, and the true machine's time."""
    rng = np.random.default_rng(seed)
    true_s = 200.0 + np.arange(round(seconds * rate_hz)) / rate_hz
    stamp_s = 5000.0 + (true_s - 200.0) / (1.0 + ppm * 1e-6)
    delay_s = (
        LEAST_S + rng.uniform(0.0, spread_s, len(true_s)).repeat(batch)[: len(true_s)]
    )
    return stamp_s, np.maximum.accumulate(true_s + delay_s), true_s


def test_a_clock_is_followed_to_its_least_delay():
    stamp_s, arrival_s, true_s = pairs(60.0)
    clock = SourceClock()
    clock.add(stamp_s, arrival_s)
    assert clock.host_s(stamp_s) - true_s == pytest.approx(LEAST_S, abs=1e-3)
    assert clock.rate_ppm == pytest.approx(40.0, abs=10.0)
    offset_s, rate = clock.line()
    assert rate * stamp_s + offset_s == pytest.approx(clock.host_s(stamp_s), abs=1e-6)


def test_estimates_so_far_are_those_of_the_pairs_so_far():
    stamp_s, arrival_s, _ = pairs(20.0)
    causal, first = SourceClock(), SourceClock()
    for at in range(0, len(stamp_s), 7):
        part = slice(at, at + 7)
        causal.add(stamp_s[part], arrival_s[part])
        if at == 1001:
            so_far = causal.host_s(stamp_s[:10])
            first.add(stamp_s[:1008], arrival_s[:1008])
            assert first.host_s(stamp_s[:10]) == pytest.approx(so_far, abs=1e-3)
    first.add(stamp_s[1008:], arrival_s[1008:])
    assert causal.host_s(stamp_s) == pytest.approx(first.host_s(stamp_s), abs=1e-4)


def test_a_buffer_that_is_read_at_once_blurs_no_clock():
    stamp_s, arrival_s, true_s = pairs(20.0)
    arrival_s[:400] = arrival_s[400]  # 4 s that were read at once
    clock = SourceClock()
    clock.add(stamp_s, arrival_s)
    assert clock.host_s(stamp_s) - true_s == pytest.approx(LEAST_S, abs=1e-3)
    assert clock.residual_s < 0.003


def test_few_pairs_of_a_slow_link_do_not_bend_the_rate():
    stamp_s, arrival_s, _ = pairs(4.0, ppm=0.0, spread_s=0.078)
    clock = SourceClock()
    clock.add(stamp_s, arrival_s)
    assert abs(clock.rate_ppm) < 100.0
    assert clock.residual_s > 0.001


def test_counted_samples_may_be_far_off_the_nominal_rate():
    stamp_s, arrival_s, true_s = pairs(60.0, ppm=9000.0)
    clock = SourceClock(COUNTED_SIGMA)
    for at in range(0, len(stamp_s), 10):
        clock.add(stamp_s[at : at + 10], arrival_s[at : at + 10])
    assert clock.host_s(stamp_s) - true_s == pytest.approx(LEAST_S, abs=2e-3)


def test_a_clock_without_pairs_claims_no_time():
    clock = SourceClock()
    clock.add(np.zeros(0), np.zeros(0))
    assert np.isnan(clock.host_s(np.zeros(2))).all()
    assert clock.residual_s == math.inf
