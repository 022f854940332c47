"""What the camera sees of its own carrier: handlebar, dashboard, a horse's head."""

import functools
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from hapticplayer.extras.rides.film.view import Floats32, Pixels, mixed, packed, rgb_of
from hapticplayer.extras.rides.scenes import Vehicle

Reals = NDArray[np.floating[Any]]

Foreground = Callable[[Pixels, float, float], None]
"""Is laid over a canvas, moved down by pixels, turned to the left by an angle in rad."""


class Painting:
    """Colours 0 to 255 and cover 0 to 1 at the lower edge of a frame.

    `u` (right from the middle) and `v` (down) are places in shares of the rows. Below
    the rows lie `spare` ones that only show when the painting moves up.
    """

    def __init__(self, width: int, height: int, share: float, spare: int) -> None:
        self.rows = round(share * height)
        self.spare = self.rows // spare
        y, x = np.mgrid[0 : self.rows + self.spare, 0:width].astype(np.float32)
        self.u, self.v = (x - 0.5 * width) / self.rows, y / self.rows
        self._clear()

    def keep_columns(self, columns: NDArray[np.intp]) -> None:
        """Forget all other columns."""
        self.u, self.v = self.u[:, columns], self.v[:, columns]
        self._clear()

    def _clear(self) -> None:
        self.rgb = np.zeros((*self.u.shape, 3), np.float32)
        self.cover = np.zeros(self.u.shape, np.float32)

    def within(self, distance: Reals) -> Floats32:
        """Return a cover that is soft over a pixel at distance 0."""
        return np.asarray(np.clip(distance * self.rows + 0.5, 0.0, 1.0), np.float32)

    def lay(self, tint: Reals, over: Reals) -> None:
        """Paint a tint (..., 3) where `over` (rows, width) says."""
        self.rgb += (tint - self.rgb) * over[..., None]
        np.maximum(self.cover, over, out=self.cover)


class Overlay:
    """Lays a painting over frames: whole pixels are copied, edges are blended."""

    def __init__(self, painting: Painting, left: int = 0) -> None:
        self._rows, self._spare = painting.rows, painting.spare
        self._columns = slice(left, left + painting.rgb.shape[1])
        self._pixels = packed(painting.rgb)
        self._solid = painting.cover > 0.995
        self._edge = np.nonzero((painting.cover > 0.004) & ~self._solid)
        self._share = (256.0 * painting.cover[self._edge]).astype(np.uint32)
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


_STEEL = rgb_of(58.0, 60.0, 66.0)
_RUBBER = rgb_of(36.0, 34.0, 36.0)
_SILVER = rgb_of(176.0, 180.0, 186.0)
_BLACK = rgb_of(70.0, 72.0, 78.0)
_BRASS = rgb_of(186.0, 148.0, 74.0)


def handlebar(width: int, height: int) -> Painting:
    """Return the handlebar with its brakes and its bell."""
    painting = Painting(width, height, share=0.30, spare=4)
    rows, v = painting.rows, painting.v
    u = painting.u / np.float32(0.5 * width / rows)  # -1 to 1
    middle = 0.42 + 0.16 * u**2 - 0.10 * np.exp(-((u / 0.22) ** 2))
    thickness = 0.085 + 0.02 * np.exp(-((u / 0.2) ** 2))
    across = (v - middle) / thickness
    _tube(painting, across, np.abs(u) < 0.80, _STEEL)
    _tube(painting, across / 1.45, np.abs(np.abs(u) - 0.70) < 0.16, _RUBBER)
    for out in (-u, u):
        lever = (v - middle + 0.15 + 0.10 * (out - 0.5)) / 0.04
        clamp = (v > middle - 0.19) & (v < middle + 0.07)
        _tube(painting, lever, np.abs(out - 0.64) < 0.15, _SILVER)
        _tube(painting, (out - 0.50) / 0.018, clamp, _BLACK)
    stem = u / (0.035 + 0.045 * np.clip(v - 0.3, 0.0, 1.0))
    _tube(painting, stem, v > middle - 0.02, _STEEL)
    # a brass dome with its light at the upper left
    across, down = painting.u + 0.10 * width / rows, v - 0.28
    radius = np.hypot(across, down) / 0.15
    light = 1.15 * np.exp(-(np.hypot(across + 0.05, down + 0.05) ** 2) / 0.008)
    tint = np.multiply.outer(0.95 - 0.45 * radius**2 + light, _BRASS)
    painting.lay(np.clip(tint, 0.0, 250.0), np.clip((1.0 - radius) * 24.0, 0.0, 1.0))
    return painting


def _tube(
    painting: Painting, across: Reals, where: NDArray[np.bool_], tint: Floats32
) -> None:
    """Paint a round tube: `across` runs from -1 to 1 over its visible width."""
    edge = np.clip((1.0 - np.abs(across)) * 0.09 * painting.rows, 0.0, 1.0) * where
    shine = 0.62 + 0.55 * np.exp(-(((across + 0.35) / 0.4) ** 2))
    painting.lay(np.multiply.outer(shine, tint), edge)


