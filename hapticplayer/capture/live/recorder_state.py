"""What a window or a terminal shows of a recording."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.recorded import Gap
from hapticplayer.errors import Message
from hapticplayer.model.arrays import Floats


@dataclass(frozen=True, slots=True, eq=False)
class RecorderState:
    """A recording now.

    Attributes:
        elapsed_s: media time.
        frame: (h, w, 3) uint8 RGB, small; None without a camera.
        level_db: peak of the microphone, full scale is 0; None without one.
        time_s: (n,) media times of the last seconds of the IMU.
        accel_mps2: (n, 3), in frame A as far as its axes are known.
        rate_radps: (n, 3).
        camera_hz: as measured, like `imu_hz`.
        frames: written.
        dropped_frames: missing by their stamps, or broken.
        samples: written.
        dropped_samples: missing by their stamps.
        gaps: the longer ones, of all streams.
        marks_s: media times.
        free_bytes: of the disk.
        notices: what a person should know, in order.
        is_over: nothing is recorded any more, although nobody stopped it.
    """

    elapsed_s: float
    frame: NDArray[np.uint8] | None
    level_db: float | None
    time_s: Floats
    accel_mps2: Floats
    rate_radps: Floats
    camera_hz: float
    imu_hz: float
    frames: int
    dropped_frames: int
    samples: int
    dropped_samples: int
    gaps: tuple[Gap, ...]
    marks_s: tuple[float, ...]
    free_bytes: int
    notices: tuple[Message, ...]
    is_over: bool
