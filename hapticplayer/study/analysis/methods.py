"""The methods of an analysis as a paper can quote them, and the works they are from."""

from collections.abc import Iterable, Iterator

from hapticplayer.study.analysis.analysis import Analysis, AnalysisOptions
from hapticplayer.study.analysis.blocks import Heading, Paragraph, ReportBlock
from hapticplayer.study.analysis.references import (
    EFRON_1993,
    HOLM_1979,
    WILSON_1927,
)
from hapticplayer.study.analysis.scores import MissingPolicy, Scores
from hapticplayer.study.analysis.statistic import listed

_MISSING = {
    MissingPolicy.PAIRED: "Where an answer was missing, its sequence was left out for all "
    "feedbacks of this participant.",
    MissingPolicy.COMPLETE: "Participants with a missing answer were left out of the "
    "tests over sequences.",
}


def methods(analysis: Analysis) -> Iterator[ReportBlock]:
    """Yield the methods of an analysis of ratings."""
    yield Heading("Methods")
    scores, options = analysis.scores, analysis.options
    yield Paragraph(
        f"Each of {len(scores.sequences)} sequences was rated with each of "
        f"{len(scores.feedbacks)} feedbacks ({listed(scores.feedbacks)}) for "
        f"{_scales(scores)}.{_sum(scores)}{_factors(scores)} Unless stated otherwise, tests are of the means over the sequences for "
        f"each participant and feedback. {_MISSING[options.missing]} {invalid_text(options)}"
    )
    for name, statistic in analysis.statistics.items():
        found = analysis.found[name]
        parts = [
            part for one in found.values() for part in statistic.rows(one).values()
        ]
        is_computed = any(part.get("p") is not None for part in parts)
        if is_computed and (text := statistic.methods(found)):
            family = statistic.holm_family(found)
            after = (
                f" p was corrected by Holm's method over {family}." if family else ""
            )
            yield Paragraph(f"{text}{after}")
    yield Paragraph(
        "Intervals of means (95 %) are percentile bootstrap intervals (Efron and "
        f"Tibshirani, 1993) of {options.resampling.count} resamples of the participants "
        "(none where all values are equal). Corrections for the number of tests follow "
        f"Holm (1979). {computed_with(options)}"
    )


def _scales(scores: Scores) -> str:
    """The factors with their ranges."""
    return "; ".join(
        f"{listed(factors)}, from {limits[0]:g} to {limits[1]:g}"
        for limits, factors in scores.by_range().items()
    )


def _sum(scores: Scores) -> str:
    if not scores.qoe:
        return ""
    parts = "its factors" if scores.qoe == scores.factors else listed(scores.qoe)
    return f" QoE of a condition is the sum of {parts}."


def _factors(scores: Scores) -> str:
    """The sequences of each level of their factors."""
    return "".join(
        f" The sequences differ in {factor}: {sequences_of_levels(scores, factor)}."
        for factor in scores.sequence_factors
    )


def sequences_of_levels(scores: Scores, factor: str) -> str:
    """The levels of a factor with their sequences, in words."""
    given = scores.sequence_factors[factor]
    of = {
        level: [
            s for s, one in zip(scores.sequences, given, strict=True) if one == level
        ]
        for level in dict.fromkeys(given)
    }
    return "; ".join(f"{level} in {listed(names)}" for level, names in of.items())


def invalid_text(options: AnalysisOptions) -> str:
    kept = "were kept" if options.include_invalid else "count as missing"
    return f"Answers to trials whose playback was not valid {kept}."


def computed_with(options: AnalysisOptions) -> str:
    """Return the sentence about versions and seed."""
    made = options.provenance()
    versions = ", ".join(f"{k} {v}" for k, v in made["versions"].items())
    return (
        f"All was computed with {made['program']} ({versions}); random numbers are from "
        f"the seed {made['seed']}."
    )


def references(
    works: Iterable[str], blocks: Iterable[ReportBlock]
) -> Iterator[ReportBlock]:
    """Yield the works that the parts cite by their first author, alphabetically."""
    text = " ".join(one.text for one in blocks if isinstance(one, Paragraph))
    yield Heading("References")
    for work in sorted(set(works)):
        if work.split()[0] in text:
            yield Paragraph(work)


def works(analysis: Analysis) -> Iterator[str]:
    """Yield the works that methods of analyses of ratings are from."""
    yield from (EFRON_1993, HOLM_1979, WILSON_1927)
    for statistic in analysis.statistics.values():
        yield from statistic.references
