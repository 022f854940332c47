"""Recordings of real sensors with the optical truth of their vertical, and offlineVQF."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model import quaternions as quat

# by how many samples the truth is read later than the sample: README of the data
TRUTH_LATER_SAMPLES = {"broad": -0.65, "tumvi": 0.48, "tyrex": 0.47, "repoimu": 0.47}
OPTICAL = ("broad", "tumvi", "tyrex", "repoimu_TStick", "repoimu_Pendulum")
GAP = "tyrex_Guillaume_Nexus5_NoDist_AR"  # 23.7 s without gyro: in no mean


@dataclass(frozen=True)
class OpticalRecording:
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


def read_optical(path: Path) -> OpticalRecording:
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
    return OpticalRecording(path.stem, log, attitude, up, counted)


def _later(up, samples):
    at = np.arange(len(up)) + samples
    low = np.clip(np.floor(at).astype(int), 0, len(up) - 2)
    share = (at - low)[:, None]
    between = (1.0 - share) * up[low] + share * up[low + 1]
    between[(at < 0) | (at > len(up) - 1)] = np.nan
    return between / np.linalg.norm(between, axis=1, keepdims=True)


def offline_vqf_up(log: ImuLog, *, tau_s: float = 3.0) -> NDArray[np.float64]:
    """Return offlineVQF's vertical (N, 3); half a window back for averaged samples."""
    from vqf import offlineVQF

    answer = offlineVQF(
        np.array(log.angular_rate_radps),
        np.array(log.specific_force_mps2),
        None,
        1.0 / log.rate_hz,
        {"tauAcc": tau_s},
    )
    attitude = answer["quat6D"]
    if log.sampling is Sampling.AVERAGED:
        half = quat.from_rotation_vector(-0.5 / log.rate_hz * log.angular_rate_radps)
        attitude = quat.multiply(attitude, half)
    return quat.vertical(attitude)
