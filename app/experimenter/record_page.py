"""Records with a camera, a microphone and a motion sensor, and shows the take back."""

import shutil
from collections.abc import Callable
from pathlib import Path
from tempfile import mkdtemp
from typing import NamedTuple

from PySide6.QtCore import QDateTime, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QMessageBox, QStackedWidget, QWidget

from app.bridge.jobs import Jobs, in_child
from app.bridge.languages import translated
from app.bridge.pump import Cadence
from app.bridge.settings import Settings
from app.experimenter.import_files import LogQuestionBox
from app.experimenter.record_choice import ChoiceForm, Chosen, Found, plugged_in
from app.experimenter.record_feel import FeelNow, FeelSetup
from app.experimenter.record_live import LivePane
from app.experimenter.record_take import TakeView
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import STRETCH, column_of, paragraph, read_in_order, row_of
from app.widgets.messages import JobRow
from app.widgets.texts import capitalised
from hapticplayer.capture.choices import LogChoices, LogQuestion, parse_choices
from hapticplayer.capture.live.recorder import Recorder
from hapticplayer.capture.live.source import OpenedSource, open_source
from hapticplayer.capture.recorded import CLIP, Take, finished
from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import (
    Cancelled,
    HapticPlayerError,
    Message,
    Progress,
    message_of,
)
from hapticplayer.sequence.library import free_name
from hapticplayer.sequence.take_overview import TakeOverview, overview_of

WIDTH_PX, HEIGHT_PX = 940, 640
CHOOSING, TAKE = range(2)
PREVIEW_S = 60.0
FELT_HZ = 6.0
"""Drawn while it is felt: the sensor's thread waits for the interpreter meanwhile."""

_NAME = "yyyy-MM-dd HH.mm.ss"


