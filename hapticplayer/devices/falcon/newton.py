"""Forward kinematics of the Falcon's legs, unrolled because it runs at kilohertz.

Written out for three legs in local variables, this takes a third of the time that the
same steps take in a loop over legs (measured); equations and frame: `kinematics`.
"""

import math
from collections.abc import Callable

from hapticplayer.devices.falcon.geometry import Geometry
from hapticplayer.devices.falcon.matrix3 import Rows
from hapticplayer.model.device import Vector

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
