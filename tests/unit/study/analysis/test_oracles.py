"""The statistics against scipy, scikit-posthocs, pingouin and statsmodels.

60 seeded studies with ties (integers of five steps) and holes. Agreement within 1e-9
relative or absolute: both sides are closed forms of the same ranks in doubles.
"""

import itertools
import warnings

import numpy as np
import pandas as pd
import pytest
import scikit_posthocs
from scipy import stats
from statsmodels.stats.multitest import multipletests

from hapticplayer.study.analysis.aligned_ranks import align, aligned_ranks, structure
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.effect_sizes import (
    independent_interval,
    matched_interval,
    rank_biserial,
)
from hapticplayer.study.analysis.friedman import (
    chi_squares,
    conover,
    exact_p,
    friedman,
    nemenyi,
)
from hapticplayer.study.analysis.rank_sum import rank_sum
from hapticplayer.study.analysis.rank_tests import (
    hodges_lehmann,
    shapiro,
    signed_rank,
)
from hapticplayer.study.analysis.scores import MissingPolicy, sample_of, scores_of
from hapticplayer.study.analysis.statistic import holm

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import pingouin

SETS = 60
EXHAUSTIVE = stats.PermutationMethod(n_resamples=np.inf)
close = pytest.approx


def exactly(value):
    return pytest.approx(value, rel=1e-9, abs=1e-9)


def studies(make_answers, count=SETS):
    """Yield studies: five to 20 people, three to five feedbacks, up to 4 % holes."""
    names = ("realistic", "none", "random", "late", "strong")
    for seed in range(count):
        rng = np.random.default_rng(seed)
        feedbacks = names[: rng.choice([3, 3, 3, 4, 5])]
        holes = rng.choice([0.0, 0.005, 0.04])
        people = int(rng.integers(5, 21))
        yield make_answers(seed, people, feedbacks=feedbacks, holes=holes, sequences=3)


@pytest.fixture(scope="module")
def samples(make_answers):
    """A measure of each study as the tests see it, (n, k) with n > 1."""
    found = []
    for number, answers in enumerate(studies(make_answers)):
        scores = scores_of(answers)
        measure = scores.measures[number % len(scores.measures)]
        found.append(sample_of(scores, measure).values)
    return [values for values in found if len(values) > 1]


def table_of(answers) -> pd.DataFrame:
    """Return the answers as pandas sees them."""
    columns = ["participant", "sequence", "feedback", "factor", "value"]
    rows = [[getattr(one, name) for name in columns] for one in answers.ratings]
    return pd.DataFrame(rows, columns=columns).astype({"value": float})


@pytest.mark.parametrize("policy", list(MissingPolicy))
def test_the_means_over_sequences_are_those_of_pandas(make_answers, policy):
    for answers in studies(make_answers):
        table = table_of(answers)
        cells = table.groupby(["participant", "sequence", "feedback"])["value"].agg(
            lambda values: values.sum(skipna=False)
        )
        wide = cells.unstack("feedback").dropna()
        if policy is MissingPolicy.COMPLETE:
            counts = wide.groupby("participant").size()
            whole = counts.index[counts == len(answers.sequences)]
            wide = wide[wide.index.get_level_values("participant").isin(whole)]
        means = wide.groupby("participant").mean()
        found = sample_of(scores_of(answers), "qoe", policy)
        assert list(found.participants) == list(means.index)
        expected = means[list(found.feedbacks)].to_numpy()
        np.testing.assert_allclose(found.values, expected, atol=1e-12)
        everyone = {person.code for person in answers.participants}
        assert set(found.dropped) == everyone - set(means.index)


def test_friedman_is_that_of_pingouin(samples, quick):
    for values in samples:
        found = friedman(values, quick, "test")
        other = pingouin.friedman(pd.DataFrame(values), method="f").iloc[0].to_dict()
        assert found["kendall_w"] == exactly(other["W"])
        assert found["f"] == exactly(other["F"])
        assert found["p_f"] == exactly(other.get("p_unc", other.get("p-unc")))


