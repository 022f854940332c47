"""The one hierarchy of errors that a person may get to read, and the sentences in it.

Every message says what is wrong, where, and what to do, in one sentence; the
command line prints it on stderr, the window shows it in the person's language.
"""

from __future__ import annotations

import numbers
import re
import shlex
import string
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:  # the doctor runs on older Pythons, which lack it
    from typing import Self

T = TypeVar("T")
_SPEC = re.compile(r"[+,]{0,2}0?\d?(\.\d)?[%a-zA-Z]?")  # of a number, and not long


class Message(str):
    """An English sentence that also carries what it was made of, to be translated.

    Args:
        template: as for `str.format`; without values it is taken as it is.
        **values: numbers, texts and messages, which are translated too; of an
            exception, its message.

    Attributes:
        template: the English sentence with places for the values.
        values: by the name of their place.
    """

    __slots__ = ("template", "values")

    template: str
    values: dict[str, Any]

    def __new__(cls, template: str, /, **values: object) -> Self:
        """Fill the template in."""
        if isinstance(template, cls) and not values:
            return template
        kept = {name: _plain(value) for name, value in values.items()}
        message = super().__new__(cls, template.format(**kept) if kept else template)
        message.template, message.values = str(template), kept
        return message

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, Any]]:
        """Be pickled as it was made."""
        return (self.template,), self.values


def joined(separator: str, parts: Iterable[str]) -> Message:
    """Return `separator.join(parts)`, of which each part can be translated."""
    values = {f"part{number}": part for number, part in enumerate(parts)}
    template = "{separator}".join(f"{{{name}}}" for name in values)
    return Message(template, separator=separator, **values)


def counted(count: int, noun: str) -> str:
    """1 participant, 2 participants."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def shell_line(*words: object) -> str:
    """A command to paste into a shell, whatever the words hold.

    A path is never taken for an option, nor by ffmpeg for a protocol (`12:30.wav`).
    """
    return " ".join(map(_shell_word, words))


def _shell_word(word: object) -> str:
    text = str(word)
    if hasattr(word, "__fspath__") and (
        text[:1] == "-" or ":" in text.partition("/")[0]
    ):
        text = f"./{text}"
    if text.isprintable():
        return shlex.quote(text)
    # what a terminal does not show, such as a line break, is written in octal
    return "".join(["$'", *map(_shell_character, text), "'"])


def _shell_character(one: str) -> str:
    if one.isprintable() and one not in "'\\":
        return one
    return "".join(f"\\{byte:03o}" for byte in one.encode(errors="surrogateescape"))


def message_of(problem: BaseException) -> Message:
    """The sentence of an exception."""
    if problem.args and isinstance(problem.args[0], Message):
        return problem.args[0]
    text = getattr(problem, "strerror", None) or str(problem)
    return Message(text or type(problem).__name__)


def to_json(message: str) -> Any:
    """Return a message as a JSON value: a text, or an object with template and values."""
    if not isinstance(message, Message) or not message.values:
        return str(message)
    values = {
        name: to_json(value) if isinstance(value, str) else value
        for name, value in message.values.items()
    }
    return {"template": message.template, "values": values}


def from_json(value: Any) -> Message:
    """Return the message that `to_json` has written; a text stands for itself.

    What comes from outside may hold any template, so its fields are checked.

    Raises:
        ValueError: it is neither.
    """
    if isinstance(value, str):
        return Message(value)
    try:
        template, values = value["template"], value["values"]
        for _, name, spec, _ in string.Formatter().parse(template):
            if name is not None and not (
                name.isidentifier() and _SPEC.fullmatch(spec or "")
            ):
                raise ValueError(f"has the field {name!r}")
        return Message(
            template,
            **{
                k: from_json(v) if isinstance(v, dict) else v for k, v in values.items()
            },
        )
    except (LookupError, TypeError, AttributeError, RecursionError) as problem:
        raise ValueError(f"is not a valid message ({problem})") from None


def _plain(value: object) -> object:
    if isinstance(value, BaseException):
        return message_of(value)
    if value is None or isinstance(value, (str, int, float)):
        return value
    if isinstance(value, numbers.Integral):
        return int(value)
    return float(value) if isinstance(value, numbers.Real) else str(value)


class HapticPlayerError(Exception):
    """Root: something was refused or failed, and the message says why.

    Args:
        template: the sentence, see `Message`.
        **values: for its places.
    """

    def __init__(self, template: str, /, **values: object) -> None:
        super().__init__(Message(template, **values))


class InputError(HapticPlayerError):
    """A file or value that came from outside cannot be used.

    Args:
        template: what is wrong.
        where: file, line, column; taken as it is.
        remedy: what to do; may use the same values.
        **values: for the places in both.
    """

    def __init__(
        self, template: str, /, *, where: str = "", remedy: str = "", **values: object
    ) -> None:
        is_template = remedy and not isinstance(remedy, Message)
        self.what = whole = Message(template, **values)
        self.where = where
        self.remedy = Message(remedy, **values) if is_template else remedy
        if where:
            whole = Message("{where}: {what}", where=where, what=whole)
        if remedy:
            whole = Message("{what}; {remedy}", what=whole, remedy=self.remedy)
        super().__init__(whole)


class MediaError(InputError):
    """A media file cannot be opened or decoded."""


class TelemetryError(InputError):
    """A recording holds no motion that can be used."""


class SequenceError(InputError):
    """A sequence folder is missing something, damaged, or cannot be written."""


class StudyError(InputError):
    """A study's definition, order or answers cannot be used, or cannot be kept."""


class DeviceError(HapticPlayerError):
    """A haptic device is missing, refused the connection or failed."""


class HapticsError(HapticPlayerError):
    """The haptics process could not be started or has died."""


class UsageError(HapticPlayerError):
    """The call is wrong, or a decision is needed (exit status 2)."""


class Cancelled(HapticPlayerError):  # noqa: N818 - a decision, not a fault
    """The user stopped a long piece of work; nothing was left behind."""

    def __init__(self) -> None:
        super().__init__(Message("cancelled; nothing was written"))


Progress = Callable[[float, str], None]
"""Called with the done fraction (0 to 1) and the step; raises Cancelled to stop."""


def no_progress(_fraction: float, _step: str) -> None:
    """Ignore the progress."""


def part_of(progress: Progress, number: int, count: int) -> Progress:
    """The progress of one of several pieces of work, counted from 0."""
    return lambda fraction, step: progress((number + fraction) / count, step)


def entry_named(known: Mapping[str, T], name: str, what: Message) -> T:
    """Return the entry of a registry that a person has named.

    Args:
        known: the entries by name, as people see them.
        name: that was given.
        what: each is, such as `Message("preset")`.
    """
    if name in known:
        return known[name]
    raise UsageError(
        "{what} {name!r} not found; choose one of {known}",
        what=what,
        name=name,
        known=", ".join(known),
    )
