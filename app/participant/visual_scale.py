"""A line on which a mark is set by mouse, touch or keys; there is none at first."""

from collections.abc import Mapping

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QSlider

from app.widgets import theme

_TOUCH_PX, _WIDE_PX = 44, 240
_LINE, _TICK, _MARK = 0.10, 0.35, 0.42  # of a letter: line, half a tick, radius
_PAGE = 10
_KEYS = (
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Home, Qt.Key.Key_End),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
)


class VisualScale(QSlider):
    """A slider without a starting mark.

    Args:
        limits: values of the ends.
        labels: of points, drawn below them.
    """

    marked = Signal()

    def __init__(self, limits: tuple[int, int], labels: Mapping[int, str]) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.is_marked = False
        self._labels = labels
        self.setRange(*limits)
        self.setPageStep(_PAGE)
        self.setValue(sum(limits) // 2)  # from where the arrows start
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        policy = QSizePolicy.Policy
        self.setSizePolicy(policy.Expanding, policy.Fixed)

    def mark(self, value: int) -> None:
        """Set the mark."""
        self.is_marked = True
        self.setValue(value)
        self.update()
        self.marked.emit()

    # --- what a person does --------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._take(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._take(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.accept()

    def _take(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            share = (event.position().x() - self._line().left()) / self._line().width()
            share = min(1.0, max(0.0, share))
            span = self.maximum() - self.minimum()
            self.mark(self.minimum() + round(share * span))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Leave Up, Down, Enter and digits to the page."""
        if event.key() not in _KEYS:
            event.ignore()
            return
        super().keyPressEvent(event)
        self.mark(self.value())

    # --- how it looks --------------------------------------------------------------

    def sizeHint(self) -> QSize:
        """Two letters high, and a line of labels."""
        letter_px = self.fontMetrics().height()
        high_px = max(_TOUCH_PX, round(1.6 * letter_px))
        return QSize(_WIDE_PX, high_px + (letter_px if self._labels else 0))

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def _line(self) -> QRectF:
        """The line, with room for the mark at both ends."""
        letter_px = float(self.fontMetrics().height())
        aside_px = _MARK * letter_px + 4.0
        high_px = self.height() - (letter_px if self._labels else 0.0)
        thick_px = max(3.0, _LINE * letter_px)
        wide_px = self.width() - 2.0 * aside_px
        return QRectF(aside_px, 0.5 * (high_px - thick_px), wide_px, thick_px)

    def _at(self, value: int) -> QPointF:
        line = self._line()
        share = (value - self.minimum()) / (self.maximum() - self.minimum())
        return QPointF(line.left() + share * line.width(), line.center().y())

    def paintEvent(self, _event: QPaintEvent) -> None:
        line, letter_px = self._line(), self.fontMetrics().height()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(line, QColor(theme.DIM))
            painter.setPen(QPen(QColor(theme.DIM), line.height()))
            for value in (self.minimum(), self.maximum(), *self._labels):
                at, half = self._at(value), QPointF(0.0, _TICK * letter_px)
                painter.drawLine(at - half, at + half)
            painter.setPen(QColor(theme.TEXT))
            for value, text in self._labels.items():
                painter.drawText(self._under(value, text), text)
            if self.is_marked:
                painter.setPen(QPen(QColor(theme.TEXT), 2.0))
                painter.setBrush(QColor(theme.PRIMARY))
                radius_px = _MARK * letter_px
                painter.drawEllipse(self._at(self.value()), radius_px, radius_px)
            if self.hasFocus():
                painter.setPen(QPen(QColor(theme.FOCUS), 3.0))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                frame = QRectF(self.rect()).adjusted(2, 2, -2, -2)
                painter.drawRoundedRect(frame, 8.0, 8.0)

    def _under(self, value: int, text: str) -> QPointF:
        """Where a label begins: centred, but not over the edge."""
        wide_px = self.fontMetrics().horizontalAdvance(text)
        left_px = self._at(value).x() - wide_px / 2.0
        left_px = min(max(0.0, left_px), self.width() - wide_px)
        return QPointF(left_px, self.height() - self.fontMetrics().descent() - 2.0)
