"""Studies in the player's menu: make, edit, run."""

import sys
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QProcess
from PySide6.QtWidgets import QFileDialog, QInputDialog, QMainWindow

from app.experimenter.study_editor import StudyEditor
from hapticplayer.errors import HapticPlayerError
from hapticplayer.study.creation import create_study, template_names
from hapticplayer.study.study_folder import open_study

translate = QCoreApplication.translate


class StudyMenu(QObject):
    """Adds the menu, and does what it offers.

    Args:
        window: whose menu bar it joins.
        report: shows what went wrong.
        release: lets go of the device, before a session takes it.
    """

    def __init__(
        self,
        window: QMainWindow,
        report: Callable[[HapticPlayerError], None],
        release: Callable[[], None],
    ) -> None:
        super().__init__(window)
        self._window, self._report, self._release = window, report, release
        menu = window.menuBar().addMenu(translate("StudyMenu", "&Study"))
        for text, slot in (
            (translate("StudyMenu", "&New study\u2026"), self.new),
            (translate("StudyMenu", "&Edit study\u2026"), self.edit),
            (translate("StudyMenu", "&Run a participant\u2026"), self.run),
        ):
            menu.addAction(text).triggered.connect(lambda _on, slot=slot: slot())

    def new(self) -> None:
        """Ask for a name and a template, and open the editor."""
        title = translate("StudyMenu", "New study")
        path, _ = QFileDialog.getSaveFileName(self._window, title)
        if not path:
            return
        template, is_meant = QInputDialog.getItem(
            self._window,
            title,
            translate("StudyMenu", "Template"),
            template_names()[::-1],
            editable=False,
        )
        if is_meant:
            self._try(
                lambda: self._open_editor(create_study(Path(path), template).folder)
            )

    def edit(self) -> None:
        """Ask for a study, and open the editor."""
        folder = self._ask()
        if folder:
            self._try(lambda: self._open_editor(folder))

    def _open_editor(self, folder: Path) -> None:
        StudyEditor(open_study(folder), self._window).open()

    def run(self) -> None:
        """Run a participant in a program of its own: nothing else shares its time."""
        folder = self._ask()
        if folder is None:
            return

        def start() -> None:
            open_study(folder)
            self._release()
            arguments = ["-m", "app", "study", "run", str(folder)]
            QProcess.startDetached(sys.executable, arguments)

        self._try(start)

    def _ask(self) -> Path | None:
        folder = QFileDialog.getExistingDirectory(
            self._window, translate("StudyMenu", "Folder of a study")
        )
        return Path(folder) if folder else None

    def _try(self, action: Callable[[], None]) -> None:
        try:
            action()
        except HapticPlayerError as problem:
            self._report(problem)
