"""What the default method makes of recordings whose truth is known in closed form."""

import dataclasses

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.errors import UsageError
from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog
from hapticplayer.motion import SmootherParameters, analyse, remove_gravity
from hapticplayer.motion.lowpass import lowpass_vertical
from hapticplayer.motion.smoother import block, state
from tests.unit.motion.smoother.conftest import (
    TIME_S,
    UP_1_G,
    WOBBLE,
    Motion,
    assert_sound,
    miss,
    nothing_skipped,
    rms,
    shake,
    window_means,
    wobble,
)

TEN_DEG = np.radians(10.0) * np.array([0.6, -0.64, 0.48])


def usual(**changed) -> ImuLog:
    return dataclasses.replace(WOBBLE.instant(TIME_S), **changed)


# ---- what does not matter -------------------------------------------------------


def test_a_magnetometer_changes_nothing(rng):
    plain = remove_gravity(usual())
    field = 50.0 * rng.standard_normal((len(TIME_S), 3))
    got = remove_gravity(usual(magnetic_field_ut=field))
    for one in ("acceleration_mps2", "quaternion_wxyz", "gravity_sigma_mps2"):
        assert np.array_equal(getattr(got, one), getattr(plain, one))


def test_a_real_magnetometer_changes_nothing(recording):
    log = recording("broad_28", 60.0)
    assert log.magnetic_field_ut is not None
    without = remove_gravity(dataclasses.replace(log, magnetic_field_ut=None))
    got = remove_gravity(log)
    assert np.array_equal(got.acceleration_mps2, without.acceleration_mps2)


@pytest.mark.parametrize(
    "convert",
    [
        lambda a: a.astype(np.float32),
        lambda a: np.repeat(a, 2, axis=1)[:, ::2],
        np.asfortranarray,
        lambda a: a.astype(">f8"),
        np.ndarray.tolist,
    ],
    ids=["float32", "not contiguous", "Fortran order", "big-endian", "lists"],
)
def test_how_the_numbers_are_kept_does_not_matter(convert):
    log = usual()
    other = ImuLog(
        log.time_s,
        convert(log.specific_force_mps2.copy()),
        convert(log.angular_rate_radps.copy()),
    )
    got, plain = remove_gravity(other), remove_gravity(log)
    # float32 rounds 10 m/s^2 to 5e-7
    assert np.abs(got.acceleration_mps2 - plain.acceleration_mps2).max() < 2e-5


def test_the_same_log_gives_the_same_motion_and_stays_unchanged():
    log = usual()
    force, rate = log.specific_force_mps2.copy(), log.angular_rate_radps.copy()
    first, again = remove_gravity(log), remove_gravity(log)
    assert np.array_equal(first.acceleration_mps2, again.acceleration_mps2)
    assert np.array_equal(log.specific_force_mps2, force)
    assert np.array_equal(log.angular_rate_radps, rate)


# ---- how exact ------------------------------------------------------------------


@pytest.mark.parametrize("rate_hz", [10, 20, 30, 100, 200, 1000])
def test_ideal_samples_give_the_vertical_at_every_rate(rate_hz):
    time_s = np.arange(1, 40 * rate_hz + 1) / rate_hz
    error = miss(WOBBLE.instant(time_s), WOBBLE.up(time_s))
    # 5 rad/s is half a rad from sample to sample at 10 Hz
    assert rms(error) < {10: 0.12, 20: 0.05, 30: 0.03}.get(rate_hz, 0.02)


@pytest.mark.parametrize(
    ("rate_hz", "bound_mps2"), [(10, 0.18), (20, 0.05), (30, 0.04), (100, 0.015)]
)
def test_ideal_means_give_the_mean_vertical(rate_hz, bound_mps2):
    log = WOBBLE.averaged(40 * rate_hz, 1.0 / rate_hz)
    up = window_means(WOBBLE.up, log.time_s, 1.0 / rate_hz)
    assert rms(miss(log, up)) < bound_mps2
    # taking the vertical in the middle for the mean costs 2 % of 9.8 at 10 Hz
    assert np.linalg.norm(up, axis=1).min() < 1.0


def test_a_mean_of_a_turning_vertical_is_shorter_than_one():
    log = WOBBLE.averaged(400, 0.1)
    norm = np.linalg.norm(remove_gravity(log).gravity_mps2, axis=1) / G
    exact = np.linalg.norm(window_means(WOBBLE.up, log.time_s, 0.1), axis=1)
    assert exact.min() < 0.996
    assert np.abs(norm - exact).max() < 0.001


