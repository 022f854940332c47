"""Writes what the picture of the grip says in words and figures."""

import html
import math

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter

from app.plots.grip_camera import Projection
from app.plots.grip_moving import CENTRING, arrow_tip, colours, zone_colour
from app.plots.grip_scene import LEAST_SHOWN_N, Activity, Grip
from app.widgets import theme
from app.widgets.numbers import local

translate = QCoreApplication.translate

# A sign of its own for each: colour alone tells some people nothing.
_SIGNS = {
    Activity.OFF: "\u25cb",
    Activity.CHANGING: "\u25b2",
    Activity.ACTIVE: "\u25cf",
    Activity.STOPPED: "\u25a0",
}
_NEAR, _AT_THE_EDGE = "\u25b2", "\u25a0"
_MARGIN_PX = 8.0
_BESIDE_PX = 12.0


def paint_words(painter: QPainter, view: Projection, grip: Grip) -> None:
    """Write excursion and forces; without a grip why there is none, in the middle."""
    room = _inside(view)
    if grip.position_m is None:
        colour = colours()[grip.activity]
        _write(painter, room, Qt.AlignmentFlag.AlignCenter, grip.state, colour)
        return
    corner = Qt.AlignmentFlag.AlignBottom | Qt.AlignmentFlag.AlignLeft
    out = excursion_text(grip)
    used_px = _write(painter, room, corner, out, zone_colour(grip) or theme.TEXT)
    if math.hypot(*grip.centring_n) >= LEAST_SHOWN_N:
        text = centring_text(grip)
        needed_px = painter.fontMetrics().horizontalAdvance(text) + 2 * _MARGIN_PX
        if needed_px < room.right() - used_px.right():
            corner = Qt.AlignmentFlag.AlignBottom | Qt.AlignmentFlag.AlignRight
        else:
            room.setBottom(used_px.top())
        _write(painter, room, corner, text, CENTRING)
    _label_force(painter, view, grip)


def headline(grip: Grip) -> str:
    """Return title and state as rich text of one line, or more where it is narrow."""
    sign, colour = _SIGNS[grip.activity], colours()[grip.activity]
    title = f"<b>{html.escape(grip.title)}</b>"
    if grip.position_m is None:  # the picture says it, where there is room for it
        return title
    state = html.escape(grip.state)
    return f"{title} &nbsp; <span style='color:{colour}'>{sign}&nbsp;{state}</span>"


def force_text(grip: Grip) -> str:
    """Return how strong the force on the hand is."""
    force_n = math.hypot(*grip.force_n)
    return local(translate("GripView", "{force:.1f} N").format(force=force_n))


def centring_text(grip: Grip) -> str:
    """Return how much of the force keeps the grip inside."""
    text = translate("GripView", "centring {force:.1f} N")
    return local(text.format(force=math.hypot(*grip.centring_n)))


def excursion_text(grip: Grip) -> str:
    """Return how far out the grip is; with a sign where that is near the edge."""
    text = translate("GripView", "{out:.0f} mm of {most:.0f}").format(
        out=1e3 * grip.excursion_m, most=1e3 * grip.radius_m
    )
    sign = {theme.WARN: _NEAR, theme.BAD: _AT_THE_EDGE}.get(zone_colour(grip))
    return f"{sign} {text}" if sign else text


def _inside(view: Projection) -> QRectF:
    whole = QRectF(0.0, 0.0, view.width_px, view.height_px)
    return whole.adjusted(_MARGIN_PX, 4.0, -_MARGIN_PX, -6.0)


def _label_force(painter: QPainter, view: Projection, grip: Grip) -> None:
    """Write the force beyond the tip of its arrow, inside the picture."""
    tip = arrow_tip(grip, grip.position_m) if grip.position_m else None
    if tip is None or grip.position_m is None:
        return
    text, metrics = force_text(grip), painter.fontMetrics()
    size_px = (metrics.horizontalAdvance(text) + 6.0, float(metrics.height()))
    (x_px, y_px), (from_x_px, from_y_px) = view.px(tip), view.px(grip.position_m)
    away = QPointF(x_px - from_x_px, y_px - from_y_px)
    length = math.hypot(away.x(), away.y()) or 1.0
    middle = QPointF(x_px, y_px) + QPointF(
        (0.5 * size_px[0] + 4.0) * away.x() / length,
        (0.5 * size_px[1] + 3.0) * away.y() / length,
    )
    plate = QRectF(0.0, 0.0, *size_px)
    plate.moveCenter(middle)
    room = QRectF(0.0, 0.0, view.width_px, view.height_px)
    plate.moveTop(min(max(plate.top(), 0.0), room.height() - plate.height()))
    plate.moveLeft(min(max(plate.left(), 0.0), room.width() - plate.width()))
    if plate.contains(x_px, y_px):  # pushed back over the head: go beside it
        plate.moveLeft(x_px + _BESIDE_PX)
        if plate.right() > room.right():
            plate.moveRight(x_px - _BESIDE_PX)
    _paint_plate(painter, plate)
    painter.setPen(QColor(theme.TEXT))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)


def _write(
    painter: QPainter,
    room: QRectF,
    where: Qt.AlignmentFlag,
    text: str,
    colour: str,
) -> QRectF:
    """Write in as many lines as it takes, on a plate; return where it is."""
    flags = int(where | Qt.TextFlag.TextWordWrap)
    plate = painter.boundingRect(room, flags, text)
    _paint_plate(painter, plate.adjusted(-4.0, -1.0, 4.0, 1.0))
    painter.setPen(QColor(colour))
    painter.drawText(room, flags, text)
    return plate


def _paint_plate(painter: QPainter, plate: QRectF) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    ground = QColor(theme.PANEL)
    ground.setAlpha(225)
    painter.setBrush(ground)
    painter.drawRoundedRect(plate, 3.0, 3.0)
