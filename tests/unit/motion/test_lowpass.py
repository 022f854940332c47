"""The zero-phase low-pass vertical against closed forms."""

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import quaternions as quat
from hapticplayer.motion.lowpass import lowpass_vertical, orientation_from_vertical

T = 0.01


def shaken(frequency_hz, amplitude_mps2=2.0, seconds=60.0):
    """An upright sensor shaken along x; the middle third is clear of the ends."""
    t = np.arange(0.0, seconds, T)
    force = np.zeros((len(t), 3))
    force[:, 0] = amplitude_mps2 * np.sin(2 * np.pi * frequency_hz * t)
    force[:, 2] = G
    middle = slice(len(t) // 3, 2 * len(t) // 3)
    return t, force, middle


@pytest.mark.parametrize("ratio", [0.25, 0.5, 1.0, 2.0, 4.0])
def test_the_frequency_response_is_that_of_butterworth_twice(ratio):
    cutoff = 1.0
    t, force, middle = shaken(ratio * cutoff)
    up = lowpass_vertical(force, T, cutoff)
    # up = (gain a sin, 0, g) / norm, so its slope is the filtered component over g
    slope = (up[:, 0] / up[:, 2])[middle]
    wave = np.sin(2 * np.pi * ratio * cutoff * t)[middle]
    gain = 2.0 * np.mean(slope * wave) * G / 2.0
    assert gain == pytest.approx(1.0 / (1.0 + ratio**4), abs=2e-3)
    # zero phase: nothing of it is a quarter of a period late
    late = np.cos(2 * np.pi * ratio * cutoff * t)[middle]
    assert abs(2.0 * np.mean(slope * late) * G / 2.0) < 1e-3


def test_the_vertical_at_rest_is_the_specific_force(still_log):
    up = lowpass_vertical(still_log.specific_force_mps2, 1 / 200)
    truth = np.array([0.2, -0.3, 0.9]) / np.linalg.norm([0.2, -0.3, 0.9])
    # noise of 0.02 m/s^2 at 200 Hz, of which 1 Hz of 100 passes
    assert np.linalg.norm(up - truth, axis=1).max() < 1.5e-3
    assert np.allclose(np.linalg.norm(up, axis=1), 1.0, atol=1e-12)


def test_running_it_backwards_gives_the_same_backwards(swing):
    log, _ = swing
    force = log.specific_force_mps2
    there = lowpass_vertical(force, 1 / 200)
    back = lowpass_vertical(force[::-1], 1 / 200)[::-1]
    assert np.abs(there - back).max() < 1e-3


def test_turning_the_sensor_turns_the_vertical(swing):
    log, _ = swing
    q = quat.normalized(np.array([0.3, -0.7, 0.2, 0.6]))
    turned = quat.rotate(q, log.specific_force_mps2)
    expected = quat.rotate(q, lowpass_vertical(log.specific_force_mps2, 1 / 200))
    assert np.allclose(lowpass_vertical(turned, 1 / 200), expected, atol=1e-12)


@pytest.mark.parametrize("count", [0, 1, 2, 3, 10, 50, 199, 201])
def test_recordings_shorter_than_the_padding_work(count):
    up = lowpass_vertical(np.tile([0.0, 3.0, 4.0], (count, 1)), T)
    assert up.shape == (count, 3)
    assert np.allclose(up, [0.0, 0.6, 0.8], atol=1e-12)


def test_at_a_rate_too_low_for_the_cutoff_nothing_is_filtered():
    force = np.array([[0.0, 3.0, 4.0], [5.0, 0.0, 12.0], [0.0, 0.0, 9.0]])
    up = lowpass_vertical(force, 0.5, 1.0)
    assert np.allclose(up, force / np.linalg.norm(force, axis=1, keepdims=True))


def test_free_fall_holds_the_last_direction():
    force = np.tile([6.0, 0.0, 8.0], (3000, 1))
    force[1000:2000] = 0.0
    up = lowpass_vertical(force, T)
    assert np.isfinite(up).all()
    assert np.allclose(up, [0.6, 0.0, 0.8], atol=1e-9)


def test_a_start_in_free_fall_takes_the_first_direction():
    force = np.tile([0.0, 0.0, -G], (2000, 1))
    force[:1000] = 0.0
    assert np.allclose(lowpass_vertical(force, T), [0.0, 0.0, -1.0], atol=1e-9)


def test_a_dead_accelerometer_leaves_the_sensor_upright():
    assert np.array_equal(
        lowpass_vertical(np.zeros((5, 3)), T), np.tile([0.0, 0.0, 1.0], (5, 1))
    )


@pytest.mark.parametrize("bad", [0.0, -1.0, np.inf, np.nan])
def test_an_interval_or_cutoff_that_is_not_positive_is_refused(bad):
    force = np.ones((10, 3))
    with pytest.raises(InputError, match="interval_s"):
        lowpass_vertical(force, bad)
    with pytest.raises(InputError, match="cutoff_hz"):
        lowpass_vertical(force, T, bad)


def wandering_vertical(count=5000):
    """A path over the whole sphere, through both poles."""
    s = np.linspace(0.0, 4.0 * np.pi, count)
    polar, around = 1.5 * s, 0.3 * np.sin(s)
    return np.stack(
        [
            np.sin(polar) * np.cos(around),
            np.sin(polar) * np.sin(around),
            np.cos(polar),
        ],
        axis=1,
    )


def test_the_orientation_has_the_vertical_it_was_made_from():
    up = wandering_vertical()
    q = orientation_from_vertical(up)
    assert np.abs(quat.vertical(q) - up).max() < 1e-12
    assert np.abs(np.linalg.norm(q, axis=1) - 1.0).max() < 1e-12


def test_the_orientation_changes_as_little_as_the_vertical_does():
    up = wandering_vertical()
    q = orientation_from_vertical(up)
    # a turn by phi moves q by 2 sin(phi / 4), and the vertical by 2 sin(phi / 2)
    turn = 4.0 * np.arcsin(0.5 * np.linalg.norm(np.diff(q, axis=0), axis=1))
    arc = 2.0 * np.arcsin(0.5 * np.linalg.norm(np.diff(up, axis=0), axis=1))
    assert np.allclose(turn, arc, atol=1e-9)


def test_a_sensor_upside_down_gets_half_a_turn():
    q = orientation_from_vertical(np.tile([0.0, 0.0, -1.0], (3, 1)))
    assert np.abs(q[:, 0]).max() < 1e-12
    assert np.abs(quat.vertical(q) - [0.0, 0.0, -1.0]).max() < 1e-12


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_vertical_that_jumps_to_its_opposite_is_followed(axis):
    up = np.tile(np.eye(3)[axis], (4, 1))
    up[2:] *= -1.0
    q = orientation_from_vertical(up)
    assert np.abs(quat.vertical(q) - up).max() < 1e-12


@pytest.mark.parametrize("count", [0, 1, 2])
def test_very_short_verticals_work(count):
    q = orientation_from_vertical(np.tile([0.6, 0.0, 0.8], (count, 1)))
    assert q.shape == (count, 4)
    assert np.allclose(quat.vertical(q), [0.6, 0.0, 0.8], atol=1e-12)
