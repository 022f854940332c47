"""Which Falcons are plugged in, asked for beside the window: the bus may take its time."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal

from app.bridge.jobs import Jobs, Progress
from hapticplayer.devices.falcon.transport import list_falcons

POLL_MS = 50


class Plugged(QObject):
    """Looks when asked to; remembers what it has found.

    Args:
        look: returns the serial numbers, "" for those that may not be read.
        parent: Qt's owner.

    Signals:
        changed: others are plugged in than before.
    """

    changed = Signal()

    def __init__(
        self,
        look: Callable[[], list[str]] | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.serials: list[str] = []
        self._look = look or _serials
        self._jobs = Jobs(lambda _problem: self._take([]))
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)

    def look(self) -> None:
        """Begin to look, unless that is being done."""
        if not self._jobs.is_busy:
            self._jobs.run("", self._work, self._take)
            self._timer.start()

    @property
    def is_busy(self) -> bool:
        """Whether it looks now."""
        return self._jobs.is_busy

    def close(self) -> None:
        """Wait until nothing is looked for."""
        self._timer.stop()
        self._jobs.close()

    def falcons(self) -> list[tuple[str, str]]:
        """Return (the engine's name, the serial number) of each Falcon to choose.

        The only one, or none, is `falcon`; its number may be "".
        """
        numbers = sorted(filter(None, self.serials))
        if len(numbers) > 1:
            return [(f"falcon:{number}", number) for number in numbers]
        return [("falcon", "".join(numbers))]

    def _work(self, _progress: Progress) -> list[str]:
        return self._look()

    def _poll(self) -> None:
        self._jobs.poll()
        if not self._jobs.is_busy:
            self._timer.stop()

    def _take(self, serials: list[str]) -> None:
        if serials != self.serials:
            self.serials = serials
            self.changed.emit()


def _serials() -> list[str]:
    return [found.serial for found in list_falcons()]
