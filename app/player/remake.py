"""The window that is open, made anew for another look or language.

Every widget takes its texts and colours when it is made. So another look or language
is another window around the same player; the clip stands still meanwhile.
"""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtWidgets import QApplication

from app.bridge import languages
from app.bridge.settings import Settings
from app.player.look_menus import LANGUAGE, LOOK
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.widgets import theme


class OpenWindow(QObject):
    """Holds the window, and replaces it when it asks for that.

    Args:
        window: the first one.
        ended: called when the clip of any of them has come to its end.
    """

    def __init__(
        self, window: PlayerWindow, ended: Callable[[], None] | None = None
    ) -> None:
        super().__init__()
        self.window = window
        self._ended = ended

    def begin(self) -> None:
        """Let the window receive errors, media keys and its wish to be made anew."""
        window = self.window
        window.session.gateway.install()
        window.desktop.begin()
        window.looks.changed.connect(self.remake)
        if self._ended is not None:
            window.session.ended.connect(self._ended)

    def end(self) -> None:
        """Close the window."""
        self.window.session.gateway.uninstall()
        self.window.close()

    def remake(self) -> None:
        """Put a new window in the place of the old one."""
        old = self.window
        application = QCoreApplication.instance()
        assert isinstance(application, QApplication)
        old.player.pause()
        geometry, source = old.geometry(), old.player.source
        old.session.gateway.uninstall()
        old.hand_over()
        dress(application, old.settings)
        surface = VideoSurface()
        if source is not None:
            surface.set_clip_size(source.clip.width, source.clip.height)
        old.player.set_sink(SurfaceSink(surface))
        self.window = PlayerWindow(
            old.player,
            surface,
            old.clock,
            old.settings,
            plots=old.commands.plots.isChecked(),
        )
        self.window.setGeometry(geometry)
        self.window.show()
        self.begin()
        self.window.study_menu.take_over(old.study_menu)
        old.close()


def dress(application: QApplication, settings: Settings) -> None:
    """Give the application the look and the language of the settings."""
    languages.install(application, settings.text(LANGUAGE, languages.ENGLISH))
    theme.apply(application, settings.text(LOOK, theme.DARK))
