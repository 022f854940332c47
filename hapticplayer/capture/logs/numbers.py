"""Reads the numbers of a text log fast, and says which lines are damaged.

Whole chunks go through numpy's tokenizer (0.06 us a number); only a chunk that does
not fit is read line by line. An empty cell is NaN; a line that is no row of numbers
is left out and counted.
"""

import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.limits import MAX_CSV_ROWS, MAX_LINE_BYTES
from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats

CHUNK_BYTES = 1 << 22

MAX_DAMAGED = 0.05
"""A log with more damaged lines than this part is not believed."""


@dataclass(frozen=True, slots=True)
class Shape:
    """How the rows of a log are written.

    Attributes:
        width: cells of a row.
        separator: between the cells; blanks around them do not count.
        decimal: "." or ",".
        columns: which cells are wanted, in order.
        integer: which cell holds integers too long for float64 (time in ns); its
            first value is subtracted exactly.
        skip_lines: of the header.
        marks: what stands in a line beside numbers, and what takes its place.
    """

    width: int
    columns: tuple[int, ...]
    separator: str = ","
    decimal: str = "."
    integer: int | None = None
    skip_lines: int = 0
    marks: tuple[tuple[bytes, bytes], ...] = ()


@dataclass(slots=True, eq=False)
class Numbers:
    """The rows of a log.

    Attributes:
        values: (rows, columns), NaN in empty cells.
        origin: what was subtracted from the integer column.
        damaged: lines that were left out.
        first_damaged: which of them was the first, counted from 1.
    """

    values: Floats
    origin: int = 0
    damaged: int = 0
    first_damaged: int = 0

    @property
    def notes(self) -> tuple[str, ...]:
        """What was left out, in words."""
        if not self.damaged:
            return ()
        first = self.first_damaged
        if self.damaged == 1:
            return (f"1 line is damaged and left out (first: line {first})",)
        return (f"{self.damaged} lines are damaged and left out (first: line {first})",)


@dataclass(slots=True)
class _State:
    shape: Shape
    origin: int | None = None
    line: int = 0
    rows: int = 0
    damaged: int = 0
    first_damaged: int = 0


def read_numbers(stream: BinaryIO, shape: Shape, where: str) -> Numbers:
    """Return the wanted columns of all rows.

    Raises:
        InputError: when there are no rows, too many, or too many damaged ones.
    """
    state = _State(shape)
    parts = [_parse(chunk, state, where) for chunk in _chunks(stream, state, where)]
    values = _joined(parts, len(shape.columns))
    if len(values) < 2 or state.damaged > MAX_DAMAGED * len(values):
        damaged = f" and {state.damaged} damaged lines"
        raise InputError(
            f"has {len(values)} rows of {shape.width} numbers"
            + (damaged if state.damaged else ""),
            where=where,
            remedy="export the log again or choose another one",
        )
    return Numbers(values, state.origin or 0, state.damaged, state.first_damaged)


def _joined(parts: list[Floats], columns: int) -> Floats:
    """Return all parts in one array; each is given up as soon as it is copied."""
    values = np.empty((sum(map(len, parts)), columns))
    end = len(values)
    while parts:
        part = parts.pop()
        values[end - len(part) : end] = part
        end -= len(part)
    return values


def _chunks(stream: BinaryIO, state: _State, where: str) -> Iterator[bytes]:
    """Yield whole lines, about CHUNK_BYTES at a time, without the header."""
    rest, to_skip = b"", state.shape.skip_lines
    while content := stream.read(CHUNK_BYTES):
        whole, newline, rest = (rest + content).rpartition(b"\n")
        if not newline and len(rest) > MAX_LINE_BYTES:
            raise InputError(
                f"has a line of more than {MAX_LINE_BYTES} characters",
                where=where,
                remedy="choose another log",
            )
        chunk = whole + newline
        while to_skip and chunk:
            chunk = chunk.partition(b"\n")[2]
            to_skip -= 1
            state.line += 1
        if chunk:
            yield chunk
    if rest and not to_skip:
        yield rest


