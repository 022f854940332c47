"""What the smoother assumes about sensors and motion."""

import math
from dataclasses import dataclass, fields

import numpy as np

from hapticplayer.errors import UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration, fused

# A gyro bias that is farther from a calibration is that of another sensor.
OTHER_SENSOR_SIGMAS = 4.0
# Shorter blocks do not show the velocity that their bound would follow.
MIN_BOUNDED_S = 45.0


@dataclass(frozen=True, slots=True)
class SmootherParameters:
    """Settings of the smoother; one set serves hands, heads, pockets and cars.

    Where no source is given, the value was chosen by `benchmarks.motion accuracy`: the
    mean error of recordings with optical truth (hand-held, camera rig, phones on
    people, one car) and of simulated rides. Half or twice of each costs at most 4 %
    (`benchmarks.motion sensitivity`), but for half of gyro_bias_sigma_radps (8 %) and
    twice of vertical_half_width_s (5 %).

    Attributes:
        window_hz: windows of strapdown integration per second.
        node_s: spacing of the nodes.
        node_samples: at least as many samples between nodes, for slow logs of 45 s on.
        rate_noise_rad_per_sqrt_s: angular random walk, with what bias instability
            adds; a MEMS gyro alone has 1e-4 to 1e-3.
        rotation_error: tilt per radian turned that the gyro matrix does not explain.
        accel_noise_mps_per_sqrt_s: velocity random walk.
        accel_error: share of the changing specific force that is wrong (scale,
            linearity, clipping).
        gyro_bias_sigma_radps: prior sigma of the gyro's bias; 2.9 deg/s.
        gyro_matrix_sigma: of each element of its scale and misalignment.
        accel_bias_sigma_mps2: of the accelerometer's bias; more where its gain is off.
        accel_scale_sigma: of its scale, beyond what still spans have corrected.
        still_bias_sigma_radps: of the gyro's bias where there are still spans, about
            its mean there, beside that mean's own sigma.
        still_sigma_factor: on the sigma of that mean, estimated by its scatter from
            second to second; slow turns look still.
        still_accel_mps2: sigma of the acceleration over a zero-velocity interval.
        time_constant_s: of the levelling: accelerations that last much longer are
            taken for gravity, and errors of the gyro decay within it. None derives it
            from the velocity found, place by place.
        first_bound_mps: bound on the velocity in the first solution.
        velocity_factor: bound over the velocity found; above 1, because too tight a
            bound absorbs motion and too wide a one only lets the gyro drift.
        velocity_floor_mps: added in quadrature.
        scale_evidence: a wrong scale of the gyro is looked for from this gain in the
            logarithm of the evidence on; what is found must explain the velocity, too.
        gyro_evidence: a noisier gyro is accepted from this gain on: odds of 12 to 1.
        floor_sigmas: then the plain estimate is preferred where the smoother differs
            from it by more than so many times its own error.
        bound_half_width_s: half width of the span that the velocity is averaged over.
        vertical_half_width_s: of the mean that gives the first vertical.
        solutions: at most as many, but two at the least.
        still_solutions: at most as many while zero-velocity weights change.
        vehicle_solutions: at most as many for a vehicle that turns.
        weight_change: mean change of the zero-velocity weights, natural logarithm,
            that calls for another solution.
        bias_change_radps: change of bias that calls for another integration.
        vehicle_bias_change_radps: the same for a vehicle that turns: 7 degrees of
            heading in two minutes.
        bound_change: mean change of the bound, natural logarithm, that calls for
            another solution.
        block_s: longer recordings are split into blocks with a calibration each.
        margin_s: blocks overlap by twice as much.
        calibration: of the sensor, from other recordings; narrows the priors of bias and
            scale and moves them.
    """

    window_hz: float = 16.0
    node_s: float = 0.75
    node_samples: int = 32
    rate_noise_rad_per_sqrt_s: float = 0.0011
    rotation_error: float = 0.0021
    accel_noise_mps_per_sqrt_s: float = 0.01
    accel_error: float = 0.037
    gyro_bias_sigma_radps: float = 0.05
    gyro_matrix_sigma: float = 0.0065
    accel_bias_sigma_mps2: float = 0.14
    accel_scale_sigma: float = 0.03
    still_bias_sigma_radps: float = 0.0005
    still_sigma_factor: float = 2.0
    still_accel_mps2: float = 0.05
    time_constant_s: float | None = None
    first_bound_mps: float = 1.5
    velocity_factor: float = 6.0
    velocity_floor_mps: float = 0.1
    scale_evidence: float = 0.5
    gyro_evidence: float = 2.5
    floor_sigmas: float = 1.75
    bound_half_width_s: float = 17.0
    vertical_half_width_s: float = 4.0
    solutions: int = 3
    still_solutions: int = 6
    vehicle_solutions: int = 8
    weight_change: float = 0.4
    bias_change_radps: float = 0.02
    vehicle_bias_change_radps: float = 0.001
    bound_change: float = 0.7
    block_s: float = 600.0
    margin_s: float = 40.0
    calibration: SensorCalibration | None = None

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, float) and not 0.0 < value < float("inf"):
                raise UsageError(
                    "{name} must be above zero, not {value}",
                    name=field.name,
                    value=value,
                )

    def gyro_bias_prior(self) -> tuple[Floats, Floats]:
        """Return the expected bias of the gyro (3,) and its sigma (3,), rad/s."""
        usual, sigma = np.zeros(3), np.full(3, self.gyro_bias_sigma_radps)
        known = self.calibration
        if known is None:
            return usual, sigma
        value, known_sigma = known.gyro_bias_radps, known.gyro_bias_sigma_radps
        return fused(np.array(value), np.array(known_sigma), usual, sigma)

    def contradicts(self, gyro_bias_radps: Floats) -> bool:
        """Return whether the bias (3,) found is not that of the calibrated sensor."""
        if self.calibration is None:
            return False
        expected, sigma = self.gyro_bias_prior()
        return math.hypot(*((gyro_bias_radps - expected) / sigma)) > OTHER_SENSOR_SIGMAS

    def accelerometer_prior(self) -> tuple[Floats, Floats]:
        """Return bias and scale error of the accelerometer, expected and sigma, (4,)."""
        usual, sigma = np.zeros(4), np.full(4, self.accel_bias_sigma_mps2)
        sigma[3] = self.accel_scale_sigma
        known = self.calibration
        if known is None:
            return usual, sigma
        value = np.array([*known.accelerometer_bias_mps2, 0.0])
        value[3] = known.accelerometer_scale - 1.0
        known_sigma = [*known.accelerometer_bias_sigma_mps2]
        known_sigma.append(known.accelerometer_scale_sigma)
        return fused(value, np.array(known_sigma), usual, sigma)

    @property
    def fixed_bound_mps(self) -> float | None:
        """The bound on the velocity that goes with the time constant."""
        if self.time_constant_s is None:
            return None
        noise = STANDARD_GRAVITY_MPS2 * self.rate_noise_rad_per_sqrt_s
        return self.time_constant_s**2 * noise / math.sqrt(2.0)

    def time_constant_of_s(self, bound_mps: Floats) -> Floats:
        """Return the time constant for a bound on the velocity.

        The smoother's error falls off as exp(-t / (sqrt(2) T)) with
        T = (2 v^2 / (g q)^2)^(1/4), q the rate noise.
        """
        noise = STANDARD_GRAVITY_MPS2 * self.rate_noise_rad_per_sqrt_s
        return np.sqrt(math.sqrt(2.0) * bound_mps / noise)

    def bias_change_of_radps(self, heading_weight: float) -> float:
        """Return the change of bias that calls for another integration.

        Args:
            heading_weight: of a vehicle, see `Locomotion`.
        """
        usual, vehicle = self.bias_change_radps, self.vehicle_bias_change_radps
        return float(usual ** (1.0 - heading_weight) * vehicle**heading_weight)

    def most_solutions(self, *, weights_change: bool, is_vehicle: bool) -> int:
        usual = self.vehicle_solutions if is_vehicle else self.solutions
        return max(2, usual, self.still_solutions if weights_change else 0)
