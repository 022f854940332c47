"""The ratings as arrays, and what is missing in them.

QoE of a condition is the sum of its factors. The score of a feedback is the mean over
the sequences, per participant (the paper's QoE_All, section 4.3).
"""

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import StrEnum
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats
from hapticplayer.study.answers import Answers, Rating

QOE = "qoe"
SCALE = (1, 5)
_SHOWN_FIRST = ("none", "random", "realistic")  # from little to much, as in the paper
_LEAST_FEEDBACKS = 2


class MissingPolicy(StrEnum):
    """What becomes of a participant whose answers have holes."""

    PAIRED = "paired"
    """Sequences with a hole are left out for all feedbacks of this participant, so that
    the feedbacks are still compared on the same sequences."""
    COMPLETE = "complete"
    """A participant with any hole is left out."""


@dataclass(frozen=True, slots=True)
class Scores:
    """Ratings by participant, sequence, feedback and factor.

    Attributes:
        participants: codes, in the order of the first axis.
        sequences: names, second axis.
        feedbacks: names, third axis; none, random, realistic first.
        factors: names, fourth axis.
        ratings: (P, S, F, K), 1 to 5, NaN where there is no usable answer.
        used_before: code to whether the device was used before; only where known.
        unsound: answers left out because the playback was not sound.
        repeated: answers replaced by those of a repeated, sound trial.
    """

    participants: tuple[str, ...]
    sequences: tuple[str, ...]
    feedbacks: tuple[str, ...]
    factors: tuple[str, ...]
    ratings: Floats
    used_before: dict[str, bool]
    unsound: int
    repeated: int

    @property
    def measures(self) -> tuple[str, ...]:
        """QoE and the factors."""
        return (QOE, *self.factors)

    @property
    def missing(self) -> int:
        """How many answers of the design there are not."""
        return int(np.isnan(self.ratings).sum())

    def of(self, measure: str) -> Floats:
        """Return a measure (P, S, F); QoE is missing where any of its factors is."""
        if measure == QOE:
            return np.asarray(self.ratings.sum(axis=3), np.float64)
        return self.ratings[:, :, :, self.factors.index(measure)]


@dataclass(frozen=True, slots=True)
class Sample:
    """One measure as the statistics see it.

    Attributes:
        measure: "qoe" or a factor.
        feedbacks: names.
        participants: codes of those who are in `values`.
        values: (n, F), averaged over the sequences, without holes.
        dropped: codes of those who are not in it.
        reduced: code to the sequences that were left out.
        used_before: whether each of `participants` had used the device; None if unknown.
        by_condition: (P, S, F) of everybody, NaN where there is no usable answer.
        everybody: codes of all participants.
    """

    measure: str
    feedbacks: tuple[str, ...]
    participants: tuple[str, ...]
    values: Floats
    dropped: tuple[str, ...]
    reduced: dict[str, tuple[str, ...]]
    used_before: tuple[bool | None, ...]
    by_condition: Floats
    everybody: tuple[str, ...]

    def each_pair(
        self, compare: Callable[[list[tuple[int, int]]], list[dict[str, Any]]]
    ) -> dict[str, Any]:
        """Return what is found of all pairs of columns, by name; none of one person."""
        pairs = list(combinations(range(len(self.feedbacks)), 2))
        if len(self.values) < 2:
            return {}
        names = (f"{self.feedbacks[i]}-{self.feedbacks[j]}" for i, j in pairs)
        return dict(zip(names, compare(pairs), strict=True))

    def each_feedback(
        self, look: Callable[[str, Floats], dict[str, Any]]
    ) -> dict[str, Any]:
        """Return what is found of each column (n,), by name."""
        columns = zip(self.feedbacks, self.values.T, strict=True)
        return {name: look(name, column) for name, column in columns}


