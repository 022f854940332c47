"""Rotation of a camera from frame to frame, estimated from its frames."""

import os

import numpy as np

from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.errors import Progress
from hapticplayer.extras.frames.watching import (
    TO_FRAME_A,
    Seen,
    Spans,
    View,
    is_available,
    watched,
)
from hapticplayer.model.arrays import Floats

_VALUES = 12  # of each interval, in `_table`


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
