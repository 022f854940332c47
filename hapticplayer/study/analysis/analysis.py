"""The whole analysis of a study, from answers to numbers, and where care is needed."""

import dataclasses
import importlib.metadata
import platform
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from hapticplayer import __version__
from hapticplayer.study.analysis.aligned_ranks import ALIGNED_RANKS
from hapticplayer.study.analysis.describing import Resampling, Summary, summarize
from hapticplayer.study.analysis.friedman import CONOVER, FRIEDMAN, NEMENYI
from hapticplayer.study.analysis.rank_tests import MANN_WHITNEY, SHAPIRO, WILCOXON
from hapticplayer.study.analysis.scores import (
    QOE,
    MissingPolicy,
    Sample,
    Scores,
    sample_of,
    scores_of,
)
from hapticplayer.study.analysis.statistic import Statistic, listed, plain
from hapticplayer.study.answers import Answers

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
    )
}
"""A new statistic is a `Statistic` beside its function, and a line here."""

FEW = 6
"""Below so many participants no pair can reach 0.05 in the signed-rank test."""
_LIBRARIES = ("numpy", "scipy", "statsmodels", "matplotlib")

Progress = Callable[[float, str], None]


@dataclass(frozen=True, slots=True)
class AnalysisOptions:
    """What a person decides before the numbers are seen.

    Attributes:
        missing: what becomes of holes.
        with_unsound: whether trials count whose playback was not sound.
        resampling: of intervals and drawn p values.
    """

    missing: MissingPolicy = MissingPolicy.PAIRED
    with_unsound: bool = False
    resampling: Resampling = field(default_factory=Resampling)

    def provenance(self) -> dict[str, Any]:
        """Return what the numbers are made with; the same again gives the same."""
        versions = {name: importlib.metadata.version(name) for name in _LIBRARIES}
        return {
            "program": f"hapticplayer {__version__}",
            "versions": {"python": platform.python_version(), **versions},
            "seed": self.resampling.seed,
            "resamples": self.resampling.count,
            "missing_answers": self.missing.value,
            "with_unsound_trials": self.with_unsound,
        }


@dataclass(frozen=True, slots=True)
class MeasureAnalysis:
    """One measure, "qoe" or a factor.

    Attributes:
        sample: means over the sequences, on which the tests are done.
        feedbacks: by feedback, of `sample`.
        conditions: by sequence and feedback, of all answers there are.
    """

    sample: Sample
    feedbacks: dict[str, Summary]
    conditions: dict[str, dict[str, Summary]]


@dataclass(frozen=True, slots=True)
class Analysis:
    """A study in numbers.

    Attributes:
        scores: of all participants.
        choices: that were made.
        measures: "qoe" first, then the factors.
        found: by name of the statistic and measure.
        remarks: of the store, about what could not be read.
    """

    scores: Scores
    choices: AnalysisOptions
    measures: dict[str, MeasureAnalysis]
    found: dict[str, dict[str, Any]]
    remarks: tuple[str, ...]


def analyse(
    answers: Answers,
    choices: AnalysisOptions | None = None,
    progress: Progress = lambda _fraction, _step: None,
) -> Analysis:
    """Return everything that is reported of a study.

    Args:
        answers: of its participants.
        choices: the usual ones if None.
        progress: told the done fraction and the step; raises to stop.

    Raises:
        InputError: when the answers do not fit their own design.
    """
    choices = choices or AnalysisOptions()
    scores = scores_of(answers, with_unsound=choices.with_unsound)
    measures: dict[str, MeasureAnalysis] = {}
    found: dict[str, dict[str, Any]] = {name: {} for name in STATISTICS}
    for number, measure in enumerate(scores.measures):
        progress(number / len(scores.measures), f"analysing {measure}")
        measures[measure] = described = _described(scores, measure, choices)
        for name, statistic in STATISTICS.items():
            one = statistic.compute(described.sample, choices.resampling)
            found[name][measure] = plain(one)
    for name, statistic in STATISTICS.items():
        statistic.correct(found[name])
    return Analysis(scores, choices, measures, found, answers.remarks)


def _described(
    scores: Scores, measure: str, choices: AnalysisOptions
) -> MeasureAnalysis:
    sample = sample_of(scores, measure, choices.missing)

    def summary(values: Any, label: str) -> Summary:
        return summarize(values, choices.resampling, f"{measure}/{label}")

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
    return MeasureAnalysis(sample, feedbacks, conditions)


def summary(analysis: Analysis) -> dict[str, Any]:
    """Return everything as one JSON object, in the shape that other programs rely on.

    `qoe` has the feedbacks, `factors` the same for each factor; each statistic and
    `conditions` have the measures ("qoe" and the factors) first. A pair is called
    "first-second". What is not defined is None.
    """
    measures = analysis.measures
    described = {
        name: {key: dataclasses.asdict(one) for key, one in measure.feedbacks.items()}
        for name, measure in measures.items()
    }
    conditions = {
        name: {
            sequence: {key: dataclasses.asdict(one) for key, one in part.items()}
            for sequence, part in measure.conditions.items()
        }
        for name, measure in measures.items()
    }
    return {
        "qoe": described.pop(QOE),
        "factors": described,
        **{
            statistic.key or name: analysis.found[name]
            for name, statistic in STATISTICS.items()
        },
        "conditions": conditions,
        "missing": missing(analysis),
        "warnings": warnings_of(analysis),
        "provenance": analysis.choices.provenance(),
    }


def missing(analysis: Analysis) -> dict[str, Any]:
    """Return how many answers there are not, and who is left out of what."""
    scores = analysis.scores
    return {
        "participants": len(scores.participants),
        "answers_planned": int(scores.ratings.size),
        "answers_missing": scores.missing,
        "of_these_not_sound": scores.unsound,
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


def warnings_of(analysis: Analysis) -> list[str]:
    """Return where something does not hold, is missing or cannot be told."""
    return [
        *analysis.remarks,
        *_missing_warnings(analysis),
        *_participant_warnings(analysis),
        *(
            text
            for name, statistic in STATISTICS.items()
            for text in statistic.warn(analysis.found[name])
        ),
    ]


def _missing_warnings(analysis: Analysis) -> Iterator[str]:
    scores, policy = analysis.scores, analysis.choices.missing
    if not scores.missing:
        return
    yield (
        f"{scores.missing} of {scores.ratings.size} answers are missing, "
        f"{scores.unsound} of them because the playback was not sound."
    )
    why = (
        "some answers are missing"
        if policy is MissingPolicy.COMPLETE
        else "no sequence was answered with every feedback"
    )
    for name, one in analysis.measures.items():
        if dropped := one.sample.dropped:
            yield (
                f"{name}: {listed(dropped)} {'is' if len(dropped) == 1 else 'are'} left "
                f"out of the tests ({why})."
            )
        if one.sample.reduced:
            yield (
                f"{name}: of {listed(one.sample.reduced)} only the sequences count that "
                "were answered with every feedback. If answers are missing because of "
                "how something felt, this does not make up for it."
            )


def _participant_warnings(analysis: Analysis) -> Iterator[str]:
    n = min(len(one.sample.participants) for one in analysis.measures.values())
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
