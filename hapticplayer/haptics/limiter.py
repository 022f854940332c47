"""The last stage before the wire; it knows nothing of the player.

A command is bounded in magnitude and in change, by the position of the grip, by the
heat of the motors, and by its age. Limits: safety contract, docs/safety.md.
"""

import math
from dataclasses import dataclass

from hapticplayer.model.device import DeviceCapabilities, Vector

PERIOD_S = 0.001
ZERO: Vector = (0.0, 0.0, 0.0)
# Share of the continuous force from which the cap sinks, so that it sinks gently.
_WARM_SHARE = 0.8


@dataclass(frozen=True, slots=True)
class Limits:
    """What no command may exceed.

    Attributes:
        force_cap_n: magnitude of the force.
        late_cap_n: the same while the loop misses too many periods.
        continuous_n: RMS over `heat_time_s` that the motors can bear for any time.
        heat_time_s: time constant of that RMS.
        content_slew_n: change per tick while the track is followed.
        stop_slew_n: change per tick on the way to zero: 5 N in 20 ms.
        entry_slew_n: change per tick while the force comes back: 0.05 N per ms.
        entry_ticks: shortest time over which the force comes back.
        workspace_m: radius that the grip can reach.
        fade_from, fade_to: shares of it between which outward force fades to zero.
        outside: share of it beyond which outward force is a fault.
        middle: share of it within which a person may re-arm.
        speed_mps: faster than this no held hand is moved.
        command_age_s: a command that comes later to the wire is not sent.
    """

    force_cap_n: float = 4.5
    late_cap_n: float = 3.0
    continuous_n: float = 4.5
    heat_time_s: float = 10.0
    content_slew_n: float = 1.0
    stop_slew_n: float = 0.25
    entry_slew_n: float = 0.05
    entry_ticks: int = 200
    workspace_m: float = 0.04
    fade_from: float = 0.6
    fade_to: float = 0.9
    outside: float = 0.9
    middle: float = 0.5
    speed_mps: float = 1.0
    command_age_s: float = 0.020


def limits_of(capabilities: DeviceCapabilities) -> Limits:
    """Return the limits for a device; never more than the defaults."""
    usual = Limits()
    return Limits(
        force_cap_n=min(usual.force_cap_n, capabilities.peak_force_n),
        late_cap_n=min(usual.late_cap_n, capabilities.peak_force_n),
        continuous_n=min(usual.continuous_n, capabilities.continuous_force_n),
        workspace_m=capabilities.workspace_radius_m,
    )


def is_finite(force_n: Vector) -> bool:
    """Whether all three components are numbers (their sum may overflow)."""
    x, y, z = force_n
    return math.isfinite(x + y + z) or (
        math.isfinite(x) and math.isfinite(y) and math.isfinite(z)
    )


def limit(target_n: Vector, previous_n: Vector, slew_n: float, cap_n: float) -> Vector:
    """Return the force nearest to the target that the caps on step and magnitude allow.

    Both caps shorten vectors and keep their direction. A target that is not finite
    counts as zero. `previous_n`, what was sent a tick ago, is finite and within the
    cap.
    """
    x, y, z = target_n
    magnitude = math.hypot(x, y, z)
    if not magnitude <= cap_n:  # true of what is not finite, too
        x, y, z = _shortened(target_n, cap_n)
    px, py, pz = previous_n
    dx, dy, dz = x - px, y - py, z - pz
    change = math.hypot(dx, dy, dz)
    if change > slew_n:
        share = slew_n / change
        x, y, z = px + dx * share, py + dy * share, pz + dz * share
    return (x, y, z)


def _shortened(force_n: Vector, cap_n: float) -> Vector:
    if not is_finite(force_n):
        return ZERO
    x, y, z = force_n
    magnitude = math.hypot(x, y, z)
    if math.isinf(magnitude):  # components near the largest double
        x, y, z = x * 1e-300, y * 1e-300, z * 1e-300
        magnitude = math.hypot(x, y, z)
    shrink = cap_n / magnitude
    return (x * shrink, y * shrink, z * shrink)


def faded(force_n: Vector, position_m: Vector, limits: Limits) -> Vector:
    """Return the force without what would push the grip out of its workspace.

    The part along the way out fades between `fade_from` and `fade_to`; the parts
    inward and across stay.
    """
    x, y, z = position_m
    radius_m = math.hypot(x, y, z)
    begin_m = limits.fade_from * limits.workspace_m
    if radius_m <= begin_m:
        return force_n
    fx, fy, fz = force_n
    outward = (fx * x + fy * y + fz * z) / radius_m
    if not 0.0 < outward < math.inf:  # the next stage handles what is not finite
        return force_n
    past = (radius_m - begin_m) / (limits.fade_to * limits.workspace_m - begin_m)
    away = outward * min(1.0, past) / radius_m
    return (fx - away * x, fy - away * y, fz - away * z)


def is_near_middle(position_m: Vector, limits: Limits) -> bool:
    """Whether a person may re-arm with the grip there."""
    return math.hypot(*position_m) <= limits.middle * limits.workspace_m


def outward_n(force_n: Vector, position_m: Vector) -> float:
    """Return the part of a force along the way out of the workspace, N."""
    x, y, z = position_m
    radius_m = math.hypot(x, y, z)
    if radius_m == 0.0:
        return 0.0
    return (force_n[0] * x + force_n[1] * y + force_n[2] * z) / radius_m


def warmed(heat_n2: float, force_n: Vector, elapsed_s: float, limits: Limits) -> float:
    """Return the mean square force of the last seconds after one more command, N^2."""
    x, y, z = force_n
    share = elapsed_s / limits.heat_time_s
    if not share < 1.0:
        share = 1.0
    return heat_n2 + share * (x * x + y * y + z * z - heat_n2)


def cap_when_warm(heat_n2: float, limits: Limits) -> float:
    """Return the force cap, N, for the present heat of the motors.

    It sinks from the peak to the continuous force while the mean square rises from
    0.64 of its limit to the limit, which it cannot pass therefore.
    """
    full = limits.continuous_n * limits.continuous_n
    left = (full - heat_n2) / (full * (1.0 - _WARM_SHARE * _WARM_SHARE))
    if left >= 1.0:
        return limits.force_cap_n
    spare = max(0.0, limits.force_cap_n - limits.continuous_n)
    return limits.force_cap_n - spare * (1.0 - max(0.0, left))
