"""The analysis of ratings: statistics, warnings, and the numbers as JSON."""

import dataclasses
import importlib.metadata
import importlib.util
import platform
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from hapticplayer import __version__
from hapticplayer.errors import Message, Progress, counted
from hapticplayer.study.analysis.aligned_ranks import ALIGNED_RANKS
from hapticplayer.study.analysis.describing import Resampling, Summary, summarize
from hapticplayer.study.analysis.first_order import first_order_models
from hapticplayer.study.analysis.friedman import CONOVER, FRIEDMAN, NEMENYI
from hapticplayer.study.analysis.ordinal_mixed import ORDINAL_LOGIT, ORDINAL_PROBIT
from hapticplayer.study.analysis.question_report import question_summary
from hapticplayer.study.analysis.rank_sum import MANN_WHITNEY
from hapticplayer.study.analysis.rank_tests import SHAPIRO, WILCOXON
from hapticplayer.study.analysis.scale_report import scale_summary
from hapticplayer.study.analysis.scores import (
    MissingPolicy,
    Sample,
    Scores,
    sample_of,
    scores_of,
)
from hapticplayer.study.analysis.sequence_factor_tests import (
    FACTOR_LOGIT,
    FACTOR_PAIRS,
    FACTOR_RANKS,
)
from hapticplayer.study.analysis.statistic import Statistic, listed, plain
from hapticplayer.study.analysis.trial_force_report import trial_force_summary
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import QOE

STATISTICS: dict[str, Statistic] = {
    one.name: one
    for one in (
        FRIEDMAN,
        SHAPIRO,
        WILCOXON,
        NEMENYI,
        CONOVER,
        MANN_WHITNEY,
        ALIGNED_RANKS,
        ORDINAL_LOGIT,
        ORDINAL_PROBIT,
        FACTOR_RANKS,
        FACTOR_PAIRS,
        FACTOR_LOGIT,
    )
}
"""To add a statistic, define a `Statistic` beside its function and list it here."""


def statistics_of(*, has_factors: bool) -> dict[str, Statistic]:
    """The statistics of a study, whose sequences may differ in factors."""
    return {
        name: one
        for name, one in STATISTICS.items()
        if has_factors or not one.of_factors
    }


FEW = 6
"""Fewest participants with which a pair can reach 0.05 in the signed-rank test."""
_LIBRARIES = ("numpy", "scipy", "matplotlib")


@dataclass(frozen=True, slots=True)
class AnalysisOptions:
    """Options of an analysis.

    Attributes:
        missing: treatment of missing answers.
        include_invalid: include trials whose playback was not valid.
        resampling: of intervals and drawn p values.
    """

    missing: MissingPolicy = MissingPolicy.PAIRED
    include_invalid: bool = False
    resampling: Resampling = field(default_factory=Resampling)

    def provenance(self) -> dict[str, Any]:
        """Return versions and options, which reproduce the numbers."""
        versions = {
            name: importlib.metadata.version(name)
            for name in _LIBRARIES
            if importlib.util.find_spec(name)
        }
        return {
            "program": f"hapticplayer {__version__}",
            "versions": {"python": platform.python_version(), **versions},
            "seed": self.resampling.seed,
            "resamples": self.resampling.count,
            "missing_answers": self.missing.value,
            "include_invalid": self.include_invalid,
        }


@dataclass(frozen=True, slots=True)
class MeasureAnalysis:
    """One measure, "qoe" or a factor.

    Attributes:
        sample: means over the sequences, used by the tests.
        feedbacks: summary of `sample` by feedback.
        conditions: summary of all answers by sequence and feedback.
        levels: summary by level of the sequences' factors and feedback.
    """

    sample: Sample
    feedbacks: dict[str, Summary]
    conditions: dict[str, dict[str, Summary]]
    levels: dict[str, dict[str, Summary]]


@dataclass(frozen=True, slots=True)
class Analysis:
    """The analysis of ratings.

    Attributes:
        scores: of all participants.
        options: of the analysis.
        measures: "qoe" first if there is one, then the factors.
        found: results by name of the statistic and measure.
        answers: that were analysed.
        first_order: models of sliders that were moved while clips played, by key.
    """

    scores: Scores
    options: AnalysisOptions
    measures: dict[str, MeasureAnalysis]
    found: dict[str, dict[str, Any]]
    answers: Answers
    first_order: dict[str, dict[str, Any]]

    @property
    def statistics(self) -> dict[str, Statistic]:
        """What was computed, by name."""
        return statistics_of(has_factors=bool(self.scores.sequence_factors))


def analyse(
    answers: Answers,
    options: AnalysisOptions | None = None,
    progress: Progress = lambda _fraction, _step: None,
) -> Analysis:
    """Analyse the ratings of a study.

    Args:
        answers: of its participants.
        options: default ones if None.
        progress: called with the fraction done and the step; raises to cancel.
    """
    options = options or AnalysisOptions()
    scores = scores_of(answers, include_invalid=options.include_invalid)
    measures: dict[str, MeasureAnalysis] = {}
    statistics = statistics_of(has_factors=bool(scores.sequence_factors))
    found: dict[str, dict[str, Any]] = {name: {} for name in statistics}
    for number, measure in enumerate(scores.measures):
        step = Message("analysing {measure}", measure=measure)
        progress(number / len(scores.measures), step)
        measures[measure] = described = _described(scores, measure, options)
        for place, (name, statistic) in enumerate(statistics.items()):
            done = number + (1 + place) / (1 + len(statistics))
            progress(done / len(scores.measures), step)
            one = statistic.compute(described.sample, options.resampling)
            found[name][measure] = plain(one)
    for name, statistic in statistics.items():
        statistic.correct(found[name])
    models = first_order_models(answers.courses, options.resampling)
    return Analysis(scores, options, measures, found, answers, models)


