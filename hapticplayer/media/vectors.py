"""The motion vectors with which a clip was compressed: how blocks move between frames.

A codec chooses them to save bits, not to follow things, but where a scene has detail both
are the same. FFmpeg shows those of H.264, not those of H.265 and others.
"""

from typing import ClassVar, NamedTuple

import numpy as np
from av.sidedata.motionvectors import MotionVectors
from av.video.frame import PictureType, VideoFrame
from numpy.typing import NDArray

from hapticplayer.errors import MediaError
from hapticplayer.installation import how_to_get
from hapticplayer.media.frames import DecodedFrame, rotation_of
from hapticplayer.media.video import VideoDecoder

CODEC = "h264"


class BlockMotion(NamedTuple):
    """The middle of blocks (M, 2) in the earlier and in the later one of two frames.

    Column and row, in px of the size asked for; the middle of the first pixel is at 0.
    """

    before: NDArray[np.float64]
    after: NDArray[np.float64]


class VectorDecoder(VideoDecoder):
    """A `VideoDecoder` whose frames hold their motion vectors.

    Raises:
        MediaError: also when the codec shows no vectors.
    """

    _OPTIONS: ClassVar = {"flags2": "+export_mvs"}

    def _set_up(self) -> None:
        super()._set_up()
        codec = self._stream.codec_context.name
        if codec != CODEC:
            raise MediaError(
                "its video ({codec}) holds no motion vectors that can be read",
                where=str(self._path),
                remedy="install hapticplayer[vision] ({how}), or convert it to H.264",
                how=how_to_get("vision"),
                codec=codec,
            )


def is_between(frame: DecodedFrame) -> bool:
    """Whether a frame also refers to later ones (a B frame)."""
    return bool(frame.native.pict_type == PictureType.B)


def block_motion(frame: DecodedFrame, width_px: int, height_px: int) -> BlockMotion:
    """Return how blocks moved from an earlier frame to this one; empty for a key frame.

    Vectors do not say to which frame they refer: of frames that are not in between it is
    the last of these. A few encoders also refer to earlier ones.

    Args:
        frame: of a `VectorDecoder`, not in between.
        width_px: of the frame as shown, after rotation.
        height_px: likewise.
    """
    native = frame.native
    vectors = native.side_data.get("MOTION_VECTORS")
    if not isinstance(vectors, MotionVectors):
        return BlockMotion(np.zeros((0, 2)), np.zeros((0, 2)))
    table = vectors.to_ndarray()
    table = table[(table["source"] < 0) & (table["motion_scale"] > 0)]
    after = np.stack([table["dst_x"], table["dst_y"]], axis=1).astype(float)
    moved = np.stack([table["motion_x"], table["motion_y"]], axis=1)
    before = after + moved / table["motion_scale"][:, None]
    size_px = width_px, height_px
    return BlockMotion(_shown(before, native, size_px), _shown(after, native, size_px))


def _shown(
    places: NDArray[np.float64], native: VideoFrame, size_px: tuple[int, int]
) -> NDArray[np.float64]:
    """Turn and scale places in a native frame, measured from its corner."""
    width, height = native.width, native.height
    for _ in range(rotation_of(native) // 90):
        places = np.stack([places[:, 1], width - places[:, 0]], axis=1)
        width, height = height, width
    return np.asarray(places * np.divide(size_px, (width, height)) - 0.5)
