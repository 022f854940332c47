"""What writes a force in a format and reads it back, for all formats."""

import numpy as np
import pytest

from hapticplayer.model import ForceTrack
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    read_force,
)

RAMP = ForceTrack([0.0, 0.5, 1.0], [[0, 0, 0], [1, 2, -3], [0, 0, 0]])


@pytest.fixture
def written(tmp_path):
    def write(name, track=RAMP, **choices):
        path = tmp_path / f"track{force_formats()[name].suffix}"
        export_track(track, path, force_formats()[name], WriteChoices(**choices))
        return path

    return write


@pytest.fixture
def read(tmp_path):
    def reader(content, suffix, **choices):
        path = tmp_path / f"other{suffix}"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return read_force(path, ReadChoices(**choices))

    return reader


@pytest.fixture
def scripts(shared_data):
    folder = shared_data / "cases" / "funscript-axes"
    if not folder.is_dir():
        pytest.skip("the case funscript-axes is not on this machine")
    return folder


def at(track, *seconds):
    return track.at(np.array(seconds, dtype=float))
