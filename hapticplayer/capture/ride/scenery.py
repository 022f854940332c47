"""The country that the simulator's camera rides through, as textures and sprites.

The ground is painted once, from above, at three resolutions; a picture then only
looks its colours up.
"""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter

from hapticplayer.capture.ride.colours import Floats32, Pixels, packed
from hapticplayer.capture.ride.roadside import POST, ROAD_HALF_M, Route, plant
from hapticplayer.capture.scenes import Scene

Rgb = Floats32


@dataclass(frozen=True, slots=True, eq=False)
class GroundTexture:
    """A piece of ground seen from above.

    Attributes:
        pixels: (rows to the north, columns to the east).
        west_m: earth x of the first column.
        south_m: earth y of the first row.
        per_m: pixels per metre.
        reach_m: up to which distance it is fine enough.
    """

    pixels: Pixels
    west_m: float
    south_m: float
    per_m: float
    reach_m: float


class Country:
    """Ground and things along a scene's route."""

    def __init__(self, scene: Scene, rng: np.random.Generator) -> None:
        self._route = Route(scene)
        self.standing = plant(self._route, rng)
        self._noise = gaussian_filter(
            rng.standard_normal((256, 256)).astype(np.float32), 1.5, mode="wrap"
        )
        self._noise /= self._noise.std()
        self._grain = rng.standard_normal((512, 512)).astype(np.float32)
        self.ground = tuple(
            self._paint(margin_m, pixel_m, reach_m)
            for margin_m, pixel_m, reach_m in (
                (9.0, 0.018, 8.5),
                (45.0, 0.08, 34.0),
                (260.0, 0.40, np.inf),
            )
        )

    def _paint(self, margin_m: float, pixel_m: float, reach_m: float) -> GroundTexture:
        low = self._route.ridden_m.min(axis=0) - margin_m
        high = self._route.ridden_m.max(axis=0) + margin_m
        east = np.arange(low[0], high[0], pixel_m, dtype=np.float32)
        north = np.arange(low[1], high[1], pixel_m, dtype=np.float32)
        pixels = np.empty((len(north), len(east)), np.uint32)
        for first in range(0, len(north), 256):  # in bands: less memory, more cache
            rows = slice(first, first + 256)
            pixels[rows] = packed(self._colours(east, north[rows], pixel_m))
        return GroundTexture(
            pixels, float(low[0]), float(low[1]), 1.0 / pixel_m, reach_m
        )

    def _colours(self, east: Floats32, north: Floats32, pixel_m: float) -> Rgb:
        """Return (rows, columns, 3) RGB of the ground at a grid of places."""
        along, aside = self._route.coordinates(east, north)
        broad = self._wrapped(self._noise, east, north, 0.9)
        fine = self._wrapped(self._grain, east, north, pixel_m * 1.01)
        softness = max(0.04, 0.8 * pixel_m)
        rgb = _meadow(broad, fine)
        for half_m, colour, mottle in (
            (ROAD_HALF_M + 0.55, (150.0, 136.0, 112.0), 13.0),
            (ROAD_HALF_M, (92.0, 93.0, 97.0), 7.0),
        ):
            cover = _inside(np.abs(aside), half_m, softness)
            _blend(
                rgb, np.add.outer(mottle * fine, np.array(colour, np.float32)), cover
            )
        for start_m, end_m in self._route.paved_m:
            cover = _inside(np.abs(along - 0.5 * (start_m + end_m)),
                            0.5 * (end_m - start_m), softness)  # fmt: skip
            cover *= _inside(np.abs(aside), ROAD_HALF_M, softness)
            _blend(rgb, _paving(along, aside, fine), cover)
            for edge_m in (start_m, end_m):
                stone = _inside(np.abs(along - edge_m), 0.11, softness)
                stone *= _inside(np.abs(aside), ROAD_HALF_M, softness)
                _blend(
                    rgb, np.add.outer(4.0 * fine, _colour(232.0, 228.0, 216.0)), stone
                )
        _blend(rgb, _colour(236.0, 234.0, 226.0), 0.92 * _marks(along, aside, softness))
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
        for thing in self.standing:
            if thing.kind == POST:
                continue
            reach_m = 0.34 * thing.height_m
            x = (east - thing.east_m - 0.5 * reach_m) / reach_m
            y = (north - thing.north_m - 0.2 * reach_m) / (0.6 * reach_m)
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


def _marks(along: Rgb, aside: Rgb, softness: float) -> Rgb:
    """Return the cover of the dashed middle line and the two edge lines."""
    dashes = _inside(np.abs((along + 500.0) % 4.0 - 1.0), 0.9, softness)
    middle = _inside(np.abs(aside), 0.06, softness) * dashes
    edges = _inside(np.abs(np.abs(aside) - (ROAD_HALF_M - 0.22)), 0.06, softness)
    return np.asarray(np.maximum(middle, edges))


def _inside(distance: Rgb, half: float, softness: float) -> Rgb:
    """Return 1 inside `half`, 0 outside, with a soft edge against jagged lines."""
    cover = np.clip((half - distance) / softness + 0.5, 0.0, 1.0)
    return np.asarray(cover, np.float32)


def _blend(rgb: Rgb, colour: Rgb, cover: Rgb) -> None:
    rgb += (colour - rgb) * cover[..., None]


def _colour(red: float, green: float, blue: float) -> Rgb:
    return np.array((red, green, blue), np.float32)
