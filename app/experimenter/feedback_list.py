"""The feedbacks of a study: add one with its parameters, remove one."""

from collections.abc import Iterable, Sequence
from typing import Any

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFormLayout,
    QLineEdit,
    QListWidget,
    QWidget,
)

from app.player.choices import feedback_words
from app.player.condition_form import ConditionForm
from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    column_of,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from hapticplayer.rendering import ChosenFeedback

translate = QCoreApplication.translate

WIDTH_PX, HEIGHT_PX = 560, 360
Entry = str | dict[str, Any]
"""Of a definition: a name, or condition, parameters and key."""


class FeedbackList(QWidget):
    """Lists the feedbacks; `entries` are those of the definition.

    Args:
        entries: of the definition.
        sequences: keys.
    """

    def __init__(self, entries: Iterable[Entry], sequences: Sequence[str]) -> None:
        super().__init__()
        self.entries, self._sequences = list(entries), sequences
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Feedbacks"))
        self.add_button = text_button(
            self.tr("Add\u2026"), self.tr("Choose a condition and its parameters")
        )
        self.add_button.clicked.connect(self._ask)
        self.remove_button = text_button(
            self.tr("Remove"), self.tr("Remove the selected feedback")
        )
        self.remove_button.clicked.connect(self._remove)
        self.list.currentRowChanged.connect(self._enable)
        text = paragraph(
            self.tr(
                "Each sequence is played with each of these. Sessions that have begun "
                "keep theirs."
            )
        )
        column_of(
            text,
            (self.list, 1),
            row_of(self.add_button, self.remove_button, STRETCH),
            margins=(12, 12, 12, 12),
            of=self,
        )
        self._show()

    def add(self, entry: Entry) -> None:
        self.entries.append(entry)
        self._show()
        self.list.setCurrentRow(len(self.entries) - 1)

    def _show(self) -> None:
        self.list.clear()
        self.list.addItems([_words(entry) for entry in self.entries])
        self._enable()

    def _enable(self) -> None:
        is_one = self.list.currentRow() >= 0 and len(self.entries) > 1
        self.remove_button.setEnabled(is_one)

    def _remove(self) -> None:
        row = self.list.currentRow()
        del self.entries[row]
        self._show()
        self.list.setCurrentRow(min(row, len(self.entries) - 1))

    def _ask(self) -> None:
        dialog = FeedbackDialog(self._sequences, self)
        dialog.wanted.connect(self.add)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()


class FeedbackDialog(QDialog):
    """Asks for a condition of a study; `wanted` has its entry."""

    wanted = Signal(object)

    def __init__(self, sequences: Iterable[str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Add a feedback"))
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.form = ConditionForm([], sequences)
        self.key = QLineEdit()
        self.key.setPlaceholderText(self.tr("name of the condition"))
        self.key.setToolTip(self.tr("In data and figures: a to z, 0 to 9, _ and -"))
        named = QWidget()
        QFormLayout(named).addRow(self.tr("Key"), self.key)
        self.add_button = text_button(self.tr("&Add"), "", "primary")
        self.add_button.setDefault(True)
        self.add_button.clicked.connect(self._add)
        cancel = text_button(self.tr("&Cancel"), "")
        cancel.clicked.connect(self.reject)
        buttons = row_of(STRETCH, cancel, self.add_button)
        fill_page(self, self.form, named, STRETCH, buttons)

    def _add(self) -> None:
        chosen, key = self.form.chosen(), self.key.text().strip()
        self.wanted.emit(_entry(chosen, key))
        self.accept()


def _entry(chosen: ChosenFeedback, key: str) -> Entry:
    if not chosen.parameters and key in ("", chosen.name):
        return chosen.name
    entry: dict[str, Any] = {"condition": chosen.name}
    if chosen.parameters:
        entry["parameters"] = dict(chosen.parameters)
    return {**entry, "key": key} if key else entry


def _words(entry: Entry) -> str:
    if isinstance(entry, str):
        return feedback_words(ChosenFeedback(entry, {}))
    words = feedback_words(
        ChosenFeedback(entry["condition"], entry.get("parameters", {}))
    )
    return f"{entry['key']}: {words}" if entry.get("key") else words
