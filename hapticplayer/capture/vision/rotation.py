"""Rotation of a camera from frame to frame, estimated from its frames."""

import importlib
import importlib.util
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hapticplayer.capture.vision.carrier import Carrier
from hapticplayer.capture.vision.egomotion import AHEAD, egomotion, rotation_flow
from hapticplayer.capture.vision.features import CELL_PX, FeatureTracker, Matches
from hapticplayer.errors import InputError, Message
from hapticplayer.media.clip_info import probe
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model.arrays import Floats

LONG_SIDE_PX = 320
"""Frames are looked at in this size."""

FIELD_OF_VIEW_RAD = np.radians(80.0)
"""Assumed along the longer side; another one scales rotation about two axes."""

_FEWEST = 12
_MANY_SHARE = 0.3  # of the cells, from which on quality does not suffer
_LEAST_AGREEMENT = 0.3
_VALUES = 12  # of each interval, in `_table`
_MEMORY = 0.15  # share of the newest in the mean direction of travel
_TO_FRAME_A = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])

Progress = Callable[[float, str], None]
Spans = Sequence[tuple[float, float]]


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
    """

    begin_s: Floats
    end_s: Floats
    rotation_rad: Floats
    quality: Floats
    row: Floats
    skew_rad: Floats

    def __len__(self) -> int:
        return len(self.begin_s)


def is_available() -> bool:
    """Whether the optional library is installed."""
    return importlib.util.find_spec("cv2") is not None


def rotation(
    clip: str | os.PathLike[str],
    *,
    spans_s: Spans | None = None,
    progress: Progress = lambda _share, _step: None,
) -> FrameRotation:
    """Follow the frames of a clip; memory does not grow with their size or number.

    Args:
        clip: the video.
        spans_s: begin and end in media time of what is looked at; None for all.
        progress: called with the share done and a step; raises Cancelled to stop.

    Raises:
        InputError: without OpenCV.
        MediaError: when the clip cannot be decoded.
    """
    cv2 = _opencv()
    spans_s = spans_s or [(0.0, probe(clip).duration_s)]
    whole_s = sum(end_s - begin_s for begin_s, end_s in spans_s) or 1.0
    rows: list[Floats] = []
    done_s = 0.0
    with VideoDecoder(clip) as decoder:
        width, height = _small(decoder.width, decoder.height)
        for begin_s, end_s in spans_s:
            decoder.seek(begin_s)
            watcher = _Watcher(cv2, width, height)
            converter = FrameConverter()
            for frame in decoder.frames():
                if frame.pts_s > end_s:
                    break
                done = (done_s + max(0.0, frame.pts_s - begin_s)) / whole_s
                progress(min(1.0, done), Message("following the frames"))
                grey = converter.convert_grey(frame, width, height)
                row = watcher.row(frame.pts_s, grey)
                if row is not None:
                    rows.append(row)
            done_s += end_s - begin_s
    return _table(rows)


def _opencv() -> Any:
    if not is_available():
        raise InputError(
            "rotation from frames needs OpenCV, which is not installed",
            remedy="install hapticplayer[vision], which synchronises without pats "
            "and finds the mounting of a sensor",
        )
    cv2 = importlib.import_module("cv2")
    cv2.setNumThreads(1)  # the same result everywhere, and the window keeps its cores
    return cv2


def _small(width: int, height: int) -> tuple[int, int]:
    """Return the size to look at, px."""
    scale = LONG_SIDE_PX / max(width, height)
    least = 2 * CELL_PX
    return max(least, round(scale * width)), max(least, round(scale * height))


class _Watcher:
    """Follows the frames of one span."""

    def __init__(self, cv2: Any, width: int, height: int) -> None:
        self._tracker = FeatureTracker(cv2)
        self._carrier = Carrier(width, height)
        self._middle_px = np.array([0.5 * width - 0.5, 0.5 * height - 0.5])
        focal = 0.5 * max(width, height) / np.tan(0.5 * FIELD_OF_VIEW_RAD)
        self._px = float(1.0 / focal)
        self._height = height * self._px
        self._many = _MANY_SHARE * (width // CELL_PX) * (height // CELL_PX)
        self._travel = AHEAD
        self._last_s = 0.0

    def row(self, pts_s: float, grey: Any) -> Floats | None:
        """Return the row of `_table` of the interval that ends here, None at first."""
        matches = self._tracker.step(grey)
        begin_s, self._last_s = self._last_s, pts_s
        if matches is None:
            return None
        values = np.zeros(_VALUES - 2)
        if len(matches.before) >= _FEWEST:
            values = self._estimated(matches)
        return np.concatenate([[begin_s, pts_s], values])

    def _estimated(self, matches: Matches) -> Floats:
        """Return rotation, quality, row and skew."""
        before, after = (
            (px - self._middle_px) * self._px for px in (matches.before, matches.after)
        )
        loose = ~self._carrier.holds(matches)
        if int(loose.sum()) < _FEWEST:
            loose[:] = True
        found = egomotion(before[loose], after[loose], self._travel, self._px)
        turned = rotation_flow((before + after) / 2.0) @ found.rotation_rad
        self._carrier.learn(matches, turned / self._px)
        share = float(found.is_inlier.mean())
        if share < _LEAST_AGREEMENT:
            quality = 0.0
        else:
            quality = share * min(1.0, float(loose.sum()) / self._many)
            travel = self._travel + _MEMORY * (found.travel - self._travel)
            self._travel = travel / np.linalg.norm(travel)
        return np.concatenate(
            [
                _TO_FRAME_A @ found.rotation_rad,
                [quality],
                np.abs(_TO_FRAME_A) @ found.height / self._height,
                _TO_FRAME_A @ found.skew_rad * self._height,
            ]
        )


def _table(rows: list[Floats]) -> FrameRotation:
    table = np.array(rows).reshape(-1, _VALUES)
    return FrameRotation(
        begin_s=table[:, 0],
        end_s=table[:, 1],
        rotation_rad=table[:, 2:5],
        quality=table[:, 5],
        row=table[:, 6:9],
        skew_rad=table[:, 9:12],
    )
