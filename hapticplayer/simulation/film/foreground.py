"""What the camera has right in front of it: handlebar, horse, dashboard or nothing."""

import functools
from typing import Protocol

import numpy as np

from hapticplayer.simulation.film.colours import Pixels
from hapticplayer.simulation.film.dashboard import dashboard, spokes
from hapticplayer.simulation.film.handlebar import handlebar
from hapticplayer.simulation.film.horse import horse
from hapticplayer.simulation.film.overlay import Overlay
from hapticplayer.simulation.rides.scenes import Vehicle

STEERING_RATIO = 15.0
"""Of the steering wheel to the wheels, as in most cars."""


class Foreground(Protocol):
    """Is laid over each picture."""

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
