"""The open window, rebuilt for another theme or language.

A widget takes its texts and colours when it is made. So another theme or language
needs another window around the same player. It is made in steps, a part at each turn of
the event loop, while the clip plays on in the window before.
"""

from collections.abc import Callable, Iterator

from PySide6.QtCore import QCoreApplication, QObject, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from app.bridge import languages
from app.bridge.collector import Collector
from app.bridge.settings import LANGUAGE, THEME, Settings
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.widgets import theme

PAUSE_MS = 10
"""Between two steps: frames are shown."""
POLISHED = 40
"""Widgets in one step: each takes 0.1 to 0.2 ms."""


class OpenWindow(QObject):
    """Holds the window, and replaces it when it asks for that.

    `ended` is called when the clip of any of them has come to its end.
    """

    def __init__(
        self, window: PlayerWindow, ended: Callable[[], None] | None = None
    ) -> None:
        super().__init__()
        self.window = window
        self._ended = ended
        self._collector = Collector(self)
        self._next: PlayerWindow | None = None
        self._steps: Iterator[None] | None = None
        self._is_stale = False  # the settings have changed meanwhile
        self._cadence = QTimer(self, interval=PAUSE_MS)
        self._cadence.timeout.connect(self._go_on)

    @property
    def is_remaking(self) -> bool:
        return self._steps is not None

    def begin(self) -> None:
        """Connect errors, media keys and requests for a rebuild."""
        self._collector.begin()
        self._attach()

    def end(self) -> None:
        """Close the window."""
        self._rest()
        self.window.session.gateway.uninstall()
        self.window.close()
        self._collector.end()

    def remake(self) -> None:
        """Put a new window in the place of the old one, soon."""
        self._is_stale = self.is_remaking
        if not self.is_remaking:
            self._steps = self._in_steps()
            self._cadence.start()

    def _attach(self) -> None:
        window = self.window
        window.session.gateway.install()
        window.desktop.begin()
        window.themes.changed.connect(self.remake)
        if self._ended is not None:
            window.session.ended.connect(self._ended)

    def _go_on(self) -> None:
        if self._steps is None or self.window.is_over:
            self._rest()
            return
        try:
            next(self._steps)
        except StopIteration:
            self._rest()
            if self._is_stale:
                self.remake()
        except BaseException:
            self._rest()
            self.window.freeze_painting(is_wanted=False)
            raise

    def _rest(self) -> None:
        self._cadence.stop()
        self._steps = None
        self._drop_next()

    def _drop_next(self) -> None:
        if self._next is not None:
            self._next.hand_over()
            self._next.deleteLater()
            self._next = None

    def _in_steps(self) -> Iterator[None]:
        old = self.window
        old.session.jobs.cancel()
        old.extras.thumbnails.forget()
        yield from _until_idle(old)
        old.freeze_painting(is_wanted=True)
        yield from appearance_in_steps(_application(), old.settings)
        surface, source = VideoSurface(), old.player.snapshot().source
        made = self._next = PlayerWindow(
            old.player, surface, old.clock, old.settings, plots=False, waits=True
        )
        yield
        if old.commands.plots.isChecked():
            yield from made.plots.in_steps()
            made.show_plots(are_wanted=True)
            yield
        made.setGeometry(old.geometry())
        for number, widget in enumerate(made.findChildren(QWidget)):
            widget.ensurePolished()
            if number % POLISHED == 0:
                yield
        yield from _until_idle(old)  # something may have been opened
        self._exchange(old, made)
        if (current := old.player.snapshot().source) is not source:
            made.session.opening.emit(current)
            made.session.opened.emit()
        yield
        old.deleteLater()

    def _exchange(self, old: PlayerWindow, made: PlayerWindow) -> None:
        """Show the new window, which takes over from the old one."""
        geometry, is_maximised = old.geometry(), old.isMaximized()
        old.session.gateway.uninstall()
        old.hand_over()
        self.window, self._next = made, None
        if (frame := old.surface.frame) is not None:
            made.surface.present(frame)  # until the next one comes
        made.player.set_sink(SurfaceSink(made.surface))
        made.setGeometry(geometry)
        if is_maximised:
            made.showMaximized()
        else:
            made.show()
        made.begin()
        self._attach()
        made.study_menu.take_over(old.study_menu)
        old.close()


def _until_idle(window: PlayerWindow) -> Iterator[None]:
    """Wait for what `hand_over` would wait for; people use the window meanwhile."""
    while window.is_working:
        window.freeze_painting(is_wanted=False)
        yield


def apply_appearance(application: QApplication, settings: Settings) -> None:
    for _ in appearance_in_steps(application, settings):
        pass


def appearance_in_steps(
    application: QApplication, settings: Settings
) -> Iterator[None]:
    """Do so, a part at each turn."""
    languages.install(application, settings.text(LANGUAGE, languages.SYSTEM))
    yield
    theme.apply(application, settings.text(THEME, theme.DARK))
    yield


def _application() -> QApplication:
    application = QCoreApplication.instance()
    assert isinstance(application, QApplication)
    return application
