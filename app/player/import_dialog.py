"""The few questions before a recording becomes a sequence."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.experimenter.sync_dialog import SyncDialog
from app.player.files import file_dialog, folder_dialog, video_filter
from app.player.session import ImportRequest
from app.widgets import theme
from app.widgets.buttons import text_button

_LONGEST_OFFSET_S = 86_400.0
_WIDTH_PX = 560


class ImportDialog(QDialog):
    """Asks for a video, perhaps a motion log, and where the sequence goes.

    Signals:
        accepted_request: what was filled in, an ImportRequest.
    """

    accepted_request = Signal(object)

    def __init__(self, folder: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Import a recording"))
        self.setMinimumWidth(min(_WIDTH_PX, self.screen().geometry().width() - 40))
        self._folder = folder
        self._suggested = ""
        self.video = self._path_field(self.tr("Video"))
        self.imu_log = self._path_field(self.tr("Motion log"))
        self.imu_log.setPlaceholderText(self.tr("inside the video"))
        self.target = self._path_field(self.tr("New folder"))
        self.offset = QDoubleSpinBox()
        self.offset.setRange(-_LONGEST_OFFSET_S, _LONGEST_OFFSET_S)
        # the lowest value stands for none: what happens then is told in its place
        self.offset.setSpecialValueText(self.tr("by three pats"))
        self.offset.setValue(-_LONGEST_OFFSET_S)
        self.offset.setDecimals(3)
        self.offset.setMinimumWidth(140)
        self.offset.setSuffix(self.tr(" s"))
        self.offset.setAccessibleName(self.tr("Offset"))
        self.offset.setToolTip(
            self.tr("Media time at which the log's clock reads zero")
        )
        self.look = text_button(
            self.tr("&Look\u2026"), self.tr("Find the pats, see and correct the offset")
        )
        self.look.clicked.connect(self._look)
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        self.problem.setStyleSheet(f"color: {theme.WARN};")
        self._lay_out()
        for field in (self.video, self.imu_log, self.target):
            field.textChanged.connect(self._check)
        self.video.textChanged.connect(self._suggest_target)
        self._check()

    def _path_field(self, name: str) -> QLineEdit:
        field = QLineEdit()
        field.setAccessibleName(name)
        field.setClearButtonEnabled(True)
        return field

    def _lay_out(self) -> None:
        intro = QLabel(
            self.tr(
                "A sequence is a folder with the clip, its motion and the force that "
                "belongs to it. Cameras such as GoPro keep their motion inside the "
                "video; otherwise give the log of a motion sensor."
            )
        )
        intro.setWordWrap(True)
        intro.setStyleSheet(f"color: {theme.DIM};")
        form = QFormLayout()
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight)
        form.setVerticalSpacing(8)
        browse = self.tr("Choose\u2026")
        for label, field, slot in (
            (self.tr("&Video"), self.video, self._choose_video),
            (self.tr("Motion &log (CSV)"), self.imu_log, self._choose_log),
            (self.tr("New &folder"), self.target, self._choose_target),
        ):
            button = text_button(browse, field.accessibleName())
            button.clicked.connect(slot)
            row = QHBoxLayout()
            row.setSpacing(8)
            row.addWidget(field, 1)
            row.addWidget(button)
            form.addRow(label, row)
            caption = form.labelForField(row)
            assert isinstance(caption, QLabel)
            caption.setBuddy(field)
            if field is self.imu_log:
                self._add_offset(form)
        self.offset.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 14, 16, 14)
        column.setSpacing(12)
        column.addWidget(intro)
        column.addLayout(form)
        column.addWidget(self.problem)
        column.addStretch(1)
        column.addLayout(self._buttons())

    def _buttons(self) -> QHBoxLayout:
        self.ok = text_button(
            self.tr("Import"), self.tr("Make the sequence and open it"), "primary"
        )
        self.ok.setDefault(True)
        self.ok.clicked.connect(self.accept)
        cancel = text_button(self.tr("Cancel"), self.tr("Import nothing"))
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addStretch(1)
        row.addWidget(cancel)
        row.addWidget(self.ok)
        return row

    def request(self) -> ImportRequest:
        """Return what is filled in."""
        log = self.imu_log.text().strip()
        return ImportRequest(
            video=Path(self.video.text().strip()),
            imu_log=Path(log) if log else None,
            offset_s=self._offset_s() if log else None,
            target=Path(self.target.text().strip()),
        )

    def _add_offset(self, form: QFormLayout) -> None:
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(self.offset)
        row.addWidget(self.look)
        row.addStretch(1)
        form.addRow(self.tr("&Offset"), row)
        caption = form.labelForField(row)
        assert isinstance(caption, QLabel)
        caption.setBuddy(self.offset)

    def _offset_s(self) -> float | None:
        """Return what a person has given, None for the pats."""
        value_s = self.offset.value()
        return None if value_s == self.offset.minimum() else value_s

    def _look(self) -> None:
        request = self.request()
        assert request.imu_log is not None
        dialog = SyncDialog(request.video, request.imu_log, self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.chosen.connect(self.offset.setValue)
        dialog.open()

    def accept(self) -> None:
        """Hand over what is filled in, if it can be used."""
        if self._obstacle():
            return
        super().accept()
        self.accepted_request.emit(self.request())

    def _check(self) -> None:
        obstacle = self._obstacle()
        is_begun = bool(self.video.text().strip())
        self.problem.setText(obstacle if is_begun else "")
        self.ok.setEnabled(not obstacle)
        request = self.request()
        has_log = bool(self.imu_log.text().strip())
        self.offset.setEnabled(has_log)
        self.look.setEnabled(
            has_log and request.video.is_file() and Path(str(request.imu_log)).is_file()
        )

    def _obstacle(self) -> str:
        """Return what is still missing, "" when nothing is."""
        request = self.request()
        if not self.video.text().strip() or not request.video.is_file():
            return self.tr("Choose a video that exists.")
        if request.imu_log is not None and not request.imu_log.is_file():
            return self.tr("The motion log does not exist.")
        if not self.target.text().strip():
            return self.tr("Choose where the new folder shall be.")
        if request.target.exists():
            return self.tr("The new folder exists already; give another name.")
        return ""

    def _suggest_target(self, video: str) -> None:
        if self.target.text() == self._suggested and video.strip():
            path = Path(video.strip())
            if not path.name:  # "/" or "..", on the way to a name
                return
            self._suggested = str(path.with_name(f"{path.stem}-sequence"))
            self.target.setText(self._suggested)

    def _choose_video(self) -> None:
        self._choose_file(self.video, self.tr("Choose a video"), video_filter())

    def _choose_log(self) -> None:
        kinds = self.tr("Motion logs (*.csv);;All files (*)")
        self._choose_file(self.imu_log, self.tr("Choose a motion log"), kinds)

    def _choose_file(self, field: QLineEdit, title: str, kinds: str) -> None:
        dialog = file_dialog(self, title, self._start(field), kinds)
        dialog.fileSelected.connect(field.setText)
        dialog.open()

    def _choose_target(self) -> None:
        """Choose the folder in which the new one is made."""
        name = Path(self.target.text().strip() or "sequence").name
        title = self.tr("Where shall the new folder be made?")
        dialog = folder_dialog(self, title, self._start(self.target))
        dialog.fileSelected.connect(
            lambda parent: self.target.setText(str(Path(parent) / name))
        )
        dialog.open()

    def _start(self, field: QLineEdit) -> str:
        text = field.text().strip() or self.video.text().strip()
        return str(Path(text).parent) if text else self._folder
