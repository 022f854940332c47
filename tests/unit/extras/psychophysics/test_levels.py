"""Curves against closed forms, scipy's own optimiser, and simulated people."""

import csv
import json

import numpy as np
import pytest
from scipy import optimize, stats

from hapticplayer import extension
from hapticplayer.errors import InputError, StudyError
from hapticplayer.extras.psychophysics.level_report import warnings_of
from hapticplayer.extras.psychophysics.levels import ALL, analyse_levels
from hapticplayer.extras.psychophysics.psychometric import CurveShape, fit
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.analysis import AnalysisOptions, Resampling
from hapticplayer.study.analysis.report import analyse_study, write_report
from hapticplayer.study.answers import Answers, Judgement, Participant, read_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.definition import TrialKind

DELAYS_S = np.array([-0.4, -0.2, -0.1, 0.0, 0.1, 0.2, 0.4, 0.8])
GAINS = np.array([0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 4.0])
LOWER_S, UPPER_S, SPREAD_S, LAPSE = -0.15, 0.25, 0.09, 0.03


def truth(x, lower=LOWER_S, upper=UPPER_S, spread=SPREAD_S, lapse=LAPSE):
    inside = stats.norm.cdf((x - lower) / spread) - stats.norm.cdf((x - upper) / spread)
    return lapse / 2.0 + (1.0 - lapse) * inside


def judged(seed, p=truth, people=20, clips=("bike", "horse"), levels=DELAYS_S):
    """Return answers of people who say yes with a probability p(delay)."""
    rng = np.random.default_rng(seed)
    codes = [f"P{i:02}" for i in range(people)]
    made = tuple(
        Judgement(code, clip, float(x), 1.0, bool(rng.random() < p(x)), is_valid=True)
        for code in codes
        for clip in clips
        for x in levels
    )
    persons = tuple(Participant(code, 30, None, None, None) for code in codes)
    return Answers(
        persons, (), clips, ("realistic",), (), judgements=made, trial=TrialKind.YES_NO
    )


def quick(count=199):
    return AnalysisOptions(resampling=Resampling(3, count))


@pytest.mark.parametrize(
    ("shape", "lower", "upper", "levels"),
    [
        (CurveShape.WINDOW, LOWER_S, UPPER_S, DELAYS_S),
        (CurveShape.RISING, LOWER_S, np.inf, DELAYS_S[:4]),
        (CurveShape.FALLING, -np.inf, UPPER_S, DELAYS_S[3:]),
    ],
)
def test_a_curve_through_exact_shares_has_their_parameters(shape, lower, upper, levels):
    asked = np.full((1, len(levels)), 100.0)
    found = fit(levels, asked * truth(levels, lower, upper), asked, shape)
    parts = (found.lower, found.upper, found.spread, found.lapse)
    expected = (lower, upper, SPREAD_S, LAPSE)
    assert np.ravel(parts) == pytest.approx(expected, abs=2e-5)


def test_no_other_curve_is_more_likely_by_scipys_optimiser():
    rng = np.random.default_rng(1)
    yes = rng.binomial(40, truth(DELAYS_S), (12, 8)).astype(float)
    found = fit(DELAYS_S, yes, np.full_like(yes, 40.0), CurveShape.WINDOW)
    for row, likelihood in zip(yes, found.likelihood, strict=True):

        def lost(v, row=row):
            p = truth(DELAYS_S, v[0], v[0] + v[1], v[2], v[3]).clip(1e-12, 1 - 1e-12)
            return -(row * np.log(p) + (40.0 - row) * np.log1p(-p)).sum()

        bounds = [(-1.6, 2.0), (0.01, 3.6), (0.01, 2.4), (0.0, 0.1)]
        starts = [(-0.15, 0.4, 0.09, 0.03), (-0.2, 0.5, 0.2, 0.01)]
        best = min(optimize.minimize(lost, s, bounds=bounds).fun for s in starts)
        assert likelihood >= -best - 1e-3


def test_intervals_hold_the_true_criteria_as_often_as_they_say():
    held = []
    for seed in range(24):
        found = analyse_levels(judged(seed, clips=("bike",)), quick())
        curve = found.axes["delay_s"].curves[ALL]
        for name, true in (("lower", LOWER_S), ("upper", UPPER_S)):
            low, high = curve.intervals[name]
            held.append(low <= true <= high)
    assert 0.87 <= np.mean(held) <= 1.0


