"""One frame of the film: sky, ground, sprites, foreground."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from hapticplayer.extras.rides.film.foreground import make_foreground
from hapticplayer.extras.rides.film.ground import SIZE, GroundTexture, draw_face
from hapticplayer.extras.rides.film.scenery import TREE_KINDS, Country
from hapticplayer.extras.rides.film.view import (
    HAZE,
    HAZE_FROM_M,
    WHITE,
    CameraPose,
    CameraRays,
    Floats32,
    Pixels,
    colour,
    haze_share,
    mixed,
    packed,
)

_TILE = 512
_CLOUD_HEIGHT_CELLS = 100.0
_LOWEST_CLOUD = 0.03  # rise of the ray; below it clouds would be a blur
_STEPS_PER_RISE = 480.0
_AZIMUTHS = 1024


class Sky:
    """What is above the horizon; drawn at half resolution, because it is soft."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._gradient = _gradient()
        self._clouds = _clouds(rng)
        self._ridges = tuple(
            (_ridge(rng, height, roughness), tint)
            for height, roughness, tint in (
                (0.085, 26.0, colour(168.0, 186.0, 200.0)),
                (0.050, 15.0, colour(132.0, 158.0, 148.0)),
            )
        )

    def draw(self, canvas: Pixels, view: CameraRays, rotation: Floats32) -> None:
        """Paint all rows above the horizon; `rotation` is sensor to earth."""
        above = np.flatnonzero(view.edges(rotation[2]).max(axis=1) > 0.0)
        rows = min(len(canvas), int(above[-1]) + 3 if len(above) else 0)
        if not rows:
            return
        coarse = CameraRays(view.x[:, ::2], view.z[:rows:2], view.focal_px)
        up = coarse.towards(rotation[2])
        level = np.clip(_STEPS_PER_RISE * up, 0.0, len(self._gradient) - 1.0)
        colours = mixed(
            self._gradient[level.astype(np.int32)],
            WHITE,
            self._cloud_cover(coarse, rotation, up),
        )
        column = _azimuth_column(coarse, rotation)
        for heights, tint in self._ridges:
            np.copyto(colours, tint, where=up < heights[column][None, :])
        doubled = np.repeat(np.repeat(colours, 2, axis=0), 2, axis=1)
        canvas[:rows] = doubled[:rows, : canvas.shape[1]]

    def _cloud_cover(
        self, view: CameraRays, rotation: Floats32, up: Floats32
    ) -> Pixels:
        reach = _CLOUD_HEIGHT_CELLS / np.maximum(up, np.float32(_LOWEST_CLOUD))
        east = (view.towards(rotation[0]) * reach).astype(np.int32) & (_TILE - 1)
        north = (view.towards(rotation[1]) * reach).astype(np.int32) & (_TILE - 1)
        cover = self._clouds[north, east]
        return np.asarray(np.where(up > _LOWEST_CLOUD, cover, np.uint32(0)))


def _azimuth_column(
    view: CameraRays, rotation: Floats32
) -> np.ndarray[tuple[int], np.dtype[np.int32]]:
    """Return for each column where it points, as an index into the ridges."""
    x = view.x[0]
    north = rotation[1, 0] * x + rotation[1, 1]
    east = rotation[0, 0] * x + rotation[0, 1]
    turn = np.arctan2(north, east) * (_AZIMUTHS / (2.0 * np.pi))
    return np.asarray(turn.astype(np.int32) % _AZIMUTHS)


def _gradient() -> Pixels:
    """Return the sky's colours from the horizon upwards."""
    share = np.linspace(0.0, 1.0, 384, dtype=np.float32)[:, None] ** 0.8
    horizon = np.array((232.0, 228.0, 214.0), np.float32)
    zenith = np.array((92.0, 146.0, 206.0), np.float32)
    return packed(horizon + (zenith - horizon) * share)


def _clouds(rng: np.random.Generator) -> Pixels:
    """Return the cover of clouds, 0 to 230 of 256, on a tile that repeats."""
    noise = rng.standard_normal((_TILE, _TILE))
    layers = [
        scale * gaussian_filter(noise, scale, mode="wrap")
        for scale in (5.0, 12.0, 30.0)
    ]
    cloud = np.sum(layers, axis=0)
    cloud = (cloud - cloud.mean()) / cloud.std()
    return np.asarray(np.clip((cloud - 0.35) * 170.0, 0.0, 230.0).astype(np.uint32))


def _ridge(rng: np.random.Generator, height: float, roughness: float) -> Floats32:
    noise = gaussian_filter(rng.standard_normal(_AZIMUTHS), roughness, mode="wrap")
    shape = height * (0.62 + 0.38 * noise / np.abs(noise).max())
    return np.asarray(shape.astype(np.float32))


Indices = NDArray[np.int32]

_UPRIGHT_PX = 60.0
"""Smaller ones do not lean: it would not be seen, and takes twice the time."""


