"""Orders from a CSV file, with a row for each trial.

order,position,sequence,feedback[,delay_s,gain,repeat]
"""

import csv
import io
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated

from msgspec import Meta

from hapticplayer.errors import Message, StudyError
from hapticplayer.structures import convert
from hapticplayer.study.definition import Condition, Definition, read_file, refuse
from hapticplayer.study.orders import first_repeat

COLUMNS = ("order", "position", "sequence", "feedback")
OPTIONAL = ("delay_s", "gain", "repeat")


class OrderRow(Condition, frozen=True, kw_only=True):
    """A trial of an order."""

    order: str
    position: Annotated[int, Meta(ge=0)]


def read_orders(path: Path, definition: Definition) -> list[tuple[Condition, ...]]:
    """Return the orders in a file, each with every condition exactly once."""
    places: dict[str, dict[int, Condition]] = defaultdict(dict)
    lines: dict[str, str] = {}
    known = {condition.key: condition for condition in definition.conditions}
    for where, cells in _rows(path):
        filled = {name: text for name, text in cells.items() if text}
        row = convert(filled, OrderRow, where, StudyError, strict=False)
        if row.key not in known:
            what = Message("condition {key} is not in the study", key=row.key)
            refuse(where, "", what)
        if row.position in places[row.order]:
            what = Message(
                "order {order} has two trials at position {position}",
                order=row.order,
                position=row.position,
            )
            refuse(where, "", what)
        places[row.order][row.position] = known[row.key]
        lines.setdefault(row.order, where)
    return [
        _checked(order, found, definition, lines[order])
        for order, found in places.items()
    ]


def _rows(path: Path) -> Iterator[tuple[str, Mapping[str, str]]]:
    try:
        text = read_file(path).decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise StudyError("is not UTF-8 text", where=str(path)) from problem
    reader = csv.DictReader(io.StringIO(text, newline=""), strict=True)

    def where() -> Message:
        line = max(1, reader.line_num)
        return Message("{file}, line {line}", file=path, line=line)

    try:
        names = set(reader.fieldnames or ())
        if not set(COLUMNS) <= names <= {*COLUMNS, *OPTIONAL}:
            columns = ",".join(COLUMNS)
            what = Message("the columns must be {columns}", columns=columns)
            refuse(where(), "", what)
        for row in reader:
            if None in row or None in row.values():
                refuse(where(), "", Message("has a different number of columns"))
            yield where(), row
    except csv.Error as problem:
        refuse(where(), "", Message(str(problem)))


def _checked(
    order: str, found: Mapping[int, Condition], definition: Definition, where: str
) -> tuple[Condition, ...]:
    made = tuple(found[position] for position in sorted(found))
    if missing := set(definition.conditions) - set(made):
        names = ", ".join(sorted(condition.key for condition in missing))
        what = Message(
            "order {order} lacks {conditions}", order=order, conditions=names
        )
        refuse(where, "", what)
    if len(made) != len(definition.conditions):
        refuse(where, "", Message("order {order} has a condition twice", order=order))
    is_apart = definition.order.no_sequence_twice_in_a_row
    if is_apart and (place := first_repeat(made)) is not None:
        what = Message(
            "order {order} plays {sequence} twice in a row",
            order=order,
            sequence=made[place].sequence,
        )
        refuse(where, "", what)
    return made
