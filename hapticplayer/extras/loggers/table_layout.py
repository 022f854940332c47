"""The layout of a table of numbers: separator, decimal sign, header, kinds of columns."""

import itertools
import re
from collections import Counter
from typing import NamedTuple

from hapticplayer.capture.csv_table import head_lines, is_number
from hapticplayer.capture.log_tables import (
    BETWEEN_TABLES,
    CLOCK,
    EMPTY,
    NUMBER,
    SKIP,
    TEXT,
    TIME,
    LogTable,
)
from hapticplayer.capture.source import LogSource
from hapticplayer.errors import InputError, Message
from hapticplayer.model.spellings import (
    HIDDEN,
    SPELLINGS,
    clock_ns,
    is_missing,
    plain,
)

_MIN_COLUMNS = 4
_SAMPLE_LINES = 60
_MOST_TABLES = 3
_SHOWN_ROWS = 4
_MOSTLY = 0.9
_LONGEST_HEADER_BYTES = 1 << 20

_UNIT = re.compile(r"[\[(]([^\[\]()]*)[\])]\s*$")
_AXIS = re.compile(r"\[([012])\]|(?:^|[^a-z])([xyz])(?:[^a-z]|$)|([xyz])$")
_OTHER = re.compile(
    r"lin(ear)?_?acc|user|grav|angle|euler|roll|pitch|yaw|quat|att?itude"
)
_OF_SENSORS = {
    "a": re.compile(r"acc|^g_?f|^a_?[xyz]"),
    "g": re.compile(r"gyr|rot|omega|angular|^[gwr]_?[xyz]|^as[xyz]"),
    "m": re.compile(r"mag|^m_?[xyz]|^h[xyz]"),
}
_OF_UNITS = {
    "a": re.compile(r"m?g|m/s.*"),
    "g": re.compile(r"(m?deg|\u00b0|rad)/?s(ec)?|dps"),
    "m": re.compile(r"[\u00b5un\u03bcm]?t|m?gauss|mg"),
}
_OF_TIMES = re.compile(
    r"time|epoc|elapsed|^t$|^cts$|^(milli|micro|nano)?s(ec)?(onds)?$|^[mun]s$"
)


class Layout(NamedTuple):
    """The layout of a table.

    Attributes:
        separator: see `model.spellings`.
        decimal: its sign.
        width: cells of a row.
        kinds: of the columns, without empty ones at the end.
        header: names of the columns, as far as they have some.
        sample: the first row.
        skip_lines: before it.
        sensors: of which each row names one, in a table with three axes for all.
    """

    separator: str
    decimal: str
    width: int
    kinds: tuple[str, ...]
    header: tuple[str, ...]
    sample: tuple[str, ...]
    skip_lines: int
    sensors: tuple[str, ...] = ()

    @property
    def usable(self) -> int:
        """How many columns hold numbers or times."""
        return sum(kind in {NUMBER, CLOCK} for kind in self.kinds)

    def refuse_unnamable(self, where: str) -> None:
        """Raise InputError for a table whose columns no names fit."""
        names, cells = len(self.header), self.sample
        if (
            (self.separator, self.decimal) == (",", ".")
            and 2 <= names < 2 * names - 2 <= len(cells) <= 2 * names
            and not any("." in cell for cell in cells)
        ):
            raise InputError(
                "has decimal commas between commas: {count} cells below {names} names",
                where=where,
                remedy="export it with semicolons, or with decimal points",
                count=len(cells),
                names=names,
            )
        if self.sensors:
            raise InputError(
                "has a row for each reading of one sensor (column {number} holds {names})",
                where=where,
                remedy="write the rows of each sensor to a file of its own and give both",
                number=self.kinds.index(TEXT) + 1,
                names=", ".join(self.sensors)[:80],
            )

    @property
    def shown(self) -> str:
        """The columns, for people."""
        names = "; ".join(self.header)[:120]
        return names or Message("without names")


def layouts_of(source: LogSource) -> dict[str, Layout]:
    """Return the layouts of the tables of a source, {} if it holds anything else."""
    if len(source.names) > _MOST_TABLES:
        return {}
    found = {name: _layout(source, name) for name in source.names}
    held = {name: layout for name, layout in found.items() if layout is not None}
    return held if len(held) == len(found) else {}


