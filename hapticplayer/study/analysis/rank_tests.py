"""The signed-rank test with exact p for tied ranks, and a test of normality.

Wilcoxon's test; zero differences are dropped. The exact p of scipy is for ranks without ties, or takes too long beyond a
dozen values (all permutations); here the distribution of sums of tied mid-ranks is
convolved rank by rank. Two-sided p: twice the smaller tail.
"""

import functools
import math
from collections.abc import Iterator

import numpy as np
import scipy
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.describing import TAILS, Resampling
from hapticplayer.study.analysis.effect_sizes import (
    matched_interval,
    rank_biserial,
)
from hapticplayer.study.analysis.references import (
    HODGES_1963,
    KERBY_2014,
    LEHMANN_1975,
    SHAPIRO_1965,
    WILCOXON_1945,
)
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.statistic import (
    ALPHA,
    Found,
    Holm,
    ReportColumn,
    Statistic,
    interval,
    listed,
    number,
    p_value,
    ways,
)

MOST_PAIRS = 200
"""Above this number the normal approximation is used (p within 1e-4)."""
_DECIMALS = 9  # so that means of integers that differ by rounding are ties
_LEAST_FOR_SHAPIRO = 3


def signed_rank(first: Floats, second: Floats) -> Found:
    """Compare paired samples (n,), n > 0; positive means that the second is larger.

    `p_normal` is corrected for ties, not for continuity. `shift` is the Hodges-Lehmann
    estimate; its interval covers at least 95 %, by the exact distribution without ties,
    and is None for fewer than six pairs.
    """
    differences = np.round(second - first, _DECIMALS)
    apart = differences[differences != 0.0]
    ranks = scipy.stats.rankdata(np.abs(apart))
    w_plus = float(ranks[apart > 0].sum())
    p = p_normal = effect = effect_interval = None
    is_counted = len(apart) <= MOST_PAIRS
    if len(apart):
        p = p_normal = float(scipy.stats.wilcoxon(apart, method="asymptotic").pvalue)
        if is_counted:
            p = smaller_tail(_sums(2.0 * ranks), 2.0 * w_plus)
        effect = rank_biserial(differences)
        effect_interval = matched_interval(w_plus, len(apart))
    shift, shift_interval = hodges_lehmann(differences)
    return {
        "n": len(differences),
        "zeros": len(differences) - len(apart),
        "w_plus": w_plus,
        "w_minus": float(ranks[apart < 0].sum()),
        "p": p,
        "p_method": "exact" if is_counted else "normal",
        "p_normal": p_normal,
        "rank_biserial": effect,
        "rank_biserial_interval": effect_interval,
        "shift": shift,
        "shift_interval": shift_interval,
    }


