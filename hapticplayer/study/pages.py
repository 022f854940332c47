"""The participant's pages as values, without file names and conditions."""

import enum
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message, StudyError
from hapticplayer.study.definition import (
    LIKERT,
    Definition,
    Question,
    QuestionKind,
    Text,
)
from hapticplayer.study.plan import Plan
from hapticplayer.study.steps import POST_TEST, SHEET, position_of


class PageKind(enum.StrEnum):
    """Kinds of pages."""

    CONSENT = "consent"
    QUESTIONS = "questions"
    DEMONSTRATION = "demonstration"
    READY = "ready"
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
        kind: how it is answered.
        text: the question.
        heading: name of the feedback, empty for other questions.
        least, most: limits of a number; most also of the length of a text.
        choices: (key, text) of a CHOICE.
        required: whether an answer is required.
    """

    name: str
    kind: QuestionKind
    text: str
    heading: str
    least: int
    most: int
    choices: tuple[tuple[str, str], ...]
    required: bool


@dataclass(frozen=True, slots=True)
class Page:
    """One page.

    Attributes:
        kind: see PageKind.
        step: name of the step.
        text: in the participant's language.
        questions: to be answered.
        replays: clips that can be played again.
        position, count: of the trial; 0 for other pages.
        number: increases with each page.
    """

    kind: PageKind
    step: str
    text: str = ""
    questions: tuple[AskedQuestion, ...] = ()
    replays: Replays = ()
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

    def page(self, kind: PageKind, step: str, number: int) -> Page:
        """Return a page."""
        is_asking = kind is PageKind.QUESTIONS
        return Page(
            kind=kind,
            step=step,
            text=self._text_of(kind, step),
            questions=tuple(self.asked(step)) if is_asking else (),
            replays=self._replays() if is_asking and step == POST_TEST else (),
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

    def scale(self) -> tuple[str, str]:
        """Return the labels of the ends of the five-point scale."""
        scale, language = self._definition.scale, self._plan.language
        return scale.lowest[language], scale.highest[language]

    def _text_of(self, kind: PageKind, step: str) -> str:
        if kind is PageKind.QUESTIONS:
            if step == SHEET:
                return ""
            return self.text("post_test" if step == POST_TEST else "questions")
        if kind in (PageKind.PAUSED, PageKind.PROBLEM, PageKind.STOPPED):
            return self.word(kind.value)
        return "" if kind is PageKind.PLAYING else self.text(kind.value)

    def asked(self, step: str) -> Iterator[AskedQuestion]:
        """Yield the questions of a step, some of them once for each feedback."""
        definition = self._definition
        pages = {SHEET: definition.sheet, POST_TEST: definition.post_test}
        for question in pages.get(step, definition.trial_questions):
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
            kind=question.kind,
            text=text,
            heading=heading,
            least=question.lowest,
            most=question.highest,
            choices=tuple((c.key, c.text[language]) for c in question.choices),
            required=question.required,
        )

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
        value = values.get(question.name)
        if isinstance(value, str):
            value = value.strip() or None
        if value is None:
            if question.required:
                raise StudyError("is not answered yet", where=question.name)
        elif not is_allowed(question, value):
            raise StudyError(_limits(question), where=question.name)
        checked[question.name] = value
    if unknown := set(values) - set(checked):
        raise StudyError("is not a question of this page", where=min(unknown))
    return checked


def is_allowed(question: AskedQuestion, value: Any) -> bool:
    """Whether a question can be answered like this."""
    is_whole = isinstance(value, int) and not isinstance(value, bool)
    match question.kind:
        case QuestionKind.LIKERT:
            return is_whole and value in LIKERT
        case QuestionKind.NUMBER:
            return is_whole and question.least <= value <= question.most
        case QuestionKind.CHOICE:
            return isinstance(value, str) and value in dict(question.choices)
        case QuestionKind.YES_NO:
            return isinstance(value, bool)
        case QuestionKind.TEXT:
            return isinstance(value, str) and len(value) <= question.most


def _limits(question: AskedQuestion) -> str:
    if question.kind is QuestionKind.NUMBER:
        return Message(
            "must be a number from {least} to {most}",
            least=question.least,
            most=question.most,
        )
    if question.kind is QuestionKind.TEXT:
        return Message("has more than {most} characters", most=question.most)
    return Message("must be one of the choices")
