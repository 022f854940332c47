"""Tables of a log as a person describes them, and descriptions that are kept by name.

The mapper of the window shows them; `--read-as template=NAME` takes a kept one too.
"""

from collections.abc import Mapping
from typing import Annotated, NamedTuple

from msgspec import Meta, Struct

from hapticplayer import storage
from hapticplayer.errors import InputError, Message
from hapticplayer.structures import read_json

NUMBER, CLOCK, TEXT, EMPTY = "number", "clock", "text", "empty"
"""Kinds of columns."""

TIME, SKIP = "time", "-"
SENSORS = {
    "accel": ("ax", "ay", "az"),
    "rate": ("gx", "gy", "gz"),
    "field": ("mx", "my", "mz"),
}
"""Names of the columns of a table, beside `TIME` and `SKIP`."""

BETWEEN_TABLES = "/"
"""In the answer `columns`."""

KEPT = "loggers.json"
"""In the settings folder: answers about logs, by the name that a person gave them."""

_MOST_KEPT, _LONGEST_NAME = 200, 60


class LogTable(NamedTuple):
    """The beginning of a table without a description.

    Attributes:
        name: of its file.
        header: names of the columns, as far as they have some.
        kinds: of the columns.
        rows: the first ones.
        proposed: names of the columns that the header suggests; () if it does not.
    """

    name: str
    header: tuple[str, ...]
    kinds: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    proposed: tuple[str, ...] = ()


class KeptAnswers(Struct, frozen=True):
    """Answers about the logs of one logger, with the headers of its tables."""

    header: tuple[tuple[str, ...], ...]
    answers: dict[str, str]


_Name = Annotated[str, Meta(min_length=1, max_length=_LONGEST_NAME)]


class _Kept(Struct):
    loggers: dict[_Name, KeptAnswers]


def header_of(tables: tuple[LogTable, ...]) -> tuple[tuple[str, ...], ...]:
    """What a log is known by again; () where a table has no names."""
    found = tuple(table.header for table in tables)
    return found if all(found) else ()


def kept_answers() -> dict[str, KeptAnswers]:
    """All that are kept, by name; raises InputError for a damaged file."""
    path = storage.config_home() / KEPT
    if not path.is_file():
        return {}
    remedy = Message("correct the file, or remove it")
    return read_json(path, _Kept, InputError, remedy).loggers


def keep_answers(
    name: str, header: tuple[tuple[str, ...], ...], answers: dict[str, str]
) -> None:
    """Keep answers under a name; those that had it before are replaced."""
    home, name = storage.config_home(), name.strip()[:_LONGEST_NAME]
    storage.make_folder(home)
    with storage.locked(home):
        kept = kept_answers()
        kept.pop(name, None)  # the newest is the last
        newest = list(kept.items())[1 - _MOST_KEPT :]
        loggers = {**dict(newest), name: KeptAnswers(header, answers)}
        written = {
            key: {"header": one.header, "answers": one.answers}
            for key, one in loggers.items()
        }
        storage.replace_json(home / KEPT, {"loggers": written})


def kept_for(
    header: tuple[tuple[str, ...], ...], kept: Mapping[str, KeptAnswers]
) -> str:
    """The name of the newest answers about logs with this header, or ""."""
    names = [name for name, one in kept.items() if header == one.header]
    return names[-1] if header and names else ""
