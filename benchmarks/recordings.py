"""Recordings with a known vertical: what every motion benchmark measures against.

`python benchmarks/recordings.py` prints what they hold and how good the car's truth
is, beside offlineVQF's error on each.
"""

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from comma import car_imu, car_truth, print_agreement
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.simulation.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.simulation.rides.sensors import SensorModel

Floats = NDArray[np.float64]

DATA = Path(__file__).resolve().parents[2] / "shared" / "data"
GRAVITY_MPS2 = 9.81  # of the error figures, as the field reports them
HOLE = "tyrex_Guillaume_Nexus5_NoDist_AR"  # 23.7 s without gyro: not in the means

# by how many native samples the truth is read later than the sample (README of the
# data: BROAD's optical truth fits best 2.3 ms earlier, the others half a sample later)
_TRUTH_LATER_SAMPLES = {"broad": -0.65, "tumvi": 0.48, "tyrex": 0.47}


@dataclass(frozen=True, slots=True, eq=False)
class TruthRecording:
    """An inertial log with the true vertical of every sample.

    Attributes:
        name: of the recording.
        family: of recordings that one figure is the mean of.
        imu: the log in its own sensor frame.
        up: (N, 3) true vertical in the sensor frame for what each sample stands for:
            at its time, or the mean over its window (then shorter than 1 while it
            rotates); NaN where unknown.
        counts: (N,) samples that error figures count.
    """

    name: str
    family: str
    imu: ImuLog
    up: Floats
    counts: NDArray[np.bool_]

    @property
    def time_s(self) -> Floats:
        """Times of the samples (N,)."""
        return self.imu.time_s

    @property
    def scored(self) -> NDArray[np.bool_]:
        """Samples that count and whose truth is known, (N,)."""
        return np.asarray(self.counts & np.isfinite(self.up).all(axis=1))


def gravity_error_mps2(recording: TruthRecording, up_estimate: Floats) -> float:
    """Return rms 9.81 ||u_est - u_true|| over the scored samples.

    NaN when the estimate is not finite in one of them: a gap is no success.
    """
    return float(np.sqrt(np.mean(gravity_errors_mps2(recording, up_estimate) ** 2)))


def gravity_errors_mps2(recording: TruthRecording, up_estimate: Floats) -> Floats:
    """Return 9.81 ||u_est - u_true|| of each scored sample."""
    scored = recording.scored
    miss = np.asarray(up_estimate)[scored] - recording.up[scored]
    return np.asarray(GRAVITY_MPS2 * np.linalg.norm(miss, axis=1))


def load_orientation(folder: Path, averaged: bool) -> list[TruthRecording]:
    """Return the recordings with optical truth, by name.

    Native: as recorded, truth read at the shifts of the data's README. Averaged:
    boxcar means over windows of 1/30 s whose middles are the times; the truth is
    the mean vertical over the same window (shifts already applied in the files).

    Args:
        folder: `data/orientation`.
        averaged: the 30 Hz variants.
    """
    read = _averaged if averaged else _native
    paths = sorted((folder / ("averaged_30hz" if averaged else "native")).glob("*.npz"))
    if not paths:
        raise FileNotFoundError(f"no recordings in {folder}")
    known = tuple(_TRUTH_LATER_SAMPLES)
    return [read(path) for path in paths if path.name.startswith(known)]


def _native(path: Path) -> TruthRecording:
    with np.load(path) as held:
        family = path.name.split("_")[0]
        count = len(held["acc"])
        stamps_s = held["t"] if "t" in held else np.arange(count) / float(held["rate"])
        quaternion = held["quat"].astype(np.float64)
        known = np.isfinite(quaternion).all(axis=1)
        up = np.full((count, 3), np.nan)
        turned = Rotation.from_quat(quaternion[known], scalar_first=True)
        up[known] = turned.inv().apply([0.0, 0.0, 1.0])
        return TruthRecording(
            name=path.stem,
            family=family,
            imu=_log(held, stamps_s - stamps_s[0], Sampling.INSTANT, path.stem),
            up=_shifted(up, _TRUTH_LATER_SAMPLES[family]),
            counts=held["mov"].astype(bool),
        )


def _averaged(path: Path) -> TruthRecording:
    with np.load(path) as held:
        # window k of the files is [k, k + 1) / rate from the start of the first
        # native sample's interval, by the nominal native rate
        time_s = (np.arange(len(held["acc"])) + 0.5) / float(held["rate"])
        return TruthRecording(
            name=path.stem,
            family=path.name.split("_")[0],
            imu=_log(held, time_s, Sampling.AVERAGED, path.stem),
            up=held["up_avg"].astype(np.float64),
            counts=held["mov"].astype(bool),
        )


