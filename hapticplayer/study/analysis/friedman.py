"""Friedman's test of k related samples with exact p, and its post-hoc tests.

chi2 is corrected for ties (Conover 1999, 5.8); Kendall's W = chi2 / (n(k-1));
F = W(n-1)/(1-W) with k-1-2/n and (n-1)(k-1-2/n) degrees of freedom (Kendall and
Babington Smith 1939) is closer than chi2 for small n.
"""

import itertools
import math
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.references import (
    CONOVER_1999,
    FRIEDMAN_1937,
    KENDALL_1939,
    NEMENYI_1963,
    PHIPSON_2010,
)
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.statistic import (
    ALPHA,
    Found,
    Holm,
    ReportColumn,
    Statistic,
    degrees,
    number,
    p_value,
    ways,
)

MOST_STEPS = 100_000_000
"""Most additions for an exact p (about 0.2 s)."""
_UNDEFINED = {
    0: "there are no ratings of all of them",
    1: "one participant alone has ratings of all of them",
}


def friedman(values: Floats, resampling: Resampling, label: str) -> Found:
    """Compare the columns of `values` (n, k) within its rows.

    Undefined values are None (fewer than two participants, all tied). `f_df` are the
    degrees of freedom of `f`; `p_exact_method` is "exact" or "permutation, N".
    """
    n, k = values.shape
    found: Found = {"n": n, "k": k, "df": k - 1, "mean_ranks": []}
    found |= dict.fromkeys(
        ["chi2", "p", "kendall_w", "p_exact", "p_exact_method", "f", "f_df", "p_f"]
    )
    if n < 2:
        return found
    ranks = scipy.stats.rankdata(values, axis=1)
    found["mean_ranks"] = ranks.mean(axis=0).tolist()
    chi2 = float(chi_squares(values))
    if math.isnan(chi2):
        return found
    found |= {"chi2": chi2, "p": float(scipy.stats.chi2.sf(chi2, k - 1))}
    found["kendall_w"] = w = chi2 / (n * (k - 1))
    found["p_exact"], found["p_exact_method"] = exact_p(ranks, resampling, label)
    df = k - 1 - 2.0 / n
    if df > 0.0:
        found["f_df"] = [df, (n - 1) * df]
        if math.isclose(w, 1.0, abs_tol=1e-12):
            found["p_f"] = 0.0  # f is infinite
        else:
            found["f"] = f = w * (n - 1) / (1.0 - w)
            found["p_f"] = float(scipy.stats.f.sf(f, *found["f_df"]))
    return found


def chi_squares(values: Floats) -> Floats:
    """Return chi-square of (..., n, k), corrected for ties; NaN if all are tied.

    scipy refuses two columns, of which Friedman's test is the sign test.
    """
    with np.errstate(invalid="ignore"):
        if values.shape[-1] == 2:
            signs = np.sign(values[..., 1] - values[..., 0])
            found = signs.sum(axis=-1) ** 2 / np.abs(signs).sum(axis=-1)
        else:
            columns = np.moveaxis(values, -1, 0)
            found = scipy.stats.friedmanchisquare(*columns, axis=-1).statistic
    return np.asarray(found, np.float64)


def exact_p(ranks: Floats, resampling: Resampling, label: str) -> tuple[float, str]:
    """Return the exact or permutation p of the rank sums, and the method.

    No library has an exact p for tied ranks, which ratings of five steps always have.

    Args:
        ranks: (n, k), mid-ranks within each row.
        resampling: used if an exact p would take too long.
        label: of this use.
    """
    doubled = np.rint(2.0 * (ranks - 1.0)).astype(np.int64)
    if can_be_counted(*ranks.shape):
        return _counted_p(doubled), "exact"
    return _drawn_p(doubled, resampling, label), f"permutation, {resampling.count}"


def can_be_counted(n: int, k: int) -> bool:
    """Whether an exact p of (n, k) takes at most MOST_STEPS additions."""
    cells: int = (2 * n * (k - 1) + 1) ** (k - 1)
    return cells * math.factorial(k) * n <= MOST_STEPS


def _counted_p(doubled: NDArray[np.int64]) -> float:
    squares, at_least = _null(
        tuple(sorted(tuple(sorted(row)) for row in doubled.tolist()))
    )
    observed = (doubled.sum(axis=0) ** 2).sum()
    return min(1.0, float(at_least[np.searchsorted(squares, observed)]))