def test_criteria_are_recovered_for_shifts_and_gains():
    found = analyse_levels(judged(1, people=100), quick())
    curve = found.axes["delay_s"].curves[ALL]
    assert curve.values["lower"] == pytest.approx(LOWER_S, abs=0.02)
    assert curve.values["upper"] == pytest.approx(UPPER_S, abs=0.02)
    assert curve.values["window"] == pytest.approx(0.4, abs=0.03)
    assert curve.values["spread"] == pytest.approx(SPREAD_S, abs=0.02)
    assert curve.p_fit > 0.05
    assert not curve.is_flat
    scaled = judged(
        2, lambda g: truth(np.log(g), np.log(0.5), np.log(2.5), 0.3), 100, levels=GAINS
    )
    gains = tuple(
        Judgement(j.participant, j.sequence, 0.0, j.delay_s, j.answer, is_valid=True)
        for j in scaled.judgements
    )
    answers = Answers(
        scaled.participants, (), scaled.sequences, ("realistic",), (), judgements=gains
    )
    values = analyse_levels(answers, quick()).axes["gain"].curves[ALL].values
    assert values["lower"] == pytest.approx(0.5, rel=0.1)
    assert values["upper"] == pytest.approx(2.5, rel=0.1)
    assert values["window"] == pytest.approx(5.0, rel=0.15)


def test_shares_are_counted_and_what_is_missing_is_reported():
    answers = judged(4, people=10, clips=("bike",))
    holes = tuple(
        Judgement(j.participant, j.sequence, j.delay_s, 1.0, None, is_valid=True)
        if j.participant == "P00"
        else j
        for j in answers.judgements
    )
    holed = Answers(
        answers.participants, (), ("bike",), ("realistic",), (), judgements=holes
    )
    found = analyse_levels(holed, quick())
    at_zero = next(s for s in found.axes["delay_s"].shares[ALL] if s.delay_s == 0.0)
    reported = [j.answer for j in holes if j.delay_s == 0.0 and j.answer is not None]
    assert (at_zero.yes, at_zero.asked) == (sum(reported), 9)
    assert found.missing == 8
    assert any("8 of 80 answers are missing" in text for text in warnings_of(found))


@pytest.mark.parametrize(
    ("p", "words"),
    [
        (lambda _x: 0.5, "do not differ significantly"),
        (lambda x: float(-0.15 < x < 0.25), "need levels in between"),
        (lambda x: 0.9 if abs(x) in {0.1, 0.4} else 0.1, "does not fit"),
    ],
)
def test_where_a_curve_does_not_hold_it_is_said(p, words):
    found = analyse_levels(judged(5, p), quick())
    assert any(words in text for text in warnings_of(found))


def test_a_study_without_a_judgement_is_refused():
    answers = judged(1, people=1)
    nothing = tuple(
        Judgement(j.participant, j.sequence, j.delay_s, 1.0, None, is_valid=True)
        for j in answers.judgements
    )
    empty = Answers(
        answers.participants,
        (),
        ("bike",),
        ("realistic",),
        (),
        judgements=nothing,
        trial=TrialKind.YES_NO,
    )
    with pytest.raises(InputError, match="no judgement"):
        analyse_study(empty)


def test_a_study_of_the_template_gets_its_report(tmp_path, manual_clock):
    study = create_study(tmp_path / "study", template="consistency")
    rng = np.random.default_rng(6)
    for _ in range(6):
        write_scripted_session(
            study,
            {"age": 31},
            lambda c: {"consistent": bool(rng.random() < truth(c.delay_s))},
            manual_clock,
            origin={"scripted": True},
        )
    found = analyse_study(read_answers(study.folder), quick())
    write_report(found, tmp_path / "report", "Shifted rides")
    names = {path.name for path in (tmp_path / "report").iterdir()}
    assert {"yes-by-time-shift.svg", "report.pdf", "report.html"} < names
    numbers = json.loads((tmp_path / "report" / "numbers.json").read_text("utf-8"))
    assert numbers == found.numbers
    with (tmp_path / "report" / "curves.csv").open(encoding="utf-8") as lines:
        rows = {(r["sequence"], r["value"]): r for r in csv.DictReader(lines)}
    curve = numbers["levels"]["delay_s"]["curves"]["all"]
    assert float(rows["all", "lower"]["estimate"]) == curve["lower"]


def test_a_curve_through_all_shares_fits():
    gains, yes = (0.5, 0.7, 1.0, 1.4, 2.0), (0, 4, 9, 6, 0)
    people = tuple(Participant(f"P{i}", 30, None, None, None) for i in range(9))
    made = tuple(
        Judgement(person.code, "bike", 0.0, gain, place < count, is_valid=True)
        for place, person in enumerate(people)
        for gain, count in zip(gains, yes, strict=True)
    )
    answers = Answers(
        people,
        (),
        ("bike",),
        ("realistic",),
        (),
        judgements=made,
        trial=TrialKind.YES_NO,
    )
    curve = analyse_levels(answers, quick(299)).axes["gain"].curves[ALL]
    assert curve.deviance < 0.01  # drawn shares have about none either
    assert curve.p_fit > 0.9


def test_judgements_without_their_extension_are_refused(monkeypatch):
    monkeypatch.setattr(extension, "rows", lambda _kind, _of: iter(()))
    with pytest.raises(StudyError, match="the analysis of yes-no trials is missing"):
        analyse_study(judged(1, people=2))
