"""The outputs of a session: chosen before it begins, the first one leads."""

from collections.abc import Iterable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.bridge.languages import translated
from app.bridge.settings import MOST_OUTPUTS
from app.player.device_form import DeviceForm, output_text, problem_of
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, captioned, column_of, row_of
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import message_of

_LEAST_PX = 220


class SessionOutputs(QWidget):
    """Lists the outputs; `chosen` has the engine's names when a person changes them."""

    chosen = Signal(list)

    def __init__(self) -> None:
        super().__init__()
        self.names: list[str] = []
        self.form = DeviceForm(self)
        self.form.fill(NO_DEVICE)
        self.form.kind.setMinimumWidth(_LEAST_PX)
        self.add_button = text_button(
            self.tr("Add"), self.tr("Let the session play on this device")
        )
        self.add_button.clicked.connect(self.add)
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        self.problem.setStyleSheet(f"color: {theme.BAD};")
        self.problem.hide()
        self.rows = QVBoxLayout()
        self.rows.setSpacing(4)
        name, kind = captioned(self.form.kind.accessibleName(), self.form.kind)
        name.hide()  # for screen readers
        form = (name, kind, self.form.caption, self.form.settings)
        chooser = row_of(*form, self.add_button, STRETCH, spacing=8)
        column_of(self.rows, chooser, self.problem, spacing=6, of=self)

    def show_names(self, names: Iterable[str]) -> None:
        """Show what the session plays on."""
        self.names = [name for name in names if name != NO_DEVICE]
        while (item := self.rows.takeAt(0)) is not None:
            if (row := item.widget()) is not None:
                row.hide()
                row.deleteLater()  # it may be one of its buttons that asks for this
        for name in self.names:
            self.rows.addWidget(self._row(name))
        if not self.names:
            none = QLabel(self.tr("No device: participants feel nothing"))
            none.setStyleSheet(f"color: {theme.WARN};")
            self.rows.addWidget(none)
        self.add_button.setEnabled(len(self.names) < MOST_OUTPUTS)

    def _row(self, name: str) -> QWidget:
        row, label = QWidget(), QLabel(output_text(name))
        remove = text_button("\u2715", self.tr("Remove this device"))
        remove.setAccessibleName(
            self.tr("Remove {device}").format(device=output_text(name))
        )
        remove.clicked.connect(lambda: self._use([n for n in self.names if n != name]))
        row_of(label, remove, STRETCH, spacing=8, of=row)
        return row

    def add(self) -> None:
        """Play on the device of the form, too."""
        name = self.form.name
        fault = problem_of(name)
        if fault is not None:
            self._say(translated(message_of(fault)))
        elif name in self.names:
            self._say(self.tr("This device is already in use"))
        else:
            self._use([*self.names, name])

    def _use(self, names: list[str]) -> None:
        self.problem.hide()
        self.show_names(names)
        self.chosen.emit(names)

    def _say(self, text: str) -> None:
        self.problem.setText(text)
        self.problem.show()
