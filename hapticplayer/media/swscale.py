"""swscale asked directly, to convert a picture into memory that is somebody else's.

PyAV converts into fresh memory of its own: a picture of the screen's size is copied from
there once more, and smaller ones leave holes in the heap (see `picture_memory`). The library it has brought takes any address (libswscale/swscale.h). Where that
library is not found, or does not give PyAV's own answer to a small picture, there is no
such way, and nothing else depends on it.
"""

import ctypes
import functools
from pathlib import Path
from typing import Any, NamedTuple

import av
import numpy as np
from av.video.frame import VideoFrame
from av.video.reformatter import Interpolation

from hapticplayer.media.clip_info import rotation_of
from hapticplayer.media.colours import untagged_matrix

# AVPixelFormat, fixed by FFmpeg's ABI.
_YUV420P, _BGRA = 0, 28
_FULL_RANGE = 2  # AVCOL_RANGE_JPEG
_IS_FULL = {"yuv420p": False, "yuvj420p": True}
_MATRICES = frozenset({1, 4, 5, 6, 7, 9})
"""AVColorSpace, for which `sws_getCoefficients` has the same numbers."""
_STEP_PX = 16
"""swscale's fast way writes so many columns at once: no column too many, none left out."""
_ONE = 1 << 16  # contrast and saturation as they are

_Pointers, _Strides = ctypes.c_void_p * 4, ctypes.c_int * 4


class Kind(NamedTuple):
    """What a conversion depends on."""

    width: int
    height: int
    matrix: int
    is_full: bool


def kind_of(frame: VideoFrame) -> Kind | None:
    """Return what kind of picture it is, None for those that are not converted here."""
    is_full = _IS_FULL.get(frame.format.name)
    matrix = untagged_matrix(frame) or frame.colorspace
    fits = frame.width % _STEP_PX == 0 and frame.height % 2 == 0
    if is_full is None or matrix not in _MATRICES or not fits or rotation_of(frame):
        return None
    is_full = is_full or frame.color_range == _FULL_RANGE
    return Kind(frame.width, frame.height, int(matrix), is_full)


class Scaler:
    """Converts pictures of one kind and size after the other; for one thread.

    Args:
        library: from `library`.
    """

    def __init__(self, library: ctypes.CDLL) -> None:
        self._library = library
        self._context: int | None = None
        self._prepared: tuple[Kind, tuple[int, int]] | None = None

    def convert(
        self,
        frame: VideoFrame,
        kind: Kind,
        address: int,
        stride_bytes: int,
        size_px: tuple[int, int],
    ) -> None:
        """Write a picture as B, G, R, 255.

        Args:
            frame: decoded.
            kind: of the frame.
            address: of its upper left pixel; there is room for all rows.
            stride_bytes: from one row to the next; where it is scaled there is room for
                64 bytes more, as whole registers are written.
            size_px: width and height that it shall have.

        Raises:
            MemoryError: when swscale has none.
        """
        if (kind, size_px) != self._prepared:
            self._prepare(kind, size_px)
        planes = frame.planes
        self._library.sws_scale(
            self._context,
            _Pointers(*[plane.buffer_ptr for plane in planes]),
            _Strides(*[plane.line_size for plane in planes]),
            0,
            kind.height,
            _Pointers(address),
            _Strides(stride_bytes),
        )

    def _prepare(self, kind: Kind, size_px: tuple[int, int]) -> None:
        self._release()
        whole_px = (kind.width, kind.height)
        flags = int(Interpolation.BILINEAR)
        context = self._library.sws_getContext(
            *whole_px, _YUV420P, *size_px, _BGRA, flags, None, None, None
        )
        if not context:
            raise MemoryError
        table = self._library.sws_getCoefficients(kind.matrix)
        self._library.sws_setColorspaceDetails(
            context, table, int(kind.is_full), table, 0, 0, _ONE, _ONE
        )
        self._context, self._prepared = context, (kind, size_px)

    def _release(self) -> None:
        context, self._context, self._prepared = self._context, None, None
        if context:
            self._library.sws_freeContext(context)

    def __del__(self) -> None:
        self._release()


@functools.cache
def library() -> ctypes.CDLL | None:
    """Return swscale as PyAV has loaded it, None where it is not to be had."""
    folder = Path(av.__file__).parents[1] / "av.libs"
    found = [*folder.glob("libswscale-*.so*")]
    if len(found) != 1:
        return None
    try:
        loaded = _declared(ctypes.CDLL(str(found[0])))
    except (OSError, AttributeError):  # cannot be loaded, or has other functions
        return None
    major, minor, micro = av.library_versions["libswscale"]
    is_the_same = loaded.swscale_version() == major << 16 | minor << 8 | micro
    return loaded if is_the_same and _agrees(loaded) else None


def _declared(swscale: ctypes.CDLL) -> ctypes.CDLL:
    number, pointer = ctypes.c_int, ctypes.c_void_p
    swscale.swscale_version.restype = ctypes.c_uint
    swscale.sws_getContext.argtypes = [number] * 7 + [pointer] * 3
    swscale.sws_getContext.restype = pointer
    swscale.sws_getCoefficients.argtypes = [number]
    swscale.sws_getCoefficients.restype = pointer
    details: list[Any] = [pointer, pointer, number, pointer, *[number] * 4]
    swscale.sws_setColorspaceDetails.argtypes = details
    swscale.sws_scale.argtypes = [
        *(pointer, _Pointers, _Strides, number, number, _Pointers, _Strides)
    ]
    swscale.sws_freeContext.argtypes = [pointer]
    swscale.sws_freeContext.restype = None
    return swscale


def _agrees(swscale: ctypes.CDLL) -> bool:
    """Whether a small picture becomes what PyAV makes of it, and nothing beside it is written.

    It is an odd number of steps wide: a processor for which steps are twice as long, or
    four times, is found out.
    """
    width, height, beside = 3 * _STEP_PX, 16, 4 * _STEP_PX
    frame = VideoFrame(width, height, "yuv420p")
    frame.colorspace = 1
    for plane in frame.planes:
        plane.update(bytes(37 * k % 256 for k in range(plane.buffer_size)))
    kind = kind_of(frame)
    assert kind is not None
    mine = np.zeros((height, 4 * (width + beside)), np.uint8)
    scaler, stride = Scaler(swscale), mine.shape[1]
    for size in ((width - 2, height - 3), (width, height)):
        scaler.convert(frame, kind, mine.ctypes.data, stride, size)
        flags = Interpolation.BILINEAR
        bgra = frame.reformat(*size, "bgra", interpolation=flags).planes[0]
        theirs = np.frombuffer(memoryview(bgra), np.uint8).reshape(-1, bgra.line_size)
        if not np.array_equal(mine[: size[1], : 4 * size[0]], theirs[:, : 4 * size[0]]):
            return False
    return not mine[:, 4 * width :].any()
