"""A simulated Falcon: the grip as a point mass held by a relaxed hand."""

import math
from dataclasses import dataclass

from hapticplayer.model.device import DeviceCapabilities, DeviceReading, Vector

# The Falcon's own figures: 40 mm usable radius (CHAI3D), about 9 N peak.
FALCON = DeviceCapabilities(
    axes=3,
    peak_force_n=9.0,
    continuous_force_n=4.5,
    workspace_radius_m=0.04,
    rate_hz=1000.0,
    latency_s=0.001,
)
MAX_STEP_S = 0.001
MAX_GAP_S = 0.05  # after a longer silence the model does not replay the time


@dataclass(frozen=True, slots=True)
class Hand:
    """A relaxed hand on the grip: mass, spring and damper about the centre.

    Attributes:
        mass_kg: grip (0.13 kg lateral, see the Falcon's inertia) plus hand.
        stiffness_n_per_m: 4.5 N moves the grip by 3 cm.
        damping_n_s_per_m: damping ratio 0.5.
    """

    mass_kg: float = 0.45
    stiffness_n_per_m: float = 150.0
    damping_n_s_per_m: float = 8.2


class SimulatedFalcon:
    """The grip as a point mass; semi-implicit Euler in steps of at most 1 ms."""

    name = "simulated"
    capabilities = FALCON

    def __init__(self, hand: Hand | None = None) -> None:
        self._hand = hand or Hand()
        self._position: list[float] = [0.0, 0.0, 0.0]
        self._velocity: list[float] = [0.0, 0.0, 0.0]
        self._last_s: float | None = None

    def open(self) -> None:
        """Put the grip at rest in the centre."""
        self._position, self._velocity, self._last_s = [0.0] * 3, [0.0] * 3, None

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Let the force act since the last exchange and return the position."""
        elapsed_s = 0.0 if self._last_s is None else now_s - self._last_s
        self._last_s = now_s
        steps = math.ceil(min(elapsed_s, MAX_GAP_S) / MAX_STEP_S - 1e-9)
        if steps > 0:
            self._advance(force_n, min(elapsed_s, MAX_GAP_S) / steps, steps)
        x, y, z = self._position
        return DeviceReading((x, y, z), 0, is_homed=True)

    def close(self) -> None:
        """Nothing to let go of."""

    def _advance(self, force_n: Vector, step_s: float, steps: int) -> None:
        hand, position, velocity = self._hand, self._position, self._velocity
        per_mass = step_s / hand.mass_kg
        for _ in range(steps):
            for axis in (0, 1, 2):
                velocity[axis] += per_mass * (
                    force_n[axis]
                    - hand.stiffness_n_per_m * position[axis]
                    - hand.damping_n_s_per_m * velocity[axis]
                )
                position[axis] += step_s * velocity[axis]
        self._stop_at_the_wall()

    def _stop_at_the_wall(self) -> None:
        radius = math.hypot(*self._position)
        if radius > FALCON.workspace_radius_m:
            shrink = FALCON.workspace_radius_m / radius
            self._position = [shrink * value for value in self._position]
            self._velocity = [0.0, 0.0, 0.0]
