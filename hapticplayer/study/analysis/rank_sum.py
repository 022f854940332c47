"""Mann-Whitney's test of two independent samples, exact also where ranks are tied."""

import math
from dataclasses import dataclass

import numpy as np
from scipy import stats

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.resampling import CONFIDENCE, Resampling

MOST_COUNTED = 100
"""Larger samples together take the normal distribution."""


@dataclass(frozen=True, slots=True)
class RankSum:
    """Outcome for those who used the device before against those who did not.

    Attributes:
        n_before: participants who used it.
        n_new: participants who did not.
        u: pairs in which the experienced one is higher; ties count half.
        p: two-sided; None where a group is empty or nothing differs.
        p_method: "exact" or "normal".
        p_normal: corrected for ties and continuity.
        rank_biserial: 2u / (n_before n_new) - 1; positive: the experienced are higher.
        rank_biserial_interval: 95 %, bootstrap within the groups.
        p_holm: corrected for the number of these tests.
    """

    n_before: int
    n_new: int
    u: float | None = None
    p: float | None = None
    p_method: str | None = None
    p_normal: float | None = None
    rank_biserial: float | None = None
    rank_biserial_interval: tuple[float, float] | None = None
    p_holm: float | None = None


def rank_sum(
    before: Floats, new: Floats, resampling: Resampling, label: str
) -> RankSum:
    """Compare independent samples (n_before,) and (n_new,)."""
    n1, n2 = len(before), len(new)
    if not n1 or not n2:
        return RankSum(n1, n2)
    ranks = stats.rankdata(np.concatenate([before, new]))
    u = float(ranks[:n1].sum()) - n1 * (n1 + 1) / 2.0
    effect = 2.0 * u / (n1 * n2) - 1.0
    interval = _effect_interval(before, new, resampling, label)
    if np.ptp(ranks) == 0.0:
        return RankSum(n1, n2, u, None, None, None, effect, interval)
    p_normal = _normal_p(ranks, n1, u)
    is_counted = n1 + n2 <= MOST_COUNTED
    p = _counted_p(ranks, n1) if is_counted else p_normal
    method = "exact" if is_counted else "normal"
    return RankSum(n1, n2, u, p, method, p_normal, effect, interval)


def _counted_p(ranks: Floats, n1: int) -> float:
    """Count the rank sums of all choices of n1 ranks; twice the smaller tail."""
    doubled = np.rint(2.0 * ranks).astype(int)
    ways = np.zeros((n1 + 1, int(np.sort(doubled)[-n1:].sum()) + 1))
    ways[0, 0] = 1.0
    for step in doubled:
        ways[1:, step:] += ways[:-1, : ways.shape[1] - step].copy()
    share = ways[n1] / ways[n1].sum()
    place = int(doubled[:n1].sum())
    return min(1.0, 2.0 * float(min(share[: place + 1].sum(), share[place:].sum())))


def _normal_p(ranks: Floats, n1: int, u: float) -> float:
    n = len(ranks)
    n2 = n - n1
    _, ties = np.unique(ranks, return_counts=True)
    lost = (ties**3 - ties).sum() / (n * (n - 1))
    sigma = math.sqrt(n1 * n2 / 12.0 * ((n + 1) - lost))
    z = (abs(u - n1 * n2 / 2.0) - 0.5) / sigma
    return min(1.0, float(2.0 * stats.norm.sf(z)))


def _effect_interval(
    before: Floats, new: Floats, resampling: Resampling, label: str
) -> tuple[float, float]:
    rng = resampling.generator(f"rank-sum/{label}")
    wins = np.sign(before[:, None] - new[None, :])
    first = _weights(rng, len(before), resampling.count)
    second = _weights(rng, len(new), resampling.count)
    effects = ((first @ wins) * second).sum(axis=1)
    tail = (1.0 - CONFIDENCE) / 2.0
    low, high = np.quantile(effects, [tail, 1.0 - tail])
    return float(low), float(high)


def _weights(rng: np.random.Generator, n: int, count: int) -> Floats:
    """Return how often each of n is drawn with replacement, as shares (count, n)."""
    return rng.multinomial(n, np.full(n, 1.0 / n), size=count) / n
