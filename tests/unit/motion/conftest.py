"""Recordings of real sensors, most of them with the optical truth of their vertical."""

import pytest

from hapticplayer.model import ImuLog
from tools.optical import GAP, OpticalRecording, read_log, read_optical


@pytest.fixture
def recording(shared_data):
    """Load a log at its native rate by the beginning of its name."""

    def load(name: str, seconds: float | None = None) -> ImuLog:
        (path,) = (shared_data / "orientation" / "native").glob(f"{name}*.npz")
        return read_log(path, seconds)

    return load


@pytest.fixture(scope="session")
def optical(shared_data):
    """Load all recordings of one family, "broad native" or "tyrex 30 Hz"."""

    def load(family: str) -> list[OpticalRecording]:
        name, _, rate = family.partition(" ")
        folder = "native" if rate == "native" else "averaged_30hz"
        paths = sorted((shared_data / "orientation" / folder).glob(f"{name}_*.npz"))
        return [read_optical(path) for path in paths if path.stem != GAP]

    return load
