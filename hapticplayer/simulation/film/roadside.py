"""Where the simulator's road runs and what stands beside it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from hapticplayer.model.arrays import Floats
from hapticplayer.simulation.film.surroundings import Surroundings
from hapticplayer.simulation.rides.scenes import Scene

Grid = NDArray[np.float32]

_COARSE_M = 0.5
_ROUTE_STEP_M = 0.25
_SAME_ROAD_M, _LAP_M = 0.6, 8.0
_BEYOND_M = 130.0
"""The road goes straight on before the start and after the stop."""

POST = 0
"""Kind of the white marker posts; the others are trees."""

TREE_KINDS = (1, 2, 3)


@dataclass(frozen=True, slots=True, eq=False)
class Standing:
    """The things beside the road, drawn as upright pictures.

    Attributes:
        foot_m: (N, 3) earth, on the ground.
        height_m: (N,) of their tops.
        kind: (N,) indices into the sprites.
    """

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
        if self.length_m < 1.0:  # nobody moves: a way that leads ahead
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


def plant(route: Route, look: Surroundings, rng: np.random.Generator) -> Standing:
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
    return Standing(foot[clear], height[clear], kinds[clear].astype(np.intp))


def _lengths(points: Floats) -> Floats:
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])
