"""The dialogs that the window opens; none of them blocks the event loop."""

import importlib
import threading
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QCoreApplication, QSize, Qt, Signal
from PySide6.QtWidgets import QDialog, QFileDialog, QLabel, QMessageBox, QWidget

from app.bridge.errors import Attempts, IsOver
from app.bridge.languages import translated
from app.bridge.settings import Settings, choose_library, library_folder
from app.player.command import Command
from app.player.device_dialogs import DeviceDialogs
from app.player.playlist import Playlist
from app.player.session import Session
from app.widgets.buttons import text_button
from app.widgets.files import file_dialog, folder_dialog, settings_filter, video_filter
from app.widgets.layout import STRETCH, column_of, fill_page, paragraph, row_of
from app.widgets.texts import capitalised
from app.widgets.theme import icon
from hapticplayer import __version__
from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError
from hapticplayer.model import Mapping
from hapticplayer.playback.source import Source, open_source
from hapticplayer.rendering import FEEDBACKS
from hapticplayer.sequence.store import mapping_of

if TYPE_CHECKING:
    from app.experimenter.import_queue import QueuePage
    from app.experimenter.import_wizard import ImportWizard

translate = QCoreApplication.translate

_TEXT_PX = 320


def about_dialog(parent: QWidget) -> QDialog:
    """Return a dialog that says what this is."""
    dialog = QDialog(parent)
    dialog.setWindowTitle(translate("Help", "About hapticplayer"))
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    image = QLabel()
    image.setPixmap(icon("hapticplayer").pixmap(QSize(56, 56)))
    text = paragraph(
        translate(
            "Help",
            "<b>hapticplayer {version}</b><p>Plays a video and lets you "
            "feel the motion of the camera.</p><p>Based on Danieau et al., "
            "A Framework for Enhancing Video Viewing Experience with Haptic "
            "Effects of Motion (2012).<br>MIT licence.</p>",
        ).format(version=__version__)
    )
    text.setTextFormat(Qt.TextFormat.RichText)
    text.setMinimumWidth(_TEXT_PX)
    # a dialog asks for the height of its texts at another width than they get
    text.setMinimumHeight(text.heightForWidth(_TEXT_PX))
    close = text_button(translate("Help", "Close"), "")
    close.setDefault(True)
    close.clicked.connect(dialog.accept)
    about = row_of(column_of(image, STRETCH), (text, 1), spacing=16)
    fill_page(dialog, about, row_of(STRETCH, close), spacing=14)
    return dialog


_FOLDER = "folder"
LATER = (
    "app.editor.page",
    "app.experimenter.import_queue",
    "app.experimenter.import_wizard",
    "app.experimenter.library_page",
    "app.experimenter.record_page",
    "app.experimenter.rendering_page",
    "app.experimenter.study.editor",
    "app.experimenter.study.results",
    "app.player.condition_form",
    "app.player.device_page",
    "app.player.keys_dialog",
    "app.player.latency_page",
    "app.player.outputs_page",
    "app.player.setup_page",
    "app.player.share_page",
    "hapticplayer.study.creation",
    "hapticplayer.study.session_setup",
)
"""What playing does not need: a fifth of the time that the program takes to start."""


