"""The last stage never lets through what the contract forbids."""

import math

import numpy as np
import pytest

from hapticplayer.haptics.limiter import ZERO, Limits, limit

SPECIALS = [
    0.0, -0.0, 1.0, -1.0, 4.5, 1e308, -1e308, 1.7e308, 5e-324, -5e-324,
    math.inf, -math.inf, math.nan,
]  # fmt: skip
LIMITS = Limits()
EPS = 1e-9  # rounding of a few double operations on values below 10


def test_adversarial_inputs_stay_finite_capped_and_slow(rng):
    previous = ZERO
    for _ in range(100_000):
        if rng.random() < 0.5:
            target = tuple(SPECIALS[i] for i in rng.integers(0, len(SPECIALS), 3))
        else:
            target = tuple(rng.standard_normal(3) * 10.0 ** rng.uniform(-3, 300))
        sent = limit(target, previous, LIMITS.content_slew_n, LIMITS.force_cap_n)
        assert all(map(math.isfinite, sent))
        assert math.hypot(*sent) <= LIMITS.force_cap_n + EPS
        assert math.dist(sent, previous) <= LIMITS.content_slew_n + EPS
        previous = sent


def test_what_is_allowed_passes_unchanged():
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