def test_two_feedbacks_are_compared_as_pingouin_does(samples):
    for values in samples:
        if (values[:, 0] == values[:, 1]).all():
            continue
        table = pd.DataFrame(values[:, :2])
        expected = pingouin.friedman(table, method="chisq").iloc[0]["Q"]
        assert chi_squares(values[:, :2]) == exactly(expected)


def test_the_exact_p_of_friedman_counts_all_orders(quick):
    rng = np.random.default_rng(3)
    for n, k in [(2, 3), (4, 3), (5, 3), (3, 4), (2, 5)]:
        for _ in range(8):
            ranks = stats.rankdata(rng.integers(1, 5, (n, k)), axis=1)
            orders = [list(itertools.permutations(row)) for row in ranks]
            squares = [
                (np.sum(choice, axis=0) ** 2).sum()
                for choice in itertools.product(*orders)
            ]
            observed = (ranks.sum(axis=0) ** 2).sum()
            expected = np.mean(np.array(squares) >= observed - 1e-9)
            p, method = exact_p(ranks, quick, "test")
            assert method == "exact"
            assert p == exactly(expected)


def test_the_drawn_p_of_friedman_is_near_the_counted_one(samples, monkeypatch):
    resampling = Resampling(seed=1, count=4000)
    for values in [v for v in samples if v.shape[1] == 3][:6]:
        ranks = stats.rankdata(values, axis=1)
        counted, _ = exact_p(ranks, resampling, "test")
        monkeypatch.setattr("hapticplayer.study.analysis.friedman.MOST_STEPS", 0)
        drawn, method = exact_p(ranks, resampling, "test")
        monkeypatch.undo()
        assert method == "permutation, 4000"
        # four standard errors of a share, and the one that is added
        assert drawn == close(counted, abs=4 * np.sqrt(counted / 4000) + 1 / 4000)


def test_nemenyi_and_conover_are_those_of_posthocs(samples, monkeypatch):
    monkeypatch.setattr("gc.collect", lambda *_: 0)  # once per call: 25 s in all
    for values in samples:
        pairs = list(itertools.combinations(range(values.shape[1]), 2))
        by_t = scikit_posthocs.posthoc_conover_friedman(values).to_numpy()
        by_range = scikit_posthocs.posthoc_nemenyi_friedman(values).to_numpy()
        for pair, one in zip(pairs, conover(values, pairs), strict=True):
            assert one["p"] == exactly(by_t[pair])
        for pair, one in zip(pairs, nemenyi(values, pairs), strict=True):
            assert one["p"] == exactly(by_range[pair])


def test_wilcoxon_is_that_of_scipy_and_pingouin(samples):
    exact = 0
    for values in samples:
        first, second = values[:, 0], values[:, 1]
        apart = np.round(second - first, 9)
        if not apart.any():
            continue
        found = signed_rank(first, second)
        normal = stats.wilcoxon(apart, method="asymptotic")
        assert min(found["w_plus"], found["w_minus"]) == exactly(normal.statistic)
        if found["n"] - found["zeros"] <= 8:
            assert found["p"] == exactly(_p_of_all_signs(apart[apart != 0]))
            exact += 1
            if exact <= 4:  # scipy's own takes its time
                counted = stats.wilcoxon(apart[apart != 0], method=EXHAUSTIVE)
                assert found["p"] == exactly(counted.pvalue)
        other = pingouin.wilcoxon(second, first, method="asymptotic").iloc[0]
        # pingouin ranks unrounded differences, where 7/3 - 5/3 and 5/3 - 1 may differ
        if len(set(np.abs(second - first))) == len(set(np.abs(apart))):
            assert found["rank_biserial"] == exactly(other["RBC"])
    assert exact > 10


