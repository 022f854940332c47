"""What the camera sees of its own carrier: handlebar, dashboard, a horse's head."""

import functools
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from hapticplayer.simulation.film.view import Floats32, Pixels, mixed, packed
from hapticplayer.simulation.rides.scenes import Vehicle

Reals = NDArray[np.floating[Any]]


@dataclass(frozen=True, slots=True, eq=False)
class Painted:
    """Colours (rows, width, 3) 0 to 255 and cover (rows, width) 0 to 1.

    The `spare` rows at the bottom only show when it moves up.
    """

    rgb: Floats32
    cover: Floats32
    spare: int


def within(distance: Reals, rows: int) -> Floats32:
    """Return a cover that is soft over a pixel at distance 0, in shares of the rows."""
    return np.asarray(np.clip(distance * rows + 0.5, 0.0, 1.0), np.float32)


def lay(rgb: Floats32, cover: Floats32, tint: Reals, over: Reals) -> None:
    """Paint a tint (rows, width, 3) where `over` (rows, width) says."""
    rgb += (tint - rgb) * over[..., None]
    np.maximum(cover, over, out=cover)


class Overlay:
    """Lays a painting over frames: whole pixels are copied, edges are blended."""

    def __init__(self, painted: Painted, left: int = 0) -> None:
        self._rows = len(painted.rgb) - painted.spare
        self._spare = painted.spare
        self._columns = slice(left, left + painted.rgb.shape[1])
        self._pixels = packed(painted.rgb)
        self._solid = painted.cover > 0.995
        self._edge = np.nonzero((painted.cover > 0.004) & ~self._solid)
        self._share = (256.0 * painted.cover[self._edge]).astype(np.uint32)
        self._edge_pixels = self._pixels[self._edge]

    def lay_over(self, canvas: Pixels, down_px: float) -> None:
        """Lay it over a canvas, moved down by `down_px`."""
        shift = int(np.clip(round(down_px), -self._spare, self._spare))
        part = canvas[len(canvas) - self._rows + shift :, self._columns]
        rows = len(part)
        np.copyto(part, self._pixels[:rows], where=self._solid[:rows])
        count = int(np.searchsorted(self._edge[0], rows))
        y, x = self._edge[0][:count], self._edge[1][:count]
        part[y, x] = mixed(part[y, x], self._edge_pixels[:count], self._share[:count])


_HANDLEBAR_SHARE = 0.30  # of the frame's height
_STEEL = (58.0, 60.0, 66.0)
_RUBBER = (36.0, 34.0, 36.0)
_SILVER = (176.0, 180.0, 186.0)
_BLACK = (70.0, 72.0, 78.0)
_BRASS = (186.0, 148.0, 74.0)


def handlebar(width: int, height: int) -> Painted:
    """Return the handlebar with its brakes and its bell."""
    rows = round(_HANDLEBAR_SHARE * height)
    spare = rows // 4
    y, x = np.mgrid[0 : rows + spare, 0:width].astype(np.float32)
    u, v = (x - 0.5 * width) / (0.5 * width), y / rows
    rgb = np.zeros((*v.shape, 3), np.float32)
    cover = np.zeros(v.shape, np.float32)
    middle = 0.42 + 0.16 * u**2 - 0.10 * np.exp(-((u / 0.22) ** 2))
    thickness = 0.085 + 0.02 * np.exp(-((u / 0.2) ** 2))
    across = (v - middle) / thickness
    tubes = [
        (across, np.abs(u) < 0.80, _STEEL),
        (across / 1.45, np.abs(np.abs(u) - 0.70) < 0.16, _RUBBER),
    ]
    for out in (-u, u):
        lever = (v - middle + 0.15 + 0.10 * (out - 0.5)) / 0.04
        clamp = (v > middle - 0.19) & (v < middle + 0.07)
        tubes += [
            (lever, np.abs(out - 0.64) < 0.15, _SILVER),
            ((out - 0.50) / 0.018, clamp, _BLACK),
        ]
    stem = u / (0.035 + 0.045 * np.clip(v - 0.3, 0.0, 1.0))
    tubes.append((stem, v > middle - 0.02, _STEEL))
    for position, where, tint in tubes:
        tube(rgb, cover, position, where, np.array(tint, np.float32), rows)
    _bell(rgb, cover, (x - 0.40 * width) / rows, v - 0.28)
    return Painted(rgb, cover, spare)


