"""What the view of the grip shows: a value, and the shapes that stand for it.

Shapes are lists of points in frame D, metres; the painter projects them.
"""

import enum
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.device import Vector

TRAIL_S = 0.5
TRAIL_STEP_S = 0.020
# Steps too small for a pixel, so that a grip at rest is not painted again and again.
STEP_M, STEP_N = 5e-5, 0.01
NEAR_SHARE, ZONE_SHARE = 0.8, 0.9  # of the radius; the zone is the outer 10 %
ARROW_RADII = 0.5  # length of the arrow at the force that the device holds for ever
LEAST_SHOWN_N = 0.05  # below it is no arrow: nobody feels so little
GRIP_RADII = 0.15  # a ball that is seen, not the size of a real one
_ZERO = (0.0, 0.0, 0.0)
_CIRCLE_POINTS = 64
_ROUND_POINTS = 16


class Activity(enum.Enum):
    """What happens to the force."""

    OFF = 0
    CHANGING = 1
    ACTIVE = 2
    STOPPED = 3


@dataclass(frozen=True, slots=True)
class Grip:
    """All that is shown; equal values look the same.

    Attributes:
        title: of the view.
        state: what happens, in words; long ones are wrapped.
        activity: the same as a colour.
        position_m: of the grip from the centre, frame D; None while nobody knows it.
        force_n: on the hand, like `planned_n` by the track, `centring_n` of the spring
            that keeps the grip inside; the last is a share of the first.
        trail_m: where the grip was in the last half second, oldest first.
        radius_m: of the workspace.
        full_force_n: what the longest arrow stands for.
    """

    title: str
    state: str
    activity: Activity = Activity.OFF
    position_m: Vector | None = None
    force_n: Vector = _ZERO
    planned_n: Vector = _ZERO
    centring_n: Vector = _ZERO
    trail_m: tuple[Vector, ...] = ()
    radius_m: float = 0.040
    full_force_n: float = 4.5

    @property
    def excursion_m(self) -> float:
        """Distance of the grip from the centre."""
        return math.hypot(*self.position_m) if self.position_m else 0.0

    @property
    def excursion_share(self) -> float:
        """The same as a share of the workspace's radius."""
        return self.excursion_m / self.radius_m

    def arrow_m(self, force_n: Vector) -> Vector | None:
        """Return a force as a length and a direction, None where it is too small."""
        if math.hypot(*force_n) < LEAST_SHOWN_N:
            return None
        return scaled(force_n, ARROW_RADII * self.radius_m / self.full_force_n)


def position_of(tick: Any) -> Vector | None:
    """Return where the grip was at a tick, None where that is no position."""
    return _rounded(tick["position_m"], STEP_M)


def force_of(tick: Any, field: str) -> Vector:
    """Return one of the forces of a tick; zero where it is no force."""
    return _rounded(tick[field], STEP_N) or _ZERO


def trail_of(ticks: NDArray[Any]) -> tuple[Vector, ...]:
    """Return where the grip was, every 20 ms of the last half second.

    Args:
        ticks: records of TICK, oldest first.

    Returns:
        Positions, oldest first; none where the grip did not move.
    """
    if not len(ticks):
        return ()
    time_s = ticks["monotonic_s"]
    first = int(np.searchsorted(time_s, time_s[-1] - TRAIL_S))
    # cells of the clock: counted from the newest tick, all points would creep
    cells = np.floor(time_s[first:] / TRAIL_STEP_S)
    rows = first + np.flatnonzero(np.diff(cells, prepend=-1.0))
    known = [_rounded(place, STEP_M) for place in ticks["position_m"][rows]]
    points = tuple(point for point in known if point)
    return points if len(set(points)) > 1 else ()


def _rounded(values: NDArray[Any], step: float) -> Vector | None:
    x, y, z = (float(value) for value in values)
    if not math.isfinite(x + y + z):
        return None
    return round(x / step) * step, round(y / step) * step, round(z / step) * step


# --- shapes -------------------------------------------------------------------


def great_circles(radius_m: float) -> list[list[Vector]]:
    """Return the circles of a sphere about x, y and z; each ends where it begins."""
    ring = _ring(_CIRCLE_POINTS, radius_m)
    ring.append(ring[0])
    return [
        [(0.0, a, b) for a, b in ring],
        [(b, 0.0, a) for a, b in ring],
        [(a, b, 0.0) for a, b in ring],
    ]


def floor_disc(radius_m: float, centre_m: Vector = _ZERO) -> list[Vector]:
    """Return a circle that lies flat around a point."""
    x, y, z = centre_m
    return [(x + a, y, z + b) for a, b in _ring(_CIRCLE_POINTS // 2, radius_m)]


def floor_grid(radius_m: float, height_m: float) -> list[tuple[Vector, Vector]]:
    """Return lines half a radius apart, along x and z, that end at a circle."""
    lines: list[tuple[Vector, Vector]] = []
    for share in (-0.5, 0.0, 0.5):
        at, half = share * radius_m, math.sqrt(1.0 - share**2) * radius_m
        lines.append(((at, height_m, -half), (at, height_m, half)))
        lines.append(((-half, height_m, at), (half, height_m, at)))
    return lines


def cap(direction: Vector, radius_m: float, half_angle_rad: float) -> list[Vector]:
    """Return a circle on a sphere around where a direction leaves it."""
    axis = unit(direction)
    centre_m = scaled(axis, radius_m * math.cos(half_angle_rad))
    return disc(centre_m, axis, radius_m * math.sin(half_angle_rad))


def disc(centre_m: Vector, axis: Vector, radius_m: float) -> list[Vector]:
    """Return a circle around an axis (a unit vector)."""
    across = unit(cross(axis, (0.0, 1.0, 0.0) if abs(axis[1]) < 0.9 else (1.0, 0, 0)))
    along = cross(axis, across)
    return [
        added(centre_m, added(scaled(across, a), scaled(along, b)))
        for a, b in _ring(_ROUND_POINTS, radius_m)
    ]


def _ring(count: int, radius_m: float) -> list[tuple[float, float]]:
    turns = (math.tau * k / count for k in range(count))
    return [(radius_m * math.cos(turn), radius_m * math.sin(turn)) for turn in turns]


def hull(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the convex hull in order; Andrew's monotone chain."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    return _chain(ordered)[:-1] + _chain(ordered[::-1])[:-1]


def _chain(ordered: list[tuple[float, float]]) -> list[tuple[float, float]]:
    chain: list[tuple[float, float]] = []
    for x, y in ordered:
        while len(chain) >= 2:
            (ax, ay), (bx, by) = chain[-2:]
            if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0:
                break
            chain.pop()
        chain.append((x, y))
    return chain


# --- vectors ------------------------------------------------------------------


def added(a: Vector, b: Vector) -> Vector:
    """Return a + b."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """Return a times a number."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def unit(a: Vector) -> Vector:
    """Return the direction of a vector that is not zero."""
    return scaled(a, 1.0 / math.hypot(*a))


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )
