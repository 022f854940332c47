"""Decoded frames, and their pixels for a screen: colours, rotation and size.

swscale takes BT.601 for every frame without a tag, but HD video is BT.709: the mean
error of the wrong choice is 9 of 255 levels.
"""

from dataclasses import dataclass

import numpy as np
from av.video.frame import VideoFrame
from av.video.reformatter import Colorspace, Interpolation, VideoReformatter
from numpy.typing import NDArray

from hapticplayer.errors import MediaError
from hapticplayer.model.limits import MAX_PIXELS

HD_HEIGHT_PX = 720
"""From here on untagged video is BT.709, as players agree."""

_TAGGED_MATRICES = frozenset({0, 1, 4, 5, 6, 7, 9})
"""AVColorSpace: RGB, BT.709, FCC, BT.470BG, SMPTE 170M, SMPTE 240M, BT.2020."""

# Without scaling, swscale's fast conversion leaves the last two or four columns of some
# widths (2 or 4 more than a multiple of 16) unwritten; the accurate one takes 1.2 ms for
# 720p instead of 0.35.
_FAST = int(Interpolation.BILINEAR)
_ACCURATE = int(Interpolation.BILINEAR | Interpolation.ACCURATE_RND)

# Handing a small frame to other threads takes as long as what they do for it.
_ONE_THREAD_PIXELS = 2560 * 1440
_ONE_THREAD, _AUTOMATIC = 1, 0


@dataclass(frozen=True, slots=True, eq=False)
class DecodedFrame:
    """A frame as it was decoded: a third of the memory that its pixels take.

    It appears at the media time `pts_s`; only the media room looks inside `native`.
    """

    pts_s: float
    duration_s: float
    native: VideoFrame


@dataclass(frozen=True, slots=True, eq=False)
class BgraImage:
    """Pixels for a screen, top row first: B, G, R, 255 (QImage.Format_RGB32).

    `pixels` keeps its memory alive.
    """

    width: int
    height: int
    stride_bytes: int
    pixels: memoryview

    def as_rgb(self) -> NDArray[np.uint8]:
        """Return a copy, (height, width, 3) RGB."""
        rows = np.frombuffer(self.pixels, np.uint8, self.height * self.stride_bytes)
        bgra = rows.reshape(self.height, self.stride_bytes)[:, : 4 * self.width]
        return bgra.reshape(self.height, self.width, 4)[:, :, 2::-1].copy()


class FrameConverter:
    """Scales, rotates and converts frames; for one thread (swscale keeps its tables)."""

    def __init__(self) -> None:
        self._reformatter = VideoReformatter()

    def convert(self, frame: DecodedFrame, width_px: int, height_px: int) -> BgraImage:
        """Return a frame's pixels in the size that is shown, after rotation.

        An odd width is rounded down.

        Raises:
            MediaError: when the size is absurd; PyAV's errors pass through.
        """
        native = frame.native
        width, height = max(2, width_px & ~1), max(2, height_px)
        if width * height > MAX_PIXELS:
            raise MediaError(
                "{width} x {height} pixels are too large for a frame",
                width=width,
                height=height,
            )
        quarter_turns = rotation_of(native) // 90
        size = (width, height)
        if quarter_turns % 2:
            size = (max(2, height & ~1), width)
        is_scaled = size != (native.width, native.height)
        bgra = self._reformatter.reformat(
            native,
            *size,
            "bgra",
            src_colorspace=untagged_matrix(native),
            interpolation=_FAST if is_scaled or size[0] % 8 == 0 else _ACCURATE,
            threads=_ONE_THREAD if width * height <= _ONE_THREAD_PIXELS else _AUTOMATIC,
        )
        return _image(bgra, quarter_turns)

    def convert_grey(
        self, frame: DecodedFrame, width_px: int, height_px: int
    ) -> NDArray[np.uint8]:
        """Return a frame's brightness (height_px, width_px) as shown, after rotation."""
        if not 0 < width_px * height_px <= MAX_PIXELS:
            raise MediaError(
                "{width} x {height} pixels are too large for a frame",
                width=width_px,
                height=height_px,
            )
        native = frame.native
        quarter_turns = rotation_of(native) // 90
        size = (height_px, width_px) if quarter_turns % 2 else (width_px, height_px)
        grey = self._reformatter.reformat(
            native, *size, "gray", interpolation=_FAST, threads=_ONE_THREAD
        )
        plane = grey.planes[0]
        rows = np.frombuffer(memoryview(plane), np.uint8)
        rows = rows.reshape(-1, plane.line_size)[: grey.height, : grey.width]
        return np.ascontiguousarray(np.rot90(rows, quarter_turns))


def _image(bgra: VideoFrame, quarter_turns: int) -> BgraImage:
    """Wrap PyAV's memory without a copy; a rotated frame is copied once."""
    plane = bgra.planes[0]
    stride_bytes, pixels = plane.line_size, memoryview(plane)
    if quarter_turns == 0:
        return BgraImage(bgra.width, bgra.height, stride_bytes, pixels)
    rows = np.frombuffer(pixels, np.uint32).reshape(bgra.height, stride_bytes // 4)
    rotated = np.ascontiguousarray(np.rot90(rows[:, : bgra.width], quarter_turns))
    height, width = rotated.shape
    return BgraImage(width, height, 4 * width, rotated.reshape(-1).data.cast("B"))


def untagged_matrix(frame: VideoFrame) -> int | None:
    """Return the source matrix to impose, or None where the frame has its own."""
    if frame.colorspace in _TAGGED_MATRICES:
        return None
    is_hd = frame.height >= HD_HEIGHT_PX
    return Colorspace.ITU709 if is_hd else Colorspace.ITU601


def rotation_of(frame: VideoFrame) -> int:
    """Return the counterclockwise quarter turns a frame asks for, degrees."""
    return round(frame.rotation / 90.0) % 4 * 90


def check_convertible(frame: VideoFrame) -> None:
    """Convert an empty frame of the same pixel format; PyAV's errors pass through."""
    empty = VideoFrame(16, 16, frame.format.name)
    FrameConverter().convert(DecodedFrame(0.0, 0.0, empty), 16, 16)
