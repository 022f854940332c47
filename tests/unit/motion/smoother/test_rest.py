"""What still spans say, interval by interval."""

import numpy as np
import pytest

from hapticplayer.motion.smoother.calibrated import Solution
from hapticplayer.motion.smoother.rest import seeming_acceleration

NOTHING = np.zeros((0, 0))


def solution(velocity_mps):
    return Solution(NOTHING, velocity_mps, *(4 * [NOTHING]))


@pytest.fixture
def solved_s(rng):
    return rng.uniform(0.5, 1.0, 40)


@pytest.fixture
def found(rng):
    return solution(rng.standard_normal((2, 41)))


def test_an_acceleration_is_the_change_of_velocity_over_time(found, solved_s):
    change = np.linalg.norm(np.diff(found.velocity_mps), axis=0)
    seems = seeming_acceleration(found, solved_s, solved_s)
    assert seems == pytest.approx(change / solved_s)


def test_intervals_that_were_solved_need_no_interpolation(found, solved_s):
    same = seeming_acceleration(found, solved_s, solved_s)
    assert seeming_acceleration(found, solved_s, solved_s.copy()) == pytest.approx(same)


def test_half_an_interval_of_steady_acceleration_has_all_of_it(solved_s):
    time_s = np.concatenate([[0.0], np.cumsum(solved_s)])
    steady = solution(np.stack([3.0 * time_s, -4.0 * time_s]))
    halves_s = np.repeat(0.5 * solved_s, 2)
    assert seeming_acceleration(steady, solved_s, halves_s) == pytest.approx(5.0)
