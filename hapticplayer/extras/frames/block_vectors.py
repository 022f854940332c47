"""How blocks of the codec moved, as features: coarse, but without OpenCV."""

import numpy as np

from hapticplayer.extras.frames.features import CELL_PX, Matches
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.media.vectors import BlockMotion, block_motion, is_between
from hapticplayer.model.arrays import Floats


class BlockVectors:
    """Means of the vectors in each cell.

    Frames in between two others are left out: their vectors are poorer, and some refer to
    each other.
    """

    def __init__(self, width_px: int, height_px: int) -> None:
        self._size_px = width_px, height_px
        self._columns = -(-width_px // CELL_PX)
        self._has_begun = False

    def skips(self, frame: DecodedFrame) -> bool:
        return is_between(frame)

    def step(self, frame: DecodedFrame) -> Matches | None:
        """Take the next frame; return its matches with the one before, None at first."""
        if not self._has_begun:
            self._has_begun = True
            return None
        return self._means(block_motion(frame, *self._size_px))

    def _means(self, motion: BlockMotion) -> Matches:
        inside = (motion.before >= 0.0) & (motion.before <= np.array(self._size_px) - 1)
        before, after = (places[inside.all(axis=1)] for places in motion)
        column, row = (before // CELL_PX).astype(np.intp).T
        cell = row * self._columns + column
        count = np.bincount(cell)
        filled = count > 0

        def mean(places: Floats) -> Floats:
            sums = [np.bincount(cell, values)[filled] for values in places.T]
            return np.stack(sums, axis=1) / count[filled, None]

        return Matches(mean(before), mean(after))
