"""Simulated clips whose log has another clock and mounting, for synchronisation by frames.

Drawing a film takes longer than all the rest: many logs are made of one ride. A rolling
shutter is drawn by turning each row's rays: exact for rotation, and without the parallax
of the milliseconds between rows. Films are encoded as finely as a camera's own file is
when it is scaled down to so few pixels; coarser ones leave still what moves by a tenth of
a pixel. They are kept until the process ends.
"""

import functools
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfiltfilt
from scipy.spatial.transform import Rotation

from hapticplayer.capture.mounting import all_mountings, axes_matrix
from hapticplayer.extras.rides.board import PAPER, record
from hapticplayer.extras.rides.catalogue import RIDES
from hapticplayer.extras.rides.film.film import Film
from hapticplayer.extras.rides.film.sound import RATE_HZ, ride_sound
from hapticplayer.extras.rides.film.view import CameraRays
from hapticplayer.extras.rides.scenes import Scene
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.model.arrays import Floats

SCENES = ("bike", "horse", "car-turning", "car-braking", "stairs", "stroll")
RATES_HZ = (200, 30)
FRAME_RATE_HZ = 30
CLIP_S = 28.0  # the standstill with the pats and 22 s of the ride
WIDTH_PX, HEIGHT_PX = 384, 216
_FINER = 2  # drawn in so many times the size: small steps of things in pixels
MOST_READ_OUT_S = 0.03
MOST_OFFSET_S, MOST_DRIFT = 60.0, 80e-6
ASKEW_RAD = np.radians(2.0)
_RATE_FACTOR = 8.0  # of x264: 4 Mbit/s here
_ZOOM = 1.15  # of a stabilised film, so that its edges are rarely seen
_STEADY_HZ = 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Filmed:
    """A ride and its film.

    Attributes:
        scene: its name.
        seed: of ride and film.
        ridden: the truth.
        path: the film, silent.
        audio: (n, 2) its sound.
        read_out_s: from the first row to the last.
        duration_s: of the film.
    """

    scene: str
    seed: int
    ridden: Scene
    path: Path
    audio: NDArray[np.float32]
    read_out_s: float
    duration_s: float


@dataclass(frozen=True, slots=True, eq=False)
class Logged:
    """What a logger beside the camera wrote.

    Attributes:
        imu: as stored, in its own frame.
        clock_map: the truth.
        axes: its mounting, as `capture.mounting` names it.
    """

    imu: ImuLog
    clock_map: ClockMap
    axes: str


@functools.cache
def _folder() -> tempfile.TemporaryDirectory[str]:
    return tempfile.TemporaryDirectory(prefix="hapticplayer-films-")


def ride_of(scene: str, seed: int) -> Scene:
    return RIDES[scene](np.random.default_rng([seed, 0]))


def filmed(scene: str, seed: int) -> Filmed:
    """Return a seeded ride with its film and sound."""
    ridden = ride_of(scene, seed)
    duration_s = min(CLIP_S, ridden.duration_s)
    audio = ride_sound(ridden, np.random.default_rng([seed, 4]))
    return Filmed(
        scene,
        seed,
        ridden,
        film_of(scene, seed),
        audio[: round(duration_s * RATE_HZ)],
        _read_out_s(seed),
        duration_s,
    )


def film_of(scene: str, seed: int) -> Path:
    """Return the film of a ride, drawn at the first time."""
    path = Path(_folder().name) / f"{scene}-{seed}.mp4"
    if not path.exists():
        _write_film(path, ride_of(scene, seed), seed, _read_out_s(seed))
    return path


def _read_out_s(seed: int) -> float:
    return float(np.random.default_rng([seed, 70]).uniform(0.0, MOST_READ_OUT_S))


def logged(ridden: Scene, seeds: tuple[int, int], rate_hz: int) -> Logged:
    """A logger's file of a ride: clock, mounting and noise by the seeds."""
    rng = np.random.default_rng([*seeds, 71])
    axes = all_mountings()[int(rng.integers(24))]
    askew = Rotation.from_rotvec(ASKEW_RAD * rng.standard_normal(3)).as_matrix()
    clock = ClockMap(
        float(rng.uniform(-MOST_OFFSET_S, MOST_OFFSET_S)),
        1.0 + float(rng.uniform(-MOST_DRIFT, MOST_DRIFT)),
    )
    return Logged(_imu(ridden, rng, rate_hz, (axes, askew, clock)), clock, axes)


