"""Gravity removal against closed-form truth."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, Sampling
from hapticplayer.motion import (
    METHODS,
    estimate_orientation,
    remove_gravity,
)
from hapticplayer.motion.stillness import estimate_accelerometer_gain


def rms(vectors):
    return np.sqrt(np.mean(np.sum(np.square(vectors), axis=1)))


def test_at_rest_gravity_is_removed_even_with_a_wrong_gain(still_log):
    track = remove_gravity(still_log)
    # the noise itself is 0.02 * sqrt(3) = 0.035 m/s^2
    assert rms(track.acceleration_mps2) < 0.04
    assert track.accelerometer_gain == pytest.approx(1 / 1.03, abs=1e-3)
    assert track.valid.all()


def test_the_gain_stays_one_without_a_still_span(swing):
    log, _ = swing
    gain = estimate_accelerometer_gain(log)
    assert gain.gain == 1.0
    assert gain.still_s == 0.0
    assert "no still span" in gain.reason


def test_an_implausible_gain_is_not_used(still_log):
    doubled = dataclasses.replace(
        still_log, specific_force_mps2=2.0 * still_log.specific_force_mps2
    )
    gain = estimate_accelerometer_gain(doubled)
    assert gain.gain == 1.0
    assert "not plausible" in gain.reason


# A sensor that swings by 30 deg at 0.2 Hz, turns and is shaken by 2 m/s^2; no noise.
# What the causal filters leave is what they follow of the shaking; a low-pass of the
# force that does not know of the turning cannot follow the swing either.
LEFT_MPS2 = {
    "smoother": 0.03,
    "offline-vqf": 0.05,
    "vqf": 0.3,
    "ekf": 0.3,
    "lowpass": 1.2,
}


@pytest.mark.parametrize("method", sorted(METHODS))
def test_acceleration_comes_out_of_a_swinging_sensor(swing, method):
    log, truth = swing
    track = remove_gravity(log, method)
    assert rms(track.acceleration_mps2 - truth) < LEFT_MPS2[method]
    # to follow the force would leave as much as there is
    assert LEFT_MPS2[method] < 0.7 * rms(truth)
    assert np.allclose(np.linalg.norm(track.quaternion_wxyz, axis=1), 1.0, atol=1e-9)
    norm = np.linalg.norm(track.gravity_mps2, axis=1)
    assert np.allclose(norm, STANDARD_GRAVITY_MPS2, atol=1e-9)


def test_gravity_and_the_rest_add_up_to_the_recording(swing):
    log, _ = swing
    track = remove_gravity(log)
    total = track.acceleration_mps2 + track.gravity_mps2
    scaled = track.accelerometer_gain * log.specific_force_mps2
    assert np.allclose(total, scaled, atol=1e-12)


def test_uneven_times_cost_little(swing, rng):
    log, truth = swing
    keep = np.sort(rng.choice(len(log), size=int(0.9 * len(log)), replace=False))
    thinned = ImuLog(
        log.time_s[keep], log.specific_force_mps2[keep], log.angular_rate_radps[keep]
    )
    track = remove_gravity(thinned)
    assert len(track) == len(thinned)
    # pretending the samples were even would cost 2 to 5 deg = 0.3 to 0.9 m/s^2
    assert rms(track.acceleration_mps2 - truth[keep]) < 0.15


def test_both_ends_of_a_gap_are_not_valid(swing):
    log, _ = swing
    keep = np.r_[0:2000, 2400:4000]
    holed = ImuLog(
        log.time_s[keep], log.specific_force_mps2[keep], log.angular_rate_radps[keep]
    )
    valid = remove_gravity(holed).valid
    assert np.flatnonzero(~valid).tolist() == [1999, 2000]


@pytest.mark.parametrize(
    ("method", "tolerance_rad"),
    # the filters' answers are turned back by half a window exactly; to the smoother
    # means are other evidence, from which it levels by a little otherwise
    [("ekf", 1e-6), ("vqf", 1e-6), ("offline-vqf", 1e-6), ("smoother", 2e-4)],
)
def test_averaged_samples_get_the_mid_window_orientation(swing, method, tolerance_rad):
    log, _ = swing
    averaged = dataclasses.replace(log, sampling=Sampling.AVERAGED)
    end = estimate_orientation(log, method)
    middle = estimate_orientation(averaged, method)
    half = 0.5 / 200.0
    angle = 2 * np.arccos(np.minimum(1, np.abs(np.sum(end * middle, axis=1))))
    expected = half * np.linalg.norm(log.angular_rate_radps, axis=1)
    # half a window is 1.7e-3 to 2.4e-3 rad
    assert np.allclose(angle, expected, rtol=0.0, atol=tolerance_rad)


def test_hours_of_silence_do_not_become_millions_of_samples():
    time = np.r_[np.arange(100) / 100.0, 36000.0 + np.arange(100) / 100.0]
    force = np.tile([0.0, 0.0, STANDARD_GRAVITY_MPS2], (200, 1))
    track = remove_gravity(ImuLog(time, force, np.zeros((200, 3))))
    assert rms(track.acceleration_mps2) < 0.01


def test_a_method_that_does_not_exist_is_named(still_log):
    with pytest.raises(UsageError, match="offline-vqf"):
        remove_gravity(still_log, "magic")


def test_one_sample_is_too_few():
    log = ImuLog([0.0], [[0, 0, 9.8]], [[0, 0, 0]], source="log.csv")
    with pytest.raises(InputError, match=r"log\.csv.*too few"):
        remove_gravity(log)


@pytest.mark.parametrize("step_s", [1e-7, 1e-6])
def test_times_that_are_hardly_seconds_are_asked_for(step_s):
    force = np.tile([0.0, 0.0, STANDARD_GRAVITY_MPS2], (100, 1))
    log = ImuLog(step_s * np.arange(100), force, np.zeros((100, 3)), source="log.csv")
    with pytest.raises(InputError, match=r"log\.csv.*times in seconds"):
        remove_gravity(log)
