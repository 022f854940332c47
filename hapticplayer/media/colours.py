"""Which matrix turns Y'CbCr into R'G'B' when a file is silent about it.

swscale takes BT.601 for every untagged picture; HD video is BT.709. The mean
error of the wrong choice is 9 of 255 levels.
"""

from av.video.frame import VideoFrame
from av.video.reformatter import Colorspace

HD_HEIGHT_PX = 720
"""From here on untagged video is BT.709, as players agree."""

_SWSCALE_KNOWS = frozenset({0, 1, 4, 5, 6, 7, 9})
"""AVColorSpace: RGB, BT.709, FCC, BT.470BG, SMPTE 170M, SMPTE 240M, BT.2020."""

BT709 = 1
"""Value of AVColorSpace, AVColorPrimaries and AVColorTransferCharacteristic."""

LIMITED_RANGE = 1
"""AVCOL_RANGE_MPEG: luma 16 to 235."""


def untagged_matrix(frame: VideoFrame) -> int | None:
    """Return the source matrix to impose, or None where the frame tells its own."""
    if frame.colorspace in _SWSCALE_KNOWS:
        return None
    is_hd = frame.height >= HD_HEIGHT_PX
    return Colorspace.ITU709 if is_hd else Colorspace.ITU601