def tube(
    rgb: Floats32,
    cover: Floats32,
    across: Floats32,
    where: NDArray[np.bool_],
    tint: Floats32,
    rows: int,
) -> None:
    """Paint a round tube: `across` runs from -1 to 1 over its visible width."""
    edge = np.clip((1.0 - np.abs(across)) * 0.09 * rows, 0.0, 1.0) * where
    shine = 0.62 + 0.55 * np.exp(-(((across + 0.35) / 0.4) ** 2))
    rgb += (np.multiply.outer(shine, tint) - rgb) * edge[..., None]
    np.maximum(cover, edge, out=cover)


def _bell(rgb: Floats32, cover: Floats32, across: Floats32, down: Floats32) -> None:
    """Paint a brass dome with its light at the upper left."""
    radius = np.hypot(across, down) / 0.15
    edge = np.clip((1.0 - radius) * 24.0, 0.0, 1.0)
    light = 1.15 * np.exp(-(np.hypot(across + 0.05, down + 0.05) ** 2) / 0.008)
    shade = 0.95 - 0.45 * radius**2 + light
    tint = np.multiply.outer(shade, np.array(_BRASS, np.float32))
    rgb += (np.clip(tint, 0.0, 250.0) - rgb) * edge[..., None]
    np.maximum(cover, edge, out=cover)


_HORSE_SHARE = 0.56  # of the frame's height
_COAT = np.array((132.0, 84.0, 50.0), np.float32)
_DARK = np.array((46.0, 30.0, 24.0), np.float32)
_LEATHER = np.array((58.0, 38.0, 28.0), np.float32)


def horse(width: int, height: int, rng: np.random.Generator) -> Painted:
    """Return neck, mane, ears and reins; the head nods as one with them."""
    rows = round(_HORSE_SHARE * height)
    spare = rows // 3
    y, x = np.mgrid[0 : rows + spare, 0:width].astype(np.float32)
    u, v = (x - 0.5 * width) / rows, y / rows
    rgb = np.zeros((*v.shape, 3), np.float32)
    cover = np.zeros(v.shape, np.float32)
    hair = gaussian_filter(rng.standard_normal(v.shape).astype(np.float32), (7.0, 0.8))
    hair /= hair.std()
    for side in (-1.0, 1.0):
        _rein(rgb, cover, side * u, v, rows)
    # the neck narrows to the poll between the ears
    half = 0.095 + 0.30 * np.clip(v - 0.20, 0.0, 2.0) ** 1.25
    light = 1.08 - 0.55 * (u / half) ** 2 - 0.22 * (u / half) + 0.035 * hair
    lay(
        rgb, cover, light[..., None] * _COAT, within(half - np.abs(u), rows) * (v > 0.2)
    )
    poll = 1.0 - np.hypot(u / 0.10, (v - 0.225) / 0.075)
    shade = (1.02 - 0.5 * (u / 0.11) ** 2 + 0.03 * hair)[..., None] * _COAT
    lay(rgb, cover, shade, within(0.08 * poll, rows))
    for side in (-1.0, 1.0):
        _ear(rgb, cover, side * u, v, rows)
    _mane(rgb, cover, u, v, hair)
    return Painted(rgb, cover, spare)


def _ear(rgb: Floats32, cover: Floats32, u: Floats32, v: Floats32, rows: int) -> None:
    """Paint a pointed ear that leans outwards, dark inside."""
    along = (0.21 - v) / 0.19  # 0 at its root, 1 at its tip
    middle = 0.060 + 0.028 * along
    half = (
        0.036
        * np.sqrt(np.clip(along * (1.0 - along), 0.0, 1.0))
        * 2.0
        * (1.15 - 0.5 * along)
    )
    inside = (half - np.abs(u - middle)) * (along > 0.0)
    light = 1.1 - 9.0 * np.abs(u - middle - 0.004)
    lay(rgb, cover, light[..., None] * _COAT, within(inside, rows) * (half > 0.0))
    hollow = 0.55 * half - np.abs(u - middle - 0.003)
    lay(
        rgb,
        cover,
        0.6 * light[..., None] * _COAT,
        0.8 * within(hollow, rows) * (half > 0.004),
    )


def _mane(
    rgb: Floats32, cover: Floats32, u: Floats32, v: Floats32, hair: Floats32
) -> None:
    """Paint the mane: strands that fall to the right of the crest."""
    down = np.clip(v - 0.14, 0.0, 2.0)
    edge = 0.012 + 0.16 * down + 0.011 * hair * (0.4 + down)
    start = -0.018 - 0.03 * down + 0.004 * hair
    cut = np.clip((edge - u) * 90.0, 0.0, 1.0) * np.clip((u - start) * 140.0, 0.0, 1.0)
    over = cut * np.clip((v - 0.125) * 40.0, 0.0, 1.0)
    light = 1.0 + 0.30 * hair + 2.2 * np.clip(0.06 - np.abs(u - 0.03), 0.0, 1.0)
    lay(
        rgb,
        cover,
        np.clip(light, 0.2, 3.0)[..., None] * _DARK,
        np.asarray(over, np.float32),
    )


