"""Fewer corners, never further from the samples than the tolerance."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.extras.formats.thinning import thin

QUANTUM = 1e-4


def largest(ticks, values, kept, heights):
    return np.abs(np.interp(ticks, kept, heights) - values).max()


@given(
    st.lists(st.integers(1, 50), min_size=1, max_size=60),
    st.sampled_from([0.001, 0.01, 0.1]),
    st.data(),
)
def test_the_tolerance_holds_at_every_sample(steps, tolerance, data):
    ticks = np.cumsum([0, *steps])
    number = st.floats(-5.0, 5.0, width=32) | st.just(0.0)
    values = np.array(
        data.draw(st.lists(number, min_size=len(ticks), max_size=len(ticks)))
    )
    kept, heights = thin(ticks, values, tolerance, QUANTUM)
    assert (kept[0], kept[-1]) == (ticks[0], ticks[-1])
    assert np.all(np.diff(kept) > 0)
    assert largest(ticks, values, kept, heights) <= tolerance + 1e-9


@given(st.lists(st.floats(0.0, 5.0) | st.just(0.0), min_size=2, max_size=60))
def test_no_corner_is_below_the_least(values):
    ticks, values = np.arange(len(values)), np.array(values)
    kept, heights = thin(ticks, values, 0.1, QUANTUM, least=0.0)
    assert heights.min() >= 0.0
    assert largest(ticks, values, kept, heights) <= 0.1 + 1e-9


def test_a_line_needs_its_two_ends():
    ticks = np.arange(5000)
    kept, _ = thin(ticks, 0.002 * ticks - 3.0, 0.01, QUANTUM)
    assert list(kept) == [0, 4999]


def test_a_span_of_zeros_stays_zero():
    ticks = np.arange(300)
    values = np.where(np.abs(ticks - 150) < 40, 0.0, np.sin(ticks / 7.0))
    kept, heights = thin(ticks, values, 0.05, QUANTUM)
    quiet = np.abs(ticks - 150) < 39
    assert np.all(np.interp(ticks[quiet], kept, heights) == 0.0)


def test_a_sine_takes_fewer_corners_than_through_samples():
    ticks = np.arange(0, 2001)
    values = np.sin(2.0 * np.pi * ticks / 1000.0)
    kept, heights = thin(ticks, values, 0.01, QUANTUM)
    # lines that touch both bounds span sqrt(16 tol / curvature); chords through samples
    # sqrt(8 tol / curvature). The mean root of |sin| is 0.763: 16.9 and 24 a period
    assert len(kept) - 1 <= 44
    assert largest(ticks, values, kept, heights) <= 0.01


@pytest.mark.parametrize("start", [0.009, -0.009])
def test_a_piece_begins_where_the_one_before_ended(start):
    ticks = np.arange(100)
    kept, heights = thin(ticks, np.full(100, 1.0), 0.01, QUANTUM, 1.0 + start)
    assert heights[0] == pytest.approx(1.0 + start, abs=1e-9)
    assert largest(ticks, np.ones(100), kept, heights) <= 0.01
