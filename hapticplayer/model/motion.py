"""How the camera moved once gravity is gone."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import (
    Floats,
    arrays_of,
    frozen,
    frozen_times,
    same_length,
)
from hapticplayer.model.imu import Sampling

DEFAULT_METHOD = "smoother"
"""Of gravity removal, see hapticplayer.motion.METHODS, which is slow to import."""


@dataclass(frozen=True, slots=True, eq=False)
class MotionTrack:
    """Gravity-free acceleration p[k] with what was removed to get it.

    p[k] = a[k] - |g| n_g[k] (Danieau et al. 2012, equation 1), with
    a = accelerometer_gain * specific force.

    Attributes:
        time_s: (N,) of the ImuLog, or media time once mapped.
        acceleration_mps2: (N, 3) in frame A, gravity-free.
        gravity_mps2: (N, 3) the vector that was removed, |g| n_g.
        accelerometer_gain: scale that makes the norm at rest 1 g.
        quaternion_wxyz: (N, 4) unit, sensor to earth.
        gravity_sigma_mps2: (N,) RMS of the gravity error where it is known.
        valid: (N,) False where the motion is not to be trusted (gaps).
        sampling: what one sample stands for, as in the ImuLog.
        is_estimated: whether it was estimated from the picture; nothing measured it.

    Raises:
        InputError: on wrong shapes, values that are not finite, or times that do
            not increase.
    """

    time_s: Floats
    acceleration_mps2: Floats
    gravity_mps2: Floats
    accelerometer_gain: float
    quaternion_wxyz: Floats
    gravity_sigma_mps2: NDArray[np.float64] | None
    valid: NDArray[np.bool_]
    sampling: Sampling = Sampling.INSTANT
    is_estimated: bool = False

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "time_s", frozen_times(self.time_s, "time_s"))
        for name, width in (
            ("acceleration_mps2", 3),
            ("gravity_mps2", 3),
            ("quaternion_wxyz", 4),
        ):
            put(self, name, frozen(getattr(self, name), (None, width), name))
        if self.gravity_sigma_mps2 is not None:
            sigma = frozen(self.gravity_sigma_mps2, (None,), "gravity_sigma_mps2")
            put(self, "gravity_sigma_mps2", sigma)
        put(self, "valid", frozen(self.valid, (None,), "valid", np.bool_))
        same_length(
            self.time_s,
            acceleration_mps2=self.acceleration_mps2,
            gravity_mps2=self.gravity_mps2,
            quaternion_wxyz=self.quaternion_wxyz,
            gravity_sigma_mps2=self.gravity_sigma_mps2,
            valid=self.valid,
        )

    def __len__(self) -> int:
        return len(self.time_s)

    def part(self, chosen: slice) -> "MotionTrack":
        """Return some of the samples, neighbours."""
        if len(self) == len(range(*chosen.indices(len(self)))):
            return self
        return replace(self, **arrays_of(self, chosen))
