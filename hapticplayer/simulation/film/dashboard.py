"""A car's bonnet, dashboard and steering wheel, seen by its driver."""

import numpy as np

from hapticplayer.simulation.film.colours import Floats32
from hapticplayer.simulation.film.overlay import Painted, lay, within

_SHARE = 0.40  # of the picture's height
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
    rows = round(_SHARE * height)
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
