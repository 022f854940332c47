"""Reads force tracks as CSV: `time_s,fx_n,fy_n,fz_n` in any order, in frame D and SI.

Each force holds from its time until the next one's. A column `is_estimated` of ones is
added where nothing measured the motion. Separators and numbers may be those of a
spreadsheet, see `model.spellings`; comments and `sep=` may stand before the header.
"""

import io
import math
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_SAMPLES, MAX_SECONDS, refuse_large_force
from hapticplayer.model.spellings import column_names, find_separator, plain
from hapticplayer.untrusted import open_regular

FORCE_COLUMNS = ("time_s", "fx_n", "fy_n", "fz_n")
ESTIMATED_COLUMN = "is_estimated"
CHUNK_BYTES = 1 << 22

# The haptic loop takes a value every millisecond; denser rows cost memory only.
_STEP_S = 1e-4
_MAX_LINE_BYTES = 4096
_MOST_BEFORE = 100
_BEFORE = re.compile(r"#|//|%|sep=", re.IGNORECASE)
"""Lines before the header."""

_REMOVE = Message("remove the line or correct the number")


def read_force_csv(
    path: str | os.PathLike[str], until_s: float = math.inf
) -> ForceTrack:
    """Return the force in a file.

    Args:
        path: of the file.
        until_s: later rows are checked, and only the last one is kept.
    """
    values = np.concatenate(list(rows_of_csv(path, until_s)))
    is_estimated = bool(values[:, len(FORCE_COLUMNS) :].any())
    return ForceTrack(
        time_s=values[:, 0],
        force_n=values[:, 1:4].astype(np.float32),
        reconstruction=Reconstruction.HOLD,
        provenance={"source": Path(path).name, "reader": "force csv"}
        | ({"feedback": "estimated"} if is_estimated else {}),
    )


def rows_of_csv(path: str | os.PathLike[str], until_s: float) -> Iterator[Floats]:
    """Yield time, force and mark of the rows of a file, some at a time."""
    with open_regular(path) as stream:
        yield from _Rows(Path(path), until_s).read(stream)


