"""Ratings over time: figures that feedbacks are compared by, curves, first-order model."""

import json
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.media.encode import write_clip
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import AnalysisOptions, first_order
from hapticplayer.study.analysis.course_report import (
    course_figures,
    course_with_band,
    mean_with_band,
)
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.first_order import first_order_models, low_pass
from hapticplayer.study.analysis.report import analyse_study
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.definition import Condition, LiveRating, RatingKind
from hapticplayer.study.live_ratings import HEAD, rating_file, row_text
from hapticplayer.study.watched import COURSE_HZ, Course
from tests.material.shaken import write_shaken_sequence
from tests.unit.study.test_watching import ALL

MATCH = LiveRating(
    "match", RatingKind.SLIDER, {"en": "match"}, least=-50, most=50, by=("mouse",)
)


def simulated_course(place, rng, lag_s, gain, lateral, people=24):
    """Raters who follow the mismatch with a lag, each with an offset and noise."""
    time_s = np.arange(0.0, 60.0, 1.0 / COURSE_HZ)
    drawn = low_pass(rng.standard_normal((len(time_s), 3)), 0.5)
    mismatch_n = 3.0 * drawn
    felt = np.abs(mismatch_n[:, [0, 2]]) @ np.array([lateral, 1.0 - lateral])
    values = 4.0 + gain * low_pass(felt, lag_s) + rng.normal(size=(people, 1))
    values = values + 0.3 * rng.standard_normal((people, len(time_s)))
    values[0, :50] = np.nan
    of = MATCH, Condition(f"clip-{place}", "none"), time_s, values
    return Course(*of, np.zeros_like(mismatch_n), mismatch_n)


@pytest.fixture(autouse=True)
def _fewer_resamples(monkeypatch):
    monkeypatch.setattr(first_order, "RESAMPLES", 49)


@pytest.mark.parametrize(
    ("lag_s", "gain", "lateral"),
    [(0.5, 8.0, 0.66), (2.5, 12.0, 0.66), (6.0, 20.0, 1.0)],
)
def test_lag_and_gain_of_simulated_raters_are_found(lag_s, gain, lateral):
    rng = np.random.default_rng(6)
    made = [simulated_course(n, rng, lag_s, gain, lateral) for n in range(6)]
    found = first_order_models(made, Resampling())["match"]
    assert found["lag_s"] == pytest.approx(lag_s, rel=0.05)
    assert found["gain"] == pytest.approx(gain, rel=0.05)
    assert found["lateral"] == pytest.approx(lateral, abs=0.04)
    assert found["explained"] > 0.9
    low, high = found["lag_interval"]
    assert low < found["lag_s"] < high
    assert high - low < 0.5 * lag_s


def test_raters_who_do_not_follow_the_force_explain_little():
    rng = np.random.default_rng(2)
    made = [simulated_course(n, rng, 2.0, 0.0, 0.5) for n in range(6)]
    assert first_order_models(made, Resampling())["match"]["explained"] < 0.3


def test_the_band_is_the_interval_of_the_mean():
    values = np.array([[1.0, 2.0, np.nan], [3.0, 2.0, np.nan], [5.0, np.nan, 1.0]])
    mean, low, high = mean_with_band(values)
    assert mean.tolist() == [3.0, 2.0, 1.0]
    # t(0.975, 2) = 4.3027 times 2 / sqrt(3)
    assert high[0] - mean[0] == pytest.approx(4.3027 * 2.0 / np.sqrt(3.0), rel=1e-4)
    assert low[1] == high[1] == 2.0
    assert np.isnan(low[2])


def test_the_band_of_a_share_is_wilsons():
    """Of 0, 6 and 12 of 12: it neither vanishes nor leaves 0 to 1."""
    key = LiveRating("moving", RatingKind.HELD_KEY, {"en": "moving"}, hold="v")
    values = (np.arange(12)[:, None] < [0, 6, 12]).astype(float)
    of = key, Condition("bike", "none"), np.arange(3.0), values, None, None
    mean, low, high = course_with_band(Course(*of))
    assert mean.tolist() == [0.0, 0.5, 1.0]
    np.testing.assert_allclose(low, [0.0, 0.2538, 0.7575], atol=1e-4)
    np.testing.assert_allclose(high, [0.2425, 0.7462, 1.0], atol=1e-4)


