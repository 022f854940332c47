"""Power by the mixed model, from the population that it is fitted to."""

import numpy as np
import pytest
import scipy

from hapticplayer.errors import Cancelled, UsageError
from hapticplayer.study.analysis import model_power
from hapticplayer.study.analysis.cumulative_link import LinkFunction
from hapticplayer.study.analysis.model_power import LatentPopulation, find_model_power
from hapticplayer.study.analysis.power import PowerGoal, power_summary

TRUE = LatentPopulation(
    LinkFunction.PROBIT, np.array([-1.0, 0.2, 1.1]), np.array([0.4, 0.9]), 0.8, 0.5
)


def test_a_population_is_found_again_in_its_answers() -> None:
    values = TRUE.drawn(400, 12, np.random.default_rng(1))
    values[:30, 2, 1] = np.nan
    found = LatentPopulation.of(values, TRUE.link, is_item=True)
    np.testing.assert_allclose(found.effects, TRUE.effects, atol=0.05)
    np.testing.assert_allclose(np.diff(found.thresholds), [1.2, 0.9], atol=0.05)
    assert found.of_people == pytest.approx(0.8, abs=0.08)
    assert found.of_clips == pytest.approx(0.5, abs=0.25)


@pytest.mark.parametrize(
    "values",
    [np.full((9, 4, 2), 3.0), TRUE.drawn(4, 4, np.random.default_rng(1))],
    ids=["alike", "four-people"],
)
def test_a_pilot_that_tells_too_little_is_refused(values: np.ndarray) -> None:
    with pytest.raises(UsageError, match="at least 5 participants"):
        LatentPopulation.of(values, LinkFunction.LOGIT, is_item=True)


def test_yes_and_no_have_the_power_of_two_shares() -> None:
    """48 against 48 answers of four people: the difference of two shares by t."""
    even = LatentPopulation(
        LinkFunction.PROBIT, np.zeros(1), np.array([0.75]), 0.0, 0.0
    )
    found = find_model_power(even, ("a", "b"), 12, PowerGoal(largest=4, studies=100))
    second = scipy.stats.norm.cdf(0.75)
    error = np.sqrt((0.25 + second * (1.0 - second)) / 48)
    least = scipy.stats.t.ppf(0.975, 3)
    expected = scipy.stats.norm.cdf((second - 0.5) / error - least)
    assert found.curves["a-b"] == (pytest.approx(expected, abs=0.1),)
    assert found.curves["a-b"] == found.curves["all pairs"]
    assert "likelihood ratio" in power_summary(found)["tests"]


def test_the_smallest_number_is_found_from_few(monkeypatch) -> None:
    tried = []

    def shares(_population, _sequences, people, _goal, _report) -> np.ndarray:
        tried.append(people)
        return np.clip(people / np.array([20.0, 30.0, 80.0]), 0.0, 1.0)

    monkeypatch.setattr(model_power, "significant_shares", shares)
    even = TRUE._replace(effects=np.array([0.4]))
    found = find_model_power(even, ("a", "b"), 4, PowerGoal(largest=60))
    assert found.needed == {"all feedbacks": 16, "a-b": 24, "all pairs": None}
    assert len(tried) < 15


def test_power_by_the_model_stops_between_two_studies() -> None:
    done: list[float] = []

    def progress(fraction: float, _step: str) -> None:
        done.append(fraction)
        if len(done) == 4:
            raise Cancelled

    with pytest.raises(Cancelled):
        find_model_power(TRUE, ("a", "b", "c"), 4, PowerGoal(largest=5), progress)
    assert done == sorted(set(done))
