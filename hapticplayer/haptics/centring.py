"""A spring that keeps the grip inside, the stronger the further out, and a damper.

In the inner part of the workspace there is nothing. Beyond `from_m` a pull p(r) to the
middle grows with the square of the way, with stiffness K(r) = p'(r) rising evenly from
0; beyond `full_m` it continues in a straight line. Nothing adapts in time: its strength
depends on where the grip is and how it moves, and the force track is never filtered.

The damper is a prediction: spring and fade (`limiter.faded`) are taken where the grip
will be after `ahead_s` at its present speed. To first order that is a damper of
b(r) = K(r) ahead_s, hence none inside and most on the way out near the edge, and there
is no place and no speed at which the pull turns outward. It belongs to the fade too,
which is a spring of 4.5 N / 12 mm = 375 N/m while the track pushes.

Stability. A sampled spring needs b > K (T/2 + delay) (Colgate & Schenkel 1997). With
T = 1 ms, one period from reading to command and 3 ms more in the device, T/2 + delay
is 4.5 ms; `ahead_s` is 10 ms because the speed is smoothed over 4 ms. For a grip that
moves steadily, seen `delay` late, p(r + v (ahead_s - delay)) resists the way out more
than p(r) and drives the way in less: no energy is made, for any rising p. The device's
own friction is not needed, and a free grip of 0.05 to 0.3 kg comes to rest at every
radius (`benchmarks.haptics centring`: eigenvalues, sweeps and the energy observer).
"""

import math
from typing import NamedTuple

from hapticplayer.haptics.hand import HandState
from hapticplayer.haptics.limiter import ZERO, Limits, faded
from hapticplayer.model.device import Vector

_FROM, _FULL = 0.4, 0.9  # shares of the workspace


class Centring(NamedTuple):
    """Settings of spring and damper; the defaults are a Falcon's."""

    # at `full_m`. With it a relaxed hand that gives way to a steady push stays below
    # 0.8 of the workspace under 4.5 N
    pull_n: float = 3.0
    from_m: float = 0.016  # radius below which there is no pull
    full_m: float = 0.036  # radius from which the stiffness stays what it is
    ahead_s: float = 0.010  # prediction time of spring and fade

    def stiffness_n_per_m(self, radius_m: float) -> float:
        """Return K(r), the slope of the pull."""
        width_m = self.full_m - self.from_m
        share = min(1.0, max(0.0, (radius_m - self.from_m) / width_m))
        return 2.0 * self.pull_n * share / width_m


def centring_of(limits: Limits) -> Centring:
    """Return the settings for a device's workspace."""
    reach_m = limits.workspace_m
    return Centring(from_m=_FROM * reach_m, full_m=_FULL * reach_m)


def ahead_of(hand: HandState, centring: Centring) -> Vector:
    """Return where the grip will be in a moment, m, frame D."""
    (x, y, z), (vx, vy, vz) = hand.position_m, hand.velocity_mps
    ahead_s = centring.ahead_s
    return (x + ahead_s * vx, y + ahead_s * vy, z + ahead_s * vz)


def centring_force(ahead_m: Vector, centring: Centring) -> Vector:
    """Return the force towards the middle, N, frame D; `ahead_m` is from `ahead_of`."""
    x, y, z = ahead_m
    radius_m = math.hypot(x, y, z)
    past_m = radius_m - centring.from_m
    if past_m <= 0.0:
        return ZERO
    share = past_m / (centring.full_m - centring.from_m)
    pull_n = centring.pull_n * (share * share if share < 1.0 else 2.0 * share - 1.0)
    per_m = -pull_n / radius_m
    return (per_m * x, per_m * y, per_m * z)


def kept_inside(
    planned_n: Vector, hand: HandState, limits: Limits, centring: Centring
) -> tuple[Vector, Vector]:
    """Return the planned force with fade and spring, and the spring's share."""
    ahead_m = ahead_of(hand, centring)
    pull = centring_force(ahead_m, centring)
    x, y, z = faded(planned_n, ahead_m, limits)
    return (x + pull[0], y + pull[1], z + pull[2]), pull
