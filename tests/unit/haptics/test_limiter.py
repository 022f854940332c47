"""The last stage never lets through what the contract forbids."""

import math

import numpy as np
import pytest

from hapticplayer.haptics.limiter import ZERO, limit


def test_an_allowed_force_passes_unchanged():
    assert limit((0.1, -0.2, 0.3), (0.0, 0.0, 0.0), 1.0, 4.5) == (0.1, -0.2, 0.3)


def test_the_cap_keeps_the_direction():
    x, y, z = limit((30.0, -40.0, 120.0), (3.0, -4.0, 0.0), 10.0, 4.5)
    assert math.hypot(x, y, z) == pytest.approx(4.5)
    assert np.allclose(np.array([x, y, z]) / 4.5, np.array([3, -4, 12]) / 13.0)


def test_even_the_largest_double_keeps_its_direction():
    x, y, z = limit((1.7e308, -1.7e308, 0.0), (3.0, -3.0, 0.0), 10.0, 4.5)
    assert (x, y, z) == pytest.approx((4.5 / math.sqrt(2), -4.5 / math.sqrt(2), 0.0))


def test_not_a_number_means_zero():
    assert limit((math.nan, 1.0, 1.0), ZERO, 1.0, 4.5) == ZERO
