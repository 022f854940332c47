"""What a participant sees and is asked, as values: no file names, no conditions."""

import enum
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message, StudyError
from hapticplayer.study.definition import LIKERT, Definition, Question, QuestionKind


class PageKind(enum.StrEnum):
    """What kind of page is shown."""

    CONSENT = "consent"
    QUESTIONS = "questions"
    DEMONSTRATION = "demonstration"
    READY = "ready"
    PLAYING = "playing"
    PAUSED = "paused"
    PROBLEM = "problem"
    THANKS = "thanks"
    STOPPED = "stopped"


@dataclass(frozen=True, slots=True)
class Asked:
    """A question in the participant's language.

    Attributes:
        name: of the answer: the question's key, with "@feedback" where it is asked
            for each feedback.
        kind: how it is answered.
        text: the question.
        heading: which feedback it is about, empty where it is about all.
        least, most: of a number; most characters of a text.
        choices: (key, text) of a CHOICE.
        required: whether it has to be answered.
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
        step: name of the step it belongs to.
        text: what it says.
        questions: to be answered.
        replays: rows of clips, each (heading, ((label, token), ...)): what may be
            played again.
        position, count: of the trial, 0 where it is none.
        number: of the page since the session was opened; another one is another page.
    """

    kind: PageKind
    step: str
    text: str = ""
    questions: tuple[Asked, ...] = ()
    replays: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = ()
    position: int = 0
    count: int = 0
    number: int = 0


def ask(
    definition: Definition,
    questions: Iterable[Question],
    language: str,
    labels: tuple[str, ...] = (),
) -> tuple[Asked, ...]:
    """Return questions as they are asked, those about each feedback several times.

    Args:
        definition: of the study.
        questions: of the page.
        language: of the participant.
        labels: feedbacks in the order of their numbers.
    """
    made: list[Asked] = []
    for question in questions:
        if not question.for_each_feedback:
            made.append(_asked(definition, question, language))
            continue
        for number, feedback in enumerate(labels, 1):
            made.append(_asked(definition, question, language, feedback, number))
    return tuple(made)


def feedback_name(definition: Definition, language: str, number: int) -> str:
    """Return what a participant knows of a feedback: a number."""
    return f"{definition.words.feedback[language]} {number}"


def _asked(
    definition: Definition,
    question: Question,
    language: str,
    feedback: str = "",
    number: int = 0,
) -> Asked:
    return Asked(
        name=f"{question.key}@{feedback}" if feedback else question.key,
        kind=question.kind,
        text=definition.wording(question, language),
        heading=feedback_name(definition, language, number) if feedback else "",
        least=question.lowest,
        most=question.highest,
        choices=tuple((c.key, c.text[language]) for c in question.choices),
        required=question.required,
    )


def check_answers(
    questions: Iterable[Asked], values: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the answers of a page; unanswered ones are None.

    Raises:
        StudyError: for the first answer that is missing or impossible; its `where`
            is the name of the question.
    """
    checked: dict[str, Any] = {}
    for question in questions:
        value = values.get(question.name)
        if isinstance(value, str):
            value = value.strip() or None
        if value is None:
            if question.required:
                raise StudyError("is not answered yet", where=question.name)
        elif not _fits(question, value):
            raise StudyError(_limits(question), where=question.name)
        checked[question.name] = value
    if unknown := set(values) - set(checked):
        raise StudyError("is no question of this page", where=min(unknown))
    return checked


def _fits(question: Asked, value: Any) -> bool:
    is_whole = isinstance(value, int) and not isinstance(value, bool)
    match question.kind:
        case QuestionKind.LIKERT:
            return is_whole and value in LIKERT
        case QuestionKind.NUMBER:
            return is_whole and question.least <= value <= question.most
        case QuestionKind.CHOICE:
            return value in [key for key, _ in question.choices]
        case QuestionKind.YES_NO:
            return isinstance(value, bool)
        case QuestionKind.TEXT:
            return isinstance(value, str) and len(value) <= question.most


def _limits(question: Asked) -> str:
    if question.kind is QuestionKind.NUMBER:
        return Message(
            "needs a number from {least} to {most}",
            least=question.least,
            most=question.most,
        )
    if question.kind is QuestionKind.TEXT:
        return Message("has more than {most} characters", most=question.most)
    return Message("has an answer that was not offered")
