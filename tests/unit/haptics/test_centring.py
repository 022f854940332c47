"""The spring and the damper that keep the grip inside, as a law."""

import math

import numpy as np
import pytest

from hapticplayer.haptics.centring import (
    Centring,
    ahead_of,
    centring_force,
    centring_of,
)
from hapticplayer.haptics.hand import HandState, observe
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.model.device import DeviceReading

SPRING = Centring()
STILL = ZERO


def radial(radius_m, speed_mps=0.0, centring=SPRING):
    """Return the force along a direction with the grip on it; positive is outward."""
    direction = np.array([0.48, -0.6, 0.64])
    hand = HandState(tuple(radius_m * direction), tuple(speed_mps * direction))
    force = np.array(centring_force(ahead_of(hand, centring), centring))
    along = float(force @ direction)
    np.testing.assert_allclose(force, along * direction, atol=1e-12)
    return along


@pytest.mark.parametrize("radius_m", [0.0, 0.005, 0.0159, 0.016])
def test_in_the_inner_part_there_is_nothing(radius_m):
    assert radial(radius_m) == 0.0


def test_the_pull_grows_smoothly_to_what_is_stated():
    radii = np.linspace(0.016, 0.05, 3401)
    pull = np.array([-radial(r) for r in radii])
    slope = np.diff(pull) / np.diff(radii)
    assert np.all(slope >= 0.0)
    assert np.all(np.diff(slope) >= -1e-6)  # convex: the further out, the stiffer
    assert np.abs(np.diff(slope)).max() < 0.2  # N/m within 0.01 mm: no kink
    assert -radial(0.026) == pytest.approx(3.0 / 4.0)
    assert -radial(0.036) == pytest.approx(3.0)
    assert slope.max() == pytest.approx(300.0)
    middles = (radii[1:] + radii[:-1]) / 2.0
    known = [SPRING.stiffness_n_per_m(r) for r in middles]
    np.testing.assert_allclose(known, slope, atol=0.1)


@pytest.mark.parametrize("radius_m", [0.022, 0.030, 0.036])
def test_the_look_ahead_is_a_damper_of_stiffness_times_time(radius_m):
    speed = 1e-4
    damping = -(radial(radius_m, speed) - radial(radius_m, -speed)) / (2.0 * speed)
    expected = SPRING.ahead_s * SPRING.stiffness_n_per_m(radius_m)
    assert damping == pytest.approx(expected, rel=1e-3)


def test_near_the_edge_outward_motion_is_damped_more():
    out = radial(0.030) - radial(0.030, 0.4)
    back = radial(0.030, -0.4) - radial(0.030)
    assert out > 1.2 * back > 0.0


def test_no_speed_turns_the_pull_outward():
    rng = np.random.default_rng(1)
    for _ in range(2000):
        hand = HandState(tuple(rng.normal(0, 0.02, 3)), tuple(rng.normal(0, 0.5, 3)))
        force = centring_force(ahead_of(hand, SPRING), SPRING)
        there = ahead_of(hand, SPRING)
        assert sum(f * p for f, p in zip(force, there, strict=True)) <= 0.0


def test_another_workspace_has_the_same_pull_at_the_same_share():
    wide = centring_of(Limits(workspace_m=0.08))
    for share in (0.3, 0.5, 0.7, 0.9):
        assert radial(share * 0.08, 0.0, wide) == pytest.approx(radial(share * 0.04))
    assert centring_of(Limits()) == pytest.approx(SPRING)


@pytest.mark.parametrize("delay_ticks", [1, 2, 4])
@pytest.mark.parametrize("swing_hz", [0.5, 2.0, 5.0, 8.0])
def test_a_grip_that_swings_through_the_edge_gets_no_energy(delay_ticks, swing_hz):
    """The motion is prescribed; seen late and in counts, answered later still."""
    hand, due, taken_j, least_j = HandState(), [], 0.0, 0.0
    count_m, before_m = 45e-6, 0.0
    for tick in range(3000):
        now_s = 1.0 + tick * PERIOD_S
        x = 0.034 * math.sin(2.0 * math.pi * swing_hz * tick * PERIOD_S)
        acting = due.pop(0) if len(due) > delay_ticks else 0.0
        taken_j -= acting * (x - before_m)
        least_j, before_m = min(least_j, taken_j), x
        seen = (count_m * round(x / count_m), 0.0, 0.0)
        hand = observe(hand, DeviceReading(seen, 0, True, now_s), Limits())
        due.append(centring_force(ahead_of(hand, SPRING), SPRING)[0])
    assert least_j > -0.001
    assert taken_j > 0.0
