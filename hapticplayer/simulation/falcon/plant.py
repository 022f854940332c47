"""Motion of grip and hand under a force: inertia, friction, hand, end stops.

The state is the grip's position and velocity; kinetic energy is that of the three
joints, whose rates follow from the velocity, and of the mass at the grip. One step:

1. The joints' geometry is taken at the middle of the way ahead. The velocity keeps
   the motion of joints and mass as well as the new geometry allows (Gauss's principle
   of least constraint), and all of the kinetic energy.
2. Implicit midpoint rule under force, spring, damper and friction, with the geometry
   held: the energy balance of a step is exact, whatever the step.
3. Beyond the end stop the grip is put back and its outward speed turned round.

Hence energy can only come in as work of the force, or of the hand when its rest
point moves. The rule is of second order in the step.
"""

import math
from dataclasses import dataclass

from hapticplayer.devices.dynamics import Hand, Mechanism
from hapticplayer.devices.falcon.matrix3 import Rows, dot, minus
from hapticplayer.model.device import Vector
from hapticplayer.simulation.falcon.kinematics import PlantKinematics, solve

ZERO: Vector = (0.0, 0.0, 0.0)
MAX_STEP_S = 0.0005
# A time of up to so many steps is one, as a period of the loop, early or late. That errs
# by 0.3 um, with dry friction by 5 um: a count of the encoders is 28 um and more.
_IN_ONE = 3.0
NO_HAND = Hand(0.0, 0.0, 0.0)
# Less than this is left over where times that should be equal are subtracted.
_NO_TIME_S = 1e-9
# A grip this near to its rest, and no faster in a second, is left alone without force.
_STILL_M = 1e-9


@dataclass(slots=True)
class Energy:
    """Work since the beginning, J: E(now) = E(0) + force + hand - lost."""

    force_j: float = 0.0
    hand_j: float = 0.0
    lost_j: float = 0.0


