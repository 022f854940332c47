"""Kinematics of the Falcon: where the grip is, and what the motors must do.

Positions are in the device's frame: origin on its axis, x right, y up, z towards the
user. A leg at azimuth phi, in its own plane (u outwards, v across; letters as in
`Geometry`):

    u = x cos phi + y sin phi - r + c,   v = -x sin phi + y cos phi - s + f.

The knee lies on a circle of radius a, the grip on a circle around the knee whose
radius shrinks as the shin's parallelogram leans across, L = d + e + h with
h = sqrt(b^2 - v^2):

    (u - a cos theta)^2 + (z - a sin theta)^2 = L^2.

With A = u - a cos theta, B = z - a sin theta and half the gradient of this closure,

    W = A (cos phi, sin phi, 0) + L v / h (-sin phi, cos phi, 0) + B (0, 0, 1),

the Jacobian dp/dtheta is W^-1 diag(D), D = a (B cos theta - A sin theta), and a force
F at the grip is held by the joint torques J^T F. All in scalars: one call of
numpy.linalg takes longer than a whole tick may.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from hapticplayer.devices.falcon.matrix3 import (
    Rows,
    condition,
    condition_bound,
    cross,
    dot,
    minus,
    transposed_times,
)
from hapticplayer.errors import Message
from hapticplayer.model.device import Vector


@dataclass(frozen=True, slots=True)
class Geometry:
    """Delta kinematics with three legs; m and rad.

    The letters are those of libnifalcon's FalconGeometry.h, from which the values
    come. Its maintainers call them doubtful near the edge of the workspace; one
    degree in `theta0_rad` ("approx." there) is 1.2 mm in z.

    Attributes:
        thigh_m: a, from the motor's axis to the knee.
        shin_m: b, length of the parallelogram between knee and grip.
        grip_radius_m: c, from the grip's axis to where a shin ends.
        shin_ends_m: d + e, what the shin's two ends add beyond the parallelogram.
        grip_offset_m: f, across the leg, at the grip.
        base_radius_m: r, from the device's axis to a motor's axis.
        base_offset_m: s, across the leg, at the base. That it differs from f by
            1.9 mm turns the lateral frame by -1.8 degrees, which packets traced from
            the vendor's driver do not show: s = f may be nearer to the truth.
        azimuths_rad: directions of the legs seen from the front: top, right, lower
            left; the order of motors and encoders.
        theta0_rad: angle of the thighs at encoder count 0.
        count_rad: one count: 320 slots read four times per turn of the 14.25 mm
            shaft, which drives a sector of 110 mm.
        centre_z_m: middle of the usable sphere, in front of the device's origin.
    """

    thigh_m: float = 0.060
    shin_m: float = 0.1025
    grip_radius_m: float = 0.01443
    shin_ends_m: float = 0.01125 + 0.01125
    grip_offset_m: float = -0.025
    base_radius_m: float = 0.0400
    base_offset_m: float = -0.02309
    azimuths_rad: Vector = (
        math.radians(105.0),
        math.radians(-15.0),
        math.radians(-135.0),
    )
    theta0_rad: float = math.radians(35.0)
    count_rad: float = math.radians(0.01425 / 0.110 * 360.0 / 1280.0)
    centre_z_m: float = 0.120


FALCON_GEOMETRY = Geometry()


Counts = tuple[int, int, int]

WORDS_PER_NM = 10_000.0
"""Motor word per torque as libnifalcon has it; no measurement is published."""
WORD_LIMIT = 4096
"""Where the hardware saturates; the 16 bits of a frame would wrap round beyond."""
FADE_BEGINS = 6.0
"""Up to this condition number of the Jacobian the full force is given."""
FADE_ENDS = 9.0
"""From this one on none: directions are no longer what the model says."""


class OutOfReachError(ValueError):
    """No pose of the legs belongs to this position or to these angles."""


class Pose(NamedTuple):
    """The grip in the device's frame, and rows x, y, z of dp/dtheta, m/rad."""

    position_m: Vector
    jacobian: Rows