def hodges_lehmann(differences: Floats) -> tuple[float, tuple[float, float] | None]:
    """Return the median of the Walsh averages and its interval (Hollander & Wolfe 3.3).

    Averages of distinct differences are counted, not listed: ratings have few.
    """
    n = len(differences)
    distinct, counts = np.unique(differences, return_counts=True)
    i, j = np.triu_indices(len(distinct))
    ways = np.where(i == j, counts[i] * (counts[i] + 1) // 2, counts[i] * counts[j])
    averages = (distinct[i] + distinct[j]) / 2.0
    order = np.argsort(averages)
    last = np.cumsum(ways[order])  # place of the last of each, from 1

    def at(place: int) -> float:
        return float(averages[order[np.searchsorted(last, place)]])

    total = n * (n + 1) // 2
    median = (at((total + 1) // 2) + at(total // 2 + 1)) / 2.0
    place = _interval_place(n)
    if place == 0:
        return median, None
    return median, (at(place), at(total - place + 1))


@functools.cache
def _interval_place(n: int) -> int:
    """Return the largest c with P(W+ < c) within the tail, or 0."""
    if n > MOST_PAIRS:
        mean, variance = n * (n + 1) / 4.0, n * (n + 1) * (2 * n + 1) / 24.0
        z = float(scipy.stats.norm.ppf(TAILS[0]))
        return math.floor(mean + z * math.sqrt(variance))
    below = np.cumsum(_sums(2.0 * np.arange(1.0, n + 1.0)))[::2]
    return int(np.searchsorted(below, TAILS[0], side="right"))


def _sums(doubled: NDArray[np.float64]) -> Floats:
    """Return the distribution of sums of random subsets of the (doubled) ranks."""
    share = np.zeros(int(np.sum(doubled)) + 1)
    share[0] = 1.0
    for step in np.rint(doubled).astype(int):
        moved = np.zeros_like(share)
        moved[step:] = share[: len(share) - step]
        share = (share + moved) / 2.0
    return share


def signed_rank_p(differences: Floats) -> Floats:
    """Exact p, as of `signed_rank`, of each row (D, n) of differences."""
    is_zero = differences == 0.0
    ranks = scipy.stats.rankdata(np.abs(differences), axis=1)
    ranks -= is_zero.sum(axis=1, keepdims=True)
    doubled = np.where(is_zero, 0, np.rint(2.0 * ranks)).astype(np.int64)
    smaller = np.minimum(
        (doubled * (differences > 0.0)).sum(axis=1),
        (doubled * (differences < 0.0)).sum(axis=1),
    )
    share = np.zeros((len(doubled), int(smaller.max()) + 1))
    share[:, 0] = 1.0
    for step in doubled.T:
        source = np.arange(share.shape[1]) - step[:, None]
        moved = np.take_along_axis(share, np.maximum(source, 0), axis=1)
        share = (share + moved * (source >= 0)) / 2.0
    tail = np.cumsum(share, axis=1)[np.arange(len(doubled)), smaller]
    return np.asarray(np.minimum(1.0, 2.0 * tail), np.float64)


def smaller_tail(share: Floats, at: float) -> float:
    """Return the two-sided p of a value from the distribution of all."""
    place = round(at)
    return min(1.0, 2.0 * float(min(share[: place + 1].sum(), share[place:].sum())))


def shapiro(values: Floats) -> Found:
    """Test a sample (n,) for normality; None if it is too small or constant."""
    if len(values) < _LEAST_FOR_SHAPIRO or np.ptp(values) == 0.0:
        return {"w": None, "p": None}
    found = scipy.stats.shapiro(values)
    return {"w": float(found.statistic), "p": float(found.pvalue)}


def _signed_ranks(sample: Sample, _resampling: Resampling) -> Found:
    columns = sample.values.T
    return sample.each_pair(
        lambda pairs: [signed_rank(columns[i], columns[j]) for i, j in pairs]
    )


def _normality_warnings(found: dict[str, Found]) -> Iterator[str]:
    for measure, one in found.items():
        skewed = [k for k, s in one.items() if s["p"] is not None and s["p"] < ALPHA]
        if skewed:
            yield (
                f"{measure}: {listed(skewed)} {'is' if len(skewed) == 1 else 'are'} not "
                "normally distributed (Shapiro-Wilk): prefer medians and ranks to means."
            )
        if constant := [k for k, s in one.items() if s["w"] is None]:
            yield (
                f"{measure}: {listed(constant)} cannot be tested for normality (fewer "
                "than three values, or constant)."
            )


def _signed_rank_methods(found: dict[str, Found]) -> str:
    way = ways(
        (part for one in found.values() for part in one.values()),
        "p_method",
        {
            "exact": "exact given the ties (all signs of the mid-ranks were counted; "
            "twice the smaller tail)",
            "normal": f"by the normal approximation for more than {MOST_PAIRS} pairs "
            "(corrected for ties, not for continuity)",
        },
    )
    return (
        "Pairs of feedbacks were compared by Wilcoxon's signed-rank test (Wilcoxon, "
        "1945); pairs without a difference were dropped, and equal differences share "
        f"their mean rank. Two-sided p was {way or 'not defined'}. The effect size is "
        "the matched rank-biserial correlation (Kerby, 2014); its interval inverts the "
        "test with the variance of W+ for shifted normal differences (Lehmann, 1975). "
        "The shift is the estimate of Hodges and Lehmann (1963)."
    )


SHAPIRO = Statistic(
    "shapiro",
    "Normality of the participants' means: Shapiro and Wilk's test",
    lambda sample, _: sample.each_feedback(lambda _name, column: shapiro(column)),
    of="feedback",
    columns=(
        ReportColumn("W", "w", lambda w: number(w, 3)),
        ReportColumn("p", "p", p_value),
    ),
    assumes="The test of Shapiro and Wilk asks whether values may come from a normal distribution. With few "
    "participants it rarely detects a deviation: a large p proves nothing. The other "
    "tests here do not assume normal values.",
    warn=_normality_warnings,
    methods=lambda _: "Normality was tested after Shapiro and Wilk (1965).",
    references=(SHAPIRO_1965,),
)

WILCOXON = Statistic(
    "wilcoxon",
    "Pairs of feedbacks: Wilcoxon's signed-rank test",
    _signed_ranks,
    of="pair",
    columns=(
        ReportColumn("n", "n", str),
        ReportColumn("zeros", "zeros", str),
        ReportColumn("W+", "w_plus", lambda w: number(w, 1)),
        ReportColumn("W-", "w_minus", lambda w: number(w, 1)),
        ReportColumn("p", "p", p_value),
        ReportColumn("p (Holm)", "p_holm", p_value),
        ReportColumn("r", "rank_biserial"),
        ReportColumn("95 % CI", "rank_biserial_interval", interval),
        ReportColumn("shift", "shift"),
        ReportColumn("95 % CI", "shift_interval", interval),
    ),
    note="W+ and W-: sums of the ranks of positive and negative differences. r: matched "
    "rank-biserial correlation. Shift: estimate of Hodges and Lehmann. CI: confidence "
    "interval.",
    assumes="Wilcoxon's signed-rank test assumes paired values whose differences are symmetric about their median "
    "and can be ranked by size. Pairs without a difference are dropped; p is exact "
    "for tied ranks. The matched rank-biserial correlation goes from -1 to 1; its "
    "interval has the values from which W+ differs by less than 1.96 standard errors "
    "(of normal differences), and is no point at 1, as a bootstrap is; the shift is the Hodges-Lehmann estimate, whose interval is exact without ties and "
    "conservative with ties.",
    holm=Holm("p", "each measure"),
    methods=_signed_rank_methods,
    references=(WILCOXON_1945, KERBY_2014, LEHMANN_1975, HODGES_1963),
)
