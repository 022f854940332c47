"""Power by simulated studies against what is known of it."""

import numpy as np
import pytest
from statsmodels.stats.power import TTestPower

from hapticplayer.errors import Cancelled, UsageError
from hapticplayer.simulation.participants import draw_effect, effect_named
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.friedman import friedman
from hapticplayer.study.analysis.power import (
    PowerGoal,
    draw_pilot,
    find_power,
    power_summary,
)
from hapticplayer.study.analysis.rank_tests import signed_rank, signed_rank_p
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


@pytest.mark.parametrize("people", [3, 7, 8, 15])
def test_pairs_are_tested_as_a_real_study_is(people):
    """Ratings have ties and pairs without a difference."""
    draw = draw_effect(effect_named("0.5"), "comfort", 4)
    values = draw(40, people, np.random.default_rng(3))
    differences = np.round(values[:, :, 2] - values[:, :, 1], 9)
    differences[0] = 0.0
    expected = [signed_rank(np.zeros(people), row)["p"] or 1.0 for row in differences]
    np.testing.assert_allclose(signed_rank_p(differences), expected, atol=1e-12)


def test_seven_participants_have_the_power_of_exact_tests():
    """By the normal approximation, which cannot reach 0.05 / 3, it would be 0.002."""
    draw = draw_effect(effect_named("paper"), "qoe", 4)
    found = find_power(draw, NAMES, PowerGoal(largest=8, studies=600))
    seven = found.participants.index(7)
    assert found.curves["none-realistic"][seven] == pytest.approx(0.95, abs=0.04)
    assert found.needed["none-realistic"] == 7
    assert "exact to 20 participants" in power_summary(found)["tests"]


def test_the_power_calculation_stops_when_asked():
    def stop(fraction: float, _step: str) -> None:
        if fraction > 0.5:
            raise Cancelled

    draw = draw_effect(effect_named("0.5"), "comfort", 4)
    with pytest.raises(Cancelled):
        find_power(draw, NAMES, PowerGoal(largest=5, studies=500), stop)


def test_feedbacks_together_have_the_power_of_the_exact_test():
    """Of the same simulated studies, as `analyse` tests each."""
    draw = draw_effect(effect_named("0.5"), "comfort", 4)
    goal = PowerGoal(largest=5, studies=300)
    found = find_power(draw, NAMES, goal)
    rng = np.random.default_rng(goal.seed)
    studies = np.concatenate([draw(100, 5, rng) for _ in range(3)])
    p = [friedman(np.round(one, 9), Resampling(), "x")["p_exact"] for one in studies]
    expected = np.mean([one is not None and one <= goal.alpha for one in p])
    assert found.curves["friedman"][found.participants.index(5)] == expected
