"""A motion rig's platform on its six legs, as seen from the left behind."""

import math

from PySide6.QtCore import QCoreApplication, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.plots.rig_platform import (
    BASE_RADIUS_M,
    HOME_M,
    LONGEST_M,
    SHORTEST_M,
    PlatformPose,
    base_m,
    legs_m,
    platform_m,
)
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.model.arrays import Floats

translate = QCoreApplication.translate

LEAST_PX, WANTED_PX = QSize(180, 140), QSize(420, 300)
_FROM_RAD, _ABOVE_RAD = math.radians(-35.0), math.radians(22.0)
_SHOWN_M = 2.6 * BASE_RADIUS_M
_NEAR_AN_END = 0.08


def floor_painter(widget: QWidget) -> QPainter:
    """Return a smooth painter for a picture, its background painted."""
    painter = QPainter(widget)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.fillRect(widget.rect(), QColor(theme.FLOOR))
    return painter


class RigView(QWidget):
    """Draws a pose; the front of the platform has a mark, legs near an end warn."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(LEAST_PX)
        self.setAccessibleName(translate("DevicePicture", "Platform of the rig"))
        self.pose, self.is_clamped = PlatformPose(), False

    def sizeHint(self) -> QSize:
        return WANTED_PX

    def show_pose(self, pose: PlatformPose, *, is_clamped: bool) -> None:
        if (pose, is_clamped) != (self.pose, self.is_clamped):
            self.pose, self.is_clamped = pose, is_clamped
            self.update()

    def spoken(self) -> str:
        """The pose in figures."""
        _, _, up_m, *turns_rad = self.pose
        figures = (1e3 * up_m, *map(math.degrees, turns_rad))
        up, roll, pitch, yaw = (f"{value + 0.0:.0f}" for value in figures)
        said = local(
            translate(
                "DevicePicture",
                "up {up} mm; roll {roll}, pitch {pitch}, yaw {yaw} degrees",
            ).format(up=up, roll=roll, pitch=pitch, yaw=yaw)
        )
        end = translate("DevicePicture", "at the end of its reach")
        return f"{said}; {end}" if self.is_clamped else said

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = floor_painter(self)
        floor, top = base_m(), platform_m(self.pose)
        self._polygon(painter, floor, theme.GRID)
        for below, above, length_m in zip(floor, top, legs_m(self.pose), strict=True):
            spare = min(length_m - SHORTEST_M, LONGEST_M - length_m)
            is_near = spare < _NEAR_AN_END * (LONGEST_M - SHORTEST_M)
            pen = QPen(QColor(theme.WARN if is_near else theme.DIM), 5.0)
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            painter.setPen(pen)
            painter.drawLine(self._seen(below), self._seen(above))
        edge = theme.WARN if self.is_clamped else theme.ACCENT
        self._polygon(painter, top, edge, filled=theme.RAISED)
        painter.setPen(QPen(QColor(edge), 4.0))
        front = 0.5 * (top[0] + top[1])  # between the two joints in front
        painter.drawLine(self._seen(top.mean(axis=0)), self._seen(front))

    def _polygon(
        self, painter: QPainter, points: Floats, edge: str, filled: str = ""
    ) -> None:
        painter.setPen(QPen(QColor(edge), 2.0))
        painter.setBrush(QColor(filled) if filled else Qt.BrushStyle.NoBrush)
        painter.drawPolygon(QPolygonF([self._seen(point) for point in points]))

    def _seen(self, point: Floats) -> QPointF:
        """Return where a point of the room is on the widget, in parallel projection."""
        x, y, z = (float(value) for value in point)
        c, s = math.cos(_FROM_RAD), math.sin(_FROM_RAD)
        across, away = c * x + s * y, c * y - s * x
        up = math.cos(_ABOVE_RAD) * (z - 0.5 * HOME_M) + math.sin(_ABOVE_RAD) * away
        scale = min(self.width(), self.height()) / _SHOWN_M
        return QPointF(
            0.5 * self.width() + scale * across, 0.5 * self.height() - scale * up
        )