@dataclass(frozen=True, slots=True, eq=False)
class Sprite:
    """An upright sprite, foot at the middle of its lowest row.

    `hazed` holds the pixels behind haze, made at first use.
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
    """Where a sprite stands on the screen; `lean` is a sine, to the right."""

    foot_x: float
    foot_y: float
    height_px: float
    lean: float
    distance_m: float


def make_sprites(rng: np.random.Generator, *, wooden: bool) -> tuple[Sprite, ...]:
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


_NEAREST_M = 0.6
_FARTHEST_M = 150.0
_LEAST_PX = 7.0
_STRIP = 48


class PictureMaker:
    """Draws the frames of one scene in one size."""

    def __init__(
        self, country: Country, width: int, height: int, rng: np.random.Generator
    ) -> None:
        self._country = country
        self._view = CameraRays.of_size(width, height)
        self._sprites = make_sprites(rng, wooden=country.vehicle == "horse")
        self._sky = Sky(rng)
        self._foreground = make_foreground(country.vehicle, width, height, rng)

    def draw(self, pose: CameraPose) -> NDArray[np.uint8]:
        """Return the frame (height, width, 4): RGB and an unused channel."""
        self._country.prepare([pose])
        canvas = np.empty(self._view.size, np.uint32)
        rotation = pose.rotation.astype(np.float32)
        self._sky.draw(canvas, self._view, rotation)
        for top in range(0, len(canvas), _STRIP):
            self._draw_strip(canvas, top, pose, rotation)
        self._draw_standing(canvas, pose)
        for face in self._country.faces:
            draw_face(canvas, self._view, pose, face)
        if self._foreground is not None:
            self._foreground(canvas, pose.shake_px, pose.steering_rad)
        return canvas.view(np.uint8).reshape(*canvas.shape, 4)

    def prepare(self, poses: list[CameraPose], margin_m: float) -> None:
        """Paint the ground for poses that will be drawn, by several threads perhaps."""
        self._country.prepare(poses, margin_m)

    def _draw_strip(
        self, canvas: Pixels, top: int, pose: CameraPose, rotation: Floats32
    ) -> None:
        """Draw the ground in some rows; so few that all of it stays in the cache."""
        view = self._view.rows(top, top + _STRIP)
        edges = view.edges(rotation[2])
        height_m, nearer_m = float(pose.position_m[2]), 0.0
        rise: Floats32 | None = None
        for texture in self._country.ground:
            is_last = texture is self._country.ground[-1]
            # a ray that rises by -h / d meets the ground at the distance d
            flattest = np.float32(0.0 if is_last else -height_m / texture.reach_m)
            steepest = np.float32(-height_m / nearer_m if nearer_m else -np.inf)
            nearer_m = texture.reach_m
            if edges.min() >= flattest or edges.max() < steepest:
                continue
            rise = view.towards(rotation[2]) if rise is None else rise
            distance = np.minimum(rise, np.float32(-1e-4))
            np.divide(np.float32(-height_m), distance, out=distance)
            colours = _look_up(texture, view, pose, distance)
            if is_last:
                colours = mixed(colours, HAZE, haze_share(distance))
            seen = rise < flattest
            seen &= rise >= steepest
            np.copyto(canvas[top : top + _STRIP], colours, where=seen)

    def _draw_standing(self, canvas: Pixels, pose: CameraPose) -> None:
        """Draw the things beside the road, from far to near."""
        things = self._country.standing
        right, front, up = ((things.foot_m - pose.position_m) @ pose.rotation).T
        per_m = self._view.focal_px / np.maximum(front, _NEAREST_M)
        visible = (front > _NEAREST_M) & (front < _FARTHEST_M)
        visible &= np.abs(right) < 1.4 * front + 4.0
        visible &= per_m * things.height_m >= _LEAST_PX
        numbers = np.flatnonzero(visible)
        rows, columns = self._view.size
        earth_up = pose.rotation[2]  # in the sensor frame
        lean = float(earth_up[0] / np.hypot(earth_up[0], earth_up[2]))
        for number in numbers[np.argsort(-front[numbers], kind="stable")]:
            place = Placement(
                foot_x=float(0.5 * columns + per_m[number] * right[number]),
                foot_y=float(0.5 * rows - per_m[number] * up[number]),
                height_px=float(per_m[number] * things.height_m[number]),
                lean=lean,
                distance_m=float(front[number]),
            )
            draw_sprite(canvas, self._sprites[things.kind[number]], place)


def _look_up(
    texture: GroundTexture, view: CameraRays, pose: CameraPose, distance: Floats32
) -> Pixels:
    """Return the colour of the ground that each ray meets."""
    rotation = pose.rotation.astype(np.float32)
    scale = np.minimum(distance, np.float32(texture.reach_m))
    scale *= np.float32(1.0 / texture.pixel_m)
    # the window wraps around: a remainder, made positive by whole windows
    column, row = (
        _cells(view.towards(rotation[axis]), scale, pose.position_m[axis], texture)
        for axis in (0, 1)
    )
    row *= SIZE
    row += column
    return np.asarray(texture.pixels.reshape(-1).take(row))


def _cells(
    ray: Floats32, scale: Floats32, at_m: float, texture: GroundTexture
) -> NDArray[np.int32]:
    ray *= scale
    ray += np.float32(at_m / texture.pixel_m % SIZE + SIZE)
    cells = ray.astype(np.int32)
    cells &= SIZE - 1
    return cells
