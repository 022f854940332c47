"""Short texts on the picture: what a key has changed."""

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QLabel, QWidget

STAYS_MS = 1200
_MARGIN_PX = 14
_STYLE = """
QLabel { background: rgba(12, 14, 17, 215); color: #ffffff; border-radius: 6px;
  padding: 6px 12px; }
"""


class OnPicture(QLabel):
    """A box with a text in the upper left corner of another widget.

    Args:
        over: what it lies on; pointers and keys go through to it.
    """

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setStyleSheet(_STYLE)
        self.move(_MARGIN_PX, _MARGIN_PX)
        self.hide()

    def show_text(self, text: str) -> None:
        """Show a text, as large as it is."""
        if text != self.text():
            self.setText(text)
            self.setAccessibleName(text)
            self.adjustSize()
        self.show()
        self.raise_()


class Toast(OnPicture):
    """A text that goes by itself."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(STAYS_MS)
        self._timer.timeout.connect(self.hide)

    def show_text(self, text: str) -> None:
        """Show a text for a while."""
        super().show_text(text)
        self._timer.start()
