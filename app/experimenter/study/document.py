"""The definition of a study that is being edited, changed by the places of its entries."""

import re
from collections.abc import Callable
from typing import Any

from app.widgets.steps import Steps

Place = tuple[str | int, ...]
"""Of an entry, such as ("sequences", 2, "folder")."""
Content = dict[str, Any]

OPEN = "\u2026"  # stands for a text that is still to be written
_PART = re.compile(r"([^.\[\]]+)|\[(\d+)\]")


def place_of(field: str) -> Place:
    """Return the place of a field as messages name it: `sequences[2].folder`."""
    return tuple(name or int(number) for name, number in _PART.findall(field))


def entry_at(content: Any, place: Place) -> Any:
    """Return an entry; None where there is none."""
    for part in place:
        try:
            content = content[part]
        except (LookupError, TypeError):
            return None
    return content


def _changed(content: Any, place: Place, change: Callable[[Any], Any]) -> Any:
    """Return a copy with another entry; the rest is shared.

    None takes it away, and so does nothing left in an object.
    """
    if not place:
        return change(content)
    first, rest = place[0], place[1:]
    copied = list(content) if isinstance(content, list) else dict(content or {})
    before = entry_at(copied, (first,))
    after = _changed(before, rest, change)
    if after in (None, {}) and isinstance(copied, dict):
        copied.pop(first, None)
    else:
        copied[first] = after  # type: ignore[index]
    return copied


def filled(content: Content) -> Content:
    """Return a definition with a sign for every text that is still empty."""
    languages = set(content["languages"])

    def fill(part: Any) -> Any:
        if isinstance(part, list):
            return [fill(one) for one in part]
        if not isinstance(part, dict):
            return part
        if part.keys() and part.keys() <= languages:
            return {one: part.get(one, "").strip() or OPEN for one in languages}
        return {name: fill(one) for name, one in part.items()}

    made: Content = fill(content)
    return made


class StudyDocument(Steps[Content]):
    """The content of `study.json`, with undo."""

    @property
    def languages(self) -> list[str]:
        """Of all texts."""
        return list(self.value["languages"])

    def at(self, place: Place) -> Any:
        """Return an entry; None where there is none."""
        return entry_at(self.value, place)

    def set(self, place: Place, value: Any, text: str) -> None:
        """Change an entry; typing in one field is one step. None takes it away."""
        made = _changed(self.value, place, lambda _before: value)
        self.change(made, text, "/".join(map(str, place)))

    def add(self, place: Place, entries: list[Any], text: str) -> None:
        """Add entries at the end of a list."""
        self.change_list(place, lambda before: [*before, *entries], text)

    def remove(self, place: Place, text: str) -> None:
        """Remove an entry of a list."""
        number = place[-1]
        assert isinstance(number, int)
        self.change_list(
            place[:-1], lambda before: before[:number] + before[number + 1 :], text
        )

    def move(self, place: Place, to: Place, text: str) -> Place:
        """Move an entry to the place of another one of its list, and return that."""

        def moved(before: list[Any]) -> list[Any]:
            made = list(before)
            made.insert(int(to[-1]), made.pop(int(place[-1])))
            return made

        self.change_list(place[:-1], moved, text)
        return to

    def change_list(
        self, place: Place, change: Callable[[list[Any]], list[Any]], text: str
    ) -> None:
        """Put another list in place of one."""
        made = _changed(self.value, place, lambda before: change(list(before or [])))
        self.change(made, text)
