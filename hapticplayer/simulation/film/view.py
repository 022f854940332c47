"""The pinhole camera of the simulator."""

from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.film.colours import Floats32

FIELD_OF_VIEW_RAD = np.radians(84.0)


class Pose(NamedTuple):
    """Where the camera is.

    Attributes:
        position_m: (3,) earth.
        rotation: (3, 3) sensor (right, front, up) to earth.
        shake_px: how far the handlebar moves against the picture, down.
        steering_rad: how far a steering wheel is turned, to the left.
    """

    position_m: NDArray[np.float64]
    rotation: NDArray[np.float64]
    shake_px: float
    steering_rad: float = 0.0


class View(NamedTuple):
    """The rays of all pixels: (x, 1, z) in right, front, up.

    Attributes:
        x: (1, width).
        z: (height, 1).
        focal_px: focal length.
    """

    x: Floats32
    z: Floats32
    focal_px: float

    @classmethod
    def of_size(cls, width: int, height: int) -> Self:
        """Return the view of a picture, its axis in the middle."""
        focal_px = float(0.5 * width / np.tan(0.5 * FIELD_OF_VIEW_RAD))
        x = (np.arange(width, dtype=np.float32) + 0.5 - 0.5 * width) / focal_px
        z = (0.5 * height - 0.5 - np.arange(height, dtype=np.float32)) / focal_px
        return cls(x[None, :], z[:, None], focal_px)

    @property
    def size(self) -> tuple[int, int]:
        """Height and width, px."""
        return self.z.shape[0], self.x.shape[1]

    def rows(self, first: int, last: int) -> "View":
        """Return the view of some rows."""
        return View(self.x, self.z[first:last], self.focal_px)

    def edges(self, row: Floats32) -> Floats32:
        """Return the component at both ends of each row (height, 2): its extremes."""
        return View(self.x[:, [0, -1]], self.z, self.focal_px).towards(row)

    def towards(self, row: Floats32) -> Floats32:
        """Return one earth component of all rays; `row` is that of the rotation."""
        return np.asarray((row[0] * self.x) + (row[1] + row[2] * self.z))
