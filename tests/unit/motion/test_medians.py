"""The median is numpy's own, to the last bit."""

import numpy as np
import pytest

from hapticplayer.motion.medians import median

COUNTS = (1, 2, 3, 8, 501, 1000, 1001, 5000, 5001)


@pytest.mark.parametrize("count", COUNTS)
def test_of_values_of_which_none_is_there_twice(count, rng):
    values = rng.standard_normal(count)
    assert median(values) == np.median(values)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("kinds", [1, 2, 3, 17])
def test_of_few_values_many_times(kinds, count, rng):
    values = rng.standard_normal(kinds)[rng.integers(0, kinds, count)]
    assert median(values) == np.median(values)


@pytest.mark.parametrize("more", [-1, 0, 1])
def test_between_two_values_of_which_each_is_half(more, rng):
    values = np.repeat([1.0, 2.0], [2000, 2000 + more])
    assert median(values) == np.median(values)
    assert median(rng.permutation(values)) == np.median(values)


def test_of_a_sample_that_is_not_like_the_rest():
    values = np.ones(4096)
    values[::16] = 2.0
    assert median(values) == 1.0


def test_a_median_does_not_write_to_its_values():
    values = np.arange(3000.0)[::-1].copy()
    values.setflags(write=False)
    assert median(values) == 1499.5
