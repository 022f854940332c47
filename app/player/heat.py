"""The force over a whole clip as a strip of colours."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from hapticplayer.model import ForceTrack

BINS = 600
LEAST_PEAK_N = 1.0  # a clip that hardly moves the hand shall not look strong
# From nearly nothing to strong along one line of growing lightness (after viridis and
# inferno): told apart with every kind of colour vision, and in grey.
_STOPS = np.array(
    [[38, 44, 52, 255], [94, 60, 110, 255], [196, 84, 72, 255], [252, 208, 96, 255]],
    dtype=float,
)


def heat_of(
    track: ForceTrack, duration_s: float, bins: int = BINS
) -> NDArray[np.float64]:
    """Return the largest amount of the force in each part of the clip.

    Args:
        track: whose force.
        duration_s: of the clip.
        bins: how many parts.

    Returns:
        (bins,), N.
    """
    edges_s = np.linspace(0.0, duration_s, bins + 1)
    at_edges = np.linalg.norm(track.at(edges_s), axis=1)
    # within a part a linear or held track is largest at one of its own times
    peaks: NDArray[np.float64] = np.maximum(at_edges[:-1], at_edges[1:])
    rows = np.floor(track.time_s / duration_s * bins).astype(np.intp)
    is_inside = (rows >= 0) & (rows < bins)
    amounts = np.linalg.norm(track.force_n, axis=1)
    np.maximum.at(peaks, rows[is_inside], amounts[is_inside])
    return peaks


def heat_image(heat_n: NDArray[np.float64]) -> QImage:
    """Return a picture of one row; the strongest force of the clip is the brightest."""
    share = heat_n / max(LEAST_PEAK_N, float(heat_n.max(initial=0.0)))
    grid = np.linspace(0.0, 1.0, len(_STOPS))
    rgba = np.stack([np.interp(share, grid, _STOPS[:, k]) for k in range(4)], axis=1)
    pixels = np.ascontiguousarray(np.round(rgba).astype(np.uint8))
    width = len(pixels)
    image = QImage(pixels.data, width, 1, 4 * width, QImage.Format.Format_RGBA8888)
    return image.copy()  # which owns its memory
