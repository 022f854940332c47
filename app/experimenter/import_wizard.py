"""From files to a sequence in the library: five steps in one window."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QStackedWidget,
    QWidget,
)

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.experimenter.import_files import FilesPage
from app.experimenter.import_mounting import MountingPage
from app.experimenter.import_reading import ReadingPage
from app.experimenter.import_sync import SyncPage
from app.experimenter.quality_view import QualityView
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import (
    STRETCH,
    column_of,
    paragraph,
    row_of,
)
from app.widgets.messages import JobRow
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.errors import HapticPlayerError, Progress, message_of
from hapticplayer.sequence.build import Choices, build_sequence
from hapticplayer.sequence.import_preview import ImportPreview, preview_import
from hapticplayer.sequence.report import quality_report, stored_notes
from hapticplayer.sequence.store import read_description
from hapticplayer.sequence.synchronizing import SyncChoices

WIDTH_PX, HEIGHT_PX = 940, 640
FILES, SYNC, MOUNTING, REPORT = range(4)


class ImportWizard(JobDialog):
    """Leads through an import; what is uncertain has to be confirmed."""

    play_wanted = Signal(object)
    library_chosen = Signal(object)
    several_wanted = Signal(list)

    def __init__(
        self, folder: str, library: Path, parent: QWidget | None = None
    ) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("Import a recording"))
        self.preview: ImportPreview | None = None
        self.made: Path | None = None
        self._is_stale = False
        self.files, self.sync = FilesPage(folder), SyncPage()
        self.mounting, self.report = MountingPage(library), QualityView()
        self._lay_out()
        self.files.changed.connect(self._look_anew)
        self.files.several_wanted.connect(self._leave_for_several)
        self.files.suggestion.changed.connect(self.show_buttons)
        self.sync.decided.connect(self.show_buttons)
        self.sync.method_chosen.connect(self._look)
        self.begin()
        self.go_to(FILES)

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        self.steps = QLabel()
        self.steps.setTextFormat(Qt.TextFormat.RichText)
        self.stack = QStackedWidget()
        for page in (self.files, self.sync, self.mounting, self.report):
            self.stack.addWidget(page)
        self.problem = paragraph("", theme.BAD)
        self.problem.setTextFormat(Qt.TextFormat.PlainText)
        rows = (self._progress_row(), self._button_row())
        parts = (self.steps, (self.stack, 1), self.problem, *rows)
        column_of(*parts, spacing=10, margins=(16, 8, 16, 8), of=self)

    def _progress_row(self) -> JobRow:
        self.progress = JobRow(
            text_button(self.tr("&Stop"), self.tr("Cancel; nothing is kept"))
        )
        self.progress.stop.clicked.connect(self.jobs.cancel)
        return self.progress

    def _button_row(self) -> QHBoxLayout:
        self.another = text_button(
            self.tr("&Import another\u2026"), self.tr("Start again with other files")
        )
        self.another.clicked.connect(self._begin_again)
        self.back = text_button(self.tr("&Back"), self.tr("Go to the previous step"))
        self.back.clicked.connect(lambda: self.go_to(self._neighbour(-1)))
        self.next = text_button(
            self.tr("&Next"), self.tr("Go to the next step"), "primary"
        )
        self.next.clicked.connect(self._on_next)
        self.leave = text_button(self.tr("Close"), self.tr("Close this window"))
        self.leave.clicked.connect(self.reject)
        forward = (self.another, self.back, self.next)
        return row_of(self.leave, STRETCH, *forward, spacing=8)

    # --- going through the steps ---------------------------------------------

    def take(self, paths: list[Path], *, suggests: bool = False) -> None:
        """Begin with files that were dropped or chosen elsewhere.

        A video without motion gets an estimate from its frames if that is wanted.
        """
        self.files.suggestion.is_wanted = suggests
        try:
            self.files.take(paths)
        except HapticPlayerError as problem:
            self.files.show_problem(problem)

    def _leave_for_several(self, paths: list[Path]) -> None:
        self.reject()
        self.several_wanted.emit(paths)

    def go_to(self, step: int) -> None:
        """Show a page."""
        self.stack.setCurrentIndex(step)
        self.problem.clear()
        if step != SYNC:
            self.sync.close_jobs()
        self._show_steps()
        self.show_buttons()

    def _show_steps(self) -> None:
        names = (
            self.tr("Recording"),
            self.tr("Synchronise"),
            self.tr("Mounting"),
            self.tr("Report"),
        )
        at = self.stack.currentIndex()
        shown = [
            f"<b>{number + 1} {name}</b>"
            if number == at
            else f"<span style='color:{theme.DIM}'>{number + 1} {name}</span>"
            for number, name in enumerate(names)
        ]
        self.steps.setText(" &nbsp;\u203a&nbsp; ".join(shown))
        self.steps.setAccessibleName(names[at])

    def show_buttons(self) -> None:
        at, is_busy = self.stack.currentIndex(), self.jobs.is_busy
        self.back.setVisible(at < REPORT)
        self.back.setEnabled(at > FILES and not is_busy)
        self.another.setVisible(at == REPORT)
        text = {MOUNTING: self.tr("&Import"), REPORT: self.tr("&Play")}
        self.next.setText(text.get(at, self.tr("&Next")))
        may = {
            FILES: self.preview is not None or self._suggests,
            SYNC: self.sync.may_go_on(),
            MOUNTING: True,
            REPORT: self.made is not None,
        }
        self.next.setEnabled(may[at] and not is_busy)
        self.stack.setEnabled(not is_busy or at == FILES)
        self.progress.show_state(self.jobs.state())

    def _on_next(self) -> None:
        at = self.stack.currentIndex()
        if at == REPORT:
            made = self.made
            self.accept()
            self.play_wanted.emit(made)
        elif at == MOUNTING:
            self._import()
        else:
            if at == FILES and self._suggests:
                self.mounting.show_suggested(Path(self.files.video.text().strip()))
            self.go_to(self._neighbour(1))

    @property
    def _suggests(self) -> bool:
        """Whether the motion is to be estimated from the picture."""
        return self.files.suggestion.is_chosen

    def _neighbour(self, by: int) -> int:
        """Return the step before or after; an estimate has no log to synchronise."""
        step = self.stack.currentIndex() + by
        return step + by if step == SYNC and self._suggests else step

    def _begin_again(self) -> None:
        self.preview = self.made = None
        for field in (self.files.video, self.files.log):
            field.clear()
        self.files.forget()
        self.files.take([])
        self.go_to(FILES)

    # --- work ----------------------------------------------------------------

    def _look_anew(self) -> None:
        self.sync.forget()
        self._look()

    def _look(self) -> None:
        """Read the files that are chosen now; what was typed last may come too late."""
        if self.is_leaving:
            return
        self.preview = None
        self.files.forget()
        self.show_buttons()
        if self.jobs.is_busy:  # with what was chosen before
            self._is_stale = True
            self.jobs.cancel()
            return
        chosen = self.files.chosen()
        if chosen is None:
            return
        video, log = chosen
        method, slowed = str(self.sync.method.currentData()), self.sync.slowed
        said = (self.files.choices(), method, slowed)

        def work(progress: Progress) -> ImportPreview:
            return in_child(preview_import, video, log, *said, progress=progress)

        self.jobs.run(self.tr("Reading {0}").format(video.name), work, self.on_found)
        self.show_buttons()

    def on_found(self, found: ImportPreview) -> None:
        """Show what a recording is, unless another one was chosen meanwhile."""
        if self._is_stale:
            return
        self.preview = found
        self.files.show_found(found)
        self.sync.show_found(found)
        self.mounting.show_found(found)

    def on_failed(self, problem: BaseException) -> None:
        """Tell what went wrong."""
        if self._is_stale:
            return
        if not isinstance(problem, HapticPlayerError):
            self.problem.setText(translated(message_of(problem)))
            raise problem
        if self.stack.currentIndex() == FILES or isinstance(problem, LogQuestion):
            self.files.show_problem(problem)
        else:
            self.problem.setText(translated(message_of(problem)))

    def _import(self) -> None:
        chosen = self.files.chosen()
        assert chosen is not None
        try:
            if not self._suggests:
                self.sync.keep()
            target, choices = self.mounting.target(), self._choices()
        except HapticPlayerError as problem:
            self.problem.setText(translated(message_of(problem)))
            return
        video, log = chosen

        def work(progress: Progress) -> Path:
            return in_child(
                build_sequence,
                video,
                target,
                imu_log=log,
                choices=choices,
                progress=progress,
            )

        self.problem.clear()
        self.jobs.run(self.tr("Importing {0}").format(video.name), work, self.on_made)
        self.show_buttons()

    def _choices(self) -> Choices:
        rendering = self.mounting.rendering.chosen()
        made = Choices(
            title=self.mounting.title.text().strip() or None,
            mapping=rendering.mapping,
            fits_gain=rendering.fits_gain,
            preset=rendering.preset,
        )
        if self._suggests:
            return replace(made, suggest_gain=1.0, sync=SyncChoices(slowed=1.0))
        return replace(
            made,
            processing=self.mounting.motion.chosen(),
            log=self.files.choices(),
            sync=SyncChoices(accepted=self.sync.choice()),
            mounting=self.mounting.axes,
        )

    def on_made(self, folder: Path) -> None:
        """Show the sequence that was made."""
        self.made = folder
        self.library_chosen.emit(self.mounting.library)
        description = read_description(folder)
        notes = stored_notes(description.provenance)
        self.report.show_findings(quality_report(description), notes)
        self.go_to(REPORT)

    # --- what happens by itself ----------------------------------------------

    def poll(self) -> None:
        """Show how far the work is, and what came of it."""
        super().poll()
        self.sync.poll()
        if self._is_stale and not (self.is_leaving or self.jobs.is_busy):
            self._is_stale = False
            self._look()

    def cancel_jobs(self) -> None:
        """Ask what runs to stop."""
        super().cancel_jobs()
        self.sync.close_jobs()

    def close_jobs(self) -> None:
        """Stop what runs and wait for it; the program ends."""
        super().close_jobs()
        self.sync.close_jobs()
        for page in self.findChildren(ReadingPage):
            page.close_jobs()
