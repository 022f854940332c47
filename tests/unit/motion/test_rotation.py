"""What a gyro is doubted for, and that right recordings are not."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.motion.repair.rotation import (
    dead_axes,
    doubt_about,
    turns_gravity,
    unseen_turn_rad,
)

PIECE_S, EVERY = 20.0, 7
SHORT_S, CLIP_S = 15.0, 10.0
T = np.arange(0, 20, 0.01)
DEGREES = 180.0 / np.pi


def read(path):
    with np.load(path) as data:
        force, rate = data["acc"].astype(float), data["gyr"].astype(float)
        time_s = np.arange(len(force)) / float(data["rate"])
        if "t" in data:  # one has a hole of 23.7 s
            time_s = data["t"] - data["t"][0]
    return time_s, force, rate


def log_of(time_s, force, rate):
    return ImuLog(
        time_s=time_s, specific_force_mps2=force, angular_rate_radps=rate, source="test"
    )


def pieces(time_s, piece_s=PIECE_S):
    count = round(piece_s / float(np.median(np.diff(time_s))))
    begins = range(0, len(time_s) - count, EVERY * count)
    return [slice(begin, begin + count) for begin in begins]


@pytest.mark.parametrize("kind", ["native", "averaged_30hz"])
def test_right_recordings_are_not_doubted(shared_data, kind):
    paths = sorted((shared_data / "orientation" / kind).glob("*.npz"))
    assert len(paths) >= 10
    for path in paths:
        given = read(path)
        for part in [slice(None), *pieces(given[0])]:
            log = log_of(*(values[part] for values in given))
            assert doubt_about(log) is None, (path.stem, part)
            assert not dead_axes(log, None)
            assert not unseen_turn_rad(log), (path.stem, part)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("scene", ["car-hard", "car-brisk", "bicycle"])
def test_vehicles_are_not_doubted(scene, seed):
    """A gyro that rotates too fast averages what a car accelerates."""
    ride = simulate_motion(scene, seed).imu
    for part in [*pieces(ride.time_s), *pieces(ride.time_s, SHORT_S)]:
        log = log_of(
            ride.time_s[part],
            ride.specific_force_mps2[part],
            ride.angular_rate_radps[part],
        )
        assert doubt_about(log) is None
        assert not unseen_turn_rad(log)


@pytest.fixture(scope="module")
def turning(shared_data):
    """A minute of a real recording that turns."""
    path = next((shared_data / "orientation" / "native").glob("broad_04*"))
    time_s, force, rate = read(path)
    part = slice(6000, 24_000)
    return time_s[part], force[part], rate[part]


@pytest.mark.parametrize("scale", [0.5, 0.25, 2.0, 8.0, np.pi / 180.0, 180.0 / np.pi])
def test_a_scale_of_a_real_gyro_is_told(turning, scale):
    time_s, force, rate = turning
    doubt = doubt_about(log_of(time_s, force, scale * rate))
    assert doubt is not None
    assert doubt.scale == pytest.approx(1.0 / scale)


@pytest.mark.parametrize("late_s", [0.3, -0.3, 0.16, -1.0])
def test_a_late_clock_of_a_real_gyro_is_told(turning, late_s):
    time_s, force, rate = turning
    late = [np.interp(time_s - late_s, time_s, axis) for axis in rate.T]
    doubt = doubt_about(log_of(time_s, force, np.stack(late, axis=1)))
    assert doubt is not None
    assert doubt.delay_s == pytest.approx(late_s, abs=0.02)


@pytest.mark.parametrize("axes", [[0], [1], [2], [0, 2], [0, 1, 2]])
def test_an_axis_that_reads_0_is_told(turning, axes):
    time_s, force, rate = turning
    rate = rate.copy()
    rate[:, axes] = 0.0
    assert dead_axes(log_of(time_s, force, rate), None) == axes


@pytest.mark.parametrize(
    ("axis", "left"), [(0, 0.0), (1, 0.0), (2, 0.0), (0, 0.5), (1, 0.5)]
)
def test_a_faulty_axis_of_a_real_gyro_is_told(turning, rng, axis, left):
    """It is dead but for its noise, or has half its range."""
    time_s, force, rate = turning
    rate = rate.copy()
    rate[:, axis] = left * rate[:, axis] + rng.normal(0.0, 0.003, len(rate))
    assert unseen_turn_rad(log_of(time_s, force, rate)) > np.radians(46.0)


def test_a_gap_in_which_it_turns_is_no_fault_of_the_gyro(turning):
    time_s, force, rate = (values.copy() for values in turning)
    kept = (time_s - time_s[0]) % 7.0 > 3.0
    log = log_of(time_s[kept], force[kept], rate[kept])
    assert not unseen_turn_rad(log)


def test_axes_between_which_gravity_cannot_decide_are_all_told(shared_data):
    """A pendulum turns about one axis."""
    path = next(
        (shared_data / "orientation" / "native").glob("*Pendulum_Test08*Segment_1*")
    )
    time_s, force, rate = (values[:3000] for values in read(path))
    doubt = doubt_about(log_of(time_s, force, -rate))
    assert doubt is not None
    assert doubt.change is not None
    found = [doubt.change, *(change for _, change in doubt.gaps)]
    assert any(np.array_equal(change, -np.eye(3)) for change in found)
    assert {round(np.linalg.det(change)) for change in found} == {-1, 1}
    gaps = [gap for gap, _ in doubt.gaps]
    assert gaps == sorted(gaps)


def test_turns_about_the_vertical_tell_nothing_of_axes(rng):
    time_s = np.arange(0.0, 20.0, 0.01)
    force = rng.normal([0.0, 0.0, 9.80665], 0.02, (len(time_s), 3))
    rate = rng.normal(0.0, 0.002, (len(time_s), 3))
    rate[:, 2] += 0.8 * np.sin(time_s)
    assert not turns_gravity(log_of(time_s, force, rate))
    assert doubt_about(log_of(time_s, force, -rate)) is None


def test_a_recording_that_turns_tells_of_axes(turning):
    assert turns_gravity(log_of(*turning))


def swinging_arm(seed, tilted=False):
    """A sensor on a pendulum's bob, where the force stays along the rod.

    With theta = A sin(w t), a bob at r has r theta'' + g sin(theta) across the rod,
    left out where the force is along it alone, and g cos(theta) + r theta'^2 along it.
    """
    rng = np.random.default_rng(seed)
    t = T[T < CLIP_S]
    amplitude, r = np.radians(rng.uniform(20.0, 75.0)), rng.uniform(0.35, 0.8)
    g = STANDARD_GRAVITY_MPS2
    w = np.sqrt(g / r) * (1.0 - amplitude**2 / 16.0)
    phase = w * t + rng.uniform(0.0, 2.0 * np.pi)
    theta, speed = amplitude * np.sin(phase), amplitude * w * np.cos(phase)
    none = np.zeros_like(t)
    across = g * np.sin(theta) - r * w**2 * theta if tilted else none
    along = g * np.cos(theta) + r * speed**2
    mounted = Rotation.random(rng=rng)
    force = mounted.apply(np.stack([none, across, along], axis=1))
    rate = mounted.apply(np.stack([speed, none, none], axis=1))
    bias = rng.normal(0.0, 0.03, 3)
    shape = (len(t), 3)
    force += 0.2 * rng.standard_normal(shape)
    return t, force, rate + bias + 0.01 * rng.standard_normal(shape)


@pytest.mark.parametrize("tilted", [False, True])
def test_swinging_arms_pass_in_rad_and_not_in_degrees(tilted):
    for seed in range(10):
        t, force, rate = swinging_arm(seed, tilted)
        assert doubt_about(log_of(t, force, rate)) is None
        doubt = doubt_about(log_of(t, force, DEGREES * rate))
        assert doubt is not None
        assert doubt.scale == pytest.approx(1.0 / DEGREES)


def test_a_rate_that_was_converted_twice_is_told():
    angle = 1.2 * np.sin(1.5 * T)
    force = Rotation.from_rotvec(np.outer(-angle, [1.0, 0, 0])).apply([0, 0, 9.8])
    rate = np.outer(1.8 * np.cos(1.5 * T), [1.0, 0, 0])
    assert doubt_about(log_of(T, force, rate)) is None
    doubt = doubt_about(log_of(T, force, rate / DEGREES))
    assert doubt is not None
    assert doubt.scale == pytest.approx(DEGREES)


@pytest.mark.parametrize("bias", [(0, 0, 0), (0.1, -0.1, 0.1), (0.0, 0.61, 1.9)])
def test_rest_and_its_bias_are_not_doubted(rng, bias):
    force = [0.0, 3.0, 9.3] + 0.02 * rng.standard_normal((len(T), 3))
    rate = np.array(bias) + 0.003 * rng.standard_normal((len(T), 3))
    assert doubt_about(log_of(T, force, rate)) is None


def test_ten_seconds_of_phones_in_degrees_are_told(shared_data):
    paths = sorted((shared_data / "orientation" / "averaged_30hz").glob("tyrex*"))
    assert paths
    for path in paths:
        time_s, force, rate = read(path)
        for part in pieces(time_s, CLIP_S):
            given = time_s[part], force[part]
            assert doubt_about(log_of(*given, rate[part])) is None
            doubt = doubt_about(log_of(*given, DEGREES * rate[part]))
            assert doubt is not None
            assert doubt.scale == pytest.approx(1.0 / DEGREES)
