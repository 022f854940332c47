"""Recordings with a known vertical, by family: each figure is the mean over one.

Truth is optical (BROAD, TUM-VI, tyrex, RepoIMU), for the car its makers' fusion of GPS, camera
and inertial sensors, for simulated rides exact.
"""

import argparse
import sys
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfiltfilt
from scipy.spatial.transform import Rotation, Slerp

from benchmarks.common import DATA
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.model import ImuLog
from tools.optical import GAP, OPTICAL, read_optical

Floats = NDArray[np.float64]

ORIENTATION, COMMA = DATA / "orientation", DATA / "capture" / "comma2k19"
GRAVITY_MPS2 = 9.81  # of the error figures, as the field reports them
NATIVE, AVERAGED = "native", "30 Hz"
_CAR, _SIM_CAR, _SIM_PEOPLE = "car", "sim-car", "sim-people"
FAMILIES = (*OPTICAL, _CAR, _SIM_CAR, _SIM_PEOPLE)
_SENSORS = {NATIVE: "camera", AVERAGED: "paper-board"}
QUICK_NAMES = (
    "broad_15_undisturbed_fast_translation_A",
    "tumvi_room4",
    "tyrex_Guillaume_Nexus5_NoDist_Swinging",
    "repoimu_TStick_Test10_Trial1",
    "repoimu_Pendulum_Test02a_Trial1_Segment_1",
    "comma2k19",
)
QUICK_SCENES = ("car-brisk", "handheld-brisk")


@dataclass(frozen=True, slots=True, eq=False)
class TruthRecording:
    """An inertial log with the true vertical of every sample.

    Attributes:
        name: of the recording.
        scene: of a simulated ride, else the family.
        imu: the log in its own sensor frame.
        up: (N, 3) true vertical in the sensor frame for what each sample stands for:
            at its time, or the mean over its window (then shorter than 1 while it
            rotates); NaN where unknown.
        counts: (N,) samples that error figures count.
    """

    name: str
    scene: str
    imu: ImuLog
    up: Floats
    counts: NDArray[np.bool_]

    @property
    def scored(self) -> NDArray[np.bool_]:
        """Samples that count and whose truth is known, (N,)."""
        return np.asarray(self.counts & np.isfinite(self.up).all(axis=1))

    def errors_mps2(self, up: Floats) -> Floats:
        """Return 9.81 ||u_est - u_true|| of each scored sample."""
        miss = np.asarray(up)[self.scored] - self.up[self.scored]
        return np.asarray(GRAVITY_MPS2 * np.linalg.norm(miss, axis=1))


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """Recordings of one kind at one rate.

    Attributes:
        name: one of FAMILIES.
        rate: NATIVE or AVERAGED.
        recordings: that figures are means over.
        apart: shown beside them, but in no mean.
    """

    name: str
    rate: str
    recordings: list[TruthRecording] = field(default_factory=list)
    apart: list[TruthRecording] = field(default_factory=list)

    @property
    def key(self) -> str:
        return f"{self.name} {self.rate}"

    @property
    def logs(self) -> list[ImuLog]:
        return [recording.imu for recording in self.recordings]


def add_options(parser: argparse.ArgumentParser, *, seeds: int) -> None:
    parser.add_argument("--families", nargs="+", choices=FAMILIES, default=FAMILIES)
    text = f"simulated rides of each scene ({seeds})"
    parser.add_argument("--seeds", type=int, default=seeds, help=text)


def chosen(options: argparse.Namespace) -> list[Family]:
    """Return the families that the options choose; exit where data are missing."""
    folders = [ORIENTATION] if set(options.families) & set(OPTICAL) else []
    folders += [COMMA] if _CAR in options.families else []
    missing = [str(folder) for folder in folders if not folder.is_dir()]
    if missing:
        sys.exit(
            f"the recordings are not on this machine: {', '.join(missing)}; choose "
            f"--families {_SIM_CAR} {_SIM_PEOPLE}, which need none"
        )
    return load(options.families, options.seeds, quick=options.quick)


def load(wanted: Iterable[str], seeds: int, *, quick: bool = False) -> list[Family]:
    """Return families, native ones first.

    Args:
        wanted: of FAMILIES.
        seeds: simulated rides of each scene.
        quick: only the recordings and scenes of QUICK_NAMES and QUICK_SCENES.
    """
    wanted = set(wanted)
    found = []
    for name in FAMILIES:
        for rate in (NATIVE, AVERAGED):
            if name not in wanted or (name, rate) == (_CAR, AVERAGED):
                continue
            held = _held(name, rate, 1 if quick else seeds, quick=quick)
            if quick and not name.startswith("sim-"):
                held = [one for one in held if one.name in QUICK_NAMES]
            kept = [one for one in held if one.name != GAP]
            found.append(Family(name, rate, kept, [r for r in held if r.name == GAP]))
    return sorted(found, key=lambda family: family.rate == AVERAGED)


def _held(name: str, rate: str, seeds: int, *, quick: bool) -> list[TruthRecording]:
    if name == _CAR:
        return [comma()]
    if name in OPTICAL:
        folder = ORIENTATION / ("averaged_30hz" if rate == AVERAGED else "native")
        return [_optical(path) for path in sorted(folder.glob(f"{name}_*.npz"))]
    rides = [
        (scene, sensor, seed)
        for scene, sensor in scenes_of(name, rate)
        if not quick or scene in QUICK_SCENES
        for seed in range(1, seeds + 1)
    ]
    return [simulated(*ride) for ride in rides]


def scenes_of(name: str, rate: str) -> list[tuple[str, str]]:
    """Return scene and sensor of a family of simulated rides."""
    is_car = name == _SIM_CAR
    scenes = [s for s in MOTION_SCENES if s.startswith("car") == is_car]
    return [(scene, _SENSORS[rate]) for scene in scenes]


