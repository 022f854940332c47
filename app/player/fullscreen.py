"""Fullscreen, and Escape, which stops the force whichever window has the keyboard."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QRect, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QKeyEvent, QWindow
from PySide6.QtWidgets import (
    QApplication,
    QBoxLayout,
    QDialog,
    QMainWindow,
    QWidget,
)

from app.player.video_surface import VideoSurface
from app.widgets.layout import TITLE_BAR_PX

_PERSON = {
    QEvent.Type.KeyPress,
    QEvent.Type.MouseButtonPress,
    QEvent.Type.MouseMove,
    QEvent.Type.Wheel,
    QEvent.Type.TouchBegin,
    QEvent.Type.DragEnter,
    QEvent.Type.FocusIn,
}


class EscapeFilter(QObject):
    """Sees the key before the dialog or menu that it closes, and that a person is here.

    The window's own shortcut does not reach into modal dialogs and open menus. The
    filter sits on the native windows, which get every key first and little else: on the
    application it would be called for each of a thousand events a second. The key still
    reaches its widget.
    """

    def __init__(
        self,
        stop: Callable[[], None],
        parent: QObject,
        seen: Callable[[], None] = lambda: None,
    ) -> None:
        super().__init__(parent)
        self._stop, self._seen, self._is_installed = stop, seen, False
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
        if event.type() in _PERSON:
            self._seen()
        if (
            event.type() == QEvent.Type.KeyPress
            and watched.isWindowType()
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
            and not event.isAutoRepeat()
        ):
            self._stop()
        return False


def close_beside() -> None:
    """Close a dialog that has the keyboard beside the window: the shortcut took its Esc."""
    native = QGuiApplication.focusWindow()
    dialogs = [w for w in QApplication.topLevelWidgets() if isinstance(w, QDialog)]
    for dialog in dialogs:
        is_there = dialog.isVisible() and dialog.windowHandle() is native
        if is_there and not dialog.isModal():
            dialog.reject()


CURSOR_STAYS_MS = 1500


class FloatingControls:
    """Lets the controls lie over the video while the pointer moves in fullscreen."""

    def __init__(
        self, controls: QWidget, surface: VideoSurface, home: QBoxLayout
    ) -> None:
        self._controls, self._surface, self._home = controls, surface, home
        self._place = home.indexOf(controls)

    def show(self) -> None:
        """Put them over the lower edge."""
        surface, controls = self._surface, self._controls
        if controls.parent() is not surface:
            self._home.removeWidget(controls)
            controls.setParent(surface)
        high_px = controls.sizeHint().height()
        top_px = surface.height() - high_px
        controls.setGeometry(0, top_px, surface.width(), high_px)
        controls.show()
        controls.raise_()

    @property
    def are_used(self) -> bool:
        """Whether the pointer is on them, or a list of theirs is open."""
        is_here = self._controls.isVisible() and self._controls.underMouse()
        return is_here or QApplication.activePopupWidget() is not None

    def hide(self) -> None:
        self._controls.hide()

    def bring_back(self) -> None:
        """Put them where they belong, hidden or not as before."""
        if self._controls.parent() is self._surface:
            self._home.insertWidget(self._place, self._controls)


class Fullscreen(QObject):
    """Hides everything but the surface and takes the whole screen, and back."""

    def __init__(
        self,
        window: QMainWindow,
        surface: VideoSurface,
        others: list[QWidget],
        controls: FloatingControls,
    ) -> None:
        super().__init__(window)
        self._controls = controls
        self._window = window
        self._surface = surface
        self._others = others
        self._hidden: list[QWidget] = []
        self._geometry_before = QRect()
        self._was_maximized, self._was_shown = False, True
        self.is_on = False
        self.screen_name = ""  # where to; "" for where the window is
        self._cursor_timer = QTimer(self)
        self._cursor_timer.setSingleShot(True)
        self._cursor_timer.setInterval(CURSOR_STAYS_MS)
        self._cursor_timer.timeout.connect(self._hide_cursor)
        surface.pointer_moved.connect(self._on_pointer_moved)

    def enter(self) -> None:
        """Show the clip and nothing else."""
        if self.is_on:
            return
        self.is_on = True
        window = self._window
        self._was_maximized = window.isMaximized()
        self._geometry_before = window.geometry()
        self._was_shown = window.isVisible()
        self._hidden = [widget for widget in self._others if not widget.isHidden()]
        for widget in self._hidden:
            widget.hide()
        known = {screen.name(): screen for screen in QGuiApplication.screens()}
        screen = known.get(self.screen_name, window.screen())
        if screen is not window.screen():
            window.move(screen.geometry().topLeft())
            window.windowHandle().setScreen(screen)
        window.showFullScreen()
        # Without a window manager nobody else would make it as large as the screen.
        # Not through the widget: that would take its fullscreen state away again.
        window.windowHandle().setGeometry(screen.geometry())
        window.activateWindow()
        self._surface.setFocus()
        self._cursor_timer.start()

    def leave(self) -> None:
        """Bring everything back."""
        if not self.is_on:
            return
        self.is_on = False
        self._cursor_timer.stop()
        self._surface.unsetCursor()
        self._controls.bring_back()
        for widget in self._hidden:
            widget.show()
        if self._was_maximized:
            self._window.showMaximized()
        else:
            self._window.showNormal()
            before, screen = self._geometry_before, self._window.screen()
            least_px = screen.availableGeometry().top() + TITLE_BAR_PX
            if not self._was_shown and before.top() < least_px:
                before.moveTop(least_px)  # its title bar would be above the screen
            self._window.setGeometry(before)

    def will_show(self, widget: QWidget, *, is_wanted: bool) -> None:
        """Show or hide one of the others, at once or after fullscreen."""
        if not self.is_on:
            widget.setVisible(is_wanted)
        elif is_wanted and widget not in self._hidden:
            self._hidden.append(widget)
        elif not is_wanted and widget in self._hidden:
            self._hidden.remove(widget)

    def _hide_cursor(self) -> None:
        if self.is_on and self._controls.are_used:
            self._cursor_timer.start()
        elif self.is_on:
            self._controls.hide()
            self._surface.setCursor(Qt.CursorShape.BlankCursor)

    def _on_pointer_moved(self) -> None:
        if self.is_on:
            self._surface.unsetCursor()
            self._controls.show()
            self._cursor_timer.start()
