"""How far a long piece of work is, and the button that stops it."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QProgressBar

from app.bridge.jobs import JobState
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.labels import ElidedLabel
from app.widgets.texts import PERCENT, job_text

_PARTS = 1000
_AT_ONCE_S = 0.3


class JobBar(QFrame):
    """Title, step, progress and Cancel; hidden while nothing runs."""

    cancelled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setStyleSheet(
            f"JobBar {{ background: {theme.PANEL}; "
            f"border: 0; border-bottom: 1px solid {theme.BORDER}; }}"
        )
        self._since_s: float | None = None
        self._label = ElidedLabel()
        self._bar = QProgressBar()
        self._bar.setRange(0, _PARTS)
        self._bar.setFormat(PERCENT)
        self._bar.setFixedWidth(240)
        self._cancel = text_button(
            self.tr("Cancel"), self.tr("Stop this work; nothing is left behind")
        )
        self._cancel.clicked.connect(self._on_cancel)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 8, 6)
        row.setSpacing(12)
        row.addWidget(self._label, 1)
        row.addWidget(self._bar)
        row.addWidget(self._cancel)
        self.hide()

    def show_state(self, state: JobState | None, now_s: float) -> None:
        """Show how far the work is; what is done at once is not worth a line.

        Args:
            state: of the job, None while nothing runs.
            now_s: monotonic time.
        """
        if state is None:
            self._since_s = None
            self._cancel.setEnabled(True)
            self.hide()
            return
        if self._since_s is None:
            self._since_s = now_s
        text = job_text(state)
        self._label.set_text(text)
        self._bar.setValue(round(_PARTS * min(1.0, max(0.0, state.fraction))))
        self._bar.setAccessibleName(text)
        if self.isHidden() and now_s - self._since_s >= _AT_ONCE_S:
            self.show()

    def _on_cancel(self) -> None:
        self._cancel.setEnabled(False)
        self.cancelled.emit()
