"""Cells of the frames that show what carries the camera: a dashboard, a handlebar.

What moves with the camera stays where it is in the frame, however the camera rotates. So
do far things while it does not rotate; only these follow when it does.
"""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.extras.frames.features import CELL_PX, Matches
from hapticplayer.model.arrays import Floats

_MEMORY = 0.02  # share of the newest frame
_SLOW_PX = 0.5  # of the flow from frame to frame
_STILL_SHARE = 0.7
_FOLLOWS = 0.5  # of the flow that the rotation alone would bring
_ENOUGH_PX2 = 2.0  # of that flow, squared and summed with memory


class Carrier:
    """Learns frame by frame which cells of 16 px stay put."""

    def __init__(self, width_px: int, height_px: int) -> None:
        self._columns = -(-width_px // CELL_PX)
        count = self._columns * -(-height_px // CELL_PX)
        self._still, self._agree, self._size = (np.zeros(count) for _ in range(3))

    def holds(self, matches: Matches) -> NDArray[np.bool_]:
        """Return which matches (M,) lie in such cells."""
        cell = self.cells(matches)
        stays = self._still > _STILL_SHARE
        follows = self._agree > _FOLLOWS * self._size
        known = self._size > _ENOUGH_PX2
        return np.asarray((stays & known & ~follows)[cell])

    def learn(self, matches: Matches, turned_px: Floats) -> None:
        """Take the flow that the rotation alone would have brought (M, 2), px."""
        cell = self.cells(matches)
        flow = matches.after - matches.before
        is_slow = np.hypot(*flow.T) < _SLOW_PX + np.hypot(*turned_px.T)
        self._still[cell] += _MEMORY * (is_slow - self._still[cell])
        self._agree *= 1.0 - _MEMORY
        self._size *= 1.0 - _MEMORY
        # a fast part is parallax, and says nothing about the rotation
        self._agree[cell] += is_slow * (flow * turned_px).sum(axis=1)
        self._size[cell] += is_slow * (turned_px**2).sum(axis=1)

    def cells(self, matches: Matches) -> NDArray[np.intp]:
        """Return in which cell each match (M,) begins."""
        column, row = (matches.before // CELL_PX).astype(np.intp).T
        return np.asarray(row * self._columns + column)