def _layout(source: LogSource, name: str) -> Layout | None:
    """Return the layout of a table, or None."""
    if not source.head(name):
        return None
    lines = head_lines(source, name)
    found = _best(lines)
    if found is None and len(lines) > _SAMPLE_LINES:  # its header may be longer
        found = _best(_more_lines(source, name))
    return found


def _more_lines(source: LogSource, name: str) -> list[str]:
    text = source.text(name, _LONGEST_HEADER_BYTES).replace("\r", "")
    return text.split("\n")[:-1]


def tables(source: LogSource) -> tuple[LogTable, ...]:
    """The beginnings of the tables of a source, () if it holds anything else."""
    layouts = layouts_of(source)
    proposed = proposed_names(list(layouts.values())).split(BETWEEN_TABLES)
    names = proposed if any(proposed) else [""] * len(layouts)
    return tuple(
        LogTable(
            name,
            layout.header[: len(layout.kinds)],
            layout.kinds,
            _first_rows(source, name, layout),
            tuple(part.split(",")) if part else (),
        )
        for (name, layout), part in zip(layouts.items(), names, strict=True)
    )


def _first_rows(
    source: LogSource, name: str, layout: Layout
) -> tuple[tuple[str, ...], ...]:
    lines, end = head_lines(source, name), layout.skip_lines + _SHOWN_ROWS
    if len(lines) < end:
        lines = _more_lines(source, name)
    rows = [
        _cells(line, layout.separator, layout.decimal)
        for line in lines[layout.skip_lines : end]
    ]
    return tuple(tuple(row[: len(layout.kinds)]) for row in rows if any(row))


def _best(lines: list[str]) -> Layout | None:
    """Return the layout in which most columns hold numbers or times."""
    fitting = [_fitted(lines, *spelling) for spelling in SPELLINGS]
    found = [layout for layout in fitting if layout is not None]
    return max(found, key=lambda layout: layout.usable, default=None)


def _fitted(lines: list[str], separator: str, decimal: str) -> Layout | None:
    """Return the layout of lines with a separator and a decimal sign, or None."""
    body = _body(lines, separator, decimal)
    if not body:
        return None
    width, kinds = len(body[0]), [_kind(column) for column in zip(*body, strict=True)]
    while kinds and kinds[-1] == EMPTY:
        kinds.pop()
    header: list[str] = []
    for number, line in enumerate(lines):
        row = _cells(line, separator, decimal)
        if len(row) == width and _is_row(row, kinds):
            names = _titles(header, body, kinds)
            kept = tuple(kinds), names, tuple(row)
            sensors = _sensors_of_rows(body, kinds)
            found = Layout(separator, decimal, width, *kept, number, sensors)
            return found if found.usable >= _MIN_COLUMNS else None
        header = row
    return None


def _titles(
    header: list[str], body: list[list[str]], kinds: list[str]
) -> tuple[str, ...]:
    """The names of the columns; R leaves out that of the rows' own names."""
    if len(header) < 2:
        return ()
    if len(header) != len(kinds) - 1:
        return tuple(header)
    firsts = [row[0] for row in body]
    numbers = [int(cell) if cell.isdecimal() else 0 for cell in firsts]
    is_counted = all(after == one + 1 for one, after in itertools.pairwise(numbers))
    return ("", *header) if is_counted or kinds[0] == TEXT else tuple(header)


def _sensors_of_rows(body: list[list[str]], kinds: list[str]) -> tuple[str, ...]:
    """The names of sensors where each row holds the reading of one, or ()."""
    if TEXT not in kinds:
        return ()
    column = [row[kinds.index(TEXT)] for row in body]
    found = set(column)
    letters = {_sensor(name.lower(), "", "") for name in found}
    is_mixed = sum(one != after for one, after in itertools.pairwise(column)) > 1
    return tuple(sorted(found)) if is_mixed and {"a", "g"} <= letters else ()


def _body(lines: list[str], separator: str, decimal: str) -> list[list[str]]:
    """Return the last rows, if nearly all of them are as wide."""
    last = [line for line in lines if line.strip()][-_SAMPLE_LINES:]
    rows = [
        row for row in (_cells(one, separator, decimal) for one in last) if any(row)
    ]
    if not rows:
        return []
    width, count = Counter(map(len, rows)).most_common(1)[0]
    if width < _MIN_COLUMNS or count < max(2, 0.8 * len(rows)):
        return []
    return [row for row in rows if len(row) == width]


