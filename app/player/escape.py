"""Escape stops the force, whichever window or menu has the keyboard."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent, QWindow


class EscapeEverywhere(QObject):
    """Sees the key before the dialog or menu that it closes.

    The window's own shortcut does not reach into modal dialogs and open menus. The
    filter sits on the native windows, which get every key first and little else: on
    the application it would be called for each of a thousand events a second.

    Args:
        stop: called for each press; the key goes on to whom it belongs.
        parent: Qt's owner.
    """

    def __init__(self, stop: Callable[[], None], parent: QObject) -> None:
        super().__init__(parent)
        self._stop, self._is_installed = stop, False
        self._application = QGuiApplication.instance()

    def install(self) -> None:
        """Begin to listen, in every window that gets the keyboard from now on."""
        if isinstance(self._application, QGuiApplication):
            self._is_installed = True
            self._application.focusWindowChanged.connect(self._listen_to)
            for window in QGuiApplication.allWindows():
                self._listen_to(window)

    def remove(self) -> None:
        """Listen no more."""
        if isinstance(self._application, QGuiApplication) and self._is_installed:
            self._is_installed = False
            self._application.focusWindowChanged.disconnect(self._listen_to)
            for window in QGuiApplication.allWindows():
                window.removeEventFilter(self)

    def _listen_to(self, window: QWindow | None) -> None:
        if window is not None:
            window.installEventFilter(self)  # once: Qt moves it to the front

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Look at keys on their way into a native window, once for each press."""
        if (
            event.type() == QEvent.Type.KeyPress
            and watched.isWindowType()
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
            and not event.isAutoRepeat()
        ):
            self._stop()
        return False
