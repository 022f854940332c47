"""The answers of all participants as numbers: what is compared, and scores of scales."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from hapticplayer.study.definition import (
    OF_TRIALS,
    Definition,
    Question,
    QuestionPage,
    Score,
    TrialKind,
    When,
)
from hapticplayer.study.questions import MAX_POINTS, kind_of
from hapticplayer.study.scoring import Limits, PageScores

PageNumbers = Callable[[PageScores, str], Mapping[str, float | None]]
"""The numbers of somebody, by key: of a page, and a feedback after clips."""


class ScoreAnswers(NamedTuple):
    """A score of a scale, of all who answered.

    Attributes:
        page: of the definition.
        score: of that page.
        limits: least and most.
        feedback: that it is about; empty where it is about all.
        values: one for each participant, of a feedback the mean over the sequences; None
            where it is missing.
        parts: the questions it is made of, each once and in the direction of the score:
            rows are participants, without those who left one out.
    """

    page: QuestionPage
    score: Score
    limits: Limits
    feedback: str
    values: tuple[float | None, ...]
    parts: tuple[tuple[float, ...], ...]


class RatedAnswers:
    """What feedbacks are compared by: numbers that are given after a clip, and scores.

    Attributes:
        ranges: least and most by key; a question that is part of a score has none.
        qoe: keys of the questions that are summed.
        items: keys of the questions whose answers are steps in an order.
    """

    def __init__(self, definition: Definition) -> None:
        self.ranges: dict[str, Limits] = {}
        shown = definition.pages_at(When.AFTER_CLIP)
        is_rating = definition.trial is TrialKind.RATING
        self._pages = [PageScores(page) for page in shown if is_rating]
        for page in self._pages:
            for key, limits in page.limits.items():
                if key not in page.items:
                    self.ranges[key] = limits
        self.qoe = tuple(
            q.key
            for q in definition.questions_at(When.AFTER_CLIP)
            if q.in_qoe and q.key in self.ranges
        )
        self.items = tuple(
            q.key
            for q in definition.questions_at(When.AFTER_CLIP)
            if q.key in self.ranges and _has_steps(q)
        )

    def of(self, values: Mapping[str, Any]) -> dict[str, float | None]:
        """The numbers in the answers to the pages after a clip."""
        found: dict[str, float | None] = {}
        for page in self._pages:
            found |= page.numbers(values)
        return {key: found[key] for key in self.ranges}


def _has_steps(asked: Question) -> bool:
    """Whether the answers are so few that they are an order rather than a number."""
    limits = kind_of(asked).limits
    return bool(asked.choices) or (
        limits is not None and limits[1] - limits[0] < MAX_POINTS
    )


def collect_scores(
    definition: Definition, participants: Sequence[PageNumbers]
) -> Iterator[ScoreAnswers]:
    """Yield the scores of all pages, in the order of the definition."""
    for when in When:
        of = definition.feedback_keys if when in OF_TRIALS else ("",)
        for page in definition.pages_at(when):
            scoring = PageScores(page)
            for feedback in of if page.scores else ():
                rows = [numbers(scoring, feedback) for numbers in participants]
                for key, score in scoring.scores.items():
                    yield ScoreAnswers(
                        page,
                        score,
                        scoring.limits[key],
                        feedback,
                        tuple(row[key] for row in rows),
                        tuple(_parts_of(scoring, score, rows)),
                    )


def _parts_of(
    scoring: PageScores, score: Score, rows: Iterable[Mapping[str, float | None]]
) -> Iterator[tuple[float, ...]]:
    """Yield the items of a score, in its direction; none if it is made of scores."""
    names = dict.fromkeys(score.of)
    if not names.keys() <= scoring.items.keys():
        return
    for row in rows:
        turned = dict(zip(score.of, scoring.counted(score, row), strict=True))
        parts = tuple(one for one in turned.values() if one is not None)
        if len(parts) == len(names):
            yield parts
