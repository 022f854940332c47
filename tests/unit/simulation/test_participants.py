"""Simulated answers have the paper's means, spreads and conclusions."""

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.errors import UsageError
from hapticplayer.simulation.participants import (
    drawn_ratings,
    effect_named,
    paper_effect,
    simulated_answers,
)
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import AnalysisOptions, Resampling, analyse
from hapticplayer.study.analysis.analysis import summary
from hapticplayer.study.answers import collect_answers
from hapticplayer.study.creation import create_study
from tests.unit.study.analysis.conftest import models_left_out

QOE = {"none": (7.5, 2.1), "random": (10.2, 1.6), "realistic": (15.3, 2.6)}
FACTORS = {
    "realism": (1.3, 1.9, 3.8),
    "sensory": (1.1, 2.4, 3.9),
    "comfort": (2.9, 3.2, 3.6),
    "satisfaction": (2.1, 2.8, 4.1),
}
NAMES = ("none", "random", "realistic")


@pytest.fixture(scope="module", params=[2012, 1, 2])
def found(request):
    answers = simulated_answers(15, seed=request.param)
    with models_left_out():
        return summary(analyse(answers, AnalysisOptions(resampling=Resampling(7, 99))))


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


def test_simulated_answers_reach_a_study_whole(tmp_path):
    answers = simulated_answers(3, "0.5", seed=4)
    study = create_study(tmp_path / "study")
    codes = write_answers(study, answers, ManualClock(), origin={"simulated": True})
    found = collect_answers(study)

    def cells(ratings):
        return sorted((r.sequence, r.feedback, r.factor, r.value) for r in ratings)

    for code, person in zip(codes, answers.participants, strict=True):
        stored = [r for r in found.ratings if r.participant == code]
        expected = [r for r in answers.ratings if r.participant == person.code]
        assert cells(stored) == cells(expected)
