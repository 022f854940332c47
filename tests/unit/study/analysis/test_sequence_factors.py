"""Factors of the sequences, such as the viewpoint, against clmm of R's `ordinal` 2022.11-16.

R: clmm(y ~ f * v + (1 | p:f:v) + (1 | p:f) + (1 | p) + (1 | s)) and, for the factor itself,
(1 | p:v) in place of (1 | p:f), with `clmm.control(gradTol = 1e-7)`.
"""

import json
from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from hapticplayer import cli
from hapticplayer.errors import StudyError
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import AnalysisOptions, model_power
from hapticplayer.study.analysis.analysis import analyse
from hapticplayer.study.analysis.blocks import Paragraph, ReportFigure, ReportTable
from hapticplayer.study.analysis.power import PowerGoal, find_level_power
from hapticplayer.study.analysis.rank_tests import signed_rank
from hapticplayer.study.analysis.report import analyse_study, parts_of
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.sequence_factor_tests import (
    aligned,
    mixed,
    signed_ranks,
)
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import (
    change_definition,
    create_study,
    new_definition,
)
from hapticplayer.study.definition_reader import parse_definition
from hapticplayer.study.study_export import export_study

LEVELS = ("first", "third") * 3
FEEDBACKS = ("none", "random", "realistic")


def drawn_values() -> np.ndarray:
    """People who prefer feedbacks and viewpoints, answers (12, 6, 3) from 1 to 5."""
    rng = np.random.default_rng(21)
    third = np.array([one == "third" for one in LEVELS]).astype(int)
    latent = rng.logistic(size=(12, 6, 3)) + 0.8 * rng.normal(size=(12, 1, 1))
    latent += rng.normal(size=(12, 1, 3))
    latent += 0.9 * rng.normal(size=(12, 2, 1))[:, third]
    latent += 0.8 * rng.normal(size=(12, 2, 3))[:, third]
    latent += 0.4 * rng.normal(size=(6, 1)) - 0.5 * third[:, None]
    latent += np.array([0.0, 0.6, 2.0]) * (1.0 - 0.6 * third)[:, None]
    return 1.0 + np.searchsorted([-1.5, -0.5, 0.5, 1.5], latent)


def sample_with(values: np.ndarray) -> Sample:
    people = tuple(f"P{i}" for i in range(len(values)))
    means = np.nan_to_num(values).mean(axis=1)
    of = "comfort", FEEDBACKS, people, means, (), {}, (None,) * len(people), values
    return Sample(*of, people, sequence_factors={"viewpoint": LEVELS})


def test_mixed_models_with_a_factor_are_those_of_clmm() -> None:
    found = mixed(sample_with(drawn_values()), "viewpoint")
    ratios = found["viewpoint"], found["viewpoint x feedback"]
    chi2 = [one["chi2"] for one in ratios]
    np.testing.assert_allclose(chi2, [2.10679, 17.41502], rtol=1e-3)
    p = [one["p_all"] for one in ratios]
    np.testing.assert_allclose(p, [0.14665, 0.00016534], rtol=2e-3)
    variances = [np.square(one["deviations"]) for one in ratios]
    of_levels, of_feedbacks = (
        (1.346612, 0.130720, 0.184868, 0.006312),
        (0.904035, 0.0, 0.375873, 0.004781),
    )
    np.testing.assert_allclose(variances[0], of_levels, rtol=2e-3, atol=1e-4)
    np.testing.assert_allclose(variances[1], of_feedbacks, rtol=2e-3, atol=1e-4)
    for name, estimate, error in (
        ("first-third", -0.639725, 0.419162),
        ("none-random, first", -0.413267, 0.589819),
        ("none-realistic, first", 3.647947, 0.743196),
        ("none-realistic, third", 0.549109, 0.578007),
        ("none-random, first-third", 0.520868, 0.830128),
        ("none-realistic, first-third", -3.098838, 0.933832),
    ):
        assert found[name]["estimate"] == pytest.approx(estimate, rel=1e-3), name
        assert found[name]["error"] == pytest.approx(error, rel=1e-3), name


def test_means_of_levels_are_compared_as_they_are_by_hand() -> None:
    values = drawn_values()
    values[3, 1, 2] = np.nan  # one sequence of the third person, left out for this one
    values[5, ::2, 0] = np.nan  # nothing of the first person
    found = signed_ranks(sample_with(values), "viewpoint")
    means = np.stack([values[:, ::2].mean(axis=1), values[:, 1::2].mean(axis=1)])
    means[1, 3] = values[3, 3::2].mean(axis=0)
    means = np.delete(means, 5, axis=1)
    whole = signed_rank(*means.mean(axis=2))
    assert found["first-third"] == whole
    apart = means[:, :, 2] - means[:, :, 0]
    assert found["none-realistic, first-third"] == signed_rank(*apart)
    assert found["first-third"]["n"] == 11


