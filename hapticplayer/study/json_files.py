"""Reads JSON files that people edit; errors name the field."""

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import msgspec
from msgspec import inspect

from hapticplayer.errors import Message, StudyError, joined
from hapticplayer.untrusted import parse_json, read_regular

MAX_BYTES = 4 << 20
MAX_TEXT = 20_000
MAX_ITEMS = 2_000
KEY = "^[a-z0-9_-]{1,40}$"
FILLED = r"\S"

_KINDS = {
    "str": Message("a text"),
    "int": Message("a whole number"),
    "float": Message("a number"),
    "bool": Message("true or false"),
    "array": Message("a list"),
    "object": Message("an object"),
}

GIVE_STUDY = Message("give the folder of a study")
_CORRECT = Message("correct it")

Kind = TypeVar("Kind")


def read_file(path: Path, max_bytes: int = MAX_BYTES) -> bytes:
    """Return the content of a small file.

    Raises:
        StudyError: when it cannot be read.
    """
    return read_regular(path, max_bytes, StudyError, GIVE_STUDY)


def parse(content: bytes, path: str) -> Any:
    """Parse a JSON text; `path` is for messages.

    Raises:
        StudyError: when it is not valid JSON or an object has a duplicate entry.
    """
    if len(content) > MAX_BYTES:
        raise StudyError("is too large", where=path)
    return parse_json(content, path, StudyError, Message("correct that line"))


def convert(value: Any, kind: type[Kind], path: str, *, strict: bool = True) -> Kind:
    """Return a value from JSON as a typed structure.

    Args:
        value: to be checked.
        kind: of the structure.
        path: of the file, for messages.
        strict: do not convert texts to numbers.

    Raises:
        StudyError: names the wrong entry and what is allowed there.
    """
    try:
        return msgspec.convert(value, kind, strict=strict)
    except (msgspec.ValidationError, OverflowError) as problem:
        said, _, place = str(problem).partition(" - at `$")
        field, found = _entry(value, inspect.type_info(kind), place.rstrip("`"))
        _refuse_reworded(path, field, said, found)


def _refuse_reworded(path: str, field: str, said: str, found: Any) -> NoReturn:
    """Reword an error of msgspec, and add the allowed values."""
    what, *named = re.split("[`'](.*?)[`']", said)
    if what == "Object missing required field ":
        refuse_missing(path, field, named[0])
    if what == "Object contains unknown field ":
        refuse_unknown(path, field, named[0], [f.name for f in found.fields])
    if what == "Invalid enum value ":
        known = getattr(found, "values", ()) or [word.value for word in found.cls]
        remedy = Message("choose one of {known}", known=", ".join(known))
        refuse(path, field, Message("{value!r} is not allowed", value=named[0]), remedy)
    if what == "Expected " and ", got" in said:
        is_, wanted = _kinds(named[2]), _kinds(named[0])
        what = Message("must be {wanted}, not {kind}", kind=is_, wanted=wanted)
        refuse(path, field, what)
    if KEY in said:
        remedy = Message("use at most {most} of a-z, 0-9, _ and -", most=40)
        refuse(path, field, Message("is not a valid key"), remedy)
    if FILLED in said:
        refuse(path, field, Message("must have 1 to {most} characters", most=MAX_TEXT))
    if what == "Expected ":  # `int` >= 0, `array` of length >= 1
        kind, limit = _KINDS.get(named[0], named[0]), named[1]
        what = Message("must be {kind} {limit}", kind=kind, limit=limit.strip())
        refuse(path, field, what)
    refuse(path, field, Message(said))


def _kinds(names: str) -> Message:
    """Return kinds as msgspec names them, such as `str | object`, in words."""
    words = [_KINDS.get(name, Message(name)) for name in names.split(" | ")]
    return words[0] if len(words) == 1 else joined(" / ", words)


def refuse(
    path: str, field: str, what: Message, remedy: Message = _CORRECT
) -> NoReturn:
    """Raise StudyError for a place in a file, such as `sequences[2].key`."""
    raise StudyError(what, where=f"{path}, {field}" if field else path, remedy=remedy)


def refuse_missing(path: str, field: str, name: str) -> NoReturn:
    """Refuse an object that lacks an entry."""
    what = Message("missing entry {name!r}", name=name)
    refuse(path, field, what, Message("add it"))


def refuse_unknown(path: str, field: str, name: str, known: Iterable[str]) -> NoReturn:
    """Refuse an unknown entry, which is mostly a typing error."""
    what = Message("unknown entry {name!r}", name=name)
    refuse(path, field, what, Message("allowed: {known}", known=", ".join(known)))


def _entry(value: Any, found: Any, place: str) -> tuple[str, Any]:
    """Return field and type of an entry; msgspec does not name keys of dicts."""
    field = ""
    for name, number in re.findall(r"\.(\w+)|\[([\d.]+)\]", place):
        if isinstance(found, inspect.UnionType):  # optional, or a name or object
            found = _meant(found, value)
        if isinstance(found, inspect.DictType):
            key = next((k for k, v in value.items() if not _is_line(v)), "")
            field, found, value = f"{field}.{key}", found.value_type, value.get(key)
        elif name:
            found = next(f.type for f in found.fields if f.name == name)
            field, value = f"{field}.{name}", value[name]
        else:
            field, value = f"{field}[{number}]", value[int(number)]
            found = found.item_type
    if isinstance(found, inspect.UnionType):
        found = _meant(found, value)
    return field.removeprefix("."), found


def _meant(union: inspect.UnionType, value: Any) -> Any:
    """Return the type of a union that a value is to have."""
    objects = (one for one in union.types if isinstance(one, inspect.StructType))
    return next(objects, union.types[0]) if isinstance(value, dict) else union.types[0]


def _is_line(value: Any) -> bool:
    return isinstance(value, str) and value.strip() != "" and len(value) <= MAX_TEXT
