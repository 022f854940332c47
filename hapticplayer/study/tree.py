"""Reads untrusted JSON value by value; every refusal names the field it means."""

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, NoReturn, TypeVar

from hapticplayer.errors import Message, StudyError

MAX_BYTES = 4 << 20
MAX_TEXT = 20_000
MAX_ITEMS = 2_000
KEY_LETTERS = frozenset("abcdefghijklmnopqrstuvwxyz0123456789_-")
MAX_KEY = 40

Read = TypeVar("Read")


class Branch:
    """A value in a tree, and where it stands.

    Args:
        value: from JSON.
        path: of the file, for messages.
        field: place in the file, such as `sequences[2].key`; empty for the whole.
    """

    def __init__(self, value: Any, path: str, field: str = "") -> None:
        self.value = value
        self.path, self.field = path, field

    def refuse(self, what: str, remedy: str = Message("correct it")) -> NoReturn:
        """Raise StudyError for this place."""
        where = f"{self.path}, {self.field}" if self.field else self.path
        raise StudyError(what, where=where, remedy=remedy)

    def mapping(self) -> dict[str, Any]:
        """Return the members of an object."""
        if not isinstance(self.value, dict):
            self.refuse(
                Message("is {kind} instead of an object", kind=_kind(self.value))
            )
        return self.value

    def only(self, *names: str) -> None:
        """Refuse members that nobody will read: they are mostly misspelt."""
        for name in self.mapping():
            if name not in names:
                self.refuse(
                    Message("has the unknown entry {name!r}", name=name),
                    Message("known are {known}", known=", ".join(names)),
                )

    def has(self, name: str) -> bool:
        """Whether there is such a member, and it is not null."""
        return self.mapping().get(name) is not None

    def get(self, name: str) -> "Branch":
        """Return a member that has to be there."""
        members = self.mapping()
        if name not in members:
            self.refuse(
                Message("lacks the entry {name!r}", name=name), Message("add it")
            )
        return self.child(members[name], name)

    def child(self, value: Any, name: str) -> "Branch":
        """Return a member as a branch of its own."""
        return Branch(value, self.path, f"{self.field}.{name}" if self.field else name)

    def each(self, name: str, *, least: int = 0) -> Iterator["Branch"]:
        """Yield the members of a list."""
        found = self.get(name)
        if not isinstance(found.value, list):
            found.refuse(
                Message("is {kind} instead of a list", kind=_kind(found.value))
            )
        if not least <= len(found.value) <= MAX_ITEMS:
            found.refuse(
                Message(
                    "has {count} entries; {least} to {most} go",
                    count=len(found.value),
                    least=least,
                    most=MAX_ITEMS,
                )
            )
        for number, value in enumerate(found.value):
            yield Branch(value, self.path, f"{found.field}[{number}]")

    def members(self, name: str) -> Iterator[tuple[str, "Branch"]]:
        """Yield the names and members of an object."""
        found = self.get(name)
        for key, value in found.mapping().items():
            yield key, found.child(value, key)

    def text(self) -> str:
        """Return a text that is not empty."""
        value = self.value
        if not isinstance(value, str):
            self.refuse(Message("is {kind} instead of a text", kind=_kind(value)))
        if not value.strip() or len(value) > MAX_TEXT:
            self.refuse(Message("needs 1 to {most} characters", most=MAX_TEXT))
        return value

    def key(self) -> str:
        """Return a short name that is safe in files and tables."""
        value = self.text()
        if len(value) > MAX_KEY or not KEY_LETTERS.issuperset(value):
            self.refuse(
                Message("{value!r} is no key", value=value),
                Message("use at most {most} of a-z, 0-9, _ and -", most=MAX_KEY),
            )
        return value

    def flag(self) -> bool:
        """Return true or false."""
        if not isinstance(self.value, bool):
            self.refuse(
                Message("is {kind} instead of true or false", kind=_kind(self.value))
            )
        return self.value

    def number(self, least: float, most: float) -> float:
        """Return a number within bounds."""
        value = self.value
        if isinstance(value, bool) or not isinstance(value, int | float):
            self.refuse(Message("is {kind} instead of a number", kind=_kind(value)))
        if not least <= value <= most:  # also NaN, and whole numbers beyond a float
            self.refuse(
                Message(
                    "{value} lies outside {least:g} to {most:g}",
                    value=str(value)[:20],
                    least=least,
                    most=most,
                )
            )
        return float(value)

    def whole(self, least: int, most: int) -> int:
        """Return a whole number within bounds."""
        value = self.number(least, most)
        if not value.is_integer():
            self.refuse(Message("{value:g} is no whole number", value=value))
        return int(value)

    def one_of(self, allowed: Iterable[str]) -> str:
        """Return one of some words."""
        value, known = self.text(), list(allowed)
        if value not in known:
            self.refuse(
                Message("is {value!r}", value=value),
                Message("choose one of {known}", known=", ".join(known)),
            )
        return value


def keys_differ(branch: Branch, keys: Iterable[str]) -> None:
    """Refuse two things of one name."""
    seen: set[str] = set()
    for key in keys:
        if key in seen:
            branch.refuse(
                Message("the key {key!r} stands twice", key=key), Message("rename one")
            )
        seen.add(key)


def parse(content: bytes, path: str, read: Callable[[Branch], Read]) -> Read:
    """Return what `read` makes of a JSON text.

    Raises:
        StudyError: where it is no JSON, or what `read` refuses.
    """
    if len(content) > MAX_BYTES:
        raise StudyError("is too large", where=path)
    try:
        value = json.loads(content.decode("utf-8-sig"), object_pairs_hook=_object)
    except (ValueError, RecursionError) as problem:
        raise StudyError(
            "is no valid JSON ({reason})",
            where=path,
            remedy="correct that line",
            reason=problem,
        ) from problem
    return read(Branch(value, path))


def read_file(path: Path, max_bytes: int = MAX_BYTES) -> bytes:
    """Return the content of a small file.

    Raises:
        StudyError: where it cannot be read.
    """
    try:
        if path.stat().st_size > max_bytes:
            raise StudyError("is too large", where=str(path))
        return path.read_bytes()
    except OSError as problem:
        raise StudyError(
            "cannot be read ({reason})",
            where=str(path),
            remedy="give the folder of a study",
            reason=problem,
        ) from problem


def _object(pairs: list[tuple[str, Any]]) -> Mapping[str, Any]:
    made = dict(pairs)
    if len(made) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(
            Message("the entry {twice!r} stands twice in one object", twice=twice)
        )
    return made


def _kind(value: Any) -> str:
    names = {
        dict: Message("an object"),
        list: Message("a list"),
        str: Message("a text"),
        bool: Message("true or false"),
    }
    if value is None:
        return "null"
    return names.get(type(value), Message("a number"))
