"""The camera's rotation as frames tell it, and who tells it: an extra."""

import dataclasses
import enum
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer import extension
from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats


class FeatureKind(enum.StrEnum):
    """What frames are compared by."""

    CORNERS = "corners"  # followed by OpenCV
    VECTORS = "vectors"  # motion vectors of the codec: coarse


class FrameFunction(NamedTuple):
    """Something that an extra finds in frames.

    Attributes:
        name: such as "watch".
        home: "module:function".
    """

    name: str
    home: str


def has_frames() -> bool:
    """Whether this installation looks at frames at all."""
    return next(extension.rows("frame_functions", FrameFunction), None) is not None


def frame_function(name: str) -> Any:
    """The function of that name.

    Raises:
        InputError: when no extra has it.
    """
    for row in extension.rows("frame_functions", FrameFunction):
        if row.name == name:
            return extension.load(row.home)
    raise InputError(
        "this installation cannot look at the frames of a clip",
        remedy="enter what is asked for by hand (--offset S, --mounting)",
    )


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
