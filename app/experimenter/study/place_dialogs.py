"""Where the data of a study, or a copy of it for other sites, are written."""

from collections.abc import Mapping
from pathlib import Path

from PySide6.QtCore import QCoreApplication, Signal
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
translate = QCoreApplication.translate


class PlaceDialog(QDialog):
    """Asks for the place of a new folder; `wanted` has the form's name and the folder.

    Args:
        study: folder of the study.
        title: of the dialog, and what its button says.
        sentence: says what is written, with a place for the {folder}.
        forms: texts of the forms by name, to choose from where there are several.
        parent: of the dialog.
    """

    wanted = Signal(str, object)

    def __init__(
        self,
        study: Path,
        title: tuple[str, str],
        sentence: str,
        forms: Mapping[str, str],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(title[0])
        resize_within_screen(self, *_SIZE_PX)
        self._name, self._sentence = study.name, sentence
        self.form, self.place = QComboBox(), QLineEdit(str(study.parent))
        self.form.setAccessibleName(self.tr("Format"))
        self.place.setAccessibleName(self.tr("Place"))
        for name, text in forms.items():
            self.form.addItem(text, name)
        self.whole, self.problem = paragraph("", theme.DIM), paragraph("", theme.BAD)
        self.make_button = text_button(title[1], "", "primary")
        self.make_button.setDefault(True)
        self.make_button.clicked.connect(self._take)
        self.form.currentIndexChanged.connect(lambda _row: self._show())
        self.place.textChanged.connect(lambda _text: self._show())
        browse = text_button(self.tr("Browse\u2026"), self.tr("Choose another folder"))
        browse.clicked.connect(self._browse)
        cancel = text_button(self.tr("&Cancel"), "")
        cancel.clicked.connect(self.reject)
        rows = QFormLayout()
        if len(forms) > 1:
            rows.addRow(self.tr("Format"), self.form)
        rows.addRow(self.tr("Place"), row_of((self.place, 1), browse, spacing=8))
        rows.addRow("", self.whole)
        buttons = row_of(STRETCH, cancel, self.make_button, spacing=8)
        fill_page(self, rows, self.problem, STRETCH, buttons)
        self._show()

    def target(self) -> Path:
        """The folder that will be made."""
        form = self.form.currentData()
        return Path(self.place.text().strip()) / f"{self._name}-{form}"

    def _show(self) -> None:
        target = self.target()
        self.whole.setText(self._sentence.format(folder=target))
        is_taken = target.exists()
        self.problem.setText(
            self.tr("This folder exists already: choose another place")
            if is_taken
            else ""
        )
        is_named = bool(self.place.text().strip())
        self.make_button.setEnabled(is_named and not is_taken)

    def _browse(self) -> None:
        title = self.tr("Choose where to create the folder")
        dialog = folder_dialog(self, title, self.place.text())
        dialog.fileSelected.connect(self.place.setText)
        dialog.open()

    def _take(self) -> None:
        self.wanted.emit(self.form.currentData(), self.target())
        self.accept()


def export_dialog(study: Path, parent: QWidget | None = None) -> PlaceDialog:
    """The dialog that asks for format and place of the data."""
    return PlaceDialog(
        study,
        (
            translate("PlaceDialog", "Export the data"),
            translate("PlaceDialog", "&Export"),
        ),
        translate("PlaceDialog", "The data will be written to {folder}"),
        {name: translated(one.text) for name, one in study_exporters().items()},
        parent,
    )


def pack_dialog(study: Path, parent: QWidget | None = None) -> PlaceDialog:
    """The dialog that asks where a copy of the study for other sites is written."""
    return PlaceDialog(
        study,
        (
            translate("PlaceDialog", "Pack the study for other sites"),
            translate("PlaceDialog", "&Pack"),
        ),
        translate(
            "PlaceDialog",
            "Definition, orders and all sequences, without sessions, will be copied to "
            "{folder}",
        ),
        {"package": ""},
        parent,
    )
