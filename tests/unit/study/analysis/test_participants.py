import numpy as np
import pytest
from statsmodels.stats.power import TTestPower

from hapticplayer.errors import Cancelled, UsageError
from hapticplayer.simulation.participants import simulated_answers, write_simulated
from hapticplayer.study.analysis import Choices, analyse
from hapticplayer.study.analysis.effects import (
    drawn_ratings,
    effect_named,
    paper_effect,
)
from hapticplayer.study.analysis.power import (
    Goal,
    draw_effect,
    draw_pilot,
    find_power,
)
from hapticplayer.study.analysis.scores import by_feedback, scores_of
from hapticplayer.study.analysis.summary import summary

QOE = {"none": (7.5, 2.1), "random": (10.2, 1.6), "realistic": (15.3, 2.6)}
FACTORS = {
    "realism": (1.3, 1.9, 3.8),
    "sensory": (1.1, 2.4, 3.9),
    "comfort": (2.9, 3.2, 3.6),
    "satisfaction": (2.1, 2.8, 4.1),
}
NAMES = ("none", "random", "realistic")


@pytest.fixture(scope="module", params=[2012, 1, 2])
def found(request, quick):
    answers = simulated_answers(15, seed=request.param)
    return summary(analyse(answers, Choices(resampling=quick)))


def test_a_simulated_sample_has_the_papers_means_and_sds(found):
    for name, (mean, sd) in QOE.items():
        assert round(found["qoe"][name]["mean"], 1) == mean
        assert round(found["qoe"][name]["sd"], 1) == sd
    for factor, means in FACTORS.items():
        assert [round(found["factors"][factor][n]["mean"], 1) for n in NAMES] == list(
            means
        )


def test_the_analysis_recovers_the_papers_conclusions(found):
    """All measures differ between the feedbacks; realistic is above both others."""
    for measure, one in found["friedman"].items():
        assert one["p"] < 0.05, measure
        assert one["p_holm"] < 0.05, measure
        ranks = one["mean_ranks"]
        assert ranks["realistic"] > max(ranks["random"], ranks["none"]), measure
    w = {name: one["kendall_w"] for name, one in found["friedman"].items()}
    assert w["sensory"] > 0.8
    assert w["comfort"] == pytest.approx(0.293, abs=0.1)
    for pair in ("none-random", "none-realistic", "random-realistic"):
        assert found["wilcoxon"]["qoe"][pair]["p_holm"] < 0.05


def test_the_population_has_the_papers_means_and_sds():
    """40 000 participants: standard errors of 0.004 of a factor and 0.01 of the SD."""
    effect = paper_effect()
    ratings = drawn_ratings(effect, (1, 40_000, 4), np.random.default_rng(0))[0]
    assert set(np.unique(ratings)) == {1.0, 2.0, 3.0, 4.0, 5.0}
    np.testing.assert_allclose(
        ratings.mean(axis=(0, 1)), effect.factor_means, atol=0.02
    )
    qoe = ratings.sum(axis=3).mean(axis=1)
    np.testing.assert_allclose(qoe.mean(axis=0), [7.5, 10.2, 15.3], atol=0.05)
    np.testing.assert_allclose(qoe.std(axis=0), [2.1, 1.6, 2.6], atol=0.04)


def test_the_seed_decides():
    assert simulated_answers(6, seed=1) == simulated_answers(6, seed=1)
    assert simulated_answers(6, seed=1) != simulated_answers(6, seed=2)


def test_without_an_effect_the_feedbacks_are_alike():
    means = effect_named("none").factor_means
    assert (means == means[0]).all()


@pytest.mark.parametrize("name", ["2", "much", "-0.5", "nan", "inf"])
def test_an_impossible_effect_is_refused(name):
    with pytest.raises(UsageError):
        simulated_answers(5, name, seed=1)


@pytest.mark.parametrize("people", [0, -3, 10_000])
def test_an_impossible_number_of_participants_is_refused(people):
    with pytest.raises(UsageError):
        simulated_answers(people, seed=1)


def test_simulated_sessions_reach_a_store_whole():
    answers = simulated_answers(3, "0.5", seed=4, sequences=("a", "b"))
    seen = {}

    def write(person, rate):
        for sequence in answers.sequences:
            for feedback in answers.feedbacks:
                for factor, value in rate(sequence, feedback).items():
                    seen[person.code, sequence, feedback, factor] = value
        return f"stored-{person.code}"

    codes = write_simulated(answers, write)
    assert codes == ["stored-S001", "stored-S002", "stored-S003"]
    assert seen == {
        (one.participant, one.sequence, one.feedback, one.factor): one.value
        for one in answers.ratings
    }


def test_without_an_effect_the_power_is_alpha():
    """2000 studies: the standard error of 0.05 is 0.005."""
    draw = draw_effect(effect_named("none"), "qoe", 4)
    found = find_power(draw, NAMES, Goal(largest=25))
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

    found = find_power(draw, ("a", "b"), Goal(largest=40, studies=4000))
    assert found.needed["a-b"] == pytest.approx(expected, abs=1.5)


def test_a_larger_effect_needs_fewer():
    needed = [
        find_power(
            draw_effect(effect_named(name), "qoe", 4), NAMES, Goal(studies=500)
        ).needed["friedman"]
        for name in ("1", "0.5", "0.3")
    ]
    assert needed == sorted(needed)
    assert needed[0] < needed[2]


def test_a_pilot_stands_for_the_population(make_answers):
    pilot = by_feedback(scores_of(make_answers(3, 12)), "qoe")
    found = find_power(draw_pilot(pilot), pilot.feedbacks, Goal(studies=200))
    assert found.needed["friedman"] is not None
    few = by_feedback(scores_of(make_answers(3, 4)), "qoe")
    with pytest.raises(UsageError, match="five participants"):
        draw_pilot(few)


def test_the_power_calculation_stops_when_asked():
    def stop(fraction: float, _step: str) -> None:
        if fraction > 0.5:
            raise Cancelled

    draw = draw_effect(effect_named("0.5"), "comfort", 4)
    with pytest.raises(Cancelled):
        find_power(draw, NAMES, Goal(largest=5, studies=500), stop)
