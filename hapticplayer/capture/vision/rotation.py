"""Rotation of a camera from frame to frame, estimated from its frames."""

import dataclasses
import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.vision.watching import (
    TO_FRAME_A,
    FeatureKind,
    Seen,
    Spans,
    View,
    is_available,
    watched,
)
from hapticplayer.errors import Progress
from hapticplayer.model.arrays import Floats

_VALUES = 12  # of each interval, in `_table`


@dataclass(frozen=True, slots=True, eq=False)
class FrameRotation:
    """Rotation of a camera from each frame to the next one, N intervals.

    Axes are those of the camera as frame A: x right, y front, z up, as the frames are
    shown. Rotation about x and z holds a factor, the same for all, because the field of
    view is not known.

    Attributes:
        begin_s: (N,) media time of the first frame of each interval.
        end_s: (N,) that of the second one.
        rotation_rad: (N, 3) rotation vectors.
        quality: (N,) 0 (not observable, as at a cut) to 1.
        row: (N, 3) mean row of what was followed, by its share in each axis: -0.5 top,
            0.5 bottom. A sensor that reads its rows one after the other tells the
            rotation of the time at which it reads this row.
        skew_rad: (N, 3) by how much the rotation of the bottom row is larger than that
            of the top one.
        kind: of the features that were used.
    """

    begin_s: Floats
    end_s: Floats
    rotation_rad: Floats
    quality: Floats
    row: Floats
    skew_rad: Floats
    kind: FeatureKind = FeatureKind.CORNERS

    def __len__(self) -> int:
        return len(self.begin_s)

    def select(self, rows: NDArray[np.bool_]) -> "FrameRotation":
        """Return the intervals that are chosen (N,)."""
        return dataclasses.replace(
            self,
            begin_s=self.begin_s[rows],
            end_s=self.end_s[rows],
            rotation_rad=self.rotation_rad[rows],
            quality=self.quality[rows],
            row=self.row[rows],
            skew_rad=self.skew_rad[rows],
        )


def rotation(
    clip: str | os.PathLike[str],
    *,
    spans_s: Spans | None = None,
    kind: FeatureKind | None = None,
    progress: Progress = lambda _share, _step: None,
) -> FrameRotation:
    """Follow the frames of a clip; arguments and errors as of `watching.watched`.

    Without a kind of features, the best that there is is taken.
    """
    kind = kind or (FeatureKind.CORNERS if is_available() else FeatureKind.VECTORS)
    steps = watched(clip, spans_s=spans_s, kind=kind, progress=progress)
    return _table([_row(view, seen) for view, seen in steps], kind)


def _row(view: View, seen: Seen) -> Floats:
    """Return the row of `_table`: times, rotation, quality, row and skew."""
    times = [seen.begin_s, seen.end_s]
    if seen.found is None:
        return np.concatenate([times, np.zeros(_VALUES - 2)])
    height = view.height_px * view.px
    return np.concatenate(
        [
            times,
            TO_FRAME_A @ seen.found.rotation_rad,
            [seen.quality],
            np.abs(TO_FRAME_A) @ seen.found.height / height,
            TO_FRAME_A @ seen.found.skew_rad * height,
        ]
    )


def _table(rows: list[Floats], kind: FeatureKind) -> FrameRotation:
    table = np.array(rows).reshape(-1, _VALUES)
    return FrameRotation(
        begin_s=table[:, 0],
        end_s=table[:, 1],
        rotation_rad=table[:, 2:5],
        quality=table[:, 5],
        row=table[:, 6:9],
        skew_rad=table[:, 9:12],
        kind=kind,
    )
