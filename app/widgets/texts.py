"""Texts, numbers, dates and times as the window's language writes them."""

import math
import re

from PySide6.QtCore import QCoreApplication, QDateTime, QLocale, Qt

from app.bridge.jobs import JobState

translate = QCoreApplication.translate

PERCENT = "%p\u00a0%"
"""Of progress bars, with the space that all other figures have."""

_FRENCH = QLocale.Language.French


def titled(title: str, text: str) -> str:
    """Return both, with the colon as the language sets it."""
    return translate("Texts", "{title}: {text}").format(title=title, text=text)


def quoted(text: str) -> str:
    """Return a text in the language's marks; the French ones stand off."""
    marked = QLocale().quoteString(text)
    is_french = marked.startswith("\u00ab") and QLocale().language() == _FRENCH
    return f"\u00ab\u00a0{text}\u00a0\u00bb" if is_french else marked


def job_text(state: JobState) -> str:
    """Return what runs and which step it is at."""
    return titled(state.title, step_text(state.step)) if state.step else state.title


def step_text(step: str) -> str:
    """Return a step in the window's language; a name behind it stays as it is."""
    words = _steps()
    for begin in sorted(words, key=len, reverse=True):
        if step == begin or step.startswith(f"{begin} "):
            return words[begin] + step[len(begin) :]
    return step


def _steps() -> dict[str, str]:
    return {
        "riding": translate("Texts", "riding"),
        "drawing the ride": translate("Texts", "drawing the ride"),
        "adding telemetry": translate("Texts", "adding telemetry"),
        "writing the logs": translate("Texts", "writing the logs"),
        "listening": translate("Texts", "listening"),
        "reading": translate("Texts", "reading"),
        "synchronising": translate("Texts", "synchronising"),
        "removing gravity": translate("Texts", "removing gravity"),
        "predicting excursions": translate("Texts", "predicting excursions"),
        "rendering the force": translate("Texts", "rendering the force"),
        "copying the clip": translate("Texts", "copying the clip"),
        "computing checksums": translate("Texts", "computing checksums"),
        "reading the answers": translate("Texts", "reading the answers"),
        "analysing": translate("Texts", "analysing"),
        "drawing": translate("Texts", "drawing"),
        "writing": translate("Texts", "writing"),
        "writing the numbers": translate("Texts", "writing the numbers"),
        "done": translate("Texts", "done"),
    }


_POINT = re.compile(r"(?<=\d)\.(?=\d)")


def local(text: str) -> str:
    """Return a text with its decimal points as the language has them: 0.5 or 0,5.

    Not for times of a clip, which are written alike everywhere, nor for names.
    """
    return _POINT.sub(QLocale().decimalPoint(), text)


def date_text(moment_utc: str) -> str:
    """Return the day of a moment in ISO 8601, here; the text itself if it is none."""
    moment = QDateTime.fromString(moment_utc, Qt.DateFormat.ISODate)
    if not moment.isValid():
        return moment_utc[:10]
    #: how a date is written in figures, in Qt's letters
    pattern = QCoreApplication.translate("Numbers", "yyyy-MM-dd")
    return moment.toLocalTime().toString(pattern)


def position_text(media_s: float, duration_s: float) -> str:
    """Return "mm:ss.s / mm:ss.s", with hours when the clip has them."""
    with_hours = duration_s >= 3600.0
    both = (media_s, duration_s)
    return " / ".join(time_text(value, with_hours=with_hours) for value in both)


def time_text(media_s: float, *, with_hours: bool = False, digits: int = 1) -> str:
    """Return a time, rounded down: the end shows only when it is reached."""
    parts = 10**digits
    count = max(0, math.floor(parts * media_s + 1e-6))
    minutes, count = divmod(count, 60 * parts)
    seconds = f"{count // parts:02}.{count % parts:0{digits}}"
    if not with_hours:
        return f"{minutes:02}:{seconds}"
    return f"{minutes // 60}:{minutes % 60:02}:{seconds}"
