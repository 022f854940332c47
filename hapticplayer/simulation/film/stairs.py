"""A flight of stone stairs that leads north, drawn as flat faces."""

from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.simulation.film.colours import Pixels, colour
from hapticplayer.simulation.film.view import Pose, View

RISER_M = 0.165
_HALF_M = 1.5
_WALL_M, _WALL_HEIGHT_M = 0.35, 0.25
_LANDING_M = 14.0
_NEAREST_M = 0.12


@dataclass(frozen=True, slots=True, eq=False)
class Face:
    """A flat convex face.

    Attributes:
        corners_m: (K, 3) earth, in order around it.
        tint: packed colour.
    """

    corners_m: Floats
    tint: np.uint32


def stair_faces(risers_m: tuple[float, ...], west_m: float) -> tuple[Face, ...]:
    """Return the faces of stairs from far to near.

    Args:
        risers_m: north of each riser.
        west_m: earth x of the middle.
    """
    faces: list[Face] = []
    ends_m = (*risers_m[1:], risers_m[-1] + _LANDING_M)
    for number, (north_m, end_m) in enumerate(zip(risers_m, ends_m, strict=True)):
        low_m, high_m = number * RISER_M, (number + 1) * RISER_M
        uneven = 6.0 * ((number * 7) % 5 - 2)
        steps = [
            Face(_level(west_m, north_m, end_m, high_m), _stone(196.0 + 0.5 * uneven)),
            Face(_upright(west_m, north_m, low_m, high_m), _stone(146.0 + uneven)),
        ]
        for side in (-1.0, 1.0):
            steps += _walls(west_m, side, (north_m, end_m), high_m)
        faces = steps + faces
    return tuple(faces)


def _stone(level: float) -> np.uint32:
    return colour(level, 0.97 * level, 0.90 * level)


def _upright(west_m: float, north_m: float, low_m: float, high_m: float) -> Floats:
    left, right = west_m - _HALF_M, west_m + _HALF_M
    return np.array([(left, north_m, low_m), (right, north_m, low_m),
                     (right, north_m, high_m), (left, north_m, high_m)])  # fmt: skip


def _level(west_m: float, north_m: float, end_m: float, height_m: float) -> Floats:
    left, right = west_m - _HALF_M, west_m + _HALF_M
    return np.array([(left, north_m, height_m), (right, north_m, height_m),
                     (right, end_m, height_m), (left, end_m, height_m)])  # fmt: skip


def _walls(
    west_m: float, side: float, span_m: tuple[float, float], height_m: float
) -> list[Face]:
    """Return the inner face and the top of the low wall beside a step."""
    inner, outer = west_m + side * _HALF_M, west_m + side * (_HALF_M + _WALL_M)
    near, far = span_m
    top_m = height_m + _WALL_HEIGHT_M
    face = [
        (inner, near, height_m),
        (inner, far, height_m),
        (inner, far, top_m),
        (inner, near, top_m),
    ]
    top = [
        (inner, near, top_m),
        (inner, far, top_m),
        (outer, far, top_m),
        (outer, near, top_m),
    ]
    front = [
        (inner, near, 0.0),
        (outer, near, 0.0),
        (outer, near, top_m),
        (inner, near, top_m),
    ]
    return [
        Face(np.array(face), _stone(118.0 if side > 0 else 134.0)),
        Face(np.array(front), _stone(128.0)),
        Face(np.array(top), _stone(176.0)),
    ]


def draw_face(canvas: Pixels, view: View, pose: Pose, face: Face) -> None:
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
