"""Reads tables of numbers: every text log and every force track goes through here.

Whole chunks go through numpy's tokenizer (0.06 us per number); only a chunk that does
not fit, and does not after its cells are spelled plainly, is read line by line. An empty
cell is NaN. A damaged line is skipped and counted; a strict table, whose columns are
named, is rejected at the first one.
"""

import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.source import LogSource
from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_CSV_ROWS, MAX_DAMAGED_SHARE, MAX_LINE_BYTES
from hapticplayer.model.spellings import (
    clock_ns,
    column_names,
    is_missing,
    plain,
    with_nan,
)

TIME = "time_s"
LOG_COLUMNS = (TIME, "ax", "ay", "az", "gx", "gy", "gz")
FIELD_COLUMNS = ("mx", "my", "mz")
CHUNK_BYTES = 1 << 22

_MIN_ROWS = 2
_CLOCK_CELL = "U40"
_MAX_INTEGER = 1 << 62
_SAMPLE_LINES = 60


@dataclass(frozen=True, slots=True)
class Shape:
    """How the rows of a table are written.

    Attributes:
        width: cells of a row.
        separator: between the cells, see `model.spellings`; blanks around them do not count.
        decimal: "." or ",".
        columns: wanted cells, in order; others may hold text.
        integer: cell with integers too long for float64 (time in ns); its first value
            is subtracted exactly.
        is_clock: that cell holds clock times or dates, which become ns.
        skip_lines: of the header.
        marks: text in the lines besides numbers, and its replacement.
        names: of all cells, for a strict table.
    """

    width: int
    columns: tuple[int, ...]
    separator: str = ","
    decimal: str = "."
    integer: int | None = None
    is_clock: bool = False
    skip_lines: int = 0
    marks: tuple[tuple[bytes, bytes], ...] = ()
    names: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Numbers:
    """The rows of a table.

    Attributes:
        values: (rows, columns), NaN in empty cells.
        origin: subtracted from the integer column.
        lines: line numbers of the rows, from 1, a part for each chunk.
        damaged: skipped lines.
    """

    values: Floats
    origin: int
    lines: tuple[Sequence[int], ...]
    damaged: tuple[int, ...] = ()

    @property
    def notes(self) -> tuple[str, ...]:
        """The skipped lines, in words."""
        if not self.damaged:
            return ()
        first = self.damaged[0]
        if len(self.damaged) == 1:
            return (Message("1 damaged line was skipped (line {line})", line=first),)
        count = len(self.damaged)
        return (
            Message(
                "{count} damaged lines were skipped (the first: line {line})",
                count=count,
                line=first,
            ),
        )

    def line(self, row: int) -> int:
        """Return the line number of a row."""
        for part in self.lines:
            if row < len(part):
                return part[row]
            row -= len(part)
        raise IndexError(row)


def read_table(source: LogSource, name: str, shape: Shape) -> Numbers:
    """Return the wanted columns of a member of a recording.

    Args:
        source: of the recording.
        name: of the member.
        shape: of its rows.
    """
    with source.opened(name) as stream:
        return read_numbers(stream, shape, source.where(name))


def read_numbers(stream: BinaryIO, shape: Shape, where: str) -> Numbers:
    """Return the wanted columns of all rows; see `read_table`."""
    parser = _ChunkParser(shape, where)
    parts = [parser.parse(chunk) for chunk in parser.chunks(stream)]
    values = _joined(parts, len(shape.columns))
    damaged = parser.damaged
    if len(values) < _MIN_ROWS or len(damaged) > MAX_DAMAGED_SHARE * len(values):
        if parser.fault:
            raise parser.fault
        more = (
            Message(" and {count} damaged lines", count=len(damaged)) if damaged else ""
        )
        raise InputError(
            "has {rows} rows of {columns} numbers{more}",
            where=where,
            remedy="export the log again or choose another one",
            rows=len(values),
            columns=shape.width,
            more=more,
        )
    return Numbers(values, parser.origin or 0, tuple(parser.lines), tuple(damaged))


def _joined(parts: list[Floats], columns: int) -> Floats:
    """Return all parts in one array; each is freed once copied."""
    values = np.empty((sum(map(len, parts)), columns))
    end = len(values)
    while parts:
        part = parts.pop()
        values[end - len(part) : end] = part
        end -= len(part)
    return values


