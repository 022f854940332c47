"""The place where the window says what went wrong."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QGuiApplication,
    QResizeEvent,
)
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QSizePolicy

from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.buttons import text_button

_LONGEST = 600


class MessageBar(QFrame):
    """One message, until it is closed or another one comes."""

    def __init__(self) -> None:
        super().__init__()
        self.setStyleSheet(
            f"MessageBar {{ background: {theme.ALARM}; "
            f"border: 0; border-bottom: 1px solid {theme.BAD}; }}"
        )
        self._message = ""
        self._sign = QLabel("\u25a0")  # the same sign as "bad" in the health line
        self._sign.setStyleSheet(f"color: {theme.BAD};")
        self._text = QLabel()
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setWordWrap(True)
        # a long path must neither widen the window nor be cut off
        self._text.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._close = text_button(self.tr("Close"), self.tr("Hide this message"))
        self._close.clicked.connect(self.hide)
        self.copy = text_button(
            self.tr("Copy"), self.tr("Copy it, in English too, to report")
        )
        self.copy.clicked.connect(self._copy)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 8, 6)
        row.addWidget(self._sign, 0)
        row.addWidget(self._text, 1)
        row.addWidget(self.copy, 0)
        row.addWidget(self._close, 0)
        self.hide()

    def minimumSizeHint(self) -> QSize:
        """Return the room for all lines at this width; a label guesses too many."""
        least, row = super().minimumSizeHint(), self.layout()
        if row is None or not row.hasHeightForWidth():
            return least
        return QSize(
            least.width(), row.totalHeightForWidth(max(least.width(), self.width()))
        )

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another width may need another line."""
        super().resizeEvent(event)
        self.updateGeometry()

    def text(self) -> str:
        """Return what it says, "" while hidden."""
        return "" if self.isHidden() else translated(self._message)

    def show_text(self, message: str) -> None:
        """Say something in the window's language, also to a screen reader."""
        self._message, text = message, translated(message)
        shown = text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "\u2026"
        self._text.setText(breakable(shown))
        self.setAccessibleName(text)
        self.show()
        QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.Alert))

    def _copy(self) -> None:
        said = dict.fromkeys((self.text(), self._message))  # once where it is English
        QGuiApplication.clipboard().setText("\n".join(said))


def breakable(text: str) -> str:
    """Return the text with places where a long path may be broken."""
    return text.replace("/", "/\u200b").replace("_", "_\u200b")
