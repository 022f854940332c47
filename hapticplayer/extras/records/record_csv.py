"""Ticks as CSV, formatted column by column: an hour has a hundred million numbers.

Each column becomes a matrix of characters with a row per tick, in which zero means
"nothing here"; side by side and without the zeros they are the text.
"""

from collections.abc import Iterator, Mapping
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message, Progress
from hapticplayer.haptics.record_reader import RecordReader

Characters = NDArray[np.uint8]

CHUNK_TICKS = 1 << 14
TICK_COLUMN = "tick"
_AXES = ("x", "y", "z")
_DECIMALS = {"s": 9, "us": 3, "n": 6, "m": 9, "mps": 6}
_IN_MICROSECONDS = ("lateness_s", "reply_age_s")
_NAMED = {"mode": "modes", "cause": "causes"}
_MAX_SCALED = float(1 << 62)
_ZERO, _MINUS, _POINT = b"0-."


class Column(NamedTuple):
    """One column of the table.

    Attributes:
        name: with the unit.
        field, item: where the values are; item None for a plain field.
        scale: from the unit of the field to that of the column.
        decimals: None where values are whole numbers, -1 for nine digits.
        names: for a field that is stored as a number but has names.
    """

    name: str
    field: str
    item: int | None = None
    scale: float = 1.0
    decimals: int | None = None
    names: Mapping[int, str] | None = None


def write_csv(
    reader: RecordReader, out: BinaryIO, progress: Progress
) -> dict[str, Any]:
    """Write all intact ticks as CSV, and return what a person wants to know of them.

    Args:
        reader: at its beginning.
        out: gets the text.
        progress: called after each chunk.
    """
    columns = columns_of(reader.dtype, reader.header)
    out.write(head_line(columns))
    count = 0
    times_s: list[float] = []
    for first, ticks in _chunks(reader):
        out.write(lines(first, ticks, columns))
        count += len(ticks)
        if "monotonic_s" in (reader.dtype.names or ()):
            ends_s = ticks["monotonic_s"][[0, -1]].tolist()
            times_s = [times_s[0] if times_s else ends_s[0], ends_s[1]]
        progress(reader.done, Message("converting"))
    duration_s = times_s[1] - times_s[0] if times_s else 0.0
    return {
        "ticks": count,
        "lost": reader.lost,
        "is_complete": reader.is_complete,
        "remark": reader.notice,
        "duration_s": round(duration_s, 6) if np.isfinite(duration_s) else None,
        "columns": [TICK_COLUMN, *[column.name for column in columns]],
        "header": {k: v for k, v in reader.header.items() if k != "dtype"},
    }


def is_csv(head: bytes) -> bool:
    """Whether a file begins as one of `write_csv`."""
    return head.startswith(f"{TICK_COLUMN},monotonic_s,media_s,".encode())


def _chunks(reader: RecordReader) -> Iterator[tuple[int, NDArray[Any]]]:
    """Yield (number of the first, ticks in a row) in pieces worth formatting."""
    plain = np.dtype((np.void, reader.dtype.itemsize))  # joins much faster
    held: list[NDArray[Any]] = []
    first = count = 0
    for frame in reader.frames():
        if held and (frame.first != first + count or count >= CHUNK_TICKS):
            yield from _cut(first, np.concatenate(held).view(reader.dtype))
            held, count = [], 0
        if not held:
            first = frame.first
        held.append(frame.ticks.view(plain))
        count += len(frame.ticks)
    if held:
        yield from _cut(first, np.concatenate(held).view(reader.dtype))


def _cut(first: int, ticks: NDArray[Any]) -> Iterator[tuple[int, NDArray[Any]]]:
    for begin in range(0, len(ticks), CHUNK_TICKS):
        yield first + begin, ticks[begin : begin + CHUNK_TICKS]


def columns_of(dtype: np.dtype[Any], header: Mapping[str, Any]) -> list[Column]:
    """Return the columns of a record, but for the number of the tick."""
    columns: list[Column] = []
    for field in dtype.names or ():
        kind = dtype[field]
        if field in _NAMED:
            names = _names(header.get(_NAMED[field]))
            columns.append(Column(field, field, names=names))
        elif kind.shape:
            columns += _vector(field, kind)
        elif field in _IN_MICROSECONDS:
            name = field.removesuffix("_s") + "_us"
            columns.append(Column(name, field, scale=1e6, decimals=_DECIMALS["us"]))
        else:
            columns.append(Column(field, field, decimals=_decimals(field, kind)))
    return columns


def head_line(columns: list[Column]) -> bytes:
    names = [TICK_COLUMN, *[column.name for column in columns]]
    return (",".join(names) + "\n").encode()


