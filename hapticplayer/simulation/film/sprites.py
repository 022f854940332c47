"""Trees and marker posts: small pictures with transparency, drawn upright."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.film.colours import (
    HAZE,
    HAZE_FROM_M,
    Floats32,
    Pixels,
    haze_share,
    mixed,
    packed,
)
from hapticplayer.simulation.film.roadside import TREE_KINDS

Indices = NDArray[np.int32]

_UPRIGHT_PX = 60.0
"""Smaller ones do not lean: it would not be seen, and takes twice the time."""


@dataclass(frozen=True, slots=True, eq=False)
class Sprite:
    """An upright picture, foot at the middle of its lowest row.

    Attributes:
        pixels: (rows from the top, columns) packed colours.
        solid: (rows, columns) whether something is there.
        hazed: the pixels behind haze, made at first use.
    """

    pixels: Pixels
    solid: NDArray[np.bool_]
    hazed: dict[int, Pixels] = field(default_factory=dict)

    def through_haze(self, distance_m: float) -> Pixels:
        """Return the colours at a distance, in 16 steps of haze."""
        if distance_m <= HAZE_FROM_M:
            return self.pixels
        share = int(haze_share(np.array(distance_m, np.float32))) // 16 * 16 + 8
        if share not in self.hazed:
            self.hazed[share] = mixed(self.pixels, HAZE, np.uint32(share))
        return self.hazed[share]


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


def make_sprites(rng: np.random.Generator, *, wooden: bool) -> tuple[Sprite, ...]:
    """Return the post and the kinds of trees, in the order of their numbers."""
    post = _stake() if wooden else _post()
    return (post, *(_tree(rng, kind) for kind in TREE_KINDS))


def draw_sprite(canvas: Pixels, sprite: Sprite, place: Placement) -> None:
    """Draw a sprite that leans with the camera's roll."""
    rows, columns = sprite.solid.shape
    width_px = place.height_px * columns / rows
    upright = float(np.sqrt(1.0 - place.lean**2))
    box = _box(canvas, place, width_px, upright)
    if box is None:
        return
    across = np.arange(box[1].start, box[1].stop, dtype=np.float32)
    across += np.float32(0.5 - place.foot_x)
    down = np.arange(box[0].start, box[0].stop, dtype=np.float32)
    down += np.float32(0.5 - place.foot_y)
    if place.height_px < _UPRIGHT_PX:
        index, inside = _upright(sprite, across, down, place.height_px)
    else:
        index, inside = _leaning(sprite, across, down, place)
    inside &= sprite.solid.take(index)
    colours = sprite.through_haze(place.distance_m).take(index)
    np.copyto(canvas[box], colours, where=inside)


def _upright(
    sprite: Sprite, across: Floats32, down: Floats32, height_px: float
) -> tuple[Indices, NDArray[np.bool_]]:
    """Return which pixels of a small sprite are seen, and where; it does not lean."""
    rows, columns = sprite.solid.shape
    scale = rows / height_px
    x = (across * scale + 0.5 * columns).astype(np.int32)
    y = (down * scale + rows).astype(np.int32)
    inside = np.logical_and.outer((y >= 0) & (y < rows), (x >= 0) & (x < columns))
    np.minimum(np.maximum(y, 0, out=y), rows - 1, out=y)
    np.minimum(np.maximum(x, 0, out=x), columns - 1, out=x)
    index = np.add.outer(columns * y, x)
    return index, inside


def _leaning(
    sprite: Sprite, across: Floats32, down: Floats32, place: Placement
) -> tuple[Indices, NDArray[np.bool_]]:
    rows, columns = sprite.solid.shape
    upright = float(np.sqrt(1.0 - place.lean**2))
    scale = rows / place.height_px
    x = np.add.outer(down * (place.lean * scale), across * (upright * scale))
    x += 0.5 * columns
    y = np.add.outer(down * (upright * scale), across * (-place.lean * scale))
    y += rows
    inside = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    index = y.astype(np.int32)
    index *= columns
    index += x.astype(np.int32)
    return np.clip(index, 0, rows * columns - 1, out=index), inside


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


def _stake() -> Sprite:
    """A round wooden stake, darker at its foot, lit from the left."""
    height, width = 128, 14
    x, y = np.linspace(-1.0, 1.0, width), np.linspace(0.0, 1.0, height)
    shade = (1.0 - 0.35 * x - 0.3 * x**2)[None, :] * (1.08 - 0.3 * y)[:, None]
    rings = 1.0 + 0.05 * np.sin(40.0 * y + 0.8)[:, None]
    rgb = (shade * rings)[..., None] * np.array((142.0, 112.0, 78.0))
    return Sprite(packed(rgb.astype(np.float32)), np.ones((height, width), np.bool_))


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
