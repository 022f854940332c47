"""The motion of a rig against rides whose truth is known in closed form."""

import numpy as np
import pytest

from hapticplayer.model import MotionTrack, Sampling
from hapticplayer.model.quaternions import from_rotation_vector, multiply
from hapticplayer.model.rig import RigMotion
from hapticplayer.rendering.rig import (
    HEADING_TIME_S,
    VELOCITY_TIME_S,
    rig_demonstration,
    rig_track,
)

TIME_S = np.arange(0.0, 20.0, 0.005)


def motion(acceleration=None, q=None, valid=None, time_s=TIME_S, **more):
    rows = len(time_s)
    return MotionTrack(
        time_s,
        np.zeros((rows, 3)) if acceleration is None else acceleration,
        np.tile([0.0, 0.0, 9.81], (rows, 1)),
        1.0,
        np.tile([1.0, 0.0, 0.0, 0.0], (rows, 1)) if q is None else q,
        None,
        np.ones(rows, bool) if valid is None else valid,
        **more,
    )


def about(axis, angle_rad):
    vector = np.zeros((len(angle_rad), 3))
    vector[:, axis] = angle_rad
    return from_rotation_vector(vector)


def columns(track):
    return dict(zip(RigMotion._fields, track.motion.T.astype(float), strict=True))


def test_acceleration_is_that_of_the_recording():
    acceleration = np.random.default_rng(1).normal(size=(len(TIME_S), 3))
    track = rig_track(motion(acceleration))
    np.testing.assert_allclose(track.motion[:, :3], acceleration, rtol=1e-6)
    np.testing.assert_array_equal(track.time_s, TIME_S)
    for name, values in columns(track).items():
        if "_rad" in name:
            assert not values.any(), name


def test_pitch_roll_and_their_rates_are_the_ones_of_the_ride():
    heading = 0.3 * TIME_S  # turning all the time must not leak
    pitch = 0.2 + 0.10 * np.sin(1.5 * TIME_S)
    roll = -0.1 + 0.15 * np.sin(2.0 * TIME_S)
    q = multiply(multiply(about(2, heading), about(0, pitch)), about(1, roll))
    got = columns(rig_track(motion(q=q)))
    np.testing.assert_allclose(got["pitch_rad"], pitch - np.median(pitch), atol=1e-6)
    np.testing.assert_allclose(got["roll_rad"], roll - np.median(roll), atol=1e-6)
    # w = Ry(-roll) (pitch' x + Rx(-pitch) heading' z) + roll' y
    pitch_rate, roll_rate = (
        0.15 * np.cos(1.5 * TIME_S),
        0.30 * np.cos(2.0 * TIME_S),
    )
    cosine = 0.3 * np.cos(pitch)
    expected = {
        "pitch_radps": np.cos(roll) * pitch_rate - np.sin(roll) * cosine,
        "roll_radps": roll_rate + 0.3 * np.sin(pitch),
        "yaw_radps": np.sin(roll) * pitch_rate + np.cos(roll) * cosine,
    }
    for name, values in expected.items():
        np.testing.assert_allclose(got[name][2:-2], values[2:-2], atol=2e-4)
        change = np.gradient(values, TIME_S)
        np.testing.assert_allclose(got[f"{name}2"][4:-4], change[4:-4], atol=0.01)


def test_a_steady_turn_gives_a_heading_that_ends():
    q = about(2, 0.5 * TIME_S)
    heading = columns(rig_track(motion(q=q)))["heading_rad"]
    law = 0.5 * HEADING_TIME_S * (1.0 - np.exp(-TIME_S / HEADING_TIME_S))
    np.testing.assert_allclose(heading, law, atol=1e-4)


