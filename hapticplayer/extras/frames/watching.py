"""Follows the frames of a clip: what moved where, and how the camera rotated."""

import functools
import importlib
import importlib.util
import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.frames import FeatureKind
from hapticplayer.errors import InputError, Message, Progress
from hapticplayer.extras.frames.block_vectors import BlockVectors
from hapticplayer.extras.frames.carrier import Carrier
from hapticplayer.extras.frames.egomotion import (
    AHEAD,
    Egomotion,
    egomotion,
    rotation_flow,
)
from hapticplayer.extras.frames.features import (
    CELL_PX,
    Features,
    FeatureTracker,
    Matches,
)
from hapticplayer.installation import how_to_get
from hapticplayer.media.clip_info import probe
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.media.vectors import VectorDecoder
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model.arrays import Floats

LONG_SIDE_PX = 320
"""Frames are looked at in this size."""

FIELD_OF_VIEW_RAD = np.radians(80.0)
"""Assumed along the longer side; another one scales rotation about two axes."""

TO_FRAME_A = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""From the axes of `egomotion`: x right, y down, z ahead."""

FEWEST = 12
"""Fewest matches that give a rotation."""

_MANY_SHARE = 0.3  # of the cells, from which on quality does not suffer
_LEAST_AGREEMENT = 0.3
_MEMORY = 0.15  # share of the newest in the mean direction of travel

Spans = Sequence[tuple[float, float]]


class View(NamedTuple):
    """How frames are looked at.

    Attributes:
        width_px: of the small frames.
        height_px: of the small frames.
        px: size of a pixel at z = 1.
    """

    width_px: int
    height_px: int
    px: float

    @classmethod
    def of(cls, width: int, height: int) -> "View":
        """Return the view of frames of a size."""
        scale, least = LONG_SIDE_PX / max(width, height), 2 * CELL_PX
        small = (max(least, round(scale * side)) for side in (width, height))
        width_px, height_px = small
        focal_px = 0.5 * max(width_px, height_px) / np.tan(0.5 * FIELD_OF_VIEW_RAD)
        return cls(width_px, height_px, float(1.0 / focal_px))

    @property
    def cells(self) -> int:
        """How many cells a frame has."""
        return -(-self.width_px // CELL_PX) * -(-self.height_px // CELL_PX)

    def points(self, places_px: Floats) -> Floats:
        """Return places (M, 2) in the frame at z = 1."""
        sides = np.array([self.width_px, self.height_px])
        return np.asarray((places_px - (0.5 * sides - 0.5)) * self.px)


class Seen(NamedTuple):
    """What a frame and the next one show; axes as in `egomotion`.

    Attributes:
        begin_s: media time of the first frame.
        end_s: media time of the second one.
        before: (M, 2) points of what is not fixed to the camera.
        after: (M, 2) the same points of the second frame.
        cell: (M,) where each is.
        found: the camera's motion, None where too little is seen.
        quality: 0 (not observable, as at a cut) to 1.
        travel: (3,) mean direction of travel so far.
    """

    begin_s: float
    end_s: float
    before: Floats
    after: Floats
    cell: NDArray[np.intp]
    found: Egomotion | None
    quality: float
    travel: Floats


@functools.cache
def why_broken() -> str:
    """Return why OpenCV cannot be loaded though it is installed; "" otherwise."""
    if importlib.util.find_spec("cv2") is None:
        return ""
    try:
        importlib.import_module("cv2")
    except Exception as problem:  # noqa: BLE001 - whatever a broken build raises
        return str(problem)
    return ""


def is_available() -> bool:
    """Whether the optional library is installed and can be loaded."""
    return importlib.util.find_spec("cv2") is not None and not why_broken()


def watched(
    clip: str | os.PathLike[str],
    *,
    spans_s: Spans | None = None,
    kind: FeatureKind = FeatureKind.CORNERS,
    progress: Progress = lambda _share, _step: None,
) -> Iterator[tuple[View, Seen]]:
    """The matches of each pair of frames; memory does not grow with their number.

    Args:
        clip: the video.
        spans_s: begin and end in media time of what is looked at; None for all.
        kind: of the features.
        progress: called with the share done and a step; raises Cancelled to stop.
    """
    features, decode = _BY_KIND[kind]()
    spans_s = spans_s or [(0.0, probe(clip).duration_s)]
    whole_s = sum(end_s - begin_s for begin_s, end_s in spans_s) or 1.0
    done_s = 0.0
    with decode(clip) as decoder:
        view = View.of(decoder.width, decoder.height)
        for begin_s, end_s in spans_s:
            decoder.seek(begin_s)
            watcher = _Watcher(features(view.width_px, view.height_px), view)
            for frame in decoder.frames():
                if frame.pts_s > end_s:
                    break
                done = (done_s + max(0.0, frame.pts_s - begin_s)) / whole_s
                progress(min(1.0, done), Message("following the frames"))
                seen = watcher.step(frame)
                if seen is not None:
                    yield view, seen
            done_s += end_s - begin_s


def opencv() -> Any:
    """Return OpenCV's module; raises InputError where it cannot be loaded."""
    if why := why_broken():
        raise InputError(
            "following frames needs OpenCV, which cannot be loaded ({why})", why=why
        )
    if not is_available():
        raise InputError(
            "following frames needs OpenCV, which is not installed",
            remedy="install hapticplayer[vision], which synchronises without taps, "
            "finds the mounting of a sensor and suggests motion for a plain video ({how})",
            how=how_to_get("vision"),
        )
    cv2 = importlib.import_module("cv2")
    cv2.setNumThreads(1)  # the same result everywhere, and the window keeps its cores
    return cv2


