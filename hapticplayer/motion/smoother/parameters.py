"""What the smoother assumes about sensors and motion."""

import math
from dataclasses import dataclass, fields

import numpy as np

from hapticplayer.errors import UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats


@dataclass(frozen=True, slots=True)
class SmootherParameters:
    """Settings of `smoother`; one set serves hands, heads, pockets and cars.

    Where no source is given, the value was found on recordings with optical truth
    (hand-held, camera rig, phones on people, one car) and on simulated rides, by
    the mean error of all; each is flat within a factor of about two.

    Attributes:
        window_hz: windows of strapdown integration per second.
        node_s: spacing of the smoother's nodes.
        node_samples: at least as many samples to a node, for slow logs.
        rate_noise_rad_per_sqrt_s: angular random walk, with what bias instability
            adds; a MEMS gyro alone has 1e-4 to 1e-3.
        rotation_error: tilt per radian turned that the gyro matrix does not explain.
        force_noise_mps_per_sqrt_s: velocity random walk.
        force_error: share of the changing specific force that is wrong (scale,
            linearity, clipping).
        gyro_bias_radps: standard deviation of the gyro's bias before anything is
            known; 2.9 deg/s.
        gyro_matrix: the same for each element of scale and misalignment.
        accelerometer_bias_mps2: the same for the accelerometer's bias; more where its
            gain is off.
        force_scale: the same for the accelerometer's scale, beyond what still spans
            have put right.
        still_bias_radps: the same for the gyro's bias where still spans were found,
            about its mean there, besides that mean's own scatter.
        still_scatter: by how much the mean over still spans is less certain than
            its scatter from second to second says; slow turns look still.
        rest_mps2: how much a sensor may be accelerated where it stands still.
        time_constant_s: of the levelling: accelerations that last much longer are
            taken for gravity, and errors of the gyro die out within it. None finds
            how fast the sensor moves and derives it from that, place by place.
        velocity_start_mps: assumed in the first solution.
        velocity_factor: bound per velocity found; above 1, because a bounded
            velocity that is too tight eats the motion and one too wide only lets
            the gyro drift.
        velocity_floor_mps: added in quadrature.
        local_s: half width of the span over which the velocity is averaged.
        rough_s: half width of the mean that gives the first vertical.
        rest_solutions: at most as many while still spans are being weighed.
        retrust: mean change of their weights, natural logarithm, that calls for
            another solution.
        rebias_radps: a bias that moves by more calls for another integration.
        steered_rebias_radps: the same for what drives and turns, see `travel`: 7 degrees
            of heading in two minutes.
        rebound: mean change of the bound, natural logarithm, that calls for another
            solution.
        solutions: at most as many, but two at the least.
        steered_solutions: at most as many for what drives and turns.
        block_s: longer recordings are taken in blocks, each with its own calibration.
        margin_s: blocks overlap by twice as much.
        shortcuts: whether work is skipped that a recording does not need: rotations
            to first order where hardly anything turns, the gyro's matrix where
            little does, the full rate and half of the nodes where it stands still from
            beginning to end.
    """

    window_hz: float = 16.0
    node_s: float = 0.75
    node_samples: int = 32
    rate_noise_rad_per_sqrt_s: float = 0.0011
    rotation_error: float = 0.0021
    force_noise_mps_per_sqrt_s: float = 0.01
    force_error: float = 0.037
    gyro_bias_radps: float = 0.05
    gyro_matrix: float = 0.0065
    accelerometer_bias_mps2: float = 0.14
    force_scale: float = 0.03
    still_bias_radps: float = 0.0005
    still_scatter: float = 2.0
    rest_mps2: float = 0.05
    rest_solutions: int = 6
    retrust: float = 0.4
    time_constant_s: float | None = None
    velocity_start_mps: float = 1.5
    velocity_factor: float = 6.0
    velocity_floor_mps: float = 0.1
    local_s: float = 17.0
    rough_s: float = 4.0
    rebias_radps: float = 0.02
    steered_rebias_radps: float = 0.001
    rebound: float = 0.7
    solutions: int = 3
    steered_solutions: int = 8
    block_s: float = 600.0
    margin_s: float = 40.0
    shortcuts: bool = True

    @property
    def fixed_velocity_mps(self) -> float | None:
        """The bound on the velocity that goes with the time constant."""
        if self.time_constant_s is None:
            return None
        noise = STANDARD_GRAVITY_MPS2 * self.rate_noise_rad_per_sqrt_s
        return self.time_constant_s**2 * noise / math.sqrt(2.0)

    def time_constant_of_s(self, velocity_mps: Floats) -> Floats:
        """Return the time constant for a bound on the velocity.

        The smoother's error falls off as exp(-t / (sqrt(2) T)) with
        T = (2 v^2 / (g q)^2)^(1/4), q the rate noise; see `uncertainty`.
        """
        noise = STANDARD_GRAVITY_MPS2 * self.rate_noise_rad_per_sqrt_s
        return np.sqrt(math.sqrt(2.0) * velocity_mps / noise)

    def rebias_of_radps(self, steered: float) -> float:
        """Return the change of bias that calls for another integration.

        Args:
            steered: how far it drives and turns, 0 to 1; see `travel`.
        """
        usual, steering = self.rebias_radps, self.steered_rebias_radps
        return float(usual ** (1.0 - steered) * steering**steered)

    def most_solutions(self, *, unrest: bool, steered: bool) -> int:
        """Return how many solutions there may be in all.

        Args:
            unrest: while still spans are being weighed.
            steered: whether it drives and turns at all.
        """
        usual = self.steered_solutions if steered else self.solutions
        return max(2, usual, self.rest_solutions if unrest else 0)

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, float) and not 0.0 < value < float("inf"):
                raise UsageError(
                    "{name} must be above zero, not {value}",
                    name=field.name,
                    value=value,
                )
