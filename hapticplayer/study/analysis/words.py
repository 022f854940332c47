"""What the tests assume, and where that does not hold, in words."""

from collections.abc import Iterator

from hapticplayer.study.analysis.analysis import Analysis, MeasureAnalysis
from hapticplayer.study.analysis.scores import MissingPolicy

ALPHA = 0.05
FEW = 6
"""Below so many participants no pair can reach 0.05 in the signed-rank test."""
_SMALL_GROUP = 5

ASSUMPTIONS = (
    (
        "Mean and standard deviation",
        (
            "describe ratings as if the steps of the scale were equally wide. Medians and "
            "quartiles do without this. Intervals of means are percentile bootstrap "
            "intervals, which are somewhat too narrow for fewer than about 20 participants."
        ),
    ),
    (
        "Shapiro-Wilk",
        (
            "asks whether values may come from a normal distribution. With few "
            "participants it seldom sees a deviation: a large p is no proof. The other "
            "tests here do not need normal values."
        ),
    ),
    (
        "Friedman",
        (
            "assumes that participants are independent of each other and that the values "
            "of one participant can be ranked; the null hypothesis is that every order is "
            "equally probable. Chi-square (corrected for ties) is an approximation for "
            "many participants; the exact p beside it counts all orders given the ties, "
            "and is the one that is corrected over the measures (Holm). Kendall's W "
            "tells how much the participants agree, from 0 to 1."
        ),
    ),
    (
        "Wilcoxon signed rank",
        (
            "assumes paired values whose differences are symmetric about their median "
            "and can be ranked by size. Pairs without a difference are left out; p counts "
            "all signs of the tied ranks. The matched rank-biserial correlation goes from "
            "-1 to 1; the shift is the Hodges-Lehmann estimate, whose interval is exact "
            "without ties and careful with them."
        ),
    ),
    (
        "Nemenyi and Conover",
        (
            "compare pairs by the ranks among all feedbacks, and are meant to follow a "
            "significant Friedman test. Nemenyi corrects for all pairs and is "
            "conservative; Conover is more sensitive, and trusts that the omnibus test was "
            "significant."
        ),
    ),
    (
        "Mann-Whitney",
        (
            "assumes two independent groups and values that can be ranked. It speaks of "
            "medians only if both distributions have one shape. Few participants see only "
            "large effects: no significance is not the same as no effect."
        ),
    ),
    (
        "Analysis of variance of aligned ranks",
        (
            "looks at sequences and feedbacks together, for participants who answered "
            "everything. It assumes equally unequal differences (sphericity), for which "
            "the corrected p makes up. An interaction means that the feedbacks differ "
            "more for some sequences than for others."
        ),
    ),
)


def warnings_of(analysis: Analysis) -> list[str]:
    """Return where something does not hold, is missing or cannot be told."""
    return [
        *analysis.remarks,
        *_missing(analysis),
        *_participants(analysis),
        *(
            text
            for name, one in analysis.measures.items()
            for text in _measure(name, one)
        ),
    ]


def _missing(analysis: Analysis) -> Iterator[str]:
    scores, policy = analysis.scores, analysis.choices.missing
    if not scores.missing:
        return
    yield (
        f"{scores.missing} of {scores.ratings.size} answers are missing, "
        f"{scores.unsound} of them because the playback was not sound."
    )
    for name, one in analysis.measures.items():
        if one.scores.dropped:
            yield (
                f"{name}: {_listed(one.scores.dropped)} "
                f"{_is(one.scores.dropped)} left out of the tests ("
                + (
                    "some answers are missing)."
                    if policy is MissingPolicy.COMPLETE
                    else "no sequence was answered with every feedback)."
                )
            )
        if one.scores.reduced:
            yield (
                f"{name}: of {_listed(tuple(one.scores.reduced))} only the sequences "
                "count that were answered with every feedback. If answers are missing "
                "because of how something felt, this does not make up for it."
            )


def _participants(analysis: Analysis) -> Iterator[str]:
    n = min(len(one.scores.participants) for one in analysis.measures.values())
    if n < FEW:
        yield (
            f"With {n} participants no pair of feedbacks can differ significantly in "
            f"the signed-rank test; {FEW} are the least."
        )
    unknown = len(analysis.scores.participants) - len(analysis.scores.used_before)
    if unknown:
        yield (
            f"{unknown} participants did not say whether they had used the device "
            "before; the Mann-Whitney tests are without them."
        )
    groups = next(iter(next(iter(analysis.measures.values())).mann_whitney.values()))
    smaller = min(groups.n_before, groups.n_new)
    if smaller < _SMALL_GROUP:
        yield (
            f"One of the groups of the Mann-Whitney tests has {smaller} participants: "
            "only very large effects of experience could be seen."
        )


def _measure(name: str, one: MeasureAnalysis) -> Iterator[str]:
    found = one.friedman
    if found.chi2 is None:
        yield f"{name}: the feedbacks cannot be compared; everybody's ratings are tied."
        return
    assert found.p is not None
    assert found.p_exact is not None
    if (found.p < ALPHA) != (found.p_exact < ALPHA):
        yield (
            f"{name}: Friedman's chi-square says p = {found.p:.3f}, the exact "
            f"distribution p = {found.p_exact:.3f}; the exact one is right."
        )
    skewed = [k for k, s in one.shapiro.items() if s.p is not None and s.p < ALPHA]
    if skewed:
        yield (
            f"{name}: {_listed(tuple(skewed))} {_is(tuple(skewed))} not normally "
            "distributed (Shapiro-Wilk): rather read medians and ranks than means."
        )
    constant = [k for k, s in one.shapiro.items() if s.w is None]
    if constant:
        yield (
            f"{name}: {_listed(tuple(constant))} cannot be tested for normality "
            "(fewer than three values, or all alike)."
        )
    yield from _structure(name, one)


def _structure(name: str, one: MeasureAnalysis) -> Iterator[str]:
    if one.structure is None:
        yield (
            f"{name}: sequence and feedback cannot be analysed together (fewer than "
            "two of something, or no spread to compare with)."
        )
        return
    if one.structure.dropped:
        yield (
            f"{name}: the analysis of aligned ranks is without "
            f"{_listed(one.structure.dropped)} (answers are missing)."
        )
    uneven = [
        effect
        for effect, found in one.structure.effects.items()
        if (found.p < ALPHA) != (found.p_corrected < ALPHA)
    ]
    if uneven:
        yield (
            f"{name}: the differences are unequally spread (no sphericity), and this "
            f"decides about {_listed(tuple(uneven))}: read the corrected p of the "
            "aligned ranks."
        )


def _listed(names: tuple[str, ...]) -> str:
    if len(names) == 1:
        return names[0]
    return f"{', '.join(names[:-1])} and {names[-1]}"


def _is(names: tuple[str, ...]) -> str:
    return "is" if len(names) == 1 else "are"
