"""Paints what moves in the scene: grip, shadow, trail, forces, the edge when near."""

import math

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import (
    QColor,
    QPainter,
    QPainterPath,
    QPen,
    QPolygonF,
    QRadialGradient,
)

from app.plots import grip_scene as scene
from app.plots.grip_scene import Activity, Grip, Projection
from app.widgets import theme
from hapticplayer.model.device import Vector

# What was planned is thin and as light as a text, the centring Okabe and Ito's purple.
CENTRING = "#cc79a7"
_BALL, _SHADOW = QColor("#cdd5de"), QColor(0, 0, 0, 150)
_SHAFT_SHARE, _HEAD_SHARE = 0.035, 0.085  # half widths, of the workspace's radius
_HEAD_LENGTHS = 2.2  # of the head, in its half widths
_THIN = 0.45  # of planned and centring beside the force
_CAP_RAD = math.radians(24.0)


def colours() -> dict[Activity, str]:
    """Return the colour of the force by what is done with it."""
    return {
        Activity.OFF: theme.DIM,
        Activity.CHANGING: theme.WARN,
        Activity.ACTIVE: theme.GOOD,
        Activity.STOPPED: theme.BAD,
    }


def paint_moving(
    painter: QPainter, view: Projection, grip: Grip, position_m: Vector
) -> None:
    """Draw a grip at its place, from what is behind it to what is before it."""
    _paint_zone(painter, view, grip, position_m)
    _paint_shadow(painter, view, position_m)
    _paint_trail(painter, view, grip)
    arrows = [
        (grip.arrow_m(grip.planned_n), QColor(theme.TEXT), _THIN),
        (grip.arrow_m(grip.force_n), QColor(colours()[grip.activity]), 1.0),
        (grip.arrow_m(grip.centring_n), QColor(CENTRING), _THIN),
    ]
    shown = [(arrow, colour, share) for arrow, colour, share in arrows if arrow]
    behind = [one for one in shown if not _comes_nearer(view, one[0])]
    for arrow, colour, share in behind:
        _paint_arrow(painter, view, (position_m, arrow), colour, share)
    _paint_ball(painter, view, grip, position_m)
    for arrow, colour, share in shown:
        if _comes_nearer(view, arrow):
            _paint_arrow(painter, view, (position_m, arrow), colour, share)


def arrow_tip(grip: Grip, position_m: Vector) -> Vector | None:
    """Return where the arrow of the force ends, None without one."""
    arrow = grip.arrow_m(grip.force_n)
    return _tip(grip.radius_m, position_m, arrow) if arrow else None


def _tip(radius_m: float, position_m: Vector, arrow_m: Vector) -> Vector:
    """Return the end of an arrow; it begins at the surface of the ball."""
    surface = scene.scaled(scene.unit(arrow_m), scene.GRIP_RADII * radius_m)
    return scene.added(position_m, scene.added(surface, arrow_m))


def _comes_nearer(view: Projection, arrow_m: Vector) -> bool:
    return view.depth_m(arrow_m) < view.distance_m


def zone_colour(grip: Grip) -> str:
    """Return the colour of the edge: "" far from it, a warning near it."""
    if grip.excursion_share < scene.NEAR_SHARE:
        return ""
    return theme.WARN if grip.excursion_share < scene.ZONE_SHARE else theme.BAD


def _paint_zone(
    painter: QPainter, view: Projection, grip: Grip, position_m: Vector
) -> None:
    """Mark the outer 10 % of the workspace, and where the grip would leave it."""
    name = zone_colour(grip)
    if not name:
        return
    middle, outer_px = QPointF(*view.middle_px), view.sphere_px
    ring = QPainterPath()
    ring.addEllipse(middle, outer_px, outer_px)
    inner_px = scene.ZONE_SHARE * outer_px
    ring.addEllipse(middle, inner_px, inner_px)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(_faded(name, 55))
    painter.drawPath(ring)
    around = scene.cap(position_m, view.radius_m, _CAP_RAD)
    painter.setPen(QPen(QColor(name), 1.2))
    painter.setBrush(_faded(name, 60))
    painter.drawPolygon(polygon(view, around))


