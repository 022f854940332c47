"""The dialogs that the window opens; none of them stops the event loop."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QDialog, QWidget

from app.bridge.settings import Settings
from app.player.device_page import DevicePage
from app.player.files import file_dialog, folder_dialog, video_filter
from app.player.help import about_dialog, shortcuts_dialog
from app.player.import_dialog import ImportDialog
from app.player.session import ImportRequest, Session
from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError
from hapticplayer.playback.haptic_link import NO_DEVICE

_FOLDER = "folder"


class Dialogs(QObject):
    """Asks for what shall be opened, and remembers where that was.

    Args:
        window: their parent.
        session: opens what was chosen.
        settings: keeps the last folder.
    """

    def __init__(self, window: QWidget, session: Session, settings: Settings) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
        self._settings = settings

    def open_sequence(self) -> None:
        """Choose the folder of a sequence."""
        title = self.tr("Open the folder of a sequence")
        dialog = folder_dialog(self._window, title, self._folder())
        dialog.fileSelected.connect(self._open)
        dialog.open()

    def open_video(self) -> None:
        """Choose a video."""
        title = self.tr("Open a video")
        dialog = file_dialog(self._window, title, self._folder(), video_filter())
        dialog.fileSelected.connect(self._open)
        dialog.open()

    def import_recording(self) -> None:
        """Ask what to import."""
        dialog = ImportDialog(self._folder(), self._window)
        dialog.accepted_request.connect(self._import)
        dialog.open()

    def get_to_know(self, clock: Clock) -> None:
        """Demonstrate the forces of the chosen device; nothing plays meanwhile."""
        player = self._session.player
        device = player.link.device
        if device == NO_DEVICE:
            problem = self.tr("Choose a device first, then get to know its forces")
            self._session.gateway.report(HapticPlayerError(problem))
            return
        self._session.stop()
        self._session.choose_device(NO_DEVICE)
        dialog = DevicePage(clock, device, self._window)
        dialog.finished.connect(lambda _: self._session.choose_device(device))
        dialog.open()

    def show(self, make: Callable[[QWidget], QDialog]) -> None:
        """Show one of the dialogs that only tell something."""
        make(self._window).open()

    def shortcuts(self) -> None:
        """Show the keys of the window."""
        actions = self._window.actions()
        self.show(lambda parent: shortcuts_dialog(parent, actions))

    def about(self) -> None:
        """Say what this program is."""
        self.show(about_dialog)

    def _open(self, path: str) -> None:
        self._settings.keep(_FOLDER, str(Path(path).parent))
        self._session.open_path(Path(path))

    def _import(self, request: ImportRequest) -> None:
        self._settings.keep(_FOLDER, str(request.video.parent))
        self._session.import_recording(request)

    def _folder(self) -> str:
        return self._settings.text(_FOLDER, str(Path.home()))