def _rein(rgb: Floats32, cover: Floats32, u: Floats32, v: Floats32, rows: int) -> None:
    """Paint a rein from the bit up to the hand at the lower edge."""
    middle = 0.11 + 0.30 * np.clip((v - 0.28) / 0.75, 0.0, 2.0) ** 0.8
    half = 0.008 + 0.008 * v
    light = 1.0 + 0.7 * np.clip(1.0 - np.abs(u - middle + 0.3 * half) / half, 0.0, 1.0)
    over = within(half - np.abs(u - middle), rows) * (v > 0.27)
    lay(rgb, cover, light[..., None] * _LEATHER, over)


_DASHBOARD_SHARE = 0.40  # of the frame's height
_PAINT = np.array((150.0, 34.0, 36.0), np.float32)
_PLASTIC = np.array((40.0, 42.0, 46.0), np.float32)
_RIM = np.array((30.0, 30.0, 33.0), np.float32)
_LAMP = np.array((236.0, 226.0, 190.0), np.float32)

_WHEEL_V, _RADIUS, _THICKNESS = 1.02, 0.70, 0.055
"""Of the steering wheel: middle, radius and half thickness in shares of the rows."""


def dashboard(width: int, height: int) -> Painted:
    """Return everything that does not turn, the wheel's rim with it."""
    rows, spare, u, v = _places(width, height)
    rgb = np.zeros((*v.shape, 3), np.float32)
    cover = np.zeros(v.shape, np.float32)
    aside = u / (0.5 * width / rows)  # -1 to 1
    # the bonnet, whose far edge is curved; it mirrors a little of the sky
    edge = 0.16 + 0.16 * (aside - 0.22) ** 2
    mirror = 70.0 * np.clip(1.0 - (v - edge) / 0.16, 0.0, 1.0) ** 2
    crease = 16.0 * np.exp(-(((np.abs(aside - 0.22) - 0.45 - 0.3 * v) / 0.02) ** 2))
    tint = _PAINT * (0.72 + 0.5 * (v - edge))[..., None] + (mirror + crease)[..., None]
    lay(rgb, cover, tint, within(v - edge, rows))
    # the dashboard, darker towards the driver
    top = 0.36 - 0.10 * np.exp(-((u / 0.52) ** 4)) + 0.05 * aside**2
    sheen = 26.0 * np.exp(-(((v - top) / 0.035) ** 2))
    tint = _PLASTIC * np.clip(1.25 - 0.9 * (v - top), 0.35, 2.0)[..., None]
    lay(rgb, cover, tint + sheen[..., None], within(v - top, rows))
    for at in (-0.20, 0.20):
        _dial(rgb, u - at, v - 0.56, rows)
    _vent(rgb, u - 1.28, v - 0.60, rows)
    ring = np.abs(np.hypot(u, v - _WHEEL_V) - _RADIUS)
    bulge = 1.0 - (ring / _THICKNESS) ** 2
    shine = (
        0.75
        + 0.55 * np.clip(bulge, 0.0, 1.0)
        + 1.1
        * np.exp(-(((np.hypot(u, v - _WHEEL_V) - _RADIUS - 0.018) / 0.012) ** 2))
        * np.clip(_WHEEL_V - v, 0.0, 1.0)
    )
    lay(rgb, cover, shine[..., None] * _RIM, within(_THICKNESS - ring, rows))
    return Painted(rgb, cover, spare)


def spokes(width: int, height: int, turned_rad: float) -> tuple[Painted, int]:
    """Return hub, spokes and the mark on the rim, and the column they begin at."""
    rows, spare, u, v = _places(width, height)
    columns = np.flatnonzero(np.abs(u[0]) < _RADIUS + _THICKNESS)
    u, v = u[:, columns], v[:, columns]
    # turned to the left the wheel goes counterclockwise for the driver
    x, up = u, _WHEEL_V - v
    across = x * np.cos(turned_rad) + up * np.sin(turned_rad)
    along = up * np.cos(turned_rad) - x * np.sin(turned_rad)
    radius = np.hypot(across, along)
    inside = np.clip((_RADIUS - _THICKNESS * 0.6 - radius) * rows, 0.0, 1.0)
    rgb = np.zeros((*u.shape, 3), np.float32)
    cover = np.zeros(u.shape, np.float32)
    bar = 0.07 - np.abs(along + 0.02 - 0.10 * np.clip(np.abs(across) - 0.2, 0, 1))
    post = (0.075 - np.abs(across)) * (along < 0.0)
    tint = (1.15 + 0.4 * np.clip(along, -0.2, 0.3))[..., None] * _RIM
    for shape in (bar, post):
        lay(rgb, cover, tint, within(np.asarray(shape), rows) * inside)
    lay(rgb, cover, (1.5 - 1.2 * radius)[..., None] * _RIM, within(0.24 - radius, rows))
    mark = (np.abs(across) < 0.022) & (along > 0.0)
    on_rim = within(_THICKNESS - np.abs(radius - _RADIUS), rows)
    lay(rgb, cover, np.broadcast_to(0.75 * _LAMP, rgb.shape), on_rim * mark)
    return Painted(rgb, cover, spare), int(columns[0])


