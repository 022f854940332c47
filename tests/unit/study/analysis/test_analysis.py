import json
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.errors import Cancelled, InputError
from hapticplayer.study.analysis import AnalysisOptions, MissingPolicy, analyse
from hapticplayer.study.analysis.analysis import summary, warnings_of
from hapticplayer.study.analysis.scores import sample_of, scores_of


@pytest.fixture(scope="module")
def choices(quick) -> AnalysisOptions:
    return AnalysisOptions(resampling=quick)


@pytest.fixture(scope="module")
def answers(make_answers):
    return make_answers(1, 15)


@pytest.fixture(scope="module")
def analysed(answers, choices):
    """Made once: most tests look at the same analysis."""
    return analyse(answers, choices)


def without(answers, **cell):
    """Return the answers with a hole where everything of `cell` is so."""
    ratings = tuple(
        replace(one, value=None)
        if all(getattr(one, key) == value for key, value in cell.items())
        else one
        for one in answers.ratings
    )
    return replace(answers, ratings=ratings)


def test_the_summary_has_the_promised_shape_and_is_plain_json(analysed):
    found = summary(analysed)
    text = json.dumps(found, allow_nan=False)
    assert json.loads(text) == found
    assert list(found["qoe"]) == ["none", "random", "realistic"]
    measures = ["qoe", "realism", "sensory", "comfort", "satisfaction"]
    for test in ("friedman", "shapiro", "wilcoxon", "mann_whitney", "structure"):
        assert list(found[test]) == measures
    assert {"chi2", "p", "kendall_w", "p_exact", "p_holm"} <= set(
        found["friedman"]["realism"]
    )
    assert list(found["wilcoxon"]["qoe"]) == [
        "none-random",
        "none-realistic",
        "random-realistic",
    ]
    assert {"seed", "versions"} <= set(found["provenance"])


def test_qoe_is_the_sum_of_the_factors(answers, analysed):
    found = summary(analysed)
    for feedback, one in found["qoe"].items():
        parts = sum(
            found["factors"][name][feedback]["mean"] for name in answers.factors
        )
        assert one["mean"] == pytest.approx(parts)


def test_the_same_seed_gives_the_same_numbers_in_any_order(answers, choices, analysed):
    turned = replace(answers, ratings=answers.ratings[::-1])
    for one in (answers, turned):
        assert summary(analyse(one, choices)) == summary(analysed)


def test_a_hole_takes_its_sequence_out_of_all_feedbacks(answers):
    holed = without(
        answers, participant="P03", sequence="clip-2", feedback="none", factor="comfort"
    )
    whole, found = scores_of(answers), sample_of(scores_of(holed), "qoe")
    kept = [whole.sequences.index(name) for name in ("clip-0", "clip-1", "clip-3")]
    expected = whole.of("qoe")[3, kept].mean(axis=0)
    assert found.values[3].tolist() == pytest.approx(expected.tolist())
    assert found.reduced == {"P03": ("clip-2",)}
    assert found.dropped == ()
    assert sample_of(scores_of(holed), "realism").reduced == {}


def test_complete_means_without_those_who_left_a_hole(answers):
    holed = without(answers, participant="P03", sequence="clip-2", factor="comfort")
    found = sample_of(scores_of(holed), "qoe", MissingPolicy.COMPLETE)
    assert found.dropped == ("P03",)
    assert len(found.values) == 14


@pytest.mark.usefixtures("without_models")
def test_who_is_left_out_is_named_in_the_numbers_and_in_words(answers, choices):
    holed = without(answers, participant="P03", feedback="random")
    found = summary(analyse(holed, choices))
    assert found["missing"]["answers_missing"] == 16
    assert found["missing"]["measures"]["qoe"]["dropped"] == ["P03"]
    assert found["friedman"]["qoe"]["n"] == 14
    assert any("16 of 720 answers are missing" in text for text in found["warnings"])
    assert any(text.startswith("qoe: P03 is excluded") for text in found["warnings"])


def test_unsound_trials_do_not_count_unless_wanted(answers):
    ratings = tuple(
        replace(one, is_valid=one.sequence != "clip-1" or one.participant != "P00")
        for one in answers.ratings
    )
    marked = replace(answers, ratings=ratings)
    scores = scores_of(marked)
    assert (scores.invalid, scores.missing) == (12, 12)
    assert np.isnan(scores.ratings[0, 1]).all()
    assert scores_of(marked, include_invalid=True).missing == 0


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda _: {"participants": ()}, "no participant"),
        (lambda _: {"feedbacks": ("none",)}, "two feedbacks"),
    ],
)
def test_answers_that_do_not_fit_their_design_are_refused(answers, change, said):
    with pytest.raises(InputError) as refused:
        scores_of(replace(answers, **change(answers)))
    assert said in str(refused.value)


@pytest.mark.parametrize("people", [1, 2, 3])
@pytest.mark.parametrize("feedbacks", [("a", "b"), ("a", "b", "c", "d", "e", "f")])
def test_small_and_odd_studies_are_analysed(make_answers, choices, people, feedbacks):
    answers = make_answers(2, people, sequences=1 + people % 2, feedbacks=feedbacks)
    found = summary(analyse(answers, choices))
    json.dumps(found, allow_nan=False)
    assert found["qoe"]["a"]["n"] == people
    assert any("are needed" in text for text in found["warnings"])


def test_a_study_in_which_everybody_says_the_same_is_analysed(answers, choices):
    ratings = tuple(replace(one, value=3) for one in answers.ratings)
    found = summary(analyse(replace(answers, ratings=ratings), choices))
    assert found["friedman"]["qoe"]["p"] is None
    assert found["wilcoxon"]["qoe"]["none-random"]["p"] is None
    assert found["shapiro"]["qoe"]["none"] == {"w": None, "p": None}
    assert any("all ratings are tied" in text for text in found["warnings"])


def test_ratings_that_are_not_there_are_not_called_tied(answers, choices):
    holed = without(answers, feedback="random")
    told = warnings_of(analyse(holed, choices))
    assert not any("tied" in text for text in told)
    why = "the feedbacks cannot be compared (there are no ratings of all of them)."
    assert f"qoe: {why}" in told


def test_a_study_without_any_answer_is_analysed(answers, choices):
    ratings = tuple(replace(one, value=None) for one in answers.ratings)
    found = summary(analyse(replace(answers, ratings=ratings), choices))
    assert found["qoe"]["none"]["mean"] is None
    assert found["missing"]["measures"]["qoe"]["used"] == 0


def test_the_analysis_stops_when_asked(answers, choices):
    def stop(fraction: float, _step: str) -> None:
        if fraction > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        analyse(answers, choices, stop)


def test_experienced_participants_are_compared_with_the_others(answers, analysed):
    one = analysed.found["mann_whitney"]["qoe"]["none"]
    used = [person.used_device_before for person in answers.participants]
    assert (one["n_before"], one["n_new"]) == (used.count(True), used.count(False))


def test_corrections_are_over_measures_and_over_groups(analysed):
    found = summary(analysed)
    raw = sorted(one["p_exact"] for one in found["friedman"].values())
    least = min(one["p_holm"] for one in found["friedman"].values())
    assert least == pytest.approx(min(1.0, 5 * raw[0]))
    tests = [t for one in found["mann_whitney"].values() for t in one.values()]
    assert len(tests) == 15
    least = min(test["p"] for test in tests)
    assert min(test["p_holm"] for test in tests) == pytest.approx(min(1.0, 15 * least))
