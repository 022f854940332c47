"""Scores of scales: sums and means of answers, by the key of their publication."""

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from hapticplayer.errors import Message
from hapticplayer.study.definition import (
    CORRECT,
    Definition,
    QuestionPage,
    Score,
    ScoreRule,
    When,
)
from hapticplayer.study.questions import Fault, kind_of

_DECIMALS = 9  # 7 x 9.54 is 66.78
_STEPS = 200  # in which the range of a polynomial is searched
Limits = tuple[float, float]


class PageScores:
    """The scores of a page.

    Attributes:
        scores: by key.
        limits: least and most of what counts: of questions and scores, by key.
        items: questions that a score is made of, by key.
    """

    def __init__(self, page: QuestionPage) -> None:
        self.scores = {one.key: one for one in page.scores}
        self._kinds = {q.key: kind_of(q) for q in page.questions}
        self.limits: dict[str, Limits] = {
            key: kind.limits for key, kind in self._kinds.items() if kind.limits
        }
        named = {name for score in page.scores for name in score.of}
        self.items = {
            key: kind.asked for key, kind in self._kinds.items() if key in named
        }
        for score in page.scores:
            self.limits[score.key] = _limits(score, self.limits)

    def numbers(self, values: Mapping[str, Any]) -> dict[str, float | None]:
        """What the answers to the questions of the page count as, and the scores."""
        found = {key: kind.number(values.get(key)) for key, kind in self._kinds.items()}
        for key, score in self.scores.items():
            found[key] = _computed(score, self.counted(score, found))
        return found

    def counted(
        self, score: Score, numbers: Mapping[str, float | None]
    ) -> list[float | None]:
        """What a score is made of, in its direction."""
        return [self._turned(score, name, numbers[name]) for name in score.of]

    def _turned(self, score: Score, name: str, value: float | None) -> float | None:
        if value is None or name not in score.reversed:
            return value
        return sum(self.limits[name]) - value


class Scoring:
    """Adds scores to answers: those of the pages that are shown at some times."""

    def __init__(self, definition: Definition, *when: When) -> None:
        shown = (page for at in when for page in definition.pages_at(at))
        self._pages = [PageScores(page) for page in shown if page.scores]

    def completed(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The answers, and the scores by their keys."""
        made = dict(values)
        for page in self._pages:
            numbers = page.numbers(values)
            made |= {key: numbers[key] for key in page.scores}
        return made


def _computed(score: Score, parts: list[float | None]) -> float | None:
    given = [one for one in parts if one is not None]
    if len(given) < (score.least_answered or len(parts)):
        return None
    total = sum(given) / (len(given) if score.by is ScoreRule.MEAN else 1)
    return round(_polynomial(score, total), _DECIMALS)


def _polynomial(score: Score, at: float) -> float:
    return sum(factor * at**power for power, factor in enumerate(score.polynomial))


def _limits(score: Score, of: Mapping[str, Limits]) -> Limits:
    ends = [sum(of.get(name, (0.0, 0.0))[end] for name in score.of) for end in (0, 1)]
    count = len(score.of) if score.by is ScoreRule.MEAN else 1
    least, most = (end / count for end in ends)
    steps = (least + (most - least) * n / _STEPS for n in range(_STEPS + 1))
    reached = [round(_polynomial(score, at), _DECIMALS) for at in steps]
    return min(reached), max(reached)


def formula_of(score: Score) -> str:
    """How a score is computed, in words."""
    names = [
        f"{count} x " * (count > 1) + name + " (reversed)" * (name in score.reversed)
        for name, count in Counter(score.of).items()
    ]
    terms = [
        f"{factor:.9g}" + (f" x^{power}" if power > 1 else " x" * power)
        for power, factor in enumerate(score.polynomial)
        if factor
    ]
    text = f"{score.by} of {', '.join(names)}"
    if score.least_answered:
        text += f" (of those answered, at least {score.least_answered})"
    if score.polynomial == (0.0, 1.0):
        return text
    return f"{' + '.join(terms)}; x: {text}".replace("+ -", "- ")


def faults_of_scores(page: QuestionPage) -> Iterator[Fault]:
    """What is wrong with the scores of a page; fields are relative to it."""
    asked = {q.key: q for q in page.questions}
    known = {key for key, q in asked.items() if kind_of(q).limits}
    for number, score in enumerate(page.scores):
        field = f"scores[{number}]"
        for name in score.of:
            if name not in known:
                what = Message(
                    "{name!r} is not a number that is known there", name=name
                )
                remedy = Message("name questions of the page, or scores before it")
                yield f"{field}.of", what, remedy
            elif name in asked and asked[name].for_each_feedback:
                what = Message("{name!r} is asked for each feedback", name=name)
                yield f"{field}.of", what, Message("ask it once, or leave it out")
        for name in score.reversed:
            if name not in score.of:
                what = Message("{name!r} is not in 'of'", name=name)
                yield f"{field}.reversed", what, CORRECT
        if score.least_answered is not None and (
            score.by is not ScoreRule.MEAN or score.least_answered > len(score.of)
        ):
            what = Message("is only used with a mean of at least as many")
            yield f"{field}.least_answered", what, CORRECT
        known.add(score.key)
