"""How programs and people write numbers, gaps and times in the cells of a table.

Decimal commas, thousands with a separator, quotes, blanks between columns, N/A, clock
times and dates. What can be read in two ways is not a number.
"""

import re
from functools import cache

import numpy as np

SPELLINGS = (
    (",", "."),
    (";", "."),
    (";", ","),
    ("\t", "."),
    ("\t", ","),
    (",", ","),
    ("|", "."),
    (" ", "."),
    (" ", ","),
)
"""Separators and decimal signs; a blank stands for any number of blanks and tabs."""

DAY_S = 86_400.0

_MINUS = "\u2212".encode()
_ARROW = b" -> "
"""Behind the clock times of Arduino's serial monitor."""
_GROUP_MARKS = (b"\xa0", b"\xe2\x80\xaf", b"'")
_GROUPS = re.compile(rb"(?<=\d)(?:\xc2\xa0|\xe2\x80\xaf|\xa0|')(?=\d{3})")
_COMMA_GROUPS = re.compile(rb"(?<=\d),(?=\d{3}(?:,\d{3}){0,4}\.\d)")
_DOT_GROUPS = re.compile(rb"(?<=\d)\.(?=\d{3}(?:\.\d{3}){0,4},\d)")
_DECIMAL_GROUPS = {",": (b".", _DOT_GROUPS), ".": (b",", _COMMA_GROUPS)}
_QUOTED = re.compile(rb'"([^"\n]*)"')
_QUOTED_THOUSANDS = re.compile(rb" *[+-]?[1-9]\d{0,2}(?:,\d{3})+(?:\.\d*)? *")
_BLANKS, _EDGES = re.compile(rb"[ \t]+"), re.compile(rb"(?m)^ | $")
HIDDEN = "\x1f"
"""In place of a separator in a quoted text."""
_WORDS = r"(?:n/?a|#n/?a|null|none|nil|undefined|-+|\?+|\*+)"
_MISSING = re.compile(rf"(?:{_WORDS})?", re.IGNORECASE)
_CLOCK = re.compile(
    r"(?:(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})[T, \x1f]+|\d{1,2}[-/.]\d{1,2}[-/.]\d{2,4}[T, \x1f]+)?"
    r"(?:(\d{1,2}):)?(\d{1,2}):(\d{1,2})(?:([.,])(\d{1,9})|:(\d{3}|\d{6}|\d{9}))?"
    r"(?:[ \x1f]*([ap])\.?m\.?)?[ \x1f]*(?:Z|UTC|GMT|([+-]\d\d):?(\d\d)?)?",
    re.IGNORECASE,
)


def plain(content: bytes, separator: str, decimal: str) -> bytes:
    """Rows of a table with plain numbers: a decimal point, no quotes, no groups."""
    if b'"' in content:
        content = _QUOTED.sub(lambda m: _unquoted(m[1], separator, decimal), content)
        content = content.replace(b'"', b"")
    content = content.replace(_MINUS, b"-").replace(_ARROW, separator.encode())
    if any(mark in content for mark in _GROUP_MARKS):
        content = _GROUPS.sub(b"", content)
    if separator != ",":
        mark, groups = _DECIMAL_GROUPS[decimal]
        if mark in content:
            content = groups.sub(b"", content)
        if decimal == ",":
            content = content.replace(b",", b".")
    if separator == " ":
        content = _EDGES.sub(b"", _BLANKS.sub(b" ", content))
    return content


def _unquoted(cell: bytes, separator: str, decimal: str) -> bytes:
    """The text between quotes, without separators."""
    if separator == "," and decimal == ",":
        return _DOT_GROUPS.sub(b"", cell).replace(b",", b".")
    if separator == "," and _QUOTED_THOUSANDS.fullmatch(cell):
        return cell.replace(b",", b"")
    return cell.replace(separator.encode(), HIDDEN.encode())


@cache
def _gaps(separator: str) -> tuple[tuple[re.Pattern[bytes], bytes], ...]:
    one = re.escape(separator.encode())
    if separator == " ":
        return ((re.compile(rb"(?im)(?<![^\n ])%s(?= |$)" % _WORDS.encode()), b"nan"),)
    return (
        (re.compile(rb"(?im)(^|%s) *%s *(?=%s|$)" % (one, _WORDS.encode(), one)), rb"\1nan"),
        (re.compile(rb"(?m)%s *(?=%s|$)" % (one, one)), separator.encode() + b"nan"),
        (re.compile(rb"(?m)^ *(?=%s)" % one), b"nan"),
    )  # fmt: skip


def with_nan(content: bytes, separator: str) -> bytes:
    """Rows of plain numbers with nan in empty cells, and for words such as N/A."""
    for pattern, number in _gaps(separator):
        content = pattern.sub(number, content)
    return content


def is_missing(cell: str) -> bool:
    """Whether a cell says that there is no number."""
    return _MISSING.fullmatch(cell) is not None


def clock_ns(cell: str) -> int | None:
    """Nanoseconds of a clock time, since midnight or, of a date, since 1970; or None.

    A day before its month or after it is left out: midnight shows in the times.
    """
    found = _CLOCK.fullmatch(cell.strip())
    if found is None:
        return None
    year, month, day, hour, minute, second, _, part, thousands, half, zone, more = (
        found.groups()
    )
    fraction = part or thousands or ""
    if (hour is None and not fraction) or int(minute) > 59 or int(second) > 60:
        return None
    hours = int(hour or 0)
    if half and 1 <= hours <= 12:
        hours = hours % 12 + 12 * (half.lower() == "p")
    days = _days(year, month, day) if year else 0
    if hours > 23 or days is None:
        return None
    zone_min = 0
    if zone and year:
        zone_min = 60 * int(zone) + (-1 if zone[0] == "-" else 1) * int(more or 0)
    whole_s = 86_400 * days + 3600 * hours + 60 * int(minute) + int(second)
    return (whole_s - 60 * zone_min) * 10**9 + int(fraction.ljust(9, "0"))


@cache
def _days(year: str, month: str, day: str) -> int | None:
    try:
        date = np.datetime64(f"{year}-{int(month):02}-{int(day):02}", "D")
    except ValueError:
        return None
    return int(date.astype(np.int64))


def column_names(line: str, separator: str = ",") -> tuple[str, ...]:
    """Return the cells of a header, without quotes and blanks."""
    return tuple(cell.strip().strip('"').strip() for cell in line.split(separator))


def find_separator(line: str) -> str:
    return max((",", ";", "\t", "|"), key=line.count)
