"""Numbers and dates as the window's language writes them."""

import re

from PySide6.QtCore import QCoreApplication, QDateTime, QLocale, Qt

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
