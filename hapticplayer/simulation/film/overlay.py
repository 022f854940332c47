"""A picture with transparency that lies over the lower part of each frame."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.film.colours import Floats32, Pixels, mixed, packed

Reals = NDArray[np.floating[Any]]


@dataclass(frozen=True, slots=True, eq=False)
class Painted:
    """What a painter gives.

    Attributes:
        rgb: (rows, width, 3) 0 to 255.
        cover: (rows, width) 0 to 1.
        spare: rows at the bottom that only show when it moves up.
    """

    rgb: Floats32
    cover: Floats32
    spare: int


def within(distance: Reals, rows: int) -> Floats32:
    """Return a cover that is soft over a pixel at distance 0, in shares of the rows."""
    return np.asarray(np.clip(distance * rows + 0.5, 0.0, 1.0), np.float32)


def lay(rgb: Floats32, cover: Floats32, tint: Reals, over: Reals) -> None:
    """Paint a tint (rows, width, 3) where `over` (rows, width) says."""
    rgb += (tint - rgb) * over[..., None]
    np.maximum(cover, over, out=cover)


class Overlay:
    """Lays a painting over frames: whole pixels are copied, edges are blended."""

    def __init__(self, painted: Painted, left: int = 0) -> None:
        self._rows = len(painted.rgb) - painted.spare
        self._spare = painted.spare
        self._columns = slice(left, left + painted.rgb.shape[1])
        self._pixels = packed(painted.rgb)
        self._solid = painted.cover > 0.995
        self._edge = np.nonzero((painted.cover > 0.004) & ~self._solid)
        self._share = (256.0 * painted.cover[self._edge]).astype(np.uint32)
        self._edge_pixels = self._pixels[self._edge]

    def lay_over(self, canvas: Pixels, down_px: float) -> None:
        """Lay it over a canvas, moved down by `down_px`."""
        shift = int(np.clip(round(down_px), -self._spare, self._spare))
        part = canvas[len(canvas) - self._rows + shift :, self._columns]
        rows = len(part)
        np.copyto(part, self._pixels[:rows], where=self._solid[:rows])
        count = int(np.searchsorted(self._edge[0], rows))
        y, x = self._edge[0][:count], self._edge[1][:count]
        part[y, x] = mixed(part[y, x], self._edge_pixels[:count], self._share[:count])