def test_levels_are_compared_by_their_aligned_ranks() -> None:
    """With two levels F is t squared, of the ranks without all other effects."""
    values = drawn_values()
    found = aligned(sample_with(values), "viewpoint")
    means = np.stack([values[:, ::2].mean(axis=1), values[:, 1::2].mean(axis=1)])
    grand = means.mean(axis=1)  # (L, F)
    apart = means - grand[:, None] + grand.mean(axis=1)[:, None, None] - grand.mean()
    ranks = stats.rankdata(np.round(apart, 9)).reshape(means.shape).mean(axis=2)
    t = stats.ttest_rel(*ranks)
    assert found["viewpoint"]["f"] == pytest.approx(t.statistic**2)
    assert found["viewpoint"]["p"] == pytest.approx(t.pvalue)
    assert found["viewpoint x feedback"]["df"] == (2.0, 22.0)


def test_a_level_without_answers_is_told_and_not_tested(make_answers, quick) -> None:
    answers = make_answers(3, 8)
    of = {"viewpoint": ("first", "third", "first", "third")}
    ratings = [
        replace(one, value=None if one.sequence in ("clip-1", "clip-3") else one.value)
        for one in answers.ratings
    ]
    made = replace(
        answers,
        ratings=tuple(one for one in ratings if one.factor == "comfort"),
        factors=("comfort",),
        qoe=(),
        sequence_factors=of,
    )
    found = analyse(made, AnalysisOptions(resampling=quick))
    assert found.found["factor_logit"]["comfort"] is None
    report = parts_of(found)
    assert any("comfort: the mixed model with factors" in str(b) for b in report.blocks)


@pytest.fixture
def viewpoint(tmp_path):
    return create_study(tmp_path / "study", "viewpoint")


def simulate(study, *words):
    command = ["study", "simulate", str(study.folder), "--participants", "12"]
    assert cli.main([*command, "--seed", "4", *words]) == 0


def test_a_report_says_whether_force_adds_as_much_to_views(viewpoint, capsys):
    claims = ("qoe: realistic > none", "qoe: realistic less none: first > third")
    content = json.loads(viewpoint.content)
    content["pages"][1]["questions"] = content["pages"][1]["questions"][:1]
    viewpoint = change_definition(viewpoint, content)
    plan = ["study", "preregister", str(viewpoint.folder), "--participants", "12"]
    plan += ["--without-power", "a pilot"]
    assert cli.main([*plan, *(f"--hypothesis={one}" for one in claims)]) == 0
    simulate(viewpoint, "--level", "third=0.2")
    report = analyse_study(read_answers(viewpoint.folder))
    results = report.numbers["preregistration"]["hypotheses"]
    assert all("It was supported" in one["result"] for one in results), results
    assert report.numbers["preregistration"]["deviations"] == []
    mixed_model = report.numbers["factor_logit"]["qoe"]
    assert mixed_model["viewpoint x feedback"]["p_all"] < 0.01
    assert mixed_model["none-realistic, first-third"]["interval"][1] < 0.0
    assert report.numbers["factor_ranks"]["qoe"]["viewpoint x feedback"]["p"] < 0.01
    paragraphs = "\n".join(b.text for b in report.blocks if isinstance(b, Paragraph))
    assert "first in bike-first and car-turning-first" in paragraphs
    assert (
        "Mean positions of the trials with each level: 6.50 (first) and 6.50"
        in paragraphs
    )
    titles = [b.title for b in report.blocks if isinstance(b, ReportTable)]
    assert sum("Factors of the sequences x feedback" in one for one in titles) == 2
    figures = {b.name for b in report.blocks if isinstance(b, ReportFigure)}
    assert figures == set(report.draw())
    assert {"ratings-by-viewpoint", "effects-by-viewpoint"} <= figures


