"""What the pictures of all pages are made with: an application, a ride, a folder."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from time import monotonic

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QApplication, QWidget

from app.bridge.settings import Settings
from hapticplayer.playback.source import Source
from tools.pages.material import Material

SETTLE_MS = 60  # layouts, fonts, one turn of every timer
PATIENCE_S = 30.0

Pictures = Iterator[tuple[str, QPixmap]]
"""(name, picture) of each page."""


@dataclass(frozen=True, slots=True)
class Stage:
    """One language and look.

    Attributes:
        application: dressed.
        settings: in memory; language and look are in them.
        source: the demo.
        material: rides, logs and studies, the same for every stage.
        folder: of its own, for what has to be written.
        language: its code.
    """

    application: QApplication
    settings: Settings
    source: Source
    material: Material
    folder: Path
    language: str

    def wait(self, for_ms: int = SETTLE_MS) -> None:
        """Let the event loop run."""
        loop = QEventLoop()
        QTimer.singleShot(for_ms, loop.quit)
        loop.exec()

    def wait_until(self, is_true: Callable[[], bool]) -> None:
        """Let the event loop run until something is so; give up after half a minute."""
        end_s = monotonic() + PATIENCE_S
        while not is_true():
            if monotonic() > end_s:
                raise TimeoutError(f"{is_true} did not come true")
            self.wait(30)

    def picture(self, widget: QWidget, for_ms: int = SETTLE_MS) -> QPixmap:
        """Show a widget, wait, and return what it looks like."""
        widget.show()
        self.wait(for_ms)
        return widget.grab()

    def asked(self, ask: Callable[[], object]) -> QPixmap:
        """A picture of a question that stops the event loop, declined."""
        seen = []

        def look() -> None:
            box = self.application.activeModalWidget()
            if box is None:
                QTimer.singleShot(SETTLE_MS, look)
            else:
                seen.append(box.grab())
                box.close()

        QTimer.singleShot(SETTLE_MS, look)
        ask()
        return seen[0]

    @contextmanager
    def shown(self, widget: QWidget) -> Iterator[QWidget]:
        """Show a dialog; closed afterwards."""
        widget.show()
        self.wait()
        yield widget
        widget.close()
        self.wait()
