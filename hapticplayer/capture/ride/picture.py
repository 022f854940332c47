"""Draws what the simulator's camera sees, about 10 ms a picture.

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
from hapticplayer.capture.ride.handlebar import Handlebar
from hapticplayer.capture.ride.roadside import Standing
from hapticplayer.capture.ride.scenery import Country, GroundTexture
from hapticplayer.capture.ride.sky import Sky
from hapticplayer.capture.ride.sprites import Placement, draw_sprite, make_sprites
from hapticplayer.capture.ride.view import Pose, View

_NEAREST_M = 0.6


class PictureMaker:
    """Draws pictures of one country in one size."""

    def __init__(
        self, country: Country, width: int, height: int, rng: np.random.Generator
    ) -> None:
        self._country = country
        self._view = View.of_size(width, height)
        self._sprites = make_sprites(rng)
        self._sky = Sky(rng)
        self._handlebar = Handlebar(width, height)

    def draw(self, pose: Pose) -> NDArray[np.uint8]:
        """Return the picture (height, width, 3) RGB."""
        canvas = np.empty(self._view.size, np.uint32)
        rotation = pose.rotation.astype(np.float32)
        rise = self._view.towards(rotation[2])
        self._sky.draw(canvas, self._view, rotation, rise)
        nearer_m = 0.0
        for texture in self._country.ground:
            self._draw_ground(canvas, texture, pose, rise, nearer_m)
            nearer_m = texture.reach_m
        self._draw_standing(canvas, pose)
        channels = canvas.view(np.uint8).reshape(*canvas.shape, 4)
        rgb = np.ascontiguousarray(channels[:, :, :3])
        self._handlebar.lay_over(rgb, pose.shake_px)
        return rgb

    def _draw_ground(
        self,
        canvas: Pixels,
        texture: GroundTexture,
        pose: Pose,
        rise: Floats32,
        nearer_m: float,
    ) -> None:
        """Draw what lies between `nearer_m` and the texture's reach."""
        height_m = float(pose.position_m[2])
        # a ray that rises by -h / d meets the ground at the distance d
        flattest = np.float32(-height_m / texture.reach_m)
        steepest = np.float32(-height_m / nearer_m if nearer_m else -np.inf)
        is_hit = (rise.min(axis=1) < flattest) & (rise.max(axis=1) > steepest)
        rows = np.flatnonzero(is_hit)
        if not len(rows):
            return
        band = slice(int(rows[0]), int(rows[-1]) + 1)
        fall = rise[band]
        distance = np.divide(height_m, np.maximum(-fall, 1e-4), dtype=np.float32)
        colours = self._look_up(texture, pose, band, distance)
        if not np.isfinite(texture.reach_m):
            colours = mixed(colours, HAZE, haze_share(distance))
        np.copyto(canvas[band], colours, where=(fall < flattest) & (fall >= steepest))

    def _look_up(
        self, texture: GroundTexture, pose: Pose, band: slice, distance: Floats32
    ) -> Pixels:
        """Return the colour of the ground that each ray of a band of rows meets."""
        rows, columns = texture.pixels.shape
        rotation = pose.rotation.astype(np.float32)
        view = View(self._view.x, self._view.z[band], self._view.focal_px)
        scale = distance * np.float32(texture.per_m)
        east = view.towards(rotation[0])
        east *= scale
        east += np.float32((pose.position_m[0] - texture.west_m) * texture.per_m)
        north = view.towards(rotation[1])
        north *= scale
        north += np.float32((pose.position_m[1] - texture.south_m) * texture.per_m)
        np.clip(east, 0, columns - 1, out=east)
        np.clip(north, 0, rows - 1, out=north)
        index = north.astype(np.int32)
        index *= columns
        index += east.astype(np.int32)
        return np.asarray(texture.pixels.reshape(-1)[index])

    def _draw_standing(self, canvas: Pixels, pose: Pose) -> None:
        """Draw the things beside the road, from far to near."""
        visible: list[tuple[Placement, Standing]] = []
        for thing in self._country.standing:
            place = self._place(thing, pose)
            if place is not None:
                visible.append((place, thing))
        for place, thing in sorted(visible, key=lambda pair: -pair[0].distance_m):
            draw_sprite(canvas, self._sprites[thing.kind], place)

    def _place(self, thing: Standing, pose: Pose) -> Placement | None:
        foot = np.array([thing.east_m, thing.north_m, 0.0]) - pose.position_m
        right, front, up = map(float, foot @ pose.rotation)
        if front < _NEAREST_M or abs(right) > 1.4 * front + 4.0:
            return None
        rows, columns = self._view.size
        per_m = self._view.focal_px / front
        earth_up = pose.rotation[2]  # in the sensor frame
        lean = float(earth_up[0] / np.hypot(earth_up[0], earth_up[2]))
        return Placement(
            foot_x=0.5 * columns + per_m * right,
            foot_y=0.5 * rows - per_m * up,
            height_px=per_m * thing.height_m,
            lean=lean,
            distance_m=front,
        )
