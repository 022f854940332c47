"""Draws what the simulator's camera sees, about 15 ms a picture of 720 lines.

Each pixel below the horizon is projected onto the ground plane and looks its
colour up in a texture that is fine enough for its distance; the clouds are a second
plane above; trees and posts are upright sprites.
"""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.ride.colours import (
    HAZE,
    Floats32,
    Pixels,
    haze_share,
    mixed,
)
from hapticplayer.capture.ride.foreground import make_foreground
from hapticplayer.capture.ride.ground import SIZE, GroundTexture
from hapticplayer.capture.ride.scenery import Country
from hapticplayer.capture.ride.sky import Sky
from hapticplayer.capture.ride.sprites import Placement, draw_sprite, make_sprites
from hapticplayer.capture.ride.stairs import draw_face
from hapticplayer.capture.ride.view import Pose, View

_NEAREST_M = 0.6
_FARTHEST_M = 170.0
_LEAST_PX = 2.0


class PictureMaker:
    """Draws pictures of one country in one size."""

    def __init__(
        self, country: Country, width: int, height: int, rng: np.random.Generator
    ) -> None:
        self._country = country
        self._view = View.of_size(width, height)
        self._sprites = make_sprites(rng, wooden=country.vehicle == "horse")
        self._sky = Sky(rng)
        self._foreground = make_foreground(country.vehicle, width, height, rng)

    def draw(self, pose: Pose) -> NDArray[np.uint8]:
        """Return the picture (height, width, 4): RGB and a channel that says nothing."""
        self._country.prepare([pose])
        canvas = np.empty(self._view.size, np.uint32)
        rotation = pose.rotation.astype(np.float32)
        rise = self._view.towards(rotation[2])
        self._sky.draw(canvas, self._view, rotation, rise)
        nearer_m = 0.0
        last = self._country.ground[-1]
        for texture in self._country.ground:
            reach_m = np.inf if texture is last else texture.reach_m
            self._draw_ground(canvas, texture, pose, rise, (nearer_m, reach_m))
            nearer_m = texture.reach_m
        self._draw_standing(canvas, pose)
        for face in self._country.faces:
            draw_face(canvas, self._view, pose, face)
        if self._foreground is not None:
            self._foreground.lay_over(canvas, pose.shake_px, pose.steering_rad)
        return canvas.view(np.uint8).reshape(*canvas.shape, 4)

    def prepare(self, poses: list[Pose], margin_m: float) -> None:
        """Paint the ground for poses that will be drawn, by several threads perhaps."""
        self._country.prepare(poses, margin_m)

    def _draw_ground(
        self,
        canvas: Pixels,
        texture: GroundTexture,
        pose: Pose,
        rise: Floats32,
        between_m: tuple[float, float],
    ) -> None:
        """Draw what lies between two distances."""
        nearer_m, reach_m = between_m
        height_m = float(pose.position_m[2])
        # a ray that rises by -h / d meets the ground at the distance d
        flattest = np.float32(-height_m / reach_m)
        steepest = np.float32(-height_m / nearer_m if nearer_m else -np.inf)
        is_hit = (rise.min(axis=1) < flattest) & (rise.max(axis=1) > steepest)
        rows = np.flatnonzero(is_hit)
        if not len(rows):
            return
        band = slice(int(rows[0]), int(rows[-1]) + 1)
        fall = rise[band]
        distance = np.divide(height_m, np.maximum(-fall, 1e-4), dtype=np.float32)
        colours = self._look_up(texture, pose, band, distance)
        if not np.isfinite(reach_m):
            colours = mixed(colours, HAZE, haze_share(distance))
        np.copyto(canvas[band], colours, where=(fall < flattest) & (fall >= steepest))

    def _look_up(
        self, texture: GroundTexture, pose: Pose, band: slice, distance: Floats32
    ) -> Pixels:
        """Return the colour of the ground that each ray of a band of rows meets."""
        rotation = pose.rotation.astype(np.float32)
        view = View(self._view.x, self._view.z[band], self._view.focal_px)
        scale = np.minimum(distance, np.float32(texture.reach_m))
        scale /= np.float32(texture.pixel_m)
        # the window wraps around: a remainder, made positive by whole windows
        east, north = (
            view.towards(rotation[axis]) * scale
            + np.float32(pose.position_m[axis] / texture.pixel_m % SIZE + SIZE)
            for axis in (0, 1)
        )
        index = north.astype(np.int32)
        index &= SIZE - 1
        index *= SIZE
        index += east.astype(np.int32) & (SIZE - 1)
        return np.asarray(texture.pixels.reshape(-1).take(index))

    def _draw_standing(self, canvas: Pixels, pose: Pose) -> None:
        """Draw the things beside the road, from far to near."""
        things = self._country.standing
        right, front, up = ((things.foot_m - pose.position_m) @ pose.rotation).T
        per_m = self._view.focal_px / np.maximum(front, _NEAREST_M)
        visible = (front > _NEAREST_M) & (front < _FARTHEST_M)
        visible &= np.abs(right) < 1.4 * front + 4.0
        visible &= per_m * things.height_m >= _LEAST_PX
        numbers = np.flatnonzero(visible)
        rows, columns = self._view.size
        earth_up = pose.rotation[2]  # in the sensor frame
        lean = float(earth_up[0] / np.hypot(earth_up[0], earth_up[2]))
        for number in numbers[np.argsort(-front[numbers], kind="stable")]:
            place = Placement(
                foot_x=float(0.5 * columns + per_m[number] * right[number]),
                foot_y=float(0.5 * rows - per_m[number] * up[number]),
                height_px=float(per_m[number] * things.height_m[number]),
                lean=lean,
                distance_m=float(front[number]),
            )
            draw_sprite(canvas, self._sprites[things.kind[number]], place)
