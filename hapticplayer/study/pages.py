"""The participant's pages as values, without file names and conditions."""

import enum
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import StudyError
from hapticplayer.study.definition import (
    Definition,
    Question,
    QuestionKind,
    QuestionPage,
    Text,
)
from hapticplayer.study.plan import Plan
from hapticplayer.study.questions import kind_of, range_of
from hapticplayer.study.steps import pages_of, position_of


class PageKind(enum.StrEnum):
    """Kinds of pages."""

    CONSENT = "consent"
    QUESTIONS = "questions"
    DEMONSTRATION = "demonstration"
    READY = "ready"
    INTERVAL = "interval"
    """Before each of two clips of a trial."""
    PLAYING = "playing"
    PAUSED = "paused"
    PROBLEM = "problem"
    THANKS = "thanks"
    STOPPED = "stopped"


Replays = tuple[tuple[str, tuple[tuple[str, str], ...]], ...]
"""Rows of clips that may be played again: (heading, ((label, token), ...))."""


@dataclass(frozen=True, slots=True)
class AskedQuestion:
    """A question in the participant's language.

    Attributes:
        name: of the answer: key of the question, with "@feedback" if it is asked for
            each feedback.
        question: of the definition.
        text: the question.
        help: a line below it; may be empty.
        heading: name of the feedback, empty for other questions.
        options: what can be chosen: (answer, text).
        labels: of points of a scale.
    """

    name: str
    question: Question
    text: str
    help: str
    heading: str
    options: tuple[tuple[Any, str], ...]
    labels: Mapping[int, str]

    @property
    def kind(self) -> QuestionKind:
        return self.question.kind


@dataclass(frozen=True, slots=True)
class Page:
    """One page.

    Attributes:
        kind: see PageKind.
        step: name of the step.
        key: of the page of questions.
        text: in the participant's language.
        questions: to be answered.
        replays: clips that can be played again.
        one_by_one: whether its questions are shown one after the other.
        position, count: of the trial; 0 for other pages.
        number: increases with each page.
    """

    kind: PageKind
    step: str
    key: str = ""
    text: str = ""
    questions: tuple[AskedQuestion, ...] = ()
    replays: Replays = ()
    one_by_one: bool = False
    position: int = 0
    count: int = 0
    number: int = 0


class PageMaker:
    """Makes the pages of one session, in the participant's language.

    Args:
        definition: of the session.
        plan: of the session.
        minutes: about how long it takes; 0 where no page is shown.
    """

    def __init__(self, definition: Definition, plan: Plan, minutes: int = 0) -> None:
        self._definition, self._plan = definition, plan
        self._blanks = {
            "{code}": plan.code,
            "{minutes}": str(minutes),
            "{trials}": str(len(plan.order)),
            "{feedbacks}": str(len(plan.labels)),
            "{feel}": definition.words.feel[plan.language],
        }

    def page(
        self,
        kind: PageKind,
        step: str,
        number: int,
        asking: QuestionPage | None = None,
        interval: int = 1,
    ) -> Page:
        """Return a page; `asking` has its questions, the first of the step by default.

        An INTERVAL page says the number of a clip.
        """
        if kind is not PageKind.QUESTIONS:
            asking = None
        elif asking is None:
            asking = next(iter(pages_of(self._definition, step)), None)
        return Page(
            kind=kind,
            step=step,
            key=asking.key if asking else "",
            text=f"{self.word('clip')} {interval}"
            if kind is PageKind.INTERVAL
            else self._text_of(kind, asking),
            questions=tuple(self.asked(asking)) if asking else (),
            replays=self._replays() if asking and asking.replays else (),
            one_by_one=asking is not None and asking.one_by_one,
            position=position_of(step) or 0,
            count=len(self._plan.order),
            number=number,
        )

    def text(self, name: str) -> str:
        text: Text = getattr(self._definition.texts, name)
        return self._filled(text)

    def _filled(self, text: Text) -> str:
        """A text in the participant's language with what this session has."""
        filled = text[self._plan.language]
        for blank, value in self._blanks.items():
            filled = filled.replace(blank, value)
        return filled

    def word(self, name: str) -> str:
        """Return the label of a button in the participant's language."""
        word: Text = getattr(self._definition.words, name)
        return self._filled(word)

    def _text_of(self, kind: PageKind, asking: QuestionPage | None) -> str:
        if kind is PageKind.QUESTIONS:
            return self._filled(asking.text) if asking and asking.text else ""
        if kind in (PageKind.PAUSED, PageKind.PROBLEM, PageKind.STOPPED):
            return self.word(kind.value)
        return "" if kind is PageKind.PLAYING else self.text(kind.value)

    def asked(self, page: QuestionPage) -> Iterator[AskedQuestion]:
        """Yield the questions of a page, some of them once for each feedback."""
        for question in page.questions:
            if not question.for_each_feedback:
                yield self._ask(question, question.key)
                continue
            for number, feedback in enumerate(self._plan.labels, 1):
                name = f"{question.key}@{feedback}"
                yield self._ask(question, name, self._feedback_name(number))

    def _ask(self, question: Question, name: str, heading: str = "") -> AskedQuestion:
        language = self._plan.language
        text = self._definition.wording(question, language)
        if not question.required:
            text += f" ({self.word('optional')})"
        return AskedQuestion(
            name=name,
            question=question,
            text=text,
            help=question.help[language] if question.help else "",
            heading=heading,
            options=self._options(question, language),
            labels={one.at: one.text[language] for one in question.labels},
        )

    def _options(self, asked: Question, language: str) -> tuple[tuple[Any, str], ...]:
        if asked.kind is QuestionKind.YES_NO:
            return (True, self.word("yes")), (False, self.word("no"))
        if asked.kind in (QuestionKind.SCALE, QuestionKind.PAIR):
            least, most = range_of(asked) or (0, 0)
            return tuple((n, number_text(n)) for n in range(least, most + 1))
        return tuple((one.key, one.text[language]) for one in asked.choices)

    def _feedback_name(self, number: int) -> str:
        """Return the numbered name of a feedback, which hides the condition."""
        return f"{self.word('feedback')} {number}"

    def _replays(self) -> Replays:
        word, clips = self.word("clip"), len(self._definition.sequences)
        return tuple(
            (
                self._feedback_name(number),
                tuple((f"{word} {n}", f"{number}.{n}") for n in range(1, clips + 1)),
            )
            for number in range(1, 1 + len(self._plan.labels))
        )


def check_answers(
    questions: Iterable[AskedQuestion], values: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the answers of a page; unanswered ones are None."""
    checked: dict[str, Any] = {}
    for question in questions:
        asked = question.question
        value = values.get(question.name)
        if isinstance(value, str):
            value = value.strip() or None
        if value in (None, []):
            value = None
            if asked.required:
                raise StudyError("is not answered yet", where=question.name)
        elif not kind_of(asked).allows(value):
            raise StudyError(kind_of(asked).refusal, where=question.name)
        checked[question.name] = value
    if unknown := set(values) - set(checked):
        raise StudyError("is not a question of this page", where=min(unknown))
    return checked


def number_text(value: int) -> str:
    return str(value).replace("-", "\u2212")
