"""Reads GoPro's metadata format (GPMF): nested key, length, value entries.

Each entry is a four-character key, a type letter, the size of one structure, a
16-bit repeat count (big endian) and the values, padded to four bytes. The reader
keeps what is intact: a length beyond its parent ends that parent, and unknown types are
kept as bytes.

Source: github.com/gopro/gpmf-parser, README ("GPMF-core Structure").
"""

import re
import struct
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from hapticplayer.errors import TelemetryError
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_NESTING

NESTED = "\0"
COMPLEX = "?"

_HEADER = struct.Struct(">4sBBH")
_DTYPES = {
    "b": ">i1",
    "B": ">u1",
    "d": ">f8",
    "f": ">f4",
    "j": ">i8",
    "J": ">u8",
    "l": ">i4",
    "L": ">u4",
    "q": ">i4",
    "Q": ">i8",
    "s": ">i2",
    "S": ">u2",
}
_FIXED_POINT = {"q": 2.0**-16, "Q": 2.0**-32}
_TEXT_BYTES = {"c": 1, "F": 4, "G": 16, "U": 16}
_COMPLEX_PART = re.compile(r"([A-Za-z])(?:\[(\d{1,3})\])?")
_MAX_COMPLEX_FIELDS = 255


class GpmfEntry(NamedTuple):
    """One key with its value.

    Attributes:
        key: four characters.
        kind: type letter; NESTED when the value is a list of entries.
        struct_bytes: size of one structure.
        payload: the value without padding; empty if nested.
        children: entries of a nested value.
        is_cut: the nested value, or one in it, ended within an entry.
    """

    key: str
    kind: str
    struct_bytes: int
    payload: bytes | memoryview
    children: tuple["GpmfEntry", ...] = ()
    is_cut: bool = False

    def find(self, key: str) -> "GpmfEntry | None":
        """Return the last child of this key (metadata may repeat), or None."""
        return next((one for one in reversed(self.children) if one.key == key), None)

    def find_all(self, key: str) -> Iterator["GpmfEntry"]:
        return (entry for entry in self.children if entry.key == key)


def parse(payload: bytes) -> GpmfEntry:
    children, is_cut = _parse_list(memoryview(payload), depth=0)
    return GpmfEntry("", NESTED, 1, b"", children, is_cut)


def _parse_list(content: memoryview, depth: int) -> tuple[tuple[GpmfEntry, ...], bool]:
    """Return the entries in a part of a payload, and whether one was cut."""
    if depth > MAX_NESTING:
        raise TelemetryError(
            "telemetry is nested deeper than {levels} levels, so it is damaged",
            levels=MAX_NESTING,
        )
    entries: list[GpmfEntry] = []
    is_cut, offset, length = False, 0, len(content)
    while offset + _HEADER.size <= length:
        key, kind, struct_bytes, repeat = _HEADER.unpack_from(content, offset)
        if key == b"\0\0\0\0":  # padding up to the end
            return tuple(entries), is_cut
        start = offset + _HEADER.size
        end = start + struct_bytes * repeat
        if end > length or not key.isascii():
            return tuple(entries), True
        value = content[start:end]
        if chr(kind) == NESTED:
            children, is_child_cut = _parse_list(value, depth + 1)
            is_cut = is_cut or is_child_cut
            entry = GpmfEntry(
                key.decode(), NESTED, struct_bytes, b"", children, is_child_cut
            )
        else:
            entry = GpmfEntry(key.decode(), chr(kind), struct_bytes, value)
        entries.append(entry)
        offset = start + ((end - start + 3) & -4)
    return tuple(entries), is_cut or offset < length


def text_of(entry: GpmfEntry | None) -> str:
    """Return a text value without its padding; "" for None."""
    if entry is None:
        return ""
    return bytes(entry.payload).decode("latin-1").strip("\0 \t\r\n")


def numbers_of(entry: GpmfEntry, complex_type: str = "") -> Floats:
    """Return the values as (repeat, elements) float64.

    Types without numbers (text, unknown letters) give shape (repeat, 0).

    Args:
        entry: scalar or complex.
        complex_type: value of the TYPE entry before a complex one, such as "Lf[3]".
    """
    size = entry.struct_bytes
    rows = len(entry.payload) // size if size else 0
    if entry.kind in _DTYPES:
        return _uniform(entry, rows)
    letters = _letters(complex_type) if entry.kind == COMPLEX else ""
    dtype, scales = _structure(letters)
    if not rows or not scales or dtype.itemsize > size:
        return np.zeros((rows, 0))
    padded = _with_size(dtype, size)
    table = np.frombuffer(entry.payload, padded, rows)
    columns = [
        table[name].astype(np.float64) * scale
        for name, scale in zip(dtype.names or (), scales, strict=True)
        if scale
    ]
    return np.stack(columns, axis=1) if columns else np.zeros((rows, 0))


def first_number_of(entry: GpmfEntry | None) -> float:
    """Return the first of the values of one type, NaN if there is none."""
    values = np.zeros(0) if entry is None else numbers_of(entry)
    return float(values.flat[0]) if values.size else float("nan")


def _uniform(entry: GpmfEntry, rows: int) -> Floats:
    """Return values of one type; trailing bytes are ignored."""
    dtype = np.dtype(_DTYPES[entry.kind])
    width, spare = divmod(entry.struct_bytes, dtype.itemsize)
    if not rows or not width:
        return np.zeros((rows, 0))
    if spare:
        dtype = np.dtype([("values", dtype, (width,)), ("spare", f"V{spare}")])
        table = np.frombuffer(entry.payload, dtype, rows)["values"]
    else:
        table = np.frombuffer(entry.payload, dtype, rows * width).reshape(rows, width)
    values = table.astype(np.float64)
    return values * _FIXED_POINT[entry.kind] if entry.kind in _FIXED_POINT else values


def _letters(complex_type: str) -> str:
    """Expand "f[3]" to "fff"."""
    letters = "".join(
        letter * int(count or 1)
        for letter, count in _COMPLEX_PART.findall(complex_type)
    )
    return letters[:_MAX_COMPLEX_FIELDS]


def _structure(letters: str) -> tuple[np.dtype[np.void], list[float]]:
    """Return a big-endian structure and the factor of each field, 0 for text.

    An unknown letter ends the structure, because its size is not known.
    """
    fields: list[tuple[str, str]] = []
    scales: list[float] = []
    for number, letter in enumerate(letters):
        if letter in _DTYPES:
            fields.append((f"f{number}", _DTYPES[letter]))
            scales.append(_FIXED_POINT.get(letter, 1.0))
        elif letter in _TEXT_BYTES:
            fields.append((f"f{number}", f"V{_TEXT_BYTES[letter]}"))
            scales.append(0.0)
        else:
            break
    return np.dtype(fields), scales


def _with_size(dtype: np.dtype[np.void], size_bytes: int) -> np.dtype[np.void]:
    """Return the structure with trailing padding."""
    spare = size_bytes - dtype.itemsize
    if not spare:
        return dtype
    return np.dtype([*dtype.descr, ("spare", f"V{spare}")])
