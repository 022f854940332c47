"""A clip whose sensor is shaken up and down, for what needs any sequence."""

from pathlib import Path

import numpy as np

from hapticplayer.capture.recording import Recording
from hapticplayer.media.clip_info import probe
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.sequence.build import Choices, write_sequence

RATE_HZ, SIZE_MPS2 = 200, 3.0


def write_shaken_sequence(
    clip: Path, folder: Path, *, shake_hz: float = 2.0, title: str = "shake"
) -> Path:
    """Write the sequence of a clip into a new folder, and return it."""
    info = probe(clip)
    time_s = np.arange(0.0, info.duration_s, 1 / RATE_HZ)
    force = np.zeros((len(time_s), 3))
    shaken = SIZE_MPS2 * np.sin(2 * np.pi * shake_hz * time_s)
    force[:, 2] = STANDARD_GRAVITY_MPS2 + shaken
    log = ImuLog(time_s, force, np.zeros_like(force), source="shake")
    recording = Recording(log, ClockMap(), "test camera")
    choices = Choices(title=title, seed=1)
    return write_sequence(info, recording, folder, choices=choices)
