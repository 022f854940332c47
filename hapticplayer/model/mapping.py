"""How motion becomes force: F[k] = diag(s) M p[k], then the force limit."""

import enum
from collections.abc import Container
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
SOFT_KNEE_N = 2.0
ROTATION_TOLERANCE = 1e-9

AxisGains = tuple[float, float, float]


class Feedback(enum.StrEnum):
    """What the hand gets while the clip plays."""

    REALISTIC = "realistic"
    ESTIMATED = "estimated"
    """In the place of `REALISTIC` where the motion was estimated from the picture."""
    NONE = "none"
    RANDOM = "random"


_MAX_GAIN_N_PER_MPS2 = 1e6
"""Beyond any: every motion would be felt at the limit."""


def rendered_feedback(names: Container[str]) -> Feedback:
    """Return which feedback of a sequence is rendered from its motion.

    Args:
        names: of its feedbacks.
    """
    is_measured = Feedback.REALISTIC in names or Feedback.ESTIMATED not in names
    return Feedback.REALISTIC if is_measured else Feedback.ESTIMATED


class PresetName(enum.StrEnum):
    """How a realistic track is rendered; `sequence.presets` says what each does."""

    FAITHFUL = "faithful"
    BALANCED = "balanced"
    EQUAL = "equal"


@dataclass(frozen=True, slots=True, eq=False)
class Mapping:
    """Axes, gain and limit from acceleration (frame A) to force (frame D).

    Attributes:
        axes: (3, 3) rotation M.
        gain_n_per_mps2: one number for all axes and all sequences by default; or s, one
            for each axis of frame D. Three equal ones become one number.
        force_limit_n: magnitude at which the planned force saturates, keeping its
            direction.
        soft_knee_n: magnitude above which the force approaches the limit smoothly; None
            for a force that is proportional up to the limit.
        lever_arm_m: from the sensor to the point of the rigid body whose acceleration
            is rendered, in frame A.

    Raises:
        InputError: when `axes` is not a rotation, a number is not positive and finite,
            or the knee is not below the limit.
    """

    axes: NDArray[np.float64] = field(default_factory=lambda: M_AD)
    gain_n_per_mps2: float | AxisGains = DEFAULT_GAIN_N_PER_MPS2
    force_limit_n: float = DEFAULT_FORCE_LIMIT_N
    soft_knee_n: float | None = None
    lever_arm_m: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        axes = frozen(self.axes, (3, 3), Message("mapping axes"))
        is_orthogonal = np.allclose(axes @ axes.T, np.eye(3), atol=ROTATION_TOLERANCE)
        if not is_orthogonal or np.linalg.det(axes) < 0.0:
            raise InputError(
                "mapping axes must be a rotation (orthogonal, determinant +1)"
            )
        put = object.__setattr__
        put(self, "axes", axes)
        gain = self.gain_n_per_mps2
        if not isinstance(gain, (int, float)):
            x, y, z = frozen(gain, (3,), "gain_n_per_mps2").tolist()
            put(self, "gain_n_per_mps2", x if x == y == z else (x, y, z))
        numbers = {
            "gain_n_per_mps2": self.gains_n_per_mps2.min(),
            "force_limit_n": self.force_limit_n,
            "soft_knee_n": 1.0 if self.soft_knee_n is None else self.soft_knee_n,
        }
        for name, value in numbers.items():
            if not (np.isfinite(value) and value > 0.0):
                raise InputError(
                    "{name} must be a positive number, got {value}",
                    name=name,
                    value=value,
                )
        if not self.gains_n_per_mps2.max() <= _MAX_GAIN_N_PER_MPS2:
            raise InputError(
                "gain_n_per_mps2 must be at most {most:g}", most=_MAX_GAIN_N_PER_MPS2
            )
        if self.soft_knee_n is not None and self.soft_knee_n >= self.force_limit_n:
            raise InputError(
                "soft_knee_n must be below force_limit_n, got {knee_n} and {limit_n}",
                knee_n=self.soft_knee_n,
                limit_n=self.force_limit_n,
            )
        x, y, z = frozen(self.lever_arm_m, (3,), "lever_arm_m").tolist()
        put(self, "lever_arm_m", (x, y, z))

    @property
    def gains_n_per_mps2(self) -> Floats:
        """(3,) gains of the axes of frame D."""
        return np.full(3, self.gain_n_per_mps2, dtype=np.float64)

    @property
    def moves_point(self) -> bool:
        """Whether the force is that of another point than the sensor's."""
        return any(self.lever_arm_m)
