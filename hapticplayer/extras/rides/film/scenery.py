"""What stands along the way, and how the whole scene is laid out."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree

from hapticplayer.extras.rides.film.ground import (
    SURROUNDINGS,
    GroundTexture,
    Surroundings,
    stair_faces,
)
from hapticplayer.extras.rides.film.view import (
    CameraPose,
    Floats32,
    Pixels,
    packed,
    rgb_of,
)
from hapticplayer.extras.rides.scenes import Scene
from hapticplayer.model.arrays import Floats

Grid = NDArray[np.float32]

_COARSE_M = 0.5
_ROUTE_STEP_M = 0.25
_SAME_ROAD_M, _LAP_M = 0.6, 8.0
_STONE_M = 0.22  # as the wheels meet them
_BEYOND_M = 130.0
"""The road goes straight on before the start and after the stop."""

POST = 0
"""Kind of the white marker posts; the others are trees."""

TREE_KINDS = (1, 2, 3)


@dataclass(frozen=True, slots=True, eq=False)
class RoadsideSprites:
    """The N things beside the road, drawn as upright sprites of the kinds given."""

    foot_m: Floats
    height_m: Floats
    kind: NDArray[np.intp]


class Route:
    """Places along and aside of the road's middle."""

    def __init__(self, scene: Scene, look: Surroundings) -> None:
        travelled_m = _lengths(scene.route_m)
        self.length_m = float(travelled_m[-1])
        wanted_m = np.arange(0.0, max(self.length_m, 1.0), _ROUTE_STEP_M)
        ridden = np.stack(
            [np.interp(wanted_m, travelled_m, axis) for axis in scene.route_m.T], axis=1
        )
        if self.length_m < 1.0:  # no motion: a straight way ahead
            ridden = ridden[:1] + np.outer(wanted_m, (0.0, 1.0))
        first, last = ridden[0] - ridden[1], ridden[-1] - ridden[-2]
        reach = np.arange(1, round(_BEYOND_M / _ROUTE_STEP_M))[:, None]
        points = np.concatenate(
            [ridden[0] + reach[::-1] * first, ridden, ridden[-1] + reach * last]
        )
        heading = np.gradient(points, axis=0)
        heading /= np.linalg.norm(heading, axis=1, keepdims=True)
        self.left = np.stack([-heading[:, 1], heading[:, 0]], axis=1)
        self.middle_m = points + look.lane_aside_m * self.left
        self.along_m = (np.arange(len(points)) - len(reach)) * _ROUTE_STEP_M
        self._heading = heading
        self._keep_first_laps()
        self._tree = cKDTree(self.middle_m)
        hits_m = [
            float(np.interp(b.time_s, scene.route_time_s, travelled_m)) + 0.45
            for b in scene.bumps
        ]
        self.paved_m = list(zip(hits_m[::2], hits_m[1::2], strict=False))
        self.cobbles_m: list[float] = []
        if scene.cobbles_s is not None:
            at_m = np.interp(scene.cobbles_s, scene.route_time_s, travelled_m)
            self.cobbles_m = (at_m + 0.45).tolist()

    def _keep_first_laps(self) -> None:
        """Forget where the road runs over itself again: its lines would not meet."""
        near = cKDTree(self.middle_m).query_ball_point(self.middle_m, _SAME_ROAD_M)
        lap = round(_LAP_M / _ROUTE_STEP_M)
        first = np.array([min(found) > at - lap for at, found in enumerate(near)])
        self.middle_m, self._heading = self.middle_m[first], self._heading[first]
        self.left, self.along_m = self.left[first], self.along_m[first]

    def away_m(self, places_m: Floats) -> Floats:
        """Return how far places (N, 2) are from the road's middle."""
        return np.asarray(self._tree.query(places_m)[0])

    def coordinates(self, east: Grid, north: Grid) -> tuple[Grid, Grid]:
        """Return metres along the road and to the left of its middle, on a grid.

        Exact on a coarse grid and interpolated between.
        """
        coarse_m = max(_COARSE_M, 4.0 * float(east[1] - east[0]))
        x = np.arange(east[0] - coarse_m, east[-1] + 2 * coarse_m, coarse_m)
        y = np.arange(north[0] - coarse_m, north[-1] + 2 * coarse_m, coarse_m)
        grid = np.stack(np.meshgrid(x, y), axis=-1)
        _, nearest = self._tree.query(grid.reshape(-1, 2))
        offset = grid.reshape(-1, 2) - self.middle_m[nearest]
        along = self.along_m[nearest] + np.sum(offset * self._heading[nearest], axis=1)
        aside = np.sum(offset * self.left[nearest], axis=1)
        at = (north - y[0]) / coarse_m, (east - x[0]) / coarse_m
        along_grid, aside_grid = (
            _between(field.reshape(grid.shape[:2]), *at) for field in (along, aside)
        )
        return along_grid, aside_grid


