"""How motion becomes force: F[k] = diag(s) M p[k]."""

import enum
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats, frozen

M_AD: Floats = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Frame A to frame D: y and z exchanged, z reversed (Danieau et al. 2012).

Up gives F_y > 0; forward gives F_z < 0: the hand is pulled away from its owner.
"""
M_AD.setflags(write=False)

DEFAULT_GAIN_N_PER_MPS2 = 0.4
DEFAULT_FORCE_LIMIT_N = 4.5


class Feedback(enum.StrEnum):
    """What the hand gets while the clip plays."""

    REALISTIC = "realistic"
    NONE = "none"
    RANDOM = "random"


@dataclass(frozen=True, slots=True, eq=False)
class Mapping:
    """Axes, gain and limit from acceleration (frame A) to force (frame D).

    Attributes:
        axes: (3, 3) signed permutation with determinant +1.
        gain_n_per_mps2: one number for all axes and all sequences by default.
        force_limit_n: magnitude at which the planned force saturates, keeping its
            direction.

    Raises:
        InputError: when `axes` is no proper signed permutation or a number is not
            positive and finite.
    """

    axes: NDArray[np.float64] = field(default_factory=lambda: M_AD)
    gain_n_per_mps2: float = DEFAULT_GAIN_N_PER_MPS2
    force_limit_n: float = DEFAULT_FORCE_LIMIT_N

    def __post_init__(self) -> None:
        axes = frozen(self.axes, (3, 3), Message("mapping axes"))
        is_permutation = np.array_equal(np.abs(axes) @ np.abs(axes).T, np.eye(3))
        if not is_permutation or not np.isclose(np.linalg.det(axes), 1.0):
            raise InputError(
                "mapping axes must be a signed permutation with determinant +1"
            )
        object.__setattr__(self, "axes", axes)
        for name in ("gain_n_per_mps2", "force_limit_n"):
            value = getattr(self, name)
            if not (np.isfinite(value) and value > 0.0):
                raise InputError(
                    "{name} must be a positive number, got {value}",
                    name=name,
                    value=value,
                )
