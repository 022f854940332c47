"""The rank-sum test of two groups with exact p for tied ranks (Mann and Whitney)."""

from collections.abc import Iterator

import numpy as np
import scipy
from numpy.typing import NDArray

from hapticplayer.errors import counted
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.effect_sizes import independent_interval
from hapticplayer.study.analysis.rank_tests import smaller_tail
from hapticplayer.study.analysis.references import MANN_1947, NEWCOMBE_2006
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.statistic import (
    Found,
    Holm,
    ReportColumn,
    Statistic,
    interval,
    number,
    p_value,
    ways,
)

MOST_PEOPLE = 100
"""Above this number the normal approximation is used (p within 1e-4)."""
_SMALL_GROUP = 5


def rank_sum(before: Floats, new: Floats) -> Found:
    """Compare independent samples (n_before,) and (n_new,).

    `u` counts the pairs in which `before` is higher, ties half; `p_normal` is corrected
    for ties and continuity; `rank_biserial` is positive where `before` is higher. None
    if a group is empty or all values are equal.
    """
    found: Found = {"n_before": len(before), "n_new": len(new)}
    found |= dict.fromkeys(["u", "p", "p_method", "p_normal"])
    found |= dict.fromkeys(["rank_biserial", "rank_biserial_interval"])
    if not len(before) or not len(new):
        return found
    ranks = scipy.stats.rankdata(np.concatenate([before, new]))
    with np.errstate(invalid="ignore"):
        normal = scipy.stats.mannwhitneyu(before, new, method="asymptotic")
    found["u"] = float(normal.statistic)
    found["rank_biserial"] = 2.0 * found["u"] / (len(before) * len(new)) - 1.0
    found["rank_biserial_interval"] = independent_interval(
        found["u"], len(before), len(new)
    )
    if np.ptp(ranks) == 0.0:
        return found
    found["p"] = found["p_normal"] = float(normal.pvalue)
    is_counted = len(ranks) <= MOST_PEOPLE
    if is_counted:
        doubled = np.rint(2.0 * ranks).astype(int)
        sums = _sums_of_choices(doubled, len(before))
        found["p"] = smaller_tail(sums, float(doubled[: len(before)].sum()))
    found["p_method"] = "exact" if is_counted else "normal"
    return found


def _sums_of_choices(doubled: NDArray[np.int64], chosen: int) -> Floats:
    """Return the distribution of sums of `chosen` of the (doubled) ranks."""
    ways = np.zeros((chosen + 1, int(np.sort(doubled)[-chosen:].sum()) + 1))
    ways[0, 0] = 1.0
    for step in doubled:
        ways[1:, step:] += ways[:-1, : ways.shape[1] - step].copy()
    return np.asarray(ways[chosen] / ways[chosen].sum())


def _expertise(sample: Sample, _resampling: Resampling) -> Found:
    before, new = (
        [i for i, used in enumerate(sample.used_before) if used is wanted]
        for wanted in (True, False)
    )
    return sample.each_feedback(
        lambda _name, column: rank_sum(column[before], column[new])
    )


def _group_warnings(found: dict[str, Found]) -> Iterator[str]:
    groups = next(iter(next(iter(found.values())).values()))
    smaller = min(groups["n_before"], groups["n_new"])
    if not smaller:
        yield (
            "Participants who had used such a device before and new ones cannot be "
            "compared: there are none of one group."
        )
    elif smaller < _SMALL_GROUP:
        yield (
            "One of the groups of the Mann-Whitney tests has "
            f"{counted(smaller, 'participant')}: "
            "only very large effects of experience can be detected."
        )


def _rank_sum_methods(found: dict[str, Found]) -> str:
    way = ways(
        (part for one in found.values() for part in one.values()),
        "p_method",
        {
            "exact": "exact given the ties (all divisions of the mid-ranks were counted); "
            "it doubles the smaller tail",
            "normal": f"by the normal approximation for more than {MOST_PEOPLE} "
            "participants (corrected for ties and continuity)",
        },
    )
    return (
        "Participants who had used such a device before were compared with new ones by "
        f"the test of Mann and Whitney (1947). Two-sided p was {way or 'not defined'}. "
        "The effect size is the rank-biserial correlation with the interval of Newcombe "
        "(2006, method 5)."
    )


MANN_WHITNEY = Statistic(
    "mann_whitney",
    "Participants who had used such a device before, and new ones: Mann and Whitney's test",
    _expertise,
    of="feedback",
    columns=(
        ReportColumn("before", "n_before", str),
        ReportColumn("new", "n_new", str),
        ReportColumn("U", "u", lambda u: number(u, 1)),
        ReportColumn("p", "p", p_value),
        ReportColumn("p (Holm)", "p_holm", p_value),
        ReportColumn("r", "rank_biserial"),
        ReportColumn("95 % CI", "rank_biserial_interval", interval),
    ),
    note="U: pairs in which the participant who had used such a device is higher. r: "
    "rank-biserial correlation. CI: confidence interval.",
    assumes="The test of Mann and Whitney assumes two independent groups and values that can be ranked. It compares "
    "medians only if both distributions have the same shape. Few participants detect only "
    "large effects: no significance does not mean no effect. The interval of the "
    "rank-biserial correlation is Newcombe's fifth method, which holds at -1 and 1.",
    warn=_group_warnings,
    holm=Holm("p", "all measures"),
    methods=_rank_sum_methods,
    references=(MANN_1947, NEWCOMBE_2006),
)
