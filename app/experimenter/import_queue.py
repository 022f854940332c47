"""Several clips are imported one after the other; what needs an answer waits."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QTableWidgetItem, QWidget

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.experimenter.quality_view import verdict
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import FileDrops, file_dialog, folder_dialog, video_filter
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of
from app.widgets.messages import JobRow
from app.widgets.tables import plain_table
from app.widgets.texts import capitalised
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.errors import HapticPlayerError, Progress, message_of
from hapticplayer.sequence.import_batch import (
    BroughtIn,
    Item,
    bring_in,
    items_of,
    needs_an_answer,
)
from hapticplayer.sequence.report import quality_report
from hapticplayer.sequence.store import read_description

WIDTH_PX, HEIGHT_PX = 900, 600
_DETAIL_LINES = 3


class State(Enum):
    """What has become of a clip."""

    WAITING = "waiting"
    RUNNING = "running"
    DONE = "done"
    THERE = "there"
    ASKS = "asks"
    FAILED = "failed"
    STOPPED = "stopped"


_OVER = (State.DONE, State.THERE)


@dataclass
class Row:
    """A clip of the queue; its sequence once there is one."""

    item: Item
    state: State = State.WAITING
    text: str = ""
    folder: Path | None = None


class QueuePage(JobDialog):
    """A table of clips, and one import at a time.

    Signals:
        wizard_wanted: the files of a clip that needs an answer.
        play_wanted: the folder of a sequence.
    """

    wizard_wanted = Signal(list)
    play_wanted = Signal(object)

    def __init__(
        self, paths: Iterable[Path], library: Path, parent: QWidget | None = None
    ) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("Import several clips"))
        self.library, self._folder = library, str(Path.home())
        self.rows: list[Row] = []
        self._is_going = False
        self.drops = FileDrops(self, self.add)
        headings = (self.tr("Clip"), self.tr("Motion log"), self.tr("State"))
        self.table = plain_table(
            self.tr("Clips to import"), headings, 2, is_chosen_from=True
        )
        self.table.itemSelectionChanged.connect(self._show_chosen)
        self.table.itemActivated.connect(lambda _item: self._open_chosen())
        self.detail = paragraph(lines=_DETAIL_LINES)
        self.detail.setTextFormat(Qt.TextFormat.PlainText)
        self.detail.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.report = paragraph(self.tr("No clips yet: add some, or drop them here."))
        self._lay_out()
        self.begin()
        self.add(paths)

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        intro = self.tr(
            "Each clip is imported with its own motion, or with the log of the same name, "
            "and tested. Clips that are in the library are only tested. A clip that needs "
            "an answer waits; the others go on."
        )
        self.progress = JobRow(
            text_button(
                self.tr("S&top"), self.tr("Stop the queue; what is done is kept")
            )
        )
        self.progress.stop.clicked.connect(self._stop)
        clips = text_button(self.tr("&Clips\u2026"), self.tr("Add clips and logs"))
        clips.clicked.connect(self._choose_clips)
        folder = text_button(self.tr("&Folder\u2026"), self.tr("Add a folder of clips"))
        folder.clicked.connect(self._choose_folder)
        self.answer = text_button(
            self.tr("&Answer\u2026"), self.tr("Import the selected clip step by step")
        )
        self.answer.clicked.connect(self._answer)
        self.play = text_button(self.tr("&Play"), self.tr("Play the selected sequence"))
        self.play.clicked.connect(self._play)
        self.start = text_button(
            self.tr("&Start"), self.tr("Import what is not yet there"), "primary"
        )
        self.start.clicked.connect(self.run)
        self.leave = text_button(self.tr("Close"), self.tr("Close this window"))
        self.leave.clicked.connect(self.reject)
        forward = (self.answer, self.play, self.start)
        fill_page(
            self,
            paragraph(intro, theme.DIM),
            (self.table, 1),
            self.detail,
            self.report,
            self.progress,
            row_of(self.leave, clips, folder, STRETCH, *forward, spacing=8),
        )

    # --- what is to be imported ----------------------------------------------

    def add(self, paths: Iterable[Path]) -> None:
        """Add clips with their logs, from files and folders."""
        known = {path for row in self.rows for path in row.item.paths}
        for item in items_of(paths):
            if known.isdisjoint(item.paths):
                self.rows.append(Row(item))
                self._show_new(item)
        self._show_report()
        self._show_chosen()

    def _show_new(self, item: Item) -> None:
        at = self.table.rowCount()
        self.table.insertRow(at)
        logs = ", ".join(log.name for log in item.logs)
        names = (item.video.name if item.video else "\u2013", logs, "")
        for column, text in enumerate(names):
            self.table.setItem(at, column, QTableWidgetItem(text))
        self._show_row(at)
        if at == 0:
            self.table.selectRow(0)

    def run(self) -> None:
        """Import all that is not there, one after the other."""
        for at, row in enumerate(self.rows):
            if row.state not in _OVER:
                self._set(at, State.WAITING)
        self._is_going = True
        self._next()

    def note(self, paths: list[Path], folder: Path | None) -> None:
        """Take over what the wizard has made of a clip."""
        for at, row in enumerate(self.rows):
            if folder is not None and not set(row.item.paths).isdisjoint(paths):
                self._take(at, BroughtIn(folder, is_new=True))
        self._show_report()
        self._show_chosen()

    # --- work ----------------------------------------------------------------

    def _at(self, *states: State) -> int | None:
        found = (at for at, row in enumerate(self.rows) if row.state in states)
        return next(found, None)

    def _next(self) -> None:
        at = self._at(State.WAITING)
        if at is None or self.is_leaving:
            self._is_going = False
            self._show_end()
            return
        item, library = self.rows[at].item, self.library
        self._set(at, State.RUNNING)

        def work(progress: Progress) -> BroughtIn:
            return in_child(bring_in, item, library, progress=progress)

        title = item.paths[0].name
        self.jobs.run(title, work, lambda found: self._take(at, found))
        self._show_report()
        self._show_chosen()

    def _take(self, at: int, found: BroughtIn) -> None:
        self.rows[at].folder = found.folder
        try:
            text = verdict(quality_report(read_description(found.folder)))
        except HapticPlayerError as problem:
            text = translated(message_of(problem))
        self._set(at, State.DONE if found.is_new else State.THERE, text)

    def on_failed(self, problem: BaseException) -> None:
        """Note why a clip is not imported; the others go on."""
        at = self._at(State.RUNNING)
        assert at is not None
        state = State.ASKS if needs_an_answer(problem) else State.FAILED
        what = problem.what if isinstance(problem, LogQuestion) else message_of(problem)
        folder = self.rows[at].item.paths[0].parent
        self._set(at, state, translated(what).removeprefix(f"{folder}/"))
        if not isinstance(problem, HapticPlayerError):
            raise problem

    def _stop(self) -> None:
        """Stop what runs and what waits."""
        self.jobs.cancel()
        for at, row in enumerate(self.rows):
            if row.state is State.WAITING:
                self._set(at, State.STOPPED)

    def poll(self) -> None:
        """Show how far the clip is, and begin with the next one."""
        super().poll()  # which raises what is a fault of the program
        state = self.jobs.state()
        running = self._at(State.RUNNING)
        if state is not None and running is not None:
            step = f"{100.0 * state.fraction:.0f}\u00a0%"
            self._set(running, State.RUNNING, f"{step} {translated(state.step)}")
        elif self._is_going:
            if running is not None:  # it was cancelled
                self._set(running, State.STOPPED)
            self._next()

    # --- what is shown -------------------------------------------------------

    def _set(self, at: int, state: State, text: str = "") -> None:
        row = self.rows[at]
        if (state, text) != (row.state, row.text):
            row.state, row.text = state, text
            self._show_row(at)

    def _show_row(self, at: int) -> None:
        row, cell = self.rows[at], self.table.item(at, 2)
        assert cell is not None
        colours = {
            State.DONE: theme.GOOD,
            State.THERE: theme.GOOD,
            State.ASKS: theme.WARN,
            State.FAILED: theme.BAD,
        }
        cell.setText(self.state_text(row))
        cell.setToolTip(row.text)
        cell.setForeground(QColor(colours.get(row.state, theme.TEXT)))
        if at == self.table.currentRow():
            self.detail.setText(capitalised(row.text))

    def state_text(self, row: Row) -> str:
        """The state of a clip, for people."""
        names = {
            State.WAITING: self.tr("waiting"),
            State.RUNNING: self.tr("importing"),
            State.DONE: self.tr("\u25cf imported"),
            State.THERE: self.tr("\u25cf was there, intact"),
            State.ASKS: self.tr("\u25b2 needs an answer"),
            State.FAILED: self.tr("\u25a0 not imported"),
            State.STOPPED: self.tr("stopped"),
        }
        name = names[row.state]
        return f"{name}: {row.text}" if row.text else name

    def _show_report(self) -> None:
        """Say how many clips came to which end."""
        if not self.rows:
            return
        counts = {
            state: sum(row.state is state for row in self.rows) for state in State
        }
        texts = {
            State.DONE: self.tr("imported: {count}"),
            State.THERE: self.tr("were there: {count}"),
            State.ASKS: self.tr("need an answer: {count}"),
            State.FAILED: self.tr("not imported: {count}"),
            State.STOPPED: self.tr("stopped: {count}"),
            State.RUNNING: self.tr("importing: {count}"),
            State.WAITING: self.tr("waiting: {count}"),
        }
        said = [
            text.format(count=counts[state])
            for state, text in texts.items()
            if counts[state]
        ]
        whole = self.tr("Clips: {count}").format(count=len(self.rows))
        self.report.setText("; ".join([whole, *said]))

    def _show_end(self) -> None:
        """Show the report, and select what needs an answer."""
        self._show_report()
        at = self._at(State.ASKS)
        if at is not None and not self.is_leaving:
            self.table.selectRow(at)
        self._show_chosen()

    def _show_chosen(self) -> None:
        row = self._chosen()
        is_idle = not self.jobs.is_busy
        self.detail.setText(capitalised(row.text) if row else "")
        self.answer.setEnabled(row is not None and row.folder is None and is_idle)
        self.play.setEnabled(row is not None and row.folder is not None and is_idle)
        is_left = any(one.state not in _OVER for one in self.rows)
        self.start.setEnabled(is_left and is_idle)

    def _chosen(self) -> Row | None:
        at = self.table.currentRow()
        return self.rows[at] if 0 <= at < len(self.rows) else None

    # --- what a person does --------------------------------------------------

    def _open_chosen(self) -> None:
        button = self.play if self.play.isEnabled() else self.answer
        button.click()

    def _answer(self) -> None:
        if row := self._chosen():
            self.wizard_wanted.emit(row.item.paths)

    def _play(self) -> None:
        row = self._chosen()
        if row is not None and row.folder is not None:
            self.accept()
            self.play_wanted.emit(row.folder)

    def _choose_clips(self) -> None:
        dialog = file_dialog(
            self, self.tr("Choose clips and logs"), self._folder, video_filter()
        )
        dialog.setFileMode(dialog.FileMode.ExistingFiles)
        dialog.filesSelected.connect(lambda paths: self.add(map(Path, paths)))
        dialog.open()

    def _choose_folder(self) -> None:
        dialog = folder_dialog(self, self.tr("Choose a folder of clips"), self._folder)
        dialog.fileSelected.connect(lambda path: self.add([Path(path)]))
        dialog.open()