def scores_of(answers: Answers, *, with_unsound: bool = False) -> Scores:
    """Return the answers as arrays.

    Args:
        answers: of a study.
        with_unsound: keep ratings of trials whose playback was not sound.

    Raises:
        InputError: when the answers do not fit their own design.
    """
    _check_design(answers)
    feedbacks = tuple(sorted(answers.feedbacks, key=_shown_at))
    codes = tuple(person.code for person in answers.participants)
    axes = (codes, answers.sequences, feedbacks, answers.factors)
    index = [{name: i for i, name in enumerate(names)} for names in axes]
    ratings = np.full([len(names) for names in axes], np.nan)
    taken: dict[tuple[int, ...], Rating] = {}
    repeated = 0
    for rating in answers.ratings:
        cell = _cell(rating, index)
        before = taken.get(cell)
        repeated += before is not None
        taken[cell] = rating if before is None else _better(before, rating)
    unsound = 0
    for cell, rating in taken.items():
        if rating.value is None:
            continue
        if not (rating.sound or with_unsound):
            unsound += 1
            continue
        ratings[cell] = rating.value
    used = {p.code: p.used_device_before for p in answers.participants}
    known = {code: is_used for code, is_used in used.items() if is_used is not None}
    return Scores(*axes, ratings, known, unsound, repeated)


def sample_of(
    scores: Scores, measure: str, policy: MissingPolicy = MissingPolicy.PAIRED
) -> Sample:
    """Return a measure with its mean over the sequences for each feedback."""
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
        everybody=scores.participants,
    )


def _all(flags: NDArray[np.bool_]) -> NDArray[np.bool_]:
    return np.asarray(flags.all(axis=-1), np.bool_)


def _check_design(answers: Answers) -> None:
    codes = tuple(person.code for person in answers.participants)
    for kind, names in (
        (Message("participant"), codes),
        (Message("sequence"), answers.sequences),
        (Message("feedback"), answers.feedbacks),
        (Message("factor"), answers.factors),
    ):
        if len(set(names)) != len(names):
            raise InputError(
                "a {kind} is named twice ({name})", kind=kind, name=_first_twice(names)
            )
        if any(name.encode(errors="replace").decode() != name for name in names):
            raise InputError("a {kind} has half a character in its name", kind=kind)
        if not names:
            raise InputError(
                "there is no {kind}", remedy="run a participant first", kind=kind
            )
    if len(answers.feedbacks) < _LEAST_FEEDBACKS:
        raise InputError("one feedback alone cannot be compared with anything")
    if QOE in answers.factors:
        raise InputError(
            "no factor may be called {name!r}, the name of their sum", name=QOE
        )


def _first_twice(names: Iterable[str]) -> str:
    return next(name for name, count in Counter(names).items() if count > 1)


def _shown_at(feedback: str) -> int:
    known = feedback in _SHOWN_FIRST
    return _SHOWN_FIRST.index(feedback) if known else len(_SHOWN_FIRST)


def _cell(rating: Rating, index: list[dict[str, int]]) -> tuple[int, ...]:
    names = (rating.participant, rating.sequence, rating.feedback, rating.factor)
    kinds = (
        Message("participant"),
        Message("sequence"),
        Message("feedback"),
        Message("factor"),
    )
    for kind, name, known in zip(kinds, names, index, strict=True):
        if name not in known:
            raise InputError(
                "a rating names the {kind} {name!r}, which there is not",
                kind=kind,
                name=name,
            )
    low, high = SCALE
    if rating.value is not None and not low <= rating.value <= high:
        raise InputError(
            "a rating of {rating} is outside {low} to {high}",
            where=Message(
                "participant {participant}, {sequence}, {feedback}, {factor}",
                participant=rating.participant,
                sequence=rating.sequence,
                feedback=rating.feedback,
                factor=rating.factor,
            ),
            rating=rating.value,
            low=low,
            high=high,
        )
    return tuple(known[name] for name, known in zip(names, index, strict=True))


def _better(before: Rating, after: Rating) -> Rating:
    """Return which of two ratings of one condition counts: the sound one."""
    if before.sound and after.sound:
        raise InputError(
            "a condition was rated twice although it was sound the first time",
            where=Message(
                "participant {participant}, {sequence}, {feedback}, {factor}",
                participant=after.participant,
                sequence=after.sequence,
                feedback=after.feedback,
                factor=after.factor,
            ),
        )
    return before if before.sound else after
