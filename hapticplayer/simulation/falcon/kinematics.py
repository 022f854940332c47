"""Kinematics of the Falcon's three legs, in scalars because they run at kilohertz.

A leg in its own plane: `u` outwards, `v` across, `w` along the device's axis. The
knee lies on a circle of the thigh's length, the grip on a circle around the knee
whose radius L depends on `v`: (u - a cos t)^2 + (w - a sin t)^2 = L^2.
"""

import math
from typing import NamedTuple

from hapticplayer.model.device import Vector
from hapticplayer.simulation.falcon.parameters import PlantGeometry

_REFINEMENTS = 4
# Each step squares the error: behind one of 0.1 um there is less than 1 pm.
_LAST_STEP_M = 1e-7


class PlantPose(NamedTuple):
    """The thighs' angles and d theta / d position, 1/m, the inverse of the Jacobian."""

    theta_rad: Vector
    rates: tuple[Vector, Vector, Vector]


class PlantKinematics:
    """Positions are in frame D, m, from the centre of the usable sphere."""

    def __init__(self, geometry: PlantGeometry) -> None:
        self.geometry = geometry
        self._shin2_m2 = geometry.shin_m**2
        self._directions = [(math.cos(p), math.sin(p)) for p in geometry.azimuths_rad]

    def inverse(self, position_m: Vector) -> PlantPose:
        """Return the joints for a position; raises ValueError out of reach."""
        geometry, shin2_m2 = self.geometry, self._shin2_m2
        thigh_m, radial_m = geometry.thigh_m, geometry.radial_m
        sideways_m, ends_m = geometry.sideways_m, geometry.shin_ends_m
        cos, sin, sqrt = math.cos, math.sin, math.sqrt
        x, y, z = position_m
        w = z + geometry.centre_z_m
        angles, rows = [], []
        for cos_phi, sin_phi in self._directions:
            u = x * cos_phi + y * sin_phi - radial_m
            v = y * cos_phi - x * sin_phi - sideways_m
            h = sqrt(shin2_m2 - v * v)
            reach_m = ends_m + h
            from_axis2_m2 = u * u + w * w
            theta = math.atan2(w, u) - math.acos(
                (from_axis2_m2 + thigh_m * thigh_m - reach_m * reach_m)
                / (2.0 * thigh_m * sqrt(from_axis2_m2))
            )
            cos_t, sin_t = cos(theta), sin(theta)
            along_u, along_w = u - thigh_m * cos_t, w - thigh_m * sin_t
            per_rad = 1.0 / (thigh_m * (along_w * cos_t - along_u * sin_t))
            along_u *= per_rad
            across = reach_m * v / h * per_rad
            rows.append(
                (
                    along_u * cos_phi - across * sin_phi,
                    along_u * sin_phi + across * cos_phi,
                    along_w * per_rad,
                )
            )
            angles.append(theta)
        return PlantPose((angles[0], angles[1], angles[2]), (rows[0], rows[1], rows[2]))

    def forward(
        self, theta_rad: Vector, near_m: Vector, near: PlantPose | None = None
    ) -> Vector:
        """Return the position for joint angles by Newton's method, to 1 pm.

        `near_m` is a position within a few millimetres, `near` its joints.
        """
        (x, y, z), pose = near_m, near
        for _ in range(_REFINEMENTS):
            theta, rates = pose or self.inverse((x, y, z))
            dx, dy, dz = solve(
                rates,
                (
                    theta_rad[0] - theta[0],
                    theta_rad[1] - theta[1],
                    theta_rad[2] - theta[2],
                ),
            )
            x, y, z, pose = x + dx, y + dy, z + dz, None
            if abs(dx) + abs(dy) + abs(dz) < _LAST_STEP_M:
                break
        return (x, y, z)


def solve(rows: tuple[Vector, Vector, Vector], right: Vector) -> Vector:
    """Return the solution of three linear equations (Cramer's rule)."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    p, q, r = right
    ei_fh, fg_di, dh_eg = e * i - f * h, f * g - d * i, d * h - e * g
    inverse_det = 1.0 / (a * ei_fh + b * fg_di + c * dh_eg)
    return (
        (p * ei_fh + q * (c * h - b * i) + r * (b * f - c * e)) * inverse_det,
        (p * fg_di + q * (a * i - c * g) + r * (c * d - a * f)) * inverse_det,
        (p * dh_eg + q * (b * g - a * h) + r * (a * e - b * d)) * inverse_det,
    )
