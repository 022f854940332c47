"""Reads untrusted JSON value by value; every refusal names the field it means."""

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, NoReturn, TypeVar

from hapticplayer.errors import StudyError

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

    def refuse(self, what: str, remedy: str = "correct it") -> NoReturn:
        """Raise StudyError for this place."""
        where = f"{self.path}, {self.field}" if self.field else self.path
        raise StudyError(what, where=where, remedy=remedy)

    def mapping(self) -> dict[str, Any]:
        """Return the members of an object."""
        if not isinstance(self.value, dict):
            self.refuse(f"is {_kind(self.value)} instead of an object")
        return self.value

    def only(self, *names: str) -> None:
        """Refuse members that nobody will read: they are mostly misspelt."""
        for name in self.mapping():
            if name not in names:
                self.refuse(
                    f"has the unknown entry {name!r}", f"known are {', '.join(names)}"
                )

    def has(self, name: str) -> bool:
        """Whether there is such a member, and it is not null."""
        return self.mapping().get(name) is not None

    def get(self, name: str) -> "Branch":
        """Return a member that has to be there."""
        members = self.mapping()
        if name not in members:
            self.refuse(f"lacks the entry {name!r}", "add it")
        return self.child(members[name], name)

    def child(self, value: Any, name: str) -> "Branch":
        """Return a member as a branch of its own."""
        return Branch(value, self.path, f"{self.field}.{name}" if self.field else name)

    def each(self, name: str, *, least: int = 0) -> Iterator["Branch"]:
        """Yield the members of a list."""
        found = self.get(name)
        if not isinstance(found.value, list):
            found.refuse(f"is {_kind(found.value)} instead of a list")
        if not least <= len(found.value) <= MAX_ITEMS:
            found.refuse(f"has {len(found.value)} entries; {least} to {MAX_ITEMS} go")
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
            self.refuse(f"is {_kind(value)} instead of a text")
        if not value.strip() or len(value) > MAX_TEXT:
            self.refuse(f"needs 1 to {MAX_TEXT} characters")
        return value

    def key(self) -> str:
        """Return a short name that is safe in files and tables."""
        value = self.text()
        if len(value) > MAX_KEY or not KEY_LETTERS.issuperset(value):
            self.refuse(
                f"{value!r} is no key",
                f"use at most {MAX_KEY} of a-z, 0-9, _ and -",
            )
        return value

    def flag(self) -> bool:
        """Return true or false."""
        if not isinstance(self.value, bool):
            self.refuse(f"is {_kind(self.value)} instead of true or false")
        return self.value

    def number(self, least: float, most: float) -> float:
        """Return a number within bounds."""
        value = self.value
        if isinstance(value, bool) or not isinstance(value, int | float):
            self.refuse(f"is {_kind(value)} instead of a number")
        if not least <= value <= most:  # also NaN, and whole numbers beyond a float
            self.refuse(f"{str(value)[:20]} lies outside {least:g} to {most:g}")
        return float(value)

    def whole(self, least: int, most: int) -> int:
        """Return a whole number within bounds."""
        value = self.number(least, most)
        if not value.is_integer():
            self.refuse(f"{value:g} is no whole number")
        return int(value)

    def one_of(self, allowed: Iterable[str]) -> str:
        """Return one of some words."""
        value, known = self.text(), list(allowed)
        if value not in known:
            self.refuse(f"is {value!r}", f"choose one of {', '.join(known)}")
        return value


def keys_differ(branch: Branch, keys: Iterable[str]) -> None:
    """Refuse two things of one name."""
    seen: set[str] = set()
    for key in keys:
        if key in seen:
            branch.refuse(f"the key {key!r} stands twice", "rename one")
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
            f"is no valid JSON ({problem})", where=path, remedy="correct that line"
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
            f"cannot be read ({problem.strerror})",
            where=str(path),
            remedy="give the folder of a study",
        ) from problem


def _object(pairs: list[tuple[str, Any]]) -> Mapping[str, Any]:
    made = dict(pairs)
    if len(made) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"the entry {twice!r} stands twice in one object")
    return made


def _kind(value: Any) -> str:
    names = {dict: "an object", list: "a list", str: "a text", bool: "true or false"}
    if value is None:
        return "null"
    return names.get(type(value), "a number")
