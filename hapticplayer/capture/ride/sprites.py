"""Trees and marker posts: small pictures with transparency, drawn upright."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.ride.colours import (
    HAZE,
    HAZE_FROM_M,
    Pixels,
    haze_share,
    mixed,
    packed,
)
from hapticplayer.capture.ride.roadside import TREE_KINDS


@dataclass(frozen=True, slots=True, eq=False)
class Sprite:
    """An upright picture, foot at the middle of its lowest row.

    Attributes:
        pixels: (rows from the top, columns) packed colours.
        solid: (rows, columns) whether something is there.
    """

    pixels: Pixels
    solid: NDArray[np.bool_]


class Placement(NamedTuple):
    """Where a sprite stands on the screen.

    Attributes:
        foot_x: px from the left.
        foot_y: px from the top.
        height_px: of the sprite.
        lean: to the right, as sine of the angle.
        distance_m: for the haze.
    """

    foot_x: float
    foot_y: float
    height_px: float
    lean: float
    distance_m: float


def make_sprites(rng: np.random.Generator) -> tuple[Sprite, ...]:
    """Return the post and the kinds of trees, in the order of their numbers."""
    return (_post(), *(_tree(rng, kind) for kind in TREE_KINDS))


def draw_sprite(canvas: Pixels, sprite: Sprite, place: Placement) -> None:
    """Draw a sprite that leans with the camera's roll."""
    rows, columns = sprite.solid.shape
    width_px = place.height_px * columns / rows
    upright = float(np.sqrt(1.0 - place.lean**2))
    box = _box(canvas, place, width_px, upright)
    if box is None:
        return
    dx = np.arange(box[1].start, box[1].stop, dtype=np.float32) + 0.5 - place.foot_x
    dy = place.foot_y - 0.5 - np.arange(box[0].start, box[0].stop, dtype=np.float32)
    dx, dy = dx[None, :], dy[:, None]
    across = ((dx * upright - dy * place.lean) / width_px + 0.5) * columns
    down = (1.0 - (dx * place.lean + dy * upright) / place.height_px) * rows
    inside = (across >= 0) & (across < columns) & (down >= 0) & (down < rows)
    index = down.astype(np.int32) * columns + across.astype(np.int32)
    np.clip(index, 0, rows * columns - 1, out=index)
    inside &= sprite.solid.reshape(-1)[index]
    colours = sprite.pixels.reshape(-1)[index]
    if place.distance_m > HAZE_FROM_M:
        share = haze_share(np.array(place.distance_m, np.float32))
        colours = mixed(colours, HAZE, share)
    np.copyto(canvas[box], colours, where=inside)


def _box(
    canvas: Pixels, place: Placement, width_px: float, upright: float
) -> tuple[slice, slice] | None:
    """Return the rows and columns a sprite touches, None when there are none."""
    half, shift = 0.5 * width_px * upright, place.height_px * place.lean
    drop = 0.5 * width_px * abs(place.lean)
    left = max(0, int(place.foot_x - half + min(0.0, shift)))
    right = min(canvas.shape[1], int(place.foot_x + half + max(0.0, shift)) + 1)
    top = max(0, int(place.foot_y - place.height_px * upright - drop))
    bottom = min(canvas.shape[0], int(place.foot_y + drop) + 1)
    if place.height_px < 2.0 or left >= right or top >= bottom:
        return None
    return slice(top, bottom), slice(left, right)


def _post() -> Sprite:
    """A white marker post with a black band and a reflector."""
    height, width = 128, 16
    rgb = np.full((height, width, 3), 238.0, np.float32)
    rgb *= np.linspace(1.0, 0.78, width, dtype=np.float32)[None, :, None]
    rgb[18:46] = (34.0, 34.0, 36.0)
    rgb[24:40, 5:11] = (226.0, 92.0, 42.0)
    solid = np.ones((height, width), np.bool_)
    solid[:6, 10:] = False  # the slanted top
    return Sprite(packed(rgb), solid)


def _tree(rng: np.random.Generator, kind: int) -> Sprite:
    """A trunk under a crown of overlapping balls of leaves, lit from the left."""
    height, width = 192, 144
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    rgb = np.zeros((height, width, 3), np.float32)
    solid = (np.abs(x - width / 2) < 3.0 + 0.02 * y) & (y > 90.0)
    rgb[solid] = (84.0, 66.0, 50.0)
    leaves = np.array([(74.0, 112.0, 46.0), (96.0, 120.0, 44.0), (58.0, 98.0, 58.0)])
    spread = (0.30, 0.24, 0.34)[kind - 1]
    for _ in range(90):
        angle, reach = rng.uniform(0.0, 2.0 * np.pi), np.sqrt(rng.uniform())
        middle_x = width * (0.5 + spread * reach * np.cos(angle))
        middle_y = 78.0 + 58.0 * reach * np.sin(angle)
        radius = rng.uniform(9.0, 21.0)
        inside = (x - middle_x) ** 2 + (y - middle_y) ** 2 < radius**2
        light = 1.0 - 0.35 * (x - middle_x) / radius - 0.25 * (y - middle_y) / radius
        light += 0.25 * (90.0 - middle_y) / 90.0 + rng.normal(0.0, 0.06)
        rgb[inside] = light[inside, None] * leaves[kind - 1] * 0.9
        solid |= inside
    rgb += rng.normal(0.0, 7.0, (height, width, 1)).astype(np.float32)
    return Sprite(packed(rgb), solid)
