"""What an inertial sensor recorded."""

import enum
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


class Sampling(enum.StrEnum):
    """What a sample stands for."""

    INSTANT = "instant"
    """The value holds over the interval that ends at its time."""
    AVERAGED = "averaged"
    """The value is the mean over the window whose middle is its time."""


@dataclass(frozen=True, slots=True, eq=False)
class ImuLog:
    """Inertial samples in frame A (x right, y front, z up).

    Attributes:
        time_s: (N,) strictly increasing.
        specific_force_mps2: (N, 3); +1 g along up at rest.
        angular_rate_radps: (N, 3).
        magnetic_field_ut: (N, 3) in microtesla, or None.
        sampling: what one sample stands for.
        source: where it came from, for people.
        valid: (N,) False where a sample was missing and has been filled in, or
            None when all were there.

    Raises:
        InputError: on wrong shapes, values that are not finite, or times that do
            not increase.
    """

    time_s: Floats
    specific_force_mps2: Floats
    angular_rate_radps: Floats
    magnetic_field_ut: NDArray[np.float64] | None = None
    sampling: Sampling = Sampling.INSTANT
    source: str = ""
    valid: NDArray[np.bool_] | None = None

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "time_s", frozen_times(self.time_s, "time_s"))
        for name in ("specific_force_mps2", "angular_rate_radps", "magnetic_field_ut"):
            if getattr(self, name) is not None:
                put(self, name, frozen(getattr(self, name), (None, 3), name))
        if self.valid is not None:
            put(self, "valid", frozen(self.valid, (None,), "valid", np.bool_))
        same_length(
            self.time_s,
            specific_force_mps2=self.specific_force_mps2,
            angular_rate_radps=self.angular_rate_radps,
            magnetic_field_ut=self.magnetic_field_ut,
            valid=self.valid,
        )

    def __len__(self) -> int:
        return len(self.time_s)

    def part(self, chosen: slice) -> "ImuLog":
        """Return some of the samples, neighbours."""
        if len(self) == len(range(*chosen.indices(len(self)))):
            return self
        return replace(self, **arrays_of(self, chosen))

    @property
    def rate_hz(self) -> float:
        """The median sampling rate; 0 with fewer than two samples."""
        if len(self) < 2:
            return 0.0
        return float(1.0 / np.median(np.diff(self.time_s)))
