"""Fullscreen: the clip and nothing else, with or without a window manager."""

from PySide6.QtCore import QObject, QRect, Qt, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMainWindow, QWidget

from app.player.video_surface import VideoSurface

CURSOR_STAYS_MS = 1500


class Fullscreen(QObject):
    """Hides everything but the surface and takes the whole screen, and back.

    Args:
        window: goes fullscreen.
        surface: stays visible.
        others: what is hidden meanwhile.
    """

    def __init__(
        self, window: QMainWindow, surface: VideoSurface, others: list[QWidget]
    ) -> None:
        super().__init__(window)
        self._window = window
        self._surface = surface
        self._others = others
        self._hidden: list[QWidget] = []
        self._geometry_before = QRect()
        self._was_maximized = False
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
        for widget in self._hidden:
            widget.show()
        if self._was_maximized:
            self._window.showMaximized()
        else:
            self._window.showNormal()
            self._window.setGeometry(self._geometry_before)

    def will_show(self, widget: QWidget, *, is_wanted: bool) -> None:
        """Show or hide one of the others, at once or after fullscreen."""
        if not self.is_on:
            widget.setVisible(is_wanted)
        elif is_wanted and widget not in self._hidden:
            self._hidden.append(widget)
        elif not is_wanted and widget in self._hidden:
            self._hidden.remove(widget)

    def _hide_cursor(self) -> None:
        if self.is_on:
            self._surface.setCursor(Qt.CursorShape.BlankCursor)

    def _on_pointer_moved(self) -> None:
        if self.is_on:
            self._surface.unsetCursor()
            self._cursor_timer.start()