def _p_of_all_signs(differences) -> float:
    ranks = stats.rankdata(np.abs(differences))
    signs = np.array(list(itertools.product([0, 1], repeat=len(ranks))))
    sums, observed = signs @ ranks, ranks[differences > 0].sum()
    tails = np.mean(sums <= observed + 1e-9), np.mean(sums >= observed - 1e-9)
    return min(1.0, 2.0 * min(tails))


def test_wilcoxon_without_ties_is_scipys_exact_one():
    rng = np.random.default_rng(4)
    for n in range(3, 40):
        first, second = rng.normal(size=n), rng.normal(0.5, size=n)
        found = signed_rank(first, second)
        assert found["p_method"] == "exact"
        reference = stats.wilcoxon(first, second, method="exact")
        assert found["p"] == exactly(reference.pvalue)


def test_the_shift_interval_holds_what_scipy_does_not_reject():
    rng = np.random.default_rng(5)
    for n in (6, 9, 15, 30):
        differences = rng.normal(0.7, 1.0, n)
        shift, (low, high) = hodges_lehmann(differences)
        assert low <= shift <= high
        for edge, inwards in ((low, 1e-9), (high, -1e-9)):
            inside = stats.wilcoxon(differences - edge - inwards, method="exact")
            outside = stats.wilcoxon(differences - edge + inwards, method="exact")
            assert inside.pvalue > 0.05 >= outside.pvalue


def test_five_pairs_are_too_few_for_an_interval():
    assert hodges_lehmann(np.arange(1.0, 6.0)) == (3.0, None)


def test_the_shift_counts_equal_differences():
    rng = np.random.default_rng(9)
    for n in (1, 2, 7, 30):
        differences = rng.integers(-3, 4, n) / 4.0
        pairs = itertools.combinations_with_replacement(differences, 2)
        assert hodges_lehmann(differences)[0] == np.median(
            [(a + b) / 2 for a, b in pairs]
        )


def test_the_effect_size_leaves_zeros_out():
    # ranks 1, 2, 3 of 1, -2, 3: (1 - 2 + 3) / 6
    assert rank_biserial(np.array([0.0, 0.0, 1.0, -2.0, 3.0])) == close(1 / 3)
    assert rank_biserial(np.zeros(5)) == 0.0


def test_intervals_of_r_leave_zero_out_where_tests_reject():
    rng = np.random.default_rng(3)
    seen = []
    for _ in range(100):
        first, second = rng.normal(0.6, 1.0, rng.integers(2, 30)), rng.normal(size=12)
        signed = stats.wilcoxon(first, method="asymptotic")
        w_plus = stats.rankdata(np.abs(first))[first > 0].sum()
        ranked = stats.mannwhitneyu(
            first, second, method="asymptotic", use_continuity=False
        )
        for reference, (low, high) in (
            (signed, matched_interval(w_plus, len(first))),
            (ranked, independent_interval(ranked.statistic, len(first), 12)),
        ):
            assert (low > 0.0 or high < 0.0) == (reference.pvalue < 0.05)
            seen.append(reference.pvalue < 0.05)
    assert 50 < sum(seen) < 150


@pytest.mark.parametrize("shift", [0.0, 1.0, 2.5])
def test_intervals_of_r_hold_the_truth_also_near_one(shift):
    # normal values: P(a + b > 0) and P(a > b) are known; 600 samples, 3 sigma = 0.027
    rng = np.random.default_rng(4)
    held = np.zeros(2)
    for _ in range(600):
        first, second = rng.normal(shift, 1.0, 15), rng.normal(size=9)
        w_plus = stats.rankdata(np.abs(first))[first > 0].sum()
        u = float((first[:, None] > second).sum())
        found = matched_interval(w_plus, 15), independent_interval(u, 15, 9)
        for place, scale in enumerate((2.0**0.5, 0.5**0.5)):
            low, high = found[place]
            held[place] += low <= 2.0 * stats.norm.cdf(shift * scale) - 1.0 <= high
    assert (held / 600 > 0.92).all()


