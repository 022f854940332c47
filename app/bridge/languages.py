"""The languages of the window, through Qt's translation system."""

import re
from collections.abc import Iterator
from pathlib import Path
from string import Formatter
from typing import Any

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from hapticplayer.errors import Message
from hapticplayer.shipped import shipped

FOLDER = shipped("resources/i18n")
ENGLISH, SYSTEM = "en", "system"
NAMES = {ENGLISH: "English", "de": "Deutsch", "fr": "Fran\u00e7ais"}
"""Each in itself: who looks for a language reads no other."""

_TYPED = re.compile(r"\s\((?:--|`hapticplayer\s)[^()]*\)")
ENGINE = "engine"
"""Context of the engine's sentences among the translations."""

_installed: list[QTranslator] = []
_spoken = [ENGLISH]


def wanted(chosen: str) -> str:
    """Return the language for what a person has chosen; the system's for SYSTEM."""
    if chosen in NAMES:
        return chosen
    ours = (name.split("-")[0] for name in QLocale.system().uiLanguages())
    return next((name for name in ours if name in NAMES), ENGLISH)


def spoken() -> str:
    return _spoken[-1]


def install(application: QCoreApplication, chosen: str) -> str:
    """Install a language, and return it; existing widgets have to be rebuilt."""
    while _installed:
        application.removeTranslator(_installed.pop())
    language = wanted(chosen)
    _spoken[:] = [language]
    QLocale.setDefault(QLocale(language))
    of_qt = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
    for file in (Path(of_qt) / f"qtbase_{language}.qm", FOLDER / f"{language}.qm"):
        translator = QTranslator(application)
        if file.is_file() and translator.load(str(file)):
            application.installTranslator(translator)
            _installed.append(translator)
    return language


def without_options(template: str) -> str:
    """A sentence without what it tells those who type commands: (--offset S)."""
    return _TYPED.sub("", template)


def translated(message: str) -> str:
    """Return a sentence of the engine in the window's language.

    What has no translation stays English; a text that is not a message is looked up whole.
    """
    if not isinstance(message, Message):
        return _looked_up(message)
    text = _looked_up(without_options(message.template))
    values = {
        name: translated(value) if isinstance(value, Message) else value
        for name, value in message.values.items()
    }
    return _Numbers().vformat(text, (), values) if values else text


class _Numbers(Formatter):
    """Writes numbers with the language's decimal sign.

    Names stay as they are, and what is typed so in every language: accel-unit=9.5.
    """

    _is_typed = False

    def parse(
        self, format_string: str
    ) -> Iterator[tuple[str, str | None, str | None, str | None]]:
        for part in super().parse(format_string):
            if part[1] is not None:  # not for what is within a format
                self._is_typed = part[0].endswith("=")
            yield part

    def format_field(self, value: Any, format_spec: str) -> str:
        text = str(super().format_field(value, format_spec))
        if not isinstance(value, float) or self._is_typed:
            return text
        text = text.replace(".", QLocale().decimalPoint())
        return re.sub(r"^-(?=\d)", "\u2212", text)


def _looked_up(text: str) -> str:
    """Return the translation; Qt takes no text with bytes that are not UTF-8."""
    return QCoreApplication.translate(ENGINE, text.encode(errors="replace").decode())
