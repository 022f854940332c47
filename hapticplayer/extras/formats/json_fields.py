"""Reads fields of JSON that others wrote: typed, in range, and named when they are not."""

from typing import Any, NamedTuple

from hapticplayer.errors import InputError, Message
from hapticplayer.model.ranges import finite_number
from hapticplayer.untrusted import ANOTHER, PathLike, parse_json, read_regular

MAX_BYTES = 96 << 20
MAX_COMMAS = 3_000_000
MAX_BRACKETS = 1_000_000
"""So many values and lists fit into 400 MB once they are read."""


def read_crowd(path: PathLike) -> Any:
    """Return the value of a JSON file that may hold many numbers."""
    content = read_regular(path, MAX_BYTES)
    crowd = max(content.count(b",") / MAX_COMMAS, content.count(b"{") / MAX_BRACKETS)
    if max(crowd, content.count(b"[") / MAX_BRACKETS) > 1.0:
        raise InputError("holds too many values", where=str(path), remedy=ANOTHER)
    return parse_json(content, str(path), InputError, ANOTHER)


class Fields(NamedTuple):
    """An object of a JSON file, and where it is.

    Attributes:
        values: by name.
        where: file and place, for errors.
    """

    values: dict[str, Any]
    where: str

    @classmethod
    def of(cls, value: Any, where: str) -> "Fields":
        if not isinstance(value, dict):
            raise InputError("is not an object", where=where, remedy=ANOTHER)
        return cls(value, where)

    def number(
        self, name: str, default: float | None = None, most: float = 1e12
    ) -> float:
        """Return a number, of at most this magnitude."""
        value = finite_number(self.values.get(name, default))
        if value is None:
            raise self._wrong(name, Message("a number"))
        if not abs(value) <= most:
            raise self._wrong(
                name, Message("between {least:g} and {most:g}", least=-most, most=most)
            )
        return value

    def text(self, name: str, default: str | None = None) -> str:
        """Return a text."""
        value = self.values.get(name, default)
        if not isinstance(value, str):
            raise self._wrong(name, Message("a text"))
        return value

    def items(self, name: str) -> list[Any]:
        """Return a list; an absent one is empty."""
        value = self.values.get(name, [])
        if not isinstance(value, list):
            raise self._wrong(name, Message("a list"))
        return value

    def objects(self, name: str) -> list["Fields"]:
        """Return the objects of a list; an absent one is empty."""
        return [
            Fields.of(value, f"{self.where}, {name}[{row}]")
            for row, value in enumerate(self.items(name))
        ]

    def _wrong(self, name: str, wanted: Message) -> InputError:
        return InputError(
            "must be {wanted}",
            where=f"{self.where}, {name}",
            remedy=ANOTHER,
            wanted=wanted,
        )