_COAT = rgb_of(132.0, 84.0, 50.0)
_DARK = rgb_of(46.0, 30.0, 24.0)
_LEATHER = rgb_of(58.0, 38.0, 28.0)


def horse(width: int, height: int, rng: np.random.Generator) -> Painting:
    """Return neck, mane, ears and reins; the head nods as one with them."""
    painting = Painting(width, height, share=0.56, spare=3)
    u, v, within = painting.u, painting.v, painting.within
    hair = gaussian_filter(rng.standard_normal(v.shape).astype(np.float32), (7.0, 0.8))
    hair /= hair.std()
    for side in (-1.0, 1.0):
        _rein(painting, side * u)
    # the neck narrows to the poll between the ears
    half = 0.095 + 0.30 * np.clip(v - 0.20, 0.0, 2.0) ** 1.25
    light = 1.08 - 0.55 * (u / half) ** 2 - 0.22 * (u / half) + 0.035 * hair
    painting.lay(light[..., None] * _COAT, within(half - np.abs(u)) * (v > 0.2))
    poll = 1.0 - np.hypot(u / 0.10, (v - 0.225) / 0.075)
    light = 1.02 - 0.5 * (u / 0.11) ** 2 + 0.03 * hair
    painting.lay(light[..., None] * _COAT, within(0.08 * poll))
    for side in (-1.0, 1.0):
        _ear(painting, side * u)
    _mane(painting, hair)
    return painting


def _ear(painting: Painting, u: Floats32) -> None:
    """Paint a pointed ear that leans outwards, dark inside."""
    along = (0.21 - painting.v) / 0.19  # 0 at its root, 1 at its tip
    middle = 0.060 + 0.028 * along
    half = 0.072 * np.sqrt(np.clip(along * (1.0 - along), 0.0, 1.0))
    half *= 1.15 - 0.5 * along
    inside = painting.within((half - np.abs(u - middle)) * (along > 0.0))
    tint = (1.1 - 9.0 * np.abs(u - middle - 0.004))[..., None] * _COAT
    painting.lay(tint, inside * (half > 0.0))
    hollow = painting.within(0.55 * half - np.abs(u - middle - 0.003))
    painting.lay(0.6 * tint, 0.8 * hollow * (half > 0.004))


def _mane(painting: Painting, hair: Floats32) -> None:
    """Paint the mane: strands that fall to the right of the crest."""
    u, v = painting.u, painting.v
    down = np.clip(v - 0.14, 0.0, 2.0)
    edge = 0.012 + 0.16 * down + 0.011 * hair * (0.4 + down)
    start = -0.018 - 0.03 * down + 0.004 * hair
    cut = np.clip((edge - u) * 90.0, 0.0, 1.0) * np.clip((u - start) * 140.0, 0.0, 1.0)
    light = 1.0 + 0.30 * hair + 2.2 * np.clip(0.06 - np.abs(u - 0.03), 0.0, 1.0)
    tint = np.clip(light, 0.2, 3.0)[..., None] * _DARK
    painting.lay(tint, cut * np.clip((v - 0.125) * 40.0, 0.0, 1.0))


def _rein(painting: Painting, u: Floats32) -> None:
    """Paint a rein from the bit up to the hand at the lower edge."""
    v = painting.v
    middle = 0.11 + 0.30 * np.clip((v - 0.28) / 0.75, 0.0, 2.0) ** 0.8
    half = 0.008 + 0.008 * v
    light = 1.0 + 0.7 * np.clip(1.0 - np.abs(u - middle + 0.3 * half) / half, 0.0, 1.0)
    over = painting.within(half - np.abs(u - middle)) * (v > 0.27)
    painting.lay(light[..., None] * _LEATHER, over)


_PAINT = rgb_of(150.0, 34.0, 36.0)
_PLASTIC = rgb_of(40.0, 42.0, 46.0)
_RIM = rgb_of(30.0, 30.0, 33.0)
_LAMP = rgb_of(236.0, 226.0, 190.0)

_WHEEL_V, _RADIUS, _THICKNESS = 1.02, 0.70, 0.055
"""Of the steering wheel: middle, radius and half thickness in shares of the rows."""


def _car(width: int, height: int) -> Painting:
    return Painting(width, height, share=0.40, spare=12)


