"""A feedback condition: how it is named, what it needs, and its parameters."""

import enum
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from hapticplayer.errors import Message, UsageError
from hapticplayer.model import Feedback, ForceTrack
from hapticplayer.model.ranges import Range, finite_number

Value = float | str
"""Of a parameter."""

_BETWEEN = re.compile(r",(?=\w+=)")


class ParameterKind(enum.Enum):
    """What a parameter says."""

    NUMBER = enum.auto()
    WORD = enum.auto()
    """One of its choices."""
    CLIP = enum.auto()
    """Another sequence: its folder, in a study its key."""
    TRACK = enum.auto()
    """A further track of the sequence."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """One number or word that a condition depends on.

    Attributes:
        name: in files and on the command line, with its unit.
        text: for people.
        kind: what it says.
        default: where it is not given; "" leaves it open.
        range: of a NUMBER.
        choices: of a WORD.
    """

    name: str
    text: Message
    kind: ParameterKind
    default: Value
    range: Range | None = None
    choices: tuple[str, ...] = ()

    def check(self, value: object) -> Value:
        """Return a value that is allowed.

        Raises:
            UsageError: says what is allowed.
        """
        if self.range is not None:
            if finite_number(value) is None:
                raise UsageError("{name} must be a number", name=self.name)
            return self.range.parse(self.name, str(value))
        if not isinstance(value, str) or (self.choices and value not in self.choices):
            raise UsageError(
                "{name} must be one of {known}, not {value}"
                if self.choices
                else "{name} must be a text, not {value}",
                name=self.name,
                known=", ".join(self.choices),
                value=str(value)[:40],
            )
        return value

    def read(self, text: str) -> Value:
        """Return the value in a text of the command line; raises UsageError."""
        return self.range.parse(self.name, text) if self.range else self.check(text)


def _unavailable(*_wanted: object) -> ForceTrack:
    raise UsageError("this condition needs the sequence of the clip")


@dataclass(frozen=True, slots=True)
class ConditionInputs:
    """What tracks are made of.

    Attributes:
        realistic: track of the clip; the estimated one where its motion is.
        seed: of random numbers.
        rendered: returns the realistic track under another preset, "" for its own,
            and with or without the sequence's effects.
        other: returns the realistic track of another clip, "" for one that suits.
        stored: returns a further track of the sequence.
    """

    realistic: ForceTrack
    seed: int = 0
    rendered: Callable[[str, bool], ForceTrack] = _unavailable
    other: Callable[[str], ForceTrack] = _unavailable
    stored: Callable[[str], ForceTrack] = _unavailable

    def edited(self) -> ForceTrack:
        """Return the realistic track, which has the effects of its sequence on it."""
        if self.realistic.provenance.get("effects"):
            return self.realistic
        raise UsageError(
            "no effect is switched on for this clip; add one to its sequence, or give "
            "the name of an edited track"
        )


@dataclass(frozen=True, slots=True)
class FeedbackCondition:
    """What the hand gets while the clip plays.

    Attributes:
        name: in files and on the command line.
        text: for people.
        make: returns the track; called with the inputs and every parameter.
        meaning: what it is, in a few words.
        parameters: that `make` takes.
        is_stored: whether a sequence keeps the track in a file of its own.
        is_derived: whether the track is made when it is chosen; else one that is not
            stored is made whenever a sequence is opened.
        simulated_as: condition of the paper that simulated participants rate alike.
    """

    name: str
    text: Message
    make: Callable[..., ForceTrack]
    meaning: str = ""
    parameters: tuple[Parameter, ...] = ()
    is_stored: bool = True
    is_derived: bool = False
    simulated_as: Feedback = Feedback.RANDOM

    @property
    def is_made_at_opening(self) -> bool:
        """Whether each opened sequence has the track."""
        return not (self.is_stored or self.is_derived)

    def parameter(self, name: str) -> Parameter:
        for one in self.parameters:
            if one.name == name:
                return one
        known = ", ".join(one.name for one in self.parameters)
        raise UsageError(
            "feedback {feedback} has no parameter {name!r}; it has {known}"
            if known
            else "feedback {feedback} has no parameters",
            feedback=self.name,
            name=name,
            known=known,
        )

    def track(self, of: ConditionInputs, given: Mapping[str, Value]) -> ForceTrack:
        """Return the track; parameters that are not given have their defaults."""
        values = {one.name: one.default for one in self.parameters}
        return self.make(of, **values | dict(given))


class ChosenFeedback(NamedTuple):
    """A condition, or a further track of a sequence, with the parameters given."""

    name: str
    parameters: Mapping[str, Value]

    @property
    def text(self) -> str:
        """As on the command line: `delayed:delay_s=0.3`."""
        given = ",".join(
            f"{name}={value:g}" if isinstance(value, float) else f"{name}={value}"
            for name, value in self.parameters.items()
        )
        return f"{self.name}:{given}" if given else self.name


def described(given: Mapping[str, Any]) -> str:
    """Return parameters as people read them: "delay_s 0.3, ..."."""
    return ", ".join(
        f"{name} {value:g}" if isinstance(value, float) else f"{name} {value}"
        for name, value in given.items()
    )


def pairs_of(text: str) -> list[tuple[str, str]]:
    """Return name and value of each parameter in `delay_s=0.3,of=FOLDER`."""
    pairs = [part.partition("=") for part in _BETWEEN.split(text) if text]
    for name, mark, _value in pairs:
        if not mark:
            raise UsageError(
                "{text!r} is not a parameter; write NAME=VALUE", text=name[:80]
            )
    return [(name, value) for name, _mark, value in pairs]