class Plant:
    """The mechanics of device and hand; no clock, no electronics, no chance.

    Positions m, velocities m/s, forces N, all in frame D.
    """

    def __init__(
        self,
        kinematics: PlantKinematics,
        mechanism: Mechanism,
        hand: Hand | None,
        max_step_s: float = MAX_STEP_S,
    ) -> None:
        self._kinematics = kinematics
        self._mechanism = mechanism
        self._max_step_s = max_step_s
        self.hand = hand or NO_HAND
        self.aim_m = self.rest_m = ZERO
        self.energy = Energy()
        self.place(ZERO)

    def place(self, position_m: Vector, velocity_mps: Vector = ZERO) -> None:
        """Put the grip somewhere within the end stops."""
        self.position_m, self.velocity_mps = position_m, velocity_mps
        self._rows = self._kinematics.inverse(position_m).rates
        self._rates = _times(self._rows, velocity_mps)

    def let_go(self) -> None:
        """Take the hand away; what it stored and carried goes with it."""
        self._change_hand(NO_HAND)

    def grasp(self, hand: Hand) -> None:
        """Put a hand on the grip, at rest relative to it and without strain."""
        self.aim_m = self.rest_m = self.position_m
        self._change_hand(hand)

    def energy_j(self) -> float:
        return self._kinetic_j(self._rates, self.velocity_mps) + self._strain_j()

    def advance(self, force_n: Vector, duration_s: float) -> None:
        """Let a constant force act for so long."""
        if duration_s <= _NO_TIME_S or (force_n == ZERO and self._is_still()):
            return
        steps = duration_s / self._max_step_s
        count = 1 if steps <= _IN_ONE else math.ceil(steps - 1e-6)
        step_s = duration_s / count
        for _ in range(count):
            self._step(force_n, step_s)

    def _is_still(self) -> bool:
        """Whether a step without force would change nothing that can be seen."""
        return (
            math.hypot(*self.velocity_mps) < _STILL_M
            and math.dist(self.position_m, self.rest_m) < _STILL_M
            and self.rest_m == self.aim_m
        )

    def _step(self, force_n: Vector, step_s: float) -> None:
        self._move_rest(step_s)
        self._carry_over(step_s)
        before_m, before_mps = self.position_m, self.velocity_mps
        self._push(force_n, step_s)
        if math.hypot(*self.position_m) > self._mechanism.stop_radius_m:
            self._bounce(force_n, before_mps)
        self.energy.force_j += dot(force_n, minus(self.position_m, before_m))

    def _move_rest(self, step_s: float) -> None:
        hand = self.hand
        if self.rest_m == self.aim_m and math.isinf(hand.yield_s):
            return
        before_j = self._strain_j()
        back = -math.expm1(-step_s / hand.return_s)
        give = -math.expm1(-step_s / hand.yield_s)
        rest = _between(self.rest_m, self.aim_m, back)
        self.rest_m = _between(rest, self.position_m, give)
        self.energy.hand_j += self._strain_j() - before_j

    def _strain_j(self) -> float:
        strain_m = math.dist(self.position_m, self.rest_m)
        return 0.5 * self.hand.stiffness_n_per_m * strain_m**2

    def _carry_over(self, step_s: float) -> None:
        """Step 1: from the geometry of the last step to that of this one."""
        (x, y, z), (vx, vy, vz) = self.position_m, self.velocity_mps
        half_s = 0.5 * step_s
        middle = (x + half_s * vx, y + half_s * vy, z + half_s * vz)
        before_j = self._kinetic_j(self._rates, self.velocity_mps)
        self._rows = rows = self._kinematics.inverse(middle).rates
        velocity = solve(self._matrix(ZERO, 0.0), self._momentum())
        rates = _times(rows, velocity)
        after_j = self._kinetic_j(rates, velocity)
        scale = math.sqrt(before_j / after_j) if after_j > 0.0 else 1.0
        self.velocity_mps = _scaled(velocity, scale)
        self._rates = _scaled(rates, scale)

    def _push(self, force_n: Vector, step_s: float) -> None:
        """Step 2: (M + h C / 2 + h^2 K / 4) v_mid = M v + h F / 2 for the mean v."""
        hand, part = self.hand, self._mechanism
        half_s = 0.5 * step_s
        viscous, coulomb, stick = part.viscous_nm_s, part.coulomb_nm, part.stick_radps
        p, q, r = self._rates
        friction = (
            viscous + coulomb / max(abs(p), stick),
            viscous + coulomb / max(abs(q), stick),
            viscous + coulomb / max(abs(r), stick),
        )
        stiffness, damping = hand.stiffness_n_per_m, hand.damping_n_s_per_m
        matrix = self._matrix(
            (half_s * friction[0], half_s * friction[1], half_s * friction[2]),
            half_s * (damping + half_s * stiffness),
        )
        momentum = self._momentum()
        (x, y, z), (rx, ry, rz) = self.position_m, self.rest_m
        mean = solve(
            matrix,
            (
                momentum[0] + half_s * (force_n[0] - stiffness * (x - rx)),
                momentum[1] + half_s * (force_n[1] - stiffness * (y - ry)),
                momentum[2] + half_s * (force_n[2] - stiffness * (z - rz)),
            ),
        )
        vx, vy, vz = self.velocity_mps
        mx, my, mz = mean
        self.position_m = (x + step_s * mx, y + step_s * my, z + step_s * mz)
        self.velocity_mps = (2.0 * mx - vx, 2.0 * my - vy, 2.0 * mz - vz)
        a, b, c = _times(self._rows, mean)
        self._rates = (2.0 * a - p, 2.0 * b - q, 2.0 * c - r)
        self.energy.lost_j += step_s * (
            damping * (mx * mx + my * my + mz * mz)
            + friction[0] * a * a
            + friction[1] * b * b
            + friction[2] * c * c
        )

    def _bounce(self, force_n: Vector, came_mps: Vector) -> None:
        """Step 3: a rigid stop that gives back a share of the speed."""
        part, beyond_m, before_j = self._mechanism, self.position_m, self.energy_j()
        radius_m = math.hypot(*beyond_m)
        normal = _scaled(beyond_m, 1.0 / radius_m)
        self.position_m = _scaled(beyond_m, part.stop_radius_m / radius_m)
        # what the force has added during the step does not bounce, it presses
        back_mps = -part.restitution * max(0.0, dot(normal, came_mps))
        too_fast_mps = dot(normal, self.velocity_mps) - back_mps
        if too_fast_mps > 0.0:
            effect = solve(self._matrix(ZERO, 0.0), normal)
            impulse_n_s = too_fast_mps / dot(normal, effect)
            self.velocity_mps = minus(self.velocity_mps, _scaled(effect, impulse_n_s))
            self._rates = _times(self._rows, self.velocity_mps)
        self.energy.lost_j += before_j - self.energy_j()
        self.energy.lost_j -= dot(force_n, minus(beyond_m, self.position_m))

    def _change_hand(self, hand: Hand) -> None:
        """Replace the hand; the grip keeps its speed."""
        before_j = self.energy_j()
        self.hand = hand
        self.energy.hand_j += self.energy_j() - before_j

    def _kinetic_j(self, rates: Vector, velocity: Vector) -> float:
        part, (p, q, r), (x, y, z) = self._mechanism, rates, velocity
        return 0.5 * (
            part.joint_inertia_kg_m2 * (p * p + q * q + r * r)
            + (part.grip_mass_kg + self.hand.mass_kg) * (x * x + y * y + z * z)
        )

    def _momentum(self) -> Vector:
        """Return G' I rates + m velocity: what of the motion fits the geometry."""
        part = self._mechanism
        (a, b, c), (d, e, f), (g, h, i) = self._rows
        inertia, (p, q, r) = part.joint_inertia_kg_m2, self._rates
        p, q, r = inertia * p, inertia * q, inertia * r
        vx, vy, vz = self.velocity_mps
        mass = part.grip_mass_kg + self.hand.mass_kg
        return (
            a * p + d * q + g * r + mass * vx,
            b * p + e * q + h * r + mass * vy,
            c * p + f * q + i * r + mass * vz,
        )

    def _matrix(self, more_inertia: Vector, more_mass: float) -> Rows:
        """Return G' (I + more) G + (m + more): mass as felt at the grip, kg."""
        part = self._mechanism
        (a, b, c), (d, e, f), (g, h, i) = self._rows
        inertia = part.joint_inertia_kg_m2
        p, q, r = (
            inertia + more_inertia[0],
            inertia + more_inertia[1],
            inertia + more_inertia[2],
        )
        mass = part.grip_mass_kg + self.hand.mass_kg + more_mass
        xy = p * a * b + q * d * e + r * g * h
        xz = p * a * c + q * d * f + r * g * i
        yz = p * b * c + q * e * f + r * h * i
        return (
            (p * a * a + q * d * d + r * g * g + mass, xy, xz),
            (xy, p * b * b + q * e * e + r * h * h + mass, yz),
            (xz, yz, p * c * c + q * f * f + r * i * i + mass),
        )


def _scaled(vector: Vector, factor: float) -> Vector:
    x, y, z = vector
    return (x * factor, y * factor, z * factor)


def _times(rows: Rows, vector: Vector) -> Vector:
    (a, b, c), (d, e, f), (g, h, i) = rows
    x, y, z = vector
    return (a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)


def _between(start: Vector, end: Vector, share: float) -> Vector:
    return (
        start[0] + share * (end[0] - start[0]),
        start[1] + share * (end[1] - start[1]),
        start[2] + share * (end[2] - start[2]),
    )
