import numpy as np
import pytest
from scipy import stats

from hapticplayer.study.analysis.friedman import conover, friedman


@pytest.mark.parametrize(
    ("chi2", "w", "p"),
    [
        (24.71, 0.824, 4.3e-6),
        (26.68, 0.889, 1.6e-6),
        (23.05, 0.768, 9.9e-6),
        (8.79, 0.293, 0.0123),
    ],
)
def test_the_papers_chi_squares_give_the_known_w(chi2, w, p, quick):
    """scipy finds the table of 15 x 3, with ties, that is nearest to the printed one.

    Chi-square has two decimals: 0.005 of it are 0.00017 of W, and W has three decimals.
    """
    rng = np.random.default_rng(0)
    tables = rng.normal(size=(20_000, 15, 3)) * rng.uniform(0.5, 2.0, (20_000, 1, 1))
    tables = np.round(tables + rng.uniform(0.2, 4.0, (20_000, 1, 1)) * np.arange(3))
    reached = stats.friedmanchisquare(*np.moveaxis(tables, 2, 0), axis=1).statistic
    found = friedman(tables[np.nanargmin(np.abs(reached - chi2))], quick, "paper")
    assert found["chi2"] == pytest.approx(chi2, abs=0.005)
    assert found["kendall_w"] == pytest.approx(w, abs=0.0007)
    assert found["p"] == pytest.approx(p, rel=0.02)


def test_the_published_critical_values_are_met(quick):
    """Table of Friedman's statistic for k = 3: n = 4 and 8.0, n = 3 and 6.0."""
    for n, chi2, p in ((4, 8.0, 0.0046), (3, 6.0, 0.028)):
        agreed = friedman(np.tile([1.0, 2.0, 3.0], (n, 1)), quick, "table")
        assert agreed["chi2"] == pytest.approx(chi2)
        assert agreed["p_exact"] == pytest.approx(p, abs=5e-4)


def test_full_agreement_has_no_finite_f_and_conover_no_finite_t(quick):
    values = np.tile([1.0, 2.0, 3.0], (15, 1))
    found = friedman(values, quick, "agreed")
    assert (found["chi2"], found["kendall_w"]) == pytest.approx((30.0, 1.0))
    assert (found["f"], found["p_f"]) == (None, 0.0)
    assert found["p_exact"] == pytest.approx(6 / 6**15)
    assert [one["t"] for one in conover(values, [(0, 1), (1, 2)])] == [None, None]


@pytest.mark.parametrize("n", [0, 1, 5])
def test_without_anything_to_compare_there_is_no_statistic(n, quick):
    found = friedman(np.full((n, 3), 2.0), quick, "flat")
    assert (found["chi2"], found["p"], found["kendall_w"], found["p_exact"]) == (
        None,
    ) * 4
