"""The ratings as arrays, with missing answers.

QoE of a condition is the sum of those factors that the study says. The score of a feedback is the mean over
the sequences, per participant (the paper's QoE_All, section 4.3).
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import QOE

SCALE = (1, 5)
_SHOWN_FIRST = ("none", "random", "realistic")  # from little to much, as in the paper
_LEAST_FEEDBACKS = 2


class MissingPolicy(StrEnum):
    """Treatment of participants with missing answers."""

    PAIRED = "paired"
    """Drop sequences with a missing answer for all feedbacks of this participant, so that
    feedbacks are compared on the same sequences."""
    COMPLETE = "complete"
    """Drop participants with a missing answer."""


@dataclass(frozen=True, slots=True)
class Scores:
    """Ratings by participant, sequence, feedback and factor.

    Attributes:
        participants: codes, in the order of the first axis.
        sequences: names, second axis.
        feedbacks: names, third axis; none, random, realistic first.
        factors: names, fourth axis.
        ratings: (P, S, F, K), NaN without a usable answer.
        used_before: by code, whether the device was used before, where known.
        invalid: number of answers dropped because the playback was not valid.
        repeated: number of answers replaced by those of a repeated trial.
        ranges: least and most of each factor.
        qoe: factors that are summed.
        items: factors that are single questions with steps.
        sites: of the participants, where sessions of several were merged.
        sequence_factors: the level of each sequence, by factor.
    """

    participants: tuple[str, ...]
    sequences: tuple[str, ...]
    feedbacks: tuple[str, ...]
    factors: tuple[str, ...]
    ratings: Floats
    used_before: dict[str, bool]
    invalid: int
    repeated: int
    ranges: tuple[tuple[float, float], ...]
    qoe: tuple[str, ...]
    items: tuple[str, ...]
    sites: tuple[str, ...] = ()
    sequence_factors: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    @property
    def measures(self) -> tuple[str, ...]:
        """QoE, where factors are summed, and the factors."""
        return (*((QOE,) if self.qoe else ()), *self.factors)

    def by_range(self) -> dict[tuple[float, float], list[str]]:
        """The factors that have a range in common."""
        found: dict[tuple[float, float], list[str]] = {}
        for factor, limits in zip(self.factors, self.ranges, strict=True):
            found.setdefault(limits, []).append(factor)
        return found

    def limits_of(self, measure: str) -> tuple[float, float]:
        """Least and most of a measure; of QoE, of the sum."""
        summed = self.qoe if measure == QOE else (measure,)
        of = [self.ranges[self.factors.index(factor)] for factor in summed]
        return sum(low for low, _ in of), sum(high for _, high in of)

    def levels_of(self, factor: str) -> tuple[str, ...]:
        """The levels of a factor of the sequences, each once."""
        return tuple(dict.fromkeys(self.sequence_factors[factor]))

    @property
    def missing(self) -> int:
        """Number of missing answers."""
        return int(np.isnan(self.ratings).sum())

    @property
    def is_empty(self) -> bool:
        """Whether ratings were planned and not one can be used."""
        return self.ratings.size > 0 and self.missing == self.ratings.size

    def of(self, measure: str) -> Floats:
        """Return a measure (P, S, F); QoE is missing where any of its factors is."""
        if measure == QOE:
            summed = [self.factors.index(factor) for factor in self.qoe]
            return np.asarray(self.ratings[..., summed].sum(axis=3), np.float64)
        return self.ratings[:, :, :, self.factors.index(measure)]


@dataclass(frozen=True, slots=True)
class Sample:
    """One measure, as input of the statistics.

    Attributes:
        measure: "qoe" or a factor.
        feedbacks: names.
        participants: codes, of the rows of `values`.
        values: (n, F), means over the sequences, without NaN.
        dropped: codes of excluded participants.
        reduced: dropped sequences by code.
        used_before: whether each of `participants` had used the device; None if unknown.
        by_condition: (P, S, F) of all participants, NaN without a usable answer.
        all_participants: codes of all participants.
        is_item: whether it is a single question with steps.
        sites: of all participants; empty if there is one.
        sequence_factors: the level of each sequence, by factor.
    """

    measure: str
    feedbacks: tuple[str, ...]
    participants: tuple[str, ...]
    values: Floats
    dropped: tuple[str, ...]
    reduced: dict[str, tuple[str, ...]]
    used_before: tuple[bool | None, ...]
    by_condition: Floats
    all_participants: tuple[str, ...]
    is_item: bool = True
    sites: tuple[str, ...] = ()
    sequence_factors: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def each_pair(
        self, compare: Callable[[list[tuple[int, int]]], list[dict[str, Any]]]
    ) -> dict[str, Any]:
        """Return the results of all pairs of columns by name; {} for one participant."""
        pairs = list(combinations(range(len(self.feedbacks)), 2))
        if len(self.values) < 2:
            return {}
        names = (f"{self.feedbacks[i]}-{self.feedbacks[j]}" for i, j in pairs)
        return dict(zip(names, compare(pairs), strict=True))

    def by_level(self, factor: str) -> dict[str, Floats]:
        """Means (P, F) over the sequences of each level, NaN where one is missing.

        As `values`, they are of sequences that were answered for all feedbacks, and of
        participants who are not excluded.
        """
        levels = np.array(self.sequence_factors[factor])
        usable = _all(~np.isnan(self.by_condition))
        usable[[code in self.dropped for code in self.all_participants]] = False
        values = np.where(usable[:, :, None], self.by_condition, 0.0)
        found = {}
        for level in dict.fromkeys(levels.tolist()):
            here = levels == level
            counts = usable[:, here].sum(axis=1)[:, None].astype(np.float64)
            counts[counts == 0.0] = np.nan
            found[level] = values[:, here].sum(axis=1) / counts
        return found

    def each_feedback(
        self, compute: Callable[[str, Floats], dict[str, Any]]
    ) -> dict[str, Any]:
        """Return the results of each column (n,) by name."""
        columns = zip(self.feedbacks, self.values.T, strict=True)
        return {name: compute(name, column) for name, column in columns}


def factors_figure(scores: Scores, limits: tuple[float, float]) -> str:
    """The name of the figure of the factors with a range."""
    is_first = next(iter(scores.by_range())) == limits
    return "factors-by-feedback" + (
        "" if is_first else f"-{limits[0]:g}-to-{limits[1]:g}"
    )


def scores_of(answers: Answers, *, include_invalid: bool = False) -> Scores:
    """Return the answers as arrays.

    Args:
        answers: of a study.
        include_invalid: keep trials whose playback was not valid.
    """
    _check_design(answers)
    feedbacks = tuple(sorted(answers.feedbacks, key=shown_at))
    codes = tuple(person.code for person in answers.participants)
    axes = (codes, answers.sequences, feedbacks, answers.factors)
    index = [{name: i for i, name in enumerate(names)} for names in axes]
    ratings = np.full([len(names) for names in axes], np.nan)
    invalid = 0
    for one in answers.ratings:
        if one.value is None:
            continue
        if not (one.is_valid or include_invalid):
            invalid += 1
            continue
        names = (one.participant, one.sequence, one.feedback, one.factor)
        cell = tuple(at[name] for at, name in zip(index, names, strict=True))
        ratings[cell] = one.value
    used = {p.code: p.used_device_before for p in answers.participants}
    known = {code: is_used for code, is_used in used.items() if is_used is not None}
    limits = tuple(answers.ranges.get(one, SCALE) for one in answers.factors)
    qoe = answers.factors if answers.qoe is None else answers.qoe
    items = answers.factors if answers.items is None else answers.items
    counts = invalid, answers.repeated
    sites = tuple(person.site for person in answers.participants)
    sites = sites if len(set(sites)) > 1 else ()
    of_sequences = answers.sequence_factors
    return Scores(
        *axes, ratings, known, *counts, limits, qoe, items, sites, of_sequences
    )


def sample_of(
    scores: Scores, measure: str, policy: MissingPolicy = MissingPolicy.PAIRED
) -> Sample:
    """Return a measure, averaged over the sequences."""
    values = scores.of(measure)
    usable = _all(~np.isnan(values))
    kept = _all(usable) if policy is MissingPolicy.COMPLETE else ~_all(~usable)
    counted = np.where(usable[:, :, None], values, 0.0).sum(axis=1)
    means = counted[kept] / usable[kept].sum(axis=1)[:, None]
    reduced = {
        code: tuple(np.array(scores.sequences)[~used].tolist())
        for code, used, keep in zip(scores.participants, usable, kept, strict=True)
        if keep and not used.all()
    }
    codes = np.array(scores.participants, dtype=object)
    return Sample(
        measure=measure,
        feedbacks=scores.feedbacks,
        participants=tuple(codes[kept]),
        values=means,
        dropped=tuple(codes[~kept]),
        reduced=reduced,
        used_before=tuple(scores.used_before.get(code) for code in codes[kept]),
        by_condition=values,
        all_participants=scores.participants,
        is_item=measure in scores.items,
        sites=scores.sites,
        sequence_factors=scores.sequence_factors,
    )


def _all(flags: NDArray[np.bool_]) -> NDArray[np.bool_]:
    return np.asarray(flags.all(axis=-1), np.bool_)


def _check_design(answers: Answers) -> None:
    if not answers.participants:
        raise InputError("there are no participants", remedy="run a participant first")
    if len(answers.feedbacks) < _LEAST_FEEDBACKS:
        raise InputError("comparing needs two feedbacks or more")


def shown_at(feedback: str) -> int:
    """The place of a feedback among all, in tables, figures and names of pairs."""
    known = feedback in _SHOWN_FIRST
    return _SHOWN_FIRST.index(feedback) if known else len(_SHOWN_FIRST)
