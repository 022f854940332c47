"""Whether two decoded pictures show the same; quick where they do not."""

from typing import Any

import numpy as np
from av.video.frame import VideoFrame
from av.video.plane import VideoPlane
from numpy.typing import NDArray

from hapticplayer.media.clip_info import rotation_of

# Bytes from one sample of a plane to the next; pictures of other formats count as new.
_SAMPLE_BYTES = {
    **dict.fromkeys(("yuv420p", "yuv422p", "yuv444p", "gray"), 1),
    **dict.fromkeys(("yuvj420p", "yuvj422p", "yuvj444p"), 1),
    **dict.fromkeys(("yuv420p10le", "yuv422p10le", "yuv444p10le"), 2),
}
_GLANCES = 24
"""Rows that are looked at first: what moves is nearly always met there, for 10 us."""
_WORD_BYTES = 8  # compared at once


def shows_the_same(frame: VideoFrame, other: VideoFrame) -> bool:
    """Return whether both become the same picture, sample by sample."""
    sample_bytes = _SAMPLE_BYTES.get(frame.format.name)
    if sample_bytes is None or _kind(frame) != _kind(other):
        return False
    planes = zip(frame.planes, other.planes, strict=True)
    return all(_are_equal(*pair, sample_bytes) for pair in planes)


def _kind(frame: VideoFrame) -> tuple[object, ...]:
    """Return what else a picture is made of."""
    size = (frame.format.name, frame.width, frame.height)
    return (*size, frame.colorspace, frame.color_range, rotation_of(frame))


def _are_equal(one: VideoPlane, two: VideoPlane, sample_bytes: int) -> bool:
    rows, others = _rows(one, sample_bytes), _rows(two, sample_bytes)
    whole = rows.shape[1] // _WORD_BYTES * _WORD_BYTES
    words, other_words = (r[:, :whole].view(np.uint64) for r in (rows, others))
    step = max(1, len(rows) // _GLANCES)
    return (
        np.array_equal(words[::step], other_words[::step])
        and np.array_equal(words, other_words)
        and np.array_equal(rows[:, whole:], others[:, whole:])
    )


def _rows(plane: VideoPlane, sample_bytes: int) -> NDArray[Any]:
    """Return the samples without what fills up the rows."""
    flat = np.frombuffer(memoryview(plane), np.uint8, plane.height * plane.line_size)
    rows = flat.reshape(plane.height, plane.line_size)
    return rows[:, : sample_bytes * plane.width]
