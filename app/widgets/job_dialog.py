"""A dialog with work beside it, which is looked at and stopped before it closes."""

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QDialog, QWidget

from app.bridge.jobs import Jobs
from app.widgets.layout import resize_within_screen
from app.widgets.messages import JobRow, StatusLine

_POLL_MS = 40


class JobDialog(QDialog):
    """Runs one piece of work at a time, in `jobs`.

    A page makes `progress`, the row of its work, and `status`, the line of its outcome,
    or says in `poll` and `on_failed` what it shows instead.

    Args:
        size_px: width and height, where the screen has room.
        parent: whom it belongs to.
    """

    progress: JobRow
    status: StatusLine

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
        self.status.show_problem(problem)

    def poll(self) -> None:
        """Show how far the work is, and what came of it."""
        is_over = self.jobs.poll()
        self.progress.show_state(self.jobs.state())
        if is_over:
            self.show_buttons()

    def show_buttons(self) -> None:
        """Show what can be done now; called when nothing runs any more."""

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
