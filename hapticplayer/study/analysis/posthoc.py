"""Pairs of feedbacks after Friedman's test, by the ranks of all feedbacks.

Nemenyi: q = |mean rank difference| / sqrt(k(k+1)/(6n)), referred to the studentised
range with infinite degrees of freedom (q sqrt 2), which corrects for all pairs.
Conover: t = |R_i - R_j| / sqrt(2 (n A - sum R^2) / ((n-1)(k-1))) with (n-1)(k-1)
degrees of freedom (Conover 1999, 5.8); not corrected, so Holm is beside it.
"""

import math
from dataclasses import dataclass

from scipy import stats

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.corrections import holm


@dataclass(frozen=True, slots=True)
class Nemenyi:
    """One pair; p is corrected for all pairs."""

    q: float
    p: float


@dataclass(frozen=True, slots=True)
class Conover:
    """One pair; None where all participants agree and t has no bound."""

    t: float | None
    p: float | None
    p_holm: float | None = None


def nemenyi(values: Floats, pairs: list[tuple[int, int]]) -> list[Nemenyi]:
    """Compare pairs of columns of `values` (n, k)."""
    n, k = values.shape
    means = stats.rankdata(values, axis=1).mean(axis=0)
    error = math.sqrt(k * (k + 1) / (6.0 * n))
    found = []
    for i, j in pairs:
        q = float(abs(means[i] - means[j]) / error)
        p = float(stats.studentized_range.sf(q * math.sqrt(2.0), k, math.inf))
        found.append(Nemenyi(q, min(1.0, p)))
    return found


def conover(values: Floats, pairs: list[tuple[int, int]]) -> list[Conover]:
    """Compare pairs of columns of `values` (n, k), n > 1."""
    n, k = values.shape
    ranks = stats.rankdata(values, axis=1)
    sums = ranks.sum(axis=0)
    left = n * float((ranks**2).sum()) - float((sums**2).sum())
    df = (n - 1) * (k - 1)
    if left <= 0.0:  # every participant ranks alike: exact in halves
        certain = [1.0 if sums[i] == sums[j] else 0.0 for i, j in pairs]
        return [Conover(None, p, p) for p in certain]
    error = math.sqrt(2.0 * left / df)
    t = [float(abs(sums[i] - sums[j]) / error) for i, j in pairs]
    p = [float(2.0 * stats.t.sf(value, df)) for value in t]
    return [Conover(*row) for row in zip(t, p, holm(p), strict=True)]