def test_an_upside_down_start_is_like_any_other():
    flipped = Motion(lambda t: Rotation.from_rotvec([np.pi, 0, 0]) * wobble(t), shake)
    assert rms(miss(flipped.instant(TIME_S), flipped.up(TIME_S))) < 0.02


def turned_over(t):
    """Return a slow roll by a whole turn and a half within a minute."""
    return Rotation.from_rotvec(np.multiply.outer(0.157 * t, [1.0, 0.0, 0.0]))


def test_a_sensor_that_is_turned_over_is_followed_all_the_way():
    motion = Motion(turned_over, shake)
    assert rms(miss(motion.instant(TIME_S), motion.up(TIME_S))) < 0.02


def test_free_fall_costs_little():
    def acceleration(t):
        falls = ((t > 20.0) & (t < 26.0))[:, None]
        return np.where(falls, -UP_1_G, shake(t))

    motion = Motion(wobble, acceleration)
    error = miss(motion.instant(TIME_S), motion.up(TIME_S))
    # 59 m/s build up, far beyond any bound
    assert np.linalg.norm(error, axis=1).max() < 0.3
    assert rms(error[TIME_S > 36.0]) < 0.1


# ---- gyros ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("degrees", "bound_mps2"), [(1, 0.04), (3, 0.1), (10, 0.08), (20, 0.15)]
)
def test_a_gyro_bias_is_found_while_the_sensor_moves(degrees, bound_mps2):
    bias = 0.1 * degrees * TEN_DEG
    log = usual(angular_rate_radps=WOBBLE.instant(TIME_S).angular_rate_radps + bias)
    # 10 deg/s is three and a half standard deviations; offline VQF leaves 1 m/s^2
    assert rms(miss(log, WOBBLE.up(TIME_S))) < bound_mps2


def still_then_wobble(t):
    rise = np.clip((t - 5.0) / 2.0, 0.0, 1.0)
    ease = (rise * rise * (3.0 - 2.0 * rise))[..., None]
    angles = [
        0.8 * np.sin(3.0 * t) + 0.5 * t,
        0.5 * np.sin(4.0 * t + 1.0),
        0.6 * np.sin(5.0 * t),
    ]
    return Rotation.from_euler("ZYX", ease * np.stack(angles, axis=-1))


def test_a_gyro_bias_of_ten_degrees_is_found_in_a_still_start():
    motion = Motion(still_then_wobble)
    clean = motion.instant(TIME_S)
    biased = dataclasses.replace(
        clean, angular_rate_radps=clean.angular_rate_radps + TEN_DEG
    )
    done = analyse(biased)
    found = np.array(done.summary["gyro_bias_radps"])
    assert np.abs(found - TEN_DEG).max() < 2e-3
    assert rms(done.track.gravity_mps2 - G * motion.up(TIME_S)) < 0.05


def tumbling(t):
    angle = 2.5 * t - 5.0 * np.cos(0.3 * t)
    return Rotation.from_rotvec(np.multiply.outer(angle, [1.0, 0.0, 0.0]))


def test_a_gyro_with_a_wrong_scale_is_put_right():
    # turns at 1 to 4 rad/s, so that 1 % of it is no constant bias
    motion = Motion(tumbling, shake)
    log, up = motion.instant(TIME_S), motion.up(TIME_S)
    wrong = dataclasses.replace(log, angular_rate_radps=1.01 * log.angular_rate_radps)
    stubborn = SmootherParameters(
        gyro_matrix_sigma=1e-9, gyro_evidence=1e9, scale_evidence=1e9
    )
    assert rms(miss(wrong, up)) < 0.7 * rms(miss(wrong, up, parameters=stubborn))


def test_a_scale_that_nobody_calibrated_is_found():
    motion = Motion(tumbling, shake)
    log, up = motion.instant(TIME_S), motion.up(TIME_S)
    wrong = dataclasses.replace(log, angular_rate_radps=1.05 * log.angular_rate_radps)
    # it turns about x alone
    assert analyse(log).summary["gyro_scale"][0] == pytest.approx(1.0, abs=0.002)
    assert analyse(wrong).summary["gyro_scale"][0] == pytest.approx(1.05, abs=0.005)
    assert rms(miss(wrong, up)) < 0.1


