"""Where the simulator's road runs and what stands beside it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates
from scipy.spatial import cKDTree

from hapticplayer.capture.scenes import Scene
from hapticplayer.model.arrays import Floats

Grid = NDArray[np.float32]

LANE_ASIDE_M = 1.1
"""The rider keeps right: the road's middle lies this far to the left."""

ROAD_HALF_M = 2.6
_COARSE_M = 0.5
_ROUTE_STEP_M = 0.25
_BEYOND_M = 130.0
"""The road goes straight on before the start and after the stop."""

POST = 0
"""Kind of the white marker posts; the others are trees."""

TREE_KINDS = (1, 2, 3)


@dataclass(frozen=True, slots=True)
class Standing:
    """A thing beside the road, drawn as an upright picture.

    Attributes:
        east_m: earth x of its foot.
        north_m: earth y.
        height_m: of its top.
        kind: index into the sprites.
    """

    east_m: float
    north_m: float
    height_m: float
    kind: int


class Route:
    """Places along and aside of the road's middle."""

    def __init__(self, scene: Scene) -> None:
        self.ridden_m = scene.route_m[:: max(1, len(scene.route_m) // 400)]
        travelled_m = _lengths(scene.route_m)
        wanted_m = np.arange(0.0, travelled_m[-1], _ROUTE_STEP_M)
        ridden = np.stack(
            [np.interp(wanted_m, travelled_m, axis) for axis in scene.route_m.T], axis=1
        )
        first, last = ridden[0] - ridden[1], ridden[-1] - ridden[-2]
        reach = np.arange(1, round(_BEYOND_M / _ROUTE_STEP_M))[:, None]
        points = np.concatenate(
            [ridden[0] + reach[::-1] * first, ridden, ridden[-1] + reach * last]
        )
        heading = np.gradient(points, axis=0)
        heading /= np.linalg.norm(heading, axis=1, keepdims=True)
        self.left = np.stack([-heading[:, 1], heading[:, 0]], axis=1)
        self.middle_m = points + LANE_ASIDE_M * self.left
        self.along_m = (np.arange(len(points)) - len(reach)) * _ROUTE_STEP_M
        self._heading = heading
        self._tree = cKDTree(self.middle_m)
        hits_m = [
            float(np.interp(b.time_s, scene.route_time_s, travelled_m)) + 0.45
            for b in scene.bumps
        ]
        self.paved_m = list(zip(hits_m[::2], hits_m[1::2], strict=False))

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
        where = np.meshgrid(
            (north - y[0]) / coarse_m, (east - x[0]) / coarse_m, indexing="ij"
        )
        shape = grid.shape[:2]
        along_grid, aside_grid = (
            map_coordinates(
                field.reshape(shape).astype(np.float32), where, order=1, mode="nearest"
            )
            for field in (along, aside)
        )
        return along_grid, aside_grid


def plant(route: Route, rng: np.random.Generator) -> tuple[Standing, ...]:
    """Return marker posts every 8 m on both sides, and trees behind them."""
    things = []
    for along_m in np.arange(-4.0, 110.0, 8.0):
        for side in (-1.0, 1.0):
            aside_m = side * (ROAD_HALF_M + 0.75)
            things.append(_standing(route, along_m, aside_m, 1.05, POST))
    for along_m in np.arange(2.0, 125.0, 3.6):
        for side in (-1.0, 1.0):
            aside_m = side * (ROAD_HALF_M + 3.2 + rng.gamma(1.6, 3.0))
            kind = int(rng.choice(TREE_KINDS))
            place_m = along_m + rng.uniform(-1.6, 1.6)
            height_m = float(rng.uniform(3.2, 7.5))
            things.append(_standing(route, place_m, aside_m, height_m, kind))
    return tuple(things)


def _standing(
    route: Route, along_m: float, aside_m: float, height_m: float, kind: int
) -> Standing:
    row = int(np.searchsorted(route.along_m, along_m).clip(0, len(route.along_m) - 1))
    east_m, north_m = route.middle_m[row] + aside_m * route.left[row]
    return Standing(float(east_m), float(north_m), height_m, kind)


def _lengths(points: Floats) -> Floats:
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])
