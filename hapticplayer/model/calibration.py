"""What is known about a sensor from another recording of it, or another part of it.

It is a prior of the smoother, not a fixed value: the recording itself may correct it.
"""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from hapticplayer.model.arrays import Floats

Vector = tuple[float, float, float]

# Between two recordings of a sensor its errors change by so much (sigma): consumer
# gyros by 0.03 deg/s a kelvin and some kelvins, accelerometers by 1 mg a kelvin.
GYRO_BIAS_CHANGE_RADPS = 0.0035
ACCEL_BIAS_CHANGE_MPS2 = 0.05
ACCEL_SCALE_CHANGE = 0.002
# Largest sigmas: nothing is known.
UNKNOWN_BIAS_SIGMA_RADPS, UNKNOWN_BIAS_SIGMA_MPS2, UNKNOWN_SCALE_SIGMA = 1.0, 10.0, 1.0


@dataclass(frozen=True, slots=True)
class SensorCalibration:
    """Errors of a sensor and how well they are known, in frame A.

    Attributes:
        gyro_bias_radps: (3,).
        gyro_bias_sigma_radps: (3,) its standard deviation.
        accelerometer_bias_mps2: (3,).
        accelerometer_bias_sigma_mps2: (3,) its standard deviation.
        accelerometer_scale: the accelerometer reads so much times the specific force.
        accelerometer_scale_sigma: its standard deviation.
    """

    gyro_bias_radps: Vector = (0.0, 0.0, 0.0)
    gyro_bias_sigma_radps: Vector = (UNKNOWN_BIAS_SIGMA_RADPS,) * 3
    accelerometer_bias_mps2: Vector = (0.0, 0.0, 0.0)
    accelerometer_bias_sigma_mps2: Vector = (UNKNOWN_BIAS_SIGMA_MPS2,) * 3
    accelerometer_scale: float = 1.0
    accelerometer_scale_sigma: float = UNKNOWN_SCALE_SIGMA

    def for_another_recording(self) -> "SensorCalibration":
        """Return it with what changes from one recording to another in its sigmas."""
        return replace(
            self,
            gyro_bias_sigma_radps=_wider(
                self.gyro_bias_sigma_radps, GYRO_BIAS_CHANGE_RADPS
            ),
            accelerometer_bias_sigma_mps2=_wider(
                self.accelerometer_bias_sigma_mps2, ACCEL_BIAS_CHANGE_MPS2
            ),
            accelerometer_scale_sigma=math.hypot(
                self.accelerometer_scale_sigma, ACCEL_SCALE_CHANGE
            ),
        )

    def with_other(self, other: "SensorCalibration") -> "SensorCalibration":
        """Return both together: the mean by variance."""
        together: dict[str, Any] = {}
        for name, sigma_name in _PAIRS:
            mean, sigma = fused(
                *(np.array(getattr(self, one)) for one in (name, sigma_name)),
                *(np.array(getattr(other, one)) for one in (name, sigma_name)),
            )
            together[name], together[sigma_name] = _plain(mean), _plain(sigma)
        return replace(self, **together)

    def turned(self, rotation: Floats) -> "SensorCalibration":
        """Return it in other axes.

        Args:
            rotation: (3, 3) to the other axes, a signed permutation.
        """
        unsigned = np.abs(rotation)
        return replace(
            self,
            gyro_bias_radps=vector(rotation @ self.gyro_bias_radps),
            gyro_bias_sigma_radps=vector(unsigned @ self.gyro_bias_sigma_radps),
            accelerometer_bias_mps2=vector(rotation @ self.accelerometer_bias_mps2),
            accelerometer_bias_sigma_mps2=vector(
                unsigned @ self.accelerometer_bias_sigma_mps2
            ),
        )


def vector(values: Floats) -> Vector:
    """Return three numbers."""
    x, y, z = values.tolist()
    return x, y, z


def fused(
    one: Floats, one_sigma: Floats, other: Floats, other_sigma: Floats
) -> tuple[Floats, Floats]:
    """Return the mean of two independent estimates by their variances, and its sigma."""
    one_weight, other_weight = one_sigma**-2.0, other_sigma**-2.0
    weight = one_weight + other_weight
    mean = (one_weight * one + other_weight * other) / weight
    return np.asarray(mean), np.asarray(weight**-0.5)


_PAIRS = (
    ("gyro_bias_radps", "gyro_bias_sigma_radps"),
    ("accelerometer_bias_mps2", "accelerometer_bias_sigma_mps2"),
    ("accelerometer_scale", "accelerometer_scale_sigma"),
)


def _plain(values: Floats) -> Vector | float:
    return vector(values) if values.ndim else float(values)


def _wider(sigmas: Vector, change: float) -> Vector:
    x, y, z = (math.hypot(sigma, change) for sigma in sigmas)
    return x, y, z
