"""The rows that extras and other packages add to the registries of the core.

An extra is a folder `hapticplayer/extras/NAME` with a light `extension.py`; another
package names such a module in the entry-point group `hapticplayer.extensions`. The
functions of the module are named after kinds of rows, and return them:

    def devices() -> tuple[DeviceEntry, ...]: ...

Windows of extras are found the same way by `app.extension`.
"""

import importlib
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, Protocol, TypeVar

from hapticplayer.errors import Message


class NamedRow(Protocol):
    """A line of a registry."""

    @property
    def name(self) -> str:
        """No other row of its kind has it."""


R = TypeVar("R", bound=NamedRow)
_problems: list[Message] = []


class Extensions:
    """Those of the engine, or of the window.

    Args:
        package: holds a folder for each extra.
        group: of the entry points of other packages.
    """

    def __init__(self, package: str, group: str) -> None:
        self._package, self._group = package, group

    def rows(self, kind: str, of: type[R], own: Iterable[R] = ()) -> Iterator[R]:
        """The rows of a kind: the core's own, of extras, of other packages.

        Other packages, which take 30 ms to find, are asked only by who reads on so
        far. Nobody replaces a row that comes before. An extension that is broken is
        left out, see `take_problems`.
        """
        seen: set[str] = set()
        for row in self._all(kind, of, own):
            if row.name not in seen:
                seen.add(row.name)
                yield row

    def _all(self, kind: str, of: type[R], own: Iterable[R]) -> Iterator[R]:
        yield from own
        for name in _extras(self._package):
            yield from _rows_of(name, kind, of)
        for name in _installed(self._group):
            yield from _rows_of(name, kind, of)


rows = Extensions("hapticplayer.extras", "hapticplayer.extensions").rows


def load(where: str) -> Any:
    """What "module:name" says; its module is imported now."""
    module, _, name = where.partition(":")
    return getattr(importlib.import_module(module), name)


def take_problems() -> list[Message]:
    """What is to be reported of broken extensions, each once."""
    taken = _problems[:]
    _problems.clear()
    return taken


def forget() -> None:
    """Look for extensions again."""
    for kept in (_extras, _installed, _module, _rows_of):
        kept.cache_clear()


@cache
def _extras(package: str) -> tuple[str, ...]:
    folders = importlib.import_module(package).__path__
    found = {
        one.parent.name for at in folders for one in Path(at).glob("*/extension.py")
    }
    return tuple(f"{package}.{name}.extension" for name in sorted(found))


@cache
def _installed(group: str) -> tuple[str, ...]:
    pattern = "*-info/entry_points.txt"
    files = (one for at in sys.path for one in Path(at).glob(pattern))
    if not any(group in one.read_text(errors="replace") for one in files):
        return ()  # as usual; the next line takes 30 ms
    from importlib import metadata

    return tuple(dict.fromkeys(one.value for one in metadata.entry_points(group=group)))


@cache
def _module(name: str) -> ModuleType | None:
    try:
        return importlib.import_module(name)
    except Exception as problem:  # noqa: BLE001 - of any kind: others have written it
        _report(name, problem)
        return None


@cache
def _rows_of(name: str, kind: str, of: type[R]) -> tuple[R, ...]:
    make = getattr(_module(name), kind, None)
    if make is None:
        return ()
    try:
        found = tuple(make())
    except Exception as problem:  # noqa: BLE001 - as above
        _report(name, problem)
        return ()
    wrong = [row for row in found if not isinstance(row, of)]
    if wrong:
        _report(name, f"{kind}() has {wrong[0]!r:.60}, not a {of.__name__}")
    return () if wrong else found


def _report(name: str, problem: Exception | str) -> None:
    _problems.append(
        Message(
            "the extension {name!r} cannot be used: {reason}; update or uninstall it",
            name=name,
            reason=str(problem) or type(problem).__name__,
        )
    )
