"""Looks beside the window for what there is on the machine: that may take its time."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal

from app.bridge.jobs import Jobs, Progress

POLL_MS = 50


class Beside(QObject):
    """Looks when asked to; remembers what it has found.

    Args:
        work: returns names; called in a thread.
        parent: Qt's owner.

    Signals:
        changed: there is something else than before.
    """

    changed = Signal()

    def __init__(
        self, work: Callable[[Progress], list[str]], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.found: list[str] = []
        self._work = work
        self._jobs = Jobs(lambda _problem: self._take([]))
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)

    @property
    def is_busy(self) -> bool:
        """Whether it looks now."""
        return self._jobs.is_busy

    def look(self) -> None:
        """Begin to look, unless that is being done."""
        if not self._jobs.is_busy:
            self._jobs.run("", self._work, self._take)
            self._timer.start()

    def close(self) -> None:
        """Wait until nothing is looked for."""
        self._timer.stop()
        self._jobs.close()

    def _poll(self) -> None:
        self._jobs.poll()
        if not self._jobs.is_busy:
            self._timer.stop()

    def _take(self, found: list[str]) -> None:
        if found != self.found:
            self.found = found
            self.changed.emit()