def _between(field: Floats, rows: Grid, columns: Grid) -> Grid:
    """Return a field at fractional rows and columns, which make a grid: bilinear."""
    for at in (rows, columns):  # each turn takes the first axis and leaves it last
        first = np.minimum(at.astype(np.intp), len(field) - 2)
        share = (at - first)[:, None]
        field = ((1.0 - share) * field[first] + share * field[first + 1]).T
    return np.ascontiguousarray(field, dtype=np.float32)


def plant(
    route: Route, look: Surroundings, rng: np.random.Generator
) -> RoadsideSprites:
    """Return posts on both sides, and trees behind them; nothing on the road."""
    aside_m = look.road_half_m + look.verge_m
    things: list[tuple[float, float, float, int]] = []
    if look.posts_m:
        for along_m in np.arange(-4.0, route.length_m + 80.0, look.posts_m):
            things += [(along_m, s * (aside_m + 0.2), 1.05, POST) for s in (-1, 1)]
    for along_m in np.arange(2.0, route.length_m + 95.0, look.trees_m):
        for side in (-1.0, 1.0):
            away_m = side * (aside_m + look.trees_aside_m + rng.gamma(1.6, 3.0) - 0.55)
            kind = int(rng.choice(TREE_KINDS))
            place_m = along_m + rng.uniform(-1.6, 1.6)
            things.append((place_m, away_m, float(rng.uniform(3.2, 7.5)), kind))
    along, aside, height, kinds = np.array(things).T
    rows = np.searchsorted(route.along_m, along).clip(0, len(route.along_m) - 1)
    foot = route.middle_m[rows] + aside[:, None] * route.left[rows]
    clear = route.away_m(foot) > aside_m
    foot = np.column_stack([foot, np.zeros(len(foot))])
    return RoadsideSprites(foot[clear], height[clear], kinds[clear].astype(np.intp))


def _lengths(points: Floats) -> Floats:
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


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

    def prepare(self, poses: list[CameraPose], margin_m: float = 0.0) -> None:
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
                    rgb, np.add.outer(4.0 * fine, rgb_of(232.0, 228.0, 216.0)), stone
                )
        marks = 0.92 * _marks(along, aside, road_half_m, softness) * look.is_marked
        if self._route.cobbles_m:
            start_m, end_m = self._route.cobbles_m
            cover = _inside(np.abs(along - 0.5 * (start_m + end_m)),
                            0.5 * (end_m - start_m), softness)  # fmt: skip
            marks *= 1.0 - cover
            cover *= _inside(np.abs(aside), road_half_m, softness)
            _blend(rgb, _cobbles(along, aside, fine, pixel_m), cover)
        if look.is_marked:
            _blend(rgb, rgb_of(236.0, 234.0, 226.0), marks)
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
    green = np.add.outer(0.0 * fine, rgb_of(104.0, 132.0, 62.0))
    green += np.multiply.outer(broad, rgb_of(13.0, 9.0, 3.0))
    green += np.multiply.outer(fine, rgb_of(8.0, 9.0, 6.0))
    return np.asarray(green)


def _paving(along: Rgb, aside: Rgb, fine: Rgb) -> Rgb:
    """Return the reddish stones of the raised crossing."""
    stones = (np.floor(along / 0.2) + np.floor(aside / 0.2)) % 2.0
    return np.asarray(
        np.add.outer(9.0 * stones + 6.0 * fine, rgb_of(152.0, 108.0, 88.0))
    )


def _cobbles(along: Rgb, aside: Rgb, fine: Rgb, pixel_m: float) -> Rgb:
    """Return granite stones, each of its own grey, in rows with dark joints."""
    row = np.floor(along / _STONE_M)
    across = aside / _STONE_M + 0.5 * (row % 2.0)
    column = np.floor(across)
    # a number for each stone that looks like chance
    mixed = row.astype(np.int64) * 73856093 ^ column.astype(np.int64) * 19349663
    level = 0.18 * ((mixed >> 5) & 255).astype(np.float32) - 23.0
    near = np.minimum(np.abs(along / _STONE_M - row - 0.5), 0.5)
    near = np.maximum(near, np.abs(across - column - 0.5))
    softness = max(0.06, 0.8 * pixel_m / _STONE_M)
    stone = _inside(near, 0.42, softness)[..., None]
    top = np.add.outer(level + 5.0 * fine, rgb_of(142.0, 130.0, 114.0))
    return np.asarray(top * stone + rgb_of(58.0, 52.0, 46.0) * (1.0 - stone))


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