@cache
def simulated(scene: str, sensor: str, seed: int) -> TruthRecording:
    """Return a simulated ride; every sample counts."""
    ride = simulate_motion(scene, seed, sensor=sensor)
    everywhere = np.ones(len(ride.imu), dtype=bool)
    name = f"{scene}, {sensor}, seed {seed}"
    return TruthRecording(name, scene, ride.imu, ride.vertical, everywhere)


def _optical(path: Path) -> TruthRecording:
    """Read a recording at its own rate, or boxcar means over 1/30 s."""
    held, family = read_optical(path), path.name.split("_")[0]
    return TruthRecording(held.name, family, held.log, held.up, held.counted)


# --- the car of comma2k19 ----------------------------------------------------------

# forward, right, down to frame A (right, front, up): a proper rotation, so it serves
# both sensors; at rest the down axis reads -g, thus +g along up
_A_FROM_FRD = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
_LOW_PASS_HZ = 2.0
_WGS84_FLATTENING, _SEMI_MAJOR_M = 1.0 / 298.257223563, 6378137.0
_NORMAL_GRAVITY_MPS2 = 9.80  # at this latitude
_FORCE_SIGMA_MPS2, _RATE_SIGMA_RADPS = 0.17, 0.0014


def comma(folder: Path = COMMA) -> TruthRecording:
    """Return one minute in a car, in frame A, truth from the pose (20 Hz, ECEF).

    The pose's quaternions are device (forward, right, down) to ECEF. What is left
    between pose and IMU (a degree) is one constant rotation, fitted to angular
    rates and specific forces below 2 Hz (Wahba's problem, each by its own noise).
    """
    imu, start_s = _car_imu(folder)
    pose = folder / "global_pose"
    time_s = np.load(pose / "frame_times") - start_s
    device = Rotation.from_quat(np.load(pose / "frame_orientations"), scalar_first=True)
    ecef_from_a = device * Rotation.from_matrix(_A_FROM_FRD.T)
    up = _geodetic_up(np.load(pose / "frame_positions"))
    acceleration = np.gradient(np.load(pose / "frame_velocities"), time_s, axis=0)
    force = ecef_from_a.inv().apply(acceleration + _NORMAL_GRAVITY_MPS2 * up)
    inside = (time_s > 1.0) & (time_s < imu.time_s[-1] - 1.0)
    pose_hz = 1.0 / float(np.median(np.diff(time_s)))
    pairs = []
    for ours, theirs, sigma in (
        (imu.specific_force_mps2, force, _FORCE_SIGMA_MPS2),
        (imu.angular_rate_radps, _rates(ecef_from_a, time_s), _RATE_SIGMA_RADPS),
    ):
        left = _at(time_s, imu.time_s, _low_passed(ours, imu.rate_hz))
        right = _low_passed(theirs, pose_hz)
        weight = np.full(int(inside.sum()), sigma**-2.0)
        pairs.append((left[inside], right[inside], weight))
    left, right, weight = (np.concatenate(part) for part in zip(*pairs, strict=True))
    mount, _ = Rotation.align_vectors(left, right, weights=weight)
    vertical = (mount * ecef_from_a.inv()).apply(up)
    known = [np.interp(imu.time_s, time_s, v, np.nan, np.nan) for v in vertical.T]
    up = np.stack(known, axis=1)
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    return TruthRecording("comma2k19", _CAR, imu, up, np.ones(len(imu), dtype=bool))


def _car_imu(folder: Path) -> tuple[ImuLog, float]:
    """Return the log in frame A from time 0 on, and that time since boot."""
    logs = folder / "processed_log" / "IMU"
    boot_s = np.load(logs / "accelerometer" / "t")
    force, rate = (
        np.load(logs / name / "value") @ _A_FROM_FRD.T
        for name in ("accelerometer", "gyro")
    )
    log = ImuLog(boot_s - boot_s[0], force, rate, source="comma2k19 segment 40")
    return log, float(boot_s[0])


def _geodetic_up(ecef_m: Floats) -> Floats:
    """Return the normal of the WGS84 ellipsoid below positions (M, 3).

    Bowring's first step, exact to 1e-9 rad near the ground.
    """
    squeeze = 1.0 - _WGS84_FLATTENING
    first = 1.0 - squeeze**2
    second = first / squeeze**2
    x, y, z = ecef_m.T
    across = np.hypot(x, y)
    reduced = np.arctan2(z, squeeze * across)
    latitude = np.arctan2(
        z + second * squeeze * _SEMI_MAJOR_M * np.sin(reduced) ** 3,
        across - first * _SEMI_MAJOR_M * np.cos(reduced) ** 3,
    )
    east, flat = np.arctan2(y, x), np.cos(latitude)
    return np.stack(
        [flat * np.cos(east), flat * np.sin(east), np.sin(latitude)], axis=1
    )


def _rates(orientation: Rotation, time_s: Floats) -> Floats:
    """Return angular rates (M, 3) in the body frame by central differences."""
    slerp = Slerp(time_s, orientation)
    before = slerp(np.clip(time_s - 0.05, time_s[0], None))
    after = slerp(np.clip(time_s + 0.05, None, time_s[-1]))
    return np.asarray((before.inv() * after).as_rotvec() / 0.1)


def _low_passed(values: Floats, rate_hz: float) -> Floats:
    sections = butter(2, _LOW_PASS_HZ, fs=rate_hz, output="sos")
    return np.asarray(sosfiltfilt(sections, values, axis=0))


def _at(query_s: Floats, time_s: Floats, values: Floats) -> Floats:
    return np.stack([np.interp(query_s, time_s, v) for v in values.T], axis=1)
