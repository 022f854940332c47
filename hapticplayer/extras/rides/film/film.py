"""The frames of a simulated ride, all of them or a run that a second process draws.

    python -m hapticplayer.extras.rides.film.film OUT.mp4 SCENE SEED WIDTH HEIGHT RATE FIRST QUICK

writes the frames from number FIRST on, and a line on stdout after each. It ends when
its standard input does: with whoever wanted it.
"""

import contextlib
import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import MediaError
from hapticplayer.extras.rides.film.frame import PictureMaker
from hapticplayer.extras.rides.film.ground import SHAKES_PX
from hapticplayer.extras.rides.film.scenery import Country
from hapticplayer.extras.rides.film.view import CameraPose
from hapticplayer.extras.rides.scenes import Scene
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import rotate

_GROUP_FRAMES, _GROUP_M = 20, 10.0
"""Frames that are drawn together; the ground is painted before them."""

COMMAND = (sys.executable, "-P", "-m", "hapticplayer.extras.rides.film.film")


@dataclass(frozen=True, slots=True)
class Film:
    """What the camera of a ride sees; the seed is that of the country."""

    scene: Scene
    seed: int
    width: int
    height: int
    frame_rate_hz: int

    @property
    def frame_count(self) -> int:
        return round(self.scene.duration_s * self.frame_rate_hz)

    def frames(self, first: int, end: int) -> Iterator[NDArray[np.uint8]]:
        """Yield frames (height, width, 4), RGB and an unused channel, before `end`."""
        maker, poses = self.studio()
        for group in _groups(poses[first:end]):
            travel_m = _apart_m(group[0], group[-1])
            maker.prepare([group[0], group[-1]], 0.5 * travel_m + 0.5)
            for pose in group:
                yield maker.draw(pose)

    def studio(self) -> tuple[PictureMaker, list[CameraPose]]:
        """The painter, and the camera's place for each frame."""
        rng = np.random.default_rng([self.seed, 2])
        country = Country(self.scene, rng)
        return PictureMaker(country, self.width, self.height, rng), self._poses()

    def _poses(self) -> list[CameraPose]:
        time_s = np.arange(self.frame_count) / self.frame_rate_hz
        motion = self.scene.trajectory.at(time_s)
        axes = [
            rotate(motion.quaternion_wxyz, np.broadcast_to(axis, (len(time_s), 3)))
            for axis in np.eye(3)
        ]
        rotations = np.stack(axes, axis=2)
        shakes_px = self._shakes_px(time_s, motion.acceleration_mps2[:, 2])
        steering_rad = np.zeros(len(time_s))
        if self.scene.steering_rad is not None:
            turned = self.scene.steering_rad
            steering_rad = np.interp(time_s, self.scene.route_time_s, turned)
        return [
            CameraPose(*pose)
            for pose in zip(
                motion.position_m, rotations, shakes_px, steering_rad, strict=True
            )
        ]

    def _shakes_px(self, time_s: Floats, upward_mps2: Floats) -> Floats:
        """Return how far what is in front of the camera moves down in the frame."""
        per_mps2 = self.height / 540 * SHAKES_PX[self.scene.vehicle]
        shakes = per_mps2 * upward_mps2
        if self.scene.nod_rad is not None:
            nods = np.interp(time_s, self.scene.route_time_s, self.scene.nod_rad)
            shakes += self.height * nods
        return np.asarray(shakes)


def _groups(poses: list[CameraPose]) -> Iterator[list[CameraPose]]:
    """Yield successive poses that are near enough to share the painted ground."""
    group: list[CameraPose] = []
    for pose in poses:
        is_far = bool(group) and _apart_m(group[0], pose) > _GROUP_M
        if is_far or len(group) == _GROUP_FRAMES:
            yield group
            group = []
        group.append(pose)
    if group:
        yield group


def _apart_m(one: CameraPose, other: CameraPose) -> float:
    return float(np.hypot(*(one.position_m[:2] - other.position_m[:2])))


class SecondPainter:
    """A process that draws and encodes the film from frame `first` on meanwhile."""

    def __init__(self, film: Film, target: Path, first: int, *, is_quick: bool) -> None:
        numbers = (film.seed, film.width, film.height, film.frame_rate_hz, first)
        self.target, self.done = target, 0
        self._count = film.frame_count - first
        self._child = subprocess.Popen(
            [*COMMAND, target, film.scene.name, *map(str, (*numbers, int(is_quick)))],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self._ear = threading.Thread(target=self._listen, name="painter", daemon=True)
        self._ear.start()

    def _listen(self) -> None:
        assert self._child.stdout is not None
        for _line in self._child.stdout:
            self.done += 1

    def is_busy(self, patience_s: float) -> bool:
        """Whether it still draws after some waiting."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._child.wait(patience_s)
        return self._child.poll() is None

    def check(self) -> None:
        """Raise MediaError unless it has drawn everything."""
        self._ear.join()
        if self._child.returncode or self.done < self._count:
            assert self._child.stderr is not None
            last_words = (
                self._child.stderr.read().decode("utf-8", "replace").split("\n")
            )
            raise MediaError(
                "the second half could not be drawn ({reason})",
                where=str(self.target.parent),
                remedy="free some memory and disk, and try again",
                reason=last_words[-2:][0][:200],
            )

    def close(self) -> None:
        """End it."""
        self._child.kill()
        self._child.communicate()
        self._ear.join()


def main(arguments: list[str]) -> int:
    """Draw what was asked for."""
    from hapticplayer.extras.rides.catalogue import SCENES
    from hapticplayer.media.encode import write_clip

    target, scene = Path(arguments[0]), arguments[1]
    seed, width, height, rate_hz, first, is_quick = map(int, arguments[2:])
    threading.Thread(target=_end_with_parent, daemon=True).start()
    film = Film(
        SCENES[scene](np.random.default_rng([seed, 0])), seed, width, height, rate_hz
    )
    write_clip(
        target,
        film.frames(first, film.frame_count),
        frame_rate_hz=rate_hz,
        is_quick=bool(is_quick),
        progress=lambda _seconds: _tell(),
    )
    return 0


def _tell() -> None:
    sys.stdout.write("\n")
    sys.stdout.flush()


def _end_with_parent() -> None:
    os.read(sys.stdin.fileno(), 1)  # a buffered reader would hold its lock at the end
    os._exit(1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
