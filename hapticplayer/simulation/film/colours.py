"""Colours as one uint32 per pixel: a look-up moves a whole pixel at once.

R is the lowest byte, then G, B and an unused one (little endian), so that a canvas
of them becomes RGB by a change of view.
"""

import numpy as np
from numpy.typing import NDArray

Floats32 = NDArray[np.float32]
Pixels = NDArray[np.uint32]

HAZE_FROM_M = 45.0
HAZE_LENGTH_M = 130.0

_OUTER, _MIDDLE, _BYTE = np.uint32(0xFF00FF), np.uint32(0x00FF00), np.uint32(8)


def packed(rgb: Floats32) -> Pixels:
    """Return (..., 3) RGB, 0 to 255, as one uint32 per pixel."""
    levels = np.clip(rgb, 0.0, 255.0).astype(np.uint32)
    shifts = np.array([0, 8, 16], np.uint32)
    return np.asarray(np.bitwise_or.reduce(levels << shifts, axis=-1))


def colour(red: float, green: float, blue: float) -> np.uint32:
    """Return one packed colour."""
    return np.uint32(int(packed(np.array([red, green, blue], np.float32))))


def mixed(
    colours: Pixels, towards: Pixels | np.uint32, share: Pixels | np.uint32
) -> Pixels:
    """Blend packed colours; `share` runs from 0 to 256.

    Red and blue go through one multiplication, because a byte lies between them.
    """
    keep = np.uint32(256) - share
    red_blue = ((colours & _OUTER) * keep + (towards & _OUTER) * share) >> _BYTE
    green = ((colours & _MIDDLE) * keep + (towards & _MIDDLE) * share) >> _BYTE
    return np.asarray((red_blue & _OUTER) | (green & _MIDDLE))


def haze_share(distance_m: Floats32) -> Pixels:
    """Return how much haze lies before a thing, 0 to 256."""
    share = np.float32(HAZE_FROM_M) - distance_m
    share = np.exp(np.minimum(share, 0.0) * np.float32(1.0 / HAZE_LENGTH_M))
    return np.asarray(np.float32(256.0) * (np.float32(1.0) - share)).astype(np.uint32)


HAZE = colour(172.0, 190.0, 186.0)
WHITE = colour(255.0, 252.0, 246.0)
