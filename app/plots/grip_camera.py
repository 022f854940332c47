"""From frame D to pixels: a camera that goes round the workspace, with perspective.

Frame D: x right, y up, z towards the user. A camera with no yaw and no pitch stands
before the device, where the user sits. Pixels: x to the right, y downwards.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

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
    """Where one looks from; always at the centre of the workspace.

    Attributes:
        yaw_rad: to the right of the user's own place.
        pitch_rad: above it.
        zoom: 1 shows the whole workspace.
    """

    yaw_rad: float = YAW_RAD
    pitch_rad: float = PITCH_RAD
    zoom: float = 1.0

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
    """One camera before one workspace on one picture.

    Attributes:
        camera: where from.
        radius_m: of the workspace.
        width_px: of the picture, like `height_px`.
    """

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
        """Unit vector that goes to the right in the picture."""
        return math.cos(self.camera.yaw_rad), 0.0, -math.sin(self.camera.yaw_rad)

    @cached_property
    def up(self) -> Vector:
        """Unit vector that goes up in the picture."""
        yaw, sine = self.camera.yaw_rad, math.sin(self.camera.pitch_rad)
        flat = math.cos(self.camera.pitch_rad)
        return -math.sin(yaw) * sine, flat, -math.cos(yaw) * sine

    @cached_property
    def distance_m(self) -> float:
        """From the camera to the centre of the workspace."""
        return DISTANCE_RADII * self.radius_m

    @cached_property
    def middle_px(self) -> Pixel:
        """Where the centre of the workspace is in the picture."""
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
        return self.distance_m - _dot(self.back, point_m)

    def px_per_m(self, point_m: Vector) -> float:
        """Return how large something at this point is shown."""
        nearest_m = _LEAST_DEPTH_SHARE * self.distance_m
        return self.focal_px / max(nearest_m, self.depth_m(point_m))

    def px(self, point_m: Vector) -> Pixel:
        """Return where a point of frame D is in the picture."""
        scale = self.px_per_m(point_m)
        x_px, y_px = self.middle_px
        return (
            x_px + scale * _dot(self.right, point_m),
            y_px - scale * _dot(self.up, point_m),
        )

    def is_in_front(self, point_m: Vector) -> bool:
        """Whether a point of the workspace's surface is on the camera's side."""
        return _dot(self.back, point_m) * self.distance_m >= self.radius_m**2


def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
