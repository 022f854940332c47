"""The default method where samples are few, missing, or unevenly spaced."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.motion import remove_gravity
from tests.unit.motion.smoother.conftest import (
    TIME_S,
    WOBBLE,
    assert_sound,
    miss,
    rms,
    window_means,
)


@pytest.mark.parametrize("sampling", list(Sampling))
@pytest.mark.parametrize("count", [2, 3, 5, 8, 13, 50, 101])
def test_a_few_samples_are_enough(count, sampling):
    time_s = TIME_S[:count]
    log = dataclasses.replace(WOBBLE.instant(time_s), sampling=sampling)
    track = remove_gravity(log)
    assert len(track) == count
    assert_sound(track)
    # nothing but the direction of the force is known, and that within 1.5 m/s^2
    lean = np.linalg.norm(track.gravity_mps2 - log.specific_force_mps2, axis=1)
    assert lean.max() < 5.0


@pytest.mark.parametrize("step_s", [0.5, 1.0, 10.0, 60.0, 700.0, 4000.0])
def test_samples_may_be_seconds_or_hours_apart(step_s, rng):
    # nothing holds from one to the next; the answer may be poor, but it is one
    force = np.array([0.0, 0.0, 9.8]) + 0.1 * rng.standard_normal((60, 3))
    log = ImuLog(step_s * np.arange(60), force, 0.01 * rng.standard_normal((60, 3)))
    track = remove_gravity(log)
    assert_sound(track)
    assert np.linalg.norm(track.gravity_mps2, axis=1) == pytest.approx(G, rel=1e-6)


def with_hole(start, stop):
    keep = np.r_[0:start, stop : len(TIME_S)]
    log = WOBBLE.instant(TIME_S)
    holed = ImuLog(
        TIME_S[keep], log.specific_force_mps2[keep], log.angular_rate_radps[keep]
    )
    return holed, WOBBLE.up(TIME_S[keep])


@pytest.mark.parametrize("stop", [2060, 2100, 2400, 3000])
@pytest.mark.parametrize("start", [2000, 2020])
def test_a_hole_is_forgotten_ten_seconds_later(start, stop):
    holed, up = with_hole(start, stop)
    error = np.linalg.norm(miss(holed, up), axis=1)
    begin_s, end_s = TIME_S[start], TIME_S[stop]
    far = (holed.time_s < begin_s - 10.0) | (holed.time_s > end_s + 10.0)
    # 1 degree is 0.17 m/s^2
    assert error[far].max() < 0.15


@pytest.mark.parametrize("stop", [2060, 2100, 2400, 3000])
@pytest.mark.parametrize("start", [2000, 2020])
def test_valid_samples_beside_a_gap_are_right_or_uncertain(start, stop):
    holed, up = with_hole(start, stop)
    track = remove_gravity(holed)
    error = np.linalg.norm(track.gravity_mps2 - G * up, axis=1)
    bound = 0.3 + 3.0 * track.gravity_sigma_mps2
    assert (error[track.valid] / bound[track.valid]).max() < 1.0


@pytest.mark.parametrize("hours", [0.1, 10.0, 1000.0])
def test_hours_without_samples_leave_both_sides_as_they_were(hours):
    log = WOBBLE.instant(TIME_S)
    later = np.where(TIME_S > 30.0, TIME_S + 3600.0 * hours, TIME_S)
    parted = dataclasses.replace(log, time_s=later)
    track = remove_gravity(parted)
    assert_sound(track)
    assert np.flatnonzero(~track.valid).tolist() == [2999, 3000]
    error = track.gravity_mps2 - G * WOBBLE.up(TIME_S)
    assert np.linalg.norm(error, axis=1).max() < 0.1


def lognormal_times(rng):
    return np.cumsum(np.exp(rng.normal(size=4000)) * 0.008)


def poisson_times(rng):
    return np.cumsum(rng.exponential(0.01, 5000) + 1e-4)


def jittered_times(rng):
    return TIME_S + 0.004 * rng.uniform(-1.0, 1.0, len(TIME_S))


@pytest.mark.parametrize("times", [jittered_times, poisson_times, lognormal_times])
def test_uneven_times_do_no_harm_where_values_hold_between_them(times, rng):
    # what ImuLog says of INSTANT: the value holds over the interval that ends there
    time_s = times(rng)
    error = miss(WOBBLE.instant(time_s), WOBBLE.up(time_s))
    # offline VQF on an even grid leaves 0.024 m/s^2
    assert rms(error) < 0.05


@pytest.mark.parametrize("rate_hz", [30, 60])
def test_dropped_means_do_not_displace_the_others(rate_hz, rng):
    width_s, count = 1.0 / rate_hz, 40 * rate_hz
    log = WOBBLE.averaged(count, width_s)
    up = window_means(WOBBLE.up, log.time_s, width_s)
    keep = np.sort(rng.choice(count, round(0.9 * count), replace=False))
    thinned = ImuLog(
        log.time_s[keep],
        log.specific_force_mps2[keep],
        log.angular_rate_radps[keep],
        sampling=Sampling.AVERAGED,
    )
    track = remove_gravity(thinned)
    error = track.gravity_mps2 - G * up[keep]
    after = np.diff(keep, prepend=-1) > 1
    # filling the holes by straight lines first leaves 0.04 and 0.012 m/s^2 in all
    assert rms(error[track.valid & ~after]) < 0.08
    assert rms(error[track.valid & after]) < 0.12