class RecordPage(JobDialog):
    """Start, mark, stop; then the take, to be imported or recorded again.

    Meanwhile what the sensor measures can be felt.

    What is being recorded when the page or the program is closed is kept.
    """

    import_wanted = Signal(object)
    """The folder of a take that has a video."""

    def __init__(
        self, settings: Settings, setup: FeelSetup, parent: QWidget | None = None
    ) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("Record"))
        self._clock = setup.clock
        self.recorder: Recorder | None = None
        self._preview: Recorder | None = None
        self._is_preview, self._how = False, Message("")
        self.folder: Path | None = None
        self._answers: list[str] = []
        self._asked: Message | None = None
        self._allowed: list[Message] = []
        self._looking, self._drawing = Jobs(self.on_failed), Cadence(FELT_HZ)
        self.form, self.live = ChoiceForm(settings), LivePane()
        self.take = TakeView(setup.clock, setup.make_player)
        self.feeling = FeelNow(setup, self)
        self.feeling.said.connect(self.live.say)
        self.question = LogQuestionBox(has_form=False)
        self.question.answered.connect(self._answer)
        self.problem = paragraph("", theme.BAD)
        self.problem.setTextFormat(Qt.TextFormat.PlainText)
        self.problem.hide()
        self.form.changed.connect(self.show_buttons)
        self.form.look_wanted.connect(self.look)
        self._lay_out()
        self.begin()
        self.look()
        self.show_buttons()

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        recording = QWidget()
        column_of(self.form, (self.live, 1), spacing=8, of=recording)
        self.stack = QStackedWidget()
        for page in (recording, self.take):
            self.stack.addWidget(page)
        self.progress = JobRow(text_button(self.tr("Stop"), self.tr("Cancel")))
        self.progress.stop.clicked.connect(self.jobs.cancel)
        below = (self.question, self.problem, self._button_row())
        column_of((self.stack, 1), *below, spacing=8, margins=(16, 10, 16, 10), of=self)

    def _button_row(self) -> QHBoxLayout:
        self.leave = text_button(self.tr("Close"), self.tr("Close this window"))
        self.leave.clicked.connect(self.reject)
        self.mark = text_button(
            self.tr("&Mark"), self.tr("Mark this moment in the recording")
        )
        self.mark.clicked.connect(self.mark_moment)
        self.preview = text_button(
            self.tr("Pre&view"),
            self.tr("Show picture, sound and motion for a minute; nothing is kept"),
        )
        self.preview.clicked.connect(self.show_preview)
        self.start = text_button(
            self.tr("&Record"), self.tr("Start a recording"), "primary"
        )
        self.start.clicked.connect(self.record)
        self.stop = text_button(
            self.tr("S&top"), self.tr("Stop, and show the take"), "primary"
        )
        self.stop.clicked.connect(self.end_take)
        self.again = text_button(
            self.tr("Record &again"), self.tr("Keep this take, and record another one")
        )
        self.again.clicked.connect(self.record_again)
        self.bring_in = text_button(
            self.tr("&Import\u2026"), self.tr("Make a sequence of this take"), "primary"
        )
        self.bring_in.clicked.connect(self._import)
        forward = (
            self.feeling.button,
            self.mark,
            self.preview,
            self.start,
            self.stop,
            self.again,
            self.bring_in,
        )
        return row_of(self.leave, (self.progress, 1), STRETCH, *forward, spacing=8)

    # --- what a person does --------------------------------------------------

    def look(self) -> None:
        """List cameras and microphones, in a thread."""
        if not self._looking.is_busy:
            self.form.show_found(Found((), ()), is_looking=True)
            self._looking.run("", plugged_in, self.form.show_found)

    @property
    def is_looking(self) -> bool:
        """Whether cameras and microphones are looked for now."""
        return self._looking.is_busy

    def record(self) -> None:
        """Open what is chosen, and begin."""
        self._answers = []
        self._is_preview = False
        self._open()

    def show_preview(self) -> None:
        """Show what would be recorded, or end that."""
        if self._preview is not None:
            self._end_preview()
            return
        self._answers = []
        self._is_preview = True
        self._open()

    def _open(self) -> None:
        """Open it with the answers that were given."""
        if self.recorder is not None or self.jobs.is_busy:
            return
        self.question.hide()
        self.problem.hide()
        self.form.keep()
        chosen = self.form.chosen()
        folder = free_name(chosen.folder, _now_text())
        before, self._preview = self._preview, None
        self.feeling.offer(None)
        is_preview = self._is_preview
        choices, self._asked = parse_choices(self._answers), None

        def ask(question: Message) -> bool:
            """What was not allowed yet is refused, and asked in the window."""
            if question not in self._allowed:
                self._asked = question
            return question in self._allowed

        def work(progress: Progress) -> Opened:
            if before is not None:
                thrown_away(before)
            place = Path(mkdtemp(), "preview") if is_preview else folder
            opened = started(chosen, place, self._clock, choices, ask)
            try:
                progress(1.0, "")
            except Cancelled:
                shutil.rmtree(opened.recorder.stop(), ignore_errors=True)
                raise
            return opened

        then = self._on_previewed if is_preview else self.on_started
        self.jobs.run(self.tr("Opening"), work, then)
        self.show_buttons()

    def _end_preview(self) -> None:
        self.feeling.offer(None)
        preview, self._preview = self._preview, None
        if preview is not None:
            self.jobs.run(
                self.tr("Closing"), lambda _progress: thrown_away(preview), self._on_end
            )
        self.show_buttons()

    def mark_moment(self) -> None:
        if self.recorder is not None:
            self.recorder.mark()

    def end_take(self) -> None:
        """Stop, and show what was recorded: the clip at once, its curves once they are."""
        self.feeling.offer(None)
        recorder, self.recorder = self.recorder, None
        if recorder is None:
            return

        def work(_progress: Progress) -> tuple[Path, Take]:
            folder = recorder.stop()
            return folder, finished(folder)

        self.jobs.run(self.tr("Closing"), work, self._on_stopped)
        self.show_buttons()

    def record_again(self) -> None:
        self.take.end()
        self.stack.setCurrentIndex(CHOOSING)
        self.show_buttons()

    def _import(self) -> None:
        folder = self.folder
        self.accept()
        self.import_wanted.emit(folder)

    def _answer(self, words: list[str]) -> None:
        keys = {word.partition("=")[0] for word in words}
        kept = [one for one in self._answers if one.partition("=")[0] not in keys]
        self._answers = [*kept, *words]
        self._open()

    def _allow(self, question: Message) -> None:
        self._allowed.append(question)
        self._open()

    # --- what happens --------------------------------------------------------

    def _on_previewed(self, opened: "Opened") -> None:
        self._preview, source = opened
        self._take_source(source)
        self.show_buttons()

    def _on_end(self, _nothing: None) -> None:
        self.live.clear()

    def on_started(self, opened: "Opened") -> None:
        self.recorder, source = opened
        self._take_source(source)
        self._follow()
        self.show_buttons()

    def _take_source(self, source: OpenedSource | None) -> None:
        """Say how it is started, and let it be felt."""
        self._how = source.how if source else Message("")
        self.feeling.offer(source)

    def _on_stopped(self, stopped: tuple[Path, Take]) -> None:
        self.folder, take = folder, _ = stopped
        self.live.clear()
        self.take.show_take(take, folder / CLIP if take.camera else None)
        self.stack.setCurrentIndex(TAKE)

        def work(progress: Progress) -> TakeOverview:
            return in_child(overview_of, folder, progress=progress)

        self.jobs.run(self.tr("Reading the take"), work, self.take.show_overview)
        self.show_buttons()

    def on_failed(self, problem: BaseException) -> None:
        """Ask what is doubtful about a sensor, or tell what went wrong."""
        if not isinstance(problem, HapticPlayerError):
            raise problem
        if isinstance(problem, LogQuestion):
            self.question.ask(problem)
            read_in_order(self)
        elif self._asked is not None:
            self._ask_for_leave(self._asked)
        else:
            self.problem.setText(translated(message_of(problem)))
            self.problem.show()
        self.show_buttons()

    def _ask_for_leave(self, question: Message) -> None:
        """Ask what must not happen unasked, such as listening on the network."""
        box = QMessageBox(
            QMessageBox.Icon.Question,
            self.windowTitle(),
            capitalised(translated(question)),
        )
        box.setParent(self, Qt.WindowType.Dialog)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        yes = box.addButton(self.tr("&Allow"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(self.tr("&Do not allow"), QMessageBox.ButtonRole.RejectRole)
        yes.clicked.connect(lambda: self._allow(question))
        box.open()

    def poll(self) -> None:
        """Show what is recorded now, and what came of the work."""
        super().poll()
        self._looking.poll()
        if self.feeling.feel is None or self._drawing.is_due(self._clock.now_s()):
            self._follow()

    def _follow(self) -> None:
        """Show what is recorded or would be."""
        if (shown := self.recorder or self._preview) is None:
            return
        state = shown.snapshot()
        self.live.show_state(state, self._how)
        if self._preview is not None and state.elapsed_s > PREVIEW_S:
            self._end_preview()
        elif self.recorder is not None and state.is_over:
            self.end_take()

    def show_buttons(self) -> None:
        is_busy, is_on = self.jobs.is_busy, self.recorder is not None
        is_take = self.stack.currentIndex() == TAKE
        self.form.setVisible(not is_on)
        self.live.setVisible(self.question.isHidden())  # there is no room for both
        chosen = self.form.chosen()
        self.start.setEnabled(not is_busy and bool(chosen.camera or chosen.sensor))
        for button in (self.preview, self.start):
            button.setVisible(not is_on and not is_take)
        is_shown = self._preview is not None
        self.preview.setText(
            self.tr("End pre&view") if is_shown else self.tr("Pre&view")
        )
        self.preview.setEnabled(is_shown or self.start.isEnabled())
        self.form.setEnabled(not is_shown)
        for button in (self.mark, self.stop):
            button.setVisible(is_on)
        for button in (self.again, self.bring_in):
            button.setVisible(is_take)
        self.bring_in.setEnabled(self.take.has_clip and not is_busy)
        self.again.setEnabled(not is_busy)

    # --- the end ---------------------------------------------------------------

    def reject(self) -> None:
        """Stop the force first; then ask about what is being recorded."""
        if self.feeling.feel is not None:
            self.feeling.stop()
        elif self.recorder is None:
            super().reject()
        else:
            self._ask_to_stop()

    def _ask_to_stop(self) -> None:
        box = QMessageBox(
            QMessageBox.Icon.Question,
            self.windowTitle(),
            self.tr("A recording is running. Stop it? What was recorded is kept."),
        )
        box.setParent(self, Qt.WindowType.Dialog)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        stop = box.addButton(self.tr("S&top"), QMessageBox.ButtonRole.AcceptRole)
        on = box.addButton(self.tr("&Continue"), QMessageBox.ButtonRole.RejectRole)
        box.setEscapeButton(on)
        stop.clicked.connect(self.end_take)
        box.open()

    def close_jobs(self) -> None:
        """Keep what is recorded, and wait for what runs; the program ends."""
        self.feeling.offer(None)
        super().close_jobs()
        if self.recorder is not None:
            self.recorder.stop()
        if self._preview is not None:
            thrown_away(self._preview)
        self.recorder = self._preview = None
        self._looking.close()
        self.take.end()


class Opened(NamedTuple):
    """A recorder that records, and the sensor that it reads."""

    recorder: Recorder
    source: OpenedSource | None


def started(
    chosen: Chosen,
    folder: Path,
    clock: Clock,
    choices: LogChoices,
    ask: Callable[[Message], bool],
) -> Opened:
    """A recorder that records; raises what opening raises."""
    source = open_source(chosen.sensor, clock, choices, ask) if chosen.sensor else None
    recorder = Recorder(
        folder,
        chosen.camera or None,
        (chosen.camera and chosen.microphone) or None,
        source,
        clock,
        source_name=chosen.sensor,
    )
    recorder.start()
    return Opened(recorder, source)


def thrown_away(preview: Recorder) -> None:
    """Stop it, and delete what it wrote."""
    shutil.rmtree(preview.stop().parent, ignore_errors=True)


def _now_text() -> str:
    """The present day and second, here."""
    now = QDateTime.fromString(utc_now_iso(), Qt.DateFormat.ISODate)
    return now.toLocalTime().toString(_NAME)