class Kinematics:
    """The legs of one geometry; see the module for frame and equations."""

    def __init__(self, geometry: Geometry = FALCON_GEOMETRY) -> None:
        self.geometry = geometry
        self.centre_m: Vector = (0.0, 0.0, geometry.centre_z_m)
        self._directions = [(math.cos(p), math.sin(p)) for p in geometry.azimuths_rad]
        self._radial_m = geometry.base_radius_m - geometry.grip_radius_m
        self._across_m = geometry.base_offset_m - geometry.grip_offset_m
        self._solve = make_solver(geometry)

    def angles(self, counts: Counts) -> Vector:
        zero, per = self.geometry.theta0_rad, self.geometry.count_rad
        i, j, k = counts
        return (zero + per * i, zero + per * j, zero + per * k)

    def counts(self, theta_rad: Vector) -> Counts:
        """Return the encoder counts nearest to these angles."""
        zero, per = self.geometry.theta0_rad, self.geometry.count_rad
        i, j, k = (round((theta - zero) / per) for theta in theta_rad)
        return (i, j, k)

    def inverse(self, position_m: Vector) -> Vector:
        """Return the thighs' angles, rad, in closed form; raises OutOfReachError."""
        x, y, z = position_m
        a, b = self.geometry.thigh_m, self.geometry.shin_m
        angles = []
        for cos_phi, sin_phi in self._directions:
            u = x * cos_phi + y * sin_phi - self._radial_m
            v = y * cos_phi - x * sin_phi - self._across_m
            if not abs(v) <= b:
                raise _too_far(position_m)
            reach = self.geometry.shin_ends_m + math.sqrt(b * b - v * v)
            from_axis = math.hypot(u, z)
            sides = from_axis * from_axis + a * a - reach * reach
            if not abs(sides) <= 2.0 * a * from_axis or from_axis == 0.0:
                raise _too_far(position_m)
            angles.append(math.atan2(z, u) - math.acos(sides / (2.0 * a * from_axis)))
        return (angles[0], angles[1], angles[2])

    def pose(self, theta_rad: Vector, near_m: Vector | None = None) -> Pose:
        """Return position and Jacobian for the thighs' angles, by Newton's method.

        `near_m`, where the grip was a moment ago, saves steps and keeps to the same
        assembly of the legs.

        Raises:
            OutOfReachError: when the legs cannot be assembled at these angles.
        """
        if near_m is not None:
            found = self._solve(theta_rad, near_m)
            if found is not None:
                return Pose(*found)
        for start in (self._where_spheres_meet(theta_rad), self.centre_m):
            found = self._solve(theta_rad, start)
            if found is not None:
                return Pose(*found)
        raise OutOfReachError(
            Message("the legs cannot be assembled at these joint angles")
        )

    def forward(self, theta_rad: Vector, near_m: Vector | None = None) -> Vector:
        """Return the grip's position for the thighs' angles; see `pose`."""
        return self.pose(theta_rad, near_m).position_m

    def jacobian(self, position_m: Vector) -> Rows:
        """Return dp/dtheta at a position, m/rad; raises OutOfReachError."""
        found = self._solve(self.inverse(position_m), position_m)
        if found is None:
            raise _too_far(position_m)
        return found[1]

    def _where_spheres_meet(self, theta_rad: Vector) -> Vector:
        """Return where the grip would be if the shins' ends had no length.

        The shins then are spheres about the knees, which meet twice: in front of
        the plane of the centres, where the grip is, and behind it.
        """
        first, second, third = (
            self._sphere_centre(leg, theta) for leg, theta in enumerate(theta_rad)
        )
        a, b = minus(second, first), minus(third, first)
        normal = cross(a, b)
        area2 = dot(normal, normal)
        if area2 == 0.0:
            return self.centre_m
        p, q = cross(b, normal), cross(normal, a)
        aa, bb = 0.5 * dot(a, a) / area2, 0.5 * dot(b, b) / area2
        to_middle = (
            aa * p[0] + bb * q[0],
            aa * p[1] + bb * q[1],
            aa * p[2] + bb * q[2],
        )
        radius = self.geometry.shin_ends_m + self.geometry.shin_m
        height2 = max(0.0, radius * radius - dot(to_middle, to_middle))
        up = math.copysign(math.sqrt(height2 / area2), normal[2])
        return (
            first[0] + to_middle[0] + up * normal[0],
            first[1] + to_middle[1] + up * normal[1],
            first[2] + to_middle[2] + up * normal[2],
        )

    def _sphere_centre(self, leg: int, theta_rad: float) -> Vector:
        cos_phi, sin_phi = self._directions[leg]
        thigh_m = self.geometry.thigh_m
        outwards_m = self._radial_m + thigh_m * math.cos(theta_rad)
        return (
            outwards_m * cos_phi - self._across_m * sin_phi,
            outwards_m * sin_phi + self._across_m * cos_phi,
            thigh_m * math.sin(theta_rad),
        )


def fade(jacobian: Rows) -> float:
    """Return the share of the force that may be given at this pose, 0 to 1.

    1 up to a condition number of 6, then falling evenly to 0 at 9.
    """
    if condition_bound(jacobian) <= FADE_BEGINS:
        return 1.0
    share = (FADE_ENDS - condition(jacobian)) / (FADE_ENDS - FADE_BEGINS)
    return min(1.0, max(0.0, share))


def motor_words(jacobian: Rows, force_n: Vector) -> Vector:
    """Return the motor words for a force, not rounded, within +-4096.

    J^T F, faded near singular poses; what is too much for one motor is taken from all
    three in proportion, so that the force keeps its direction; raises ValueError when
    it is not finite.
    """
    x, y, z = force_n
    scale = -WORDS_PER_NM * fade(jacobian)
    return saturated(transposed_times(jacobian, (scale * x, scale * y, scale * z)))


def saturated(words: Vector) -> Vector:
    """Return the words in proportion, within +-4096; else raises ValueError."""
    i, j, k = words
    largest = max(abs(i), abs(j), abs(k))
    if not (math.isfinite(i) and math.isfinite(j) and math.isfinite(k)):
        raise ValueError(f"motor words {words} are not finite")
    if largest <= WORD_LIMIT:
        return words
    scale = WORD_LIMIT / largest
    return (scale * i, scale * j, scale * k)


