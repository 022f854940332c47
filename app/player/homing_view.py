"""The Falcon from the front and from the side while it is homed."""

import math
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.widgets import theme
from hapticplayer.devices.falcon.homing import WAY_COUNTS, Advice
from hapticplayer.devices.falcon.setting_up import Progress, Step

RADIUS_M = 0.040
"""Of the sphere in which the grip is shown once its place is known."""


class HomingView(NamedTuple):
    """One state of the drawing.

    Attributes:
        homed: encoders (top, right, lower left) that have found their zero.
        legs: how far out each of them is, 0 to 1; None where nothing is known.
        out: the same for the grip.
        aside: place of the grip right and up, -1 to 1.
        arrow: 1 pull, -1 push, 0 nothing to do.
    """

    homed: tuple[bool, bool, bool] = (False, False, False)
    legs: tuple[float, float, float] | None = None
    out: float | None = None
    aside: tuple[float, float] = (0.0, 0.0)
    arrow: int = 0
    is_ready: bool = False


class TravelEstimate:
    """Turns differences of counts into shares of the way from the inner end.

    Before homing nobody knows where on its way the grip began: in the middle, until
    it goes further to one side than that leaves room for.
    """

    def __init__(self) -> None:
        self._low = [-WAY_COUNTS / 2.0] * 4

    def share(self, which: int, counts: float) -> float:
        """Return the share of the way for leg 0 to 2, or for the mean of them, 3."""
        low = min(self._low[which], counts)
        self._low[which] = low = max(low, counts - WAY_COUNTS)
        return (counts - low) / WAY_COUNTS


def view_of(progress: Progress | None, ways: TravelEstimate) -> HomingView:
    """The picture of homing; no progress means no Falcon."""
    if progress is None:
        return HomingView()
    if progress.step is Step.READY:
        x, y, z = (max(-1.0, min(1.0, way / RADIUS_M)) for way in progress.position_m)
        out = (z + 1.0) / 2.0
        return HomingView((True,) * 3, (out,) * 3, out, (x, y), 0, is_ready=True)
    guidance = progress.guidance
    if guidance is None:
        return HomingView()
    i, j, k = (ways.share(leg, counts) for leg, counts in enumerate(guidance.legs))
    arrow = {Advice.PULL: 1, Advice.PUSH: -1, Advice.DONE: 0}[guidance.advice]
    return HomingView(
        guidance.homed,
        (i, j, k),
        ways.share(3, guidance.out),
        (0.0, 0.0),
        arrow,
        is_ready=guidance.advice is Advice.DONE,
    )


translate = QCoreApplication.translate

WIDTH_PX, HEIGHT_PX = 460, 230
_AZIMUTHS_DEG = (105.0, -15.0, -135.0)  # of the legs, from the front
_FROM, _TO, _SIGN_AT = 0.34, 0.76, 0.90  # along a leg, in radii
_SIGN_PX, _LINE_PX, _GRIP_PX = 11.0, 7.0, 13.0
_ARROW_PX = 46.0
_CENTRE = Qt.AlignmentFlag.AlignCenter


