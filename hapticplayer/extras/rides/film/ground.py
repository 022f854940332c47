"""The ground of the rides: road, meadow, stairs, and what stands beside it."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hapticplayer.extras.rides.film.view import (
    CameraPose,
    CameraRays,
    Floats32,
    Pixels,
    colour,
)
from hapticplayer.extras.rides.scenes import Vehicle
from hapticplayer.model.arrays import Floats

Rgb = tuple[float, float, float]
Corner = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Surroundings:
    """A kind of way through the country."""

    road_half_m: float = 2.6  # half its width
    lane_aside_m: float = 1.1  # how far its middle lies to the left of where one goes
    verge_m: float = 0.55  # width of the strip beside it
    road_rgb: Rgb = (92.0, 93.0, 97.0)  # its colour
    verge_rgb: Rgb = (150.0, 136.0, 112.0)  # of the strip
    road_mottle: float = 7.0  # how uneven the colour of the way is
    is_marked: bool = True  # whether lines are painted on it
    posts_m: float = 8.0  # distance between two posts; 0 for none
    trees_m: float = 3.6  # distance between two trees on each side
    trees_aside_m: float = 3.2  # how far the nearest of them stand from the verge
    near_pixel_m: float = 0.02  # resolution of the nearest ground
    near_reach_m: float = 8.5  # up to where that is drawn


_PATH = Surroundings(
    road_half_m=1.6,
    lane_aside_m=0.0,
    verge_m=0.8,
    road_rgb=(150.0, 124.0, 92.0),
    verge_rgb=(122.0, 128.0, 76.0),
    road_mottle=17.0,
    is_marked=False,
    posts_m=3.0,
    trees_m=4.5,
    trees_aside_m=4.0,
    near_pixel_m=0.025,
    near_reach_m=10.0,
)

SURROUNDINGS: dict[Vehicle, Surroundings] = {
    "bicycle": Surroundings(),
    "horse": _PATH,
    "car": Surroundings(
        road_half_m=3.5,
        lane_aside_m=1.75,
        trees_m=5.5,
        trees_aside_m=4.5,
        posts_m=16.0,
        near_pixel_m=0.03,
        near_reach_m=12.0,
    ),
    "foot": Surroundings(
        road_half_m=1.4,
        lane_aside_m=0.0,
        road_rgb=(158.0, 152.0, 140.0),
        is_marked=False,
        posts_m=0.0,
        trees_aside_m=2.0,
    ),
    "tripod": Surroundings(
        road_half_m=0.9,
        lane_aside_m=-2.2,
        road_rgb=(150.0, 130.0, 100.0),
        road_mottle=14.0,
        is_marked=False,
        posts_m=0.0,
        trees_m=3.0,
    ),
}
"""By vehicle."""

SHAKES_PX: dict[Vehicle, float] = {
    "bicycle": 1.2,
    "horse": 0.5,
    "car": 0.12,
    "foot": 0.0,
    "tripod": 0.0,
}
"""How far the foreground moves, in 540 lines, for each m/s2 upwards: arms give way."""


Paint = Callable[[Floats32, Floats32, float], Pixels]
"""Colours (rows, columns) of places east (columns,) and north (rows,), and pixel size."""

SIZE = 2048
_BLOCK = 128
_BLOCKS = SIZE // _BLOCK
_CORNER = 1.4
"""How much farther the ground is at the frame's edges than ahead."""

_NOWHERE = np.iinfo(np.int64).min


@dataclass(slots=True, eq=False)
class GroundTexture:
    """A window on the ground that wraps around and is filled block by block.

    It is drawn up to `reach_m` ahead; the place (row, column) lies at the remainders of
    (SIZE, SIZE).
    """

    paint: Paint
    pixel_m: float
    reach_m: float
    pixels: Pixels = field(default_factory=lambda: np.zeros((SIZE, SIZE), np.uint32))
    _held: NDArray[np.int64] = field(
        default_factory=lambda: np.full((_BLOCKS, _BLOCKS, 2), _NOWHERE)
    )

    def prepare(
        self,
        position_m: NDArray[np.float64],
        ahead: NDArray[np.float64],
        margin_m: float = 0.0,
    ) -> None:
        """Paint what can be seen from a place: the half disc before the camera.

        `ahead` (2,) is the unit vector to where it looks, `margin_m` how much farther,
        for places near by.
        """
        block_m = _BLOCK * self.pixel_m
        reach_m = _CORNER * self.reach_m + margin_m + block_m
        first = np.floor((position_m - reach_m) / block_m).astype(np.int64)
        last = np.floor((position_m + reach_m) / block_m).astype(np.int64)
        east, north = np.meshgrid(
            *(np.arange(a, b + 1) for a, b in zip(first, last, strict=True))
        )
        away = np.stack([east, north], axis=-1) * block_m + 0.5 * block_m - position_m
        wanted = np.hypot(away[..., 0], away[..., 1]) < reach_m
        wanted &= away @ ahead > -block_m - margin_m
        held = self._held[north % _BLOCKS, east % _BLOCKS]
        wanted &= (held[..., 0] != north) | (held[..., 1] != east)
        for row, column in zip(north[wanted], east[wanted], strict=True):
            self._fill(int(row), int(column))

    def _fill(self, row: int, column: int) -> None:
        steps = np.arange(_BLOCK, dtype=np.float64) + 0.5
        north = ((row * _BLOCK + steps) * self.pixel_m).astype(np.float32)
        east = ((column * _BLOCK + steps) * self.pixel_m).astype(np.float32)
        at_row, at_column = row % _BLOCKS, column % _BLOCKS
        rows = slice(at_row * _BLOCK, (at_row + 1) * _BLOCK)
        columns = slice(at_column * _BLOCK, (at_column + 1) * _BLOCK)
        self.pixels[rows, columns] = self.paint(east, north, self.pixel_m)
        self._held[at_row, at_column] = (row, column)


