"""The camera's view of a scene: projection and colours."""

from typing import NamedTuple, Self

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


def rgb_of(red: float, green: float, blue: float) -> Floats32:
    """Return one colour, (3,)."""
    return np.array((red, green, blue), np.float32)


def colour(red: float, green: float, blue: float) -> np.uint32:
    return np.uint32(int(packed(rgb_of(red, green, blue))))


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


FIELD_OF_VIEW_RAD = np.radians(84.0)


class CameraPose(NamedTuple):
    """Where the camera is; `rotation` is sensor (right, front, up) to earth.

    `shake_px` is how far the handlebar moves against the frame, down, `steering_rad`
    how far a steering wheel is turned, to the left.
    """

    position_m: NDArray[np.float64]
    rotation: NDArray[np.float64]
    shake_px: float
    steering_rad: float = 0.0


class CameraRays(NamedTuple):
    """The rays of all pixels, (x (1, width), 1, z (height, 1)) in right, front, up."""

    x: Floats32
    z: Floats32
    focal_px: float

    @classmethod
    def of_size(cls, width: int, height: int) -> Self:
        """Return the view of a frame, its axis in the middle."""
        focal_px = float(0.5 * width / np.tan(0.5 * FIELD_OF_VIEW_RAD))
        x = (np.arange(width, dtype=np.float32) + 0.5 - 0.5 * width) / focal_px
        z = (0.5 * height - 0.5 - np.arange(height, dtype=np.float32)) / focal_px
        return cls(x[None, :], z[:, None], focal_px)

    @property
    def size(self) -> tuple[int, int]:
        """Height and width, px."""
        return self.z.shape[0], self.x.shape[1]

    def rows(self, first: int, last: int) -> "CameraRays":
        return CameraRays(self.x, self.z[first:last], self.focal_px)

    def edges(self, row: Floats32) -> Floats32:
        """Return the component at both ends of each row (height, 2): its extremes."""
        return CameraRays(self.x[:, [0, -1]], self.z, self.focal_px).towards(row)

    def towards(self, row: Floats32) -> Floats32:
        """Return one earth component of all rays; `row` is that of the rotation."""
        return np.asarray((row[0] * self.x) + (row[1] + row[2] * self.z))
