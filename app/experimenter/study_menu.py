"""The menu of studies, and the process in which a session runs."""

import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QSocketNotifier, QTimer, Signal
from PySide6.QtWidgets import QFileDialog, QMainWindow, QMenu, QProgressDialog

from app.bridge.errors import Attempts, IsOver
from app.bridge.settings import Settings, library_folder
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import HapticPlayerError, StudyError

_PREFIX = "hapticplayer: "
_LOOK_MS = 100


class StudyProcess(QObject):
    """One at a time; it continues when this window is closed.

    `opened` means that its windows are there; `ended` says what it complained of, ""
    where nothing.
    """

    opened = Signal()
    ended = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._looks = QTimer(self, interval=_LOOK_MS)
        self._looks.timeout.connect(self._look)
        self._process: subprocess.Popen[bytes] | None = None

    @property
    def is_running(self) -> bool:
        """Whether a session is open."""
        return self._process is not None

    def start(self, arguments: Sequence[str]) -> None:
        """Start `hapticplayer` with arguments; raises OSError if that is refused."""
        self._stderr = tempfile.TemporaryFile()  # noqa: SIM115 - read when it has ended
        self._process = subprocess.Popen(
            [sys.executable, "-m", "app", *arguments],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=self._stderr,
            start_new_session=True,
        )
        self._looks.start()
        assert self._process.stdout is not None
        self._output = QSocketNotifier(
            self._process.stdout.fileno(), QSocketNotifier.Type.Read, self
        )
        self._output.activated.connect(self._on_said)

    def leave(self) -> None:
        """Stop watching it; it continues."""
        if self._process is None:
            return
        self._looks.stop()
        self._output.setEnabled(False)
        self._output.deleteLater()
        assert self._process.stdout is not None
        self._process.stdout.close()
        self._stderr.close()
        self._process = None

    def _on_said(self) -> None:
        """It says something only once, see `application.run`, or it ends."""
        self._output.setEnabled(False)
        self.opened.emit()

    def _look(self) -> None:
        if self._process and (status := self._process.poll()) is not None:
            self._on_ended(status)

    def _on_ended(self, status: int) -> None:
        self._stderr.seek(0)
        lines = self._stderr.read().decode(errors="replace").splitlines()
        self.leave()
        said = [line for line in lines if line.startswith(_PREFIX)]
        message = said[-1].removeprefix(_PREFIX) if said else "".join(lines[-1:])
        exited = self.tr("The session has ended with status {0}").format(status)
        self.ended.emit((message or exited) if status else "")


translate = QCoreApplication.translate

FOLDER = "study_folder"
"""Name in the settings."""