def test_sigma_tells_of_samples_that_are_held():
    ride = simulate_motion("handheld-brisk", 2)
    row = 10 * (np.arange(len(ride.imu)) // 10)
    held = dataclasses.replace(
        ride.imu,
        specific_force_mps2=ride.imu.specific_force_mps2[row],
        angular_rate_radps=ride.imu.angular_rate_radps[row],
    )
    track = remove_gravity(held)
    error = np.linalg.norm(track.gravity_mps2 - G * ride.vertical, axis=1)
    assert np.mean(error < 2.0 * track.gravity_sigma_mps2) > 0.9


def railed(rate, rng):
    """Return rates cut off at 60 % of the largest, on a rail that wobbles by 0.1 %."""
    rail = 0.6 * np.abs(rate).max()
    wobble = 1.0 + 0.001 * rng.standard_normal(rate.shape).clip(-2.0, 2.0)
    return np.where(np.abs(rate) < rail, rate, np.sign(rate) * rail * wobble)


def scaled(rate, _):
    return 1.05 * rate


@pytest.mark.parametrize(
    ("scene", "spoilt"), [("handheld-brisk", scaled), ("run", railed)]
)
def test_a_gyro_that_errs_is_trusted_less(scene, spoilt, rng):
    ride = simulate_motion(scene, 2)
    rate = spoilt(ride.imu.angular_rate_radps, rng)
    log = dataclasses.replace(ride.imu, angular_rate_radps=rate)
    done = analyse(log)
    error = done.track.gravity_mps2 - G * ride.vertical
    trusting = remove_gravity(log, parameters=SmootherParameters(gyro_evidence=1e9))
    assert done.summary["gyro_noise_factor"] > 1.0
    assert "noise" in done.summary["time_constant_from"]
    # by a quarter and by a third; sigma says how large it still is
    assert rms(error) < 0.8 * rms(trusting.gravity_mps2 - G * ride.vertical)
    inside = np.linalg.norm(error, axis=1) < 2.0 * done.track.gravity_sigma_mps2
    assert np.mean(inside) > 0.85


@pytest.mark.parametrize("scene", ["walk", "run", "handheld-brisk", "mountain-bike"])
@pytest.mark.parametrize("seed", [1, 2])
def test_a_good_gyro_is_trusted(scene, seed):
    found = analyse(simulate_motion(scene, seed).imu).summary
    assert found["gyro_noise_factor"] == 1.0


# ---- accelerometers -------------------------------------------------------------


def turned_about(t):
    """Return a slow turn to all sides, by more than a radian."""
    angles = [1.5 * np.sin(0.3 * t), 1.2 * np.sin(0.21 * t + 1), 1.4 * np.sin(0.4 * t)]
    return Rotation.from_euler("ZYX", np.stack(angles, axis=-1))


def test_the_bias_of_an_accelerometer_is_found_by_turning_it():
    motion, bias = Motion(turned_about), np.array([0.15, -0.1, 0.05])
    log = motion.instant(TIME_S)
    biased = dataclasses.replace(
        log, specific_force_mps2=log.specific_force_mps2 + bias
    )
    done = analyse(biased)
    found = np.array(done.summary["accelerometer_bias_mps2"])
    # what it reads too much, as the smoother's equation has it
    assert np.abs(found - bias).max() < 0.01
    assert rms(done.track.gravity_mps2 - G * motion.up(TIME_S)) < 0.02


def test_the_scale_of_an_accelerometer_is_found_without_rest():
    clean = WOBBLE.instant(TIME_S).specific_force_mps2
    found = analyse(usual(specific_force_mps2=1.03 * clean)).summary
    assert found["accelerometer_gain"] == 1.0  # there is no still span
    assert found["accelerometer_scale"] == pytest.approx(1.03, abs=0.01)


# ---- accelerations that last ----------------------------------------------------


@pytest.mark.parametrize("seed", [1, 2])
def test_hard_braking_is_not_taken_for_gravity(seed):
    ride = simulate_motion("car-hard", seed)
    up, force = ride.vertical, ride.imu.specific_force_mps2
    error = rms(miss(ride.imu, up))
    slow = lowpass_vertical(force, 1.0 / ride.imu.rate_hz, 0.5)
    assert error < 0.05 * rms(G * (slow - up))
    assert error < 0.2 * rms(miss(ride.imu, up, "offline-vqf"))
    assert rms(ride.acceleration_mps2) > 20.0 * error


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_quiet_footage_does_not_drift(seed):
    ride = simulate_motion("handheld-quiet", seed)
    error = miss(ride.imu, ride.vertical)
    # offline VQF leaves up to 0.08 m/s^2 of these
    assert rms(error) < 0.06
    third = len(error) // 3
    # a drift would grow towards the ends
    assert rms(error[-third:]) < 0.08
    assert rms(error[:third]) < 0.08


def test_ten_quiet_minutes_do_not_drift():
    ride = simulate_motion("handheld-quiet", 4, duration_s=900.0)
    error = np.linalg.norm(miss(ride.imu, ride.vertical), axis=1)
    assert error.max() < 0.15


@pytest.mark.parametrize(("factor", "moves"), [(1.5, False), (2.5, True)])
def test_only_a_bound_that_is_far_off_is_corrected_twice(monkeypatch, factor, moves):
    """Another solution for the gyro's sake leaves it: a hair decides about that."""
    used_mps, bound_mps = [], [0.5]

    def bound(_solution, duration_s, *_):
        bound_mps.append(bound_mps[-1] * factor)
        return np.full(len(duration_s) + 1, bound_mps[-1])

    def noted(nodes, vertical, frames, known, p):
        used_mps.append(float(known.bound_mps.mean()))
        return linearised(nodes, vertical, frames, known, p)

    linearised = state.linearised
    monkeypatch.setattr(state, "linearised", noted)
    monkeypatch.setattr(block, "velocity_bound", bound)
    # every change of the bias calls for another solution
    eager = SmootherParameters(bias_change_radps=1e-12, solutions=4)
    analyse(usual(), parameters=eager)
    second, third, fourth = used_mps[-3:]
    assert second == pytest.approx(bound_mps[1])
    assert third == pytest.approx(bound_mps[2] if moves else second)
    assert fourth == pytest.approx(bound_mps[3])  # far off by then


def upright(t):
    return Rotation.from_rotvec(np.zeros((*np.shape(t), 3)))


def long_push(rng):
    """Return 1 m/s^2 for 40 s, as of a train, in a sensor that keeps its attitude."""

    def push(t):
        return ((t > 60.0) & (t < 100.0))[:, None] * np.array([1.0, 0.0, 0.0])

    time_s = np.arange(1, 16001) / 100.0
    log = Motion(upright, push).instant(time_s)
    # vibration, so that it does not seem to stand still
    force = log.specific_force_mps2 + 0.5 * rng.standard_normal((len(log), 3))
    return dataclasses.replace(log, specific_force_mps2=force)


@pytest.mark.parametrize(
    ("constant_s", "kept_mps2"), [(1.0, 0.0), (2.0, 0.0), (5.0, 0.0), (100.0, 0.8)]
)
def test_a_person_may_say_how_soon_an_acceleration_is_forgotten(
    constant_s, kept_mps2, rng
):
    p = SmootherParameters(time_constant_s=constant_s)
    done = analyse(long_push(rng), parameters=p)
    assert done.summary["time_constant_s"] == [constant_s, constant_s]
    assert done.summary["time_constant_from"] == "chosen by a person"
    # 15 to 25 s into the push it is levelled away, or not
    kept = done.track.acceleration_mps2[7500:8500, 0].mean()
    assert kept == pytest.approx(kept_mps2, abs=0.25)


@pytest.mark.parametrize("constant_s", [1.0, 5.0, None])
def test_a_long_push_is_not_put_down_to_the_accelerometer(constant_s, rng):
    p = SmootherParameters(time_constant_s=constant_s)
    done = analyse(long_push(rng), parameters=p)
    found = np.abs(done.summary["accelerometer_bias_mps2"]).max()
    # a bias of 0.14 m/s^2 is expected; the sensor has none
    assert found < 5.0 * p.accel_bias_sigma_mps2
    # half a minute after the push little of it is left in the vertical; a train that
    # chooses for itself is held to its velocity no tighter before the push than after
    left = done.track.acceleration_mps2[13000:, 0].mean()
    assert abs(left) < (0.4 if constant_s is None else 0.3)


# ---- rest -----------------------------------------------------------------------


def test_at_rest_nothing_is_left_and_the_summary_says_so(still_log):
    done = analyse(still_log)
    assert done.summary["leak_at_rest_mps2"] < 0.01
    assert done.summary["still_s"] == pytest.approx(10.0, abs=0.2)
    assert done.summary["accelerometer_gain"] == pytest.approx(1 / 1.03, abs=1e-3)
    # the noise itself is 0.02 per axis
    assert rms(done.track.acceleration_mps2) < 0.04
    assert_sound(done.track)


@pytest.mark.parametrize("scene", ["car-calm", "car-brisk", "bicycle", "walk", "run"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_at_rest_hardly_anything_is_left_of_a_bad_sensor(scene, seed):
    # an accelerometer with 0.2 to 0.4 m/s^2 of bias, still for seconds at a time; with
    # the edges of the spans not levelled 0.06 to 0.4 m/s^2 were left, and up to 0.08
    # where what is found of the gyro last turned the frame within an interval
    done = analyse(simulate_motion(scene, seed, sensor="paper-board").imu)
    assert 0.9 < done.summary["still_s"] < 30.0
    assert done.summary["leak_at_rest_mps2"] < 0.045


@pytest.mark.parametrize("name", ["broad_01", "broad_24", "broad_33"])
def test_at_rest_nothing_is_left_of_a_real_recording(recording, name):
    done = analyse(recording(name))
    assert done.summary["still_s"] > 30.0
    # its accelerometer reads 0.1 to 0.8 % too much
    assert 0.99 < done.summary["accelerometer_gain"] < 1.0
    assert done.summary["leak_at_rest_mps2"] < 0.05


@pytest.mark.parametrize("force", [[0, 0, 9.8], [3, 4, 8], [0, 0, -9.8], [0, 0, 0]])
@pytest.mark.parametrize("rate", [[0, 0, 0], [0, 0, 0.05], [0.05, 0, 0]])
def test_constants_are_no_reason_to_fail(force, rate):
    count = 3000
    track = remove_gravity(
        ImuLog(np.arange(count) / 100.0, [force] * count, [rate] * count)
    )
    assert_sound(track)
    expected = abs(np.linalg.norm(force) * track.accelerometer_gain - G)
    # a turn that the force does not see is a bias
    assert rms(track.acceleration_mps2) == pytest.approx(expected, abs=0.05)


def test_a_gyro_that_reads_nothing_leaves_the_mean_direction(rng):
    count = 4000
    force = np.array([0.0, 3.0, 9.3]) + rng.standard_normal((count, 3))
    log = ImuLog(np.arange(count) / 100.0, force, np.zeros((count, 3)))
    up = np.array([0.0, 3.0, 9.3]) / np.hypot(3.0, 9.3)
    assert rms(miss(log, up)) < 0.05


def test_the_uncertainty_never_exceeds_the_possible_error():
    # a force fixed to a spinning sensor contradicts the gyro; the model has no answer
    count = 3000
    log = ImuLog(np.arange(count) / 100.0, [[0, 0, 9.8]] * count, [[3.0, 0, 0]] * count)
    sigma = remove_gravity(log).gravity_sigma_mps2
    assert sigma.max() <= 2.0 * G


# ---- work that is left out ------------------------------------------------------


@pytest.mark.parametrize("scene", ["handheld-quiet", "car-stop-and-go", "walk"])
def test_shortcuts_hardly_change_the_motion(scene):
    log = simulate_motion(scene, 1, duration_s=90.0).imu
    short = remove_gravity(log).acceleration_mps2
    with nothing_skipped():
        whole = remove_gravity(log).acceleration_mps2
    assert rms(short - whole) < 0.01


# ---- parameters -----------------------------------------------------------------


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
@pytest.mark.parametrize("name", ["node_s", "time_constant_s", "gyro_bias_sigma_radps"])
def test_a_parameter_that_cannot_be_is_named(name, value):
    with pytest.raises(UsageError, match=f"{name} must be above zero"):
        SmootherParameters(**{name: value})


@pytest.mark.parametrize(
    "changed",
    [
        {"solutions": 1},
        {"solutions": 2},
        {"solutions": 10},
        {"node_s": 0.05},
        {"node_s": 5.0},
        {"window_hz": 1.0},
        {"window_hz": 1000.0},
        {"node_samples": 1},
        {"bound_half_width_s": 0.01},
        {"vertical_half_width_s": 0.01},
        {"margin_s": 0.01, "block_s": 20.0},
        {"time_constant_s": 0.1},
        {"time_constant_s": 1000.0},
    ],
    ids=lambda changed: " ".join(f"{k}={v}" for k, v in changed.items()),
)
def test_any_setting_gives_a_sound_answer(changed):
    error = miss(usual(), WOBBLE.up(TIME_S), parameters=SmootherParameters(**changed))
    # the shaking is 2.7 m/s^2: whatever the setting, it is not mistaken for gravity
    assert rms(error) < 1.0
