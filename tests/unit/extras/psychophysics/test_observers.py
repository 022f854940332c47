"""Simulated observers of each kind of trials, and what reports find of them."""

import json
import random
import secrets

import numpy as np
import pytest
from scipy import stats

from hapticplayer.extras.psychophysics.psychometric import CurveShape, fit
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.analysis import AnalysisOptions, Resampling
from hapticplayer.study.analysis.report import analyse_study, write_report
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition, create_study

JND = stats.norm.ppf(0.75)


def chooser(rng, key, felt):
    def answer(first, second):
        is_second = felt(second) - felt(first) + rng.normal() > 0.0
        return {key: "second" if is_second else "first"}

    return answer


def estimator(rng):
    def answer(one):
        return {"strength": round(50.0 * one.gain**0.8 * np.exp(0.1 * rng.normal()))}

    return answer


@pytest.fixture
def study_of(tmp_path, manual_clock, monkeypatch):
    """A study of a template with one clip, in which observers took part.

    Codes decide orders; random ones would miss an interval of 95 % once in 20 runs.
    """
    monkeypatch.setattr(secrets, "choice", random.Random(7).choice)

    def make(template, observe, people, **changes):
        study = create_study(tmp_path / template, template)
        content = {**json.loads(study.content), **changes}
        content["sequences"] = content["sequences"][:1]
        study = change_definition(study, content)
        for _ in range(people):
            origin = {"simulated": True}
            write_scripted_session(study, {}, observe, manual_clock, origin=origin)
        return analyse_study(
            read_answers(study.folder), AnalysisOptions(resampling=Resampling(1, 99))
        )

    return make


def test_a_curve_from_half_has_the_spread_of_exact_shares():
    levels = np.array([-0.4, -0.2, -0.1, -0.05])
    p = 0.015 + 0.97 * stats.norm.cdf(np.abs(levels) / 0.15)
    found = fit(levels, 100.0 * p[None], np.full((1, 4), 100.0), CurveShape.FROM_HALF)
    assert found.spread[0] == pytest.approx(0.15, abs=1e-4)
    assert found.lapse[0] == pytest.approx(0.03, abs=1e-4)
    assert found.shares(levels)[0] == pytest.approx(p, abs=1e-5)


def test_a_staircase_finds_the_threshold_of_its_observers(study_of, tmp_path):
    rng = np.random.default_rng(2)
    rule = {"changes": "delay_s", "correct": 2, "start": 0.6}
    rule |= {"steps": [0.1, 0.05], "trials": 30}
    found = study_of(
        "staircase",
        chooser(rng, "later", lambda one: one.delay_s / 0.2),
        4,
        staircase=rule,
    )
    curve = found.numbers["levels"]["delay_s"]["curves"]["all"]
    low, high = curve["intervals"]["threshold"]
    assert low <= JND * 0.2 <= high
    assert high - low < 0.2
    (group,) = found.numbers["staircases"]
    assert group["count"] == 4
    write_report(found, tmp_path / "report", "Staircases")
    names = {path.name for path in (tmp_path / "report").iterdir()}
    assert {"staircases.csv", "staircases.svg", "chosen-by-time-shift.svg"} < names


def test_levels_around_a_standard_find_equality_and_threshold(study_of):
    rng = np.random.default_rng(4)
    observe = chooser(rng, "stronger", lambda one: np.log(one.gain) / 0.3)
    found = study_of("two-interval", observe, 10)
    curve = found.numbers["levels"]["gain"]["curves"]["all"]
    assert curve["equal"] == pytest.approx(1.0, abs=0.15)
    assert curve["threshold"] == pytest.approx(np.exp(JND * 0.3), abs=0.1)
    assert not curve["is_flat"]


def test_feedbacks_are_compared_in_pairs_without_levels(study_of):
    rng = np.random.default_rng(5)
    worth = {"realistic": 1.0, "random": 0.0, "none": -1.0}
    found = study_of(
        "two-interval",
        chooser(rng, "stronger", lambda one: worth[one.feedback]),
        8,
        feedbacks=list(worth),
        levels=[],
    )
    shares = {k: one["share"] for k, one in found.numbers["feedbacks"].items()}
    assert set(shares) == {"random", "none"}
    assert shares["none"] < shares["random"] < 0.5


def test_magnitudes_have_the_exponent_of_their_observers(study_of, tmp_path):
    found = study_of("magnitude", estimator(np.random.default_rng(6)), 8)
    one = found.numbers["exponents"]["all"]
    low, high = one["interval"]
    assert low <= 0.8 <= high
    assert one["mean"] == pytest.approx(0.8, rel=0.05)
    write_report(found, tmp_path / "report", "Magnitudes")
    assert (tmp_path / "report" / "exponents.csv").is_file()


def test_numbers_without_a_logarithm_are_told(study_of):
    found = study_of("magnitude", lambda one: {"strength": int(4 * one.gain) // 2}, 2)
    warned = found.numbers["warnings"]
    assert any("zero or below" in text for text in warned)
