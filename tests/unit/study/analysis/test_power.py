"""Power by simulated studies against what is known of it."""

import numpy as np
import pytest
from statsmodels.stats.power import TTestPower

from hapticplayer.errors import Cancelled, UsageError
from hapticplayer.simulation.participants import draw_effect, effect_named
from hapticplayer.study.analysis.power import PowerGoal, draw_pilot, find_power
from hapticplayer.study.analysis.scores import sample_of, scores_of

NAMES = ("none", "random", "realistic")


def test_without_an_effect_the_power_is_alpha():
    """2000 studies: the standard error of 0.05 is 0.005."""
    draw = draw_effect(effect_named("none"), "qoe", 4)
    found = find_power(draw, NAMES, PowerGoal(largest=25))
    assert found.curves["friedman"][-1] == pytest.approx(0.05, abs=0.02)
    assert set(found.needed.values()) == {None}


@pytest.mark.parametrize("d", [0.55, 0.8])
def test_a_normal_shift_needs_the_t_tests_n_over_efficiency(d):
    """Differences N(d, 1): 3 / pi is Pitman's efficiency of the signed-rank test."""
    by_t = TTestPower().solve_power(effect_size=d, alpha=0.05, power=0.8)
    expected = by_t * np.pi / 3.0

    def draw(studies, people, rng):
        values = rng.standard_normal((studies, people, 2)) / np.sqrt(2.0)
        return values + np.array([0.0, d])

    found = find_power(draw, ("a", "b"), PowerGoal(largest=40, studies=4000))
    assert found.needed["a-b"] == pytest.approx(expected, abs=1.5)


def test_a_larger_effect_needs_fewer():
    needed = [
        find_power(
            draw_effect(effect_named(name), "qoe", 4), NAMES, PowerGoal(studies=200)
        ).needed["friedman"]
        for name in ("1", "0.5", "0.3")
    ]
    assert needed == sorted(needed)
    assert needed[0] < needed[2]


def test_a_pilot_stands_for_the_population(make_answers):
    pilot = sample_of(scores_of(make_answers(3, 12)), "qoe")
    found = find_power(draw_pilot(pilot), pilot.feedbacks, PowerGoal(studies=200))
    assert found.needed["friedman"] is not None
    few = sample_of(scores_of(make_answers(3, 4)), "qoe")
    with pytest.raises(UsageError, match="five complete participants"):
        draw_pilot(few)


def test_the_power_calculation_stops_when_asked():
    def stop(fraction: float, _step: str) -> None:
        if fraction > 0.5:
            raise Cancelled

    draw = draw_effect(effect_named("0.5"), "comfort", 4)
    with pytest.raises(Cancelled):
        find_power(draw, NAMES, PowerGoal(largest=5, studies=500), stop)
