"""A motion whose acceleration and rotation are exact derivatives of its path.

Six coordinates (position and yaw, pitch, roll) are splines of the fifth degree;
everything else is derived from them in closed form, so that a recording made of it
has a truth without approximation.

Earth frame: x east, y north, z up. Orientation = Rz(yaw) Rx(pitch) Ry(roll) from
sensor to earth: yaw counterclockwise seen from above, pitch lifts the nose, roll
lowers the right side.
"""

from dataclasses import dataclass, fields

import numpy as np
from scipy.interpolate import make_interp_spline

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import (
    conjugate,
    multiply,
    rotate,
    to_rotation_vector,
)

_DEGREE = 5


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """What a sensor goes through at N times, all exact.

    Position and velocity are in the earth's frame, what a sensor measures and the
    gravity-free acceleration in its own: specific force is R^T (a_earth + g z), the
    quaternion (N, 4) sensor to earth.
    """

    time_s: Floats
    position_m: Floats
    velocity_mps: Floats
    acceleration_mps2: Floats
    specific_force_mps2: Floats
    angular_rate_radps: Floats
    quaternion_wxyz: Floats

    def arrays(self) -> dict[str, Floats]:
        """Return all of it by name, for a `.npz`."""
        return {field.name: getattr(self, field.name) for field in fields(self)}


class Trajectory:
    """Splines through sampled coordinates."""

    def __init__(
        self,
        time_s: Floats,
        position_m: Floats,
        angles_rad: Floats,
        impacts_s: tuple[tuple[float, float], ...] = (),
    ) -> None:
        """Lay splines through samples (N, 3): position in earth, and yaw, pitch, roll.

        The times are equally spaced and reach a little beyond what will be asked for,
        because splines are loose at their ends. `impacts_s` are the spans of single
        impacts that the samples hold, for what has to find them.
        """
        self.time_s = time_s
        self.impacts_s = impacts_s
        self._samples = (position_m, angles_rad)
        self._position = make_interp_spline(time_s, position_m, k=_DEGREE)
        self._angles = make_interp_spline(time_s, angles_rad, k=_DEGREE)
        self._velocity = self._position.derivative(1)
        self._acceleration = self._position.derivative(2)
        self._angle_rates = self._angles.derivative(1)

    def at(self, time_s: Floats) -> Motion:
        """Return the motion at times (N,)."""
        angles = self._angles(time_s)
        quaternion = quaternion_from_angles(angles)
        acc_earth = self._acceleration(time_s)
        to_sensor = conjugate(quaternion)
        gravity = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])
        return Motion(
            time_s=time_s,
            position_m=self._position(time_s),
            velocity_mps=self._velocity(time_s),
            acceleration_mps2=rotate(to_sensor, acc_earth),
            specific_force_mps2=rotate(to_sensor, acc_earth + gravity),
            angular_rate_radps=_body_rate(angles, self._angle_rates(time_s)),
            quaternion_wxyz=quaternion,
        )

    def changed(
        self, *, later_s: float = 0.0, displacement_m: Floats | float = 0.0
    ) -> "Trajectory":
        """Return this motion at a later time, with a displacement (N, 3) added."""
        position_m, angles_rad = self._samples
        return Trajectory(
            self.time_s + later_s,
            position_m + displacement_m,
            angles_rad,
            tuple((begin + later_s, end + later_s) for begin, end in self.impacts_s),
        )

    def mean_rate_radps(self, time_s: Floats, step_s: float) -> Floats:
        """Return the rotation over the interval ending at each time, per second.

        What an integrating gyro delivers: the rotation vector that leads exactly
        from one orientation to the next. (N, 3), sensor frame.
        """
        before = quaternion_from_angles(self._angles(time_s - step_s))
        after = quaternion_from_angles(self._angles(time_s))
        return to_rotation_vector(multiply(conjugate(before), after)) / step_s


def quaternion_from_angles(angles_rad: Floats) -> Floats:
    """Return Rz(yaw) Rx(pitch) Ry(roll) as quaternions (N, 4)."""
    yaw, pitch, roll = 0.5 * angles_rad.T
    zero = np.zeros_like(yaw)
    about_z = np.stack([np.cos(yaw), zero, zero, np.sin(yaw)], axis=1)
    about_x = np.stack([np.cos(pitch), np.sin(pitch), zero, zero], axis=1)
    about_y = np.stack([np.cos(roll), zero, np.sin(roll), zero], axis=1)
    return multiply(multiply(about_z, about_x), about_y)


def _body_rate(angles: Floats, rates: Floats) -> Floats:
    """Return the angular rate in the sensor frame from Euler angles and rates."""
    _, pitch, roll = angles.T
    yaw_rate, pitch_rate, roll_rate = rates.T
    side = pitch_rate
    ahead = yaw_rate * np.sin(pitch)
    upward = yaw_rate * np.cos(pitch)
    cosine, sine = np.cos(roll), np.sin(roll)
    return np.stack(
        [
            cosine * side - sine * upward,
            ahead + roll_rate,
            sine * side + cosine * upward,
        ],
        axis=1,
    )


def smooth_step(time_s: Floats, start_s: float, length_s: float) -> Floats:
    """Return 0 before, 1 after, and a polynomial with three zero derivatives between.

    S(u) = 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7.
    """
    u = np.clip((time_s - start_s) / length_s, 0.0, 1.0)
    return u**4 * (35.0 + u * (-84.0 + u * (70.0 - 20.0 * u)))
