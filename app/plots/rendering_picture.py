"""A picture of two renderings of a clip: their forces and excursions over each other."""

import math
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.plots.playhead_plot import clock_text
from app.widgets import theme
from app.widgets.texts import local, titled
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.comparison import Curves
from hapticplayer.sequence.excursion import FAR, LIMITS

translate = QCoreApplication.translate

_GAP_PX, _EDGE_PX, _KEY_PX = 8, 6, 18
_FILL_ALPHA = 90
_TICKS, _TICKS_S = 6, (0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1200, 1800, 3600)
_LEAST_FORCE_N = 0.5
_MM = 1000.0
_END_MM = _MM * LIMITS.workspace_m
_FAR_MM = FAR * _END_MM


class _Row(NamedTuple):
    """One of the four curves.

    Attributes:
        name: for people.
        colour: of what comes after.
        before, after: (spans, 2) lowest and highest; None while nothing is known.
        low, high: of the row.
        marks: values with a line and a number.
    """

    name: str
    colour: str
    before: Floats | None
    after: Floats | None
    low: float
    high: float
    marks: tuple[float, ...]


class RenderingPicture(QWidget):
    """Force along three axes and the excursion of a relaxed hand, for the whole clip.

    What is there now is a grey band with its outline, what would come a coloured one.

    Args:
        names: of both, in place of "Before" and "After".
    """

    def __init__(self, names: tuple[str, str] | None = None) -> None:
        super().__init__()
        self.names = names or (self.tr("Before"), self.tr("After"))
        title = self.tr("Force and predicted excursion: {before}, {after}")
        before, after = self.names
        self.setAccessibleName(title.format(before=before, after=after))
        self.setToolTip(
            self.tr(
                "Excursion from the centre: beyond {far} mm outward force is reduced, "
                "at {end} mm the workspace ends"
            ).format(far=f"{_FAR_MM:.0f}", end=f"{_END_MM:.0f}")
        )
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFont(theme.scaled(self.font(), 0.85))
        self.before: Curves | None = None
        self.after: Curves | None = None
        self.notice = ""

    def sizeHint(self) -> QSize:
        return QSize(480, 320)

    def minimumSizeHint(self) -> QSize:
        return QSize(300, 14 * self.fontMetrics().height())

    def show_curves(
        self, before: Curves | None, after: Curves | None, notice: str = ""
    ) -> None:
        """Show two renderings, or the one that is known; the notice stands for none."""
        self.before, self.after, self.notice = before, after, notice
        self.update()

    def spoken(self) -> str:
        """The largest force and excursion of both, or the notice."""
        named = zip(self.names, (self.before, self.after), strict=True)
        said = [titled(name, _peaks(one)) for name, one in named if one is not None]
        return ", ".join(said) or self.notice

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(self.rect(), QColor(theme.PANEL))
            known = self.before or self.after
            if known is None:
                painter.setPen(QColor(theme.DIM))
                flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
                painter.drawText(self.rect(), flags, self.notice)
                return
            self._draw_key(painter)
            areas = self._areas()
            for row, area in zip(self._rows(), areas, strict=True):
                self._draw_row(painter, row, area)
            self._draw_times(painter, areas[-1], known.duration_s)

    def _areas(self) -> list[QRectF]:
        """Return where the curves go, one below the other."""
        metrics = self.fontMetrics()
        left = metrics.horizontalAdvance("\u22128.8 ") + 2 * _EDGE_PX
        line = metrics.height()
        top, bottom = line + 2 * _EDGE_PX, line + 2 * _EDGE_PX
        each = (self.height() - top - bottom) / 4
        width = self.width() - left - 2 * _EDGE_PX
        return [
            QRectF(left, top + row * each + line, width, each - line - _GAP_PX)
            for row in range(4)
        ]

    def _rows(self) -> list[_Row]:
        known = [one for one in (self.before, self.after) if one is not None]
        most_n = max(float(np.abs(one.force_n).max()) for one in known)
        force_n = max(_LEAST_FORCE_N, _round_up(most_n))
        names = (
            self.tr("Force to the right, N"),
            self.tr("Force up, N"),
            self.tr("Force towards the user, N"),
        )
        rows = [
            _Row(
                name,
                theme.AXIS_COLOURS[axis],
                None if self.before is None else self.before.force_n[:, axis],
                None if self.after is None else self.after.force_n[:, axis],
                -force_n,
                force_n,
                (-force_n, 0.0, force_n),
            )
            for axis, name in enumerate(names)
        ]
        title = self.tr("Excursion of a relaxed hand, mm")
        before, after = (_excursion_mm(one) for one in (self.before, self.after))
        marks = (0.0, _FAR_MM, _END_MM)
        rows.append(_Row(title, theme.ACCENT, before, after, 0.0, _END_MM, marks))
        return rows

    def _draw_key(self, painter: QPainter) -> None:
        metrics = self.fontMetrics()
        x, base = float(_EDGE_PX), _EDGE_PX + metrics.ascent()
        middle = base - metrics.xHeight() / 2
        for text, colours in (
            (self.names[0], (theme.DIM,)),
            (self.names[1], (*theme.AXIS_COLOURS, theme.ACCENT)),
        ):
            wide = _KEY_PX / len(colours)
            for number, colour in enumerate(colours):
                box = QRectF(x + number * wide, middle - 3, wide, 6)
                painter.fillRect(box, QColor(colour))
            painter.setPen(QColor(theme.TEXT))
            painter.drawText(QPointF(x + _KEY_PX + _EDGE_PX, base), text)
            x += _KEY_PX + 4 * _EDGE_PX + metrics.horizontalAdvance(text)

    def _draw_row(self, painter: QPainter, row: _Row, area: QRectF) -> None:
        metrics = self.fontMetrics()
        painter.setPen(QColor(theme.DIM))
        painter.drawText(QPointF(area.left(), area.top() - metrics.descent()), row.name)
        for mark in row.marks:
            y = _height(row, area, mark)
            painter.setPen(QColor(theme.ZERO if mark == 0.0 else theme.GRID))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            painter.setPen(QColor(theme.DIM))
            text = local(f"{mark:.3g}")
            box = QRectF(
                0, y - metrics.height() / 2, area.left() - _EDGE_PX, metrics.height()
            )
            painter.drawText(box, Qt.AlignmentFlag.AlignRight, text)
        for band, colour in ((row.before, theme.DIM), (row.after, row.colour)):
            if band is not None:
                self._draw_band(painter, row, area, band, QColor(colour))

    def _draw_band(
        self, painter: QPainter, row: _Row, area: QRectF, band: Floats, colour: QColor
    ) -> None:
        across = area.left() + (np.arange(len(band)) + 0.5) / len(band) * area.width()
        low, high = (
            QPolygonF(
                [
                    QPointF(x, _height(row, area, value))
                    for x, value in zip(across.tolist(), side.tolist(), strict=True)
                ]
            )
            for side in band.T
        )
        fill = QColor(colour)
        fill.setAlpha(_FILL_ALPHA)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(fill)
        painter.drawPolygon(QPolygonF([*low.toList(), *reversed(high.toList())]))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(colour, 1.0))
        painter.drawPolyline(low)
        painter.drawPolyline(high)

    def _draw_times(self, painter: QPainter, area: QRectF, duration_s: float) -> None:
        metrics = self.fontMetrics()
        enough = (step for step in _TICKS_S if duration_s <= _TICKS * step)
        step_s = next(enough, _TICKS_S[-1] * math.ceil(duration_s / 3600 / _TICKS))
        painter.setPen(QColor(theme.DIM))
        for number in range(math.floor(duration_s / step_s) + 1):
            text = clock_text(number * step_s)
            x = area.left() + number * step_s / duration_s * area.width()
            wide = metrics.horizontalAdvance(text)
            left = min(max(x - wide / 2, 0.0), self.width() - wide - 1.0)
            base = self.height() - _EDGE_PX - metrics.descent()
            painter.drawText(QPointF(left, base), text)


def _height(row: _Row, area: QRectF, value: float) -> float:
    share = (min(max(value, row.low), row.high) - row.low) / (row.high - row.low)
    return area.bottom() - share * area.height()


def _peaks(curves: Curves) -> str:
    force_n = float(np.abs(curves.force_n).max())
    excursion_mm = _MM * float(curves.excursion_m.max())
    return local(f"{force_n:.2f} N, {excursion_mm:.0f} mm")


def _excursion_mm(curves: Curves | None) -> Floats | None:
    if curves is None:
        return None
    high_mm = _MM * curves.excursion_m
    return np.stack([np.zeros_like(high_mm), high_mm], axis=1)


def _round_up(value: float) -> float:
    """Return the next of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10 times a power of ten."""
    if value <= 0.0:
        return 0.0
    power = 10.0 ** math.floor(math.log10(value))
    steps = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
    return power * next(step for step in steps if step * power >= value * 0.999)
