"""Lever arm, rotation, gains per axis, fitted gain and soft knee, by closed forms."""

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import ImuLog, Mapping, MotionTrack
from hapticplayer.rendering import LEVER_ARMS_M, at_point, fit_gain, render_force

COUNT, RATE_HZ = 1000, 100.0
TIME_S = np.arange(COUNT) / RATE_HZ


def motion(acceleration, valid=None):
    count = len(acceleration)
    return MotionTrack(
        time_s=np.arange(count) / RATE_HZ,
        acceleration_mps2=acceleration,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0, 0, 0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, bool) if valid is None else valid,
    )


def turning(rates_radps):
    zeros = np.zeros((COUNT, 3))
    return motion(zeros), ImuLog(TIME_S, zeros, rates_radps)


def test_a_constant_turn_gives_the_centripetal_acceleration():
    track, imu = turning(np.tile([0.0, 0.0, 3.0], (COUNT, 1)))
    moved = at_point(track, imu, (0.5, 0.2, 9.0)).acceleration_mps2
    # towards the axis, omega^2 times the distance from it
    np.testing.assert_allclose(moved, np.tile([-4.5, -1.8, 0.0], (COUNT, 1)), atol=1e-9)


def test_a_growing_turn_adds_the_tangential_acceleration():
    rates = np.outer(2.0 * TIME_S, [0.0, 1.0, 0.0])
    track, imu = turning(rates)
    moved = at_point(track, imu, (0.0, 0.0, 0.3)).acceleration_mps2
    expected = np.zeros((COUNT, 3))
    expected[:, 0] = 2.0 * 0.3
    expected[:, 2] = -0.3 * rates[:, 1] ** 2
    np.testing.assert_allclose(moved, expected, atol=1e-6)


@pytest.mark.parametrize(("rate_hz", "share"), [(2.0, 1.0), (15.0, 0.5**0.5)])
def test_the_angular_rate_is_smoothed_at_15_hz(rate_hz, share):
    time_s = np.arange(4000) / 1000.0
    rates = np.zeros((4000, 3))
    rates[:, 2] = np.sin(2.0 * np.pi * rate_hz * time_s)
    track = motion(np.zeros((390, 3)))
    imu = ImuLog(time_s, np.zeros((4000, 3)), rates)
    moved = at_point(track, imu, (1.0, 0.0, 0.0)).acceleration_mps2[100:300, 1]
    # alpha of a sine: 2 pi f; sampled 100 times a second
    expected = share * 2.0 * np.pi * rate_hz
    assert np.sqrt(2.0 * np.mean(moved**2)) == pytest.approx(expected, rel=0.01)


def test_a_log_of_20_hz_is_smoothed_below_half_its_rate():
    time_s = np.arange(200) / 20.0
    imu = ImuLog(time_s, np.zeros((200, 3)), np.tile([0.0, 0.0, 2.0], (200, 1)))
    moved = at_point(motion(np.zeros((900, 3))), imu, LEVER_ARMS_M["handlebar"])
    assert np.allclose(moved.acceleration_mps2[:, 1], -4.0 * 0.45)


def test_an_angular_rate_that_is_not_valid_reaches_no_force():
    rates = np.tile([0.0, 0.0, 3.0], (COUNT, 1))
    valid = np.ones(COUNT, bool)
    valid[400:500] = False
    rates[~valid] = 700.0
    imu = ImuLog(TIME_S, np.zeros((COUNT, 3)), rates, valid=valid)
    moved = at_point(motion(np.zeros((COUNT, 3))), imu, (0.5, 0.0, 0.0))
    np.testing.assert_allclose(moved.acceleration_mps2[:, 0], -4.5, atol=1e-9)


def test_a_lever_arm_is_rendered_and_needs_the_angular_rate():
    track, imu = turning(np.tile([0.0, 0.0, 3.0], (COUNT, 1)))
    mapping = Mapping(lever_arm_m=(0.5, 0.0, 0.0))
    force = render_force(track, mapping, imu)
    np.testing.assert_allclose(force.force_n[:, 0], -4.5 * 0.4, atol=1e-6)
    assert force.provenance["lever_arm_m"] == [0.5, 0.0, 0.0]
    with pytest.raises(InputError, match="angular rate"):
        render_force(track, mapping)


def test_a_rotation_then_one_gain_for_each_axis():
    axes = np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])
    mapping = Mapping(axes, (0.1, 0.2, 0.3))
    force = render_force(motion(np.array([[5.0, 0.0, 1.0]])), mapping).force_n
    np.testing.assert_allclose(force[0], [0.1 * 3.0, 0.2 * 4.0, 0.3], atol=1e-6)
    assert Mapping(gain_n_per_mps2=(0.4, 0.4, 0.4)).gain_n_per_mps2 == 0.4


@pytest.mark.parametrize(("size", "limited"), [(3.0, None), (0.1, 1.6), (90.0, 0.2)])
def test_a_fitted_gain_puts_the_quantile_at_3_5_newtons(rng, size, limited):
    p = size * rng.standard_normal((COUNT, 3))
    valid = np.arange(COUNT) % 7 > 0
    p[~valid] = 1e3
    track, duration_s = motion(p, valid), 8.0
    gain = fit_gain(track, Mapping(), duration_s)
    within = valid & (track.time_s <= duration_s)
    high = np.quantile(np.sqrt((p[within] ** 2).sum(axis=1)), 0.995)
    assert gain == pytest.approx(limited or 3.5 / high)
    with pytest.raises(InputError, match="no valid motion"):
        fit_gain(motion(p, valid & False), Mapping(), duration_s)


def test_a_soft_knee_is_smooth_and_stays_below_the_limit():
    planned = np.linspace(0.0, 40.0, 40001)
    p = np.outer(planned / 0.4, [0.6, 0.0, 0.8])
    track = render_force(motion(p), Mapping(soft_knee_n=2.0))
    force = track.force_n.astype(float)
    size = np.linalg.norm(force, axis=1)
    assert np.all(size <= 4.5 + 1e-6)
    low = planned <= 2.0
    np.testing.assert_allclose(size[low], planned[low], atol=1e-6)
    assert size[planned.searchsorted(4.5)] == pytest.approx(2 + 2.5 * np.tanh(1.0))
    # float32 rounds to 5e-7 N, over 0.01 N 1e-4 of the slope
    slope = (size[10:] - size[:-10]) / 0.01
    assert np.all(slope > -2e-4)
    assert np.all(slope < 1.0 + 2e-4)
    assert np.abs(np.diff(slope)).max() < 1e-3
    np.testing.assert_allclose(force[1:, 1] / size[1:], 0.8, atol=1e-6)
    assert track.provenance["saturated_share"] == 0.0
    assert track.provenance["compressed_share"] == pytest.approx(0.95, abs=1e-3)