class HomingDrawing(QWidget):
    """Paints a `HomingView`.

    Each leg is a bar that fills as the grip comes out; at its end a ring, which turns
    into a disc with a tick when its encoder has found its zero. From the side, an
    arrow says where the grip has to go.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view = HomingView()
        self.setMinimumSize(WIDTH_PX, HEIGHT_PX)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(translate("HomingPicture", "The Falcon's grip"))

    def sizeHint(self) -> QSize:
        return QSize(WIDTH_PX, HEIGHT_PX)

    @property
    def view(self) -> HomingView:
        """What is shown."""
        return self._view

    def show_view(self, view: HomingView) -> None:
        """Show another state; nothing is drawn when it is the same."""
        if view != self._view:
            self._view = view
            self.setAccessibleDescription(_said(view))
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        half = self.width() / 2.0
        words = self.fontMetrics().height() + 6.0
        height = self.height() - words
        self._caption(painter, 0.0, translate("HomingPicture", "From the front"))
        self._caption(painter, half, translate("HomingPicture", "From the side"))
        _paint_front(painter, QRectF(0.0, words, half, height), self._view)
        _paint_side(painter, QRectF(half, words, half, height), self._view)

    def _caption(self, painter: QPainter, left: float, text: str) -> None:
        painter.setPen(QColor(theme.DIM))
        place = QRectF(left, 0.0, self.width() / 2.0, self.fontMetrics().height() + 4.0)
        painter.drawText(place, _CENTRE, text)


def leg_names() -> tuple[str, str, str]:
    """The names of the legs."""
    return (
        translate("HomingPicture", "top"),
        translate("HomingPicture", "right"),
        translate("HomingPicture", "lower left"),
    )


def _said(view: HomingView) -> str:
    pairs = zip(leg_names(), view.homed, strict=True)
    found = ", ".join(name for name, is_homed in pairs if is_homed)
    nothing = translate("HomingPicture", "none yet")
    return translate("HomingPicture", "Homed: {legs}").format(legs=found or nothing)


def _paint_front(painter: QPainter, room: QRectF, view: HomingView) -> None:
    radius = min(room.width(), room.height()) / 2.0 - 4.0
    centre = room.center()
    painter.setPen(QPen(QColor(theme.BORDER), 1.5))
    painter.setBrush(QColor(theme.FLOOR))
    painter.drawEllipse(centre, radius, radius)
    for leg, azimuth_deg in enumerate(_AZIMUTHS_DEG):
        angle = math.radians(azimuth_deg)
        way = QPointF(math.cos(angle), -math.sin(angle)) * radius
        share = view.legs[leg] if view.legs is not None else 0.0
        _paint_leg(painter, centre, way, share, is_homed=view.homed[leg])
    x, y = view.aside
    place = centre + QPointF(x, -y) * (_FROM * 0.6 * radius)
    _paint_grip(painter, place, view, 0.8 + 0.5 * (view.out or 0.0))


def _paint_leg(
    painter: QPainter, centre: QPointF, way: QPointF, share: float, *, is_homed: bool
) -> None:
    begin, end = centre + way * _FROM, centre + way * _TO
    round_cap = Qt.PenCapStyle.RoundCap
    line = Qt.PenStyle.SolidLine
    painter.setPen(QPen(QColor(theme.BORDER), _LINE_PX, line, round_cap))
    painter.drawLine(begin, end)
    if share > 0.0:
        colour = QColor(theme.GOOD if is_homed else theme.ACCENT)
        painter.setPen(QPen(colour, _LINE_PX, line, round_cap))
        painter.drawLine(begin, begin + (end - begin) * share)
    _paint_sign(painter, centre + way * _SIGN_AT, _SIGN_PX, is_done=is_homed)


def _paint_sign(
    painter: QPainter, at: QPointF, size_px: float, *, is_done: bool
) -> None:
    """Paint a ring, or a disc with a tick."""
    painter.setPen(QPen(QColor(theme.GOOD if is_done else theme.WARN), 2.5))
    painter.setBrush(QColor(theme.GOOD if is_done else theme.PANEL))
    painter.drawEllipse(at, size_px, size_px)
    if not is_done:
        return
    painter.setPen(QPen(QColor(theme.PANEL), 2.5))
    unit = size_px / 10.0
    tick = [QPointF(-4.5, 0.5), QPointF(-1.2, 4.0), QPointF(5.0, -4.0)]
    painter.drawPolyline(QPolygonF([at + point * unit for point in tick]))


def _paint_grip(
    painter: QPainter, at: QPointF, view: HomingView, scale: float = 1.0
) -> None:
    is_known = view.out is not None
    painter.setPen(QPen(QColor(theme.TEXT if is_known else theme.DISABLED), 1.5))
    colour = theme.GOOD if view.is_ready else theme.ACCENT
    painter.setBrush(QColor(colour if is_known else theme.RAISED))
    painter.drawEllipse(at, _GRIP_PX * scale, _GRIP_PX * scale)


def _paint_side(painter: QPainter, room: QRectF, view: HomingView) -> None:
    """Paint the body at the left, and the way of the grip out of it."""
    middle = room.center().y()
    body = QRectF(room.left() + 6.0, middle - 44.0, 40.0, 88.0)
    painter.setPen(QPen(QColor(theme.BORDER), 1.5))
    painter.setBrush(QColor(theme.FLOOR))
    painter.drawRoundedRect(body, 10.0, 10.0)
    begin = QPointF(body.right() + _GRIP_PX + 6.0, middle)
    end = QPointF(room.right() - _GRIP_PX - 12.0, middle)
    painter.setPen(QPen(QColor(theme.BORDER), 4.0))
    painter.drawLine(QPointF(body.right(), middle), end)
    _name_the_ends(painter, begin, end)
    share = 0.5 if view.out is None else view.out
    grip = begin + (end - begin) * share
    if view.is_ready:
        up = QPointF(0.0, -view.aside[1] * 30.0)
        _paint_grip(painter, grip + up, view)
        _paint_sign(painter, body.center(), _SIGN_PX + 3.0, is_done=True)
        return
    _paint_grip(painter, grip, view)
    if view.arrow:
        _paint_arrow(painter, grip, end if view.arrow > 0 else begin)


def _name_the_ends(painter: QPainter, begin: QPointF, end: QPointF) -> None:
    painter.setPen(QPen(QColor(theme.DIM), 1.5))
    for at in (begin, end):
        painter.drawLine(at - QPointF(0.0, 9.0), at + QPointF(0.0, 9.0))
    room = QSizeF(110.0, 20.0)
    for at, text in (
        (begin, translate("HomingPicture", "in")),
        (end, translate("HomingPicture", "out")),
    ):
        place = QRectF(at + QPointF(-55.0, 48.0), room)
        painter.drawText(place, _CENTRE, text)


def _paint_arrow(painter: QPainter, grip: QPointF, goal: QPointF) -> None:
    """Paint where the grip has to go, above it."""
    way = 1.0 if goal.x() > grip.x() else -1.0
    tip = goal + QPointF(0.0, -34.0)
    tail = tip - QPointF(way * max(_ARROW_PX, abs(goal.x() - grip.x())), 0.0)
    colour = QColor(theme.WARN)
    painter.setPen(QPen(colour, 6.0))
    painter.drawLine(tail, tip - QPointF(way * 10.0, 0.0))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    back = tip - QPointF(way * 16.0, 0.0)
    up = QPointF(0.0, 11.0)
    painter.drawPolygon(QPolygonF([tip, back + up, back - up]))