def _places(width: int, height: int) -> tuple[int, int, Floats32, Floats32]:
    """Return rows, spare rows, and places right and down in shares of the rows."""
    rows = round(_DASHBOARD_SHARE * height)
    spare = rows // 12
    y, x = np.mgrid[0 : rows + spare, 0:width].astype(np.float32)
    return rows, spare, (x - 0.5 * width) / rows, y / rows


def _dial(rgb: Floats32, u: Floats32, v: Floats32, rows: int) -> None:
    """Paint a round instrument with ticks and a pointer."""
    radius, angle = np.hypot(u, v), np.arctan2(v, u)
    none = np.zeros(u.shape, np.float32)
    face = np.array((16.0, 18.0, 22.0), np.float32)
    lay(rgb, none, np.broadcast_to(face, rgb.shape), within(0.155 - radius, rows))
    ring = within(0.006 - np.abs(radius - 0.155), rows)
    lay(rgb, none, np.broadcast_to(0.55 * _LAMP, rgb.shape), ring)
    ticks = (np.abs((angle * 8.0 / np.pi + 0.5) % 1.0 - 0.5) < 0.09) & (v < 0.08)
    dashes = ticks * within(0.010 - np.abs(radius - 0.135), rows)
    lay(rgb, none, np.broadcast_to(0.8 * _LAMP, rgb.shape), dashes)
    hand = (
        within(0.006 - np.abs(u * 0.55 + v * 0.83), rows) * (radius < 0.12) * (u < 0.02)
    )
    red = np.array((226.0, 74.0, 40.0), np.float32)
    lay(rgb, none, np.broadcast_to(red, rgb.shape), hand)


def _vent(rgb: Floats32, u: Floats32, v: Floats32, rows: int) -> None:
    """Paint an air outlet with its slats."""
    none = np.zeros(u.shape, np.float32)
    frame = within(np.minimum(0.26 - np.abs(u), 0.12 - np.abs(v)), rows)
    slats = 0.35 + 0.45 * (np.abs((v / 0.048) % 1.0 - 0.5) < 0.22)
    lay(rgb, none, slats[..., None] * _PLASTIC, frame)


STEERING_RATIO = 15.0
"""Of the steering wheel to the wheels, as in most cars."""


class Foreground(Protocol):
    """Is laid over each frame."""

    def lay_over(self, canvas: Pixels, shake_px: float, steering_rad: float) -> None:
        """Lay it over, moved down by `shake_px`, steered to the left."""


class _Fixed:
    """A foreground in one piece."""

    def __init__(self, overlay: Overlay) -> None:
        self._overlay = overlay

    def lay_over(self, canvas: Pixels, shake_px: float, _steering_rad: float) -> None:
        self._overlay.lay_over(canvas, shake_px)


class _Dashboard:
    """A dashboard behind a steering wheel that turns."""

    def __init__(self, width: int, height: int) -> None:
        self._board = Overlay(dashboard(width, height))
        self._spokes = functools.lru_cache(maxsize=64)(
            lambda degrees: Overlay(*spokes(width, height, float(np.radians(degrees))))
        )

    def lay_over(self, canvas: Pixels, shake_px: float, steering_rad: float) -> None:
        self._board.lay_over(canvas, shake_px)
        turned = 3 * round(np.degrees(STEERING_RATIO * steering_rad) / 3.0)
        self._spokes(turned).lay_over(canvas, shake_px)


def make_foreground(
    vehicle: Vehicle, width: int, height: int, rng: np.random.Generator
) -> Foreground | None:
    """Return what is seen in front of the camera on a vehicle."""
    if vehicle == "bicycle":
        return _Fixed(Overlay(handlebar(width, height)))
    if vehicle == "horse":
        return _Fixed(Overlay(horse(width, height, rng)))
    return _Dashboard(width, height) if vehicle == "car" else None
