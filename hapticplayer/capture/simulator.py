"""Makes recordings of rides whose true motion is known.

The truth is exact (`trajectory`); the log is what a sensor in the camera would have
written: the truth with noise and bias, its gyro integrating between samples.
"""

import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.recording import Recording
from hapticplayer.capture.ride.picture import PictureMaker
from hapticplayer.capture.ride.scenery import Country
from hapticplayer.capture.ride.sound import RATE_HZ, ride_sound
from hapticplayer.capture.ride.view import Pose
from hapticplayer.capture.scenes import SCENES, Scene
from hapticplayer.capture.trajectory import Motion
from hapticplayer.errors import UsageError
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import rotate

IMU_RATE_HZ = 200
FRAME_RATE_HZ = 30
WIDTH_PX, HEIGHT_PX = 960, 540

_FORCE_NOISE_MPS2 = 0.035  # per sample at 200 Hz; a camera's sensor, better than 0.065
_FORCE_BIAS_MPS2 = 0.04  # SD per axis, what a factory calibration leaves
_RATE_NOISE_RADPS = 0.003
_RATE_BIAS_RADPS = 0.004


@dataclass(frozen=True, slots=True, eq=False)
class SimulatedRecording:
    """A recording with its truth.

    Time 0 of truth, log, sound and pictures is the first picture.

    Attributes:
        scene: what was ridden.
        seed: of everything random in it.
        truth: exact motion at the log's times.
        imu: the log, with noise and bias: specific force as it is at each time,
            angular rate as the mean over the interval that ends there.
        audio: (n, 2) float32.
        audio_rate_hz: of the sound.
        frame_rate_hz: of the pictures.
        width: of the pictures, px.
        height: of the pictures, px.
    """

    scene: Scene
    seed: int
    truth: Motion
    imu: ImuLog
    audio: NDArray[np.float32]
    audio_rate_hz: int = RATE_HZ
    frame_rate_hz: int = FRAME_RATE_HZ
    width: int = WIDTH_PX
    height: int = HEIGHT_PX

    @property
    def frame_count(self) -> int:
        """How many pictures there are."""
        return round(self.scene.duration_s * self.frame_rate_hz)

    def frames(self) -> Iterator[NDArray[np.uint8]]:
        """Yield the pictures (height, width, 3) RGB, drawn one by one."""
        maker, poses = self._studio()
        for pose in poses:
            yield maker.draw(pose)

    def frame(self, number: int) -> NDArray[np.uint8]:
        """Return one picture; for screenshots."""
        maker, poses = self._studio()
        return maker.draw(poses[number])

    def _studio(self) -> tuple[PictureMaker, list[Pose]]:
        rng = np.random.default_rng([self.seed, 2])
        country = Country(self.scene, rng)
        maker = PictureMaker(country, self.width, self.height, rng)
        return maker, self._poses()

    def _poses(self) -> list[Pose]:
        time_s = np.arange(self.frame_count) / self.frame_rate_hz
        motion = self.scene.trajectory.at(time_s)
        axes = [
            rotate(motion.quaternion_wxyz, np.broadcast_to(axis, (len(time_s), 3)))
            for axis in np.eye(3)
        ]
        rotations = np.stack(axes, axis=2)
        # the arms give way by a few millimetres: 1.2 px for each m/s2 upwards
        shakes_px = 1.2 * motion.acceleration_mps2[:, 2]
        return [
            Pose(*pose)
            for pose in zip(motion.position_m, rotations, shakes_px, strict=True)
        ]

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
            "acceleration_mps2",
            "specific_force_mps2",
            "angular_rate_radps",
            "quaternion_wxyz",
        )
        return {name: getattr(self.truth, name) for name in names}


def simulate(scene: str, seed: int) -> SimulatedRecording:
    """Ride a scene.

    Args:
        scene: a name in SCENES.
        seed: the same seed gives the same recording, bit for bit.

    Raises:
        UsageError: for a scene that does not exist.
    """
    if scene not in SCENES:
        raise UsageError(
            f"there is no scene {scene!r}; choose one of {', '.join(sorted(SCENES))}"
        )
    ridden = SCENES[scene](np.random.default_rng([seed, 0]))
    time_s = np.arange(round(ridden.duration_s * IMU_RATE_HZ) + 1) / IMU_RATE_HZ
    truth = ridden.trajectory.at(time_s)
    rng = np.random.default_rng([seed, 1])
    return SimulatedRecording(
        scene=ridden,
        seed=seed,
        truth=truth,
        imu=_measure(ridden, truth, rng),
        audio=ride_sound(ridden, rng),
    )


def _measure(scene: Scene, truth: Motion, rng: np.random.Generator) -> ImuLog:
    """Return what a sensor in the camera logs."""
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
    """Write pictures and sound as MP4.

    Args:
        recorded: from `simulate`.
        path: of the clip.
        progress: called with the done fraction, 0 to 1; raises Cancelled to stop.

    Raises:
        MediaError: when the clip cannot be written.
    """
    from hapticplayer.media import write_clip

    duration_s = recorded.scene.duration_s
    write_clip(
        path,
        recorded.frames(),
        frame_rate_hz=recorded.frame_rate_hz,
        audio=recorded.audio,
        audio_rate_hz=recorded.audio_rate_hz,
        progress=(lambda s: progress(min(1.0, s / duration_s))) if progress else None,
    )
