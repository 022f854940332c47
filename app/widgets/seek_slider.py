"""The seek bar: position of the clip, and where to go."""

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QAbstractSlider, QSizePolicy, QSlider, QWidget

from app.widgets import theme
from app.widgets.texts import position_text

_HEIGHT_PX = 32
_GROOVE_PX = 6.0
_HANDLE_PX = 8.0
_HEAT_PX, _MARK_PX = 5.0, 2.0
_STEP_MS, _PAGE_MS = 1_000, 10_000


class SeekSlider(QSlider):
    """A slider in milliseconds: a click jumps, a drag scrubs, the arrows step.

    It is painted by hand: ten times a second a style sheet would cost more than
    the video.
    """

    sought = Signal(float)
    """A person wants to be at this time, s."""

    hovered = Signal(float)
    """The pointer is at this time, s; negative when it has left."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setOrientation(Qt.Orientation.Horizontal)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setSingleStep(_STEP_MS)
        self.setPageStep(_PAGE_MS)
        self._painted_px = self._told_s = -1
        self.heat: QImage | None = None
        self.marks_s: tuple[float, ...] = ()
        self.setMouseTracking(True)

    def set_duration(self, duration_s: float) -> None:
        """Say how long the clip is, s."""
        self.setRange(0, max(0, round(1e3 * duration_s)))
        self._told_s = -1
        self.setEnabled(duration_s > 0.0)

    def set_heat(self, heat: QImage | None) -> None:
        """Show a strip under the bar, one row of pixels over the whole clip."""
        self.heat = heat
        self.update()

    def set_marks(self, marks_s: tuple[float, ...]) -> None:
        """Show where a loop begins and ends."""
        if marks_s != self.marks_s:
            self.marks_s = marks_s
            self.update()

    def follow(self, media_s: float) -> None:
        """Show where the clip is, unless a person holds the handle."""
        if not self.isSliderDown():
            self.blockSignals(True)
            self.setValue(round(1e3 * media_s))
            self.blockSignals(False)
            if not self.hasFocus():  # a reader who is here would hear every second
                self._describe()

    def _describe(self) -> None:
        """Say the time in words: its value is in milliseconds."""
        now_s = self.value() // 1000
        if now_s != self._told_s:
            self._told_s = now_s
            said = position_text(1e-3 * self.value(), 1e-3 * self.maximum())
            self.setAccessibleDescription(said)

    def sizeHint(self) -> QSize:
        return QSize(300, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        return QSize(80, _HEIGHT_PX)

    def sliderChange(self, change: QAbstractSlider.SliderChange) -> None:  # noqa: N802
        """Paint only when the handle moves by a pixel."""
        is_value = change == QAbstractSlider.SliderChange.SliderValueChange
        if not is_value or round(self._handle_x()) != self._painted_px:
            self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self.maximum() > 0:
            self.setSliderDown(True)
            self._go(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.isSliderDown():
            self._go(event.position().x())
        if self.maximum() > 0:
            self.hovered.emit(1e-3 * self._value_at(event.position().x()))

    def leaveEvent(self, event: QEvent) -> None:
        self.hovered.emit(-1.0)
        super().leaveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.setSliderDown(False)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self._describe()
        super().focusInEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        before = self.value()
        super().keyPressEvent(event)
        if self.value() != before:
            self._describe()
            self.sought.emit(1e-3 * self.value())

    def _go(self, x_px: float) -> None:
        value = self._value_at(x_px)
        if value != self.value():
            self.setValue(value)
            self.sought.emit(1e-3 * value)

    def _value_at(self, x_px: float) -> int:
        span_px = max(1.0, self.width() - 2 * _HANDLE_PX)
        share = min(1.0, max(0.0, (x_px - _HANDLE_PX) / span_px))
        return round(share * self.maximum())

    def x_of(self, media_s: float) -> float:
        """Return where a time lies, px."""
        share = 1e3 * media_s / self.maximum() if self.maximum() else 0.0
        return _HANDLE_PX + share * (self.width() - 2 * _HANDLE_PX)

    def _handle_x(self) -> float:
        return self.x_of(1e-3 * self.value())

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        x, middle = self._handle_x(), self.height() / 2 - _HEAT_PX / 2
        self._painted_px = round(x)
        groove = QRectF(_HANDLE_PX, middle - _GROOVE_PX / 2, 0, _GROOVE_PX)
        for right, colour in ((self.width() - _HANDLE_PX, theme.BORDER), (x, None)):
            groove.setRight(right)
            painter.setBrush(QColor(colour or theme.ACCENT))
            painter.drawRoundedRect(groove, _GROOVE_PX / 2, _GROOVE_PX / 2)
        self._paint_extras(painter)
        painter.setPen(Qt.PenStyle.NoPen)
        if self.isEnabled():
            painter.setBrush(QColor(theme.TEXT))
            if self.hasFocus():
                painter.setPen(QPen(QColor(theme.ACCENT), 3))
            painter.drawEllipse(QPointF(x, middle), _HANDLE_PX - 1, _HANDLE_PX - 1)

    def _paint_extras(self, painter: QPainter) -> None:
        """Draw the strip under the groove, and the marks of a loop through both."""
        span_px, bottom = self.width() - 2 * _HANDLE_PX, self.height() - 1.0
        if self.heat is not None:
            strip = QRectF(_HANDLE_PX, bottom - _HEAT_PX, span_px, _HEAT_PX)
            painter.drawImage(strip, self.heat)
        painter.setBrush(QColor(theme.WARN))
        for mark_s in self.marks_s:
            painter.drawRect(QRectF(self.x_of(mark_s) - 1, 2, _MARK_PX, bottom - 2))
