"""The handlebar that the rider sees at the foot of the picture."""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.film.colours import Floats32
from hapticplayer.simulation.film.overlay import Painted

_SHARE = 0.30  # of the picture's height
_STEEL = (58.0, 60.0, 66.0)
_RUBBER = (36.0, 34.0, 36.0)
_SILVER = (176.0, 180.0, 186.0)
_BLACK = (70.0, 72.0, 78.0)
_BRASS = (186.0, 148.0, 74.0)


def handlebar(width: int, height: int) -> Painted:
    """Return the handlebar with its brakes and its bell."""
    rows = round(_SHARE * height)
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