MakeFeatures = Callable[[int, int], Features]


def _corners() -> tuple[MakeFeatures, type[VideoDecoder]]:
    return functools.partial(FeatureTracker, opencv()), VideoDecoder


def _vectors() -> tuple[MakeFeatures, type[VideoDecoder]]:
    return BlockVectors, VectorDecoder


_BY_KIND = {FeatureKind.CORNERS: _corners, FeatureKind.VECTORS: _vectors}


class _Watcher:
    """Follows the frames of one span."""

    def __init__(self, features: Features, view: View) -> None:
        self._features = features
        self._carrier = Carrier(view.width_px, view.height_px)
        self._view = view
        self._many = (
            _MANY_SHARE * (view.width_px // CELL_PX) * (view.height_px // CELL_PX)
        )
        self._travel = AHEAD
        self._last_s = 0.0

    def step(self, frame: DecodedFrame) -> Seen | None:
        """Take the next frame; return what it shows, None at first or if it is left out."""
        if self._features.skips(frame):
            return None
        matches = self._features.step(frame)
        begin_s, self._last_s = self._last_s, frame.pts_s
        if matches is None:
            return None
        loose = ~self._carrier.holds(matches)
        if int(loose.sum()) < FEWEST:
            loose[:] = True
        before, after = (
            self._view.points(px) for px in (matches.before, matches.after)
        )
        found, quality = None, 0.0
        if len(before) >= FEWEST:
            found, quality = self._found(matches, before, after, loose)
        cell = self._carrier.cells(matches)[loose]
        seen = (before[loose], after[loose], cell)
        return Seen(begin_s, frame.pts_s, *seen, found, quality, self._travel)

    def _found(
        self, matches: Matches, before: Floats, after: Floats, loose: NDArray[np.bool_]
    ) -> tuple[Egomotion, float]:
        """Return the motion and its quality, and learn from it."""
        px = self._view.px
        found = egomotion(before[loose], after[loose], self._travel, px)
        turned = rotation_flow((before + after) / 2.0) @ found.rotation_rad
        self._carrier.learn(matches, turned / px)
        share = float(found.is_inlier.mean())
        if share < _LEAST_AGREEMENT:
            return found, 0.0
        travel = self._travel + _MEMORY * (found.travel - self._travel)
        self._travel = travel / np.linalg.norm(travel)
        return found, share * min(1.0, float(loose.sum()) / self._many)
