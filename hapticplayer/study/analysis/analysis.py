"""The whole analysis of a study, from answers to numbers."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from itertools import combinations

from hapticplayer.study.analysis.corrections import holm
from hapticplayer.study.analysis.describing import Shapiro, Summary, shapiro, summarize
from hapticplayer.study.analysis.friedman import Friedman, friedman
from hapticplayer.study.analysis.posthoc import Conover, Nemenyi, conover, nemenyi
from hapticplayer.study.analysis.rank_sum import RankSum, rank_sum
from hapticplayer.study.analysis.resampling import Resampling
from hapticplayer.study.analysis.scores import (
    FeedbackScores,
    MissingPolicy,
    Scores,
    by_feedback,
    scores_of,
)
from hapticplayer.study.analysis.signed_rank import SignedRank, signed_rank
from hapticplayer.study.analysis.structure import Structure, structure
from hapticplayer.study.answers import Answers

Progress = Callable[[float, str], None]


@dataclass(frozen=True, slots=True)
class Choices:
    """What a person decides before the numbers are seen.

    Attributes:
        missing: what becomes of holes.
        with_unsound: whether trials count whose playback was not sound.
        resampling: of intervals and drawn p values.
    """

    missing: MissingPolicy = MissingPolicy.PAIRED
    with_unsound: bool = False
    resampling: Resampling = field(default_factory=Resampling)


@dataclass(frozen=True, slots=True)
class Pair:
    """Two feedbacks compared; effects are positive where the second is higher."""

    first: str
    second: str
    wilcoxon: SignedRank
    nemenyi: Nemenyi
    conover: Conover


@dataclass(frozen=True, slots=True)
class MeasureAnalysis:
    """All about one measure, "qoe" or a factor.

    Attributes:
        scores: means over the sequences, on which the tests are done.
        feedbacks: by feedback, of `scores`.
        conditions: by sequence and feedback, of all answers there are.
        shapiro: by feedback.
        friedman: over the feedbacks.
        pairs: of feedbacks; empty where fewer than two participants are left.
        mann_whitney: used the device before or not, by feedback.
        structure: sequence x feedback; None where it cannot be computed.
    """

    scores: FeedbackScores
    feedbacks: dict[str, Summary]
    conditions: dict[str, dict[str, Summary]]
    shapiro: dict[str, Shapiro]
    friedman: Friedman
    pairs: tuple[Pair, ...]
    mann_whitney: dict[str, RankSum]
    structure: Structure | None


@dataclass(frozen=True, slots=True)
class Analysis:
    """A study in numbers.

    Attributes:
        scores: of all participants.
        choices: that were made.
        measures: "qoe" first, then the factors.
        remarks: of the store, about what could not be read.
    """

    scores: Scores
    choices: Choices
    measures: dict[str, MeasureAnalysis]
    remarks: tuple[str, ...]


def analyse(
    answers: Answers,
    choices: Choices | None = None,
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
    choices = choices or Choices()
    scores = scores_of(answers, with_unsound=choices.with_unsound)
    measures = {}
    for number, measure in enumerate(scores.measures):
        progress(number / len(scores.measures), f"analysing {measure}")
        measures[measure] = _measure(scores, measure, choices)
    return Analysis(scores, choices, _corrected(measures), answers.remarks)


def _measure(scores: Scores, measure: str, choices: Choices) -> MeasureAnalysis:
    balanced = by_feedback(scores, measure, choices.missing)
    values, names = balanced.values, balanced.feedbacks
    resampling, by_condition = choices.resampling, scores.of(measure)
    columns = dict(zip(names, values.T, strict=True))
    return MeasureAnalysis(
        balanced,
        {
            name: summarize(column, resampling, f"{measure}/{name}")
            for name, column in columns.items()
        },
        {
            sequence: {
                name: summarize(
                    by_condition[:, i, j], resampling, f"{measure}/{sequence}/{name}"
                )
                for j, name in enumerate(names)
            }
            for i, sequence in enumerate(scores.sequences)
        },
        {name: shapiro(column) for name, column in columns.items()},
        friedman(values, resampling, measure),
        _pairs(balanced, resampling) if len(values) > 1 else (),
        _expertise(scores, balanced, resampling),
        structure(by_condition, scores.participants),
    )


def _pairs(balanced: FeedbackScores, resampling: Resampling) -> tuple[Pair, ...]:
    values, names = balanced.values, balanced.feedbacks
    pairs = list(combinations(range(len(names)), 2))
    signed = [
        signed_rank(
            values[:, i],
            values[:, j],
            resampling,
            f"{balanced.measure}/{names[i]}/{names[j]}",
        )
        for i, j in pairs
    ]
    corrected = holm([one.p for one in signed])
    return tuple(
        Pair(names[i], names[j], replace(one, p_holm=p), by_range, by_t)
        for (i, j), one, p, by_range, by_t in zip(
            pairs,
            signed,
            corrected,
            nemenyi(values, pairs),
            conover(values, pairs),
            strict=True,
        )
    )


def _expertise(
    scores: Scores, balanced: FeedbackScores, resampling: Resampling
) -> dict[str, RankSum]:
    used = [scores.used_before.get(code) for code in balanced.participants]
    before = [i for i, is_used in enumerate(used) if is_used is True]
    new = [i for i, is_used in enumerate(used) if is_used is False]
    return {
        name: rank_sum(
            column[before], column[new], resampling, f"{balanced.measure}/{name}"
        )
        for name, column in zip(balanced.feedbacks, balanced.values.T, strict=True)
    }


def _corrected(measures: dict[str, MeasureAnalysis]) -> dict[str, MeasureAnalysis]:
    """Return the measures with p corrected over all of them.

    The family of Friedman's tests is QoE and its factors; that of the tests on
    expertise is all measures and feedbacks.
    """
    omnibus = holm([one.friedman.p_exact for one in measures.values()])
    groups = [test for one in measures.values() for test in one.mann_whitney.values()]
    expertise = iter(holm([test.p for test in groups]))
    return {
        name: replace(
            one,
            friedman=replace(one.friedman, p_holm=p),
            mann_whitney={
                feedback: replace(test, p_holm=next(expertise))
                for feedback, test in one.mann_whitney.items()
            },
        )
        for (name, one), p in zip(measures.items(), omnibus, strict=True)
    }