@lru_cache(maxsize=512)
def _null(rows: tuple[tuple[int, ...], ...]) -> tuple[NDArray[np.int64], Floats]:
    """Squares of the rank sums in ascending order, and the share of orders with at least each.

    Convolves the rows to the distribution of the first k-1 rank sums. It depends on the
    ties in the rows alone, so that simulated studies share it.
    """
    n, k = len(rows), len(rows[0])
    size = 2 * n * (k - 1) + 1
    share = np.zeros((size,) * (k - 1))
    share[(0,) * (k - 1)] = 1.0
    for row in rows:
        orders = list(itertools.permutations(row))
        added = np.zeros_like(share)
        for order in orders:
            into = tuple(slice(step, None) for step in order[:-1])
            from_ = tuple(slice(0, size - step) for step in order[:-1])
            added[into] += share[from_]
        share = added / len(orders)
    sums = np.indices(share.shape)
    rest = sum(sum(row) for row in rows) - sums.sum(axis=0)
    squares, places = np.unique((sums**2).sum(axis=0) + rest**2, return_inverse=True)
    each = np.bincount(places.ravel(), share.ravel())
    return squares, np.asarray(np.cumsum(each[::-1])[::-1], np.float64)


def _drawn_p(doubled: NDArray[np.int64], resampling: Resampling, label: str) -> float:
    rng = resampling.generator(f"friedman/{label}")
    observed = (doubled.sum(axis=0) ** 2).sum()
    drawn, hits = 0, 0
    while drawn < resampling.count:
        rows = min(resampling.count - drawn, 1000)
        orders = rng.permuted(np.broadcast_to(doubled, (rows, *doubled.shape)), axis=2)
        hits += int(((orders.sum(axis=1) ** 2).sum(axis=1) >= observed).sum())
        drawn += rows
    return (hits + 1) / (drawn + 1)


def nemenyi(values: Floats, pairs: list[tuple[int, int]]) -> list[Found]:
    """Compare pairs of columns of `values` (n, k); p is corrected for all pairs.

    q = |mean rank difference| / sqrt(k(k+1)/(6n)), referred to the studentised range
    with infinite degrees of freedom (q sqrt 2). scikit-posthocs gives the same, but
    needs seaborn.
    """
    n, k = values.shape
    means = scipy.stats.rankdata(values, axis=1).mean(axis=0)
    error = math.sqrt(k * (k + 1) / (6.0 * n))
    q = [float(abs(means[i] - means[j]) / error) for i, j in pairs]
    p = scipy.stats.studentized_range.sf(np.array(q) * math.sqrt(2.0), k, math.inf)
    return [
        {"q": one, "p": min(1.0, float(p_one))}
        for one, p_one in zip(q, np.atleast_1d(p), strict=True)
    ]


def conover(values: Floats, pairs: list[tuple[int, int]]) -> list[Found]:
    """Compare pairs of columns of `values` (n, k), n > 1; p is not corrected.

    t = |R_i - R_j| / sqrt(2 (n A - sum R^2) / ((n-1)(k-1))) with the rank sums R, the sum
    of squared ranks A and (n-1)(k-1) degrees of freedom (Conover 1999, 5.8). If all
    participants agree, t is infinite (None); scikit-posthocs divides by zero.
    """
    n, k = values.shape
    ranks = scipy.stats.rankdata(values, axis=1)
    sums = ranks.sum(axis=0)
    left = n * float((ranks**2).sum()) - float((sums**2).sum())
    df = (n - 1) * (k - 1)
    if left <= 0.0:  # exact: multiples of one half
        same = [float(sums[i] == sums[j]) for i, j in pairs]
        return [{"t": None, "df": df, "p": one} for one in same]
    error = math.sqrt(2.0 * left / df)
    t = [float(abs(sums[i] - sums[j]) / error) for i, j in pairs]
    return [
        {"t": one, "df": df, "p": float(2.0 * scipy.stats.t.sf(one, df))} for one in t
    ]


def _of_sample(sample: Sample, resampling: Resampling) -> Found:
    found = friedman(sample.values, resampling, sample.measure)
    ranks = dict(zip(sample.feedbacks, found["mean_ranks"], strict=False))
    return {**found, "mean_ranks": ranks}


