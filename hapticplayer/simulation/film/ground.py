"""The ground seen from above, painted where the camera comes, and nowhere else."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.film.colours import Floats32, Pixels

Paint = Callable[[Floats32, Floats32, float], Pixels]
"""Colours (rows, columns) of places east (columns,) and north (rows,), and pixel size."""

SIZE = 2048
_BLOCK = 128
_BLOCKS = SIZE // _BLOCK
_CORNER = 1.4
"""How much farther the ground is at the picture's edges than ahead."""

_NOWHERE = np.iinfo(np.int64).min


@dataclass(slots=True, eq=False)
class GroundTexture:
    """A window on the ground that wraps around and is filled block by block.

    Attributes:
        paint: gives the colours.
        pixel_m: size of a pixel.
        reach_m: up to which distance ahead it is drawn.
        pixels: (SIZE, SIZE); the place (row, column) lies at their remainders.
    """

    paint: Paint
    pixel_m: float
    reach_m: float
    pixels: Pixels = field(default_factory=lambda: np.zeros((SIZE, SIZE), np.uint32))
    _held: NDArray[np.int64] = field(
        default_factory=lambda: np.full((_BLOCKS, _BLOCKS, 2), _NOWHERE)
    )

    def prepare(
        self,
        position_m: NDArray[np.float64],
        ahead: NDArray[np.float64],
        margin_m: float = 0.0,
    ) -> None:
        """Paint what can be seen from a place: the half disc before the camera.

        Args:
            position_m: (2,) east and north.
            ahead: (2,) unit vector to where the camera looks.
            margin_m: how much farther, for places near by.
        """
        block_m = _BLOCK * self.pixel_m
        reach_m = _CORNER * self.reach_m + margin_m + block_m
        first = np.floor((position_m - reach_m) / block_m).astype(np.int64)
        last = np.floor((position_m + reach_m) / block_m).astype(np.int64)
        east, north = np.meshgrid(
            *(np.arange(a, b + 1) for a, b in zip(first, last, strict=True))
        )
        away = np.stack([east, north], axis=-1) * block_m + 0.5 * block_m - position_m
        wanted = np.hypot(away[..., 0], away[..., 1]) < reach_m
        wanted &= away @ ahead > -block_m - margin_m
        held = self._held[north % _BLOCKS, east % _BLOCKS]
        wanted &= (held[..., 0] != north) | (held[..., 1] != east)
        for row, column in zip(north[wanted], east[wanted], strict=True):
            self._fill(int(row), int(column))

    def _fill(self, row: int, column: int) -> None:
        steps = np.arange(_BLOCK, dtype=np.float64) + 0.5
        north = ((row * _BLOCK + steps) * self.pixel_m).astype(np.float32)
        east = ((column * _BLOCK + steps) * self.pixel_m).astype(np.float32)
        at_row, at_column = row % _BLOCKS, column % _BLOCKS
        rows = slice(at_row * _BLOCK, (at_row + 1) * _BLOCK)
        columns = slice(at_column * _BLOCK, (at_column + 1) * _BLOCK)
        self.pixels[rows, columns] = self.paint(east, north, self.pixel_m)
        self._held[at_row, at_column] = (row, column)
