"""How the motion of a recording is processed: the fields, and what they say."""

from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QLineEdit, QWidget

from app.bridge.languages import translated
from app.experimenter.import_columns import Number
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog, settings_filter
from app.widgets.layout import captioned, paragraph, row_of
from app.widgets.texts import capitalised
from hapticplayer.model import ranges
from hapticplayer.model.ranges import Range
from hapticplayer.motion import DEFAULT_METHOD, METHODS
from hapticplayer.sequence.calibration import read_calibration
from hapticplayer.sequence.processing import Processing


class ProcessingFields(QObject):
    """Gravity removal, its calibration, and what is done to the samples."""

    def __init__(self, parent: QWidget, folder: Path) -> None:
        super().__init__(parent)
        self._parent, self._folder = parent, folder
        self.method = QComboBox()
        self.method.setAccessibleName(self.tr("Gravity removal"))
        self.method_text = paragraph(colour=theme.DIM)
        for one in METHODS.values():
            self.method.addItem(one.name, one.name)
        self.method.currentTextChanged.connect(self._show_method)
        self.method.setCurrentText(DEFAULT_METHOD)
        self._show_method(DEFAULT_METHOD)
        self.time_constant = Number(self.tr("Time constant, s"))
        self.time_constant.setPlaceholderText(self.tr("from the motion"))
        self.time_constant.setToolTip(
            self.tr("Accelerations that last much longer than this count as gravity")
        )
        self.calibration = QLineEdit()
        self.calibration.setAccessibleName(self.tr("Calibration"))
        self.calibration.setPlaceholderText(self.tr("None"))
        self.calibration.setToolTip(
            self.tr(
                "For short recordings: the file with what a longer one of the same sensor "
                "tells of its errors"
            )
        )
        self.spikes = QCheckBox(self.tr("Replace isolated s&pikes"))
        self.clipping = QCheckBox(self.tr("Reconstruct short cli&pped peaks"))
        self.average = self._rate(self.tr("Average to, Hz"))
        self.lowpass = self._rate(self.tr("Low-pass at, Hz"))
        self.rows: list[QWidget] = []

    def _rate(self, name: str) -> Number:
        made = Number(name)
        made.setPlaceholderText(self.tr("not at all"))
        return made

    def add_rows(self, form: QFormLayout) -> None:
        """Put the fields into a form."""
        choose = text_button(self.tr("Choose\u2026"), self.tr("Choose a calibration"))
        choose.clicked.connect(self._choose_calibration)
        calibration = QWidget()
        row_of((self.calibration, 1), choose, of=calibration)
        rates = QWidget()
        names = (
            captioned(one.accessibleName(), one) for one in (self.average, self.lowpass)
        )
        row_of(*(part for pair in names for part in pair), of=rates)
        caption, _ = captioned(self.tr("&Calibration"), self.calibration)
        form.addRow(self.tr("Gra&vity removal"), self.method)
        form.addRow("", self.method_text)
        form.addRow(self.time_constant.accessibleName(), self.time_constant)
        form.addRow(caption, calibration)
        form.addRow("", self.spikes)
        form.addRow("", self.clipping)
        form.addRow("", rates)
        self.rows = [
            *(self.method, self.method_text, self.time_constant, calibration),
            *(self.spikes, self.clipping, rates),
        ]

    def _show_method(self, name: str) -> None:
        self.method_text.setText(capitalised(translated(METHODS[name].text)))

    def chosen(self) -> Processing:
        """What the fields say; raises UsageError or InputError for what they cannot be."""
        path = self.calibration.text().strip()
        return Processing(
            method=str(self.method.currentData()),
            time_constant_s=_number(self.time_constant, ranges.TIME_CONSTANT_S),
            remove_spikes=self.spikes.isChecked(),
            repair_clipping=self.clipping.isChecked(),
            average_hz=_number(self.average, ranges.AVERAGE_HZ),
            lowpass_hz=_number(self.lowpass, ranges.LOWPASS_HZ),
            calibration=read_calibration(Path(path)) if path else None,
        )

    def _choose_calibration(self) -> None:
        title = self.tr("Choose a calibration")
        start = self.calibration.text() or str(self._folder)
        dialog = file_dialog(self._parent, title, start, settings_filter())
        dialog.fileSelected.connect(self.calibration.setText)
        dialog.open()


def _number(field: Number, within: Range) -> float | None:
    text = field.value()
    return within.parse(field.accessibleName(), text) if text else None
