"""The drawings in `resources/icons`."""

from functools import cache
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon, QPainter, QPixmap

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "icons"
_OFF_OPACITY = 0.35
_OFF_SIZE = QSize(24, 24)


@cache
def icon(name: str) -> QIcon:
    """Return an icon by the name of its file; empty where it is missing."""
    made = QIcon(str(FOLDER / f"{name}.svg"))
    # Qt's own way of greying leaves a light drawing as light as it was
    for ratio in (1.0, 2.0, 3.0):
        made.addPixmap(_faded(made.pixmap(_OFF_SIZE, ratio)), QIcon.Mode.Disabled)
    return made


def _faded(drawing: QPixmap) -> QPixmap:
    faded = QPixmap(drawing.size())
    faded.setDevicePixelRatio(drawing.devicePixelRatio())
    faded.fill(Qt.GlobalColor.transparent)
    with QPainter(faded) as painter:
        painter.setOpacity(_OFF_OPACITY)
        painter.drawPixmap(0, 0, drawing)
    return faded
