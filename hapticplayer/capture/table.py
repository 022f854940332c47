"""Reads strict tables of numbers: a header that must fit, then numbers only.

A good file is read by numpy in one pass. Only when that fails a slow second pass
looks for the first line at fault, so that the message can name it. A layout may allow
holes (empty cells, NaN, times in disorder), which its reader then has to repair.
"""

import contextlib
import functools
import math
import os
import re
import warnings
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import numpy as np

from hapticplayer.capture.limits import MAX_CSV_BYTES, MAX_CSV_ROWS, MAX_LINE_BYTES
from hapticplayer.errors import InputError
from hapticplayer.media.files import resolve_regular
from hapticplayer.model.arrays import Floats

TIME = "time_s"

_HOLE = re.compile(r"(^|,)\s*(?=,|$)")


@dataclass(frozen=True, slots=True)
class Layout:
    """What a table must look like.

    Attributes:
        required: names of the columns, in order; the first is TIME.
        optional: names that may follow, all or none of them.
        least_rows: how many rows make sense.
        has_holes: whether cells may be empty or not finite, and times in disorder.
    """

    required: tuple[str, ...]
    optional: tuple[str, ...] = ()
    least_rows: int = 1
    has_holes: bool = False

    @property
    def header(self) -> str:
        """The header line, optional columns in brackets."""
        extra = "".join(f",{name}" for name in self.optional)
        return ",".join(self.required) + (f"[{extra}]" if extra else "")


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """Numbers that fit their layout.

    Attributes:
        path: absolute.
        columns: names in order.
        values: (rows, columns) finite, the first column increases strictly; or with
            NaN and in any order, where the layout allows holes.
    """

    path: Path
    columns: tuple[str, ...]
    values: Floats


def read_table(path: str | os.PathLike[str], layout: Layout) -> Table:
    """Read a comma-separated file; about 1 s per million numbers.

    Spaces, quotes, a byte-order mark, CRLF and empty lines are accepted.

    Raises:
        InputError: naming file, line, column and what to do.
    """
    file = resolve_regular(path, InputError)
    if file.stat().st_size > MAX_CSV_BYTES:
        raise InputError(
            f"has {file.stat().st_size >> 20} MB, the limit is {MAX_CSV_BYTES >> 20} MB",
            where=str(file),
            remedy="cut the log into parts",
        )
    with _text_errors(file), file.open(encoding="utf-8-sig") as lines:
        columns = _read_header(lines, layout, file)
        values = _parse(_short_lines(lines), len(columns))
        if values is None and layout.has_holes:
            _rewind(lines)
            values = _parse(_without_holes(lines), len(columns))
    if values is None or not _is_good(values, layout):
        values = _parse_or_blame(file, columns, layout)
    return Table(file, columns, values)


def find_lines(path: Path, rows: Iterable[int]) -> dict[int, int]:
    """Return in which lines, counted from 1, rows of a table stand, from 0."""
    wanted, row, found = set(rows), -1, {}
    with path.open(encoding="utf-8-sig") as lines:
        _rewind(lines)
        for number, line in enumerate(_short_lines(lines), start=2):
            row += bool(line.strip())
            if row in wanted:
                found[row] = number
                wanted.remove(row)
            if not wanted:
                break
    return found


def _rewind(lines: IO[str]) -> None:
    """Go to the line behind the header."""
    lines.seek(0)
    lines.readline()


@contextlib.contextmanager
def _text_errors(file: Path) -> Iterator[None]:
    try:
        yield
    except UnicodeDecodeError as error:
        raise InputError(
            "is not a text file in UTF-8",
            where=str(file),
            remedy="export the log as comma-separated text",
        ) from error


def _read_header(lines: IO[str], layout: Layout, file: Path) -> tuple[str, ...]:
    line = lines.readline(MAX_LINE_BYTES)
    names = tuple(name.strip(' \t"') for name in line.strip().split(","))
    if names in {layout.required, layout.required + layout.optional}:
        return names
    raise InputError(
        _what_is_wrong(line, names, layout),
        where=f"{file}, line 1",
        remedy=f"begin the file with {layout.header}",
    )