def lines(first: int, ticks: NDArray[Any], columns: list[Column]) -> bytes:
    """Return one line for each tick.

    Args:
        first: number of the first of them.
        ticks: structured array with the fields of the columns.
        columns: from `columns_of`.
    """
    count = len(ticks)
    parts = [_fixed(np.arange(first, first + count), 0)]
    comma = np.full((count, 1), ord(","), dtype=np.uint8)
    for column in columns:
        values = ticks[column.field]
        if column.item is not None:
            values = values[:, column.item]
        parts += [comma, _characters(values, column)]
    parts.append(np.full((count, 1), ord("\n"), dtype=np.uint8))
    table = np.concatenate(parts, axis=1)
    text: Characters = table[table != 0]
    return text.tobytes()


def _characters(values: NDArray[Any], column: Column) -> Characters:
    if column.names is not None:
        return _named(values, column.names)
    if column.decimals is None:
        return _fixed(values, 0)
    if column.decimals < 0:
        return _general(values)
    return _fixed(values * np.float64(column.scale), column.decimals)


def _fixed(values: NDArray[Any], decimals: int) -> Characters:
    """Return numbers with so many decimals, rounded half to even."""
    if not decimals:
        scaled = values
    else:
        with np.errstate(over="ignore", invalid="ignore"):
            scaled = np.rint(values * 10.0**decimals)
    odd = _is_odd(scaled)
    if odd.any():
        return _replaced(_fixed(np.where(odd, 0, values), decimals), odd, values)
    whole = scaled.astype(np.int64)
    is_negative = whole < 0
    left = np.abs(whole)
    largest = int(left.max())
    if largest < 1 << 31:
        left = left.astype(np.uint32)  # divides several times faster
    digits = max(len(str(largest)), decimals + 1)
    width = 1 + digits + (1 if decimals else 0)
    table = np.zeros((width, len(values)), dtype=np.uint8)
    row = width - 1
    for place in range(digits):
        if decimals and place == decimals:
            table[row] = _POINT
            row -= 1
        rest = left // left.dtype.type(10)
        digit = (left - rest * left.dtype.type(10)).astype(np.uint8) + np.uint8(_ZERO)
        # zeros in front of the first digit are no part of a number
        table[row] = digit if place <= decimals else np.where(left > 0, digit, 0)
        left = rest
        row -= 1
    table[0] = np.where(is_negative, _MINUS, 0)
    return table.T


def _is_odd(scaled: NDArray[Any]) -> NDArray[np.bool_]:
    """Whether a number is not finite, or too large for whole numbers of 64 bits."""
    if scaled.dtype.kind == "u":
        return np.asarray(scaled >= _MAX_SCALED)
    with np.errstate(invalid="ignore"):
        return np.asarray(~((scaled < _MAX_SCALED) & (scaled > -_MAX_SCALED)))


def _replaced(
    table: Characters, odd: NDArray[np.bool_], values: NDArray[Any]
) -> Characters:
    """Return the table with the rows of odd values written in full instead."""
    texts = _general(values[odd])
    width = max(table.shape[1], texts.shape[1])
    made = np.zeros((len(values), width), dtype=np.uint8)
    made[:, : table.shape[1]] = table
    made[odd] = 0
    made[odd, : texts.shape[1]] = texts
    return made


def _general(values: NDArray[Any]) -> Characters:
    """Return any numbers, with all the digits that they have."""
    if values.dtype.kind in "ui":
        texts = [str(value) for value in values.tolist()]
    else:
        digits = 9 if values.dtype.itemsize == 4 else 17
        texts = [f"{value:.{digits}g}" for value in values.tolist()]
    return _as_characters(np.array(texts, dtype=np.bytes_))


def _named(values: NDArray[Any], names: Mapping[int, str]) -> Characters:
    known, place = np.unique(values, return_inverse=True)
    texts = [names.get(int(value), str(int(value))) for value in known]
    return _as_characters(np.array(texts, dtype=np.bytes_)[place])


def _as_characters(texts: NDArray[np.bytes_]) -> Characters:
    return np.ascontiguousarray(texts).view(np.uint8).reshape(len(texts), -1)


def _vector(field: str, kind: np.dtype[Any]) -> list[Column]:
    """Return the columns of a vector: force_n is force_fx_n, force_fy_n, force_fz_n."""
    items = kind.shape[0]
    stem, _, unit = field.rpartition("_")
    decimals = _decimals(field, kind.base)
    columns = []
    for item in range(items):
        axis = _AXES[item] if items == len(_AXES) else str(item)
        axis = f"f{axis}" if unit == "n" else axis
        name = f"{stem}_{axis}_{unit}" if stem else f"{field}_{axis}"
        columns.append(Column(name, field, item, decimals=decimals))
    return columns


def _decimals(field: str, kind: np.dtype[Any]) -> int | None:
    if kind.kind in "ui":
        return None
    return _DECIMALS.get(field.rpartition("_")[2], -1)


def _names(given: object) -> dict[int, str]:
    """Return the names of numbers from a header; what looks odd has no name."""
    if not isinstance(given, Mapping):
        return {}
    return {
        int(number): name
        for number, name in given.items()
        if isinstance(name, str)
        and name.isascii()
        and name.replace("_", "a").isalnum()
        and len(name) <= 32
        and number.isascii()
        and number.isdecimal()
        and len(number) < 10
    }
