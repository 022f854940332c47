"""The analysis of a study: its report in a window, and written to files."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt, QTimer, QUrl
from PySide6.QtGui import (
    QCloseEvent,
    QImage,
    QTextBlockFormat,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
)
from PySide6.QtWidgets import QMainWindow, QTextBrowser, QWidget

from app.bridge.errors import Attempts
from app.bridge.jobs import Jobs, in_child
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    ElidedLabel,
    column_of,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.messages import JobBar, MessageBar
from hapticplayer.clock import Clock
from hapticplayer.errors import Message, Progress, message_of
from hapticplayer.installation import require
from hapticplayer.study.answers import Answers, read_answers
from hapticplayer.study.study_folder import Study

SCHEME = "figure:"
"""Of the addresses of the figures in the text."""
_READ, _ANALYSED = 0.3, 0.7  # of the work


@dataclass(frozen=True, slots=True)
class Report:
    """Text whose figures (PNG, by name) are referred to as SCHEME and their names.

    `is_empty`: no answer can be used.
    """

    answers: Answers
    html: str
    figures: dict[str, bytes]
    dpi: float
    is_empty: bool


def made_report(answers: Answers, *, progress: Progress) -> Report:
    """Return the report of a study's answers."""
    require("study", Message("the report"))
    from hapticplayer.study.analysis.figures import DPI, image
    from hapticplayer.study.analysis.report import analyse_study
    from hapticplayer.study.analysis.typesetting import body

    parts = analyse_study(
        answers, progress=lambda fraction, step: progress(_ANALYSED * fraction, step)
    )
    progress(_ANALYSED, Message("drawing the figures"))
    figures = {name: image(figure) for name, figure in parts.draw().items()}
    html = body(parts.blocks, lambda name: SCHEME + name)
    return Report(answers, html, figures, DPI, parts.is_empty)


def answers_with_force(folder: Path, *, progress: Progress) -> Answers:
    """Return the answers of a study, with the measured force per trial: its records are large."""
    return read_answers(folder, lambda fraction, step: progress(_READ * fraction, step))


def written_report(
    answers: Answers, target: Path, title: str, *, progress: Progress
) -> Path:
    """Write the report of these answers into a new folder, and return it."""
    from hapticplayer.study.analysis.report import analyse_study, write_report

    found = analyse_study(
        answers, progress=lambda fraction, step: progress(_ANALYSED * fraction, step)
    )
    write_report(
        found,
        target,
        title,
        lambda fraction, step: progress(_ANALYSED + (1.0 - _ANALYSED) * fraction, step),
    )
    return target


_POLL_MS = 50
_SCREEN_DPI = 100.0
_SHOWN = object()
_PARTS = re.compile(r"(?=<h2>)")


