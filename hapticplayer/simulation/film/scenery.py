"""The country that the simulator's camera goes through, as textures and sprites.

The ground is painted from above, at three resolutions; a picture then only looks its
colours up.
"""

import numpy as np
from scipy.ndimage import gaussian_filter

from hapticplayer.simulation.film.colours import Floats32, Pixels, packed
from hapticplayer.simulation.film.ground import GroundTexture
from hapticplayer.simulation.film.roadside import POST, Route, plant
from hapticplayer.simulation.film.stairs import stair_faces
from hapticplayer.simulation.film.surroundings import SURROUNDINGS
from hapticplayer.simulation.film.view import Pose
from hapticplayer.simulation.rides.scenes import Scene

Rgb = Floats32

_FARTHEST_M = 220.0
"""Beyond it there is nothing but haze."""


class Country:
    """Ground and things along a scene's route."""

    def __init__(self, scene: Scene, rng: np.random.Generator) -> None:
        self.vehicle = scene.vehicle
        self._look = SURROUNDINGS[scene.vehicle]
        self._route = Route(scene, self._look)
        start_m = scene.route_m[0]
        risers_m = tuple(float(start_m[1]) + along_m for along_m in scene.stairs_m)
        self.faces = stair_faces(risers_m, float(start_m[0])) if risers_m else ()
        self.standing = plant(self._route, self._look, rng)
        self._noise = gaussian_filter(
            rng.standard_normal((256, 256)).astype(np.float32), 1.5, mode="wrap"
        )
        self._noise /= self._noise.std()
        self._grain = rng.standard_normal((512, 512)).astype(np.float32)
        self.ground = tuple(
            GroundTexture(self._painted, pixel_m, reach_m)
            for pixel_m, reach_m in (
                (self._look.near_pixel_m, self._look.near_reach_m),
                (0.08, 34.0),
                (0.40, _FARTHEST_M),
            )
        )

    def prepare(self, poses: list[Pose], margin_m: float = 0.0) -> None:
        """Paint the ground that can be seen from places at most `margin_m` away."""
        for pose in poses:
            ahead = pose.rotation[:2, 1] / np.hypot(*pose.rotation[:2, 1])
            for texture in self.ground:
                texture.prepare(pose.position_m[:2], ahead, margin_m)

    def _painted(self, east: Floats32, north: Floats32, pixel_m: float) -> Pixels:
        return packed(self._colours(east, north, pixel_m))

    def _colours(self, east: Floats32, north: Floats32, pixel_m: float) -> Rgb:
        """Return (rows, columns, 3) RGB of the ground at a grid of places."""
        along, aside = self._route.coordinates(east, north)
        broad = self._wrapped(self._noise, east, north, 0.9)
        fine = self._wrapped(self._grain, east, north, pixel_m * 1.01)
        softness = max(0.04, 0.8 * pixel_m)
        rgb = _meadow(broad, fine)
        look = self._look
        road_half_m = look.road_half_m
        for half_m, colour, mottle in (
            (road_half_m + look.verge_m, look.verge_rgb, 13.0),
            (road_half_m, look.road_rgb, look.road_mottle),
        ):
            cover = _inside(np.abs(aside), half_m, softness)
            _blend(
                rgb, np.add.outer(mottle * fine, np.array(colour, np.float32)), cover
            )
        for start_m, end_m in self._route.paved_m:
            cover = _inside(np.abs(along - 0.5 * (start_m + end_m)),
                            0.5 * (end_m - start_m), softness)  # fmt: skip
            cover *= _inside(np.abs(aside), road_half_m, softness)
            _blend(rgb, _paving(along, aside, fine), cover)
            for edge_m in (start_m, end_m):
                stone = _inside(np.abs(along - edge_m), 0.11, softness)
                stone *= _inside(np.abs(aside), road_half_m, softness)
                _blend(
                    rgb, np.add.outer(4.0 * fine, _colour(232.0, 228.0, 216.0)), stone
                )
        if look.is_marked:
            marks = 0.92 * _marks(along, aside, road_half_m, softness)
            _blend(rgb, _colour(236.0, 234.0, 226.0), marks)
        self._shade(rgb, east, north)
        return rgb

    def _wrapped(
        self,
        tile: Rgb,
        east: Floats32,
        north: Floats32,
        cell_m: float,
    ) -> Rgb:
        columns = (east / cell_m).astype(np.int64) % tile.shape[1]
        rows = (north / cell_m).astype(np.int64) % tile.shape[0]
        return np.asarray(tile[rows[:, None], columns])

    def _shade(self, rgb: Rgb, east: Floats32, north: Floats32) -> None:
        """Lay the shadow of each tree on the ground, away from a low sun."""
        things = self.standing
        near = (things.kind != POST) & (things.height_m > 0.0)
        for axis, places in ((0, east), (1, north)):
            foot_m = things.foot_m[:, axis]
            near &= foot_m > places[0] - things.height_m
            near &= foot_m < places[-1] + things.height_m
        for number in np.flatnonzero(near):
            east_m, north_m = things.foot_m[number, :2].astype(np.float32)
            reach_m = np.float32(0.34 * things.height_m[number])
            x = (east - east_m - 0.5 * reach_m) / reach_m
            y = (north - north_m - 0.2 * reach_m) / (0.6 * reach_m)
            columns = np.flatnonzero(np.abs(x) < 1.3)
            rows = np.flatnonzero(np.abs(y) < 1.3)
            if not (len(columns) and len(rows)):
                continue
            part = np.ix_(rows, columns)
            radius = np.add.outer(y[rows] ** 2, x[columns] ** 2)
            rgb[part] *= (1.0 - 0.45 * _inside(radius, 1.0, 0.35))[..., None]


def _meadow(broad: Rgb, fine: Rgb) -> Rgb:
    green = np.add.outer(0.0 * fine, _colour(104.0, 132.0, 62.0))
    green += np.multiply.outer(broad, _colour(13.0, 9.0, 3.0))
    green += np.multiply.outer(fine, _colour(8.0, 9.0, 6.0))
    return np.asarray(green)


def _paving(along: Rgb, aside: Rgb, fine: Rgb) -> Rgb:
    """Return the reddish stones of the raised crossing."""
    stones = (np.floor(along / 0.2) + np.floor(aside / 0.2)) % 2.0
    return np.asarray(
        np.add.outer(9.0 * stones + 6.0 * fine, _colour(152.0, 108.0, 88.0))
    )


def _marks(along: Rgb, aside: Rgb, road_half_m: float, softness: float) -> Rgb:
    """Return the cover of the dashed middle line and the two edge lines."""
    dashes = _inside(np.abs((along + 500.0) % 4.0 - 1.0), 0.9, softness)
    middle = _inside(np.abs(aside), 0.06, softness) * dashes
    edges = _inside(np.abs(np.abs(aside) - (road_half_m - 0.22)), 0.06, softness)
    return np.asarray(np.maximum(middle, edges))


def _inside(distance: Rgb, half: float, softness: float) -> Rgb:
    """Return 1 inside `half`, 0 outside, with a soft edge against jagged lines."""
    cover = np.clip((half - distance) / softness + 0.5, 0.0, 1.0)
    return np.asarray(cover, np.float32)


def _blend(rgb: Rgb, colour: Rgb, cover: Rgb) -> None:
    rgb += (colour - rgb) * cover[..., None]


def _colour(red: float, green: float, blue: float) -> Rgb:
    return np.array((red, green, blue), np.float32)
