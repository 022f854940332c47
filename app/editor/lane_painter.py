"""Draws what does not change while a person works: times, force curves, loudness."""

from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.editor.view import TimeView
from app.experimenter.sync_strip import Curve, columns, tick_step_s
from app.plots.series import Page, half_range, thin
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering.effects import TimeMarker

translate = QCoreApplication.translate

RULER_PX, EVENTS_PX, MARGIN_PX = 20, 22, 5
MARKERS_PX, CURVE_PX = 18, 84
_CURVE_SHARE = 0.24  # of a low window
LEAST_FORCE_N = 1.0
_TICK_PX, _APART_PX = 90, 0.4
_SOUND_SHARE = 0.8  # of the height of a curve
_ROW_PX, _LEAST_ROW_PX = 24, 4


class Boxes(NamedTuple):
    """Where the lanes are."""

    ruler: QRectF
    markers: QRectF
    axes: tuple[QRectF, QRectF, QRectF]
    sound: QRectF
    curve: QRectF
    events: QRectF
    effects: QRectF


def boxes(
    width: int,
    height: int,
    rows: int,
    *,
    has_markers: bool = False,
    has_curve: bool = False,
) -> Boxes:
    """Return the lanes of a widget; `rows` effects lie below each other.

    Those of markers and curve are there when they are needed; events and effects stay
    where they are meanwhile, as one of these may be held by the pointer.
    """
    effects_px = min(_ROW_PX * (max(2, rows) + 0.25), 0.35 * height)
    markers_px = MARKERS_PX if has_markers else 0.0
    curve_px = min(CURVE_PX, _CURVE_SHARE * height) if has_curve else 0.0
    taken_px = RULER_PX + markers_px + curve_px + EVENTS_PX + effects_px
    axis_px = (height - taken_px) / (3.0 + _SOUND_SHARE)
    sound_px = _SOUND_SHARE * axis_px
    heights = (
        *(RULER_PX, markers_px, *(axis_px,) * 3, sound_px),
        *(curve_px, EVENTS_PX, effects_px),
    )
    tops = np.concatenate(([0.0], np.cumsum(heights)))
    made = [
        QRectF(0, top, width, high) for top, high in zip(tops, heights, strict=False)
    ]
    return Boxes(made[0], made[1], (made[2], made[3], made[4]), *made[5:])


def row_box(lane: QRectF, row: int, rows: int) -> QRectF:
    high = max(_LEAST_ROW_PX, min(_ROW_PX, (lane.height() - 4) / max(1, rows)))
    return QRectF(lane.left(), lane.top() + 2 + row * high, lane.width(), high - 2)


def paint_frame(painter: QPainter, lanes: Boxes, view: TimeView) -> None:
    """Draw the ground, the edges of the lanes and the times."""
    width = lanes.ruler.width()
    painter.fillRect(lanes.ruler, QColor(theme.RAISED))
    painter.setPen(QColor(theme.BORDER))
    painter.fillRect(lanes.markers, QColor(theme.RAISED))
    for lane in (*lanes.axes, lanes.sound, lanes.events, lanes.effects):
        painter.drawLine(lane.topLeft(), lane.topRight())
    step_s = tick_step_s(view.span_s * _TICK_PX / max(1.0, width))
    first, last = int(np.ceil(view.begin_s / step_s)), int(view.end_s / step_s)
    bottom = lanes.effects.bottom()
    for tick in range(first, last + 1):
        x = view.x_of(tick * step_s, width)
        painter.setPen(QColor(theme.GRID))
        painter.drawLine(QPointF(x, RULER_PX), QPointF(x, bottom))
        painter.setPen(QColor(theme.DIM))
        painter.drawLine(QPointF(x, RULER_PX - 5), QPointF(x, RULER_PX))
        text = translate("Lanes", "{time} s").format(time=local(f"{tick * step_s:.6g}"))
        box = QRectF(x + 3, 0, _TICK_PX, RULER_PX)
        painter.drawText(box, Qt.AlignmentFlag.AlignVCenter, text)


def paint_force(
    painter: QPainter,
    lanes: Boxes,
    view: TimeView,
    track: ForceTrack | None,
    before: ForceTrack | None = None,
) -> None:
    """Draw the three curves of a track, and behind it another one, all on one scale."""
    names = (
        translate("Lanes", "Force x (right)"),
        translate("Lanes", "Force y (up)"),
        translate("Lanes", "Force z (towards you)"),
    )
    half_n = max(scale_n(track), scale_n(before))
    for lane in lanes.axes:
        painter.setPen(QColor(theme.ZERO))
        middle = lane.center().y()
        painter.drawLine(QPointF(lane.left(), middle), QPointF(lane.right(), middle))
    if before is not None and before is not track:
        paint_curves(painter, lanes, view, before, half_n, (theme.DISABLED,) * 3)
    if track is not None:
        paint_curves(painter, lanes, view, track, half_n, theme.AXIS_COLOURS)
    for lane, name in zip(lanes.axes, names, strict=True):
        paint_name(painter, lane, name)
        text = local(translate("Lanes", "\u00b1 {peak} N").format(peak=f"{half_n:g}"))
        paint_name(painter, lane, text, Qt.AlignmentFlag.AlignRight)


