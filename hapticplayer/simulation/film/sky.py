"""Sky, fair-weather clouds and two ridges of hills."""

import numpy as np
from scipy.ndimage import gaussian_filter

from hapticplayer.simulation.film.colours import (
    WHITE,
    Floats32,
    Pixels,
    colour,
    mixed,
    packed,
)
from hapticplayer.simulation.film.view import View

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

    def draw(self, canvas: Pixels, view: View, rotation: Floats32) -> None:
        """Paint all rows that reach above the horizon.

        Args:
            canvas: packed colours, the upper rows are overwritten.
            view: of the canvas.
            rotation: (3, 3) sensor to earth.
        """
        above = np.flatnonzero(view.edges(rotation[2]).max(axis=1) > 0.0)
        rows = min(len(canvas), int(above[-1]) + 3 if len(above) else 0)
        if not rows:
            return
        coarse = View(view.x[:, ::2], view.z[:rows:2], view.focal_px)
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

    def _cloud_cover(self, view: View, rotation: Floats32, up: Floats32) -> Pixels:
        reach = _CLOUD_HEIGHT_CELLS / np.maximum(up, np.float32(_LOWEST_CLOUD))
        east = (view.towards(rotation[0]) * reach).astype(np.int32) & (_TILE - 1)
        north = (view.towards(rotation[1]) * reach).astype(np.int32) & (_TILE - 1)
        cover = self._clouds[north, east]
        return np.asarray(np.where(up > _LOWEST_CLOUD, cover, np.uint32(0)))


def _azimuth_column(
    view: View, rotation: Floats32
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
    """Return the rise of a ridge by azimuth."""
    noise = gaussian_filter(rng.standard_normal(_AZIMUTHS), roughness, mode="wrap")
    shape = height * (0.62 + 0.38 * noise / np.abs(noise).max())
    return np.asarray(shape.astype(np.float32))