def _imu(
    ridden: Scene,
    rng: np.random.Generator,
    rate_hz: int,
    lies: tuple[str, Floats, ClockMap],
) -> ImuLog:
    """A board's log on its own clock and in its own frame."""
    axes, askew, clock = lies
    sensor = (
        PAPER.sensor if rate_hz == 30 else replace(PAPER.sensor, averaged_to_hz=None)
    )
    board = replace(PAPER, sensor=sensor, clock_ppm=0.0, boot_s=(0.0, 0.0), stamp_s=0.0)
    span_s = (-ridden.lead_s, ridden.duration_s + ridden.tail_s)
    log = record(ridden.trajectory, span_s, board, rng)
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


def _write_film(path: Path, ridden: Scene, seed: int, read_out_s: float) -> None:
    size = _FINER * WIDTH_PX, _FINER * HEIGHT_PX
    film = Film(ridden, seed, *size, FRAME_RATE_HZ)
    duration_s = min(CLIP_S, ridden.duration_s)
    frames = _rolling(film, read_out_s, round(duration_s * FRAME_RATE_HZ))
    _write(path, frames)


def _write(path: Path, frames: Iterable[NDArray[np.uint8]]) -> None:
    write_clip(
        path, frames, frame_rate_hz=FRAME_RATE_HZ, is_quick=True,
        rate_factor=_RATE_FACTOR,
    )  # fmt: skip


def stabilised(film: Filmed) -> Path:
    """Return the film as a camera's stabiliser would have left it: only slow turns stay."""
    path = film.path.with_name(f"{film.path.stem}-stabilised.mp4")
    _write(path, _steadied(film))
    return path


def _steadied(film: Filmed) -> Iterator[NDArray[np.uint8]]:
    view = CameraRays.of_size(WIDTH_PX, HEIGHT_PX)
    rays = np.empty((HEIGHT_PX, WIDTH_PX, 3), np.float32)
    rays[..., 0], rays[..., 1], rays[..., 2] = view.x / _ZOOM, 1.0, view.z / _ZOOM
    for frame, matrix in zip(_pixels(film.path), _to_camera(film), strict=False):
        seen = rays @ matrix.astype(np.float32).T
        scale = np.float32(view.focal_px) / seen[..., 1]
        across = 0.5 * WIDTH_PX + scale * seen[..., 0]
        yield _sampled(frame, across, 0.5 * HEIGHT_PX - scale * seen[..., 2])


def _to_camera(film: Filmed) -> Floats:
    """Return for each frame the rotation from the steadied camera to the real one."""
    count = round(film.duration_s * FRAME_RATE_HZ)
    motion = film.ridden.trajectory.at(np.arange(count) / FRAME_RATE_HZ)
    turned = Rotation.from_quat(motion.quaternion_wxyz[:, [1, 2, 3, 0]])
    first = turned[0]
    angles = np.unwrap((first.inv() * turned).as_euler("zxy"), axis=0)
    sos = butter(2, _STEADY_HZ, fs=FRAME_RATE_HZ, output="sos")
    steady = first * Rotation.from_euler("zxy", sosfiltfilt(sos, angles, axis=0))
    return np.asarray((turned.inv() * steady).as_matrix())


def _pixels(path: Path) -> Iterator[NDArray[np.uint8]]:
    converter = FrameConverter()
    with VideoDecoder(path) as decoder:
        for frame in decoder.frames():
            rgb = converter.convert(frame, WIDTH_PX, HEIGHT_PX).as_rgb()
            yield np.dstack([rgb, rgb[..., :1]])


def still(film: Filmed, rng: np.random.Generator) -> Path:
    """Return a film of one frame and the noise of a sensor."""
    path = film.path.with_name(f"{film.path.stem}-still.mp4")
    first = next(_pixels(film.path)).astype(np.float32)
    noisy = (
        np.clip(first + 2.0 * rng.standard_normal(first.shape), 0, 255).astype(np.uint8)
        for _ in range(round(film.duration_s * FRAME_RATE_HZ))
    )
    _write(path, noisy)
    return path


def _rolling(film: Film, read_out_s: float, count: int) -> Iterator[NDArray[np.uint8]]:
    """Yield frames whose middle row is of their time, smaller than the film's."""
    fine, view = (
        CameraRays.of_size(film.width, film.height),
        CameraRays.of_size(WIDTH_PX, HEIGHT_PX),
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
