"""What hangs on the simulated board's motors and encoders."""

from typing import Protocol

from hapticplayer.devices.falcon.kinematics import WORDS_PER_NM, Kinematics
from hapticplayer.devices.falcon.matrix3 import cross, dot
from hapticplayer.devices.falcon.protocol import Lights, MotorCommand, Reply
from hapticplayer.model.device import Vector
from hapticplayer.simulation.falcon.process import PlantRecorder
from hapticplayer.simulation.falcon.simulation import Simulation

_ALL_HOMED = 7
_OUT_M, _IN_M = 0.038, -0.038  # the ends of the way, less a little


class Mechanics(Protocol):
    """Motors, encoders and buttons; times never run backwards."""

    def command(self, command: MotorCommand, at_s: float) -> None:
        """Apply motor words and lights."""

    def reply(self, at_s: float) -> Reply:
        """Return encoders and buttons."""


class Homing:
    """Encoders without a zero, and an owner who gives them one.

    Once the program asks for homing, the person pulls the grip out, then pushes it in,
    and brings it to the middle; the device knows its place from the inner end on.

    Args:
        deciding_s: time before the person begins.
    """

    def __init__(self, deciding_s: float = 0.5) -> None:
        self.deciding_s = deciding_s
        self._since_s: float | None = None
        self._was_out = self._is_done = False

    def follow(self, simulation: Simulation, lights: int, at_s: float) -> None:
        """Move the hand on, and note how far it has come."""
        if self._since_s is None:
            simulation.is_homed = False
            if not lights & Lights.HOMING:
                return
            self._since_s = at_s
        z_m = simulation.position_m[2]
        self._was_out = self._was_out or z_m > _OUT_M
        if self._was_out and z_m < _IN_M and lights & Lights.HOMING:
            simulation.is_homed = self._is_done = True
        if self._is_done:
            simulation.aim((0.0, 0.0, 0.0))
        elif at_s - self._since_s > self.deciding_s:
            simulation.aim((0.0, 0.0, -0.06 if self._was_out else 0.06))


class SimulatedMechanics:
    """The physics of `simulation.falcon` between motor words and encoder counts."""

    def __init__(self, simulation: Simulation) -> None:
        self.simulation = simulation
        self.homing: Homing | None = None
        self._kinematics = Kinematics()

    def command(self, command: MotorCommand, at_s: float) -> None:
        """Let the motors push: F = J^-T tau with tau = -words / 10000."""
        simulation, words = self.simulation, command.words
        simulation.advance(at_s)
        if self.homing is not None:
            self.homing.follow(simulation, command.lights, at_s)
        # columns of J by joint; J^T F = tau by Cramer's rule
        a, b, c = zip(*self._kinematics.jacobian(self._place()), strict=True)
        bc, ca, ab = cross(b, c), cross(c, a), cross(a, b)
        scale = -1.0 / (WORDS_PER_NM * dot(a, bc))
        i, j, k = words
        force_n = tuple(
            scale * (i * p + j * q + k * r) for p, q, r in zip(bc, ca, ab, strict=True)
        )
        simulation.command((force_n[0], force_n[1], force_n[2]), at_s)

    def reply(self, at_s: float) -> Reply:
        """Return the counts of the true position."""
        simulation, kinematics = self.simulation, self._kinematics
        simulation.advance(at_s)
        counts = kinematics.counts(kinematics.inverse(self._place()))
        homed = _ALL_HOMED if simulation.is_homed else 0
        return Reply(counts, simulation.buttons, homed)

    def _place(self) -> Vector:
        x, y, z = self.simulation.position_m
        return (x, y, z + self._kinematics.geometry.centre_z_m)


class RecordedMechanics(SimulatedMechanics):
    """The same, written down in memory that outlives the process."""

    def __init__(self, simulation: Simulation, recorder: PlantRecorder) -> None:
        super().__init__(simulation)
        self._recorder = recorder

    def command(self, command: MotorCommand, at_s: float) -> None:
        """Let the motors push, and write it down."""
        super().command(command, at_s)
        self._recorder.write(at_s, self.simulation)