class _Rows:
    """Checks the rows of a file chunk by chunk, and keeps those that are felt."""

    def __init__(self, path: Path, until_s: float) -> None:
        self._path, self._until_s = path, until_s
        self._names: tuple[str, ...] = ()
        self._columns: tuple[int, ...] = ()
        self._separator, self._decimal = ",", "."
        self._last = np.empty((0, 0))
        self._count = 0

    def read(self, stream: BinaryIO) -> Iterator[Floats]:
        """Yield time, force and mark of the rows that are kept."""
        begin = self._read_header(stream)
        kept_s = math.nan
        for chunk, number in _chunks(stream, begin):
            part = self._kept(*self._parsed(chunk, number))
            if len(part):
                kept_s = part[-1, 0]
                yield part
        if not self._count:
            raise self._fault(
                None, "", Message("has no rows"), Message("export the force again")
            )
        if kept_s != self._last[0, 0]:
            yield self._last

    def _read_header(self, stream: BinaryIO) -> int:
        """Read the names of the columns; the number of the line behind them."""
        number, line, text, bare = 0, b"", "", "#"
        while number < _MOST_BEFORE and (not bare or _BEFORE.match(bare)):
            line, number = stream.readline(_MAX_LINE_BYTES), number + 1
            text = line.removeprefix(b"\xef\xbb\xbf").decode(errors="replace")
            bare = text.strip(" ,;|\t\r\n").removeprefix('"')
            if not line:
                break
        if b"\0" in line or line.startswith((b"\xff\xfe", b"\xfe\xff")):
            remedy = Message("save it as text in UTF-8")
            raise self._fault(None, "", Message("is text in UTF-16"), remedy)
        if "\r" in bare:
            remedy = Message("save it with the line ends of Unix or Windows")
            raise self._fault(None, "", Message("its lines end with CR alone"), remedy)
        self._check_header(text, number)
        return number + 1

    def _check_header(self, text: str, number: int) -> None:
        self._separator = find_separator(text)
        if self._separator not in text:
            self._separator, text = " ", " ".join(text.split())
        names = column_names(text.rstrip(" ,;|\t\r\n").lower(), self._separator)
        known = (*FORCE_COLUMNS, ESTIMATED_COLUMN)
        more = [one for one in names if one not in known]
        if more and {*FORCE_COLUMNS} <= {*names}:
            what = Message("the column {name!r} is not of a force", name=more[0][:30])
            raise self._fault(number, "", what, Message("remove the column"))
        if set(FORCE_COLUMNS) - set(names) or sorted({*names} & {*known}) != sorted(
            names
        ):
            header = f"{','.join(FORCE_COLUMNS)}[,{ESTIMATED_COLUMN}]"
            raise self._fault(
                number,
                "",
                Message("the header is {header!r}", header=text.strip()[:80]),
                Message("begin the file with {header}", header=header),
            )
        self._names = names
        self._columns = tuple(names.index(one) for one in known if one in names)

    def _parsed(self, chunk: bytes, first: int) -> tuple[Floats, list[int] | range]:
        """Return the numbers of whole lines, with the number of each line."""
        separator = self._separator.encode()
        chunk = chunk.replace(b"\r", b"")
        if separator != b"," and b"," in chunk:
            self._decimal = ","
        chunk = plain(chunk, self._separator, self._decimal)
        texts = chunk.split(b"\n") if b"\n\n" in chunk else None
        lines: list[int] | range = range(first, first + chunk.count(b"\n") + 1)
        if texts is None and b"_" not in chunk:
            try:
                values = np.loadtxt(
                    io.BytesIO(chunk),
                    delimiter=self._separator,
                    comments=None,
                    usecols=self._columns,
                    ndmin=2,
                )
            except ValueError:  # found again below, with its line
                pass
            else:
                cells = chunk.count(separator) + len(lines)
                if len(values) == len(lines) and cells == len(lines) * len(self._names):
                    return values, lines
        numbered = [
            (number, text)
            for number, text in zip(lines, texts or chunk.split(b"\n"), strict=True)
            if text.strip()
        ]
        rows = [self._row(text, number) for number, text in numbered]
        values = np.array(rows).reshape(-1, len(self._columns))
        return values, [number for number, _ in numbered]

    def _row(self, line: bytes, number: int) -> list[float]:
        cells = line.decode(errors="replace").split(self._separator)
        while len(cells) > len(self._names) and not cells[-1].strip():
            cells.pop()  # separators at the end of the line, as Excel adds them
        if len(cells) != len(self._names):
            what = Message(
                "has {count} columns, the header has {expected}",
                count=len(cells),
                expected=len(self._names),
            )
            raise self._fault(number, "", what, Message("remove or complete the line"))
        row = []
        for at in self._columns:
            name, cell = self._names[at], cells[at]
            try:
                if not cell.isascii() or "_" in cell:
                    raise ValueError(cell)  # noqa: TRY301 - Python's own digits
                row.append(float(cell))
            except ValueError:
                what = Message("{text!r} is not a number", text=cell.strip()[:30])
                raise self._fault(number, name, what, _REMOVE) from None
        return row

    def _kept(self, values: Floats, lines: list[int] | range) -> Floats:
        """Return the rows before the end; of those in one slot of time the last one."""
        if not len(values):
            return values
        self._count += len(values)
        if self._count > MAX_SAMPLES:
            what = Message("has more than {most} rows", most=MAX_SAMPLES)
            raise self._fault(None, "", what, Message("cut it into parts"))
        self._check_finite(values, lines)
        self._check_order(values[:, 0], lines)
        refuse_large_force(values[:, 1:4], str(self._path))
        with np.errstate(over="ignore"):
            slots = np.floor(values[:, 0] / _STEP_S)
        kept = np.append(slots[1:] > slots[:-1], True) & (values[:, 0] < self._until_s)
        kept[0] |= not len(self._last)
        self._last = values[-1:].copy()
        return values[kept]

    def _check_finite(self, values: Floats, lines: list[int] | range) -> None:
        bad = np.argwhere(~np.isfinite(values))
        if len(bad):
            row, column = (int(place) for place in bad[0])
            number = float(values[row, column])
            what = Message("{text} is not a finite number", text=number)
            name = self._names[self._columns[column]]
            raise self._fault(lines[row], name, what, _REMOVE)
        late = np.flatnonzero(np.abs(values[:, 0]) > MAX_SECONDS)
        if len(late):
            what = Message(
                "{time_s:.3g} s is later than any clip", time_s=values[late[0], 0]
            )
            remedy = Message("give the times in seconds of media time")
            raise self._fault(lines[int(late[0])], "time_s", what, remedy)

    def _check_order(self, time_s: Floats, lines: list[int] | range) -> None:
        last_s = self._last[0, 0] if len(self._last) else -math.inf
        before_s = np.concatenate([[last_s], time_s[:-1]])
        late = np.flatnonzero(time_s <= before_s)
        if not len(late):
            return
        row = int(late[0])
        is_repeated = time_s[row] == before_s[row]
        what = Message(
            "the time {fault} ({time_s} s after {last_s} s)",
            fault=Message("repeats") if is_repeated else Message("decreases"),
            time_s=float(time_s[row]),
            last_s=float(before_s[row]),
        )
        remedy = Message("sort the file by time and remove duplicates")
        raise self._fault(lines[row], "time_s", what, remedy)

    def _fault(
        self, line: int | None, column: str, what: str, remedy: str
    ) -> InputError:
        where: str = str(self._path)
        if line is not None:
            where = Message("{file}, line {line}", file=where, line=line)
        if column:
            where = Message("{line}, column {column}", line=where, column=column)
        return InputError(what, where=where, remedy=remedy)


def _chunks(stream: BinaryIO, number: int) -> Iterator[tuple[bytes, int]]:
    """Yield whole lines after the header, and the number of the first of them."""
    rest = b""
    while content := stream.read(CHUNK_BYTES):
        whole, newline, rest = (rest + content).rpartition(b"\n")
        if newline:
            yield whole, number
            number += whole.count(b"\n") + 1
        elif len(rest) > _MAX_LINE_BYTES:
            rest = rest[:_MAX_LINE_BYTES]  # refused below: no row is so long
            break
    if rest:
        yield rest, number
