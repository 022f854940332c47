"""Turns decoded frames into pictures that can be painted."""

from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, Self

import numpy as np
from av.video.frame import VideoFrame
from av.video.reformatter import Interpolation, VideoReformatter

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_info import rotation_of
from hapticplayer.media.colours import untagged_matrix
from hapticplayer.media.limits import MAX_PIXELS
from hapticplayer.media.picture_memory import PictureMemory, stride_of
from hapticplayer.media.sameness import shows_the_same
from hapticplayer.media.swscale import Kind, Scaler, kind_of, library

_NO_PIXELS = memoryview(b"")


@dataclass(frozen=True, slots=True, eq=False)
class Picture:
    """A picture ready to be painted, top row first.

    Attributes:
        pts_s: media time at which it appears.
        width: px.
        height: px.
        stride_bytes: from one row to the next.
        pixels: B, G, R, 255 for each pixel (QImage.Format_RGB32).
        owner: keeps the memory of `pixels` alive; hold the Picture as long as
            anything points into it. Pictures of one owner are the same.
        decoded: what is yet to be converted, and of which kind it is, see
            `DirectPainter`; `pixels` is empty then.
        has_pixels: whether there is anything to paint; asked several times a picture.
    """

    pts_s: float
    width: int
    height: int
    stride_bytes: int
    pixels: memoryview
    owner: Any
    decoded: tuple[VideoFrame, Kind] | None = None
    has_pixels: bool = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "has_pixels", self.width > 0)

    @classmethod
    def without_pixels(cls, pts_s: float, owner: Any) -> Self:
        """Return what stands for a picture that nobody sees."""
        return cls(pts_s, 0, 0, 0, _NO_PIXELS, owner)

    @classmethod
    def as_decoded(cls, pts_s: float, frame: VideoFrame, kind: Kind) -> Self:
        """Return what is converted when it is shown."""
        size_px = (kind.width, kind.height)
        return cls(pts_s, *size_px, 0, _NO_PIXELS, frame, (frame, kind))

    def as_rgb(self) -> np.ndarray[Any, np.dtype[np.uint8]]:
        """Return a copy as (height, width, 3) RGB; for tests and thumbnails."""
        rows = np.frombuffer(self.pixels, np.uint8, self.height * self.stride_bytes)
        bgra = rows.reshape(self.height, self.stride_bytes)[:, : 4 * self.width]
        return bgra.reshape(self.height, self.width, 4)[:, :, 2::-1].copy()


# The fast way of swscale without scaling leaves the last two or four columns of some
# widths (2 or 4 more than a multiple of 16) as they were in memory; the accurate way
# writes them all and takes 1.2 ms for 720p instead of 0.35.
_FAST = int(Interpolation.BILINEAR)
_TO_THE_EDGE = int(Interpolation.BILINEAR | Interpolation.ACCURATE_RND)

# Handing a small picture to other threads takes as long as what they do for it.
_ALONE_PIXELS = 2560 * 1440
_ALONE, _AUTOMATIC = 1, 0


_LOOK_EVERY = 8
"""Where everything moves, one picture in so many is compared (up to 27 us for 720p)."""


class _Done(NamedTuple):
    """What was converted last, from what, to the size that was asked for."""

    frame: VideoFrame
    wanted: tuple[int, int, bool]
    picture: Picture


class PictureConverter:
    """Scales, rotates and converts to BGRA; reuses swscale's tables, and memory.

    A picture that shows what the one before showed is not converted again: it has the
    same memory and the same owner.
    """

    def __init__(self) -> None:
        self._reformatter = VideoReformatter()
        swscale = library()
        self._scaler = Scaler(swscale) if swscale is not None else None
        self._memory = PictureMemory()
        self._last: _Done | None = None
        self._moved = 0  # pictures since two were the same

    def convert(
        self,
        frame: VideoFrame,
        pts_s: float,
        width_px: int,
        height_px: int,
        is_direct: bool = False,
    ) -> Picture:
        """Return a picture of the size as shown, its width rounded down to even.

        Args:
            frame: decoded.
            pts_s: media time at which it appears.
            width_px: as shown, after rotation.
            height_px: as shown.
            is_direct: a `DirectPainter` takes it as it is, if it has this size.

        Raises:
            MediaError: when the size is absurd; PyAV's errors pass through.
        """
        last, wanted = self._last, (width_px, height_px, is_direct)
        if last and last.wanted == wanted and self._stands(frame, last.frame):
            return replace(last.picture, pts_s=pts_s)
        kind = kind_of(frame) if self._scaler is not None else None
        is_whole = kind and (kind.width, kind.height) == (width_px, height_px)
        if kind is not None and is_whole and is_direct:
            picture = Picture.as_decoded(pts_s, frame, kind)
        else:
            picture = self._converted(frame, pts_s, (width_px, height_px), kind)
        self._last = _Done(frame, wanted, picture)
        return picture

    def _stands(self, frame: VideoFrame, before: VideoFrame) -> bool:
        """Whether nothing moves, as far as that is looked at."""
        self._moved += 1
        if self._moved > _LOOK_EVERY and self._moved % _LOOK_EVERY:
            return False
        if shows_the_same(frame, before):
            self._moved = 0
        return self._moved == 0

    def _converted(
        self,
        frame: VideoFrame,
        pts_s: float,
        size_px: tuple[int, int],
        kind: Kind | None,
    ) -> Picture:
        width, height = max(2, size_px[0] & ~1), max(2, size_px[1])
        if width * height > MAX_PIXELS:
            raise MediaError(
                "{width} x {height} pixels are too large for a picture",
                width=width,
                height=height,
            )
        if self._scaler is not None and kind and width * height <= _ALONE_PIXELS:
            stride_bytes = stride_of(width)
            block = self._memory.take(stride_bytes * height)
            pixels, address = block.memory.bytes.data, block.memory.address
            self._scaler.convert(frame, kind, address, stride_bytes, (width, height))
            return Picture(pts_s, width, height, stride_bytes, pixels, block)
        turns = rotation_of(frame) // 90
        size = (max(2, height & ~1), width) if turns % 2 else (width, height)
        is_scaled = size != (frame.width, frame.height)
        bgra = self._reformatter.reformat(
            frame,
            *size,
            "bgra",
            src_colorspace=untagged_matrix(frame),
            interpolation=_FAST if is_scaled or size[0] % 8 == 0 else _TO_THE_EDGE,
            threads=_ALONE if width * height <= _ALONE_PIXELS else _AUTOMATIC,
        )
        return _picture(bgra, pts_s, turns)


def _picture(bgra: VideoFrame, pts_s: float, turns: int) -> Picture:
    """Wrap PyAV's memory without a copy; rotated pictures are copied once."""
    plane = bgra.planes[0]
    if turns == 0:
        return Picture(
            pts_s, bgra.width, bgra.height, plane.line_size, memoryview(plane), bgra
        )
    rows = np.frombuffer(memoryview(plane), np.uint8).reshape(
        bgra.height, plane.line_size
    )
    pixels = rows[:, : 4 * bgra.width].reshape(bgra.height, bgra.width, 4)
    turned = np.ascontiguousarray(np.rot90(pixels, turns))
    height, width = turned.shape[:2]
    return Picture(pts_s, width, height, 4 * width, turned.reshape(-1).data, turned)