def _warnings(found: dict[str, Found]) -> list[str]:
    warned = []
    for measure, one in found.items():
        if one["chi2"] is None:
            why = _UNDEFINED.get(one["n"], "all ratings are tied")
            warned.append(f"{measure}: the feedbacks cannot be compared ({why}).")
        elif (one["p"] < ALPHA) != (one["p_exact"] < ALPHA):
            warned.append(
                f"{measure}: p of Friedman's chi-square ({one['df']} df) is "
                f"{one['p']:.3f}, the permutation p {one['p_exact']:.3f}; use the "
                "latter."
            )
    return warned


def _methods(found: dict[str, Found]) -> str:
    drawn = {str(one["p_exact_method"]).partition(", ")[2] for one in found.values()}
    way = ways(
        found.values(),
        "p_exact_method",
        {
            "exact": "exact (all orders of the mid-ranks within participants, ties "
            "included, were counted)",
            "permutation": f"by Monte Carlo ({max(drawn)} random orders of the mid-ranks "
            "within participants; p = (b + 1)/(m + 1) for b of m orders at least as "
            "extreme; Phipson and Smyth, 2010)",
        },
    )
    return (
        "Feedbacks were compared by Friedman's test (Friedman, 1937) with chi-square "
        f"corrected for ties (Conover, 1999). Its permutation p was {way or 'not defined'}. "
        "Kendall's W is the effect size; F of Kendall and Babington Smith (1939) is "
        "given for comparison."
    )


FRIEDMAN = Statistic(
    "friedman",
    "Friedman's test over the feedbacks, of the means over the sequences",
    _of_sample,
    of="measure",
    columns=(
        ReportColumn("n", "n", str),
        ReportColumn("chi²", "chi2"),
        ReportColumn("df", "df", str),
        ReportColumn("p", "p", p_value),
        ReportColumn("Kendall's W", "kendall_w", lambda w: number(w, 3)),
        ReportColumn("p (permutation)", "p_exact", p_value),
        ReportColumn("p (Holm)", "p_holm", p_value),
        ReportColumn("F", "f"),
        ReportColumn("df of F", "f_df", degrees),
        ReportColumn("p of F", "p_f", p_value),
    ),
    note="F: of Kendall and Babington Smith.",
    assumes="Friedman's test assumes that participants are independent of each other and "
    "that the values of one participant can be ranked; the null hypothesis is that every order is "
    "equally probable. Chi-square (corrected for ties) is an approximation for many "
    "participants; the permutation p beside it is given the ties, and is the "
    "one that is corrected over the measures (Holm). Kendall's W tells how much the "
    "participants agree, from 0 to 1.",
    warn=_warnings,
    rows=lambda found: {"": found},
    holm=Holm("p_exact", "all measures"),
    methods=_methods,
    references=(FRIEDMAN_1937, CONOVER_1999, KENDALL_1939, PHIPSON_2010),
)

NEMENYI = Statistic(
    "nemenyi",
    "Pairs of feedbacks: Nemenyi's test (q and p for all pairs together)",
    lambda sample, _: sample.each_pair(lambda pairs: nemenyi(sample.values, pairs)),
    of="pair",
    columns=(ReportColumn("q", "q"), ReportColumn("p", "p", p_value)),
    assumes="Nemenyi's test compares pairs by the ranks among all feedbacks, and is meant "
    "to follow a significant Friedman test. It corrects for all pairs and is conservative.",
    methods=lambda _: (
        "Nemenyi's test (1963) refers differences of mean ranks to the "
        "studentised range with infinite degrees of freedom."
    ),
    references=(NEMENYI_1963,),
)

CONOVER = Statistic(
    "conover",
    "Pairs of feedbacks: Conover's test",
    lambda sample, _: sample.each_pair(lambda pairs: conover(sample.values, pairs)),
    of="pair",
    columns=(
        ReportColumn("t", "t"),
        ReportColumn("df", "df", str),
        ReportColumn("p", "p", p_value),
        ReportColumn("p (Holm)", "p_holm", p_value),
    ),
    assumes="Conover's test compares pairs by the ranks among all feedbacks, and is meant "
    "to follow a significant Friedman test. It is more sensitive than Nemenyi's, and relies on a "
    "significant omnibus test.",
    holm=Holm("p", "each measure"),
    methods=lambda _: (
        "Conover's test (1999, 5.8) refers differences of rank sums to Student's t."
    ),
    references=(CONOVER_1999,),
)
