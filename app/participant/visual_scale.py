"""A line on which a mark is set by mouse, touch or keys; there is none at first."""

from collections.abc import Mapping
from itertools import pairwise
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFontMetrics,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QSlider

from app.widgets import theme

_TOUCH_PX, _WIDE_PX = 44, 240
_LINE, _TICK, _MARK = 0.10, 0.35, 0.42  # of a letter: line, half a tick, radius
_APART = 0.6  # of a letter: between two labels
_INNER = 0.3  # of its room: a label with less on one side is aligned to that edge
_PAGE = 10
_FRAME_PX = 8.0  # of the focus, with what keeps the labels off it
_KEYS = (
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Home, Qt.Key.Key_End),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
)


class VisualScale(QSlider):
    """A slider without a starting mark.

    Args:
        limits: values of the ends.
        labels: of points, drawn below them.
    """

    marked = Signal()

    def __init__(self, limits: tuple[int, int], labels: Mapping[int, str]) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.is_marked = False
        self._labels = labels
        self.setRange(*limits)
        self.setPageStep(_PAGE)
        self.setValue(sum(limits) // 2)  # from where the arrows start
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        # not fixed: a layout would leave it at the height of one line of labels
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def mark(self, value: int) -> None:
        """Set the mark."""
        self.is_marked = True
        self.setValue(value)
        self.update()
        self.marked.emit()

    # --- what a person does --------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._take(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._take(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.accept()

    def _take(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            line = self._line(self.width())
            share = (event.position().x() - line.left()) / line.width()
            share = min(1.0, max(0.0, share))
            span = self.maximum() - self.minimum()
            self.mark(self.minimum() + round(share * span))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Leave the wheel to the page: it sets no mark."""
        event.ignore()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Leave Up, Down, Enter and digits to the page."""
        if event.key() not in _KEYS:
            event.ignore()
            return
        super().keyPressEvent(event)
        self.mark(self.value())

    # --- how it looks --------------------------------------------------------------

    def sizeHint(self) -> QSize:
        """Two letters high, and a line of labels."""
        letter_px = self.fontMetrics().height()
        return QSize(_WIDE_PX, self._above_px() + (letter_px if self._labels else 0))

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def heightForWidth(self, width_px: int) -> int:
        """As high as the labels are that have several lines at this width."""
        rooms, metrics = self.label_rooms(width_px), self.fontMetrics()
        high_px = max((room.high_px(metrics) for room in rooms), default=0)
        return self._above_px() + high_px + (round(_FRAME_PX) if rooms else 0)

    def _above_px(self) -> int:
        """Height of the line with its mark."""
        return max(_TOUCH_PX, round(1.6 * self.fontMetrics().height()))

    def _line(self, width_px: int) -> QRectF:
        """The line, with room for the mark at both ends."""
        letter_px = float(self.fontMetrics().height())
        aside_px = _MARK * letter_px + 4.0
        thick_px = max(3.0, _LINE * letter_px)
        top_px = 0.5 * (self._above_px() - thick_px)
        return QRectF(aside_px, top_px, width_px - 2.0 * aside_px, thick_px)

    def label_rooms(self, width_px: int) -> list["LabelRoom"]:
        """Where the labels are at a width."""
        line = self._line(width_px)
        labels = {self._at(at, line).x(): text for at, text in self._labels.items()}
        edges = _FRAME_PX, width_px - _FRAME_PX
        return rooms_of(self.fontMetrics(), labels, edges)

    def _at(self, value: int, line: QRectF) -> QPointF:
        share = (value - self.minimum()) / (self.maximum() - self.minimum())
        return QPointF(line.left() + share * line.width(), line.center().y())

    def paintEvent(self, _event: QPaintEvent) -> None:
        line, letter_px = self._line(self.width()), self.fontMetrics().height()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(line, QColor(theme.DIM))
            painter.setPen(QPen(QColor(theme.DIM), line.height()))
            for value in (self.minimum(), self.maximum(), *self._labels):
                at, half = self._at(value, line), QPointF(0.0, _TICK * letter_px)
                painter.drawLine(at - half, at + half)
            painter.setPen(QColor(theme.TEXT))
            for room in self.label_rooms(self.width()):
                room.draw(painter, self._above_px(), self.height())
            if self.is_marked:
                painter.setPen(QPen(QColor(theme.TEXT), 2.0))
                painter.setBrush(QColor(theme.PRIMARY))
                radius_px = _MARK * letter_px
                painter.drawEllipse(self._at(self.value(), line), radius_px, radius_px)
            if self.hasFocus():
                painter.setPen(QPen(QColor(theme.FOCUS), 3.0))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                frame = QRectF(self.rect()).adjusted(2, 2, -2, -2)
                painter.drawRoundedRect(frame, 8.0, 8.0)


_ENDLESS_PX = 10_000
_WRAP = Qt.TextFlag.TextWordWrap


class LabelRoom(NamedTuple):
    """Where the label of a point is drawn, in as many lines as it takes."""

    text: str
    left_px: float
    right_px: float
    side: Qt.AlignmentFlag = Qt.AlignmentFlag.AlignHCenter

    def draw(self, painter: QPainter, top_px: float, bottom_px: float) -> None:
        box = QRectF(self.left_px, top_px, self.right_px - self.left_px, 0.0)
        box.setBottom(bottom_px)
        text = self.breakable(painter.fontMetrics())
        painter.drawText(box, self.side | Qt.AlignmentFlag.AlignTop | _WRAP, text)

    def high_px(self, metrics: QFontMetrics) -> int:
        wide_px = max(1, int(self.right_px - self.left_px))
        box = QRect(0, 0, wide_px, _ENDLESS_PX)
        return metrics.boundingRect(box, _WRAP, self.breakable(metrics)).height()

    def breakable(self, metrics: QFontMetrics) -> str:
        """The text; a word that is too long for a line may be broken anywhere."""
        wide_px = self.right_px - self.left_px
        return " ".join(
            word if metrics.horizontalAdvance(word) <= wide_px else "\u200b".join(word)
            for word in self.text.split()
        )


def rooms_of(
    metrics: QFontMetrics,
    labels: Mapping[float, str],
    edges_px: tuple[float, float],
) -> list[LabelRoom]:
    """The room of each label, about up to half the way to its neighbours.

    Args:
        metrics: of the letters.
        labels: by the place of their point, px.
        edges_px: left and right one of all.
    """
    places, half_px = sorted(labels), 0.5 * _APART * metrics.height()
    wide = [metrics.horizontalAdvance(labels[at]) + 2.0 for at in places]
    middles = [(one + other) / 2.0 for one, other in pairwise(places)]
    if len(places) > 2:  # an end has no room outside: as much as its neighbour at most
        for end, edge, sign in ((0, edges_px[0], 1.0), (-1, edges_px[1], -1.0)):
            needed = sign * edge + wide[end] + half_px
            fair = sign * (edge + 2.0 * places[1 if end == 0 else -2]) / 3.0
            middles[end] = sign * max(sign * middles[end], min(needed, fair))
    lefts = [edges_px[0], *(middle + half_px for middle in middles)]
    rights = [*(middle - half_px for middle in middles), edges_px[1]]
    return [
        _room(labels[at], at, left, right, wide_px)
        for at, left, right, wide_px in zip(places, lefts, rights, wide, strict=False)
    ]


def _room(text: str, at: float, left: float, right: float, wide: float) -> LabelRoom:
    """Below its point as far as that is possible; px."""
    if wide <= right - left:
        left = min(max(left, at - wide / 2.0), right - wide)
        return LabelRoom(text, left, left + wide)
    half = min(at - left, right - at)
    if half >= _INNER * (right - left):
        return LabelRoom(text, at - half, at + half)
    is_first = at - left < right - at
    align = Qt.AlignmentFlag
    side = align.AlignLeft if is_first else align.AlignRight
    return LabelRoom(text, left, right, side)
