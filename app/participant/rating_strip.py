"""The strip below a clip that is rated while it plays: dark, still, and never over it."""

from collections.abc import Callable, Iterator

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QCursor,
    QFont,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.participant.questions import digit_of
from app.participant.visual_scale import LabelRoom, rooms_of
from app.widgets import theme
from hapticplayer.study.definition import LiveRating, RatingKind
from hapticplayer.study.live_ratings import RATE_HZ
from hapticplayer.study.rating_rules import AXES
from hapticplayer.study.watching import Watching

TYPED_MS = 2500
"""After so long what was typed is the number."""
STEPS = 20
"""Of a notch of the wheel, and of an arrow key, over the range of a slider."""
_SMALLEST_PX, _OF_HEIGHT = 11, 36  # of a letter
_TEXT, _LINE_AT, _BELOW = 2.35, 0.65, 1.3  # letters: text, line and labels below it
_FOOT = 0.25  # of a letter
_LINE, _TICK, _MARK, _LAMP = 0.10, 0.30, 0.38, 0.55  # of a letter
_HOLDS: dict[str, tuple[Qt.Key, ...]] = {
    "enter": (Qt.Key.Key_Return, Qt.Key.Key_Enter),
    "shift": (Qt.Key.Key_Shift,),
    "control": (Qt.Key.Key_Control,),
}
_ENTER = _HOLDS["enter"]
_ARROWS = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
Axis = Callable[[str], float | None]
"""Where an axis is, from 0 to 1; None while it is not known."""


def _no_axis(_name: str) -> None:
    """Say that no axis is known."""