def _too_far(position_m: Vector) -> OutOfReachError:
    x, y, z = (1000.0 * part for part in position_m)
    return OutOfReachError(
        Message("no leg reaches ({x:.1f}, {y:.1f}, {z:.1f}) mm", x=x, y=y, z=z)
    )


MOST_STEPS = 25
ACCURACY_M = 1e-9
_LEGS_TOO_SHORT = ValueError  # of math.sqrt

Solver = Callable[[Vector, Vector], tuple[Vector, Rows] | None]
"""From angles (rad) and a start (m) to position (m) and Jacobian (m/rad), or None."""


def make_solver(geometry: Geometry) -> Solver:
    """Return Newton's method for the legs of a geometry.

    The solver returns None when it does not converge from that start, or converges
    to legs that are folded the other way (then some D is not positive).
    """
    (c0, s0), (c1, s1), (c2, s2) = (
        (math.cos(phi), math.sin(phi)) for phi in geometry.azimuths_rad
    )
    thigh, ends, shin2 = geometry.thigh_m, geometry.shin_ends_m, geometry.shin_m**2
    radial = geometry.base_radius_m - geometry.grip_radius_m
    across = geometry.base_offset_m - geometry.grip_offset_m
    cos, sin, sqrt = math.cos, math.sin, math.sqrt

    def solve(theta_rad: Vector, near_m: Vector) -> tuple[Vector, Rows] | None:
        t0, t1, t2 = theta_rad
        x, y, z = near_m
        # knees: outwards and along the axis
        k0, k1, k2 = thigh * cos(t0), thigh * cos(t1), thigh * cos(t2)
        q0, q1, q2 = thigh * sin(t0), thigh * sin(t1), thigh * sin(t2)
        for _ in range(MOST_STEPS):
            # from the knee to the grip: u outwards, v across, w along the axis
            u0 = x * c0 + y * s0 - radial - k0
            u1 = x * c1 + y * s1 - radial - k1
            u2 = x * c2 + y * s2 - radial - k2
            v0, v1, v2 = (
                y * c0 - x * s0 - across,
                y * c1 - x * s1 - across,
                y * c2 - x * s2 - across,
            )
            w0, w1, w2 = z - q0, z - q1, z - q2
            try:
                h0, h1, h2 = (
                    sqrt(shin2 - v0 * v0),
                    sqrt(shin2 - v1 * v1),
                    sqrt(shin2 - v2 * v2),
                )
            except _LEGS_TOO_SHORT:
                return None
            # gradients of the closures (rows of W, third column w) and their values
            l0, l1, l2 = v0 + ends * v0 / h0, v1 + ends * v1 / h1, v2 + ends * v2 / h2
            a0, b0 = u0 * c0 - l0 * s0, u0 * s0 + l0 * c0
            a1, b1 = u1 * c1 - l1 * s1, u1 * s1 + l1 * c1
            a2, b2 = u2 * c2 - l2 * s2, u2 * s2 + l2 * c2
            g0 = u0 * u0 + w0 * w0 - (ends + h0) * (ends + h0)
            g1 = u1 * u1 + w1 * w1 - (ends + h1) * (ends + h1)
            g2 = u2 * u2 + w2 * w2 - (ends + h2) * (ends + h2)
            # columns of W^-1, up to the determinant
            m0, m1, m2 = b1 * w2 - b2 * w1, b2 * w0 - b0 * w2, b0 * w1 - b1 * w0
            n0, n1, n2 = w1 * a2 - w2 * a1, w2 * a0 - w0 * a2, w0 * a1 - w1 * a0
            o0, o1, o2 = a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0
            det = a0 * m0 + a1 * m1 + a2 * m2
            if det == 0.0:
                return None
            half = 0.5 / det
            dx = half * (g0 * m0 + g1 * m1 + g2 * m2)
            dy = half * (g0 * n0 + g1 * n1 + g2 * n2)
            dz = half * (g0 * o0 + g1 * o1 + g2 * o2)
            x, y, z = x - dx, y - dy, z - dz
            if dx * dx + dy * dy + dz * dz < ACCURACY_M * ACCURACY_M:
                d0, d1, d2 = w0 * k0 - u0 * q0, w1 * k1 - u1 * q1, w2 * k2 - u2 * q2
                if not (d0 > 0.0 and d1 > 0.0 and d2 > 0.0):
                    return None
                d0, d1, d2 = d0 / det, d1 / det, d2 / det
                return (x, y, z), (
                    (m0 * d0, m1 * d1, m2 * d2),
                    (n0 * d0, n1 * d1, n2 * d2),
                    (o0 * d0, o1 * d1, o2 * d2),
                )
        return None

    return solve


_FALCON = Kinematics()
angles = _FALCON.angles
inverse = _FALCON.inverse
forward = _FALCON.forward
pose = _FALCON.pose
jacobian = _FALCON.jacobian
