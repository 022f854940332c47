"""A small recording, and the sequence that it makes."""

import numpy as np
import pytest

from hapticplayer.capture.recording import Recording
from hapticplayer.media import probe, write_clip
from hapticplayer.model import ClockMap
from hapticplayer.sequence.build import Choices, write_sequence


@pytest.fixture(scope="session")
def tiny_clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "ride.mp4"
    grey = (np.full((36, 64, 3), 40 + 2 * k, dtype=np.uint8) for k in range(60))
    write_clip(path, grey, frame_rate_hz=30)
    return probe(path)


@pytest.fixture
def recording(still_log):
    return Recording(still_log, ClockMap(offset_s=0.5), "test camera", ("a note",), {})


@pytest.fixture
def sequence_folder(tmp_path, tiny_clip, recording):
    return write_sequence(
        tiny_clip, recording, tmp_path / "ride", choices=Choices(title="Ride", seed=5)
    )