def test_no_interval_is_a_point_where_r_is_one():
    wilcoxon = signed_rank(np.zeros(15), np.arange(1.0, 16.0))
    mann_whitney = rank_sum(np.arange(5.0, 10.0), np.arange(4.0))
    for found in (wilcoxon, mann_whitney):
        low, high = found["rank_biserial_interval"]
        assert found["rank_biserial"] == high == 1.0
        assert 0.2 < low < 0.7


def test_mann_whitney_is_that_of_scipy_and_pingouin(samples):
    exact = 0
    for values in samples:
        cut = 1 + len(values) // 3
        before, new = values[:cut, 0], values[cut:, 0]
        if not len(new) or np.ptp(values[:, 0]) == 0:
            continue
        found = rank_sum(before, new)
        other = pingouin.mwu(before, new).iloc[0]
        assert found["rank_biserial"] == exactly(other["RBC"])
        if len(values) <= 9:
            counted = stats.mannwhitneyu(before, new, method=EXHAUSTIVE)
            assert found["p"] == exactly(counted.pvalue)
            exact += 1
    assert exact > 10


def test_mann_whitney_without_ties_is_scipys_exact_one():
    rng = np.random.default_rng(6)
    for n1, n2 in itertools.product((1, 4, 9, 20), (2, 7, 15)):
        before, new = rng.normal(size=n1), rng.normal(0.5, size=n2)
        found = rank_sum(before, new)
        reference = stats.mannwhitneyu(before, new, method="exact")
        assert found["p"] == exactly(reference.pvalue)


def test_holm_is_that_of_statsmodels():
    rng = np.random.default_rng(7)
    for count in (1, 2, 5, 15):
        p = rng.uniform(0, 0.2, count).round(2)  # with ties
        assert holm(p.tolist()) == exactly(multipletests(p, method="holm")[1])


def test_holm_leaves_out_what_has_no_p():
    assert holm([0.04, None, 0.01]) == [close(0.04), None, close(0.02)]


def test_shapiro_is_that_of_pingouin(samples):
    for values in samples:
        column = values[:, 0]
        found = shapiro(column)
        if found["w"] is None:
            assert len(column) < 3 or np.ptp(column) == 0
            continue
        if len(column) > 3:
            other = pingouin.normality(column).iloc[0]
            assert (found["w"], found["p"]) == exactly(
                (other["W"], other["pval"] if "pval" in other else other["p_val"])
            )


def test_the_analysis_of_aligned_ranks_is_that_of_pingouin(make_answers):
    seen = 0
    for answers in studies(make_answers, 16):
        scores = scores_of(answers)
        values = scores.of("qoe")
        found = structure(values, scores.participants)
        whole = values[~np.isnan(values).any(axis=(1, 2))]
        if len(whole) < 5:  # pingouin divides by zero
            continue
        for place, name in enumerate(("sequence", "feedback", "interaction")):
            ranks = aligned_ranks(whole, name)
            axes = (axis.ravel() for axis in np.indices(ranks.shape))
            table = pd.DataFrame(
                dict(zip("psf", axes, strict=True)) | {"y": ranks.ravel()}
            )
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of pingouin: epsilon is approximate
                other = pingouin.rm_anova(
                    table, dv="y", within=["s", "f"], subject="p"
                ).iloc[place]
            effect = found["effects"][name]
            assert effect["f"] == exactly(other["F"])
            assert effect["epsilon"] == exactly(other["eps"])
            seen += 1
    assert seen > 20


def test_an_alignment_leaves_nothing_of_the_other_effects():
    rng = np.random.default_rng(8)
    values = rng.normal(size=(9, 4, 3)) + np.arange(12).reshape(4, 3)
    for name in ("sequence", "feedback", "interaction"):
        cells = align(values, name).mean(axis=0)
        left = {
            "sequence": cells.mean(axis=1),
            "feedback": cells.mean(axis=0),
            "interaction": cells
            - cells.mean(axis=1, keepdims=True)
            - cells.mean(axis=0),
        }
        for other, effect in left.items():
            assert (np.abs(effect).max() > 0.01) == (other == name)
