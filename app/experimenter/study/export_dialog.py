"""In which format the data of a study are exported, and where."""

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QDialog, QFormLayout, QLineEdit, QWidget

from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    STRETCH,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from hapticplayer.study.study_export import study_exporters

_SIZE_PX = (600, 260)


class ExportDialog(QDialog):
    """Asks for format and place; `wanted` has the format's name and a new folder.

    Args:
        study: folder of the study.
        parent: of the dialog.
    """

    wanted = Signal(str, object)

    def __init__(self, study: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Export the data"))
        resize_within_screen(self, *_SIZE_PX)
        self._name = study.name
        self.form, self.place = QComboBox(), QLineEdit(str(study.parent))
        self.form.setAccessibleName(self.tr("Format"))
        self.place.setAccessibleName(self.tr("Place"))
        for name, one in study_exporters().items():
            self.form.addItem(translated(one.text), name)
        self.whole, self.problem = paragraph("", theme.DIM), paragraph("", theme.BAD)
        self.export_button = text_button(self.tr("&Export"), "", "primary")
        self.export_button.setDefault(True)
        self.export_button.clicked.connect(self._take)
        self.form.currentIndexChanged.connect(lambda _row: self._show())
        self.place.textChanged.connect(lambda _text: self._show())
        browse = text_button(self.tr("Browse\u2026"), self.tr("Choose another folder"))
        browse.clicked.connect(self._browse)
        cancel = text_button(self.tr("&Cancel"), "")
        cancel.clicked.connect(self.reject)
        rows = QFormLayout()
        rows.addRow(self.tr("Format"), self.form)
        rows.addRow(self.tr("Place"), row_of((self.place, 1), browse, spacing=8))
        rows.addRow("", self.whole)
        buttons = row_of(STRETCH, cancel, self.export_button, spacing=8)
        fill_page(self, rows, self.problem, STRETCH, buttons)
        self._show()

    def target(self) -> Path:
        """The folder that will be made."""
        form = self.form.currentData()
        return Path(self.place.text().strip()) / f"{self._name}-{form}"

    def _show(self) -> None:
        target = self.target()
        self.whole.setText(
            self.tr("The data will be written to {folder}").format(folder=target)
        )
        is_taken = target.exists()
        self.problem.setText(
            self.tr("This folder exists already: choose another place")
            if is_taken
            else ""
        )
        is_named = bool(self.place.text().strip())
        self.export_button.setEnabled(is_named and not is_taken)

    def _browse(self) -> None:
        title = self.tr("Choose where to create the data folder")
        dialog = folder_dialog(self, title, self.place.text())
        dialog.fileSelected.connect(self.place.setText)
        dialog.open()

    def _take(self) -> None:
        self.wanted.emit(self.form.currentData(), self.target())
        self.accept()
