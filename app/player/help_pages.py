"""The pages of the menu Help: what this machine lacks, and a report of a problem."""

from collections.abc import Callable
from datetime import date
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import QDialog, QFileDialog, QPlainTextEdit, QWidget

from app.bridge.jobs import POLL_MS, Job
from app.bridge.languages import translated
from app.player.problem_report import check_text, save, shown
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog
from app.widgets.layout import (
    STRETCH,
    captioned,
    column_of,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.messages import StatusLine
from hapticplayer.errors import HapticPlayerError

WIDTH_PX, HEIGHT_PX = 720, 560
_NOTES_PX = 80


class CheckPage(QDialog):
    """Lists what the program needs of this machine; nothing is changed."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("System check"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.text = _box(self.tr("Results"))
        self.text.setPlainText(self.tr("Checking\u2026"))
        self._buttons = row_of(STRETCH)
        self.copy = text_button(self.tr("C&opy"), self.tr("Copy the whole text"))
        self.copy.clicked.connect(
            lambda: QGuiApplication.clipboard().setText(self.text.toPlainText())
        )
        close = text_button(self.tr("&Close"), "")
        close.clicked.connect(self.reject)
        head = paragraph(
            self.tr("What is installed, what is missing, and how to get it.")
        )
        row = row_of(STRETCH, self.copy, close)
        fill_page(self, head, (self.text, 1), row)
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.checks = Checks(self, self.text.setPlainText, translated)


class Checks:
    """Runs the checks in a thread and hands the text over; a socket may take a second."""

    def __init__(
        self,
        parent: QWidget,
        take: Callable[[str], None],
        say: Callable[[str], str] = str,
    ) -> None:
        self._take = take
        self.job = Job("check", lambda _progress: check_text(say))
        self._timer = QTimer(parent)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)
        self.job.start()
        self._timer.start()

    def _poll(self) -> None:
        if self.job.is_done:
            self._timer.stop()
            self._take(self.job.result or str(self.job.problem))


class ReportPage(QDialog):
    """Shows everything that a report would hold, and saves it as a zip."""

    def __init__(
        self,
        collect: Callable[[str], dict[str, str]],
        folder: str,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Report a problem"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._collect, self._folder = collect, folder
        self._parts: dict[str, str] = {}
        self.notes, self.text = QPlainTextEdit(), _box(self.tr("The report"))
        self.notes.setMaximumHeight(_NOTES_PX)
        self.notes.setTabChangesFocus(True)
        self.notes.setPlaceholderText(
            self.tr("What did you do, what happened, what did you expect?")
        )
        self.notes.textChanged.connect(self._refresh)
        self.status = StatusLine()
        self.save_button = text_button(
            self.tr("&Save\u2026"), self.tr("Save the report as a zip file"), "primary"
        )
        self.save_button.setEnabled(False)
        self.save_button.clicked.connect(self._ask)
        close = text_button(self.tr("&Close"), "")
        close.clicked.connect(self.reject)
        head = paragraph(
            self.tr(
                "This is all that the report holds: no names of your files or folders, "
                "nothing of your recordings. It is saved on this computer; nothing is sent."
            )
        )
        notes = column_of(*captioned(self.tr("Your &words"), self.notes), spacing=4)
        row = row_of(STRETCH, close, self.save_button)
        fill_page(self, head, notes, (self.text, 1), self.status, row)
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.checks = Checks(self, self._take)

    def _take(self, checks: str) -> None:
        self._parts = self._collect(checks)
        self.save_button.setEnabled(True)
        self._refresh()

    @property
    def parts(self) -> dict[str, str]:
        """What is saved: the person's words, and what was collected."""
        words = self.notes.toPlainText().strip()
        return {"words.txt": words, **self._parts} if words else self._parts

    def _refresh(self) -> None:
        self.text.setPlainText(shown(self.parts))

    def _ask(self) -> None:
        title = self.tr("Save the report")
        kinds = self.tr("Zip files (*.zip)")
        dialog = file_dialog(self, title, self._folder, kinds)
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setFileMode(QFileDialog.FileMode.AnyFile)
        dialog.setDefaultSuffix("zip")
        dialog.selectFile(f"hapticplayer-{date.today().isoformat()}.zip")  # noqa: DTZ011 - the person's day
        dialog.setOption(QFileDialog.Option.DontConfirmOverwrite)  # it is refused
        dialog.fileSelected.connect(lambda path: self.save(Path(path)))
        dialog.open()

    def save(self, target: Path) -> None:
        """Write the zip, and say where."""
        try:
            save(self.parts, target)
        except HapticPlayerError as problem:
            self.status.show_problem(problem)
        else:
            text = self.tr("Saved: {name}").format(name=str(target))
            self.status.show_text(text, theme.GOOD)


def _box(name: str) -> QPlainTextEdit:
    made = QPlainTextEdit()
    made.setReadOnly(True)
    made.setAccessibleName(name)
    fixed = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    made.setFont(theme.scaled(fixed, 0.95))
    return made
