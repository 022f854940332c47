"""A new study: its name, its place, its languages and the template it begins with."""

from pathlib import Path

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QDialog,
    QFormLayout,
    QLineEdit,
    QRadioButton,
    QWidget,
)

from app.bridge.languages import NAMES, spoken, translated
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    STRETCH,
    column_of,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
    scrolling,
)
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.sequence.library import name_from
from hapticplayer.study.creation import (
    STUDY_TEMPLATES,
    create_study,
    new_definition,
)
from hapticplayer.study.definition import TrialKind
from hapticplayer.study.definition_reader import parse_definition

_WIDTH_PX, _HEIGHT_PX = 720, 600
_PICTURE_PX = (184, 84)
_GAP_PX = 4


class TemplatePicture(QWidget):
    """A row for each clip, a column for each way it is felt: bars of their force.

    Nothing for no force, noise for a random one, shifted for one that is late.
    """

    def __init__(self, template: str) -> None:
        super().__init__()
        self.setFixedSize(QSize(*_PICTURE_PX))
        made = parse_definition(new_definition(template), template)
        self._rows = len(made.sequences)
        if made.trial is TrialKind.RATING:
            self._columns = [
                (0.0, 0.0) if one.condition == "none" else _phase(one.condition)
                for one in made.chosen_feedbacks
            ]
        else:
            levels = [(level.gain, level.delay_s) for level in made.levels]
            self._columns = levels or [(1.0, 0.0), (1.0, 0.3)]  # of a staircase

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            wide = (self.width() + _GAP_PX) / len(self._columns)
            high = (self.height() + _GAP_PX) / self._rows
            for row in range(self._rows):
                for column, (gain, delay) in enumerate(self._columns):
                    cell = QRectF(
                        column * wide, row * high, wide - _GAP_PX, high - _GAP_PX
                    )
                    self._draw(painter, cell, gain, delay, row)

    def _draw(
        self, painter: QPainter, cell: QRectF, gain: float, delay: float, row: int
    ) -> None:
        painter.setPen(QColor(theme.BORDER))
        painter.setBrush(QColor(theme.RAISED))
        painter.drawRoundedRect(cell, 3, 3)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.ACCENT))
        inside = cell.adjusted(3, 3, -3, -3)
        count = max(3, int(inside.width() // 5))
        for bar in range(count):
            share = gain * _FORM[(bar + 2 * row - round(4 * delay)) % len(_FORM)]
            height = max(1.0, share * inside.height())
            left = inside.left() + bar * inside.width() / count
            painter.drawRect(
                QRectF(
                    left, inside.bottom() - height, inside.width() / count - 1, height
                )
            )


_FORM = (0.3, 0.9, 0.6, 0.2, 0.7, 1.0, 0.4, 0.25)  # of a drawn force


def _phase(condition: str) -> tuple[float, float]:
    """Return gain and delay of a drawn condition: the recorded one has 1 and 0."""
    delays = {"random": 0.75, "shuffled": 1.25, "delayed": 0.5, "inverted": 1.0}
    return 1.0, delays.get(condition, 0.0)


class NewStudyDialog(QDialog):
    """Asks for a study and makes it; `made` has its folder.

    Args:
        place: where studies were made before.
        parent: of the dialog.
    """

    made = Signal(object)

    def __init__(self, place: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("New study"))
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)
        self.name, self.place = QLineEdit(), QLineEdit(str(place))
        self.name.setAccessibleName(self.tr("Name"))
        self.place.setAccessibleName(self.tr("Place"))
        self.name.setPlaceholderText(self.tr("For example: Bicycle rides 2026"))
        self.problem = paragraph("", theme.BAD)
        self.problem.hide()
        self.templates = QButtonGroup(self)
        self.languages = {language: QCheckBox(text) for language, text in NAMES.items()}
        self.languages[spoken()].setChecked(True)
        self.create_button = text_button(self.tr("&Create"), "", "primary")
        self.create_button.setDefault(True)
        self.create_button.clicked.connect(self.create_study)
        self.name.textChanged.connect(lambda _text: self._show_place())
        self.place.textChanged.connect(lambda _text: self._show_place())
        self.whole_place = paragraph("", theme.DIM)
        self._lay_out()
        self._show_place()
        self.name.setFocus()

    def _lay_out(self) -> None:
        browse = text_button(self.tr("Browse\u2026"), self.tr("Choose another folder"))
        browse.clicked.connect(self._browse)
        form = QFormLayout()
        form.addRow(self.tr("Name"), self.name)
        form.addRow(self.tr("Place"), row_of((self.place, 1), browse, spacing=8))
        form.addRow("", self.whole_place)
        boxes = row_of(*self.languages.values(), STRETCH, spacing=16)
        form.addRow(self.tr("Languages of participants"), boxes)
        heading = paragraph(self.tr("Begin with"))
        rows = [self._template_row(number) for number in range(len(STUDY_TEMPLATES))]
        cancel = text_button(self.tr("&Cancel"), "")
        cancel.clicked.connect(self.reject)
        buttons = row_of(STRETCH, cancel, self.create_button, spacing=8)
        area = scrolling(column_of(*rows, STRETCH, spacing=14))
        fill_page(self, form, heading, (area, 1), self.problem, buttons)

    def _template_row(self, number: int) -> QWidget:
        template, row = STUDY_TEMPLATES[number], QWidget()
        button = QRadioButton(translated(template.title))
        button.setChecked(number == 0)
        self.templates.addButton(button, number)
        text = paragraph(translated(template.text), theme.DIM)
        words = column_of(button, text, STRETCH, spacing=4)
        row_of(TemplatePicture(template.name), (words, 1), spacing=14, of=row)
        return row

    def folder(self) -> Path:
        """Where the study is to be."""
        return Path(self.place.text().strip()) / name_from(self.name.text())

    def _show_place(self) -> None:
        is_named = bool(self.name.text().strip() and self.place.text().strip())
        text = self.tr("The study will be kept in {folder}")
        folder = str(self.folder()) if is_named else "\u2026"
        self.whole_place.setText(text.format(folder=folder))
        self.create_button.setEnabled(is_named)
        self.problem.hide()

    def _browse(self) -> None:
        dialog = folder_dialog(
            self, self.tr("Choose where to create the study"), self.place.text()
        )
        dialog.fileSelected.connect(self.place.setText)
        dialog.open()

    def create_study(self) -> None:
        """Make the study, or say why it cannot be made."""
        languages = [one for one, box in self.languages.items() if box.isChecked()]
        if not languages:
            self._say(self.tr("Choose a language for the participants' pages"))
            return
        template = STUDY_TEMPLATES[self.templates.checkedId()].name
        try:
            study = create_study(
                self.folder(), template, languages=languages, title=self.name.text()
            )
        except HapticPlayerError as problem:
            self._say(translated(message_of(problem)))
        else:
            self.accept()
            self.made.emit(study.folder)

    def _say(self, text: str) -> None:
        self.problem.setText(text)
        self.problem.show()
