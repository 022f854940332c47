"""What hangs on the simulated board's motors and encoders."""

from typing import Protocol

from hapticplayer.devices.falcon.kinematics import WORDS_PER_NM, Kinematics
from hapticplayer.devices.falcon.matrix3 import cross, dot
from hapticplayer.devices.falcon.protocol import Reply, Words
from hapticplayer.devices.simulated import Simulation
from hapticplayer.model.device import Vector

_ALL_HOMED = 7


class Mechanics(Protocol):
    """Motors, encoders and buttons; times never run backwards."""

    def command(self, words: Words, at_s: float) -> None:
        """Put words on the motors."""
        ...

    def reply(self, at_s: float) -> Reply:
        """Return encoders and buttons."""
        ...


class BenchMechanics:
    """Encoders that stand where a test has put them; commands are written down.

    Attributes:
        counts: of the encoders.
        buttons: pressed ones.
        homed: encoders that have found their zero.
        commands: what came, and when.
    """

    def __init__(self, counts: Words = (-300, -300, -300), homed: int = 7) -> None:
        self.counts, self.buttons, self.homed = counts, 0, homed
        self.commands: list[tuple[float, Words]] = []

    def command(self, words: Words, at_s: float) -> None:
        """Write the words down."""
        self.commands.append((at_s, words))

    def reply(self, at_s: float) -> Reply:  # noqa: ARG002 - they stand still
        """Return what the test wants."""
        return Reply(self.counts, self.buttons, self.homed)


class SimulatedMechanics:
    """The physics of `devices.simulated` between motor words and encoder counts.

    Args:
        simulation: in frame D, from the workspace's centre.
        kinematics: of the legs.
    """

    def __init__(
        self, simulation: Simulation, kinematics: Kinematics | None = None
    ) -> None:
        self.simulation = simulation
        self._kinematics = kinematics or Kinematics()

    def command(self, words: Words, at_s: float) -> None:
        """Let the motors push: F = J^-T tau with tau = -words / 10000."""
        simulation = self.simulation
        simulation.advance(at_s)
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