def _short_lines(lines: IO[str]) -> Iterator[str]:
    """Yield lines; one that never ends is cut instead of filling the memory."""
    return iter(functools.partial(lines.readline, MAX_LINE_BYTES + 1), "")


def _without_holes(lines: IO[str]) -> Iterator[str]:
    """Yield lines with NaN in empty cells."""
    for line in _short_lines(lines):
        if content := line.replace('"', "").strip():
            yield _HOLE.sub(r"\1nan", content)


def _what_is_wrong(line: str, names: tuple[str, ...], layout: Layout) -> str:
    if not line.isprintable() and "\0" in line:
        return "is not text"
    for separator, name in ((";", "semicolons"), ("\t", "tabs")):
        if line.count(separator) >= len(layout.required) - 1:
            return f"the columns are separated by {name} instead of commas"
    if all(_is_number(name) for name in names):
        return "there is no header, the file begins with numbers"
    if sorted(names) in map(
        sorted, (layout.required, layout.required + layout.optional)
    ):
        return "the columns are in another order"
    return f"the header is {line.strip()[:80]!r}"


def _parse(lines: Iterable[str], width: int) -> Floats | None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # a table without rows
        try:
            values = np.loadtxt(
                lines,
                delimiter=",",
                comments=None,
                ndmin=2,
                max_rows=MAX_CSV_ROWS + 1,
                quotechar='"',
            )
        except (ValueError, IndexError):
            return None
    if not values.size:
        return np.zeros((0, width))
    return values if values.shape[1] == width else None


def _is_good(values: Floats, layout: Layout) -> bool:
    if not layout.least_rows <= len(values) <= MAX_CSV_ROWS:
        return False
    return layout.has_holes or bool(
        np.isfinite(values).all() and (np.diff(values[:, 0]) > 0.0).all()
    )


def _parse_or_blame(file: Path, columns: Sequence[str], layout: Layout) -> Floats:
    """Find the first line at fault and raise; blank lines are none."""
    rows, last_s = 0, -math.inf
    with _text_errors(file), file.open(encoding="utf-8-sig") as lines:
        for number, line in enumerate(_short_lines(lines), start=1):
            if number == 1 or not line.strip():
                continue
            where = f"{file}, line {number}"
            time_s = _check_line(line, columns, where, has_holes=layout.has_holes)
            if not layout.has_holes:
                _check_order(time_s, last_s, where)
            rows, last_s = rows + 1, time_s
        if layout.least_rows <= rows <= MAX_CSV_ROWS:
            _rewind(lines)
            values = _parse(filter(str.strip, _short_lines(lines)), len(columns))
            if values is not None and _is_good(values, layout):
                return values
    raise InputError(
        f"has {rows} rows, expected {layout.least_rows} to {MAX_CSV_ROWS}",
        where=str(file),
        remedy="choose another log",
    )


def _check_line(
    line: str, columns: Sequence[str], where: str, *, has_holes: bool
) -> float:
    if len(line) > MAX_LINE_BYTES:
        raise InputError(
            f"is longer than {MAX_LINE_BYTES} characters",
            where=where,
            remedy="choose another log",
        )
    cells = line.replace('"', "").strip().split(",")
    if len(cells) != len(columns):
        raise InputError(
            f"has {len(cells)} columns, the header has {len(columns)}",
            where=where,
            remedy="remove or complete the line",
        )
    if has_holes:
        cells = [cell if cell.strip() else "nan" for cell in cells]
    for name, cell in zip(columns, cells, strict=True):
        if not _is_number(cell) or not (has_holes or math.isfinite(float(cell))):
            kind = "number" if has_holes else "finite number"
            raise InputError(
                f"{cell.strip()[:30]!r} is not a {kind}",
                where=f"{where}, column {name}",
                remedy="remove the line or correct the number",
            )
    return float(cells[0])


def _check_order(time_s: float, last_s: float, where: str) -> None:
    if time_s <= last_s:
        fault = "repeats" if time_s == last_s else "runs backwards"
        raise InputError(
            f"the time {fault} ({time_s} s after {last_s} s)",
            where=f"{where}, column {TIME}",
            remedy="sort the log by time and remove duplicates",
        )


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell
