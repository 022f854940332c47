"""One plot whose middle is the playhead, drawn as cheaply as pyqtgraph can.

Its own time axis costs 25 ms for each step of a moving view; here the ticks are
painted by hand, only the view's transform changes, and it changes before painting
(otherwise everything is painted twice): 1.5 ms instead of 15 ms for each plot.
"""

import math
import os
from typing import Any

os.environ.setdefault("PYQTGRAPH_QT_LIB", "PySide6")

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import (
    QCoreApplication,
    QEvent,
    QObject,
    QPointF,
    QRectF,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPen,
    QResizeEvent,
    QWheelEvent,
)

from app.plots.series import EMPTY, PAGE_MARGIN_S, Page, ViewSpan, cut
from app.widgets import theme
from app.widgets.texts import local

translate = QCoreApplication.translate

_TICKS_S = (0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0)
_TICKS = 5  # about, in a view
_AXIS_WIDTH_PX = 46
_LABELS_PX = 18
ZOOM_STEP = 1.25
_CLICK_PX = 4.0
_PAN_SHARE = 0.25
_LINE_PX, _PLATE_PX = 16.0, 6.0


_EVERYWHERE = QRectF(-1e7, -1e7, 2e7, 2e7)


class _Line(pg.PlotCurveItem):
    """A curve whose bounds nobody asks for: finding them costs as much as drawing."""

    def boundingRect(self) -> QRectF:  # noqa: N802 - Qt's name
        """Return a rectangle that is always in view."""
        return _EVERYWHERE

    def viewTransformChanged(self) -> None:  # noqa: N802 - pyqtgraph's name
        """Keep the bounds."""


class PlayheadPlot(pg.PlotWidget):
    """Three lines for each group, over the seconds around the playhead.

    Each group has its pen width; later ones lie on top. The span of seconds is shared
    by plots that go together.
    """

    sought = Signal(float)
    """A person wants to be at this time, s."""

    def __init__(
        self, name: str, widths_px: tuple[float, ...], span: ViewSpan | None = None
    ) -> None:
        super().__init__(background=theme.PANEL, enableMenu=False)
        self.setAccessibleName(name)
        self.setFrameShape(pg.QtWidgets.QFrame.Shape.NoFrame)
        self.setMinimumSize(120, 80)
        # everything moves, and the times are no items of the scene
        self.setViewportUpdateMode(self.ViewportUpdateMode.FullViewportUpdate)
        self.setCacheMode(self.CacheModeFlag.CacheNone)
        self.notice = ""
        self._media_s = 0.0
        self.span = span or ViewSpan()
        self.page_s = (math.inf, -math.inf)  # what the lines cover
        self.view_box: Any = self.getPlotItem().getViewBox()
        self._set_up_item(self.getPlotItem())
        self.curve_groups = [self._make_group(width) for width in widths_px]
        self.pointer = PlotPointer(self)
        self.set_playhead(0.0)

    def _set_up_item(self, item: Any) -> None:
        item.hideButtons()
        for side in ("bottom", "top", "right"):
            item.getAxis(side).unlinkFromView()
            item.hideAxis(side)
        left = item.getAxis("left")
        left.enableAutoSIPrefix(False)
        left.setWidth(_AXIS_WIDTH_PX)
        left.setTextPen(theme.DIM)
        left.setPen(theme.BORDER)
        left.setStyle(tickFont=self.font(), maxTickLevel=0)
        # it stands still: painted anew with each frame it took an eighth of the time
        left.setCacheMode(left.CacheMode.DeviceCoordinateCache)
        item.layout.setContentsMargins(0, 8, 8, _LABELS_PX)
        self.view_box.setMouseEnabled(False, False)
        self.view_box.disableAutoRange()

    def _make_group(self, width_px: float) -> list[Any]:
        curves = []
        width_px *= self.devicePixelRatioF()  # pens are in the screen's own pixels
        for colour in theme.AXIS_COLOURS:
            curve = _Line(pen=pg.mkPen(colour, width=width_px))
            self.view_box.addItem(curve, ignoreBounds=True)
            curves.append(curve)
        return curves

    def set_half_range(self, value: float) -> None:
        """Show values from minus to plus this one, with five ticks."""
        self.view_box.setYRange(-value, value, padding=0.04)
        ticks = [(k * value / 2, local(f"{k * value / 2:g}")) for k in range(-2, 3)]
        self.getPlotItem().getAxis("left").setTicks([ticks])

    def set_notice(self, text: str) -> None:
        """Say something in the place of lines."""
        self.notice = text
        self.viewport().update()

    def set_lines(self, group: int, page: Page) -> None:
        for axis, curve in enumerate(self.curve_groups[group]):
            curve.setData(page.time_s, page.values[:, axis])

    def new_page(self, media_s: float) -> tuple[float, float] | None:
        """Return the span to redraw, None while the present page covers the view."""
        first_s, last_s = self.span.around(media_s)
        if self.page_s[0] <= first_s and last_s <= self.page_s[1]:
            return None
        self.page_s = (first_s - PAGE_MARGIN_S, last_s + PAGE_MARGIN_S)
        return self.page_s

    def forget_page(self) -> None:
        """Draw the next page whatever the view is."""
        self.page_s = (math.inf, -math.inf)

    def set_playhead(self, media_s: float) -> None:
        """Move the middle of the view to a media time."""
        self._media_s = media_s
        self.view_box.setXRange(*self.span.around(media_s), padding=0)
        self.view_box.updateMatrix()  # now, not in the middle of painting

    def spoken(self) -> str:
        """The values at the playhead."""
        words = self.pointer.words(self._media_s)
        return self.notice or ", ".join(text for text, _ in words)

    def drawBackground(self, painter: QPainter, rect: QRectF) -> None:  # noqa: N802
        super().drawBackground(painter, rect)
        painter.save()
        painter.resetTransform()
        box: QRectF = self.view_box.sceneBoundingRect()
        # filled rectangles: a line of the painter takes 60 us, these take 5
        for tick_s in self._ticks():
            painter.fillRect(_upright(box, self._x(box, tick_s)), QColor(theme.GRID))
        middle = QRectF(box.left(), round(box.center().y()), box.width(), 1)
        painter.fillRect(middle, QColor(theme.ZERO))
        painter.restore()

    def drawForeground(self, painter: QPainter, _rect: QRectF) -> None:  # noqa: N802
        painter.save()
        painter.resetTransform()
        box: QRectF = self.view_box.sceneBoundingRect()
        painter.setPen(QColor(theme.DIM))
        row = QRectF(0, box.bottom() + 1, 80, _LABELS_PX)
        for tick_s in self._ticks():
            row.moveLeft(self._x(box, tick_s) - row.width() / 2)
            if row.left() >= 0 and row.right() <= self.width():
                painter.drawText(row, Qt.AlignmentFlag.AlignCenter, clock_text(tick_s))
        if self.notice:
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.notice)
        elif box.left() <= (head := self._x(box, self._media_s)) <= box.right():
            painter.fillRect(_upright(box, head), QColor(theme.TEXT))
        self.pointer.paint(painter, box)
        painter.restore()

    def _ticks(self) -> list[float]:
        if self.notice:
            return []
        first_s, last_s = self.span.around(self._media_s)
        step_s = next(
            (s for s in _TICKS_S if s * _TICKS >= last_s - first_s), _TICKS_S[-1]
        )
        first, last = math.ceil(first_s / step_s), math.floor(last_s / step_s)
        return [k * step_s for k in range(max(0, first), last + 1)]

    def _x(self, box: QRectF, media_s: float) -> float:
        first_s, last_s = self.span.around(self._media_s)
        return round(
            box.left() + (media_s - first_s) / (last_s - first_s) * box.width()
        )

    def time_at(self, x_px: float) -> float:
        """Return the media time at a place of the widget."""
        box: QRectF = self.view_box.sceneBoundingRect()
        first_s, last_s = self.span.around(self._media_s)
        return first_s + (x_px - box.left()) / max(1.0, box.width()) * (
            last_s - first_s
        )

    def values_at(self, media_s: float) -> list[list[float]]:
        """Return x, y, z of each group at a time; nothing where it has no line."""
        found = []
        for group in self.curve_groups:
            times_s = group[0].getData()[0]
            if times_s is None or not len(times_s):
                continue
            if times_s[0] <= media_s <= times_s[-1]:
                lines = (curve.getData()[1] for curve in group)
                found.append([float(np.interp(media_s, times_s, y)) for y in lines])
        return found

    def pages(self) -> list[Page]:
        """The lines of each group in view."""
        pages = []
        for group in self.curve_groups:
            times_s = group[0].getData()[0]
            if times_s is None or not len(times_s):
                pages.append(EMPTY)
                continue
            values = np.stack([curve.getData()[1] for curve in group], axis=1)
            pages.append(cut(times_s, values, *self.span.around(self._media_s)))
        return pages

    def viewportEvent(self, event: QEvent) -> bool:
        is_taken = hasattr(self, "pointer") and self.pointer.takes(event)
        return is_taken or bool(super().viewportEvent(event))

    def event(self, event: QEvent) -> bool:
        """Give the keys of the view to it, before the window's shortcuts."""
        is_taken = hasattr(self, "pointer") and self.pointer.takes_key(event)
        return is_taken or bool(super().event(event))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if hasattr(self, "view_box"):
            self.view_box.updateMatrix()


def _upright(box: QRectF, x: float) -> QRectF:
    return QRectF(x, box.top(), 1, box.height())


def clock_text(media_s: float) -> str:
    """Return a time as m:ss or h:mm:ss, with a tenth where it has one."""
    tenths = round(10 * media_s)
    minutes, tenths = divmod(tenths, 600)
    hours, minutes = divmod(minutes, 60)
    rest = f".{tenths % 10}" if tenths % 10 else ""
    clock = f"{minutes:02}" if hours else f"{minutes}"
    whole = local(f"{clock}:{tenths // 10:02}{rest}")
    return f"{hours}:{whole}" if hours else whole


class PlotPointer(QObject):
    """Watches the events of one plot, whose view is changed and read."""

    def __init__(self, plot: PlayheadPlot) -> None:
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
