"""Gain over time against closed forms."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.errors import InputError
from hapticplayer.motion.conditioning import GainSpan, gain_at, modulate


def test_the_gain_is_a_raised_cosine_in_the_span_else_one():
    span = GainSpan(2.0, 8.0, 3.0, fade_in_s=1.0, fade_out_s=2.0)
    times = np.array([-5.0, 1.999, 2.25, 2.5, 3.0, 5.0, 6.0, 7.0, 7.5, 8.0, 9.0])
    quarter = 0.5 - 0.5 * np.cos(np.pi / 4)
    wanted = 1 + 2 * np.array([0, 0, quarter, 0.5, 1, 1, 1, 0.5, quarter, 0, 0])
    assert np.allclose(gain_at([span], times), wanted, atol=1e-12)


@given(
    gain=st.floats(0.0, 5.0),
    fade_in_s=st.floats(0.05, 1.5),
    fade_out_s=st.floats(0.05, 1.5),
)
def test_value_and_slope_are_continuous(gain, fade_in_s, fade_out_s):
    step_s = 1e-4
    times = np.arange(0.0, 6.0, step_s)
    span = GainSpan(1.0, 5.0, gain, fade_in_s, fade_out_s)
    values = gain_at([span], times)
    shortest = min(fade_in_s, fade_out_s)
    change = abs(gain - 1.0)
    steepest = 0.5 * np.pi * change / shortest
    sharpest = 0.5 * np.pi**2 * change / shortest**2
    assert np.abs(np.diff(values)).max() <= steepest * step_s + 1e-12
    # a kink would leave a second difference of slope * step, not of step^2
    assert np.abs(np.diff(values, 2)).max() <= sharpest * step_s**2 + 1e-12


def test_fades_take_exactly_half_of_their_length():
    times = np.linspace(0.0, 10.0, 100_001)
    missing = 1.0 - gain_at([GainSpan(2.0, 8.0, 0.0, 1.0, 2.0)], times)
    area = np.sum(0.5 * (missing[1:] + missing[:-1])) * 1e-4
    assert area == pytest.approx(6.0 - 1.5, abs=1e-6)


def test_spans_that_overlap_multiply_in_any_order(rng):
    times = np.sort(rng.uniform(0, 10, 500))
    a, b = GainSpan(1.0, 9.0, 0.5), GainSpan(4.0, 12.0, 3.0, 2.0, 1.0)
    both = gain_at([a, b], times)
    assert np.array_equal(both, gain_at([b, a], times))
    assert np.allclose(both, gain_at([a], times) * gain_at([b], times), atol=1e-15)
    assert gain_at([a, b], np.array([7.0]))[0] == pytest.approx(1.5)
    assert np.array_equal(gain_at([], times), np.ones(500))


def test_only_the_acceleration_inside_the_span_changes(make_track):
    time_s = np.arange(2000) / 200.0
    track = make_track(time_s, np.sin(3 * time_s) + 2.0, sigma=np.ones(2000))
    out = modulate(track, [GainSpan(3.0, 6.0, 0.0, 0.5, 0.5)])
    outside = (time_s <= 3.0) | (time_s >= 6.0)
    assert np.array_equal(
        out.acceleration_mps2[outside], track.acceleration_mps2[outside]
    )
    silent = (time_s >= 3.5) & (time_s <= 5.5)
    assert np.abs(out.acceleration_mps2[silent]).max() < 1e-12
    for name in ("time_s", "gravity_mps2", "quaternion_wxyz", "gravity_sigma_mps2"):
        assert np.array_equal(getattr(out, name), getattr(track, name))


@pytest.mark.parametrize(
    "numbers",
    [
        (0.0, 1.0, -0.1, 0.2, 0.2),
        (0.0, 1.0, 0.5, 0.0, 0.2),
        (0.0, 1.0, 0.5, 0.6, 0.6),
        (1.0, 0.0, 0.5, 0.1, 0.1),
        (0.0, np.inf, 0.5, 0.1, 0.1),
        (0.0, 1.0, np.nan, 0.1, 0.1),
    ],
)
def test_spans_that_make_no_sense_are_refused_with_a_remedy(numbers):
    with pytest.raises(InputError) as caught:
        GainSpan(*numbers)
    assert caught.value.remedy
