"""Draws the grip view: body, forces, trail, and what they are in words."""

import html
import math

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen, QPixmap, QRadialGradient

from app.plots import grip_scene as scene
from app.plots.grip_moving import (
    CENTRING,
    arrow_tip,
    colours,
    paint_moving,
    polygon,
    zone_colour,
)
from app.plots.grip_scene import (
    LEAST_SHOWN_N,
    Activity,
    Camera,
    Grip,
    Pixel,
    Projection,
)
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.model.device import Vector

translate = QCoreApplication.translate

# A sign for each: not everyone can tell the colours.
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
    if grip.position_m is None:  # the view says it, where there is room for it
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
    """Write the force beyond the tip of its arrow, inside the view."""
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


LEAST_FOR_WORDS_PX = 130.0  # of the shorter side; a smaller view names no axes
_GAP_PX = 4.0


class GripPainter:
    """Paints a grip as a camera sees it; keeps what did not change."""

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._behind, self._before = QPixmap(), QPixmap()

    def paint(
        self, painter: QPainter, size: QSizeF, camera: Camera, grip: Grip
    ) -> None:
        """Fill a view of this size, in the painter's pixels.

        The painter's device gives the resolution, its font the words.
        """
        view = Projection(camera, grip.radius_m, size.width(), size.height())
        has_grip = grip.position_m is not None
        self._prepare(painter, view, has_axes=has_grip)
        painter.drawPixmap(QPointF(), self._behind)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if grip.position_m is not None:
            paint_moving(painter, view, grip, grip.position_m)
        painter.drawPixmap(QPointF(), self._before)
        paint_words(painter, view, grip)

    def _prepare(self, on: QPainter, view: Projection, *, has_axes: bool) -> None:
        """Paint what stays; without a grip a text takes the place of the axes."""
        ratio, font = on.device().devicePixelRatioF(), on.font()
        key = (view, ratio, font.key(), has_axes)
        if key == self._key:
            return
        self._key = key
        self._behind = _layer(view, ratio, QColor(theme.PANEL))
        painter = _begun(self._behind, font)
        _paint_floor(painter, view)
        _paint_sphere(painter, view)
        _paint_arcs(painter, view, are_in_front=False)
        if has_axes:
            paint_axes(painter, view)
        painter.end()
        self._before = _layer(view, ratio, QColor(Qt.GlobalColor.transparent))
        painter = _begun(self._before, font)
        _paint_arcs(painter, view, are_in_front=True)
        painter.end()


def _layer(view: Projection, ratio: float, colour: QColor) -> QPixmap:
    size = QSizeF(view.width_px, view.height_px) * ratio
    made = QPixmap(size.toSize())
    made.setDevicePixelRatio(ratio)
    made.fill(colour)
    return made


def _begun(layer: QPixmap, font: QFont) -> QPainter:
    painter = QPainter(layer)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setFont(font)
    return painter


def _paint_floor(painter: QPainter, view: Projection) -> None:
    """Draw what makes heights visible, together with the grip's shadow."""
    height_m = -view.radius_m
    painter.setPen(QPen(QColor(theme.GRID), 1.0))
    painter.setBrush(QColor(theme.FLOOR))
    painter.drawPolygon(
        polygon(view, scene.floor_disc(view.radius_m, (0.0, height_m, 0.0)))
    )
    for first, last in scene.floor_grid(view.radius_m, height_m):
        painter.drawLine(QPointF(*view.px(first)), QPointF(*view.px(last)))


def _paint_sphere(painter: QPainter, view: Projection) -> None:
    """Draw the workspace as a soft ball of glass: clear inside, denser at the rim."""
    middle, radius_px = QPointF(*view.middle_px), view.sphere_px
    shade = QRadialGradient(middle, radius_px)
    shade.setColorAt(0.0, QColor(120, 150, 185, 8))
    shade.setColorAt(0.75, QColor(120, 150, 185, 22))
    shade.setColorAt(1.0, QColor(120, 150, 185, 62))
    painter.setPen(QPen(QColor(theme.BORDER), 1.0))
    painter.setBrush(shade)
    painter.drawEllipse(middle, radius_px, radius_px)


def _paint_arcs(painter: QPainter, view: Projection, *, are_in_front: bool) -> None:
    """Draw the half of the great circles that is before or behind the rest."""
    colour = QColor(theme.ZERO if are_in_front else theme.BORDER)
    painter.setPen(QPen(colour, 1.0))
    for circle in scene.great_circles(view.radius_m):
        run: list[Vector] = []
        for point in circle:
            if view.is_in_front(point) == are_in_front:
                run.append(point)
            elif run:
                painter.drawPolyline(polygon(view, run))
                run = []
        painter.drawPolyline(polygon(view, run))


def axis_words() -> tuple[str, str, str]:
    """The names of the directions of frame D."""
    return (
        translate("GripView", "right"),
        translate("GripView", "up"),
        translate("GripView", "towards you"),
    )


def paint_axes(painter: QPainter, view: Projection) -> None:
    """Draw the axes from the centre, in the colours of the plots, with words."""
    has_words = min(view.width_px, view.height_px) >= LEAST_FOR_WORDS_PX
    units: tuple[Vector, ...] = ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))
    for word, colour, axis in zip(axis_words(), theme.AXIS_COLOURS, units, strict=True):
        end_px = view.px(scene.scaled(axis, view.radius_m))
        shade = QColor(colour)
        painter.setPen(QPen(shade, 1.2))
        painter.drawLine(QPointF(*view.middle_px), QPointF(*end_px))
        painter.setBrush(shade)
        painter.drawEllipse(QPointF(*end_px), 2.0, 2.0)
        if has_words:
            _paint_axis_word(painter, view, word, end_px)


def _paint_axis_word(
    painter: QPainter, view: Projection, word: str, end_px: Pixel
) -> None:
    """Write beside the end of an axis, off the sphere's rim, inside the view."""
    metrics = painter.fontMetrics()
    most_px = int(view.width_px / 2)
    word = metrics.elidedText(word, Qt.TextElideMode.ElideRight, most_px)
    width_px, height_px = metrics.horizontalAdvance(word) + 1, metrics.height()
    x_px, y_px = end_px
    is_left = x_px < view.middle_px[0] - 2.0
    is_above = y_px < view.middle_px[1] - 0.5 * view.sphere_px
    top_px = y_px - height_px if is_above else y_px - 0.5 * height_px
    room_px = view.width_px - width_px - 1.0
    for from_px in (x_px if is_above else _rim_px(view, end_px), x_px):
        left_px = from_px - _GAP_PX - width_px if is_left else from_px + _GAP_PX
        if 0.0 <= left_px <= room_px:
            break
    else:
        left_px = min(max(0.0, left_px), room_px)
        if not is_above:
            top_px = y_px + _GAP_PX  # pushed back over the axis: go below it
    top_px = min(max(0.0, top_px), view.height_px - height_px)
    painter.setPen(QColor(theme.DIM))
    box = QRectF(left_px, top_px, width_px, height_px)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)


def _rim_px(view: Projection, end_px: Pixel) -> float:
    """Return where the rim is on the side and at the height of an axis's end."""
    middle_x_px, middle_y_px = view.middle_px
    high_px = min(abs(end_px[1] - middle_y_px), view.sphere_px)
    out_px = math.sqrt(view.sphere_px**2 - high_px**2)
    return middle_x_px + math.copysign(out_px, end_px[0] - middle_x_px)
