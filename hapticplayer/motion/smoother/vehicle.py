"""The vehicle constraint: a steady velocity in the sensor's own frame.

Of a hand only a bound on the velocity is known. The velocity of a vehicle rotates with
it: in a bend the sideways acceleration lasts as long as the bend, which a bound alone
takes for tilt. So the velocity is split into a part u that is constant in the sensor's
frame and the rest v', and the bound holds for that:
    v[k] = R[k] u + v'[k]
    v'[k+1] - v'[k] = impulse - (R[k+1] - R[k]) u
which makes u three more columns of the calibration, the last ones. (Non-holonomic
constraint of wheels: Dissanayake et al. 2001, IEEE T-RA 17(5):731; here the axis is
estimated, too.) Without locomotion u would absorb errors of the sensors.

The bound of what moves along does not follow the velocity found, place by place: a
recording that starts within an acceleration shows too small a velocity, and a bound
that fits it would take more of the acceleration for tilt. The kind of motion follows
from the turning radius, speed over rotation rate, which hardly depends on where a
recording is cut: 0.1 to 2.3 m for hands and people on foot, 5 to 6.5 m for a head on a
downhill bike, 11 m and more for vehicles. Each kind has its usual bound; that of a
vehicle is wide and fixed, beyond the others' the bound follows the velocity.

u depends on the heading, and the heading on the gyro's bias, so that a vehicle is
solved for until the bias stays. Without turns, as in a train, the heading is not
observable; only the velocity is kept small.

A bias about the vertical is a steady turn, whose sideways acceleration a steady tilt
balances: 0.2 rad at 25 m/s and 5 deg/s. Roads bend both ways, and a bend is entered and
left: a mean rate of turn that is large beside its changes is the gyro's.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.nodes import Nodes

# Columns of u.
BODY_VELOCITY_COLUMNS = 3
# Prior sigma of each component of u: at the least, of what moves, and of a vehicle
# (beside its wide bound a smaller one makes u too small). Half of the second costs 1 %.
MIN_BODY_SIGMA_MPS, MOVING_BODY_SIGMA_MPS, VEHICLE_BODY_SIGMA_MPS = 0.01, 10.0, 80.0
# RMS speed between swaying (weight 0) and moving (weight 1); twice of it costs 8 %.
MOVING_SPEED_MPS = (0.4, 0.55)
# Turning radius between walking and riding, and between riding and a vehicle.
RIDING_RADIUS_M, VEHICLE_RADIUS_M = (2.8, 4.2), (6.5, 9.5)
# Mean rotation rate between which the heading becomes observable.
HEADING_RATE_RADPS = (0.005, 0.02)
# Bound on v' of a vehicle, and the least for riding and walking; twice of the last costs
# 3 %.
VEHICLE_BOUND_MPS, RIDING_BOUND_MPS, WALKING_BOUND_MPS = 40.0, 8.0, 4.0
# Beyond the least, the bound is that of the velocity found over this; half of it costs
# 3 %.
FOUND_BOUND_RATIO = 1.15
# Correlation time of the rate of turn on a road, and the least deviation of its mean; how
# long a bend lasts, and its usual rate.
TURN_CORRELATION_S, MIN_TURN_RADPS, BEND_S, BEND_RADPS = 20.0, 0.002, 5.0, 0.2
# A gap disturbs the velocity for so long; a smaller undisturbed share is not used alone.
GAP_INFLUENCE_S, MIN_UNDISTURBED_SHARE = 15.0, 0.2


@dataclass(frozen=True, slots=True)
class Locomotion:
    """How the sensor moves along; weights from 0 to 1.

    Attributes:
        moving_weight: of moving along, against swaying in place.
        riding_weight: of moving faster than on foot.
        vehicle_weight: of a vehicle.
        heading_weight: of a vehicle whose heading is observable.
    """

    moving_weight: float = 0.0
    riding_weight: float = 0.0
    vehicle_weight: float = 0.0
    heading_weight: float = 0.0

    @property
    def body_sigma_mps(self) -> float:
        """Prior sigma of each component of u, 0 where there is none."""
        if not self.moving_weight:
            return 0.0
        sigma_mps = _geometric(
            MOVING_BODY_SIGMA_MPS, VEHICLE_BODY_SIGMA_MPS, self.vehicle_weight
        )
        return _geometric(MIN_BODY_SIGMA_MPS, sigma_mps, self.moving_weight)

    def bound_mps(self, found_mps: Floats) -> Floats:
        """Return the bound on v' from that for the velocity found."""
        if not self.moving_weight:
            return found_mps
        least_mps = _geometric(WALKING_BOUND_MPS, RIDING_BOUND_MPS, self.riding_weight)
        moving_mps = np.maximum(least_mps, found_mps / FOUND_BOUND_RATIO)
        weight = self.moving_weight
        bound = found_mps ** (1.0 - weight) * moving_mps**weight
        weight = self.vehicle_weight
        return np.asarray(bound ** (1.0 - weight) * VEHICLE_BOUND_MPS**weight)


