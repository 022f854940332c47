"""A person's mouse on the timeline."""

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

LEFT = Qt.MouseButton.LeftButton
NO_KEY = Qt.KeyboardModifier.NoModifier


def at(lanes, seconds, y) -> QPoint:
    """Return the place of a time of the clip of two seconds, which is shown whole."""
    return QPoint(round(seconds / 2.0 * lanes.width()), round(y))


def press(lanes, place, keys=NO_KEY) -> None:
    QTest.mousePress(lanes, LEFT, keys, place)


def pull(lanes, begin, end, steps=4) -> None:
    """Move what is held from one place to another."""
    way = QPointF(end - begin)
    for k in range(1, steps + 1):
        QTest.mouseMove(lanes, begin + (way * k / steps).toPoint())


def release(lanes, place) -> None:
    QTest.mouseRelease(lanes, LEFT, NO_KEY, place)


def drag(lanes, begin, end, keys=NO_KEY) -> None:
    press(lanes, begin, keys)
    pull(lanes, begin, end)
    release(lanes, end)


def click(lanes, place, keys=NO_KEY) -> None:
    QTest.mouseClick(lanes, LEFT, keys, place)


def middle(lanes, number) -> QPoint:
    """Return the middle of an effect."""
    return lanes.effect_box(number).center().toPoint()
