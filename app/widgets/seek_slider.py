"""The bar under the picture: where the clip is, and where it shall go."""

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractSlider, QSizePolicy, QSlider, QWidget

from app.widgets import theme

_HEIGHT_PX = 26
_GROOVE_PX = 6.0
_HANDLE_PX = 8.0
_STEP_MS, _PAGE_MS = 1_000, 10_000


class SeekSlider(QSlider):
    """A slider in milliseconds: a click jumps, a drag scrubs, the arrows step.

    It is painted by hand: ten times a second a style sheet would cost more than
    the picture.
    """

    sought = Signal(float)
    """A person wants to be at this time, s."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setOrientation(Qt.Orientation.Horizontal)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setSingleStep(_STEP_MS)
        self.setPageStep(_PAGE_MS)
        self._painted_px = -1

    def set_duration(self, duration_s: float) -> None:
        """Say how long the clip is, s."""
        self.setRange(0, max(0, round(1e3 * duration_s)))
        self.setEnabled(duration_s > 0.0)

    def follow(self, media_s: float) -> None:
        """Show where the clip is, unless a person holds the handle."""
        if not self.isSliderDown():
            self.blockSignals(True)
            self.setValue(round(1e3 * media_s))
            self.blockSignals(False)

    def sizeHint(self) -> QSize:
        """Return a comfortable size."""
        return QSize(300, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the smallest size that can be aimed at."""
        return QSize(80, _HEIGHT_PX)

    def sliderChange(self, change: QAbstractSlider.SliderChange) -> None:  # noqa: N802
        """Paint only when the handle moves by a pixel."""
        is_value = change == QAbstractSlider.SliderChange.SliderValueChange
        if not is_value or round(self._handle_x()) != self._painted_px:
            self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Jump to where the click is."""
        if event.button() == Qt.MouseButton.LeftButton and self.maximum() > 0:
            self.setSliderDown(True)
            self._go(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Scrub."""
        if self.isSliderDown():
            self._go(event.position().x())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.setSliderDown(False)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Step with the keys."""
        before = self.value()
        super().keyPressEvent(event)
        if self.value() != before:
            self.sought.emit(1e-3 * self.value())

    def _go(self, x_px: float) -> None:
        span_px = max(1.0, self.width() - 2 * _HANDLE_PX)
        share = min(1.0, max(0.0, (x_px - _HANDLE_PX) / span_px))
        value = round(share * self.maximum())
        if value != self.value():
            self.setValue(value)
            self.sought.emit(1e-3 * value)

    def _handle_x(self) -> float:
        share = self.value() / self.maximum() if self.maximum() else 0.0
        return _HANDLE_PX + share * (self.width() - 2 * _HANDLE_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the groove, what has been played, and the handle."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        x, middle = self._handle_x(), self.height() / 2
        self._painted_px = round(x)
        groove = QRectF(_HANDLE_PX, middle - _GROOVE_PX / 2, 0, _GROOVE_PX)
        for right, colour in ((self.width() - _HANDLE_PX, theme.BORDER), (x, None)):
            groove.setRight(right)
            painter.setBrush(QColor(colour or theme.ACCENT))
            painter.drawRoundedRect(groove, _GROOVE_PX / 2, _GROOVE_PX / 2)
        if self.isEnabled():
            painter.setBrush(QColor(theme.TEXT))
            if self.hasFocus():
                painter.setPen(QPen(QColor(theme.ACCENT), 3))
            painter.drawEllipse(QPointF(x, middle), _HANDLE_PX - 1, _HANDLE_PX - 1)