def locomotion_of(velocity_mps: Floats, turn_radps: float) -> Locomotion:
    """Return how the sensor moves along.

    Args:
        velocity_mps: (2, n) horizontal, of a solution without u.
        turn_radps: mean rotation rate.
    """
    speed_mps = rms_mps(velocity_mps)
    first_mps, last_mps = MOVING_SPEED_MPS
    moving = min(max((speed_mps - first_mps) / (last_mps - first_mps), 0.0), 1.0)
    radius_m = speed_mps / max(turn_radps, 1e-9)
    vehicle = moving * _place(radius_m, VEHICLE_RADIUS_M)
    return Locomotion(
        moving_weight=moving,
        riding_weight=moving * _place(radius_m, RIDING_RADIUS_M),
        vehicle_weight=vehicle,
        heading_weight=vehicle * _place(turn_radps, HEADING_RATE_RADPS),
    )


def moves(velocity_mps: Floats) -> bool:
    """Return whether velocities (2, n) are more than swaying."""
    return rms_mps(velocity_mps) > MOVING_SPEED_MPS[0]


def with_body_velocity(
    prior: Floats, weight: Floats, sigma_mps: float
) -> tuple[Floats, Floats]:
    """Return prior and weight (C,) with the three columns of u at the end."""
    zeros = np.zeros(BODY_VELOCITY_COLUMNS)
    return np.append(prior, zeros), np.append(weight, zeros + sigma_mps**-2.0)


def undisturbed(nodes: Nodes) -> NDArray[np.bool_]:
    """Return which nodes are far from any gap, (K + 1,); all where hardly any is.

    The velocity that bridges a gap belongs to no motion.
    """
    total = np.cumsum(np.append(0.0, nodes.lost_s + nodes.doubt_s))
    time_s = np.cumsum(np.append(0.0, nodes.duration_s))
    if total[-1] > 0.0:
        before = np.interp(time_s - GAP_INFLUENCE_S, time_s, total)
        clear = np.interp(time_s + GAP_INFLUENCE_S, time_s, total) <= before
        if clear.mean() > MIN_UNDISTURBED_SHARE:
            return np.asarray(clear)
    return np.ones(len(time_s), np.bool_)


def yaw_bias_radps(
    yaw_rad: Floats, duration_s: Floats, variance: Floats, share: Floats
) -> float:
    """Return the gyro's bias about the vertical of a vehicle, beyond that expected.

    The mean over sensors, and over a road that bends both ways (its mean rate varies as
    the rate does) and one bend that lasts throughout.

    Args:
        yaw_rad: (K,) turns about the vertical, by the gyro less the bias expected.
        duration_s: (K,) of them.
        variance: (S,) prior variance of the bias for each sensor, (rad/s)^2.
        share: (S,) probability of each sensor.
    """
    total_s = float(duration_s.sum())
    mean_radps = float(yaw_rad.sum()) / total_s
    changes = np.square(yaw_rad - mean_radps * duration_s) / duration_s
    rate_variance = float(changes.sum()) / total_s
    both_ways = rate_variance * 2.0 * TURN_CORRELATION_S / total_s + MIN_TURN_RADPS**2
    one_bend = math.exp(-total_s / BEND_S)
    read = np.array([[both_ways], [BEND_RADPS**2]]) + variance
    log_density = -0.5 * (mean_radps**2 / read + np.log(read))
    weight = np.exp(log_density - log_density.max()) * share
    weight *= np.array([[1.0 - one_bend], [one_bend]])
    return float(mean_radps * (weight * variance / read).sum() / weight.sum())


def rms_mps(velocity_mps: Floats) -> float:
    """Return the RMS of velocities (2, n)."""
    count = velocity_mps.shape[1]
    return math.sqrt(float(np.square(velocity_mps).sum()) / count)


def _geometric(first: float, last: float, weight: float) -> float:
    return float(first * (last / first) ** weight)


def _place(value: float, limits: tuple[float, float]) -> float:
    """Return where a value lies between limits by its logarithm, 0 to 1."""
    first, last = limits
    if value <= first:
        return 0.0
    return min(math.log(value / first) / math.log(last / first), 1.0)