def written(study, clock, people=7, seconds=20.0):
    """Sessions whose key is held from 4 s on with force, and never without."""
    keys = tuple(one.key for one in study.definition.sequences)
    answers = simulated_answers(people, "1", seed=3, sequences=keys)
    codes = write_answers(study, answers, clock, origin={"simulated": True})
    rng = np.random.default_rng(1)
    for code in codes:
        session = study.session(code)
        for position, condition in enumerate(session.plan.order, 1):
            onset_s = {"none": np.inf, "random": 9.0, "realistic": 4.0}[
                condition.feedback
            ]
            onset_s += rng.uniform(-1.0, 1.0)
            time_s = np.arange(0.0, seconds, 0.02)
            held = (time_s >= onset_s) & (time_s < onset_s + 5.0)
            for key, values in (("vection", held), ("match", 10.0 * np.sin(time_s))):
                rows = zip(time_s.tolist(), np.asarray(values, float), strict=True)
                lines = [row_text(100.0 + at_s, at_s, one) for at_s, one in rows]
                path = rating_file(session.folder, position, 1, key)
                path.write_text(f"{HEAD}\n{''.join(lines)}")
            asked = rating_file(session.folder, position, 1, "fms")
            asked.write_text(
                f"{HEAD}\n{row_text(105.0, 5.0, None)}{row_text(107.0, 7.0, 3)}"
            )
    return codes


@pytest.fixture
def watched(tmp_path, template, manual_clock):
    frames = (np.full((36, 64, 3), 5 * i, np.uint8) for i in range(50))
    write_clip(tmp_path / "clip.mp4", frames, frame_rate_hz=25)
    clip = write_shaken_sequence(tmp_path / "clip.mp4", tmp_path / "sequence")
    sequences = [{**one, "folder": str(clip)} for one in template["sequences"][:2]]
    rated = {"while_watching": ALL, "sequences": sequences}
    return change_definition(create_study(tmp_path / "study"), {**template, **rated})


def test_vection_is_compared_and_told_over_time(watched, manual_clock, quick):
    written(watched, manual_clock)
    answers = read_answers(watched.folder, lambda _fraction, _step: None)
    report = analyse_study(answers, AnalysisOptions(resampling=quick))
    onset = report.numbers["factors"]["vection.onset_s"]
    assert onset["realistic"]["mean"] == pytest.approx(4.0, abs=0.5)
    assert onset["none"]["mean"] == pytest.approx(19.98, abs=0.03)  # never: the end
    assert report.numbers["factors"]["vection.held_s"]["none"]["mean"] == 0.0
    assert report.numbers["friedman"]["vection.onset_s"]["p_exact"] < 0.01
    mixed = report.numbers["ordinal_logit"]["vection.onset_s"]
    assert mixed["levels"] <= 10
    assert report.numbers["factors"]["fms.mean"]["random"]["mean"] == 3.0
    head, *rows = report.tables["courses.csv"]
    assert head[-3:] == ["force_x_n", "force_y_n", "force_z_n"]
    assert ["vection", "bike", "realistic", 6.0, 7, 1.0] in [row[:6] for row in rows]
    texts = "\n".join(map(repr, report.blocks))
    assert "vection while bike played" in texts
    assert "First-order model of ratings" in texts


def test_a_curve_is_drawn_beside_its_force(make_answers):
    rng = np.random.default_rng(3)
    made = replace(make_answers(1), courses=(simulated_course(1, rng, 2.0, 9.0, 0.5),))
    (drawn,) = course_figures(made).items()
    assert drawn[0] == "over-time-match-clip-1"
    panels = drawn[1].axes
    assert [one.get_ylabel() for one in panels] == ["match (-50 to 50)", "force, N"]
    mean = np.nanmean(made.courses[0].values, axis=0)
    np.testing.assert_allclose(panels[0].lines[0].get_ydata(), mean)
    assert len(panels[0].collections) == 1  # the band


def test_ratings_are_shown_without_sequences(watched, manual_clock, quick):
    content = json.loads(watched.content)
    for one in content["sequences"]:
        one["folder"] = ""
    study = change_definition(watched, content)
    written(study, manual_clock, people=3)
    answers = read_answers(study.folder, lambda _fraction, _step: None)
    assert all(one.force_n is None for one in answers.courses)
    assert any("without the force" in text for text in answers.notices)
    report = analyse_study(answers, AnalysisOptions(resampling=quick))
    assert report.numbers["over_time"]["match"]["first_order"] is None
