"""Rides without picture: consistent truth, stated levels, standstills, seeds.

Nothing of the simulator is used to compute what is expected: positions are
differentiated numerically and orientations handled by scipy.
"""

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import butter, periodogram, sosfiltfilt
from scipy.spatial.transform import Rotation

from hapticplayer.errors import UsageError
from hapticplayer.extras.rides.motion_scenes import (
    MOTION_SCENES,
    SimulatedMotion,
    simulate_motion,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.model import STANDARD_GRAVITY_MPS2, Sampling

Floats = NDArray[np.float64]
G = STANDARD_GRAVITY_MPS2
RATE_HZ = 200.0
CARS = [name for name in MOTION_SCENES if name.startswith("car-")]
SEEDS = (1, 2, 3)


@cache
def ride(name: str, seed: int = 1) -> SimulatedMotion:
    return simulate_motion(name, seed, sensor="ideal")


def earth_acceleration(motion: SimulatedMotion) -> Floats:
    turned = Rotation.from_quat(motion.truth.quaternion_wxyz, scalar_first=True)
    return turned.apply(motion.truth.acceleration_mps2)


def along_and_left(motion: SimulatedMotion, below_hz: float) -> tuple[Floats, Floats]:
    """Accelerations along the way and to its left below a frequency, in g.

    Only where the car moves; 0 elsewhere.
    """
    velocity = motion.truth.velocity_mps[:, :2]
    speed = np.linalg.norm(velocity, axis=1)
    moving = speed > 0.5
    ahead = np.where(moving[:, None], velocity / np.maximum(speed, 0.5)[:, None], 0.0)
    flat = earth_acceleration(motion)[:, :2]
    left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    low = butter(2, below_hz, fs=RATE_HZ, output="sos")
    return tuple(
        sosfiltfilt(low, np.sum(flat * axis, axis=1)) / G for axis in (ahead, left)
    )


def stretches(flags: NDArray[np.bool_]) -> list[slice]:
    """The unbroken stretches of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(int), [0]])))
    return [slice(a, b) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def stretches_s(flags: NDArray[np.bool_]) -> Floats:
    """How long they are."""
    return np.array([(part.stop - part.start) / RATE_HZ for part in stretches(flags)])


def longest_s(flags: NDArray[np.bool_]) -> float:
    """The longest of them; 0 when there is none."""
    return float(max(stretches_s(flags), default=0.0))


def chained(steps_rad: Floats) -> Rotation:
    """Rotate by all rotation vectors (N, 3), one after the other."""
    turned = Rotation.from_rotvec(steps_rad)
    while len(turned) > 1:
        odd = turned[-1:] if len(turned) % 2 else None
        turned = turned[0 : len(turned) // 2 * 2 : 2] * turned[1::2]
        turned = turned if odd is None else Rotation.concatenate([turned, odd])
    return turned[0]


# --- the truth is consistent ------------------------------------------------


@pytest.mark.parametrize("name", MOTION_SCENES)
def test_force_is_the_second_derivative_of_the_path(name: str) -> None:
    """f = R^T (a + g z), with a from central differences of the position."""
    path = ride(name).trajectory
    times_s = np.random.default_rng(7).uniform(0.1, 85.0, 1000)
    step_s = 2.5e-4
    before, here, after = (
        path.at(times_s + shift).position_m for shift in (-step_s, 0.0, step_s)
    )
    acc_earth = (before - 2.0 * here + after) / step_s**2
    truth = path.at(times_s)
    turned = Rotation.from_quat(truth.quaternion_wxyz, scalar_first=True)
    expected = turned.inv().apply(acc_earth + np.array([0.0, 0.0, G]))
    # h^2 / 12 times the fourth derivative: 30 m/s2 at 30 Hz give 5e-3
    np.testing.assert_allclose(truth.specific_force_mps2, expected, atol=6e-3)
    np.testing.assert_allclose(
        truth.velocity_mps, (after - before) / (2.0 * step_s), atol=1e-4
    )


@pytest.mark.parametrize("name", MOTION_SCENES)
def test_angular_rate_turns_the_orientation(name: str) -> None:
    """w = log(R(t - h)^T R(t + h)) / 2h."""
    path = ride(name).trajectory
    times_s = np.random.default_rng(8).uniform(0.1, 85.0, 1000)
    step_s = 2.5e-4
    before, after = (
        Rotation.from_quat(path.at(times_s + shift).quaternion_wxyz, scalar_first=True)
        for shift in (-step_s, step_s)
    )
    numerical = (before.inv() * after).as_rotvec() / (2.0 * step_s)
    np.testing.assert_allclose(
        path.at(times_s).angular_rate_radps, numerical, atol=1e-5
    )


@pytest.mark.parametrize("name", MOTION_SCENES)
def test_integrated_truth_does_not_drift(name: str) -> None:
    """Summed acceleration ends at the true velocity, chained gyro at the true turn."""
    motion = ride(name)
    acc = earth_acceleration(motion)
    gained = np.sum(0.5 * (acc[1:] + acc[:-1]), axis=0) / RATE_HZ
    truth = motion.truth
    np.testing.assert_allclose(
        gained, truth.velocity_mps[-1] - truth.velocity_mps[0], atol=2e-3
    )
    begin = Rotation.from_quat(truth.quaternion_wxyz[0], scalar_first=True)
    turned = begin * chained(motion.imu.angular_rate_radps[1:] / RATE_HZ)
    end = Rotation.from_quat(truth.quaternion_wxyz[-1], scalar_first=True)
    assert (end.inv() * turned).magnitude() < 1e-8


@pytest.mark.parametrize("name", MOTION_SCENES)
def test_vertical_and_motion_add_up_to_the_force(name: str) -> None:
    motion = ride(name)
    np.testing.assert_allclose(
        motion.imu.specific_force_mps2,
        motion.acceleration_mps2 + G * motion.vertical,
        atol=1e-9,
    )


def test_spline_is_precise_far_from_the_start() -> None:
    """Twelve hours at 34 m/s away, float64 costs 1e-4 m/s2 at most."""
    time_s = np.arange(-100, 6101) / 200.0
    far_m = 1.5e6 + 34.0 * time_s
    position = np.stack([far_m, 0.3 * far_m, np.zeros_like(far_m)], axis=1)
    motion = Trajectory(time_s, position, np.zeros_like(position)).at(
        np.arange(0.0, 30.0, 0.00371)
    )
    assert np.abs(motion.acceleration_mps2).max() < 4e-4
    assert np.abs(motion.velocity_mps[:, 0] - 34.0).max() < 1e-6


def test_half_an_hour_is_like_a_minute() -> None:
    """No build-up: speeds, levels and standstills stay, in the last minute too."""
    motion = simulate_motion("car-brisk", 5, duration_s=1800.0, sensor="ideal")
    assert len(motion.imu) == 360_001
    speed = np.linalg.norm(motion.truth.velocity_mps, axis=1)
    assert speed.max() < 22.0
    along, left = along_and_left(motion, 0.7)
    for part in (slice(0, 48_000), slice(-48_000, None)):
        assert 0.24 < np.abs(along[part]).max() < 0.40
        assert 0.24 < np.abs(left[part]).max() < 0.40
    last_stands = [part for part in stretches(speed < 1e-6) if part.start > 300_000]
    assert max(part.stop - part.start for part in last_stands) > 1.0 * RATE_HZ


# --- the levels are what they are called ------------------------------------


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(
    ("name", "low_g", "high_g"),
    [("car-calm", 0.10, 0.15), ("car-brisk", 0.25, 0.35), ("car-hard", 0.50, 0.70)],
)
def test_town_rides_brake_and_corner_at_their_level(
    name: str, low_g: float, high_g: float, seed: int
) -> None:
    along, left = along_and_left(ride(name, seed), 0.7)
    for kind in (-along, along, np.abs(left)):  # braking, accelerating, cornering
        assert low_g < kind.max() < 1.12 * high_g
        assert longest_s(kind > 0.8 * low_g) > 1.0
    sustained = np.hypot(along, left) > 0.8 * low_g
    assert 0.2 < sustained.mean() < 0.8
    assert longest_s(np.abs(left) > 0.8 * low_g) > 4.0  # a roundabout


@pytest.mark.parametrize("seed", SEEDS)
def test_roundabouts_last_five_to_fifteen_seconds(seed: int) -> None:
    _, left = along_and_left(ride("car-roundabouts", seed), 0.7)
    lengths = stretches_s(left > 0.12)
    rounds = lengths[lengths > 3.5]
    assert len(rounds) >= 3
    assert rounds.min() > 4.0
    assert rounds.max() < 16.0
    assert 0.2 < left.max() < 0.45


@pytest.mark.parametrize("seed", SEEDS)
def test_motorway_is_fast_and_gentle(seed: int) -> None:
    motion = ride("car-motorway", seed)
    speed = np.linalg.norm(motion.truth.velocity_mps, axis=1)
    assert speed.min() > 24.5
    assert speed.max() < 34.5
    along, left = along_and_left(motion, 0.5)
    assert np.abs(along).max() < 0.10
    assert 0.05 < np.abs(left).max() < 0.13
    assert longest_s(np.abs(left) > 0.03) > 8.0


@pytest.mark.parametrize("seed", SEEDS)
def test_ramps_have_ten_seconds_of_acceleration(seed: int) -> None:
    along, left = along_and_left(ride("car-on-ramp", seed), 0.7)
    assert 8.0 < longest_s(along > 0.12) < 12.5
    assert 0.18 < along.max() < 0.32
    assert longest_s(left < -0.15) > 4.0


@pytest.mark.parametrize("seed", SEEDS)
def test_hills_go_up_and_down(seed: int) -> None:
    velocity = ride("car-hills", seed).truth.velocity_mps
    climb = velocity[:, 2] / np.linalg.norm(velocity[:, :2], axis=1)
    low = butter(2, 0.3, fs=RATE_HZ, output="sos")
    climb = sosfiltfilt(low, climb)
    assert 0.04 < climb.max() < 0.14
    assert -0.14 < climb.min() < -0.04


@pytest.mark.parametrize("seed", SEEDS)
def test_queue_stands_still_again_and_again(seed: int) -> None:
    truth = ride("car-stop-and-go", seed).truth
    speed = np.linalg.norm(truth.velocity_mps, axis=1)
    shaking = np.linalg.norm(truth.acceleration_mps2, axis=1)
    assert np.sum(stretches_s(speed < 0.01) > 1.5) >= 4
    # settled and with the engine off, nothing moves at all
    dead = [p for p in stretches(speed < 1e-6) if p.stop - p.start > RATE_HZ]
    assert dead
    for part in dead:
        inside = slice(part.start + 20, part.stop - 20)
        assert shaking[inside].max() < 1e-4
        assert np.abs(truth.angular_rate_radps[inside]).max() < 1e-5
        assert np.ptp(truth.position_m[inside], axis=0).max() < 1e-5


def test_standstills_neither_creep_nor_turn() -> None:
    """Engine on or off: over a standstill the car ends where it began."""
    truth = ride("car-stop-and-go", 2).truth
    speed = np.linalg.norm(truth.velocity_mps, axis=1)
    stands = [p for p in stretches(speed < 0.003) if p.stop - p.start > 2.0 * RATE_HZ]
    assert len(stands) >= 3
    for part in stands:
        inside = slice(part.start + 100, part.stop - 100)  # while the body settles
        assert np.ptp(truth.position_m[inside], axis=0).max() < 1e-3


@pytest.mark.parametrize("name", CARS)
def test_cars_shake_as_cars_do(name: str) -> None:
    """Vertical vibration above 1 Hz at speed: 0.1 to 0.5 m/s2, resonances at 1-2 Hz."""
    motion = ride(name)
    speed = np.linalg.norm(motion.truth.velocity_mps, axis=1)
    high = butter(2, 1.0, "high", fs=RATE_HZ, output="sos")
    shaking = sosfiltfilt(high, earth_acceleration(motion)[:, 2])
    assert 0.1 < shaking[speed > 6.0].std() < 0.5
    frequency_hz, power = periodogram(shaking, RATE_HZ)
    wheels = power[(frequency_hz > 8.0) & (frequency_hz < 14.0)].mean()
    beyond = power[(frequency_hz > 75.0) & (frequency_hz < 90.0)].mean()
    assert wheels > 100.0 * beyond


def test_walker_steps_and_stands() -> None:
    motion = ride("walk")
    vertical = earth_acceleration(motion)[:, 2]
    frequency_hz, power = periodogram(vertical, RATE_HZ)
    assert frequency_hz[power.argmax()] == pytest.approx(1.85, rel=0.06)
    assert 1.2 < vertical.std() < 3.0
    speed = np.linalg.norm(motion.truth.velocity_mps, axis=1)
    assert longest_s(speed < 0.1) > 1.5


def test_runner_clips_a_phone_but_not_a_camera() -> None:
    phone, camera = (simulate_motion("run", 1, sensor=s) for s in ("phone", "camera"))
    force = phone.imu.specific_force_mps2
    clipped = np.abs(force) >= 2.0 * G
    assert np.abs(force).max() == 2.0 * G
    assert 0.02 < clipped.any(axis=1).mean() < 0.3
    assert np.abs(camera.imu.specific_force_mps2).max() > 3.0 * G
    # in flight almost nothing is felt
    assert np.linalg.norm(camera.truth.specific_force_mps2, axis=1).min() < 3.0


def test_quiet_footage_is_almost_still() -> None:
    motion = ride("handheld-quiet")
    assert 0.02 < motion.truth.acceleration_mps2.std() < 0.1
    rate_degps = np.degrees(np.linalg.norm(motion.truth.angular_rate_radps, axis=1))
    assert rate_degps.max() < 20.0
    turned = Rotation.from_quat(motion.truth.quaternion_wxyz, scalar_first=True)
    yaw_deg = np.degrees(np.unwrap(turned.as_euler("ZXY")[:, 0]))
    assert np.ptp(yaw_deg) > 10.0  # it pans
    assert np.ptp(motion.truth.position_m, axis=0).max() < 0.05


def test_brisk_hands_turn_fast_and_stay_in_the_room() -> None:
    motion = ride("handheld-brisk")
    rate_degps = np.degrees(np.linalg.norm(motion.truth.angular_rate_radps, axis=1))
    assert 40.0 < np.sqrt(np.mean(rate_degps**2)) < 120.0
    assert 1.0 < np.sqrt(np.mean(np.sum(motion.acceleration_mps2**2, axis=1))) < 5.0
    assert np.ptp(motion.truth.position_m, axis=0).max() < 6.0


def test_cyclist_leans_into_bends() -> None:
    """A cyclist's right side goes down in a right bend, a car's in a left one."""
    for name, sign in (("bicycle", -1.0), ("car-hard", 1.0)):
        motion = ride(name)
        _, left = along_and_left(motion, 0.5)
        right_up = Rotation.from_quat(
            motion.truth.quaternion_wxyz, scalar_first=True
        ).apply([1.0, 0.0, 0.0])[:, 2]
        roll = sosfiltfilt(butter(2, 0.5, fs=RATE_HZ, output="sos"), -right_up)
        bends = np.abs(left) > 0.15
        slope = np.sum(roll[bends] * left[bends]) / np.sum(left[bends] ** 2)
        # car: 3.5 deg/g outwards; cyclist: 0.6 of the balancing lean inwards
        assert 0.03 < sign * slope < (0.09 if sign > 0 else 0.7)


def test_mountain_biker_falls_and_lands() -> None:
    truth = ride("mountain-bike").truth
    norms = np.linalg.norm(truth.specific_force_mps2, axis=1)
    low = butter(2, 6.0, fs=RATE_HZ, output="sos")
    smooth = sosfiltfilt(low, norms)
    assert smooth.min() < 4.0
    assert smooth.max() > 20.0
    assert truth.position_m[0, 2] - truth.position_m[-1, 2] > 50.0  # downhill


# --- seeds, names and durations ---------------------------------------------


@pytest.mark.parametrize("name", ["car-hard", "walk", "handheld-brisk", "bicycle"])
def test_same_seed_gives_the_same_bytes(name: str) -> None:
    first, again = (simulate_motion(name, 9, duration_s=5.0) for _ in range(2))
    other = simulate_motion(name, 10, duration_s=5.0)
    for field in ("specific_force_mps2", "angular_rate_radps"):
        logged = getattr(first.imu, field)
        assert logged.tobytes() == getattr(again.imu, field).tobytes()
        assert not np.array_equal(logged, getattr(other.imu, field))
    assert first.truth.position_m.tobytes() == again.truth.position_m.tobytes()
    assert not np.array_equal(first.truth.position_m, other.truth.position_m)


@pytest.mark.parametrize("name", MOTION_SCENES)
def test_scenes_last_as_long_as_they_say(name: str) -> None:
    motion = ride(name)
    assert 60.0 <= MOTION_SCENES[name].duration_s <= 180.0
    assert motion.imu.time_s[0] == 0.0
    assert motion.imu.time_s[-1] == pytest.approx(MOTION_SCENES[name].duration_s)
    assert simulate_motion(name, 1, duration_s=7.5).imu.time_s[-1] == 7.5
    assert motion.title in motion.imu.source


def test_board_writes_averages_at_30_hz() -> None:
    motion = simulate_motion("handheld-brisk", 1, duration_s=30.0, sensor="paper-board")
    assert motion.imu.sampling is Sampling.AVERAGED
    assert motion.imu.rate_hz == pytest.approx(30.0)
    assert len(motion.imu) == len(motion.vertical) == len(motion.truth.time_s) == 900
    assert np.linalg.norm(motion.vertical, axis=1).min() < 0.9999


def test_truth_is_handed_on_as_arrays() -> None:
    arrays = ride("walk").truth_arrays()
    assert all(len(array) == 18_001 for array in arrays.values())
    assert {"time_s", "acceleration_mps2", "vertical", "quaternion_wxyz"} <= set(arrays)


def test_an_unknown_scene_is_refused_with_the_known_ones() -> None:
    with pytest.raises(
        UsageError, match="motion scene 'boat' not found; choose one of car-"
    ):
        simulate_motion("boat", 1)
    with pytest.raises(
        UsageError, match="sensor 'nose' not found; choose one of camera"
    ):
        simulate_motion("walk", 1, sensor="nose")
    for duration_s in (0.0, -3.0, float("nan"), 1e6):
        with pytest.raises(UsageError, match="give one from 1 to"):
            simulate_motion("walk", 1, duration_s=duration_s)
