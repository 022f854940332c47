"""Tables of data as text, for spreadsheets and other programs."""

import csv
import io
import re
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple


class DataColumn(NamedTuple):
    """A column: name, meaning, unit or levels, and the texts of levels."""

    name: str
    meaning: str
    levels: str = ""
    texts: Mapping[str, str] = MappingProxyType({})


class DataTable(NamedTuple):
    """A table: name of the file, columns, rows."""

    name: str
    columns: Sequence[DataColumn]
    rows: Sequence[Sequence[Any]]


_SIGN = "[=+\\-@\uff1d\uff0b\uff0d\uff20]"
_FORMULA = re.compile(f"['\\s\ufeff\u200b-\u200f]*{_SIGN}|[\t\r\n]")
"""Beginnings of a text that spreadsheets take for a formula, also in full width."""

_LATER = re.compile(f'([;\t\n][ \u00a0"]*)(?={_SIGN})')
"""Where a cell begins for those that separate by semicolons or tabs."""

_BREAKS = re.compile("\r\n|[\r\x0b\x0c\x1c-\x1e\x85\u2028\u2029]")
_CONTROLS = re.compile("[\0-\x08\x0e-\x1f\x7f]")
"""At some of them programs take the file to end."""


def guarded(value: Any) -> Any:
    """Return a cell that no spreadsheet takes for a formula.

    Line breaks become the one that `csv` puts into quotation marks, control characters
    the sign for what cannot be shown.
    """
    if not isinstance(value, str):
        return value
    text = _CONTROLS.sub("\ufffd", _BREAKS.sub("\n", value))
    guarded_text = _LATER.sub(r"\1'", text)
    return f"'{guarded_text}" if _FORMULA.match(value) else guarded_text


def separated(table: DataTable, mark: str = ",", missing: str = "") -> bytes:
    """Return a table as text.

    Args:
        table: to be written.
        mark: delimiter.
        missing: text for missing values.
    """
    out = io.StringIO()
    writer = csv.writer(out, delimiter=mark, lineterminator="\n")
    writer.writerow([column.name for column in table.columns])
    writer.writerows([_cell(value, missing) for value in row] for row in table.rows)
    return out.getvalue().encode(errors="replace")


def _cell(value: Any, missing: str) -> Any:
    if value is None or value == "":
        return missing
    return str(value).lower() if isinstance(value, bool) else value
