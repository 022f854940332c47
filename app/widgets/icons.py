"""The drawings in `resources/icons`."""

from functools import cache
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "icons"
_OFF_OPACITY = 0.35
_ONLY_ITS_SHAPE = QPainter.CompositionMode.CompositionMode_SourceIn
_RATIOS = (1.0, 1.25, 1.5, 2.0, 3.0)  # of screens


@cache
def icon(name: str) -> QIcon:
    """Return an icon by the name of its file; empty where it is missing."""
    return QIcon(str(FOLDER / f"{name}.svg"))


@cache
def control_icon(name: str, size_px: int, colour: str) -> QIcon:
    """Return an icon of one size and colour that fades when its control is disabled.

    Qt's own way of greying leaves a light drawing as light as it was.
    """
    made = QIcon()
    for ratio in _RATIOS:
        drawing = icon(name).pixmap(QSize(size_px, size_px), ratio)
        with QPainter(drawing) as painter:
            painter.setCompositionMode(_ONLY_ITS_SHAPE)
            painter.fillRect(drawing.rect(), QColor(colour))
        made.addPixmap(drawing, QIcon.Mode.Normal)
        made.addPixmap(_faded(drawing), QIcon.Mode.Disabled)
    return made


def _faded(drawing: QPixmap) -> QPixmap:
    faded = QPixmap(drawing.size())
    faded.setDevicePixelRatio(drawing.devicePixelRatio())
    faded.fill(Qt.GlobalColor.transparent)
    with QPainter(faded) as painter:
        painter.setOpacity(_OFF_OPACITY)
        painter.drawPixmap(0, 0, drawing)
    return faded
