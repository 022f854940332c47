"""Three arrows that show how a recorder sat on the actor."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.widgets import theme
from hapticplayer.capture.mounting import AS_RECORDED, axes_matrix
from hapticplayer.model.arrays import Floats

_SIDE_PX = 210
_HEAD = 0.16
_BOX = np.array([0.42, 0.3, 0.3])  # half sides of the recorder
_TURN, _TILT = np.radians(-32.0), np.radians(22.0)


class Triad(QWidget):
    """The recorder's x, y and z as arrows, seen by somebody behind the actor's left.

    The words right, front and up stay where they are; the recorder turns.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setFixedSize(QSize(_SIDE_PX + 30, _SIDE_PX))
        self.axes = AS_RECORDED
        self._up: tuple[float, float, float] | None = None
        self.show_axes(AS_RECORDED, None)

    def show_axes(self, axes: str, up: tuple[float, float, float] | None) -> None:
        """Show a mounting.

        Args:
            axes: right, front and up of the actor in the recorder's axes.
            up: where gravity says that up was, in the recorder's axes.
        """
        self.axes, self._up = axes, up
        right, front, top = axes.split(",")
        text = self.tr("Right is {right}, front is {front}, up is {up}")
        self.setAccessibleName(text.format(right=right, front=front, up=top))
        self.setToolTip(self.accessibleName())
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the recorder and the arrows, the farthest first."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        turn = axes_matrix(self.axes)
        self._paint_words(painter)
        self._paint_box(painter, turn)
        arrows = [(turn[:, k], "xyz"[k], theme.AXIS_COLOURS[k]) for k in range(3)]
        for way, name, colour in sorted(arrows, key=lambda arrow: -_seen(arrow[0])[2]):
            self._paint_arrow(painter, way, name, QColor(colour))
        if self._up is not None:
            self._paint_gravity(painter, turn @ np.array(self._up))
        painter.end()

    def _at(self, place: Floats) -> QPointF:
        x, y, _ = _seen(place)
        scale = 0.29 * self.height()
        return QPointF(0.5 * self.width() + scale * x, 0.55 * self.height() - scale * y)

    def _paint_words(self, painter: QPainter) -> None:
        painter.setPen(QPen(QColor(theme.BORDER), 1, Qt.PenStyle.DotLine))
        for way in np.eye(3):
            painter.drawLine(self._at(-1.2 * way), self._at(1.2 * way))
        painter.setPen(QColor(theme.DIM))
        names = (self.tr("right"), self.tr("front"), self.tr("up"))
        for way, name in zip(np.eye(3), names, strict=True):
            at, wide = self._at(1.8 * way), self.fontMetrics().horizontalAdvance(name)
            beside = at.x() - 0.5 * self.width()
            if abs(beside) > 1.0:  # away from the letter at the arrow
                at += QPointF(math.copysign(0.5 * wide, beside), 0.0)
            self._paint_text(painter, at, name)

    def _paint_text(self, painter: QPainter, at: QPointF, text: str) -> None:
        metrics = self.fontMetrics()
        wide = metrics.horizontalAdvance(text)
        left = min(max(0.0, at.x() - 0.5 * wide), self.width() - wide)
        base = at.y() + 0.35 * metrics.height()
        low = self.height() - metrics.descent()
        painter.drawText(QPointF(left, min(max(metrics.ascent(), base), low)), text)

    def _paint_box(self, painter: QPainter, turn: Floats) -> None:
        """Draw the recorder, its lens on the side where its y is."""
        painter.setPen(QPen(QColor(theme.DIM), 1.2))
        fill = QColor(theme.RAISED)
        fill.setAlpha(190)
        painter.setBrush(fill)
        sides = [(axis, sign) for axis in range(3) for sign in (-1.0, 1.0)]
        for axis, sign in sorted(sides, key=lambda s: -_seen(turn[:, s[0]] * s[1])[2]):
            painter.drawPolygon(
                QPolygonF([self._at(turn @ c) for c in _side(axis, sign)])
            )
            if (axis, sign) == (1, 1.0):
                angles = np.linspace(0.0, 2 * np.pi, 25)
                ring = np.stack(
                    [0.2 * np.cos(angles), 0 * angles + _BOX[1], 0.2 * np.sin(angles)]
                )
                painter.drawPolygon(QPolygonF([self._at(turn @ c) for c in ring.T]))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_arrow(
        self, painter: QPainter, way: Floats, name: str, colour: QColor
    ) -> None:
        painter.setPen(QPen(colour, 2.6))
        painter.setBrush(colour)
        tip, foot = self._at(way), self._at(0.0 * way)
        painter.drawLine(foot, self._at((1.0 - _HEAD) * way))
        along = tip - foot
        length = max(1e-6, float(np.hypot(along.x(), along.y())))
        across = QPointF(-along.y(), along.x()) / length * 5.0
        base = self._at((1.0 - _HEAD) * way)
        if length > 12.0:
            painter.drawPolygon(QPolygonF([tip, base + across, base - across]))
        else:  # it points to or from who looks
            painter.drawEllipse(tip, 5.0, 5.0)
        self._paint_text(painter, self._at(1.2 * way) + QPointF(0.0, -3.0), name)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_gravity(self, painter: QPainter, up: Floats) -> None:
        """Draw where gravity says that up was: a dashed line from the middle."""
        painter.setPen(QPen(QColor(theme.TEXT), 1.6, Qt.PenStyle.DashLine))
        painter.drawLine(self._at(0.0 * up), self._at(1.15 * up))


def _side(axis: int, sign: float) -> list[Floats]:
    """Return the corners of one side of the recorder."""
    first, second = (k for k in range(3) if k != axis)
    corners = []
    for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        corner = np.zeros(3)
        corner[axis], corner[first], corner[second] = sign, a, b
        corners.append(corner * _BOX)
    return corners


def _seen(place: Floats) -> Floats:
    """Return right, up and depth on the screen of a place in frame A."""
    x, y, z = place
    right = np.cos(_TURN) * x + np.sin(_TURN) * y
    deep = -np.sin(_TURN) * x + np.cos(_TURN) * y
    up = np.cos(_TILT) * z + np.sin(_TILT) * deep
    return np.array([right, up, np.cos(_TILT) * deep - np.sin(_TILT) * z])
