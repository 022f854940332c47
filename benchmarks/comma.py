"""The car of comma2k19: its IMU in frame A and the true vertical from its pose.

The pose (20 Hz, position and orientation in ECEF) was fused from GPS, camera and
inertial sensors by its makers; here it is turned into the IMU's frame and compared
with the accelerometer, which says how good a truth it is.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfiltfilt
from scipy.spatial.transform import Rotation, Slerp

from hapticplayer.model import ImuLog

Floats = NDArray[np.float64]

# comma2k19 is forward, right, down; frame A is right, front, up. A proper rotation,
# so it serves both sensors; at rest the down axis reads -g, thus +g along up.
_A_FROM_FRD = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
_LOW_PASS_HZ = 2.0
_WGS84_FLATTENING = 1.0 / 298.257223563
_NORMAL_GRAVITY_MPS2 = 9.80  # at this latitude


@dataclass(frozen=True, slots=True, eq=False)
class CarTruth:
    """The car's pose (20 Hz) in the frame A of its IMU, and how well it agrees.

    Attributes:
        time_s: (M,) of the pose, in the log's time.
        up: (M, 3) geodetic up in the IMU's frame A.
        acceleration_mps2: (M, 3) true motion in frame A, from the pose's velocity.
        mount_rad: (3,) the rotation between pose and IMU that was removed.
        disagreement_mps2: RMS of the pose's specific force minus the accelerometer's
            below 2 Hz; `filtered`: both below 2 Hz.
        filtered_disagreement_mps2: the same with both below 2 Hz.
        motion_mps2: RMS of the true motion.
        rate_disagreement_radps: RMS of the angular rates' difference below 2 Hz.
        lag_s: by which the IMU follows the pose, from the angular rates.
        speed_lag_s: by which the CAN speed follows the pose's.
    """

    time_s: Floats
    up: Floats
    acceleration_mps2: Floats
    mount_rad: Floats
    disagreement_mps2: float
    filtered_disagreement_mps2: float
    motion_mps2: float
    rate_disagreement_radps: float
    lag_s: float
    speed_lag_s: float


def car_truth(folder: Path) -> CarTruth:
    """Return the pose turned into the IMU's frame, and its agreement with the IMU.

    The pose's quaternions are device (forward, right, down) to ECEF. What is left
    between pose and IMU (a degree) is one constant rotation, fitted to angular
    rates and specific forces below 2 Hz (Wahba's problem, each by its own noise).
    """
    imu, start_s = car_imu(folder)
    pose = folder / "global_pose"
    time_s = np.load(pose / "frame_times") - start_s
    ecef_from_device = Rotation.from_quat(
        np.load(pose / "frame_orientations"), scalar_first=True
    )
    ecef_from_a = ecef_from_device * Rotation.from_matrix(_A_FROM_FRD.T)
    velocity = np.load(pose / "frame_velocities")
    up = _geodetic_up(np.load(pose / "frame_positions"))
    acceleration = np.gradient(velocity, time_s, axis=0)
    force = ecef_from_a.inv().apply(acceleration + _NORMAL_GRAVITY_MPS2 * up)
    rate = _rates(ecef_from_a, time_s)

    lowered = [
        _low_passed(v, imu.rate_hz)
        for v in (imu.specific_force_mps2, imu.angular_rate_radps)
    ]
    inside = (time_s > 1.0) & (time_s < imu.time_s[-1] - 1.0)
    imu_force, imu_rate = (_at(time_s, imu.time_s, v) for v in lowered)
    pose_hz = 1.0 / float(np.median(np.diff(time_s)))
    smooth_force, smooth_rate = _low_passed(force, pose_hz), _low_passed(rate, pose_hz)
    mount = _mount(
        (imu_force[inside], smooth_force[inside], 0.17),
        (imu_rate[inside], smooth_rate[inside], 0.0014),
    )

    def rms(left: Floats, right: Floats) -> float:
        miss = (left - mount.apply(right))[inside]
        return float(np.sqrt(np.mean(np.sum(miss**2, axis=1))))

    turned_rate = mount.apply(smooth_rate)
    speed = np.linalg.norm(velocity, axis=1)
    return CarTruth(
        time_s=time_s,
        up=(mount * ecef_from_a.inv()).apply(up),
        acceleration_mps2=(mount * ecef_from_a.inv()).apply(acceleration),
        mount_rad=mount.as_rotvec(),
        disagreement_mps2=rms(imu_force, force),
        filtered_disagreement_mps2=rms(imu_force, smooth_force),
        motion_mps2=float(np.sqrt(np.mean(np.sum(acceleration[inside] ** 2, axis=1)))),
        rate_disagreement_radps=rms(imu_rate, smooth_rate),
        lag_s=_lag_s(time_s, turned_rate, imu.time_s, lowered[1]),
        speed_lag_s=_lag_s(time_s, speed[:, None], *_can_speed(folder, start_s)),
    )


def car_imu(folder: Path) -> tuple[ImuLog, float]:
    """Return the log in frame A, its time 0 its first sample, and that boot time.

    Pose, IMU and CAN are stamped with one clock, seconds since boot.
    """
    logs = folder / "processed_log" / "IMU"
    boot_s = np.load(logs / "accelerometer" / "t")
    values = [
        np.load(logs / name / "value") @ _A_FROM_FRD.T
        for name in ("accelerometer", "gyro")
    ]
    force, rate = values
    log = ImuLog(boot_s - boot_s[0], force, rate, source="comma2k19 segment 40")
    return log, float(boot_s[0])


def _can_speed(folder: Path, start_s: float) -> tuple[Floats, Floats]:
    speed = folder / "processed_log" / "CAN" / "speed"
    return np.load(speed / "t") - start_s, np.load(speed / "value")


def _geodetic_up(ecef_m: Floats) -> Floats:
    """Return the normal of the WGS84 ellipsoid below positions (M, 3).

    Bowring's first step, exact to 1e-9 rad near the ground.
    """
    squeeze = 1.0 - _WGS84_FLATTENING
    semi_major_m = 6378137.0
    first = 1.0 - squeeze**2
    second = first / squeeze**2
    x, y, z = ecef_m.T
    across = np.hypot(x, y)
    reduced = np.arctan2(z, squeeze * across)
    latitude = np.arctan2(
        z + second * squeeze * semi_major_m * np.sin(reduced) ** 3,
        across - first * semi_major_m * np.cos(reduced) ** 3,
    )
    longitude = np.arctan2(y, x)
    flat = np.cos(latitude)
    return np.stack(
        [flat * np.cos(longitude), flat * np.sin(longitude), np.sin(latitude)], axis=1
    )


def _rates(orientation: Rotation, time_s: Floats) -> Floats:
    """Return angular rates (M, 3) in the body frame by central differences."""
    slerp = Slerp(time_s, orientation)
    before = slerp(np.clip(time_s - 0.05, time_s[0], None))
    after = slerp(np.clip(time_s + 0.05, None, time_s[-1]))
    return np.asarray((before.inv() * after).as_rotvec() / 0.1)


def _mount(*pairs: tuple[Floats, Floats, float]) -> Rotation:
    """Return the rotation R that best gives left = R right, each pair by its sigma."""
    left, right, weight = (
        np.concatenate(parts)
        for parts in zip(
            *((a, b, np.full(len(a), s**-2.0)) for a, b, s in pairs), strict=True
        )
    )
    rotation, _ = Rotation.align_vectors(left, right, weights=weight)
    return rotation


def _low_passed(values: Floats, rate_hz: float) -> Floats:
    sections = butter(2, _LOW_PASS_HZ, fs=rate_hz, output="sos")
    return np.asarray(sosfiltfilt(sections, values, axis=0))


def _at(query_s: Floats, time_s: Floats, values: Floats) -> Floats:
    return np.stack([np.interp(query_s, time_s, v) for v in values.T], axis=1)


def _lag_s(time_s: Floats, values: Floats, other_s: Floats, other: Floats) -> float:
    """Return by how much `other` follows `values`: the best of a 2 ms grid."""
    inside = (time_s > 1.0) & (time_s < time_s[-1] - 1.0)
    lags_s = np.arange(-0.2, 0.2005, 0.002)

    def miss(lag_s: float) -> float:
        left = _at(time_s[inside] + lag_s, other_s, other) - values[inside]
        return float(np.sum((left - left.mean(axis=0)) ** 2))

    return float(lags_s[np.argmin([miss(lag) for lag in lags_s])])


def print_agreement(folder: Path) -> None:
    """Print how well pose and IMU agree."""
    truth = car_truth(folder)
    print(
        f"car: true motion {truth.motion_mps2:.3f} m/s2 RMS; pose against the "
        f"accelerometer below 2 Hz: {truth.disagreement_mps2:.3f} m/s2, both below "
        f"2 Hz: {truth.filtered_disagreement_mps2:.3f}; angular rates: "
        f"{truth.rate_disagreement_radps:.4f} rad/s; mount of "
        f"{np.degrees(np.linalg.norm(truth.mount_rad)):.2f} deg removed; after the "
        f"pose: IMU {1e3 * truth.lag_s:.0f} ms, speed {1e3 * truth.speed_lag_s:.0f} ms"
    )