def test_velocity_is_an_integral_that_forgets():
    acceleration = np.zeros((len(TIME_S), 3))
    acceleration[:, 2] = np.cos(6.0 * TIME_S)
    up_mps = columns(rig_track(motion(acceleration)))["up_mps"]
    rate = 1.0 / VELOCITY_TIME_S
    law = rate * np.cos(6.0 * TIME_S) + 6.0 * np.sin(6.0 * TIME_S)
    law = (law - rate * np.exp(-rate * TIME_S)) / (rate**2 + 36.0)
    np.testing.assert_allclose(up_mps, law, atol=1e-3)


def test_samples_that_are_not_valid_give_no_acceleration():
    valid = TIME_S < 10.0
    track = rig_track(motion(np.ones((len(TIME_S), 3)), valid=valid))
    assert np.all(track.motion[valid, :3] == 1.0)
    assert not track.motion[~valid, :3].any()


def test_window_means_get_the_entries_that_a_force_gets():
    time_s = np.arange(0.0, 5.0, 1 / 30)
    wave = np.sin(2 * np.pi * 6.0 * time_s)[:, None] * np.ones(3)
    track = rig_track(motion(wave, time_s=time_s, sampling=Sampling.AVERAGED))
    assert len(track.time_s) > 3 * len(time_s)
    inside = (track.time_s > 1.0) & (track.time_s < 4.0)
    assert np.abs(track.motion[inside, 0]).max() > 1.0  # lines keep less of it


def test_signs_of_a_quaternion_do_not_matter():
    q = about(0, 0.3 * np.sin(TIME_S))
    flipped = q * np.where(np.arange(len(q)) % 2, -1.0, 1.0)[:, None]
    one, other = rig_track(motion(q=q)).motion, rig_track(motion(q=flipped)).motion
    np.testing.assert_allclose(one, other, atol=1e-6)


def test_one_sample_is_a_track_too():
    track = rig_track(motion(time_s=np.array([1.0])))
    assert track.motion.shape == (1, 15)
    assert track.motion.dtype == np.float32
    assert track.active_s.tolist() == [[1.0, pytest.approx(1.0)]]


def test_a_long_uneven_recording_is_the_same_sum():
    random = np.random.default_rng(3)
    time_s = np.cumsum(random.uniform(0.01, 0.5, 600))
    time_s[300:] += 70.0  # a gap
    acceleration = random.normal(size=(600, 3))
    got = columns(rig_track(motion(acceleration, time_s=time_s)))["front_mps"]
    y, law = 0.0, [0.0]
    for row in range(1, 600):
        kept = np.exp(-(time_s[row] - time_s[row - 1]) / VELOCITY_TIME_S)
        mean = 0.5 * (acceleration[row, 1] + acceleration[row - 1, 1])
        y = kept * y + mean * VELOCITY_TIME_S * (1.0 - kept)
        law.append(y)
    np.testing.assert_allclose(got, law, atol=1e-6)


def test_the_demonstration_moves_one_axis_at_a_time_and_gently():
    track, steps = rig_demonstration()
    got = columns(track)
    moved = {
        "surge": {"front_mps2"},
        "sway": {"right_mps2"},
        "heave": {"up_mps2"},
        "roll": {"roll_rad", "roll_radps", "roll_radps2"},
        "pitch": {"pitch_rad", "pitch_radps", "pitch_radps2"},
        "yaw": {"heading_rad", "yaw_radps", "yaw_radps2"},
    }
    assert [step.axis for step in steps] == list(moved)
    for step in steps:
        inside = (track.time_s > step.begin_s) & (track.time_s < step.end_s)
        assert {n for n, v in got.items() if np.abs(v[inside]).max() > 1e-3} == moved[
            step.axis
        ]
    assert max(np.abs(got[name]).max() for name in got if "_mps2" in name) < 0.5
    assert max(np.abs(got[name]).max() for name in got if name.endswith("_rad")) < 0.03
    assert not track.motion[[0, -1]].any()
    rate = np.gradient(got["roll_rad"], track.time_s)
    np.testing.assert_allclose(got["roll_radps"], rate, atol=1e-6)
