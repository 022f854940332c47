"""The kinds of answers: a class for each, with all that the program knows about it.

How a kind looks to a participant is in `app.participant.questions.ROWS`.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import Any, ClassVar, NamedTuple

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.structures import missing
from hapticplayer.study.definition import MAX_ANSWER, Question, QuestionKind, Text

VISUAL_RANGE = (0, 100)
MAX_POINTS = 21
SIMULATED = "simulated"
_CORRECT = Message("correct it")
_BETWEEN = "must be between {least} and {most}"
_YES_NO: dict[str, Text] = {"true": {}, "false": {}}
Fault = tuple[str, Message, Message]
"""An entry, what is wrong there, and what to do."""


class AnswerColumn(NamedTuple):
    """A column of the data.

    Attributes:
        suffix: behind the name of the question.
        levels: texts by value; None for other values.
        unit: of a number.
        of: the option whose choice is the value; "" for the answer itself.
    """

    suffix: str = ""
    levels: dict[str, Text] | None = None
    unit: str = ""
    of: str = ""

    def cell(self, value: Any) -> Any:
        return value if value is None or not self.of else self.of in value


class AnswerKind(ABC):
    """How a question is answered; each kind is a class of its own.

    Attributes:
        name: as people choose it.
        uses: entries that only some kinds have.
        limits: least and most of answers that can be ranked and averaged; else None.
        refusal: why an answer is not allowed.
        columns: of the answers in the data.
    """

    name: ClassVar[Message]
    uses: ClassVar[tuple[str, ...]] = ()

    def __init__(self, asked: Question) -> None:
        self.asked = asked
        self.limits: tuple[int, int] | None = None
        self.refusal = Message("must be one of the choices")
        self.columns = [AnswerColumn()]

    def faults(self) -> Iterator[Fault]:
        """What is wrong with a question of this kind."""
        yield from ()

    @abstractmethod
    def allows(self, value: Any) -> bool:
        """Whether the question can be answered like this."""

    def number(self, value: Any) -> float | None:
        """What an answer counts as; None where it does not count."""
        is_counted = self.limits is not None and self.allows(value)
        return self._number(value) if is_counted else None

    def _number(self, value: Any) -> Any:
        return value

    @abstractmethod
    def drawn(self, rng: np.random.Generator) -> Any:
        """An answer at random, for simulated participants."""


class _Number(AnswerKind):
    name = Message("Number")
    uses: ClassVar[tuple[str, ...]] = ("least", "most", "unit")

    def __init__(self, asked: Question) -> None:
        super().__init__(asked)
        self.least, self.most = asked.least or 0, asked.most or 0
        self._prepare()

    def _prepare(self) -> None:
        self.limits = (self.least, self.most)
        text = "must be a number from {least} to {most}"
        self.refusal = Message(text, least=self.least, most=self.most)
        labels = sorted(self.asked.labels, key=lambda one: one.at)
        levels = {str(one.at): one.text for one in labels}
        self.columns = [AnswerColumn(levels=levels or None, unit=self.asked.unit)]

    def faults(self) -> Iterator[Fault]:
        lacking = [n for n in ("least", "most") if getattr(self.asked, n) is None]
        if lacking:
            yield lacking[0], *missing(lacking[0])
        elif self.least > self.most:
            yield (
                "most",
                Message("must be at least {limit}", limit=self.least),
                _CORRECT,
            )

    def allows(self, value: Any) -> bool:
        is_whole = isinstance(value, int) and not isinstance(value, bool)
        return is_whole and self.least <= value <= self.most

    def drawn(self, rng: np.random.Generator) -> Any:
        return int(rng.integers(self.least, self.most + 1))

    def _label_faults(self) -> Iterator[Fault]:
        points = [one.at for one in self.asked.labels]
        for number, at in enumerate(points):
            field = f"labels[{number}].at"
            if not self.least <= at <= self.most:
                what = Message(_BETWEEN, least=self.least, most=self.most)
                yield field, what, _CORRECT
            if at in points[:number]:
                what = Message("the point {at} has two labels", at=at)
                yield field, what, Message("remove one of them")


class _Visual(_Number):
    name = Message("Visual analogue scale")
    uses = ("labels",)

    def __init__(self, asked: Question) -> None:
        super().__init__(asked)
        self.least, self.most = VISUAL_RANGE
        self._prepare()

    def faults(self) -> Iterator[Fault]:
        return self._label_faults()


class _Scale(_Number):
    name = Message("Scale of points")
    uses: ClassVar[tuple[str, ...]] = ("least", "most", "labels", "in_qoe")

    def faults(self) -> Iterator[Fault]:
        if found := list(super().faults()):
            yield from found
            return
        count = self.most - self.least + 1
        if not 2 <= count <= MAX_POINTS:
            text = "must have 2 to {most} points, has {count}"
            yield "most", Message(text, most=MAX_POINTS, count=count), _CORRECT
        yield from self._label_faults()


class _Pair(_Scale):
    name = Message("Pair of opposites")
    uses = ("least", "most", "labels")

    def faults(self) -> Iterator[Fault]:
        if found := list(super().faults()):
            yield from found
        elif {one.at for one in self.asked.labels} != {self.least, self.most}:
            text = "must be the two opposites, at {least} and at {most}"
            what = Message(text, least=self.least, most=self.most)
            yield "labels", what, _CORRECT


class _YesNo(AnswerKind):
    name = Message("Yes or no")

    def __init__(self, asked: Question) -> None:
        super().__init__(asked)
        self.columns = [AnswerColumn(levels=_YES_NO)]

    def allows(self, value: Any) -> bool:
        return isinstance(value, bool)

    def drawn(self, rng: np.random.Generator) -> Any:
        return bool(rng.integers(2))


class _Choice(AnswerKind):
    name = Message("One of several answers")
    uses = ("choices",)

    def __init__(self, asked: Question) -> None:
        super().__init__(asked)
        self.keys = [one.key for one in asked.choices]
        levels = {one.key: one.text for one in asked.choices}
        self.columns = [AnswerColumn(levels=levels)]
        self._values = {one.key: one.value for one in asked.choices}
        known = [one for one in self._values.values() if one is not None]
        self.limits = (min(known), max(known)) if known else None

    def _number(self, value: Any) -> Any:
        return self._values[value]

    def faults(self) -> Iterator[Fault]:
        if len(self.keys) < 2:
            what = Message("must have at least {limit} entries", limit=2)
            yield "choices", what, Message("add an answer")
        for number, key in enumerate(self.keys):
            if key in self.keys[:number]:
                what = Message("duplicate key {key!r}", key=key)
                yield f"choices[{number}].key", what, Message("rename one of them")

    def allows(self, value: Any) -> bool:
        return isinstance(value, str) and value in self.keys

    def drawn(self, rng: np.random.Generator) -> Any:
        return str(rng.choice(self.keys))


class _Choices(_Choice):
    name = Message("Several answers")

    def __init__(self, asked: Question) -> None:
        super().__init__(asked)
        self.limits = None
        self.refusal = Message("must be a list of one or more of the choices")
        self.columns = [AnswerColumn(f".{key}", _YES_NO, of=key) for key in self.keys]

    def faults(self) -> Iterator[Fault]:
        yield from super().faults()
        for number, value in enumerate(self._values.values()):
            if value is not None:
                what = Message("is not used in {kind} questions", kind="choices")
                yield f"choices[{number}].value", what, Message("remove it")

    def allows(self, value: Any) -> bool:
        if not isinstance(value, list) or not value:
            return False
        is_known = all(isinstance(one, str) and one in self.keys for one in value)
        return is_known and len(set(value)) == len(value)

    def drawn(self, rng: np.random.Generator) -> Any:
        chosen = [key for key in self.keys if rng.integers(2)]
        return chosen or self.keys[:1]


class _Words(AnswerKind):
    """Has no column: a text is exported once somebody has read it."""

    name = Message("Text")
    uses = ("most",)

    def __init__(self, asked: Question) -> None:
        super().__init__(asked)
        self.most = MAX_ANSWER if asked.most is None else asked.most
        self.refusal = Message("has more than {most} characters", most=self.most)
        self.columns = []

    def faults(self) -> Iterator[Fault]:
        if not 1 <= self.most <= MAX_ANSWER:
            yield "most", Message(_BETWEEN, least=1, most=MAX_ANSWER), _CORRECT

    def allows(self, value: Any) -> bool:
        return isinstance(value, str) and len(value) <= self.most

    def drawn(self, rng: np.random.Generator) -> Any:
        return f"{SIMULATED} {rng.integers(1000)}"[: self.most]


ANSWER_KINDS: dict[QuestionKind, type[AnswerKind]] = {
    QuestionKind.SCALE: _Scale,
    QuestionKind.VISUAL: _Visual,
    QuestionKind.NUMBER: _Number,
    QuestionKind.YES_NO: _YesNo,
    QuestionKind.CHOICE: _Choice,
    QuestionKind.CHOICES: _Choices,
    QuestionKind.PAIR: _Pair,
    QuestionKind.TEXT: _Words,
}
OF_KINDS = tuple(
    dict.fromkeys(use for kind in ANSWER_KINDS.values() for use in kind.uses)
)
"""Entries that only some kinds use."""


def kind_of(asked: Question) -> AnswerKind:
    return ANSWER_KINDS[asked.kind](asked)


def range_of(asked: Question) -> tuple[int, int] | None:
    """The smallest and largest answer; None where answers are not numbers themselves."""
    kind = kind_of(asked)
    return kind.limits if isinstance(kind, _Number) else None