class StudyMenu(QObject):
    """Adds the menu, and does what it offers.

    `devices` are what stops playback, lends all devices and returns their names, and what
    takes them back.
    """

    running = Signal(bool)

    def __init__(
        self,
        window: QMainWindow,
        clock: Clock,
        report: Callable[[HapticPlayerError, IsOver | None], None],
        devices: tuple[Callable[[], list[str]], Callable[[], None]],
        settings: Settings,
    ) -> None:
        super().__init__(window)
        self._window, self._clock = window, clock
        self.report, self._settings = report, settings
        self.attempts = Attempts()
        self._release, self._take_back = devices
        self.process = StudyProcess(self)
        self.process.ended.connect(self._on_ended)
        self.process.opened.connect(self._on_opened)
        self._waiting: QProgressDialog | None = None
        menu = QMenu(translate("StudyMenu", "&Study"), window)
        bar = window.menuBar()
        bar.insertMenu(bar.actions()[-1], menu)  # help stays last
        for text, slot in (
            (translate("StudyMenu", "&New study\u2026"), self.new),
            (translate("StudyMenu", "&Edit study\u2026"), self.edit),
            (translate("StudyMenu", "&Run a participant\u2026"), self.run),
            (translate("StudyMenu", "&Sessions and data\u2026"), self.show_results),
            (translate("StudyMenu", "&Analyse study\u2026"), self.analyse),
        ):
            menu.addAction(text).triggered.connect(lambda _on, slot=slot: slot())

    def new(self) -> None:
        """Ask for what a new study is, make it, and open the editor."""
        from app.experimenter.study.new_study import NewStudyDialog

        dialog = NewStudyDialog(self.place(), self._window)
        dialog.made.connect(self._on_made)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _on_made(self, folder: Path) -> None:
        self._settings.keep(FOLDER, str(folder.parent))
        self._try(lambda: self._open_editor(folder))

    def place(self) -> Path:
        """Where studies are."""
        kept = self._settings.text(FOLDER)
        return Path(kept) if kept else library_folder(self._settings).parent

    def edit(self) -> None:
        folder = self.ask_folder()
        if folder:
            self._try(lambda: self._open_editor(folder))

    def open_folder(self, folder: Path) -> bool:
        """Edit the study in a folder; False where it holds none."""
        from hapticplayer.study.definition_reader import DEFINITION

        is_study = (folder / DEFINITION).is_file()
        if is_study:
            self._try(lambda: self._open_editor(folder))
        return is_study

    def _open_editor(self, folder: Path) -> None:
        from app.experimenter.study.editor import StudyEditor

        library = partial(library_folder, self._settings)
        editor = StudyEditor(folder, library, self._window)
        editor.finished.connect(editor.deleteLater)
        editor.open()

    def run(self) -> None:
        """Run a participant in a program of its own: nothing else shares its time."""
        folder = None if self.process.is_running else self.ask_folder()
        if folder is not None:
            self._try(lambda: self._start(folder))

    def _start(self, folder: Path) -> None:
        from hapticplayer.study.session_setup import load_study_sources
        from hapticplayer.study.study_folder import open_study

        load_study_sources(open_study(folder))  # what is missing is reported here
        names = self._release() or [NO_DEVICE]
        chosen = [word for name in names for word in ("--device", name)]
        try:
            self.process.start(["study", "run", str(folder), *chosen])
        except OSError as problem:
            self._take_back()
            raise StudyError(
                "cannot be started ({reason})", reason=problem
            ) from problem
        self._show_waiting()
        self.running.emit(True)

    def _show_waiting(self) -> None:
        """Say that the session is coming: its windows take some seconds."""
        text = translate("StudyMenu", "Opening the session\u2026")
        waiting = self._waiting = QProgressDialog(text, "", 0, 0, self._window)
        waiting.setCancelButton(None)
        waiting.setWindowTitle(translate("StudyMenu", "Run a participant"))
        waiting.show()

    def _on_opened(self) -> None:
        if self._waiting is not None:
            self._waiting.close()
            self._waiting.deleteLater()
            self._waiting = None

    def _on_ended(self, problem: str) -> None:
        self._on_opened()
        self.running.emit(False)
        self._try(self._take_back)
        if problem:
            self.report(StudyError(problem), self.attempts.begin())

    def show_results(self) -> None:
        """Show who took part, and what can be done with their data."""
        folder = self.ask_folder()
        if folder:
            self._try(lambda: self._open_results(folder))

    def _open_results(self, folder: Path) -> None:
        from app.experimenter.study.results import StudyResults

        results = StudyResults(folder, self._window)
        results.analysis_wanted.connect(
            lambda: self._try(lambda: self.open_report(folder))
        )
        results.finished.connect(results.deleteLater)
        results.show()

    def analyse(self) -> None:
        folder = self.ask_folder()
        if folder:
            self._try(lambda: self.open_report(folder))

    def open_report(self, folder: Path) -> None:
        # loads scipy and its kin: half of the time that the window takes to start
        from app.experimenter.analysis import AnalysisWindow
        from hapticplayer.study.study_folder import open_study

        AnalysisWindow(open_study(folder), self._clock, self._window).begin()

    def take_over(self, other: "StudyMenu") -> None:
        """Watch the session that another window has watched until now."""
        if other.process.is_running:
            other.process.ended.disconnect()
            other.process.setParent(self)
            self.process = other.process
            self.process.ended.connect(self._on_ended)
            self.running.emit(True)

    def close(self) -> None:
        for report in self._window.findChildren(QMainWindow):
            report.close()

    def ask_folder(self) -> Path | None:
        """Return the folder of a study that a person chose."""
        folder = QFileDialog.getExistingDirectory(
            self._window,
            translate("StudyMenu", "Study folder"),
            self._settings.text(FOLDER),
        )
        if folder:
            self._settings.keep(FOLDER, str(Path(folder).parent))
        return Path(folder) if folder else None

    def _try(self, action: Callable[[], None]) -> None:
        is_over = self.attempts.begin()
        try:
            action()
        except HapticPlayerError as problem:
            self.report(problem, is_over)
