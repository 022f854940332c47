"""The report of a study in a window of its own."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QMainWindow, QVBoxLayout, QWidget

from app.experimenter.analysis_page import AnalysisPage
from app.widgets.message_bar import MessageBar
from app.widgets.room import resize_within_screen
from hapticplayer.clock import Clock
from hapticplayer.errors import message_of
from hapticplayer.study.answers import read_answers
from hapticplayer.study.study_folder import Study

WIDTH_PX, HEIGHT_PX = 1040, 860


class AnalysisWindow(QMainWindow):
    """Analyses a study at once; closing it stops what runs.

    Args:
        study: opened; its folder is read anew for each analysis.
        clock: of the machine.
        parent: closes it too.
    """

    def __init__(self, study: Study, clock: Clock, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        title, folder = study.definition.title, Path(study.folder)
        self.setWindowTitle(self.tr("Analysis \u2013 {0}").format(title))
        self.messages = MessageBar()
        self.page = AnalysisPage(
            title,
            lambda: read_answers(folder),
            lambda problem: self.messages.show_text(message_of(problem)),
            clock,
        )
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.messages)
        column.addWidget(self.page, 1)
        self.setCentralWidget(middle)
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)

    def begin(self) -> None:
        """Show the window and analyse."""
        self.show()
        self.page.analyse()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Stop what runs."""
        self.page.close_jobs()
        event.accept()