def _log(held: Any, time_s: Floats, sampling: Sampling, name: str) -> ImuLog:
    return ImuLog(
        time_s=np.asarray(time_s, dtype=np.float64),
        specific_force_mps2=held["acc"].astype(np.float64),
        angular_rate_radps=held["gyr"].astype(np.float64),
        magnetic_field_ut=held["mag"].astype(np.float64) if "mag" in held else None,
        sampling=sampling,
        source=name,
    )


def _shifted(up: Floats, later_samples: float) -> Floats:
    """Return the vertical at index i + later_samples; NaN beside unknown ones."""
    at = np.arange(len(up)) + later_samples
    low = np.clip(np.floor(at).astype(int), 0, len(up) - 2)
    share = (at - low)[:, None]
    between = (1.0 - share) * up[low] + share * up[low + 1]
    between[(at < 0) | (at > len(up) - 1)] = np.nan
    return np.asarray(between / np.linalg.norm(between, axis=1, keepdims=True))


def load_comma(folder: Path) -> TruthRecording:
    """Return one minute in a car (comma2k19) in frame A, truth from the camera pose.

    Args:
        folder: `data/capture/comma2k19`.
    """
    imu, _ = car_imu(folder)
    truth = car_truth(folder)
    up = np.stack(
        [
            np.interp(imu.time_s, truth.time_s, truth.up[:, i], np.nan, np.nan)
            for i in range(3)
        ],
        axis=1,
    )
    return TruthRecording(
        name="comma2k19",
        family="car",
        imu=imu,
        up=up / np.linalg.norm(up, axis=1, keepdims=True),
        counts=np.ones(len(imu), dtype=bool),
    )


def load_simulated(
    name: str,
    seed: int = 1,
    *,
    duration_s: float | None = None,
    sensor: str | SensorModel = "camera",
) -> TruthRecording:
    """Return a simulated ride, truth exact; every sample counts.

    Args:
        name: one of MOTION_SCENES, which is also the family.
        seed: of the ride and the sensor.
        duration_s: None for the scene's own.
        sensor: a name in SENSORS, or a model.
    """
    ride = simulate_motion(name, seed, duration_s=duration_s, sensor=sensor)
    sensor_name = sensor if isinstance(sensor, str) else sensor.name
    return TruthRecording(
        name=f"{name}, {sensor_name}, seed {seed}",
        family=name,
        imu=ride.imu,
        up=ride.vertical,
        counts=np.ones(len(ride.imu), dtype=bool),
    )


def offline_vqf_up(imu: ImuLog) -> Floats:
    """Return offlineVQF's vertical (N, 3); half a window back for averaged samples."""
    from vqf import offlineVQF

    answer = offlineVQF(
        np.ascontiguousarray(imu.angular_rate_radps),
        np.ascontiguousarray(imu.specific_force_mps2),
        None,
        1.0 / imu.rate_hz,
    )
    turned = Rotation.from_quat(answer["quat6D"], scalar_first=True)
    if imu.sampling is Sampling.AVERAGED:
        half = Rotation.from_rotvec(0.5 / imu.rate_hz * imu.angular_rate_radps)
        turned = turned * half.inv()
    return np.asarray(turned.inv().apply([0.0, 0.0, 1.0]))


def main() -> int:
    """Print the car's truth, and offlineVQF's error on every recording."""
    print_agreement(DATA / "capture" / "comma2k19")
    held = [load_comma(DATA / "capture" / "comma2k19")]
    for averaged in (False, True):
        held += load_orientation(DATA / "orientation", averaged)
    held += [load_simulated(name) for name in MOTION_SCENES]
    means: dict[tuple[str, str], list[float]] = {}
    for recording in held:
        imu = recording.imu
        error = gravity_error_mps2(recording, offline_vqf_up(imu))
        print(
            f"{recording.name:45} {imu.sampling:9} {imu.rate_hz:7.2f} Hz "
            f"{recording.scored.sum():6} of {len(imu):6} scored  {error:.4f} m/s2"
        )
        if recording.name != HOLE:
            means.setdefault((recording.family, imu.sampling), []).append(error)
    for (family, sampling), errors in means.items():
        print(f"mean of {family}, {sampling}: {np.mean(errors):.4f} m/s2")
    return 0


if __name__ == "__main__":
    sys.exit(main())
