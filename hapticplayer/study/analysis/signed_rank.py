"""Wilcoxon's signed-rank test with its exact distribution, also where ranks are tied.

Differences of zero are left out (Wilcoxon's own rule); p counts all 2^n signs of the
remaining mid-ranks, two-sided as twice the smaller tail.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy import stats

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.resampling import CONFIDENCE, Resampling

MOST_COUNTED = 200
"""Beyond so many differences the normal distribution is as good (p within 1e-4)."""
_DECIMALS = 9  # means of integers that are equal but for their rounding are ties


@dataclass(frozen=True, slots=True)
class SignedRank:
    """Outcome for paired samples; positive means that the second is larger.

    Attributes:
        n: pairs.
        zeros: pairs without a difference, left out of the test.
        w_plus: sum of the ranks of positive differences.
        w_minus: of the negative ones; the smaller of both is often printed as W.
        p: two-sided, None where nothing differs.
        p_method: "exact" or "normal".
        p_normal: of the normal distribution, corrected for ties, not for continuity.
        rank_biserial: (w_plus - w_minus) / their sum, -1 to 1.
        rank_biserial_interval: 95 %, bootstrap.
        shift: Hodges-Lehmann estimate (median of the Walsh averages).
        shift_interval: at least 95 %, from the exact distribution without ties; None
            for fewer than six pairs, for which there is none.
        p_holm: corrected for the number of pairs.
    """

    n: int
    zeros: int
    w_plus: float
    w_minus: float
    p: float | None
    p_method: str
    p_normal: float | None
    rank_biserial: float | None
    rank_biserial_interval: tuple[float, float] | None
    shift: float
    shift_interval: tuple[float, float] | None
    p_holm: float | None = None


def signed_rank(
    first: Floats, second: Floats, resampling: Resampling, label: str
) -> SignedRank:
    """Compare paired samples (n,), n > 0."""
    differences = np.round(second - first, _DECIMALS)
    apart = differences[differences != 0.0]
    ranks = stats.rankdata(np.abs(apart))
    w_plus, w_minus = float(ranks[apart > 0].sum()), float(ranks[apart < 0].sum())
    p_normal = _normal_p(ranks, w_plus)
    is_counted = len(apart) <= MOST_COUNTED
    interval = None
    if len(apart):
        interval = resampling.interval(differences, rank_biserial, f"signed/{label}")
    shift, shift_interval = hodges_lehmann(differences)
    return SignedRank(
        len(differences),
        len(differences) - len(apart),
        w_plus,
        w_minus,
        _counted_p(ranks, w_plus) if is_counted else p_normal,
        "exact" if is_counted else "normal",
        p_normal,
        float(rank_biserial(differences)) if len(apart) else None,
        interval,
        shift,
        shift_interval,
    )


def rank_biserial(differences: Floats) -> Floats:
    """Return the matched rank-biserial correlation over the last axis; 0 if all are 0."""
    ranks = stats.rankdata(np.abs(differences), axis=-1)
    ranks -= (differences == 0.0).sum(axis=-1, keepdims=True)  # zeros rank lowest
    signed = (np.sign(differences) * ranks).sum(axis=-1)
    total = np.where(differences == 0.0, 0.0, ranks).sum(axis=-1)
    return np.asarray(signed / np.maximum(total, 1.0), np.float64)


def hodges_lehmann(
    differences: Floats,
) -> tuple[float, tuple[float, float] | None]:
    """Return the median of the Walsh averages and its interval (Hollander & Wolfe 3.3)."""
    n = len(differences)
    upper = np.triu_indices(n)
    averages = np.sort((differences[upper[0]] + differences[upper[1]]) / 2.0)
    place = _interval_place(n)
    if place == 0:
        return float(np.median(averages)), None
    low, high = averages[place - 1], averages[len(averages) - place]
    return float(np.median(averages)), (float(low), float(high))


def _interval_place(n: int) -> int:
    """Return the largest c with P(W+ < c) within the tail; 0 where there is none."""
    tail = (1.0 - CONFIDENCE) / 2.0
    if n > MOST_COUNTED:
        mean, variance = n * (n + 1) / 4.0, n * (n + 1) * (2 * n + 1) / 24.0
        return math.floor(mean + float(stats.norm.ppf(tail)) * math.sqrt(variance))
    below = np.cumsum(_distribution(2.0 * np.arange(1.0, n + 1.0, dtype=np.float64)))[
        ::2
    ]
    return int(np.searchsorted(below, tail, side="right"))


def _distribution(doubled: Floats) -> Floats:
    """Return the probability of each doubled sum of positive ranks."""
    share = np.zeros(int(np.sum(doubled)) + 1)
    share[0] = 1.0
    for step in np.rint(doubled).astype(int):
        moved = np.zeros_like(share)
        moved[step:] = share[: len(share) - step]
        share = (share + moved) / 2.0
    return share


def _counted_p(ranks: Floats, w_plus: float) -> float | None:
    if not len(ranks):
        return None
    share = _distribution(2.0 * ranks)
    place = round(2.0 * w_plus)
    return min(1.0, 2.0 * float(min(share[: place + 1].sum(), share[place:].sum())))


def _normal_p(ranks: Floats, w_plus: float) -> float | None:
    if not len(ranks):
        return None
    z = (w_plus - ranks.sum() / 2.0) / math.sqrt((ranks**2).sum() / 4.0)
    return float(2.0 * stats.norm.sf(abs(z)))