def _paint_shadow(painter: QPainter, view: Projection, position_m: Vector) -> None:
    """Draw the shadow on the floor and the line that drops to it."""
    x, y, z = position_m
    below = (x, -view.radius_m, z)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(_SHADOW)
    disc = scene.floor_disc(scene.GRIP_RADII * view.radius_m, below)
    painter.drawPolygon(polygon(view, disc))
    if y > -view.radius_m:
        pen = QPen(QColor(theme.DIM), 1.0, Qt.PenStyle.DotLine)
        painter.setPen(pen)
        painter.drawLine(QPointF(*view.px(position_m)), QPointF(*view.px(below)))


def _paint_trail(painter: QPainter, view: Projection, grip: Grip) -> None:
    """Draw where the grip was, the older the fainter."""
    points = [QPointF(*view.px(point)) for point in grip.trail_m]
    for number in range(1, len(points)):
        share = number / len(points)
        colour = QColor(theme.ACCENT)
        colour.setAlphaF(share * share)
        painter.setPen(QPen(colour, 1.0 + share))
        painter.drawLine(points[number - 1], points[number])


def _paint_ball(
    painter: QPainter, view: Projection, grip: Grip, position_m: Vector
) -> None:
    """Draw the grip with light from the upper left; nearer is larger."""
    middle = QPointF(*view.px(position_m))
    radius_px = scene.GRIP_RADII * view.radius_m * view.px_per_m(position_m)
    is_stopped = grip.activity is Activity.STOPPED
    colour = QColor(theme.BAD) if is_stopped else _BALL
    light = middle - QPointF(0.4 * radius_px, 0.45 * radius_px)
    shade = QRadialGradient(middle, 1.05 * radius_px, light)
    shade.setColorAt(0.0, colour.lighter(125))
    shade.setColorAt(0.5, colour)
    shade.setColorAt(1.0, colour.darker(240))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(shade)
    painter.drawEllipse(middle, radius_px, radius_px)


def _paint_arrow(
    painter: QPainter,
    view: Projection,
    from_to: tuple[Vector, Vector],
    colour: QColor,
    width_share: float,
) -> None:
    """Draw a shaft and a cone, both as solids: also an arrow at one's eye is seen."""
    position_m, arrow_m = from_to
    length_m, axis = math.hypot(*arrow_m), scene.unit(arrow_m)
    tip = _tip(view.radius_m, position_m, arrow_m)
    half_m = width_share * _HEAD_SHARE * view.radius_m
    head_m = min(_HEAD_LENGTHS * half_m, 0.8 * length_m)
    neck = scene.added(tip, scene.scaled(axis, -head_m))
    tail = scene.added(tip, scene.scaled(axis, -length_m))
    head = scene.disc(neck, axis, half_m)
    shaft_m = width_share * _SHAFT_SHARE * view.radius_m
    ends = [*scene.disc(tail, axis, shaft_m), *scene.disc(neck, axis, shaft_m)]
    painter.setPen(Qt.PenStyle.NoPen)
    parts = [(ends, colour.darker(125)), ([*head, tip], colour)]
    if _comes_nearer(view, arrow_m):
        _paint_solids(painter, view, parts)
    else:  # the cone's base hides its tip
        _paint_solids(painter, view, [parts[1], (head, colour.darker(160)), parts[0]])


def _paint_solids(
    painter: QPainter, view: Projection, parts: list[tuple[list[Vector], QColor]]
) -> None:
    for points_m, colour in parts:
        outline = scene.hull([view.px(point) for point in points_m])
        painter.setBrush(colour)
        painter.drawPolygon(QPolygonF([QPointF(*pixel) for pixel in outline]))


def polygon(view: Projection, points_m: list[Vector]) -> QPolygonF:
    """Return points of the scene as they are seen."""
    return QPolygonF([QPointF(*view.px(point)) for point in points_m])


def _faded(name: str, alpha: int) -> QColor:
    colour = QColor(name)
    colour.setAlpha(alpha)
    return colour