RISER_M = 0.165
_HALF_M = 1.5
_WALL_M, _WALL_HEIGHT_M = 0.35, 0.25
_LANDING_M = 14.0
_NEAREST_M = 0.12


@dataclass(frozen=True, slots=True, eq=False)
class Face:
    """A flat convex face; its corners (K, 3), earth, in order around it."""

    corners_m: Floats
    tint: np.uint32


def stair_faces(risers_m: tuple[float, ...], west_m: float) -> tuple[Face, ...]:
    """Return the faces of stairs from far to near, given the norths of the risers."""
    faces: list[Face] = []
    ends_m = (*risers_m[1:], risers_m[-1] + _LANDING_M)
    left, right = west_m - _HALF_M, west_m + _HALF_M
    for number, (near_m, far_m) in enumerate(zip(risers_m, ends_m, strict=True)):
        low_m, high_m = number * RISER_M, (number + 1) * RISER_M
        top_m = high_m + _WALL_HEIGHT_M
        uneven = 6.0 * ((number * 7) % 5 - 2)
        steps = [
            _stone(
                (left, near_m, high_m), (right, far_m, high_m), 196.0 + 0.5 * uneven
            ),
            _stone((left, near_m, low_m), (right, near_m, high_m), 146.0 + uneven),
        ]
        # inner face, front and top of the low walls beside a step
        for inner, outer, level in (
            (left, left - _WALL_M, 134.0),
            (right, right + _WALL_M, 118.0),
        ):
            steps += [
                _stone((inner, near_m, high_m), (inner, far_m, top_m), level),
                _stone((inner, near_m, 0.0), (outer, near_m, top_m), 128.0),
                _stone((inner, near_m, top_m), (outer, far_m, top_m), 176.0),
            ]
        faces = steps + faces
    return tuple(faces)


def _stone(first: Corner, last: Corner, level: float) -> Face:
    """Return the rectangle between corners that differ in two axes only."""
    corners = np.array([first, first, last, last])
    axis = np.flatnonzero(corners[0] != corners[2])[0]
    corners[[1, 3], axis] = corners[[3, 1], axis]
    return Face(corners, colour(level, 0.97 * level, 0.90 * level))


def draw_face(canvas: Pixels, view: CameraRays, pose: CameraPose, face: Face) -> None:
    """Fill a face as the camera sees it; what lies behind the camera is cut off."""
    corners = _cut((face.corners_m - pose.position_m) @ pose.rotation)
    if len(corners) < 3:
        return
    rows, columns = canvas.shape
    x = 0.5 * columns + view.focal_px * corners[:, 0] / corners[:, 1]
    y = 0.5 * rows - view.focal_px * corners[:, 2] / corners[:, 1]
    left, right = max(0, int(x.min())), min(columns, int(x.max()) + 2)
    top, bottom = max(0, int(y.min())), min(rows, int(y.max()) + 2)
    if left >= right or top >= bottom:
        return
    at_x = np.arange(left, right, dtype=np.float32) + 0.5
    at_y = np.arange(top, bottom, dtype=np.float32) + 0.5
    turn = np.sign(_area(x, y))
    inside = np.ones((bottom - top, right - left), np.bool_)
    for a in range(len(x)):
        b = (a + 1) % len(x)
        dx, dy = turn * (x[b] - x[a]), turn * (y[b] - y[a])
        inside &= np.subtract.outer(dx * (at_y - y[a]), dy * (at_x - x[a])) >= 0.0
    np.copyto(canvas[top:bottom, left:right], face.tint, where=inside)


def _area(x: Floats, y: Floats) -> float:
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def _cut(corners: Floats) -> Floats:
    """Return the part of a polygon (right, front, up) that lies before the camera."""
    kept = []
    for here, there in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        is_here, is_there = here[1] > _NEAREST_M, there[1] > _NEAREST_M
        if is_here:
            kept.append(here)
        if is_here != is_there:
            share = (_NEAREST_M - here[1]) / (there[1] - here[1])
            kept.append(here + share * (there - here))
    return np.array(kept).reshape(-1, 3)
