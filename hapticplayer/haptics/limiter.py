"""The last stage before the wire; it knows nothing of the player.

Limits: shared safety contract, design section 6.
"""

import math
from dataclasses import dataclass

from hapticplayer.model.device import Vector

PERIOD_S = 0.001
ZERO: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Limits:
    """What no command may exceed.

    Attributes:
        force_cap_n: magnitude of the force.
        content_slew_n: change per tick while the track is followed.
        stop_slew_n: change per tick on the way to zero: 5 N in 20 ms.
        entry_slew_n: change per tick while the force comes back: 0.05 N per ms.
        entry_ticks: shortest time over which the force comes back.
    """

    force_cap_n: float = 4.5
    content_slew_n: float = 1.0
    stop_slew_n: float = 0.25
    entry_slew_n: float = 0.05
    entry_ticks: int = 200


def is_finite(force_n: Vector) -> bool:
    """Whether all three components are numbers (the sum of squares may overflow)."""
    x, y, z = force_n
    return math.isfinite(x) and math.isfinite(y) and math.isfinite(z)


def limit(target_n: Vector, previous_n: Vector, slew_n: float, cap_n: float) -> Vector:
    """Return the force nearest to the target that the caps allow.

    Both caps shorten vectors and keep their direction. A target that is not
    finite counts as zero.

    Args:
        target_n: what is wanted.
        previous_n: what was sent a tick ago, finite and within the cap.
        slew_n: largest change of the vector, N per tick.
        cap_n: largest magnitude, N.
    """
    if not is_finite(target_n):
        target_n = ZERO
    x, y, z = target_n
    magnitude = math.hypot(x, y, z)
    if magnitude > cap_n:
        if math.isinf(magnitude):  # components near the largest double
            x, y, z = x * 1e-300, y * 1e-300, z * 1e-300
            magnitude = math.hypot(x, y, z)
        shrink = cap_n / magnitude
        x, y, z = x * shrink, y * shrink, z * shrink
    px, py, pz = previous_n
    dx, dy, dz = x - px, y - py, z - pz
    change = math.hypot(dx, dy, dz)
    if change > slew_n:
        share = slew_n / change
        x, y, z = px + dx * share, py + dy * share, pz + dz * share
    return (x, y, z)
