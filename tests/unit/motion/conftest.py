"""Recordings of real sensors, most of them with the optical truth of their vertical."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model import quaternions as quat

# by how many samples the truth is read later than the sample: README of the data
TRUTH_LATER_SAMPLES = {"broad": -0.65, "tumvi": 0.48, "tyrex": 0.47}
OPTICAL = tuple(TRUTH_LATER_SAMPLES)
GAP = "tyrex_Guillaume_Nexus5_NoDist_AR"  # 23.7 s without gyro: in no mean


@dataclass(frozen=True)
class Optical:
    """A log, its truth, and the samples that count: none where no truth is known.

    Attributes:
        name: of the file.
        log: in the sensor frame.
        attitude: (N, 4) as optics measured it, not shifted.
        up: (N, 3) the vertical in the sensor frame for what each sample stands for.
        counted: (N,).
    """

    name: str
    log: ImuLog
    attitude: NDArray[np.float64]
    up: NDArray[np.float64]
    counted: NDArray[np.bool_]


def read_log(path: Path, seconds: float | None = None) -> ImuLog:
    """Return a recording, or its first seconds, at its own rate."""
    with np.load(path) as held:
        count = len(held["acc"])
        is_averaged = "up_avg" in held
        time_s = (np.arange(count) + 0.5 * is_averaged) / held["rate"]
        if "t" in held and not is_averaged:
            time_s = np.asarray(held["t"], dtype=np.float64) - held["t"][0]
        stop = count if seconds is None else int(np.searchsorted(time_s, seconds))
        field = held["mag"].astype(float)[:stop] if "mag" in held else None
        return ImuLog(
            time_s[:stop],
            held["acc"].astype(float)[:stop],
            held["gyr"].astype(float)[:stop],
            magnetic_field_ut=field,
            sampling=Sampling.AVERAGED if is_averaged else Sampling.INSTANT,
            source=path.stem,
        )


def read_optical(path: Path) -> Optical:
    """Return a recording with its truth."""
    log = read_log(path)
    with np.load(path) as held:
        counted = held["mov"].astype(bool)
        attitude = quat.normalized(held["quat"].astype(float))
        if log.sampling is Sampling.AVERAGED:
            up = held["up_avg"].astype(float)
        else:
            later = TRUTH_LATER_SAMPLES[path.name.split("_")[0]]
            up = _later(quat.vertical(attitude), later)
    counted &= np.isfinite(up).all(axis=1)
    return Optical(path.stem, log, attitude, up, counted)


def _later(up, samples):
    at = np.arange(len(up)) + samples
    low = np.clip(np.floor(at).astype(int), 0, len(up) - 2)
    share = (at - low)[:, None]
    between = (1.0 - share) * up[low] + share * up[low + 1]
    between[(at < 0) | (at > len(up) - 1)] = np.nan
    return between / np.linalg.norm(between, axis=1, keepdims=True)


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

    def load(family: str) -> list[Optical]:
        name, _, rate = family.partition(" ")
        folder = "native" if rate == "native" else "averaged_30hz"
        paths = sorted((shared_data / "orientation" / folder).glob(f"{name}_*.npz"))
        return [read_optical(path) for path in paths if path.stem != GAP]

    return load