class RatingStrip(QWidget):
    """Shows what is rated, takes it from mouse, wheel, keys and axes, 50 times a second.

    `asked` means that a number is due.
    """

    asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.axis: Axis = _no_axis
        self.typed, self._language, self._text_px = "", "", 0.0
        self._watching: Watching | None = None
        self._pointer = QPoint()
        self._was_asking: LiveRating | None = None
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.timer = QTimer(self)
        self.timer.setTimerType(Qt.TimerType.PreciseTimer)
        self.timer.setInterval(round(1e3 / RATE_HZ))
        self.timer.timeout.connect(self.beat)
        self._typing = QTimer(self)
        self._typing.setSingleShot(True)
        self._typing.setInterval(TYPED_MS)
        self._typing.timeout.connect(self._give)
        self.hide()

    def begin(self, watching: Watching, language: str) -> None:
        """Take ratings of a clip that begins now."""
        self._watching, self._language = watching, language
        self.typed, self._was_asking = "", None
        texts = (one.text[language] for one in watching.ratings)
        self.setAccessibleName("; ".join(texts))
        self._fit()
        self.show()
        self._put_pointer()
        self.timer.start()

    def end(self) -> None:
        """Take no more."""
        self.timer.stop()
        self._typing.stop()
        self._watching = None
        self.hide()

    # --- what a person does ---------------------------------------------------

    def beat(self) -> None:
        """Follow pointer and axes, and keep where everything is."""
        watching = self._watching
        if watching is None:
            return
        self._follow_pointer(watching)
        for one in watching.ratings:
            for name in set(one.by).intersection(AXES):
                if (share := self.axis(name)) is not None:
                    self._move(one, _at_share(one, share))
        watching.sample()
        asking = watching.asking
        if asking is not self._was_asking:
            self._was_asking, self.typed = asking, ""
            self._typing.stop()
            self.update()
            if asking is not None:
                self.asked.emit()

    def _ratings(self) -> tuple[LiveRating, ...]:
        return self._watching.ratings if self._watching else ()

    def _sliders(self, by: str) -> Iterator[LiveRating]:
        return (one for one in self._ratings() if by in one.by)

    def _move(self, one: LiveRating, value: float) -> None:
        assert self._watching is not None
        least, most = _limits(one)
        value = round(min(max(value, least), most), 3)
        if value != self._watching.values[one.key]:
            self._watching.change(one.key, value)
            self.update()

    def _put_pointer(self) -> None:
        """Put the pointer onto the mark, so that its first move is no jump."""
        for one in self._sliders("mouse"):
            assert self._watching is not None
            at = self._at(one, self._watching.values[one.key]).toPoint()
            QCursor.setPos(self.mapToGlobal(at))
        self._pointer = QCursor.pos()

    def _follow_pointer(self, watching: Watching) -> None:
        pointer = QCursor.pos()
        if pointer == self._pointer:
            return
        self._pointer = pointer
        x = self.mapFromGlobal(pointer).x()
        for one in watching.ratings:
            if "mouse" in one.by:
                line = self._line(one)
                self._move(one, _at_share(one, (x - line.left()) / line.width()))

    def turn(self, notches: int) -> None:
        """Follow the wheel."""
        for one in self._sliders("wheel"):
            self._step(one, notches)

    def _step(self, one: LiveRating, by: int) -> None:
        assert self._watching is not None
        least, most = _limits(one)
        step = max((most - least) / STEPS, 1.0 if most - least >= STEPS else 0.0)
        self._move(one, self._watching.values[one.key] + by * step)

    def take_key(self, event: QKeyEvent, *, is_pressed: bool) -> bool:
        """Whether a key is one of a rating; it is taken then."""
        watching = self._watching
        if watching is None:
            return False
        key = Qt.Key(event.key())
        for one in watching.ratings:
            if one.hold and key in _HOLDS.get(one.hold, (ord(one.hold.upper()),)):
                if not event.isAutoRepeat():
                    watching.change(one.key, float(is_pressed))
                    self.update()
                return True
        if not is_pressed:
            return False
        if key in _ARROWS:
            moved = list(self._sliders("keys"))
            for one in moved:
                self._step(one, _ARROWS[key])
            return bool(moved)
        return self._take_typed(watching.asking, event)

    def _take_typed(self, asking: LiveRating | None, event: QKeyEvent) -> bool:
        if asking is None or asking.spoken:
            return False
        digit = digit_of(event)
        if digit >= 0 and not event.isAutoRepeat():
            self._type(asking, f"{self.typed}{digit}")
        elif event.key() == Qt.Key.Key_Backspace:
            self._type(asking, self.typed[:-1])
        elif event.key() in _ENTER:
            self._give()
        else:
            return False
        return True

    def _type(self, asking: LiveRating, typed: str) -> None:
        """Show a digit; a number that none can follow is given at once."""
        _, most = _limits(asking)
        self.typed = typed if not typed or int(typed) <= most else ""
        self._typing.start()
        if self.typed and (int(self.typed) == 0 or 10 * int(self.typed) > most):
            self._give()
        self.update()

    def _give(self) -> None:
        """Give what was typed, if it is a number that may be."""
        watching, typed = self._watching, self.typed
        asking = watching.asking if watching else None
        self.typed = ""
        self._typing.stop()
        is_number = asking is not None and typed and int(typed) >= _limits(asking)[0]
        if watching is not None and asking is not None and is_number:
            watching.give(asking.key, int(typed))
        self.update()

    # --- how it looks -----------------------------------------------------------

    def _fit(self) -> None:
        """Take letters for the window, and a height for all lines of the texts."""
        high_px = self.window().height()
        font = QFont(self.font())
        font.setPixelSize(max(_SMALLEST_PX, round(high_px / _OF_HEIGHT)))
        self.setFont(font)
        metrics, ratings = self.fontMetrics(), self._ratings()
        letter_px = metrics.height()
        self.resize(self.window().width(), self.height())
        texts = [
            LabelRoom(one.text[self._language], cell.left(), cell.right())
            for one in ratings
            for cell in (self._cell(one),)
        ]
        labels = [room for one in ratings for room in self.label_rooms(one)]
        high = [
            max((r.high_px(metrics) for r in of), default=0) for of in (texts, labels)
        ]
        self._text_px = max(_TEXT * letter_px, high[0])
        below_px = max(letter_px, high[1]) + (_BELOW + _FOOT) * letter_px
        self.setFixedHeight(round(self._text_px + below_px))

    def sizeHint(self) -> QSize:
        return QSize(0, self.height())

    def _cell(self, one: LiveRating) -> QRectF:
        """The part of the strip that a rating has."""
        ratings = self._ratings() or (one,)
        wide_px = self.width() / len(ratings)
        aside_px = 1.0 * self.fontMetrics().height()
        cell = QRectF(ratings.index(one) * wide_px, 0.0, wide_px, self.height())
        return cell.adjusted(aside_px, 0.0, -aside_px, 0.0)

    def _line(self, one: LiveRating) -> QRectF:
        """The line of a slider."""
        cell, letter_px = self._cell(one), float(self.fontMetrics().height())
        thick_px = max(2.0, _LINE * letter_px)
        aside_px = _MARK * letter_px + 2.0
        at_px = self._text_px + _LINE_AT * letter_px - thick_px / 2.0
        wide_px = cell.width() - 2.0 * aside_px
        return QRectF(cell.left() + aside_px, at_px, wide_px, thick_px)

    def _at(self, one: LiveRating, value: float) -> QPointF:
        line, (least, most) = self._line(one), _limits(one)
        share = (value - least) / (most - least)
        return QPointF(line.left() + share * line.width(), line.center().y())

    def paintEvent(self, _event: QPaintEvent) -> None:
        watching = self._watching
        with QPainter(self) as painter:
            painter.fillRect(self.rect(), Qt.GlobalColor.black)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for one in watching.ratings if watching else ():
                if one.kind is RatingKind.SLIDER:
                    self._paint_slider(painter, one)
                elif one.kind is RatingKind.HELD_KEY:
                    self._paint_key(painter, one)
                elif one is self._was_asking:
                    self._paint_number(painter, one)

    def _paint_text(self, painter: QPainter, one: LiveRating) -> None:
        """What is rated, on the first two lines of the cell."""
        box = self._cell(one)
        box.setHeight(self._text_px)
        painter.setPen(_dark("DIM"))
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(box, flags, one.text[self._language])

    def _paint_slider(self, painter: QPainter, one: LiveRating) -> None:
        assert self._watching is not None
        letter_px = float(self.fontMetrics().height())
        self._paint_text(painter, one)
        line = self._line(one)
        painter.fillRect(line, _dark("BORDER"))
        painter.setPen(QPen(_dark("BORDER"), line.height()))
        for value in {*_limits(one), *(label.at for label in one.labels)}:
            at, half = self._at(one, value), QPointF(0.0, _TICK * letter_px)
            painter.drawLine(at - half, at + half)
        painter.setPen(_dark("DIM"))
        for room in self.label_rooms(one):
            room.draw(painter, self._text_px + _BELOW * letter_px, self.height())
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_dark("TEXT"))
        radius_px = _MARK * letter_px
        at = self._at(one, self._watching.values[one.key])
        painter.drawEllipse(at, radius_px, radius_px)

    def label_rooms(self, one: LiveRating) -> list[LabelRoom]:
        """Where the labels of a slider are."""
        cell = self._cell(one)
        edges = cell.left(), cell.right()
        labels = {self._at(one, at).x(): text for at, text in self._labels(one)}
        return rooms_of(self.fontMetrics(), labels, edges)

    def _labels(self, one: LiveRating) -> list[tuple[int, str]]:
        return [(label.at, label.text[self._language]) for label in one.labels]

    def _paint_key(self, painter: QPainter, one: LiveRating) -> None:
        assert self._watching is not None
        self._paint_text(painter, one)
        letter_px = self.fontMetrics().height()
        below_px = self._text_px + (_BELOW - 0.05) * letter_px
        middle = QPointF(self._cell(one).center().x(), below_px)
        is_held = bool(self._watching.values[one.key])
        painter.setPen(QPen(_dark("DIM"), 2.0))
        painter.setBrush(_dark("TEXT") if is_held else Qt.BrushStyle.NoBrush)
        painter.drawEllipse(middle, _LAMP * letter_px, _LAMP * letter_px)

    def _paint_number(self, painter: QPainter, one: LiveRating) -> None:
        self._paint_text(painter, one)
        least, most = (round(limit) for limit in _limits(one))
        box = self._cell(one)
        box.setTop(self._text_px + 0.55 * self.fontMetrics().height())
        range_text = f"{least} \u2013 {most}"
        painter.setPen(_dark("TEXT"))
        text = self.typed or (range_text if one.spoken else f"{range_text}   _")
        painter.drawText(box, Qt.AlignmentFlag.AlignHCenter, text)


def _limits(one: LiveRating) -> tuple[float, float]:
    return float(one.least or 0), float(one.most or 0)


def _at_share(one: LiveRating, share: float) -> float:
    least, most = _limits(one)
    return least + min(max(share, 0.0), 1.0) * (most - least)


def _dark(name: str) -> QColor:
    """A colour of the dark theme: the strip belongs to the clip, not to the pages."""
    return QColor(theme.THEMES[theme.DARK][name])
