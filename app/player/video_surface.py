"""The video on a plain widget: frames are converted when they are painted; no GPU needed."""

import math
from typing import NamedTuple

from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QRegion,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from hapticplayer.media.frames import BgraImage, DecodedFrame, FrameConverter

_SHAPE, _NOTCH = 10_000, 120  # of a wheel, in Qt's eighths of a degree


class Box(NamedTuple):
    """A rectangle in device pixels, from the surface's top left corner."""

    x: int
    y: int
    width: int
    height: int


def letterbox(clip: tuple[int, int], area: tuple[int, int]) -> Box:
    """Return the largest box of the clip's shape in the middle of the area.

    The width is even, as the converter wants it, and rounding never makes a bar of a
    single column or row: a box within a pixel of the area fills it. Sizes are width and
    height, those of the area in device pixels.
    """
    wide, high = max(1, clip[0]), max(1, clip[1])
    room_x, room_y = max(2, area[0]), max(2, area[1])
    if wide * room_y >= high * room_x:
        width, height = room_x, round(room_x * high / wide)
    else:
        width, height = round(room_y * wide / high), room_y
    if abs(room_x - width) <= 1:
        width = room_x
    if abs(room_y - height) <= 1:
        height = room_y
    width, height = max(2, width & ~1), max(2, height)
    return Box((room_x - width) // 2, (room_y - height) // 2, width, height)


def zoomed(box: Box, zoom: float) -> Box:
    """The box grown or shrunk about its middle; its width stays even."""
    if zoom == 1.0:
        return box
    width, height = round(zoom * box.width) & ~1, round(zoom * box.height)
    x, y = box.x + (box.width - width) // 2, box.y + (box.height - height) // 2
    return Box(x, y, max(2, width), max(2, height))


class VideoSurface(QWidget):
    """Shows frames as they come, with black bars around them."""

    double_clicked = Signal()
    pointer_moved = Signal()
    wheeled = Signal(int, bool)
    """Notches, and whether Shift is held."""
    menu_wanted = Signal(QPoint)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 90)
        self.setMouseTracking(True)
        self.setAccessibleName(self.tr("Video"))
        self._clip_size = (16, 9)
        self._aspect: float | None = None
        self.zoom, self._notches = 1.0, 0.0
        self._target = Box(0, 0, 2, 2)
        self._ratio = self.devicePixelRatioF()
        # the target in logical pixels: itself, all that it touches, all that it fills
        self._where, self._aligned, self._covered = QRectF(), QRect(), QRect()
        self._converter = FrameConverter()
        self._frame: DecodedFrame | None = None
        self._image: QImage | None = None  # of the frame, once it is needed
        self._pixels: BgraImage | None = None  # keeps the memory of the image

    @property
    def target(self) -> Box:
        """Where the video goes, in device pixels."""
        return self._target

    @property
    def video_rect(self) -> QRect:
        """Where the video is, in logical pixels, as far as it is inside."""
        return self._aligned.intersected(self.rect())

    def set_aspect(self, ratio: float | None) -> None:
        """Show the video in another shape than its own."""
        self._aspect = ratio
        self._place()

    def set_zoom(self, zoom: float) -> None:
        """Show the video larger or smaller than what fits; 1 fits."""
        self.zoom = zoom
        self._place()

    @property
    def frame(self) -> DecodedFrame | None:
        """What was presented last."""
        return self._frame

    @property
    def image(self) -> QImage | None:
        """The frame in the size of its place; paint it before the next one comes."""
        if self._image is None and self._frame is not None:
            made = self._converter.convert(self._frame, *self._target[2:])
            rgb32 = QImage.Format.Format_RGB32
            size_px = (made.width, made.height)
            self._image = QImage(made.pixels, *size_px, made.stride_bytes, rgb32)
            self._image.setDevicePixelRatio(self._ratio)
            self._pixels = made
        return self._image

    def set_clip_size(self, width_px: int, height_px: int) -> None:
        """Say what shape the clip has; what was shown is forgotten."""
        self._clip_size = (width_px, height_px)
        self.clear()
        self._place()

    def clear(self) -> None:
        """Show black."""
        self._image = self._frame = None
        self.update()

    def present(self, frame: DecodedFrame) -> None:
        """Paint a frame now; returns when it is on its way to the screen.

        In a hidden window, or one that is known to be covered, Qt paints nothing, and
        nothing is converted; it paints the last frame once the window is back.
        """
        self._frame, self._image = frame, None
        self.repaint(self._aligned)

    def _place(self) -> None:
        """Find the target again."""
        self._ratio = ratio = self.devicePixelRatioF()
        area = (int(self.width() * ratio), int(self.height() * ratio))
        shape = self._clip_size
        if self._aspect is not None:
            shape = (round(_SHAPE * self._aspect), _SHAPE)
        target = zoomed(letterbox(shape, area), self.zoom)
        self._where = where = QRectF(*(value / ratio for value in target))
        self._aligned, self._covered = where.toAlignedRect(), _inside(where)
        if target != self._target:
            self._target, self._image = target, None
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Copy the frame to the window; black where there is none.

        Qt paints all of a window that has come to a screen of another scale.
        """
        if self.devicePixelRatioF() != self._ratio:
            self._place()
        # `with`: a traceback keeps this frame, and Qt dies of a painter that lives on
        with QPainter(self) as painter:
            self._paint(painter, event.region())

    def _paint(self, painter: QPainter, exposed: QRegion) -> None:
        image, bounds = self.image, exposed.boundingRect()
        covered = self._covered if image is not None else QRect()
        if not covered.contains(bounds):
            painter.setClipRegion(exposed - QRegion(covered))
            painter.fillRect(bounds, Qt.GlobalColor.black)
            painter.setClipping(False)
        if image is not None:
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Source)
            painter.drawImage(QPointF(self._where.topLeft()), image)

    def resizeEvent(self, _event: QResizeEvent) -> None:
        self._place()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit()

    def mouseMoveEvent(self, _event: QMouseEvent) -> None:
        self.pointer_moved.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Count whole notches: touch pads send small parts of one."""
        turned = event.angleDelta()
        self._notches += (turned.y() or turned.x()) / _NOTCH
        whole = int(self._notches)
        self._notches -= whole
        if whole:
            is_shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self.wheeled.emit(whole, is_shift)
        event.accept()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self.menu_wanted.emit(event.globalPos())


class SurfaceSink:
    """The surface as the player knows it (FrameSink)."""

    def __init__(self, surface: VideoSurface) -> None:
        self.show = surface.present


def _inside(where: QRectF) -> QRect:
    """Return the whole logical pixels that a rectangle covers."""
    left, top = math.ceil(where.left()), math.ceil(where.top())
    right, bottom = math.floor(where.right()), math.floor(where.bottom())
    return QRect(left, top, right - left, bottom - top)