def unread_columns(source: LogSource) -> InputError | None:
    """Why a table of another kind is none of numbers, or None for what is no table."""
    name = source.names[0]
    lines = head_lines(source, name)
    bodies = [_body(lines, *spelling) for spelling in SPELLINGS]
    body = max(bodies, key=lambda rows: len(rows[0]) if rows else 0)
    if not body:
        return None
    kinds = [_kind(column) for column in zip(*body, strict=True)]
    texts = [number for number, kind in enumerate(kinds) if kind == TEXT]
    shown = [f"{number + 1} ({body[0][number][:20]!r})" for number in texts[:8]]
    return InputError(
        "is a table with {count} columns of numbers, fewer than time and acceleration "
        "need; these columns hold text: {shown}",
        where=source.where(name),
        remedy="write numbers without units or signs, or choose another log",
        count=sum(kind == NUMBER for kind in kinds),
        shown=", ".join(shown) or Message("none"),
    )


def _cells(line: str, separator: str, decimal: str) -> list[str]:
    """Return the cells of a line, without quotes."""
    if separator != ";":
        line = line.rstrip().removesuffix(";")
    text = plain(line.encode(), separator, decimal).decode("utf-8", "replace")
    return [cell.strip().replace(HIDDEN, separator) for cell in text.split(separator)]


def _kind(column: tuple[str, ...]) -> str:
    """What the cells of a column are."""
    cells = [cell for cell in column if not is_missing(cell)]
    if not cells:
        return EMPTY if not any(column) else NUMBER
    for kind, fits in ((NUMBER, _is_plain_number), (CLOCK, _is_clock)):
        if sum(map(fits, cells)) >= _MOSTLY * len(cells):
            return kind
    return TEXT


def _is_row(row: list[str], kinds: list[str]) -> bool:
    """Whether the cells of a line are of the kinds of the columns."""
    held = 0
    for cell, kind in zip(row, kinds, strict=False):
        fits = _is_plain_number(cell) or (kind == CLOCK and _is_clock(cell))
        if kind in {NUMBER, CLOCK}:
            if not (fits or is_missing(cell)):
                return False
            held += fits
    return held >= min(_MIN_COLUMNS, len(kinds))


def _is_plain_number(cell: str) -> bool:
    return is_number(cell) and cell.isascii()


def _is_clock(cell: str) -> bool:
    return clock_ns(cell) is not None


def proposed_names(layouts: list[Layout]) -> str:
    """The answer that the names in the headers suggest; "" if they do not say."""
    parts = [_proposed(layout) for layout in layouts]
    named = [name for part in parts for name in part if name not in {TIME, SKIP}]
    wanted = {letter + axis for letter in "ag" for axis in "xyz"}
    is_whole = wanted <= set(named) and len(set(named)) == len(named)
    if any(len(layout.header) < len(layout.kinds) for layout in layouts):
        return ""  # the names may be those of other columns
    if not (is_whole and all(TIME in part for part in parts)):
        return ""
    return BETWEEN_TABLES.join(",".join(part) for part in parts)


def _proposed(layout: Layout) -> list[str]:
    """The names of one table's columns."""
    found: list[str] = []
    sensor = ""
    for kind, title in zip(layout.kinds, layout.header, strict=False):
        text = title.strip().lower()
        unit = _UNIT.search(text)
        words = text[: unit.start()].strip() if unit and unit.start() else text
        axis = _AXIS.search(words) or _AXIS.search(text)
        if kind == NUMBER and axis and not _OTHER.search(words):
            sensor = _sensor(words, unit[1].strip() if unit else "", sensor)
            letter = next(one for one in axis.groups() if one)
            found.append(sensor + letter.translate(str.maketrans("012", "xyz")))
        elif TIME not in found and kind in {NUMBER, CLOCK} and _OF_TIMES.search(words):
            found.append(TIME)
        else:
            found.append(SKIP)
    known = {letter + axis for letter in "agm" for axis in "xyz"} | {TIME}
    return [name if name in known else SKIP for name in found]


def _sensor(words: str, unit: str, before: str) -> str:
    """The letter of a column's sensor, which may be that of the column before."""
    for patterns, text in ((_OF_SENSORS, words), (_OF_UNITS, unit)):
        for letter, pattern in patterns.items():
            is_unit = patterns is _OF_UNITS
            if pattern.fullmatch(text) if is_unit else pattern.search(text):
                return letter
    return before
