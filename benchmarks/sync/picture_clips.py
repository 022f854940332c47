"""Simulated clips whose log has another clock and mounting, for synchronisation by frames.

Films are kept in the folder for temporary files, because drawing takes longer than all
the rest. A rolling shutter is drawn by turning each row's rays: exact for rotation, and
without the parallax of the milliseconds between rows.
"""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from hapticplayer.capture.mounting import all_mountings, axes_matrix
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.simulation.film.film import Film
from hapticplayer.simulation.film.sound import RATE_HZ, ride_sound
from hapticplayer.simulation.film.view import View
from hapticplayer.simulation.rides.board import PAPER, record
from hapticplayer.simulation.rides.catalogue import RIDES
from hapticplayer.simulation.rides.scenes import Scene

SCENES = ("bike", "horse", "car-turning", "car-braking", "stairs")
RATES_HZ = (200, 30)
FRAME_RATE_HZ = 30
CLIP_S = 28.0  # the standstill with the pats and 22 s of the ride
WIDTH_PX, HEIGHT_PX = 384, 216
_FINER = 2  # drawn in so many times the size: small steps of things in pixels
MOST_READ_OUT_S = 0.03
MOST_OFFSET_S, MOST_DRIFT = 60.0, 80e-6
ASKEW_RAD = np.radians(2.0)
CACHE = Path(tempfile.gettempdir()) / "hapticplayer-films"


@dataclass(frozen=True, slots=True, eq=False)
class PictureClip:
    """A clip on disk and what a logger beside the camera wrote.

    Attributes:
        path: the clip, silent.
        audio: (n, 2) its sound.
        imu: as stored by the logger, in its own frame.
        clock_map: the truth.
        axes: its mounting, as `capture.mounting` names it.
        read_out_s: from the first row to the last.
        duration_s: of the clip.
    """

    path: Path
    audio: NDArray[np.float32]
    imu: ImuLog
    clock_map: ClockMap
    axes: str
    read_out_s: float
    duration_s: float


def picture_clip(
    scene: str, seed: int, rate_hz: int, *, draw: bool = True
) -> PictureClip:
    """Return a seeded clip; the film of both rates is the same, if it is drawn at all."""
    ridden = RIDES[scene](np.random.default_rng([seed, 0]))
    rng = np.random.default_rng([seed, 70])
    duration_s = min(CLIP_S, ridden.duration_s)
    read_out_s = _read_out_s(rng)
    audio = ride_sound(ridden, np.random.default_rng([seed, 4]))
    axes = all_mountings()[int(rng.integers(24))]
    askew = Rotation.from_rotvec(ASKEW_RAD * rng.standard_normal(3)).as_matrix()
    clock = ClockMap(
        float(rng.uniform(-MOST_OFFSET_S, MOST_OFFSET_S)),
        1.0 + float(rng.uniform(-MOST_DRIFT, MOST_DRIFT)),
    )
    return PictureClip(
        film_of(scene, seed) if draw else _film_path(scene, seed, duration_s),
        audio[: round(duration_s * RATE_HZ)],
        _logged(ridden, seed, rate_hz, (axes, askew, clock)),
        clock,
        axes,
        read_out_s,
        duration_s,
    )


def film_of(scene: str, seed: int) -> Path:
    """Return the film of a ride, drawn at the first time."""
    ridden = RIDES[scene](np.random.default_rng([seed, 0]))
    path = _film_path(scene, seed, min(CLIP_S, ridden.duration_s))
    if not path.exists():
        read_out_s = _read_out_s(np.random.default_rng([seed, 70]))
        _write_film(path, ridden, seed, read_out_s)
    return path


def _read_out_s(rng: np.random.Generator) -> float:
    return float(rng.uniform(0.0, MOST_READ_OUT_S))


def _logged(
    ridden: Scene, seed: int, rate_hz: int, lies: tuple[str, Floats, ClockMap]
) -> ImuLog:
    """Return what a board wrote on its own clock and in its own frame."""
    axes, askew, clock = lies
    sensor = (
        PAPER.sensor if rate_hz == 30 else replace(PAPER.sensor, averaged_to_hz=None)
    )
    board = replace(PAPER, sensor=sensor, clock_ppm=0.0, boot_s=(0.0, 0.0), stamp_s=0.0)
    span_s = (-ridden.lead_s, ridden.duration_s + ridden.tail_s)
    log = record(ridden.trajectory, span_s, board, np.random.default_rng([seed, 3]))
    imu, to_media = log.imu, log.clock_map
    own_s = (
        to_media.rate * imu.time_s + to_media.offset_s - clock.offset_s
    ) / clock.rate
    matrix = axes_matrix(axes) @ askew
    return replace(
        imu,
        time_s=np.round(own_s, 3),  # the board's stamps have milliseconds
        specific_force_mps2=imu.specific_force_mps2 @ matrix,
        angular_rate_radps=imu.angular_rate_radps @ matrix,
        magnetic_field_ut=None,
        # its gyro means over the interval around each reading
        sampling=Sampling.AVERAGED,
    )


def _film_path(scene: str, seed: int, duration_s: float) -> Path:
    name = f"{scene}-{seed}-{WIDTH_PX}x{HEIGHT_PX}-{duration_s:g}.mp4"
    return CACHE / name


def _write_film(path: Path, ridden: Scene, seed: int, read_out_s: float) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    size = _FINER * WIDTH_PX, _FINER * HEIGHT_PX
    film = Film(ridden, seed, *size, FRAME_RATE_HZ)
    duration_s = min(CLIP_S, ridden.duration_s)
    frames = _rolling(film, read_out_s, round(duration_s * FRAME_RATE_HZ))
    write_clip(path, frames, frame_rate_hz=FRAME_RATE_HZ, is_quick=True)


def _rolling(film: Film, read_out_s: float, count: int) -> Iterator[NDArray[np.uint8]]:
    """Yield frames whose middle row is of their time, smaller than the film's."""
    fine, view = (
        View.of_size(film.width, film.height),
        View.of_size(WIDTH_PX, HEIGHT_PX),
    )
    later_s = read_out_s * ((np.arange(HEIGHT_PX) + 0.5) / HEIGHT_PX - 0.5)
    rays = np.empty((HEIGHT_PX, WIDTH_PX, 3), np.float32)
    rays[..., 0], rays[..., 1], rays[..., 2] = view.x, 1.0, view.z
    motion = film.scene.trajectory.at(np.arange(count) / film.frame_rate_hz)
    for number, frame in enumerate(film.frames(0, count)):
        angles = later_s[:, None] * motion.angular_rate_radps[number]
        turned = Rotation.from_rotvec(angles).as_matrix().astype(np.float32)
        seen = np.matmul(rays, turned.swapaxes(1, 2))
        scale = np.float32(fine.focal_px) / seen[..., 1]
        across = 0.5 * film.width + scale * seen[..., 0]
        down = 0.5 * film.height - scale * seen[..., 2]
        yield _sampled(frame, across, down)


def _sampled(
    frame: NDArray[np.uint8], across: NDArray[np.float32], down: NDArray[np.float32]
) -> NDArray[np.uint8]:
    """Return the means of four pixels around places, measured from the corner."""
    height, width = frame.shape[:2]
    total = np.zeros((*across.shape, 4), np.uint16)
    pixels = frame.reshape(-1, 4)
    for right in (-0.5, 0.5):
        column = np.clip((across + right).astype(np.int32), 0, width - 1)
        for low in (-0.5, 0.5):
            row = np.clip((down + low).astype(np.int32), 0, height - 1)
            total += pixels[row * width + column]
    return np.asarray(total // 4, np.uint8)
