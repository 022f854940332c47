"""Pointer and keys on a plot: wheel zooms, a drag pans, a click jumps, hover reads."""

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPen, QWheelEvent

from app.widgets import theme
from app.widgets.texts import local

if TYPE_CHECKING:
    from app.plots.playhead_plot import PlayheadPlot

translate = QCoreApplication.translate

ZOOM_STEP = 1.25
_CLICK_PX = 4.0
_PAN_SHARE = 0.25
_LINE_PX, _PLATE_PX = 16.0, 6.0


class PlotPointer(QObject):
    """Watches the events of one plot, whose view is changed and read."""

    def __init__(self, plot: "PlayheadPlot") -> None:
        super().__init__(plot)
        self._plot = plot
        self.hover_px: float | None = None
        self._pressed_px: float | None = None
        self._dragged_px = 0.0
        plot.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        plot.setToolTip(
            translate(
                "PlotPanel",
                "Click: seek. Drag: pan. Wheel or + and \u2212: zoom. Double-click "
                "or Enter: reset",
            )
        )
        plot.viewport().setMouseTracking(True)

    def takes_key(self, event: QEvent) -> bool:
        """Do what a key means for the view; False for what it does not know."""
        return isinstance(event, QKeyEvent) and self._on_key(event)

    def takes(self, event: QEvent) -> bool:
        """Do what the pointer means for the view."""
        if isinstance(event, QWheelEvent):
            steps = event.angleDelta().y() / 120.0
            self._plot.span.zoom(ZOOM_STEP ** (-steps))
            return True
        if event.type() == QEvent.Type.Leave:
            self._hover(None)
        return self._on_mouse(event) if isinstance(event, QMouseEvent) else False

    def _on_mouse(self, event: QMouseEvent) -> bool:
        kind, x_px = event.type(), event.position().x()
        if kind == QEvent.Type.MouseMove:
            self._move(x_px)
        elif event.button() != Qt.MouseButton.LeftButton:
            return False
        elif kind == QEvent.Type.MouseButtonPress:
            self._pressed_px, self._dragged_px = x_px, 0.0
        elif kind == QEvent.Type.MouseButtonDblClick:
            self._pressed_px = None
            self._plot.span.reset()
        elif kind == QEvent.Type.MouseButtonRelease and self._pressed_px is not None:
            self._pressed_px = None
            if self._dragged_px <= _CLICK_PX:
                self._plot.sought.emit(max(0.0, self._plot.time_at(x_px)))
        return True

    def _move(self, x_px: float) -> None:
        if self._pressed_px is not None:
            self._dragged_px += abs(x_px - self._pressed_px)
            if self._dragged_px > _CLICK_PX:
                plot = self._plot
                plot.span.pan(plot.time_at(self._pressed_px) - plot.time_at(x_px))
            self._pressed_px = x_px
        self._hover(x_px)

    def _hover(self, x_px: float | None) -> None:
        if x_px != self.hover_px:
            self.hover_px = x_px
            self._plot.viewport().update()

    def _on_key(self, event: QKeyEvent) -> bool:
        if event.type() not in (QEvent.Type.KeyPress, QEvent.Type.ShortcutOverride):
            return False
        span, keys = self._plot.span, Qt.Key
        action: Any = {
            keys.Key_Plus: lambda: span.zoom(1.0 / ZOOM_STEP),
            keys.Key_Minus: lambda: span.zoom(ZOOM_STEP),
            keys.Key_Left: lambda: span.pan(-_PAN_SHARE * span.half_s),
            keys.Key_Right: lambda: span.pan(_PAN_SHARE * span.half_s),
            keys.Key_Return: span.reset,
        }.get(Qt.Key(event.key()))
        if action is None:
            return False
        event.accept()
        if event.type() == QEvent.Type.KeyPress:
            action()
        return True

    def paint(self, painter: QPainter, box: QRectF) -> None:
        """Draw the line and the values under the pointer, and the focus."""
        if self._plot.hasFocus():
            painter.setPen(QPen(QColor(theme.FOCUS), 2.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(box.adjusted(1, 1, -1, -1))
        x_px = self.hover_px
        if x_px is None or not box.left() <= x_px <= box.right():
            return
        painter.fillRect(QRectF(x_px, box.top(), 1, box.height()), QColor(theme.FOCUS))
        media_s = self._plot.time_at(x_px)
        if media_s < 0.0:
            return
        self._paint_words(painter, box, x_px, self.words(media_s))

    def words(self, media_s: float) -> list[tuple[str, str]]:
        """Return (text, colour) of the lines of the read-out."""
        lines = [(local(f"{media_s:.3f} s"), theme.TEXT)]
        groups = self._plot.values_at(media_s)
        for axis, colour in enumerate(theme.AXIS_COLOURS):
            values = "  ".join(f"{group[axis]:+.2f}" for group in groups)
            if values:
                lines.append((local(f"{'xyz'[axis]} {values}"), colour))
        return lines

    def _paint_words(
        self,
        painter: QPainter,
        box: QRectF,
        x_px: float,
        lines: list[tuple[str, str]],
    ) -> None:
        metrics = painter.fontMetrics()
        wide = max(metrics.horizontalAdvance(text) for text, _ in lines)
        room = QRectF(0, 0, wide + 2 * _PLATE_PX, _LINE_PX * len(lines) + _PLATE_PX)
        left = x_px + 8.0
        if left + room.width() > box.right():
            left = x_px - 8.0 - room.width()
        room.moveTopLeft(QPointF(left, box.top() + 2.0))
        plate = QColor(theme.PANEL)
        plate.setAlpha(230)
        painter.fillRect(room, plate)
        for row, (text, colour) in enumerate(lines):
            painter.setPen(QColor(colour))
            painter.drawText(
                QPointF(
                    left + _PLATE_PX,
                    room.top() + (row + 0.8) * _LINE_PX + 1.0,
                ),
                text,
            )