def _parse(chunk: bytes, state: _State, where: str) -> Floats:
    shape = state.shape
    chunk = chunk.replace(b"\r", b"").removeprefix(b"\xef\xbb\xbf")
    if b'"' in chunk:  # numbers between quotes; a comma in them shows in the width
        chunk = chunk.replace(b'"', b"")
    for mark, number in shape.marks:
        chunk = chunk.replace(mark, number)
    if shape.decimal == ",":
        chunk = chunk.replace(b",", b".")
    lines = chunk.count(b"\n") + (not chunk.endswith(b"\n"))
    values = _parse_whole(chunk, state)
    if values is None:
        values = _parse_lines(chunk, state)
    state.line += lines
    state.rows += len(values)
    if state.rows > MAX_CSV_ROWS:
        raise InputError(
            f"has more than {MAX_CSV_ROWS} rows",
            where=where,
            remedy="cut the log into parts",
        )
    return values


def _parse_whole(chunk: bytes, state: _State) -> Floats | None:
    """Return all rows of a chunk without any fault, or None."""
    shape = state.shape
    if chunk.count(shape.separator.encode()) % max(1, shape.width - 1):
        return None
    if b"_" in chunk or not chunk.strip():
        return None
    kinds: list[object] = [np.float64] * len(shape.columns)
    if shape.integer is not None:
        kinds[shape.columns.index(shape.integer)] = np.int64
    table = np.dtype([(f"c{number}", kind) for number, kind in enumerate(kinds)])
    try:
        rows = np.loadtxt(
            io.BytesIO(chunk),
            dtype=table,
            delimiter=shape.separator,
            comments=None,
            usecols=shape.columns,
            ndmin=1,
            encoding="ascii",
        )
    except (ValueError, IndexError, OverflowError, UnicodeDecodeError):
        return None
    # usecols does not mind cells that are missing or too many at the end
    if len(rows) * (shape.width - 1) != chunk.count(shape.separator.encode()):
        return None
    return _as_floats(rows, state)


def _as_floats(rows: NDArray[np.void], state: _State) -> Floats:
    names = rows.dtype.names or ()
    values = np.empty((len(rows), len(names)))
    for number, name in enumerate(names):
        column = rows[name]
        if column.dtype.kind == "i":
            if state.origin is None:
                state.origin = int(column[0])
            # wraps round where a damaged number is huge; such a time is refused later
            column = column - np.int64(state.origin)
        values[:, number] = column
    return values


def _parse_lines(chunk: bytes, state: _State) -> Floats:
    rows: list[list[float]] = []
    for number, line in enumerate(chunk.split(b"\n"), start=state.line + 1):
        text = line.decode("ascii", "replace").strip()
        if not text:
            continue
        row = _row(text, state)
        if row is not None:
            rows.append(row)
            continue
        state.damaged += 1
        state.first_damaged = state.first_damaged or number
    return np.array(rows).reshape(-1, len(state.shape.columns))


def _row(text: str, state: _State) -> list[float] | None:
    shape = state.shape
    cells = text.split(shape.separator)
    if len(cells) == shape.width + 1 and not cells[-1].strip():
        cells.pop()  # a separator at the end of the line
    if len(cells) != shape.width:
        return None
    numbers = [_number(cells[column].strip()) for column in shape.columns]
    if any(number is None for number in numbers):
        return None
    if shape.integer is not None:
        at = shape.columns.index(shape.integer)
        numbers[at] = _since_origin(cells[shape.integer].strip(), state)
    return [math.nan if number is None else number for number in numbers]


def _number(cell: str) -> float | None:
    if not cell:
        return math.nan
    try:
        return float(cell) if "_" not in cell else None
    except ValueError:
        return None


def _since_origin(cell: str, state: _State) -> float | None:
    try:
        whole = int(cell)
    except ValueError:
        value = _number(cell)
        if value is None or not math.isfinite(value):
            return value
        whole = int(value)
    if state.origin is None:
        state.origin = whole
    return float(whole - state.origin)


def column_names(line: str, separator: str) -> tuple[str, ...]:
    """Return the cells of a header, without quotes and blanks."""
    return tuple(cell.strip().strip('"').strip() for cell in line.split(separator))


def find_separator(line: str, candidates: Sequence[str] = (",", ";", "\t")) -> str:
    """Return the separator that a line has most of."""
    return max(candidates, key=line.count)
