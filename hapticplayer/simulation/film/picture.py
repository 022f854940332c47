"""Draws what the simulator's camera sees, about 12 ms a picture of 720 lines.

Each pixel below the horizon is projected onto the ground plane and looks its
colour up in a texture that is fine enough for its distance; the clouds are a second
plane above; trees and posts are upright sprites.
"""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.film.colours import (
    HAZE,
    Floats32,
    Pixels,
    haze_share,
    mixed,
)
from hapticplayer.simulation.film.foreground import make_foreground
from hapticplayer.simulation.film.ground import SIZE, GroundTexture
from hapticplayer.simulation.film.scenery import Country
from hapticplayer.simulation.film.sky import Sky
from hapticplayer.simulation.film.sprites import Placement, draw_sprite, make_sprites
from hapticplayer.simulation.film.stairs import draw_face
from hapticplayer.simulation.film.view import Pose, View

_NEAREST_M = 0.6
_FARTHEST_M = 150.0
_LEAST_PX = 7.0
_STRIP = 48


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
        self._sky.draw(canvas, self._view, rotation)
        for top in range(0, len(canvas), _STRIP):
            self._draw_strip(canvas, top, pose, rotation)
        self._draw_standing(canvas, pose)
        for face in self._country.faces:
            draw_face(canvas, self._view, pose, face)
        if self._foreground is not None:
            self._foreground.lay_over(canvas, pose.shake_px, pose.steering_rad)
        return canvas.view(np.uint8).reshape(*canvas.shape, 4)

    def prepare(self, poses: list[Pose], margin_m: float) -> None:
        """Paint the ground for poses that will be drawn, by several threads perhaps."""
        self._country.prepare(poses, margin_m)

    def _draw_strip(
        self, canvas: Pixels, top: int, pose: Pose, rotation: Floats32
    ) -> None:
        """Draw the ground in some rows; so few that all of it stays in the cache."""
        view = self._view.rows(top, top + _STRIP)
        edges = view.edges(rotation[2])
        height_m, nearer_m = float(pose.position_m[2]), 0.0
        rise: Floats32 | None = None
        for texture in self._country.ground:
            is_last = texture is self._country.ground[-1]
            # a ray that rises by -h / d meets the ground at the distance d
            flattest = np.float32(0.0 if is_last else -height_m / texture.reach_m)
            steepest = np.float32(-height_m / nearer_m if nearer_m else -np.inf)
            nearer_m = texture.reach_m
            if edges.min() >= flattest or edges.max() < steepest:
                continue
            rise = view.towards(rotation[2]) if rise is None else rise
            distance = np.minimum(rise, np.float32(-1e-4))
            np.divide(np.float32(-height_m), distance, out=distance)
            colours = _look_up(texture, view, pose, distance)
            if is_last:
                colours = mixed(colours, HAZE, haze_share(distance))
            seen = rise < flattest
            seen &= rise >= steepest
            np.copyto(canvas[top : top + _STRIP], colours, where=seen)

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


def _look_up(
    texture: GroundTexture, view: View, pose: Pose, distance: Floats32
) -> Pixels:
    """Return the colour of the ground that each ray meets."""
    rotation = pose.rotation.astype(np.float32)
    scale = np.minimum(distance, np.float32(texture.reach_m))
    scale *= np.float32(1.0 / texture.pixel_m)
    # the window wraps around: a remainder, made positive by whole windows
    column, row = (
        _cells(view.towards(rotation[axis]), scale, pose.position_m[axis], texture)
        for axis in (0, 1)
    )
    row *= SIZE
    row += column
    return np.asarray(texture.pixels.reshape(-1).take(row))


def _cells(
    ray: Floats32, scale: Floats32, at_m: float, texture: GroundTexture
) -> NDArray[np.int32]:
    ray *= scale
    ray += np.float32(at_m / texture.pixel_m % SIZE + SIZE)
    cells = ray.astype(np.int32)
    cells &= SIZE - 1
    return cells
