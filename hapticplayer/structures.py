"""Typed structures from the JSON of untrusted files and services; errors name the field."""

import re
from collections.abc import Iterable
from types import UnionType
from typing import (
    Annotated,
    Any,
    Literal,
    TypeVar,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

import msgspec
from msgspec import Struct

from hapticplayer.errors import DeviceError, InputError, Message, joined, message_of
from hapticplayer.untrusted import PathLike, parse_json, read_regular

MAX_JSON_BYTES = 4 << 20
MAX_COMMAS, MAX_BRACKETS = 3_000_000, 1_000_000
"""So many values and lists fit into 400 MB once they are read."""

MAX_TEXT = 20_000
KEY = r"^[a-z0-9_][a-z0-9_-]{0,39}\Z"
FILLED = r"\S"
SHA256 = r"^[0-9a-f]{64}\Z"
_MAX_SHOWN, _MAX_SAID = 40, 200

_KINDS = {
    "str": Message("a text"),
    "int": Message("a whole number"),
    "float": Message("a number"),
    "bool": Message("true or false"),
    "array": Message("a list"),
    "object": Message("an object"),
}
_LIMITS = {
    " >= ": Message("must be at least {limit}"),
    " <= ": Message("must be at most {limit}"),
    " of length >= ": Message("must have at least {limit} entries"),
    " of length <= ": Message("must have at most {limit} entries"),
    " of length ": Message("must have {limit} entries"),
    "str of length >= ": Message("must have at least {limit} characters"),
    "str of length <= ": Message("must have at most {limit} characters"),
}
_CORRECT = Message("correct it")
_OF_PATTERNS = {
    KEY: (
        Message("is not a valid key"),
        Message(
            "use at most {most} of a-z, 0-9, _ and -, without a - in front", most=40
        ),
    ),
    FILLED: (Message("is empty"), _CORRECT),
    SHA256: (Message("is not a SHA-256 checksum"), _CORRECT),
}
"""How a text is refused that does not match."""

Kind = TypeVar("Kind")
Refusal = tuple[Message, Message]
"""What is wrong, and what to do."""


def convert(
    value: Any,
    kind: type[Kind],
    where: str,
    error: type[InputError] = InputError,
    remedy: str = "",
    *,
    strict: bool = True,
) -> Kind:
    """Return a value from JSON as a typed structure.

    Args:
        value: to be checked.
        kind: of the structure.
        where: the file, for messages.
        error: to be raised.
        remedy: in place of the one that fits the field.
        strict: do not convert texts to numbers.

    Raises:
        InputError: `error`; names the wrong field and what is allowed there.
    """
    try:
        return msgspec.convert(value, kind, strict=strict)
    except InputError as problem:  # of a value type that checks itself
        raise error(message_of(problem), where=where, remedy=remedy) from None
    except UnicodeEncodeError:
        what = Message("holds half a character")
        raise error(what, where=where, remedy=remedy or _CORRECT) from None
    except (msgspec.ValidationError, OverflowError) as problem:
        said, _, place = str(problem).rpartition(" - at `$")
        try:
            field, found = _entry(value, kind, place if said else "")
        except (AttributeError, LookupError, StopIteration, TypeError, ValueError):
            said, field, found = "", "", kind  # the name of an unknown entry, no place
        what, to_do = _reworded(said or str(problem), found)
        where = ", ".join(filter(None, (where, field)))
        raise error(what, where=where, remedy=remedy or to_do) from None


def decode(
    content: bytes,
    kind: type[Kind],
    where: str,
    error: type[InputError] = InputError,
    remedy: str = "",
    most_bytes: int = MAX_JSON_BYTES,
) -> Kind:
    """JSON as a typed structure; see `convert`."""
    if len(content) > most_bytes:
        raise error(Message("is too large"), where=where, remedy=remedy)
    brackets = max(content.count(b"{"), content.count(b"["))
    if brackets > MAX_BRACKETS or content.count(b",") > MAX_COMMAS:
        raise error(Message("holds too many values"), where=where, remedy=remedy)
    value = parse_json(content, where, error, remedy or _CORRECT)
    return convert(value, kind, where, error, remedy)


def read_json(
    path: PathLike,
    kind: type[Kind],
    error: type[InputError] = InputError,
    remedy: str = "",
    most_bytes: int = MAX_JSON_BYTES,
) -> Kind:
    """The content of a JSON file as a typed structure; see `convert`."""
    content = read_regular(path, most_bytes, error, remedy)
    return decode(content, kind, str(path), error, remedy, most_bytes)


def understood(value: Any, kind: type[Kind], where: str) -> Kind:
    """What a service said, as a typed structure; raises DeviceError with the field."""
    try:
        return convert(value, kind, where, remedy="update it")
    except InputError as problem:
        raise DeviceError(message_of(problem)) from None


def message_in(text: str | bytes, where: str) -> Any:
    """The JSON of a message; raises DeviceError."""
    content = text.encode() if isinstance(text, str) else text
    try:
        return parse_json(content, where, InputError, "update it")
    except InputError as problem:
        raise DeviceError(message_of(problem)) from None


def check_schema(
    content: Any,
    schema: tuple[str, int],
    where: str,
    other: Refusal,
    error: type[InputError] = InputError,
) -> None:
    """Raise the error for an object of another schema, or of another version of it.

    Args:
        content: to be checked.
        schema: name and version.
        where: the file, for messages.
        other: how another object is refused.
        error: to be raised.
    """
    if not isinstance(content, dict) or content.get("schema") != schema[0]:
        raise error(other[0], where=where, remedy=other[1])
    if content.get("version") != schema[1]:
        raise error(
            "has version {found}, this program reads {version}",
            where=where,
            remedy="update hapticplayer",
            found=repr(content.get("version"))[:_MAX_SHOWN],
            version=schema[1],
        )


def missing(name: str) -> Refusal:
    """Return how an object is refused that lacks an entry."""
    return Message("missing entry {name!r}", name=name), Message("add it")


def unknown(name: str, known: Iterable[str]) -> Refusal:
    """Return how an unknown entry is refused, which is mostly a typing error."""
    return (
        Message("unknown entry {name!r}", name=name[:_MAX_SHOWN]),
        Message("allowed: {known}", known=", ".join(known)),
    )


def _reworded(said: str, kind: Any) -> Refusal:
    """Return an error of msgspec in our words, with the allowed values."""
    what, *named = re.split("[`'](.*?)[`']", said, flags=re.DOTALL)
    if what == "Object missing required field ":
        return missing(named[0])
    if what == "Object contains unknown field ":
        return unknown(named[0], get_type_hints(kind))
    if what == "Invalid enum value ":
        is_literal = get_origin(kind) is Literal
        known = sorted(get_args(kind)) if is_literal else list(kind)
        return (
            Message("{value!r} is not allowed", value=named[0][:_MAX_SHOWN]),
            Message("choose one of {known}", known=", ".join(known)),
        )
    for pattern, refusal in _OF_PATTERNS.items():
        if what == "Expected " and repr(pattern) in said:  # as msgspec writes it
            return refusal
    return _expected(named) if what == "Expected " else Message(
        said[:_MAX_SAID]
    ), _CORRECT


def _expected(named: list[str]) -> Message:
    """The expectation: [float, ", got ", str, ""], or [int, " >= 0"]."""
    wanted, more = named[:2]
    if len(named) > 2:
        found = _kinds(named[2])
        return Message(
            "must be {wanted}, not {kind}", kind=found, wanted=_kinds(wanted)
        )
    limited, limit = re.findall(r"(\D+?)(-?\d[\d.e+-]*)", more)[0]
    text = _LIMITS.get(wanted + limited) or _LIMITS[limited]
    return Message(text.template, limit=f"{float(limit):g}")


def _kinds(names: str) -> Message:
    """Return kinds as msgspec names them, such as `str | object`, in words."""
    words = [_KINDS.get(name, Message(name)) for name in names.split(" | ")]
    return words[0] if len(words) == 1 else joined(" / ", words)


def _entry(value: Any, kind: Any, place: str) -> tuple[str, Any]:
    """Return field and type of an entry; msgspec does not name the keys of dicts."""
    field = ""
    for name, number in re.findall(r"\.(\w+)|\[([\d.]+)\]", place):
        kind = meant(kind, value)
        if name:
            kind, value = _hint(kind, name), value[name]
            field = f"{field}.{name}" if field else name
        elif number == "...":
            kind = get_args(kind)[1]
            key, value = next(i for i in value.items() if not _fits(i[1], kind))
            shown = (
                key if re.fullmatch(r"[\w. -]{1,60}", key) else repr(key[:_MAX_SHOWN])
            )
            field = f"{field}.{shown}" if field else shown
        else:
            kinds = get_args(kind)
            is_alike = len(kinds) == 1 or kinds[1] is ...
            kind, value = kinds[0 if is_alike else int(number)], value[int(number)]
            field = f"{field}[{number}]"
    return field, meant(kind, value)


def _hint(kind: Any, name: str) -> Any:
    """The type of an entry, by its name in the file."""
    if issubclass(kind, Struct):
        names = zip(kind.__struct_encode_fields__, kind.__struct_fields__, strict=True)
        name = dict(names)[name]
    return get_type_hints(kind, include_extras=True)[name]


def _fits(value: Any, kind: Any) -> bool:
    try:
        msgspec.convert(value, kind)
    except (InputError, msgspec.ValidationError, OverflowError, UnicodeEncodeError):
        return False
    return True


def meant(kind: Any, value: Any) -> Any:
    """Return the type, of a union the one that a value is to have."""
    if get_origin(kind) is Annotated:
        return meant(get_args(kind)[0], value)
    if get_origin(kind) not in (Union, UnionType):
        return kind
    kinds = [meant(one, value) for one in get_args(kind)]
    return next((one for one in kinds if _is_like(one, value)), kinds[0])


def _is_like(kind: Any, value: Any) -> bool:
    made = get_origin(kind) or kind
    if isinstance(value, dict):
        return made is dict or (isinstance(made, type) and issubclass(made, Struct))
    return isinstance(value, list) and made in (tuple, list)