class _ChunkParser:
    """Parses the chunks of one table and counts its lines."""

    def __init__(self, shape: Shape, where: str) -> None:
        self._shape, self._where = shape, where
        self._line = self._rows = 0
        self.origin: int | None = None
        self.lines: list[Sequence[int]] = []
        self.damaged: list[int] = []
        self.fault: InputError | None = None  # that explains the damaged lines

    def chunks(self, stream: BinaryIO) -> Iterator[bytes]:
        """Yield whole lines, about CHUNK_BYTES at a time, without the header."""
        rest, to_skip = b"", self._shape.skip_lines
        while content := stream.read(CHUNK_BYTES):
            if b"\n" not in content:  # lines may end with CR alone
                content = content.replace(b"\r", b"\n")
            whole, newline, rest = (rest + content).rpartition(b"\n")
            if not newline and len(rest) > MAX_LINE_BYTES:
                raise self._too_long(rest, self._line + 1)
            chunk = whole + newline
            while to_skip and chunk:
                chunk = chunk.partition(b"\n")[2]
                to_skip -= 1
                self._line += 1
            if chunk:
                yield chunk
        if rest and not to_skip:
            yield rest

    def parse(self, chunk: bytes) -> Floats:
        """Return the rows of whole lines."""
        shape = self._shape
        if not chunk.strip():  # split into empty lines it takes 70 s per GB
            self._line += chunk.count(b"\n")
            return np.empty((0, len(shape.columns)))
        chunk = chunk.replace(b"\r", b"").removeprefix(b"\xef\xbb\xbf")
        for mark, number in shape.marks:
            chunk = chunk.replace(mark, number)
        count = chunk.count(b"\n") + (not chunk.endswith(b"\n"))
        values = self._whole(chunk.replace(b'"', b""), count)
        if values is None:
            chunk = plain(chunk, shape.separator, shape.decimal)
            values = self._whole(chunk, count)
        if values is None:
            values = self._whole(with_nan(chunk, shape.separator), count)
        if values is None:
            values = self._line_by_line(chunk)
        self._line += count
        self._rows += len(values)
        if self._rows > MAX_CSV_ROWS:
            raise InputError(
                "has more than {most} rows",
                where=self._where,
                remedy="cut the log into parts",
                most=MAX_CSV_ROWS,
            )
        return values

    def _whole(self, chunk: bytes, count: int) -> Floats | None:
        """Return all rows of a chunk without a damaged line, else None."""
        shape, separator = self._shape, self._shape.separator.encode()
        separators = chunk.count(separator)
        if separators % max(1, shape.width - 1) or not chunk.strip():
            return None
        kinds: list[object] = [np.float64] * len(shape.columns)
        if shape.integer is not None:
            at = shape.columns.index(shape.integer)
            kinds[at] = _CLOCK_CELL if shape.is_clock else np.int64
        table = np.dtype([(f"c{number}", kind) for number, kind in enumerate(kinds)])
        try:
            rows = np.loadtxt(
                io.BytesIO(chunk),
                dtype=table,
                delimiter=shape.separator,
                comments=None,
                usecols=shape.columns,
                ndmin=1,
                encoding="latin-1",  # of units and texts in other columns
            )
        except (ValueError, IndexError, OverflowError, UnicodeDecodeError):
            return None
        # usecols ignores missing and extra cells at the end
        if len(rows) * (shape.width - 1) != separators:
            return None
        values = self._as_floats(rows)
        if values is None:
            return None
        first = self._line + 1
        if len(rows) == count:
            self.lines.append(range(first, first + count))
        else:
            texts = enumerate(io.BytesIO(chunk), start=first)
            self.lines.append([number for number, text in texts if text.strip()])
        return values

    def _as_floats(self, rows: NDArray[np.void]) -> Floats | None:
        """Return the numbers of a chunk; None if a clock time is none."""
        names = rows.dtype.names or ()
        values = np.empty((len(rows), len(names)))
        for number, name in enumerate(names):
            column = rows[name]
            if column.dtype.kind == "U":
                stamps = [clock_ns(cell) for cell in column.tolist()]
                if None in stamps:
                    return None
                column = np.array(stamps, np.int64)
            if column.dtype.kind == "i":
                if self.origin is None:
                    self.origin = int(column[0])
                # wraps around for huge damaged numbers, rejected later
                column = column - np.int64(self.origin)
            values[:, number] = column
        return values

    def _line_by_line(self, chunk: bytes) -> Floats:
        rows: list[list[float]] = []
        lines: list[int] = []
        for number, line in enumerate(io.BytesIO(chunk), start=self._line + 1):
            if not line.strip():
                continue
            row = self._row(line.decode("latin-1"))
            if row is not None:
                rows.append(row)
                lines.append(number)
            elif self._shape.names:
                self._blame(line, number)
            else:
                self.damaged.append(number)
                if self.fault is None:
                    text = line.decode("utf-8", "replace")
                    self.fault = foreign_digits(text, at(self._where, number))
        self.lines.append(lines)
        return np.array(rows).reshape(-1, len(self._shape.columns))

    def _row(self, text: str) -> list[float] | None:
        shape = self._shape
        cells = text.rstrip("\n").split(shape.separator)
        while len(cells) > shape.width and not cells[-1].strip():
            cells.pop()  # separators at the end of the line, as Excel adds them
        if len(cells) != shape.width:
            return None
        numbers = [_number(cells[column].strip()) for column in shape.columns]
        if shape.integer is not None:
            at = shape.columns.index(shape.integer)
            numbers[at] = self._since_origin(cells[shape.integer].strip())
        row = [number for number in numbers if number is not None]
        return row if len(row) == len(numbers) else None

    def _since_origin(self, cell: str) -> float | None:
        stamp = clock_ns(cell) if self._shape.is_clock else None
        try:
            whole = int(cell) if stamp is None else stamp
        except ValueError:
            value = _number(cell)
            if value is None or not math.isfinite(value):
                return value
            whole = int(value)
        if abs(whole) > _MAX_INTEGER:
            return None
        if self.origin is None:
            self.origin = whole
        return float(whole - self.origin)

    def _blame(self, content: bytes, line: int) -> None:
        """Raise the error of a damaged line in a strict table."""
        try:
            text = content.decode().strip()
        except UnicodeDecodeError as error:
            raise not_text(self._where) from error
        if len(text) > MAX_LINE_BYTES:
            raise self._too_long(content, line)
        if "\0" in text:
            raise self._fault("", line, *nul_bytes())
        cells, names = text.split(self._shape.separator), self._shape.names
        while len(cells) > len(names) and not cells[-1].strip():
            cells.pop()
        if len(cells) != len(names):
            what = Message(
                "has {count} columns, the header has {expected}",
                count=len(cells),
                expected=len(names),
            )
            raise self._fault("", line, what, Message("remove or complete the line"))
        for at_cell in sorted(self._shape.columns):
            name, cell = names[at_cell], cells[at_cell]
            if fault := foreign_digits(cell, at(self._where, line, name)):
                raise fault
            if _number(cell.strip()) is None or not cell.isascii():
                what = Message("{text!r} is not a number", text=cell.strip(" ")[:30])
                remedy = Message("remove the line or correct the number")
                raise self._fault(name, line, what, remedy)

    def _too_long(self, content: bytes, line: int) -> InputError:
        if b"\0" in content:
            return self._fault("", line, *nul_bytes())
        return self._fault("", line, _TOO_LONG, Message("choose another log"))

    def _fault(self, column: str, line: int, what: str, remedy: str) -> InputError:
        return InputError(what, where=at(self._where, line, column), remedy=remedy)


