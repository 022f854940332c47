"""Texts that several pages show: a title with what it says, and the steps of long work.

The engine names the steps of its work in English; the window says them in its language.
"""

from PySide6.QtCore import QCoreApplication, QLocale

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