class Dialogs(DeviceDialogs):
    """Asks what to open, and remembers the folder."""

    keys_changed = Signal()
    effects_left = Signal()
    """The editor of effects is closed."""

    def __init__(self, window: QWidget, session: Session, settings: Settings) -> None:
        super().__init__(window, session, settings)
        self._is_prepared, self._attempts = False, Attempts()

    def prepare(self) -> None:
        """Load in a thread what the dialogs need: one is about to be chosen."""
        if not self._is_prepared:
            self._is_prepared = True
            threading.Thread(target=load, name="dialogs").start()

    def open_sequence(self) -> None:
        """Choose the folder of a sequence."""
        title = self.tr("Open a sequence folder")
        dialog = folder_dialog(self._window, title, self._folder())
        dialog.fileSelected.connect(self._open)
        dialog.open()

    def open_video(self) -> None:
        """Choose a video."""
        title = self.tr("Open a video")
        dialog = file_dialog(self._window, title, self._folder(), video_filter())
        dialog.fileSelected.connect(self._open)
        dialog.open()

    def open_log(self) -> None:
        """Choose a log of the clip that is open, to feel again what was sent."""
        title = self.tr("Replay the forces of a log")
        kinds = self.tr("Logs (*.jsonl *.json *.log);;All files (*)")
        dialog = file_dialog(self._window, title, self._folder(), kinds)
        dialog.fileSelected.connect(lambda path: self._session.open_log(Path(path)))
        dialog.open()

    def import_recording(
        self, paths: list[Path] | bool = False, *, suggests: bool = False
    ) -> "ImportWizard":
        """Lead through an import, of files that were dropped perhaps."""
        from app.experimenter.import_wizard import ImportWizard

        library = library_folder(self._settings)
        wizard = ImportWizard(self._folder(), library, self._window)
        wizard.play_wanted.connect(self._session.open_path)
        wizard.library_chosen.connect(self._keep_library)
        wizard.several_wanted.connect(self.import_several)
        self._open_working(wizard)
        if isinstance(paths, list):
            wizard.take(paths, suggests=suggests)
        return wizard

    def import_files(self, paths: list[Path]) -> None:
        """Import what was dropped: a clip step by step, several in a queue."""
        from hapticplayer.sequence.import_batch import items_of

        if len(items_of(paths)) > 1:
            self.import_several(paths)
        else:
            self.import_recording(paths)

    def import_several(self, paths: list[Path]) -> None:
        """Import clips one after the other."""
        from app.experimenter.import_queue import QueuePage

        queue = QueuePage(paths, library_folder(self._settings), self._window)
        queue.play_wanted.connect(self._session.open_path)
        queue.wizard_wanted.connect(lambda chosen: self._answer_in(queue, chosen))
        self._open_working(queue)

    def _answer_in(self, queue: "QueuePage", paths: list[Path]) -> None:
        """Lead through the import of a clip of a queue, which stays behind it."""
        wizard = self.import_recording(paths)
        wizard.play_wanted.connect(queue.accept)
        wizard.finished.connect(lambda _result: queue.note(paths, wizard.made))

    def record(self, clock: Clock) -> None:
        """Record here, and show the take back."""
        from app.experimenter.record_feel import FeelSetup
        from app.experimenter.record_page import RecordPage

        player = self._session.player
        self._lend()
        now = player.snapshot()
        described = now.source.description if now.source else None
        mapping = mapping_of(described) if described else Mapping()
        if mapping.moves_point:  # which needs what comes after
            mapping = replace(mapping, lever_arm_m=(0.0, 0.0, 0.0))
        setup = FeelSetup(
            clock, now.leading.name, mapping, self.own_player, player.latch
        )
        page = RecordPage(self._settings, setup, self._window)
        page.finished.connect(lambda _: self._take_back())
        page.import_wanted.connect(self._import_take)
        self._open_working(page)

    def _import_take(self, folder: Path) -> None:
        """Lead through the import of a take; without a sensor its frames tell."""
        from hapticplayer.capture.recorded import parts_of

        self.import_recording([folder], suggests=parts_of(folder).log is None)

    def library(self, clock: Clock) -> None:
        """Show the sequences that there are."""
        from app.experimenter.library_page import LibraryPage

        page = LibraryPage(library_folder(self._settings), self._window)
        page.open_wanted.connect(self._session.open_path)
        page.import_wanted.connect(self.import_recording)
        page.edit_wanted.connect(lambda folder: self.edit_effects(clock, folder))
        page.library_chosen.connect(self._keep_library)
        self._open_working(page)

    def edit_effects(
        self, clock: Clock, folder: Path | None = None, *, recovers: bool = False
    ) -> None:
        """Edit the effects of a sequence; of the one that is open if none is given.

        With `recovers` it begins with the changes that a kill has left unsaved.
        """
        source = self._session.player.snapshot().source
        if folder is None and source is not None and source.path.is_dir():
            folder = source.path
        if folder is None:
            problem = self.tr(
                "Only the effects of a sequence can be edited: import the video first"
            )
            self._session.report(HapticPlayerError(problem), self._opens_another())
            return
        from app.editor.page import EditorPage
        from app.editor.playing import PlayerSetup

        device = self._session.player.snapshot().leading.name
        self._lend()
        setup = PlayerSetup(clock, device, self._settings, self.own_player)
        page = EditorPage(folder, setup, self._window, recovers=recovers)
        page.saved.connect(self._show_again)
        page.finished.connect(lambda _: self._take_back())
        page.finished.connect(lambda _: self.effects_left.emit())
        self._open_working(page)

    def _show_again(self, folder: Path) -> None:
        """Load a sequence that is open with what has changed in it."""
        now = self._session.player.snapshot()
        if now.source is not None and now.source.path == folder:
            self._session.show_source(open_source(folder))
            self._session.player.seek(now.media_s)

    def share(self) -> None:
        """Write the sequence that is open as a file to send."""
        source = self._session.player.snapshot().source
        if source is None or not source.path.is_dir():
            problem = self.tr(
                "Only a sequence can be shared: import the video first. A file that was "
                "shared with you can be sent on as it is."
            )
            self._session.report(HapticPlayerError(problem), self._opens_another())
            return
        from app.player.share_page import SharePage

        page = SharePage(source.path, self._folder(), source.title, self._window)
        page.shared.connect(self._keep_folder)
        self._open_working(page)

    def rendering(self) -> None:
        """Render the force of the sequence that is open in another way."""
        source = self._session.player.snapshot().source
        if source is None or not source.path.is_dir():
            problem = self.tr(
                "Only a sequence can be rendered: import the video first, or unpack a "
                "file that was shared with you."
            )
            self._session.report(HapticPlayerError(problem), self._opens_another())
            return
        from app.experimenter.rendering_page import RenderingPage

        library = library_folder(self._settings)
        page = RenderingPage(source.path, source.title, library, self._window)
        page.changed.connect(self._session.open_path)
        self._open_working(page)

    def other_feedback(self) -> None:
        """Choose a condition to be made of the sequence that is open."""
        from app.player.condition_form import ConditionDialog

        source = self._session.player.snapshot().source
        own = {one.name for one in FEEDBACKS}
        names = source.tracks if source else ()
        tracks = [one for one in names if one not in own and ":" not in one]
        dialog = ConditionDialog(tracks, self._window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.wanted.connect(self._session.make_feedback)
        dialog.open()

    def show_playlist(self, playlist: Playlist) -> None:
        """Show what plays one after the other, beside the window."""
        from app.player.playlist_page import PlaylistPage

        page = self._window.findChild(PlaylistPage)
        page = page or PlaylistPage(playlist, self._folder(), self._window)
        page.show()
        page.raise_()

    def guide(self) -> None:
        """Show the documents, beside the window."""
        from app.player.guide import GuideWindow

        page = self._window.findChild(GuideWindow) or GuideWindow(self._window)
        page.show()
        page.raise_()

    def system_check(self) -> None:
        """Show what this machine lacks."""
        from app.player.help_pages import CheckPage

        CheckPage(self._window).open()

    def report_problem(self) -> None:
        """Show what a report of a problem would hold."""
        from app.player.help_pages import ReportPage
        from app.player.problem_report import parts_of

        player, noted = self._session.player, self._session.gateway.noted
        collect = partial(parts_of, player, noted, self._settings)
        ReportPage(collect, self._folder(), self._window).open()

    def ask_about_video(self, source: Source) -> None:
        """Ask whether force may be felt with another video than it was made for."""
        video_question(source, self._window).open()

    def close(self) -> None:
        """End what the dialogs still do."""
        for dialog in self._working:
            dialog.close_jobs()
        self._working.clear()

    def _keep_library(self, folder: Path) -> None:
        choose_library(self._settings, folder)

    def show(self, make: Callable[[QWidget], QDialog]) -> None:
        make(self._window).open()

    def shortcuts(self, commands: tuple[Command[Any], ...]) -> None:
        """Show the keys of window and editor, and let people choose others."""
        from app.editor.commands import EDITOR_COMMANDS
        from app.player.keys_dialog import KeysDialog

        every = (*commands, *EDITOR_COMMANDS)
        dialog = KeysDialog(every, self._settings, self._window)
        dialog.changed.connect(self.keys_changed)
        dialog.open()

    def export_settings(self) -> None:
        """Write the settings into a file."""
        title = self.tr("Export settings")
        dialog = file_dialog(self._window, title, self._folder(), settings_filter())
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setFileMode(QFileDialog.FileMode.AnyFile)
        dialog.setDefaultSuffix("json")
        dialog.fileSelected.connect(self.export)
        dialog.open()

    def import_settings(self) -> None:
        """Take settings over from a file."""
        title = self.tr("Import settings")
        dialog = file_dialog(self._window, title, self._folder(), settings_filter())
        dialog.fileSelected.connect(self.take)
        dialog.open()

    def about(self) -> None:
        """Say what this program is."""
        self.show(about_dialog)

    def _keep_folder(self, path: Path) -> None:
        self._settings.keep(_FOLDER, str(path.parent))

    def _open(self, path: str) -> None:
        self._keep_folder(Path(path))
        self._session.open_path(Path(path))

    def export(self, path: str) -> None:
        """Write the settings into a file."""
        self._try(lambda: self._settings.export(Path(path)))

    def take(self, path: str) -> None:
        """Read the settings of a file."""
        if self._try(lambda: self._settings.take(Path(path))):
            self._settings.save()
            self.settings_taken.emit()

    def _try(self, action: Callable[[], None]) -> bool:
        """Do it, or say why not until the next attempt; return whether it is done."""
        is_over = self._attempts.begin()
        try:
            action()
        except HapticPlayerError as problem:
            self._session.report(problem, is_over)
            return False
        return True

    def _opens_another(self) -> IsOver:
        """Whether another clip is open since now."""
        player = self._session.player
        before = player.snapshot().source
        return lambda: player.snapshot().source is not before

    def _folder(self) -> str:
        return self._settings.text(_FOLDER, str(Path.home()))


def load() -> None:
    """Import what dialogs need, which takes a moment."""
    for name in LATER:
        importlib.import_module(name)


def video_question(source: Source, parent: QWidget | None) -> QMessageBox:
    """Return the question; declined, the video plays on without force."""
    assert source.check is not None
    box = QMessageBox(
        QMessageBox.Icon.Warning,
        translate("VideoQuestion", "Another video"),
        capitalised(translated(source.check.notice)) + ".",
        parent=parent,
    )
    box.setInformativeText(
        translate(
            "VideoQuestion",
            "What is felt may not be what is seen. Feel the force anyway?",
        )
    )
    roles = QMessageBox.ButtonRole
    felt = box.addButton(
        translate("VideoQuestion", "&Feel the force"), roles.AcceptRole
    )
    without = box.addButton(
        translate("VideoQuestion", "Play &without"), roles.RejectRole
    )
    box.setDefaultButton(without)
    box.setEscapeButton(without)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    felt.clicked.connect(source.check.accept)
    return box
