"""Texts, numbers, dates and times as the window's language writes them."""

import math
import re

from PySide6.QtCore import QCoreApplication, QDateTime, QLocale, Qt

from app.bridge.jobs import JobState
from app.bridge.languages import translated

translate = QCoreApplication.translate

PERCENT = "%p\u00a0%"
"""Of progress bars, with the space that all other figures have."""

_FRENCH = QLocale.Language.French


def titled(title: str, text: str) -> str:
    """Return both, with the colon as the language sets it."""
    return translate("Texts", "{title}: {text}").format(title=title, text=text)


def capitalised(text: str) -> str:
    """Return a text as it begins a line."""
    return text[:1].upper() + text[1:]


def quoted(text: str) -> str:
    """Return a text in the language's marks; the French ones with a space."""
    marked = QLocale().quoteString(text)
    is_french = marked.startswith("\u00ab") and QLocale().language() == _FRENCH
    return f"\u00ab\u00a0{text}\u00a0\u00bb" if is_french else marked


def job_text(state: JobState) -> str:
    return titled(state.title, translated(state.step)) if state.step else state.title


_LONG_WORD = re.compile(r"(\S{24})(?=\S)")


def breakable(text: str) -> str:
    """Return a text in which names without a space can be broken between lines."""
    return _LONG_WORD.sub("\\1\u200b", text)


_POINT = re.compile(r"(?<=\d)\.(?=\d)")
_MINUS = re.compile(r"(?<![\w.,:-])-(?=\d)")


def local(text: str) -> str:
    """Return a text with its numbers as people read them: 0.5 or 0,5, and \u22120.5.

    Not for names, nor for what a file or another program reads.
    """
    return _MINUS.sub("\u2212", _POINT.sub(QLocale().decimalPoint(), text))


def date_text(moment_utc: str) -> str:
    """Return the day of a moment in ISO 8601, here; the text itself if it is none."""
    moment = QDateTime.fromString(moment_utc, Qt.DateFormat.ISODate)
    if not moment.isValid():
        return moment_utc[:10]
    #: how a date is written in figures, in Qt's letters
    pattern = QCoreApplication.translate("Numbers", "yyyy-MM-dd")
    return moment.toLocalTime().toString(pattern)


def moment_text(moment_utc: str) -> str:
    """Return the day and the minute of a moment in ISO 8601, here."""
    moment = QDateTime.fromString(moment_utc, Qt.DateFormat.ISODate)
    clock = moment.toLocalTime().toString("HH:mm") if moment.isValid() else ""
    return f"{date_text(moment_utc)} {clock}".strip()


def position_text(media_s: float, duration_s: float) -> str:
    """Return "mm:ss.s / mm:ss.s", with hours when the clip has them."""
    with_hours = duration_s >= 3600.0
    both = (min(media_s, duration_s), duration_s)  # the last frame may end later
    return " / ".join(time_text(value, with_hours=with_hours) for value in both)


def time_text(media_s: float, *, with_hours: bool = False, digits: int = 1) -> str:
    """Return a time, rounded down: the end shows only when it is reached."""
    parts = 10**digits
    count = max(0, math.floor(parts * media_s + 1e-6))
    minutes, count = divmod(count, 60 * parts)
    seconds = f"{count // parts:02}.{count % parts:0{digits}}"
    if not with_hours:
        return local(f"{minutes:02}:{seconds}")
    return local(f"{minutes // 60}:{minutes % 60:02}:{seconds}")
