"""Makes recordings of rides whose true motion is known.

The truth is exact (`trajectory`); the log is what a sensor in the camera would have
written: the truth with noise and bias, its gyro integrating between samples. A ride
(`rides`) has a second log, of a board with a clock of its own (`board`).
"""

import os
import secrets
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.recording import Recording
from hapticplayer.errors import UsageError
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.simulation.film.film import Film, SecondPainter
from hapticplayer.simulation.film.sound import RATE_HZ, ride_sound
from hapticplayer.simulation.rides.board import PAPER, BoardLog, record
from hapticplayer.simulation.rides.catalogue import RIDES, SCENES
from hapticplayer.simulation.rides.scenes import Scene
from hapticplayer.simulation.rides.trajectory import Motion

IMU_RATE_HZ = 200
FRAME_RATE_HZ = 30
WIDTH_PX, HEIGHT_PX = 960, 540
RIDE_WIDTH_PX, RIDE_HEIGHT_PX = 1280, 720
TRUTH_RATE_HZ = 1000

_FORCE_NOISE_MPS2 = 0.035  # per sample at 200 Hz; a camera's sensor, better than 0.065
_FORCE_BIAS_MPS2 = 0.04  # SD per axis, what a factory calibration leaves
_RATE_NOISE_RADPS = 0.003
_RATE_BIAS_RADPS = 0.004

WORTH_PX = 150_000_000
"""So many pixels are drawn by two processes; the second has to load what it needs."""

_LOOK_S = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class SimulatedRecording:
    """A recording with its truth.

    Time 0 of truth, log, sound and frames is the first frame.

    Attributes:
        truth: exact motion at the log's times; of a ride, every millisecond.
        imu: the log, with noise and bias: specific force as it is at each time,
            angular rate as the mean over the interval that ends there.
        audio: (n, 2) float32.
        board: what a board with its own clock logged; None in the demo.
    """

    scene: Scene
    seed: int
    truth: Motion
    imu: ImuLog
    audio: NDArray[np.float32]
    board: BoardLog | None = None
    audio_rate_hz: int = RATE_HZ
    frame_rate_hz: int = FRAME_RATE_HZ
    width: int = WIDTH_PX
    height: int = HEIGHT_PX

    @property
    def film(self) -> Film:
        """Its frames."""
        return Film(self.scene, self.seed, self.width, self.height, self.frame_rate_hz)

    def frame(self, number: int) -> NDArray[np.uint8]:
        """Return one frame (height, width, 3) RGB; for screenshots."""
        maker, poses = self.film.studio()
        return np.ascontiguousarray(maker.draw(poses[number])[:, :, :3])

    def recording(self) -> Recording:
        """Return the log as an importer sees it; the clocks are one."""
        return Recording(
            imu=self.imu,
            clock_map=ClockMap(),
            camera="simulated camera",
            provenance={
                "reader": "simulator",
                "scene": self.scene.name,
                "seed": self.seed,
            },
        )

    def truth_arrays(self) -> dict[str, Any]:
        """Return the truth as arrays by name, for a `.npz`."""
        names = (
            "time_s",
            "position_m",
            "velocity_mps",
            "acceleration_mps2",
            "specific_force_mps2",
            "angular_rate_radps",
            "quaternion_wxyz",
        )
        return {name: getattr(self.truth, name) for name in names}


def simulate(scene: str, seed: int) -> SimulatedRecording:
    """Ride a scene; the same seed gives the same recording, bit for bit.

    Raises:
        UsageError: for a scene that does not exist.
    """
    if scene not in SCENES:
        raise UsageError(
            "there is no scene {scene!r}; choose one of {known}",
            scene=scene,
            known=", ".join(sorted(SCENES)),
        )
    ridden = SCENES[scene](np.random.default_rng([seed, 0]))
    rng = np.random.default_rng([seed, 1])
    imu = _measure(ridden, rng)
    audio = ride_sound(ridden, rng)
    if scene not in RIDES:
        truth = ridden.trajectory.at(imu.time_s)
        return SimulatedRecording(ridden, seed, truth, imu, audio)
    span_s = (-ridden.lead_s, ridden.duration_s + ridden.tail_s)
    return SimulatedRecording(
        scene=ridden,
        seed=seed,
        truth=ridden.trajectory.at(_times(ridden.duration_s, TRUTH_RATE_HZ)),
        imu=imu,
        audio=audio,
        board=record(
            ridden.trajectory, span_s, PAPER, np.random.default_rng([seed, 3])
        ),
        width=RIDE_WIDTH_PX,
        height=RIDE_HEIGHT_PX,
    )


def _times(duration_s: float, rate_hz: float) -> Floats:
    return np.asarray(np.arange(round(duration_s * rate_hz) + 1) / rate_hz)


def _measure(scene: Scene, rng: np.random.Generator) -> ImuLog:
    """Return what a sensor in the camera logs."""
    truth = scene.trajectory.at(_times(scene.duration_s, IMU_RATE_HZ))
    mean_rate = scene.trajectory.mean_rate_radps(truth.time_s, 1.0 / IMU_RATE_HZ)
    return ImuLog(
        time_s=truth.time_s,
        specific_force_mps2=_disturbed(
            truth.specific_force_mps2, _FORCE_NOISE_MPS2, _FORCE_BIAS_MPS2, rng
        ),
        angular_rate_radps=_disturbed(
            mean_rate, _RATE_NOISE_RADPS, _RATE_BIAS_RADPS, rng
        ),
        sampling=Sampling.INSTANT,
        source=f"simulated: {scene.title}",
    )


def _disturbed(
    values: Floats, noise: float, bias: float, rng: np.random.Generator
) -> Floats:
    offset = rng.normal(0.0, bias, values.shape[1])
    return values + offset + rng.normal(0.0, noise, values.shape)


def write_simulated_clip(
    recorded: SimulatedRecording,
    path: str | os.PathLike[str],
    progress: Callable[[float], None] | None = None,
) -> None:
    """Write frames and sound as MP4; `progress` is called with the share, 0 to 1.

    Raises:
        MediaError: when the clip cannot be written.
    """
    from hapticplayer.media.encode import key_frame_interval

    film, is_quick = recorded.film, recorded.board is not None
    count = film.frame_count
    report = progress or (lambda _share: None)
    if count * film.width * film.height < WORTH_PX:
        first = film.frames(0, count)
        _write(recorded, path, first, is_quick, lambda drawn: report(drawn / count))
        return
    interval = key_frame_interval(film.frame_rate_hz)
    half = -(-count // (2 * interval)) * interval
    target = Path(path)
    rest = target.with_name(f".{target.stem}.{secrets.token_hex(4)}.rest.mp4")
    second = SecondPainter(film, rest, half, is_quick=is_quick)

    def tell_both(drawn: int) -> None:
        report(min(1.0, (min(drawn, half) + second.done) / count))

    def waited_for() -> Path:
        while second.is_busy(_LOOK_S):
            tell_both(half)
        second.check()
        return rest

    try:
        first = film.frames(0, half)
        _write(recorded, path, first, is_quick, tell_both, waited_for)
    finally:
        second.close()
        rest.unlink(missing_ok=True)


def _write(
    recorded: SimulatedRecording,
    path: str | os.PathLike[str],
    frames: Iterator[NDArray[np.uint8]],
    is_quick: bool,
    report: Callable[[int], None],
    rest: Callable[[], Path] | None = None,
) -> None:
    from hapticplayer.media.encode import write_clip

    write_clip(
        path,
        frames,
        frame_rate_hz=recorded.frame_rate_hz,
        audio=recorded.audio,
        audio_rate_hz=recorded.audio_rate_hz,
        is_quick=is_quick,
        progress=lambda s: report(round(s * recorded.frame_rate_hz)),
        rest=rest,
    )


def write_gopro_clip(
    recorded: SimulatedRecording,
    clip: str | os.PathLike[str],
    path: str | os.PathLike[str],
) -> None:
    """Write a copy of a clip with the camera's log as a GoPro's telemetry track.

    Raises:
        MediaError: when it cannot be written.
    """
    from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry
    from hapticplayer.simulation.rides.gpmf_writer import write_payloads

    packets = [TelemetryPacket(t, 1.0, p) for t, p in write_payloads(recorded.imu)]
    add_telemetry(clip, path, packets)