def test_levels_are_columns_of_each_export(viewpoint, tmp_path, manual_clock):
    answers = simulated_answers(
        2,
        "1",
        seed=1,
        sequences=tuple(one.key for one in viewpoint.definition.sequences),
    )
    write_answers(viewpoint, answers, manual_clock, origin={"simulated": True})
    for form, pattern, mark in (
        ("csv", "*trials.csv", ","),
        ("bids", "*_beh.tsv", "\t"),
    ):
        export_study(viewpoint, tmp_path / form, form)
        path = next((tmp_path / form).rglob(pattern))
        head, *rows = (line.split(mark) for line in path.read_text().splitlines())
        at, sequence = head.index("viewpoint"), head.index("sequence")
        assert all(row[sequence].endswith(row[at]) for row in rows)
        assert len({row[at] for row in rows}) == 2
    sidecar = json.loads((tmp_path / "bids" / "task-qoe_beh.json").read_text())
    assert sidecar["viewpoint"]["Levels"] == {"first": "first", "third": "third"}


@pytest.mark.parametrize(
    ("change", "place"),
    [
        (lambda all_of: all_of[1].clear(), "sequences[1].factors: "),
        (lambda all_of: [one.update(viewpoint="first") for one in all_of], "2 to 6"),
        (lambda all_of: [one.update(none="x") for one in all_of], "something else"),
        (lambda all_of: all_of[0].update(viewpoint="random"), "something else"),
        (lambda all_of: all_of[0].update(viewpoint="bike-first"), "something else"),
        (lambda all_of: all_of[0].update(viewpoint="all"), "something else"),
        (  # of which the report has a figure
            lambda all_of: [one.update(measure=one.pop("viewpoint")) for one in all_of],
            "'measure' is the name of something else",
        ),
        (
            lambda all_of: [one.update(v=f"x{one['viewpoint']}") for one in all_of],
            "as another factor does",
        ),
        (lambda all_of: all_of[0].update(viewpoint=""), "sequences[0].factors"),
    ],
)
def test_factors_that_say_nothing_are_refused(change, place) -> None:
    content = json.loads(new_definition("viewpoint"))
    change([one["factors"] for one in content["sequences"]])
    with pytest.raises(StudyError) as refusal:
        parse_definition(json.dumps(content).encode(), "study.json")
    assert place in str(refusal.value)


def test_power_of_levels_is_of_the_test_that_analyse_makes() -> None:
    """Against the signed-rank test of each simulated study by itself."""

    def draw(studies, people, rng):
        made = rng.normal(size=(studies, people, 4))
        made[..., 1] += 2.0
        return made

    goal = PowerGoal(studies=100, largest=12)
    found = find_level_power(draw, ("none", "real"), ("first", "third"), goal)
    rng = np.random.default_rng(goal.seed)
    drawn = draw(100, 12, rng)
    p = [
        [
            signed_rank(one[:, :2].mean(axis=1), one[:, 2:].mean(axis=1))["p"],
            signed_rank(one[:, 1] - one[:, 0], one[:, 3] - one[:, 2])["p"],
        ]
        for one in drawn
    ]
    smaller, larger = np.sort(p, axis=1).T
    is_first = np.argmin(p, axis=1)
    hits = np.zeros(2)
    for place in range(2):
        is_smaller = is_first == place
        p_holm = np.where(is_smaller, 2 * smaller, np.maximum(larger, 2 * smaller))
        hits[place] = (p_holm <= goal.alpha).mean()
    curves = [
        found.curves["first-third"][-1],
        found.curves["none-real, first-third"][-1],
    ]
    assert curves == hits.tolist()
    assert curves[1] > 0.5


def test_power_by_the_model_says_that_it_is_not_of_factors(
    viewpoint, capsys, monkeypatch
) -> None:
    monkeypatch.setattr(model_power, "significant_shares", lambda *_: np.full(5, 0.5))
    simulate(viewpoint)
    capsys.readouterr()
    words = ["study", "power", str(viewpoint.folder), "--largest", "4", "--json"]
    assert cli.main([*words, "--model", "logit"]) == 0
    told = capsys.readouterr()
    assert "levels" not in json.loads(told.out)
    assert "--model tests feedbacks alone" in told.err


def test_power_tells_levels_where_the_effect_differs(capsys) -> None:
    words = ["study", "power", "--studies", "100", "--largest", "20", "--json"]
    assert cli.main([*words, "--level", "first=1", "--level", "third=0.2"]) == 0
    told = json.loads(capsys.readouterr().out)
    curves = told["levels"][0]["curves"]
    assert curves["none-realistic, first-third"][-1] > 0.8
    assert curves["first-third"][-1] < 0.2  # the share moves no level as a whole
    assert "0.2 of it at third" in told["population"]
    for wrong in (["first=1"], ["first=1", "third=nan"], ["first=1", "first=2"]):
        given = [word for one in wrong for word in ("--level", one)]
        assert cli.main([*words, *given]) == 2
        assert "--level" in capsys.readouterr().err
