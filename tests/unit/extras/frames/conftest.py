"""Films of the simulator whose rotation is known, made once."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.extras.rides.catalogue import SCENES
from hapticplayer.extras.rides.film.film import Film
from hapticplayer.extras.rides.film.view import CameraPose
from hapticplayer.media.encode import write_clip
from tests.once import made_once

FRAME_RATE_HZ = 30
SEED = 1

MakeFilm = Callable[..., Path]


def film(scene: str) -> Film:
    return Film(
        SCENES[scene](np.random.default_rng([SEED, 0])), SEED, 320, 180, FRAME_RATE_HZ
    )


@pytest.fixture(scope="session")
def ride_film(tmp_path_factory: pytest.TempPathFactory) -> MakeFilm:
    """Return what writes a part of a ride's film, from a time on."""

    def make(scene: str, begin_s: float, duration_s: float) -> Path:
        first = round(begin_s * FRAME_RATE_HZ)
        last = first + round(duration_s * FRAME_RATE_HZ)

        def write(path: Path) -> None:
            frames = film(scene).frames(first, last)
            write_clip(path, frames, frame_rate_hz=FRAME_RATE_HZ)

        return made_once(tmp_path_factory, f"{scene}-{first}-{last}.mp4", write)

    return make


def turning(rotations: Rotation, position_m: np.ndarray) -> list[np.ndarray]:
    """Draw what a camera sees that only rotates."""
    maker, poses = film("bike").studio()
    made = poses[0].rotation @ rotations.as_matrix()
    return [maker.draw(CameraPose(position_m, matrix, 0.0)) for matrix in made]


@pytest.fixture
def standing_m() -> np.ndarray:
    """Where a ride's camera stands at first."""
    return film("bike").studio()[1][0].position_m