class AnalysisPage(QWidget):
    """Analyses a study beside the window, and shows what was found.

    Args:
        title: of the study.
        read: returns its answers.
        say: shows a message to the person.
        clock: of the machine.
    """

    def __init__(
        self,
        title: str,
        read: Callable[[Progress], Answers],
        say: Callable[[str], None],
        clock: Clock,
    ) -> None:
        super().__init__()
        self._title, self._read, self._clock = title, read, clock
        self.attempts = Attempts()
        self._report: Report | None = None
        self._steps: Iterator[None] | None = None  # of showing it
        self.jobs = Jobs(lambda problem: say(message_of(problem)))
        self.job_bar = JobBar()
        self.job_bar.cancelled.connect(self.jobs.cancel)
        self.note = paragraph(self.tr("The report is in English."), theme.DIM)
        self.text = QTextBrowser()
        self.text.setOpenLinks(False)
        self.text.document().setDefaultStyleSheet(_style())
        self.text.setAccessibleName(self.tr("Report"))
        self.analyse_button = text_button(
            self.tr("&Analyse"),
            self.tr("Compute statistics and figures again"),
            "primary",
        )
        self.analyse_button.clicked.connect(self.analyse)
        self.save_button = text_button(
            self.tr("&Save report\u2026"),
            self.tr("Write the report, its figures and the data to a new folder"),
        )
        self.save_button.clicked.connect(self._choose_report_folder)
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(_POLL_MS)
        self._timer.timeout.connect(self._poll)
        self._show_buttons()

    @property
    def is_busy(self) -> bool:
        """Whether a report is made, written, or about to be shown."""
        return self.jobs.is_busy or self._steps is not None

    def analyse(self) -> None:
        """Read the answers and analyse them."""
        if not self.is_busy:
            self.jobs.run(self.tr("Analysing"), self._work, self._show)
            self._begin()

    def save(self, target: Path) -> None:
        """Write the report that is shown into a new folder."""
        if self.is_busy or self._report is None:
            return
        answers, title = self._report.answers, self._title

        def work(progress: Progress) -> Path:
            return in_child(written_report, answers, target, title, progress=progress)

        self.jobs.run(self.tr("Writing the report"), work, self._saved)
        self._begin()

    def close_jobs(self) -> None:
        """Stop what runs; before the window goes."""
        self._timer.stop()
        self._steps = None
        self.jobs.close()

    def _lay_out(self) -> None:
        self._heading = ElidedLabel(self._title)
        buttons = (self.save_button, self.analyse_button)
        top = row_of((self._heading, 1), *buttons, spacing=8)
        self.job_bar.lie_over(self.text)
        parts = (top, self.note, (self.text, 1))
        column_of(*parts, spacing=8, margins=(12, 10, 12, 12), of=self)

    def _work(self, progress: Progress) -> Report:
        progress(0.0, Message("reading the answers"))
        answers = self._read(progress)
        return in_child(
            made_report,
            answers,
            progress=lambda fraction, step: progress(
                _READ + (1.0 - _READ) * fraction, step
            ),
        )

    def _show(self, report: Report) -> None:
        """Show it in steps: a figure is decoded in 12 ms, a part laid out in 10."""
        self._report = report
        if report.is_empty:
            self.note.setText(
                self.tr("No valid answer yet: there is nothing to publish.")
            )
        else:
            text = self.tr("The report is in English, ready for publication.")
            self.note.setText(text)
        self._steps = self._showing(report)

    def _showing(self, report: Report) -> Iterator[None]:
        document = self.text.document()
        document.clear()
        for name, png in report.figures.items():
            image = QImage.fromData(png)
            image.setDevicePixelRatio(report.dpi / _SCREEN_DPI)
            kind = QTextDocument.ResourceType.ImageResource
            document.addResource(kind.value, QUrl(SCHEME + name), image)
            yield
        end = QTextCursor(document)
        for part in _PARTS.split(report.html):
            end.movePosition(QTextCursor.MoveOperation.End)
            if not end.atBlockStart():
                end.insertBlock(QTextBlockFormat(), QTextCharFormat())
            end.insertHtml(part)
            yield

    def _saved(self, target: Path) -> None:
        self._heading.set_text(self.tr("Saved to {0}").format(target))

    def _begin(self) -> None:
        self.attempts.begin()
        self._timer.start()
        self._show_buttons()

    def _poll(self) -> None:
        self.jobs.poll()
        if self._steps is not None and next(self._steps, _SHOWN) is _SHOWN:
            self._steps = None
        self.job_bar.show_state(self.jobs.state(), self._clock.now_s())
        if not self.is_busy:
            self._timer.stop()
        self._show_buttons()

    def _show_buttons(self) -> None:
        self.analyse_button.setEnabled(not self.is_busy)
        self.save_button.setEnabled(not self.is_busy and self._report is not None)

    def _choose_report_folder(self) -> None:
        title = self.tr("Choose where to create the report folder")
        dialog = folder_dialog(self, title, str(Path.home()))
        dialog.fileSelected.connect(lambda path: self.save(Path(path) / "report"))
        dialog.open()


def _style() -> str:
    return f"""
h2 {{ color: {theme.ACCENT}; }}
table {{ margin-top: 4px; margin-bottom: 14px; }}
th {{ color: {theme.DIM}; padding: 1px 7px; text-align: right; }}
td {{ padding: 1px 7px; text-align: right; }}
caption {{ font-weight: bold; }}
img {{ max-width: 100%; }}
"""


WIDTH_PX, HEIGHT_PX = 1040, 860


class AnalysisWindow(QMainWindow):
    """Analyses a study at once; closing it stops what runs.

    The study's folder is read again for each analysis.
    """

    def __init__(self, study: Study, clock: Clock, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        title, folder = study.definition.title, Path(study.folder)
        self.setWindowTitle(self.tr("Analysis \u2013 {0}").format(title))
        self.messages = MessageBar()
        self.page = AnalysisPage(
            title,
            lambda progress: in_child(answers_with_force, folder, progress=progress),
            lambda text: self.messages.show_text(text, self.page.attempts.begin()),
            clock,
        )
        middle = QWidget()
        column_of(self.messages, (self.page, 1), of=middle)
        self.setCentralWidget(middle)
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)

    def begin(self) -> None:
        self.show()
        self.page.analyse()

    def closeEvent(self, event: QCloseEvent) -> None:
        self.page.close_jobs()
        event.accept()
