"""A dialog with work beside it, which is looked at and stopped before it closes."""

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QDialog, QWidget

from app.bridge.jobs import Jobs
from app.widgets.layout import resize_within_screen

_POLL_MS = 40


class JobDialog(QDialog):
    """Runs one piece of work at a time; a page says in `poll` what it sees of it.

    Args:
        size_px: width and height, where the screen has room.
        parent: whom it belongs to.
    """

    def __init__(self, size_px: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        resize_within_screen(self, *size_px)
        self.jobs = Jobs(self.on_failed)
        self.is_leaving = False
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._on_tick)

    def begin(self) -> None:
        """Look at the work from now on: the page is made."""
        self._timer.start(_POLL_MS)

    def on_failed(self, problem: BaseException) -> None:
        """Tell what went wrong."""
        raise problem

    def poll(self) -> None:
        """Hand over what has been done, and show the rest."""
        self.jobs.poll()

    @property
    def is_working(self) -> bool:
        """Whether closing has to wait for something."""
        return self.jobs.is_busy

    def cancel_jobs(self) -> None:
        """Ask what runs to stop."""
        self.jobs.cancel()

    def close_jobs(self) -> None:
        """Stop what runs and wait for it."""
        self._timer.stop()
        self.jobs.close()

    def reject(self) -> None:
        """Close; work that runs is stopped first, without holding the window up."""
        self.is_leaving = True
        if self.is_working:
            self.cancel_jobs()
            self.hide()
        else:
            super().reject()

    def done(self, result: int) -> None:
        """Let nothing run on, nor begin."""
        self.is_leaving = True
        self.close_jobs()
        super().done(result)

    def _on_tick(self) -> None:
        self.poll()
        if self.is_leaving and not self.is_working:
            super().reject()
