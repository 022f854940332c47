"""The motion that a rig is to make, known in advance."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats, frozen, frozen_times, same_length
from hapticplayer.model.rig import RigMotion


@dataclass(frozen=True, slots=True, eq=False)
class RigTrack:
    """Motion over media time, lines between the entries; neutral outside of them.

    Attributes:
        time_s: (N,) media time, strictly increasing, N >= 1.
        motion: (N, 15) float32, the numbers of a `RigMotion` in their order.
        active_s: (1, 2) from the first to the last entry.

    Raises:
        InputError: on wrong shapes, values that are not finite, times that do not
            increase, or an empty track.
    """

    time_s: Floats
    motion: NDArray[np.float32]
    active_s: Floats = field(init=False)

    def __post_init__(self) -> None:
        put = object.__setattr__
        width = len(RigMotion._fields)
        put(self, "time_s", frozen_times(self.time_s, "time_s"))
        put(self, "motion", frozen(self.motion, (None, width), "motion", np.float32))
        same_length(self.time_s, motion=self.motion)
        if not len(self.time_s):
            raise InputError("a rig track needs at least one row")
        put(self, "active_s", self.time_s[[0, -1]].reshape(1, 2))