def at(file: str, line: int, column: str = "") -> Message:
    """Return the place of an error in a file."""
    place = Message("{file}, line {line}", file=file, line=line)
    return (
        Message("{line}, column {column}", line=place, column=column)
        if column
        else place
    )


_TOO_LONG = Message("is longer than {most} characters", most=MAX_LINE_BYTES)


def not_text(where: str) -> InputError:
    """Return the error for a file that is not text."""
    return InputError(
        "is not a text file in UTF-8",
        where=where,
        remedy="export the log as comma-separated text",
    )


def nul_bytes() -> tuple[Message, Message]:
    """The refusal of a text with NUL bytes."""
    return (
        Message("holds NUL bytes, as a logger leaves that loses its power"),
        Message("copy it again, or remove the bytes"),
    )


def foreign_digits(text: str, where: str) -> InputError | None:
    """Return the error for digits other than 0 to 9 in a text, or None."""
    found = next((one for one in text if one.isdecimal() and not one.isascii()), "")
    if not found:
        return None
    return InputError(
        "has numbers in other digits than 0 to 9 ({found})",
        where=where,
        remedy="export the log with the digits 0 to 9, as programs in English do",
        found=found,
    )


def head_lines(source: LogSource, name: str) -> list[str]:
    """Return the first lines of a member, without one that may be cut."""
    text = source.head(name)
    text = text.replace("\r", "") if "\n" in text else text.replace("\r", "\n")
    lines = text.split("\n")
    return lines[: max(1, len(lines) - 1)]


def first_numbers(source: LogSource, name: str) -> list[list[float]]:
    """Return the rows of numbers at the beginning of a member, or [].

    Empty cells are NaN. The last line is omitted, because it may be cut.
    """
    lines = source.head(name).replace("\r", "\n").split("\n")
    rows = []
    for line in [line for line in lines[:-1] if line.strip()][:_SAMPLE_LINES]:
        try:
            rows.append([float(cell.strip() or "nan") for cell in line.split(",")])
        except ValueError:
            return []
    return rows


def _number(cell: str) -> float | None:
    if is_missing(cell):
        return math.nan
    try:
        return float(cell) if "_" not in cell and cell.isascii() else None
    except ValueError:
        return None


def header_fault(source: LogSource) -> InputError:
    """Return the error for a text that is no log of a known format."""
    name = source.names[0]
    if not source.head(name):
        return not_text(source.where(name))
    line = source.first_line(name)
    what = Message("the header is {header!r}", header=line[:80])
    if all(is_number(cell) for cell in column_names(line)):
        what = Message("there is no header, the file begins with numbers")
    return InputError(
        what,
        where=Message("{file}, line 1", file=source.where(name)),
        remedy=Message(
            "begin the file with {header}",
            header=",".join(LOG_COLUMNS) + "[,mx,my,mz]",
        ),
    )


def is_number(cell: str) -> bool:
    """Whether a cell holds a number."""
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell
