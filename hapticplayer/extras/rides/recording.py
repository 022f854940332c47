"""Makes recordings of rides whose true motion is known.

The truth is exact (`trajectory`); the log is what a sensor in the camera would have
written: the truth with noise and bias, its gyro integrating between samples. A ride
(`rides`) has a second log, of a board with a clock of its own (`board`).
"""

import os
import secrets
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.recording import Recording
from hapticplayer.errors import Message, entry_named
from hapticplayer.extras.rides.board import PAPER, BoardLog, record
from hapticplayer.extras.rides.catalogue import RIDES, SCENES
from hapticplayer.extras.rides.film.film import Film, SecondPainter
from hapticplayer.extras.rides.film.sound import RATE_HZ, ride_sound
from hapticplayer.extras.rides.scenes import Scene
from hapticplayer.extras.rides.sensors import CAMERA, measure
from hapticplayer.extras.rides.trajectory import Motion
from hapticplayer.model import ClockMap, ImuLog

FRAME_RATE_HZ = 30
WIDTH_PX, HEIGHT_PX = 960, 540
RIDE_WIDTH_PX, RIDE_HEIGHT_PX = 1280, 720
TRUTH_RATE_HZ = 1000

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


def simulate(scene: str, seed: int) -> SimulatedRecording:
    """Ride a scene; the same seed gives the same recording, bit for bit."""
    ridden = entry_named(dict(sorted(SCENES.items())), scene, Message("scene"))(
        np.random.default_rng([seed, 0])
    )
    measured = measure(ridden.trajectory, ridden.duration_s, CAMERA, seed)
    imu = replace(measured.imu, source=f"simulated: {ridden.title}")
    audio = ride_sound(ridden, np.random.default_rng([seed, 4]))
    if scene not in RIDES:
        return SimulatedRecording(ridden, seed, measured.truth, imu, audio)
    times_s = np.arange(round(ridden.duration_s * TRUTH_RATE_HZ) + 1) / TRUTH_RATE_HZ
    span_s = (-ridden.lead_s, ridden.duration_s + ridden.tail_s)
    return SimulatedRecording(
        scene=ridden,
        seed=seed,
        truth=ridden.trajectory.at(times_s),
        imu=imu,
        audio=audio,
        board=record(
            ridden.trajectory, span_s, PAPER, np.random.default_rng([seed, 3])
        ),
        width=RIDE_WIDTH_PX,
        height=RIDE_HEIGHT_PX,
    )


def write_simulated_clip(
    recorded: SimulatedRecording,
    path: str | os.PathLike[str],
    progress: Callable[[float], None] | None = None,
) -> None:
    """Write frames and sound as MP4; `progress` is called with the share, 0 to 1."""
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
    """Write a copy of a clip with the camera's log as a GoPro's telemetry track."""
    from hapticplayer.extras.rides.gpmf_writer import write_payloads
    from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry

    packets = [TelemetryPacket(t, 1.0, p) for t, p in write_payloads(recorded.imu)]
    add_telemetry(clip, path, packets)
