"""Follows image features from one frame to the next."""

from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from hapticplayer.media.frames import DecodedFrame, FrameConverter
from hapticplayer.model.arrays import Floats

Grey = NDArray[np.uint8]

CELL_PX = 16
"""One feature is followed in each square cell of this size."""

_WINDOW_PX, _LEVELS = 15, 3  # of the pyramid below the frame itself
_LEAST_EIGENVALUE = 1e-4  # of the gradient matrix; flat sky and walls have less
_RETURN_PX = 0.5  # there and back again, a feature arrives at its origin


class Matches(NamedTuple):
    """The same features in two frames (M, 2) each: column and row in px."""

    before: Floats
    after: Floats


class Features(Protocol):
    """What finds the same features in two frames."""

    def skips(self, frame: DecodedFrame) -> bool:
        """Whether a frame is left out."""

    def step(self, frame: DecodedFrame) -> Matches | None:
        """Take the next frame; return its matches with the one before, None at first."""


class FeatureTracker:
    """Follows the strongest corner of each cell by pyramidal Lucas-Kanade.

    Source: J.-Y. Bouguet, Pyramidal implementation of the affine Lucas Kanade feature
    tracker, 2001; corners as in Shi and Tomasi, Good features to track, 1994.
    """

    def __init__(self, cv2: Any, width_px: int, height_px: int) -> None:
        self._cv2 = cv2
        self._size_px = width_px, height_px
        self._converter = FrameConverter()
        criteria = cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT
        self._options = {
            "winSize": (_WINDOW_PX, _WINDOW_PX),
            "maxLevel": _LEVELS,
            "criteria": (criteria, 20, 0.01),
        }
        self._grey: Grey | None = None
        self._corners = np.zeros((0, 2), np.float32)

    def skips(self, _frame: DecodedFrame) -> bool:
        """Look at every frame."""
        return False

    def step(self, frame: DecodedFrame) -> Matches | None:
        """Take the next frame; return its matches with the one before, None at first."""
        grey = self._converter.convert_grey(frame, *self._size_px)
        before, corners = self._grey, self._corners
        self._grey, self._corners = grey, self._strongest(grey)
        if before is None:
            return None
        if not len(corners):
            return Matches(np.zeros((0, 2)), np.zeros((0, 2)))
        return self._followed(before, grey, corners)

    def _followed(self, before: Grey, after: Grey, corners: Any) -> Matches:
        follow = self._cv2.calcOpticalFlowPyrLK
        there, is_found, _ = follow(before, after, corners, None, **self._options)
        back, is_back, _ = follow(after, before, there, None, **self._options)
        error_px = np.abs(back - corners).max(axis=1)
        kept = (is_found[:, 0] == 1) & (is_back[:, 0] == 1) & (error_px < _RETURN_PX)
        return Matches(corners[kept].astype(float), there[kept].astype(float))

    def _strongest(self, grey: Grey) -> NDArray[np.float32]:
        """Return the strongest corner of each cell (K, 2)."""
        strength = self._cv2.cornerMinEigenVal(grey, 3)
        rows, columns = (side // CELL_PX for side in grey.shape)
        cells = strength[: rows * CELL_PX, : columns * CELL_PX]
        cells = cells.reshape(rows, CELL_PX, columns, CELL_PX).swapaxes(1, 2)
        cells = cells.reshape(rows * columns, CELL_PX * CELL_PX)
        best = cells.argmax(axis=1)
        cell = np.flatnonzero(cells[np.arange(len(cells)), best] > _LEAST_EIGENVALUE)
        down, across = np.divmod(best[cell], CELL_PX)
        places = (cell % columns * CELL_PX + across, cell // columns * CELL_PX + down)
        return np.stack(places, axis=1).astype(np.float32)