def _described(
    scores: Scores, measure: str, options: AnalysisOptions
) -> MeasureAnalysis:
    sample = sample_of(scores, measure, options.missing)

    def summary(values: Any, label: str) -> Summary:
        return summarize(values, options.resampling, f"{measure}/{label}")

    feedbacks = {
        name: summary(column, name)
        for name, column in zip(sample.feedbacks, sample.values.T, strict=True)
    }
    conditions = {
        sequence: {
            name: summary(sample.by_condition[:, i, j], f"{sequence}/{name}")
            for j, name in enumerate(sample.feedbacks)
        }
        for i, sequence in enumerate(scores.sequences)
    }
    levels = {
        level: {
            name: summary(values[:, j], f"{level}/{name}")
            for j, name in enumerate(sample.feedbacks)
        }
        for factor in scores.sequence_factors
        for level, values in sample.by_level(factor).items()
    }
    return MeasureAnalysis(sample, feedbacks, conditions, levels)


def summary(analysis: Analysis) -> dict[str, Any]:
    """Return the analysis as JSON, in the stable layout for other programs.

    `qoe` and `felt` have the feedbacks, `factors` the same for each factor, `questions` the
    answers to other questions; each statistic and
    `conditions` have the measures ("qoe" and the factors) first, and so have `levels` where
    sequences differ in factors. A pair is called "first-second". What is not defined is None.
    """
    measures, factors = analysis.measures, analysis.scores.sequence_factors
    described = {
        name: {key: dataclasses.asdict(one) for key, one in measure.feedbacks.items()}
        for name, measure in measures.items()
    }
    conditions = {name: _plain(one.conditions) for name, one in measures.items()}
    levels = {name: _plain(one.levels) for name, one in measures.items()}
    return {
        "qoe": described.pop(QOE, {}),
        "factors": described,
        **{
            statistic.key or name: analysis.found[name]
            for name, statistic in analysis.statistics.items()
        },
        "conditions": conditions,
        **({"levels": levels} if factors else {}),
        "missing": missing(analysis),
        "scales": scale_summary(analysis.answers),
        "questions": question_summary(analysis.answers),
        "felt": trial_force_summary(analysis.answers),
        "warnings": warnings_of(analysis),
        "provenance": analysis.options.provenance(),
    }


def _plain(groups: dict[str, dict[str, Summary]]) -> dict[str, Any]:
    return {
        group: {key: dataclasses.asdict(one) for key, one in part.items()}
        for group, part in groups.items()
    }


def missing(analysis: Analysis) -> dict[str, Any]:
    """Return the number of missing answers, and who is excluded from which tests."""
    scores = analysis.scores
    return {
        "participants": len(scores.participants),
        "answers_planned": int(scores.ratings.size),
        "answers_missing": scores.missing,
        "of_these_invalid": scores.invalid,
        "replaced_by_repetition": scores.repeated,
        "used_before_unknown": [
            code for code in scores.participants if code not in scores.used_before
        ],
        "measures": {
            name: {
                "used": len(one.sample.participants),
                "dropped": list(one.sample.dropped),
                "reduced": {k: list(v) for k, v in one.sample.reduced.items()},
            }
            for name, one in analysis.measures.items()
        },
    }


def nothing_valid(found: Mapping[str, Any]) -> str:
    """What is said first where no answer can be used, from the counts of `missing`."""
    return (
        f"No valid answer yet: {found['answers_missing']} of {found['answers_planned']} "
        f"answers are missing, {found['of_these_invalid']} of them because the playback "
        "was not valid. There is nothing to analyse."
    )


def warnings_of(analysis: Analysis) -> list[str]:
    """Return warnings about missing data and violated assumptions."""
    if analysis.scores.is_empty:
        return [*analysis.answers.notices, nothing_valid(missing(analysis))]
    return [
        *analysis.answers.notices,
        *_missing_warnings(analysis),
        *_participant_warnings(analysis),
        *(
            text
            for name, statistic in analysis.statistics.items()
            for text in statistic.warn(analysis.found[name])
        ),
    ]


def _missing_warnings(analysis: Analysis) -> Iterator[str]:
    scores, policy = analysis.scores, analysis.options.missing
    if not scores.missing:
        return
    yield (
        f"{scores.missing} of {scores.ratings.size} answers are missing, "
        f"{scores.invalid} of them because the playback was not valid."
    )
    why = (
        "some answers are missing"
        if policy is MissingPolicy.COMPLETE
        else "no sequence was answered for all feedbacks"
    )
    for name, one in analysis.measures.items():
        if dropped := one.sample.dropped:
            yield (
                f"{name}: {listed(dropped)} {'is' if len(dropped) == 1 else 'are'} "
                f"excluded from the tests ({why})."
            )
        if one.sample.reduced:
            yield (
                f"{name}: for {listed(one.sample.reduced)} only sequences that were answered "
                "for all feedbacks are used. This does not help if answers are missing "
                "because of the feedback."
            )


def _participant_warnings(analysis: Analysis) -> Iterator[str]:
    counts = [len(one.sample.participants) for one in analysis.measures.values()]
    if not counts:
        yield "No question after a clip is answered by a number: there is nothing to test."
    elif (n := min(counts)) < FEW:
        yield (
            f"With {counted(n, 'participant')} no pair of feedbacks can differ significantly in "
            f"the signed-rank test; at least {FEW} are needed."
        )
    unknown = len(analysis.scores.participants) - len(analysis.scores.used_before)
    if unknown and counts:
        yield (
            f"{counted(unknown, 'participant')} did not say whether they had used the "
            "device before, and cannot be part of the Mann-Whitney tests."
        )