def dashboard(width: int, height: int) -> Painting:
    """Return everything that does not turn, the wheel's rim with it."""
    painting = _car(width, height)
    u, v, within = painting.u, painting.v, painting.within
    aside = u / (0.5 * width / painting.rows)  # -1 to 1
    # the bonnet, whose far edge is curved; it mirrors a little of the sky
    edge = 0.16 + 0.16 * (aside - 0.22) ** 2
    mirror = 70.0 * np.clip(1.0 - (v - edge) / 0.16, 0.0, 1.0) ** 2
    crease = 16.0 * np.exp(-(((np.abs(aside - 0.22) - 0.45 - 0.3 * v) / 0.02) ** 2))
    tint = _PAINT * (0.72 + 0.5 * (v - edge))[..., None] + (mirror + crease)[..., None]
    painting.lay(tint, within(v - edge))
    # the dashboard, darker towards the driver
    top = 0.36 - 0.10 * np.exp(-((u / 0.52) ** 4)) + 0.05 * aside**2
    sheen = 26.0 * np.exp(-(((v - top) / 0.035) ** 2))
    tint = _PLASTIC * np.clip(1.25 - 0.9 * (v - top), 0.35, 2.0)[..., None]
    painting.lay(tint + sheen[..., None], within(v - top))
    for at in (-0.20, 0.20):
        _dial(painting, u - at, v - 0.56)
    # an air outlet with its slats
    out, down = u - 1.28, v - 0.60
    slats = 0.35 + 0.45 * (np.abs((down / 0.048) % 1.0 - 0.5) < 0.22)
    frame = within(np.minimum(0.26 - np.abs(out), 0.12 - np.abs(down)))
    painting.lay(slats[..., None] * _PLASTIC, frame)
    beyond = np.hypot(u, v - _WHEEL_V) - _RADIUS
    bulge = np.clip(1.0 - (np.abs(beyond) / _THICKNESS) ** 2, 0.0, 1.0)
    glint = np.exp(-(((beyond - 0.018) / 0.012) ** 2)) * np.clip(_WHEEL_V - v, 0.0, 1.0)
    shine = 0.75 + 0.55 * bulge + 1.1 * glint
    painting.lay(shine[..., None] * _RIM, within(_THICKNESS - np.abs(beyond)))
    return painting


def _dial(painting: Painting, u: Floats32, v: Floats32) -> None:
    """Paint a round instrument with ticks and a pointer."""
    within = painting.within
    radius, angle = np.hypot(u, v), np.arctan2(v, u)
    painting.lay(rgb_of(16.0, 18.0, 22.0), within(0.155 - radius))
    painting.lay(0.55 * _LAMP, within(0.006 - np.abs(radius - 0.155)))
    ticks = (np.abs((angle * 8.0 / np.pi + 0.5) % 1.0 - 0.5) < 0.09) & (v < 0.08)
    painting.lay(0.8 * _LAMP, ticks * within(0.010 - np.abs(radius - 0.135)))
    pointer = within(0.006 - np.abs(u * 0.55 + v * 0.83)) * (radius < 0.12) * (u < 0.02)
    painting.lay(rgb_of(226.0, 74.0, 40.0), pointer)


def spokes(width: int, height: int, turned_rad: float) -> tuple[Painting, int]:
    """Return hub, spokes and the mark on the rim, and the column they begin at."""
    painting = _car(width, height)
    columns = np.flatnonzero(np.abs(painting.u[0]) < _RADIUS + _THICKNESS)
    painting.keep_columns(columns)
    # turned to the left the wheel goes counterclockwise for the driver
    x, up, within = painting.u, _WHEEL_V - painting.v, painting.within
    across = x * np.cos(turned_rad) + up * np.sin(turned_rad)
    along = up * np.cos(turned_rad) - x * np.sin(turned_rad)
    radius = np.hypot(across, along)
    inside = np.clip((_RADIUS - _THICKNESS * 0.6 - radius) * painting.rows, 0.0, 1.0)
    bar = 0.07 - np.abs(along + 0.02 - 0.10 * np.clip(np.abs(across) - 0.2, 0, 1))
    post = (0.075 - np.abs(across)) * (along < 0.0)
    tint = (1.15 + 0.4 * np.clip(along, -0.2, 0.3))[..., None] * _RIM
    for shape in (bar, post):
        painting.lay(tint, within(shape) * inside)
    painting.lay((1.5 - 1.2 * radius)[..., None] * _RIM, within(0.24 - radius))
    mark = (np.abs(across) < 0.022) & (along > 0.0)
    on_rim = within(_THICKNESS - np.abs(radius - _RADIUS))
    painting.lay(0.75 * _LAMP, on_rim * mark)
    return painting, int(columns[0])


STEERING_RATIO = 15.0
"""Of the steering wheel to the wheels, as in most cars."""


def _dashboard(width: int, height: int) -> Foreground:
    """Return a dashboard behind a steering wheel that turns."""
    board = Overlay(dashboard(width, height))

    @functools.lru_cache(maxsize=64)
    def turned(degrees: int) -> Overlay:
        return Overlay(*spokes(width, height, float(np.radians(degrees))))

    def lay_over(canvas: Pixels, shake_px: float, steering_rad: float) -> None:
        board.lay_over(canvas, shake_px)
        degrees = 3 * round(np.degrees(STEERING_RATIO * steering_rad) / 3.0)
        turned(degrees).lay_over(canvas, shake_px)

    return lay_over


def make_foreground(
    vehicle: Vehicle, width: int, height: int, rng: np.random.Generator
) -> Foreground | None:
    """The foreground of a camera on a vehicle."""
    if vehicle == "car":
        return _dashboard(width, height)
    if vehicle == "bicycle":
        overlay = Overlay(handlebar(width, height))
    elif vehicle == "horse":
        overlay = Overlay(horse(width, height, rng))
    else:
        return None
    return lambda canvas, shake_px, _steering_rad: overlay.lay_over(canvas, shake_px)
