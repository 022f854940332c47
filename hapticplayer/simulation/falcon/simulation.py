"""The whole simulated Falcon in virtual time: electronics, mechanics, encoders."""

import math
from collections import deque

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.dynamics import RELAXED, Hand, Mechanism
from hapticplayer.model.device import DeviceReading, Vector
from hapticplayer.simulation.falcon.kinematics import PlantKinematics
from hapticplayer.simulation.falcon.packets import Control, ScriptedEvent
from hapticplayer.simulation.falcon.parameters import Electronics, PlantGeometry
from hapticplayer.simulation.falcon.plant import MAX_STEP_S, ZERO, Energy, Plant

# Of a longer time under one force only so much is computed, which leaves a held grip
# at rest and a free one at its end stop: no silence makes the simulation hang.
MAX_REPLAY_S = 1.0
_PERIOD_S = 1.0 / FALCON.rate_hz


class Simulation:
    """Advances only when called, and deterministically; no hand is a free grip.

    Vectors in frame D; times are those of the caller's clock, s, and never run
    backwards here.
    """

    def __init__(
        self,
        hand: Hand | None = RELAXED,
        *,
        mechanism: Mechanism | None = None,
        electronics: Electronics | None = None,
        geometry: PlantGeometry | None = None,
        max_step_s: float = MAX_STEP_S,
    ) -> None:
        self.electronics = electronics or Electronics()
        self.commanded_n = self.applied_n = ZERO
        self.applied_since_s = 0.0
        self.buttons = 0
        self.is_homed = True
        self.refused = 0
        self._kinematics = PlantKinematics(geometry or PlantGeometry())
        self._plant = Plant(
            self._kinematics, mechanism or Mechanism(), hand, max_step_s
        )
        self._hand = hand or RELAXED
        self._now_s: float | None = None
        self._pending: deque[tuple[float, Vector]] = deque()
        self._expires_s = math.inf
        self._counts: tuple[int, int, int] | None = None
        self._read_m: Vector | None = None
        self._seen_m = ZERO

    @property
    def position_m(self) -> Vector:
        """Where the grip is in truth."""
        return self._plant.position_m

    @property
    def velocity_mps(self) -> Vector:
        """How fast it moves in truth."""
        return self._plant.velocity_mps

    @property
    def energy(self) -> Energy:
        """Work and losses since the beginning."""
        return self._plant.energy

    @property
    def next_change_s(self) -> float:
        """When the force on the motors will change without a new command."""
        soonest_s = self._pending[0][0] if self._pending else math.inf
        return min(soonest_s, self._expires_s)

    def command(self, force_n: Vector, now_s: float) -> bool:
        """Advance to `now_s` and put a force on the motors, after the delay.

        False when it is not finite: then it is counted in `refused`.
        """
        self.advance(now_s)
        if not math.isfinite(force_n[0] + force_n[1] + force_n[2]):
            self.refused += 1
            return False
        self.commanded_n = force_n
        if self.electronics.delay_s > 0.0:
            self._pending.append((now_s + self.electronics.delay_s, force_n))
        else:
            self._apply(force_n, now_s, now_s + _PERIOD_S)
        return True

    def advance(self, now_s: float) -> None:
        """Let the time pass up to `now_s`, with every change of force on its way."""
        if self._now_s is None:
            self._now_s = self.applied_since_s = now_s
        while (change_s := self.next_change_s) <= now_s:
            self._run_to(change_s)
            if self._pending and self._pending[0][0] <= change_s:
                at_s, force_n = self._pending.popleft()
                self._apply(force_n, at_s, at_s + _PERIOD_S)
            else:
                self._apply(ZERO, change_s, math.inf)
        self._run_to(now_s)

    def reading(self, now_s: float) -> DeviceReading:
        """Encoders and buttons at `now_s`."""
        position_m = self._plant.position_m
        if position_m is not self._read_m:
            self._read_m = position_m
            self._read(position_m)
        return DeviceReading(self._seen_m, self.buttons, self.is_homed, now_s)

    def _read(self, position_m: Vector) -> None:
        kinematics = self._kinematics
        geometry, pose = kinematics.geometry, kinematics.inverse(position_m)
        zero_rad, count_rad = geometry.theta0_rad, geometry.count_rad
        a, b, c = pose.theta_rad
        counts = (
            round((a - zero_rad) / count_rad),
            round((b - zero_rad) / count_rad),
            round((c - zero_rad) / count_rad),
        )
        if counts != self._counts:
            self._counts = p, q, r = counts
            a, b, c = (
                zero_rad + p * count_rad,
                zero_rad + q * count_rad,
                zero_rad + r * count_rad,
            )
            self._seen_m = kinematics.forward((a, b, c), position_m, pose)

    def act(self, control: Control) -> None:
        """Do what concerns hand, buttons and homing; other acts are not for here."""
        if control.event is ScriptedEvent.LET_GO:
            self.let_go()
        elif control.event is ScriptedEvent.GRASP:
            self.grasp()
        elif control.event is ScriptedEvent.BUTTONS:
            self.buttons = int(control.value)
        elif control.event is ScriptedEvent.LOSE_HOMING:
            self.is_homed = False

    def let_go(self) -> None:
        """Take the hand away; the grip alone remains."""
        self._plant.let_go()

    def grasp(self, hand: Hand | None = None) -> None:
        """Put a hand on the grip where it is; by default the one from before."""
        self._hand = hand or self._hand
        self._plant.grasp(self._hand)

    def place(self, position_m: Vector) -> None:
        """Put the grip somewhere within the end stops, at rest."""
        self._plant.place(position_m)

    def aim(self, position_m: Vector) -> None:
        """Let the person want the grip there; the rest point follows slowly."""
        self._plant.aim_m = position_m

    def _apply(self, force_n: Vector, at_s: float, next_due_s: float) -> None:
        if force_n != self.applied_n:
            self.applied_n, self.applied_since_s = force_n, at_s
        is_zero = force_n == ZERO
        self._expires_s = math.inf if is_zero else next_due_s + self.electronics.hold_s

    def _run_to(self, end_s: float) -> None:
        begin_s = end_s if self._now_s is None else self._now_s
        if end_s > begin_s:
            self._plant.advance(self.applied_n, min(end_s - begin_s, MAX_REPLAY_S))
            self._now_s = end_s
