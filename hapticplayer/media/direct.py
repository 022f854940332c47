"""Paints pictures straight into the memory of a window, at the time they are shown.

A picture of the size of its place needs no scaling: converting it there takes as long as
copying it there, and until then it waits as it was decoded, in three eighths of the
memory.
"""

import ctypes

from hapticplayer.media.pictures import Picture, PictureConverter
from hapticplayer.media.swscale import Scaler, library


class DirectPainter:
    """What the thread that shows pictures has for those that are as they were decoded."""

    def __init__(self) -> None:
        swscale = library()
        self._scaler = Scaler(swscale) if swscale is not None else None
        self._converter = PictureConverter()

    @property
    def is_possible(self) -> bool:
        """Whether pictures may come as they were decoded."""
        return self._scaler is not None

    def paint(
        self, picture: Picture, memory: memoryview, stride_bytes: int, x: int, y: int
    ) -> bool:
        """Convert a picture into memory of B, G, R, 255; False: not possible there.

        Args:
            picture: as it was decoded.
            memory: all rows of an image, writable.
            stride_bytes: from one of its rows to the next.
            x: column of the picture's upper left pixel in it.
            y: its row.
        """
        if self._scaler is None or picture.decoded is None or x < 0 or y < 0:
            return False
        frame, kind = picture.decoded
        begin = y * stride_bytes + 4 * x
        end = begin + (kind.height - 1) * stride_bytes + 4 * kind.width
        if 4 * (x + kind.width) > stride_bytes or end > memory.nbytes:
            return False
        address = ctypes.addressof(ctypes.c_char.from_buffer(memory))
        size_px = (kind.width, kind.height)
        self._scaler.convert(frame, kind, address + begin, stride_bytes, size_px)
        return True

    def whole(self, picture: Picture) -> Picture:
        """Return a picture with its pixels.

        Raises:
            MediaError: see `PictureConverter`.
        """
        if picture.decoded is None:
            return picture
        size_px = (picture.width, picture.height)
        return self._converter.convert(picture.decoded[0], picture.pts_s, *size_px)
