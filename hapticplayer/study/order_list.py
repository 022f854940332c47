"""Orders that were made elsewhere: a CSV with a row for each trial.

order,position,sequence,feedback[,delay_s,gain,repeat]
"""

import csv
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NoReturn

from hapticplayer.errors import Message, StudyError
from hapticplayer.study.definition import Condition, Definition
from hapticplayer.study.json_files import read_file
from hapticplayer.study.orders import first_repeat

ORDERS = "orders.csv"
COLUMNS = ("order", "position", "sequence", "feedback")
OPTIONAL = ("delay_s", "gain", "repeat")


def read_orders(path: Path, definition: Definition) -> list[tuple[Condition, ...]]:
    """Return the orders in a file, each with every condition exactly once.

    Raises:
        StudyError: what is wrong, in which line.
    """
    places: dict[str, dict[int, Condition]] = defaultdict(dict)
    lines: dict[str, int] = {}
    known = {condition.key: condition for condition in definition.conditions}
    for line, row in _rows(path):
        condition = _condition(row, path, line)
        if condition.key not in known:
            _refuse(
                path,
                line,
                Message("the study has no condition {key}", key=condition.key),
            )
        order, position = row["order"], _whole(row["position"], path, line)
        if position in places[order]:
            _refuse(
                path,
                line,
                Message(
                    "order {order} has two trials at position {position}",
                    order=order,
                    position=position,
                ),
            )
        places[order][position] = condition
        lines.setdefault(order, line)
    return [
        _checked(order, found, definition, path, lines[order])
        for order, found in places.items()
    ]


def _rows(path: Path) -> Iterator[tuple[int, Mapping[str, str]]]:
    try:
        text = read_file(path).decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise StudyError("is no UTF-8 text", where=str(path)) from problem
    reader = csv.DictReader(text.splitlines(), strict=True)
    try:
        names = reader.fieldnames or ()
        if not set(COLUMNS) <= set(names) <= {*COLUMNS, *OPTIONAL}:
            _refuse(
                path,
                1,
                Message("the columns have to be {columns}", columns=",".join(COLUMNS)),
            )
        for row in reader:
            if None in row or None in row.values():
                _refuse(path, reader.line_num, Message("has another number of columns"))
            yield reader.line_num, row
    except csv.Error as problem:
        _refuse(path, reader.line_num, str(problem))


def _condition(row: Mapping[str, str], path: Path, line: int) -> Condition:
    try:
        return Condition(
            row["sequence"],
            row["feedback"],
            float(row.get("delay_s") or 0.0),
            float(row.get("gain") or 1.0),
            int(row.get("repeat") or 1),
        )
    except ValueError as problem:
        _refuse(path, line, str(problem))


def _checked(
    order: str,
    found: Mapping[int, Condition],
    definition: Definition,
    path: Path,
    line: int,
) -> tuple[Condition, ...]:
    made = tuple(found[position] for position in sorted(found))
    missing = set(definition.conditions) - set(made)
    if missing:
        names = ", ".join(sorted(condition.key for condition in missing))
        _refuse(
            path,
            line,
            Message("order {order} lacks {conditions}", order=order, conditions=names),
        )
    if len(made) != len(definition.conditions):
        _refuse(path, line, Message("order {order} has a condition twice", order=order))
    if definition.order.no_sequence_twice_in_a_row:
        place = first_repeat(made)
        if place is not None:
            _refuse(
                path,
                line,
                Message(
                    "order {order} plays {sequence} twice in a row",
                    order=order,
                    sequence=made[place].sequence,
                ),
            )
    return made


def _whole(text: str, path: Path, line: int) -> int:
    if not text.strip().isascii() or not text.strip().isdecimal():
        _refuse(
            path, line, Message("the position {text!r} is no whole number", text=text)
        )
    return int(text)


def _refuse(path: Path, line: int, what: str) -> NoReturn:
    raise StudyError(
        what,
        where=Message("{file}, line {line}", file=path, line=line),
        remedy="correct it",
    )
