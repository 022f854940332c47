"""What the grip view shows, and the camera that projects it."""

import enum
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from hapticplayer.devices.falcon.matrix3 import cross, dot
from hapticplayer.haptics.contract import Mode
from hapticplayer.model.device import Vector

Pixel = tuple[float, float]

# From the user's place a little to the left and above, so that all three axes show
# and the third one points at the person.
YAW_RAD, PITCH_RAD = math.radians(-28.0), math.radians(20.0)
STEEPEST_RAD = math.radians(85.0)
LEAST_ZOOM, MOST_ZOOM = 0.5, 4.0
DISTANCE_RADII = 5.0  # near enough to tell near from far
# Of the shorter side. The rest is for words, and for an arrow at the rim.
_SPHERE_SHARE = 0.345
_MIDDLE_SHARE = 0.475  # the floor needs more room below than the sphere above
_LEAST_DEPTH_SHARE = 0.1  # what comes closer is shown at this depth


@dataclass(frozen=True, slots=True)
class Camera:
    """Where one looks from; always at the centre of the workspace."""

    yaw_rad: float = YAW_RAD  # to the right of the user's own place
    pitch_rad: float = PITCH_RAD  # above it
    zoom: float = 1.0  # 1 shows the whole workspace

    def turned(self, yaw_rad: float, pitch_rad: float) -> Self:
        """Return the camera moved round the workspace; never over the top."""
        pitch_rad = self.pitch_rad + pitch_rad
        return replace(
            self,
            yaw_rad=math.remainder(self.yaw_rad + yaw_rad, math.tau),
            pitch_rad=min(STEEPEST_RAD, max(-STEEPEST_RAD, pitch_rad)),
        )

    def zoomed(self, factor: float) -> Self:
        """Return the camera nearer or farther, within limits."""
        return replace(self, zoom=min(MOST_ZOOM, max(LEAST_ZOOM, self.zoom * factor)))


@dataclass(frozen=True)
class Projection:
    """One camera before one workspace in one view."""

    camera: Camera
    radius_m: float
    width_px: float
    height_px: float

    @cached_property
    def back(self) -> Vector:
        """Unit vector from the centre of the workspace to the camera."""
        yaw, pitch = self.camera.yaw_rad, self.camera.pitch_rad
        flat = math.cos(pitch)
        return math.sin(yaw) * flat, math.sin(pitch), math.cos(yaw) * flat

    @cached_property
    def right(self) -> Vector:
        """Unit vector that goes to the right in the view."""
        return math.cos(self.camera.yaw_rad), 0.0, -math.sin(self.camera.yaw_rad)

    @cached_property
    def up(self) -> Vector:
        """Unit vector that goes up in the view."""
        yaw, sine = self.camera.yaw_rad, math.sin(self.camera.pitch_rad)
        flat = math.cos(self.camera.pitch_rad)
        return -math.sin(yaw) * sine, flat, -math.cos(yaw) * sine

    @cached_property
    def distance_m(self) -> float:
        """From the camera to the centre of the workspace."""
        return DISTANCE_RADII * self.radius_m

    @cached_property
    def middle_px(self) -> Pixel:
        """Where the centre of the workspace is in the view."""
        return 0.5 * self.width_px, _MIDDLE_SHARE * self.height_px

    @cached_property
    def sphere_px(self) -> float:
        """Radius of the workspace's outline, a circle around the middle."""
        side_px = min(self.width_px, self.height_px)
        return _SPHERE_SHARE * side_px * self.camera.zoom

    @cached_property
    def focal_px(self) -> float:
        """Size in pixels of what is as large as it is far away.

        The outline of a sphere of radius R at distance d is where the rays touch it:
        at R / sqrt(d^2 - R^2).
        """
        touching_m = math.sqrt(self.distance_m**2 - self.radius_m**2)
        return self.sphere_px * touching_m / self.radius_m

    def depth_m(self, point_m: Vector) -> float:
        """Return the distance from the camera along its line of sight."""
        return self.distance_m - dot(self.back, point_m)

    def px_per_m(self, point_m: Vector) -> float:
        """Return how large something at this point is shown."""
        nearest_m = _LEAST_DEPTH_SHARE * self.distance_m
        return self.focal_px / max(nearest_m, self.depth_m(point_m))

    def px(self, point_m: Vector) -> Pixel:
        """Return where a point of frame D is in the view."""
        scale = self.px_per_m(point_m)
        x_px, y_px = self.middle_px
        return (
            x_px + scale * dot(self.right, point_m),
            y_px - scale * dot(self.up, point_m),
        )

    def is_in_front(self, point_m: Vector) -> bool:
        """Whether a point of the workspace's surface is on the camera's side."""
        return dot(self.back, point_m) * self.distance_m >= self.radius_m**2


TRAIL_S = 0.5
TRAIL_STEP_S = 0.020
# Steps too small for a pixel, so that a grip at rest is not painted again and again.
STEP_M, STEP_N = 5e-5, 0.01
NEAR_SHARE, ZONE_SHARE = 0.8, 0.9  # of the radius; the zone is the outer 10 %
ARROW_RADII = 0.5  # length of the arrow at the force that the device holds for ever
LEAST_SHOWN_N = 0.05  # no arrow below it: too little to be felt
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


ACTIVITIES = {
    Mode.IDLE: Activity.OFF,
    Mode.FOLLOWING: Activity.ACTIVE,
    Mode.TRIPPED: Activity.STOPPED,
}
"""Of the modes of the loop; in the others the force is changing."""


@dataclass(frozen=True, slots=True)
class Grip:
    """All that is shown; equal values look the same.

    Attributes:
        state: what happens, in words; long ones are wrapped.
        activity: the same as a colour.
        position_m: of the grip from the centre, frame D; None while nobody knows it.
        force_n: on the hand, like `planned_n` by the track, `centring_n` of the spring
            that keeps the grip inside; the last is a share of the first.
        trail_m: where the grip was in the last half second, oldest first.
        full_force_n: force of the longest arrow.
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
    """Return where the grip was at a tick, None where it is not finite."""
    return _rounded(tick["position_m"], STEP_M)


def force_of(tick: Any, field: str) -> Vector:
    """Return one of the forces of a tick; zero where it is no force."""
    return _rounded(tick[field], STEP_N) or _ZERO


def trail_of(ticks: NDArray[Any]) -> tuple[Vector, ...]:
    """Return where the grip was, every 20 ms of the last half second, oldest first.

    The ticks are records of TICK, oldest first. None where the grip did not move.
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
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """Return a times a number."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def unit(a: Vector) -> Vector:
    """Return the direction of a vector that is not zero."""
    return scaled(a, 1.0 / math.hypot(*a))
