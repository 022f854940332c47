"""How much later than video and sound the force came: the last half minute."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.bridge.pump import Cadence
from app.widgets import theme
from app.widgets.layout import is_seen
from app.widgets.texts import local, titled
from hapticplayer.model import SyncStats
from hapticplayer.playback.meters import EARLY_MS, LATE_MS
from hapticplayer.playback.snapshot import SyncTraces

SPAN_S = 30.0
LOWEST_MS, HIGHEST_MS = -25.0, 60.0
"""What lies beyond is drawn on the edge."""
REFRESH_HZ = 4.0

_LEAST_HEIGHT_PX = 72  # where the screen is low
_HEIGHT_PX, _EDGE_PX, _DOT_PX, _GAP_PX = 104, 6, 2.5, 14
_MARKS_MS = (EARLY_MS, 0.0, LATE_MS)
_BAND_ALPHA = 45


class Trace(NamedTuple):
    """How much later the force came (n,) than one thing, and how long ago that was."""

    ages_s: NDArray[np.float64]
    later_ms: NDArray[np.float64]


def trace_of(events: NDArray[np.float64], now_s: float) -> Trace:
    """Return the last half minute of (monotonic s, ms) pairs, (n, 2)."""
    ages_s = now_s - events[:, 0]
    is_shown = ages_s <= SPAN_S
    return Trace(ages_s[is_shown], events[is_shown, 1])


class SyncPlot(QWidget):
    """Two rows of points over the span in which nobody feels a difference.

    Costs nothing while it is hidden.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Sync plot"))
        self.setToolTip(
            self.tr(
                "How much later than video and sound the force came in the last "
                "30 s. Between 15 ms early and 50 ms late is not noticeable"
            )
        )
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setFont(theme.scaled(self.font(), 0.85))
        self.video = self.sound = Trace(np.empty(0), np.empty(0))
        self._figures: tuple[SyncStats | None, SyncStats | None] = (None, None)
        self._cadence = Cadence(REFRESH_HZ)
        self.hide()

    def sizeHint(self) -> QSize:
        return QSize(320, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, _LEAST_HEIGHT_PX)

    def follow(self, now_s: float, sync_traces: Callable[[], SyncTraces]) -> None:
        """Show what the meters know, a few times a second and only where it is seen."""
        if is_seen(self) and self._cadence.is_due(now_s):
            traces = sync_traces()
            self.video = trace_of(traces.video, now_s)
            self.sound = trace_of(traces.audio, now_s)
            self._figures = (traces.force_minus_video, traces.force_minus_audio)
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.fillRect(self.rect(), QColor(theme.PANEL))
            painter.setPen(QColor(theme.BORDER))
            painter.drawLine(0, 0, self.width(), 0)
            area = self.plot_area()
            self._draw_band(painter, area)
            traces = (self.video, self.sound)
            for trace, colour in zip(traces, _colours(), strict=True):
                self._draw_points(painter, area, trace, QColor(colour))
            self._draw_legend(painter, area)

    def _legend(self) -> list[str]:
        names = (self.tr("Force \u2212 video"), self.tr("Force \u2212 sound"))
        return [
            titled(name, _figures_text(one))
            for name, one in zip(names, self._figures, strict=True)
        ]

    def spoken(self) -> str:
        """The figures of the legend."""
        return ", ".join(self._legend())

    def plot_area(self) -> QRectF:
        """Return where the points go: beside the numbers, under the legend."""
        metrics = self.fontMetrics()
        left_px = metrics.horizontalAdvance("\u221288 ms") + 2 * _EDGE_PX
        top_px = metrics.height() + 2 * _EDGE_PX
        width_px = self.width() - left_px - 2 * _EDGE_PX
        return QRectF(left_px, top_px, width_px, self.height() - top_px - 2 * _EDGE_PX)

    @staticmethod
    def height_of(area: QRectF, later_ms: float) -> float:
        """Return where a difference lies, px."""
        share = (later_ms - LOWEST_MS) / (HIGHEST_MS - LOWEST_MS)
        return area.bottom() - share * area.height()

    def _draw_band(self, painter: QPainter, area: QRectF) -> None:
        top, bottom = self.height_of(area, LATE_MS), self.height_of(area, EARLY_MS)
        band = QColor(theme.GOOD)
        band.setAlpha(_BAND_ALPHA)
        painter.fillRect(QRectF(area.left(), top, area.width(), bottom - top), band)
        high_px = self.fontMetrics().height()
        for mark_ms in _MARKS_MS:
            y = self.height_of(area, mark_ms)
            painter.setPen(QColor(theme.ZERO if mark_ms == 0.0 else theme.GRID))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            painter.setPen(QColor(theme.DIM))
            text = local(f"{mark_ms:+.0f} ms").replace("+0", "0")
            box = QRectF(0, y - high_px / 2, area.left() - _EDGE_PX, high_px)
            painter.drawText(box, Qt.AlignmentFlag.AlignRight, text)

    def _draw_points(
        self, painter: QPainter, area: QRectF, trace: Trace, colour: QColor
    ) -> None:
        pen = QPen(colour, _DOT_PX)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        across = area.right() - np.clip(trace.ages_s, 0, SPAN_S) / SPAN_S * area.width()
        held_ms = np.clip(trace.later_ms, LOWEST_MS, HIGHEST_MS)
        points = zip(across.tolist(), held_ms.tolist(), strict=True)
        painter.drawPoints([QPointF(x, self.height_of(area, ms)) for x, ms in points])

    def _draw_legend(self, painter: QPainter, area: QRectF) -> None:
        metrics, x = self.fontMetrics(), area.left()
        line_px = _EDGE_PX + metrics.ascent()
        for text, colour in zip(self._legend(), _colours(), strict=True):
            middle = QPointF(x + 4, line_px - metrics.xHeight() / 2)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(colour))
            painter.drawEllipse(middle, 4, 4)
            painter.setPen(QColor(theme.TEXT))
            painter.drawText(QPointF(x + _GAP_PX, line_px), text)
            x += 2 * _GAP_PX + metrics.horizontalAdvance(text)


def _figures_text(stats: SyncStats | None) -> str:
    """Median and 95th percentile, as the health line has them."""
    if stats is None:
        return "\u2013"
    return local(f"p50 {stats.p50_ms:+.1f}, p95 {stats.p95_ms:+.1f} ms")


def _colours() -> tuple[str, str]:
    return theme.AXIS_COLOURS[0], theme.AXIS_COLOURS[1]
