"""The picture on a plain widget, converted into the window's own memory; no GPU needed.

What has another size than its place is converted ahead of time and copied. On a machine without a GPU this costs 0.6 to 0.8 of mpv's x11 output and a fourth
of every OpenGL way (reference/playback.md, part B).
"""

import math

from PySide6.QtCore import QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import (
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QRegion,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.player.letterbox import Box, letterbox
from app.widgets.room import is_seen
from hapticplayer.media import DirectPainter, Picture

_FORMATS = (QImage.Format.Format_RGB32, QImage.Format.Format_ARGB32_Premultiplied)
_MISSES = 10
"""So often in a row a picture had to be copied all the same: they come converted then."""
_LOOK_EVERY = 4
"""What is seen is looked at once for so many pictures: to ask Qt takes 70 us."""


class VideoSurface(QWidget):
    """Shows pictures as they come, with black bars around them.

    Signals:
        target_changed: width and height in device pixels that the next pictures
            should have, and whether they may come as they were decoded.
        double_clicked: a person wants fullscreen, or to leave it.
        pointer_moved: the pointer moved over the picture.
        seen_changed: whether anybody can see the pictures is another; see `look`.
    """

    target_changed = Signal(int, int, bool)
    double_clicked = Signal()
    pointer_moved = Signal()
    seen_changed = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 90)
        self.setMouseTracking(True)
        self.setAccessibleName(self.tr("Picture"))
        self._clip_size = (16, 9)
        self._target = Box(0, 0, 2, 2)
        self._ratio = self.devicePixelRatioF()
        # the target in logical pixels: itself, all that it touches, all that it fills
        self._where, self._aligned, self._covered = QRectF(), QRect(), QRect()
        self._picture: Picture | None = None
        self._whole: Picture | None = None  # the same with pixels, once they are needed
        self._image: QImage | None = None  # of its memory
        self._painter = DirectPainter()
        self._misses = 0
        self._was_seen, self._was_painted = True, False
        self._looked = 0

    @property
    def target(self) -> Box:
        """Where the picture goes, in device pixels."""
        return self._target

    @property
    def image(self) -> QImage | None:
        """What is shown now; its memory is the decoder's, so paint it at once."""
        if self._image is None and self._picture is not None:
            self._whole = whole = self._painter.whole(self._picture)
            rgb32 = QImage.Format.Format_RGB32
            size_px = (whole.width, whole.height)
            self._image = QImage(whole.pixels, *size_px, whole.stride_bytes, rgb32)
        return self._image

    @property
    def picture(self) -> Picture | None:
        """What was presented last."""
        return self._picture

    @property
    def has_picture_of_target_size(self) -> bool:
        """Whether what is shown needs no scaling."""
        picture = self._picture
        return picture is None or _size(picture) == self._target[2:]

    def set_clip_size(self, width_px: int, height_px: int) -> None:
        """Say what shape the clip has; what was shown is forgotten."""
        self._clip_size = (width_px, height_px)
        self.clear()
        self._place()

    def clear(self) -> None:
        """Show black."""
        self._image = self._whole = self._picture = None
        self.update()

    def present(self, picture: Picture) -> None:
        """Paint a picture now; returns when it is on its way to the screen.

        One that shows what is shown already is not painted, one without pixels is left.
        """
        shown = self._picture
        if not picture.has_pixels:
            return
        if shown is not None and picture.owner is shown.owner:
            self._picture = picture
            return
        self._image = self._whole = None
        self._picture = picture
        self._looked = (self._looked + 1) % _LOOK_EVERY
        if self._looked == 0 or not self._was_seen:
            self.look()
        if self._was_seen and self.isVisible():
            self.repaint(self._aligned)

    def look(self) -> None:
        """Notice that the window has been hidden, or is back.

        Until it is painted for the first time it is about to be seen.
        """
        is_seen_now = is_seen(self) or not self._was_painted
        if is_seen_now is not self._was_seen:
            self._was_seen = is_seen_now
            if is_seen_now:
                self.update()
            self.seen_changed.emit(is_seen_now)

    def _place(self) -> None:
        """Find the target anew and ask for pictures of its size."""
        self._ratio = ratio = self.devicePixelRatioF()
        area = (int(self.width() * ratio), int(self.height() * ratio))
        target = letterbox(self._clip_size, area)
        self._where = where = QRectF(*(value / ratio for value in target))
        self._aligned, self._covered = where.toAlignedRect(), _inside(where)
        if target != self._target:
            is_new_size = target[2:] != self._target[2:]
            self._target = target
            self.update()
            if is_new_size:
                self._misses = 0
                self._tell_target()

    def _tell_target(self) -> None:
        is_direct = self._painter.is_possible and self._misses < _MISSES
        self.target_changed.emit(*self._target[2:], is_direct)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Copy the picture to the window; black where there is none.

        Qt paints all of a window that has come to a screen of another scale.
        """
        if self.devicePixelRatioF() != self._ratio:
            self._place()
        # `with`: a traceback keeps this frame, and Qt dies of a painter that lives on
        with QPainter(self) as painter:
            self._paint(painter, event.region())
        if not (self._was_painted and self._was_seen):
            self._was_painted = True
            self.look()

    def _paint(self, painter: QPainter, exposed: QRegion) -> None:
        picture, bounds = self._picture, exposed.boundingRect()
        covered = self._covered if picture is not None else QRect()
        if not covered.contains(bounds):
            painter.setClipRegion(exposed - QRegion(covered))
            painter.fillRect(bounds, Qt.GlobalColor.black)
            painter.setClipping(False)
        if picture is None or self._convert_there(painter, exposed, bounds, picture):
            return
        image = self.image
        if image is not None:
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Source)
            self._draw(painter, self._where, image)

    def _convert_there(
        self, painter: QPainter, exposed: QRegion, bounds: QRect, picture: Picture
    ) -> bool:
        """Convert what comes as it was decoded; False where it has to be copied."""
        if picture.decoded is None:
            return False
        is_done = (
            _size(picture) == self._target[2:]
            and exposed.rectCount() == 1  # else something lies upon it
            and bounds.contains(self._aligned)
            and self._convert_into(painter, picture)
        )
        self._misses = 0 if is_done else self._misses + 1
        if self._misses == _MISSES:
            self._tell_target()
        return is_done

    def _convert_into(self, painter: QPainter, picture: Picture) -> bool:
        window = painter.paintEngine().paintDevice()
        if not isinstance(window, QImage) or window.format() not in _FORMATS:
            return False
        origin = painter.deviceTransform()
        left, top = self._target[:2]
        x, y = round(origin.dx() + left), round(origin.dy() + top)
        stride_bytes = window.bytesPerLine()
        memory = memoryview(window.bits())
        return self._painter.paint(picture, memory, stride_bytes, x, y)

    def _draw(self, painter: QPainter, where: QRectF, image: QImage) -> None:
        if (image.width(), image.height()) == self._target[2:]:
            image.setDevicePixelRatio(self._ratio)
            painter.drawImage(QPointF(where.topLeft()), image)
        else:  # decoded for another size: a few pictures after a resize
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(where, image)

    def resizeEvent(self, _event: QResizeEvent) -> None:
        """Follow the window."""
        self._place()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Toggle fullscreen."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit()

    def mouseMoveEvent(self, _event: QMouseEvent) -> None:
        """Tell that the pointer is being used."""
        self.pointer_moved.emit()


class SurfaceSink:
    """The surface as the player knows it (FrameSink)."""

    def __init__(self, surface: VideoSurface) -> None:
        self.show = surface.present


def _inside(where: QRectF) -> QRect:
    """Return the whole logical pixels that a rectangle covers."""
    left, top = math.ceil(where.left()), math.ceil(where.top())
    right, bottom = math.floor(where.right()), math.floor(where.bottom())
    return QRect(left, top, right - left, bottom - top)


def _size(picture: Picture) -> tuple[int, int]:
    return picture.width, picture.height
