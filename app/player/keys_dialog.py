"""The keys of the window: what they do, and other keys for it."""

from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QKeySequenceEdit,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.bridge.settings import Settings
from app.player.command import KEYS, Command, owner_of
from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.tables import plain_table

_WIDTH_PX, _HEIGHT_PX = 520, 560
_FIELD_MARGIN_PX = 36


class KeysDialog(QDialog):
    """Lists every command with its keys; a key that is pressed below is given to it."""

    changed = Signal()

    def __init__(
        self,
        commands: tuple[Command[Any], ...],
        settings: Settings,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._commands = commands
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._settings = settings
        self.table = self._make_table()
        self.key = QKeySequenceEdit()
        self.key.setMaximumSequenceLength(1)
        self.key.setAccessibleName(self.tr("New shortcut"))
        self.key.setToolTip(self.tr("Press the new shortcut for the selected command"))
        for inner in self.key.findChildren(QLineEdit):
            inner.setAccessibleName(self.key.accessibleName())
            text = inner.placeholderText()
            wide = inner.fontMetrics().horizontalAdvance(text) + _FIELD_MARGIN_PX
            self.key.setMinimumWidth(wide)
        self.assign = text_button(
            self.tr("Assign"), self.tr("Assign this shortcut to the selected command")
        )
        self.reset = text_button(
            self.tr("Reset"),
            self.tr("Restore the default shortcut of the selected command"),
        )
        self.reset_all = text_button(
            self.tr("Reset all"), self.tr("Restore default shortcuts")
        )
        self.close_button = text_button(self.tr("Close"), "")
        self.note = paragraph()
        self._lay_out()
        self.assign.clicked.connect(self._on_assign)
        self.reset.clicked.connect(self._on_reset)
        self.reset_all.clicked.connect(self._on_reset_all)
        self.close_button.clicked.connect(self.accept)
        self.table.itemSelectionChanged.connect(self._on_chosen)
        self.refresh()
        self.table.selectRow(0)
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)

    def _make_table(self) -> QTableWidget:
        table = plain_table(
            self.tr("Commands and their shortcuts"),
            [self.tr("Command"), self.tr("Shortcut")],
            stretched=0,
            is_chosen_from=True,
            has_grid=False,
        )
        table.setRowCount(len(self._commands))
        return table

    def _lay_out(self) -> None:
        fill_page(
            self,
            (self.table, 1),
            row_of((self.key, 1), self.assign, self.reset),
            self.note,
            row_of(self.reset_all, STRETCH, self.close_button),
            spacing=10,
        )

    def refresh(self) -> None:
        """Show the keys as they are."""
        chosen = self._settings.table(KEYS)
        for row, command in enumerate(self._commands):
            self.table.setItem(row, 0, QTableWidgetItem(command.plain_title))
            keys = ", ".join(key_text(key) for key in command.keys_in(chosen))
            self.table.setItem(row, 1, QTableWidgetItem(keys))

    def choose(self, name: str) -> None:
        self.table.selectRow([command.name for command in self._commands].index(name))

    def _chosen(self) -> Command[Any]:
        return self._commands[max(0, self.table.currentRow())]

    def _on_chosen(self) -> None:
        is_free = not self._chosen().is_fixed
        for widget in (self.key, self.assign, self.reset):
            widget.setEnabled(is_free)
        self.note.setText(
            ""
            if is_free
            else self.tr("This shortcut always stops the force and cannot be changed")
        )

    def _on_assign(self) -> None:
        key, command = self.key.keySequence(), self._chosen()
        chosen = self._settings.table(KEYS)
        if key.isEmpty():
            self.note.setText(self.tr("Press a shortcut in the field first"))
            return
        if self._is_free(key, command, chosen):
            self._keep({**chosen, command.name: [key.toString()]})

    def _on_reset(self) -> None:
        command, chosen = self._chosen(), self._settings.table(KEYS)
        chosen.pop(command.name, None)
        if all(self._is_free(key, command, chosen) for key in command.keys_in(chosen)):
            self._keep(chosen)

    def _is_free(
        self, key: QKeySequence, command: Command[Any], chosen: dict[str, object]
    ) -> bool:
        """Whether a command may have a key; else say which one has it."""
        owner = owner_of(key, command, self._commands, chosen)
        if owner is not None:
            text = self.tr("{key} is already used by \u201c{command}\u201d")
            self.note.setText(text.format(key=key_text(key), command=owner.plain_title))
        return owner is None

    def _on_reset_all(self) -> None:
        self._keep({})

    def _keep(self, chosen: dict[str, object]) -> None:
        self._settings.keep(KEYS, chosen)
        self._settings.save()
        self.key.clear()
        self.note.clear()
        self.refresh()
        self.changed.emit()


def key_text(key: QKeySequence) -> str:
    """Return a key as people of this platform and language write it."""
    return key.toString(QKeySequence.SequenceFormat.NativeText)
