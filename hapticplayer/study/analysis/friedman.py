"""Friedman's test of k related samples, with its exact distribution.

chi2 = (k-1) sum_j (R_j - n(k+1)/2)^2 / (A - n k (k+1)^2 / 4) with the rank sums R_j
and the sum of squared ranks A, which corrects for ties (Conover 1999, 5.8);
Kendall's W = chi2 / (n(k-1)); F = W(n-1)/(1-W) with k-1-2/n and (n-1)(k-1-2/n)
degrees of freedom (Kendall and Babington Smith 1939) is closer than chi2 for small n.
"""

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.resampling import Resampling

_MOST_STEPS = 100_000_000
"""Additions that an exact p may cost (about 0.2 s); beyond, it is drawn."""


@dataclass(frozen=True, slots=True)
class Friedman:
    """Outcome; None where it is not defined (fewer than two participants, all tied).

    Attributes:
        n: participants.
        k: feedbacks.
        df: k - 1.
        mean_ranks: by feedback, in their order; empty without participants.
        chi2: corrected for ties.
        p: of chi2.
        kendall_w: 0 (no agreement) to 1 (all rank alike).
        p_exact: of all rank orders within participants, given the ties.
        p_exact_method: "exact", or "permutation" with how many were drawn.
        f: the variant for small n.
        f_df: its degrees of freedom.
        p_f: its p.
        p_holm: p_exact corrected for the number of measures, by Holm.
    """

    n: int
    k: int
    df: int
    mean_ranks: tuple[float, ...]
    chi2: float | None = None
    p: float | None = None
    kendall_w: float | None = None
    p_exact: float | None = None
    p_exact_method: str | None = None
    f: float | None = None
    f_df: tuple[float, float] | None = None
    p_f: float | None = None
    p_holm: float | None = None


def friedman(values: Floats, resampling: Resampling, label: str) -> Friedman:
    """Compare the columns of `values` (n, k) within its rows."""
    n, k = values.shape
    if n < 2:
        return Friedman(n, k, k - 1, ())
    ranks = stats.rankdata(values, axis=1)
    mean_ranks = tuple(ranks.mean(axis=0).tolist())
    chi2 = float(chi_squares(ranks))
    if np.isnan(chi2):
        return Friedman(n, k, k - 1, mean_ranks)
    w = chi2 / (n * (k - 1))
    p_exact, method = exact_p(ranks, resampling, label)
    p = float(stats.chi2.sf(chi2, k - 1))
    small = _small_sample_f(w, n, k)
    return Friedman(n, k, k - 1, mean_ranks, chi2, p, w, p_exact, method, *small)


def chi_squares(ranks: Floats) -> Floats:
    """Return chi-square of ranks (..., n, k), corrected for ties; NaN if all are tied."""
    n, k = ranks.shape[-2:]
    spread = (ranks**2).sum(axis=(-2, -1)) - n * k * (k + 1) ** 2 / 4.0
    between = ((ranks.sum(axis=-2) - n * (k + 1) / 2.0) ** 2).sum(axis=-1)
    with np.errstate(invalid="ignore"):
        return np.asarray((k - 1) * between / spread, np.float64)


def _small_sample_f(
    w: float, n: int, k: int
) -> tuple[float | None, tuple[float, float] | None, float | None]:
    df1 = k - 1 - 2.0 / n
    if df1 <= 0.0:
        return None, None, None
    df = (df1, (n - 1) * df1)
    if math.isclose(w, 1.0, abs_tol=1e-12):
        return None, df, 0.0  # infinite
    f = w * (n - 1) / (1.0 - w)
    return f, df, float(stats.f.sf(f, *df))


def exact_p(ranks: Floats, resampling: Resampling, label: str) -> tuple[float, str]:
    """Return how probable so unequal rank sums are when all orders are, and how found.

    Args:
        ranks: (n, k), mid-ranks within each row.
        resampling: used where counting all would take too long.
        label: of this use.
    """
    n, k = ranks.shape
    doubled = np.rint(2.0 * (ranks - 1.0)).astype(np.int64)
    cells = (2 * n * (k - 1) + 1) ** (k - 1)
    if cells * math.factorial(k) * n <= _MOST_STEPS:
        return _counted_p(doubled), "exact"
    return _drawn_p(doubled, resampling, label), f"permutation, {resampling.count}"


def _counted_p(doubled: NDArray[np.int64]) -> float:
    """Add the rows one by one to the distribution of the first k-1 rank sums."""
    n, k = doubled.shape
    size = 2 * n * (k - 1) + 1
    share = np.zeros((size,) * (k - 1))
    share[(0,) * (k - 1)] = 1.0
    for row in doubled:
        orders = list(itertools.permutations(row.tolist()))
        added = np.zeros_like(share)
        for order in orders:
            into = tuple(slice(step, None) for step in order[:-1])
            from_ = tuple(slice(0, size - step) for step in order[:-1])
            added[into] += share[from_]
        share = added / len(orders)
    sums = np.indices(share.shape)
    rest = int(doubled.sum()) - sums.sum(axis=0)
    squares = (sums**2).sum(axis=0) + rest**2
    observed = (doubled.sum(axis=0) ** 2).sum()
    return min(1.0, float(share[squares >= observed].sum()))


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