def scale_n(track: ForceTrack | None) -> float:
    return half_range(track.peak_n() if track else 0.0, LEAST_FORCE_N)


def paint_curves(
    painter: QPainter,
    lanes: Boxes,
    view: TimeView,
    track: ForceTrack,
    half_n: float,
    colours: tuple[str, ...],
) -> None:
    """Draw a LINEAR track, one axis in each lane; no peak is lost."""
    width = lanes.ruler.width()
    first, last = np.searchsorted(track.time_s, (view.begin_s, view.end_s))
    rows = slice(max(0, first - 1), last + 1)
    page = Page(track.time_s[rows], track.force_n[rows].astype(np.float64))
    page = thin(page, max(4, 2 * int(width)))
    x = width / view.span_s * (page.time_s - view.begin_s)
    for axis, lane in enumerate(lanes.axes):
        room = 0.5 * lane.height() - MARGIN_PX
        y = lane.center().y() - room / half_n * page.values[:, axis]
        _stroke(painter, _polygon(x, y), QColor(colours[axis]))


def _stroke(painter: QPainter, line: QPolygonF, colour: QColor) -> None:
    """Draw a line 1.5 px wide out of some that are as thin as a pixel of the screen.

    Qt has a fast way for those alone: 0.3 ms for 2300 points, 26 ms for any wider pen.
    """
    pen = QPen(colour)
    pen.setCosmetic(True)
    painter.setPen(pen)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    count = 1 + round(painter.device().devicePixelRatioF())
    for number in range(count):
        aside = _APART_PX * (number - 0.5 * (count - 1))
        painter.drawPolyline(line.translated(aside, aside))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)


def paint_loop(
    painter: QPainter, lanes: Boxes, view: TimeView, span_s: tuple[float, float]
) -> None:
    """Mark a span that is repeated, on the ruler and through all lanes."""
    width = lanes.ruler.width()
    first, last = (view.x_of(at_s, width) for at_s in span_s)
    ground = QColor(theme.ACCENT)
    ground.setAlpha(40)
    painter.fillRect(QRectF(first, 0, last - first, lanes.effects.bottom()), ground)
    painter.fillRect(QRectF(first, RULER_PX - 3, last - first, 3), QColor(theme.ACCENT))


def paint_markers(
    painter: QPainter, lanes: Boxes, view: TimeView, markers: tuple[TimeMarker, ...]
) -> None:
    """Draw each as a line through all lanes, with its name as far as the next one."""
    width = lanes.ruler.width()
    places = [view.x_of(one.time_s, width) for one in markers]
    ends = [*places[1:], width]
    for marker, x, end in zip(markers, places, ends, strict=False):
        if not 0.0 <= x <= width:
            continue
        painter.setPen(QPen(QColor(theme.ACCENT), 1, Qt.PenStyle.DashLine))
        bottom = lanes.effects.bottom()
        painter.drawLine(QPointF(x, lanes.markers.top()), QPointF(x, bottom))
        painter.fillRect(
            QRectF(x, lanes.markers.top() + 1, 4, MARKERS_PX - 2), QColor(theme.ACCENT)
        )
        room = QRectF(x + 8, lanes.markers.top(), max(0.0, end - x - 12), MARKERS_PX)
        shown = painter.fontMetrics().elidedText(
            marker.name, Qt.TextElideMode.ElideRight, int(room.width())
        )
        painter.setPen(QColor(theme.TEXT))
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, shown)


def paint_sound(
    painter: QPainter, lane: QRectF, view: TimeView, loudness: Curve
) -> None:
    """Draw how loud the clip is, or that it is silent."""
    shown_s = view.begin_s, view.end_s
    x, y = columns(loudness, shown_s, max(1, int(lane.width())))
    if len(x) < 2:
        name = translate("Lanes", "The clip has no sound")
        paint_name(painter, lane, name)
        return
    top = max(float(loudness[1].max()), 1e-9)
    floor, space = lane.bottom() - 1, lane.height() - 2 * MARGIN_PX
    edge = _polygon(x, floor - space / top * y)
    edge.prepend(QPointF(x[0], floor))
    edge.append(QPointF(x[-1], floor))
    colour = QColor(theme.DIM)
    painter.setPen(colour)
    colour.setAlpha(90)
    painter.setBrush(colour)
    painter.drawPolygon(edge)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    paint_name(painter, lane, translate("Lanes", "Sound"))


def paint_name(
    painter: QPainter,
    lane: QRectF,
    name: str,
    side: Qt.AlignmentFlag = Qt.AlignmentFlag.AlignLeft,
) -> None:
    """Write what a lane shows, on a ground that keeps it readable."""
    inner = lane.adjusted(MARGIN_PX, 2, -MARGIN_PX, 0)
    flags = side | Qt.AlignmentFlag.AlignTop
    ground = QColor(theme.PANEL)
    ground.setAlpha(190)
    painter.fillRect(painter.boundingRect(inner, int(flags), name), ground)
    painter.setPen(QColor(theme.DIM))
    painter.drawText(inner, int(flags), name)


def _polygon(x: Floats, y: Floats) -> QPolygonF:
    points = (QPointF(a, b) for a, b in zip(x.tolist(), y.tolist(), strict=True))
    return QPolygonF(list(points))
