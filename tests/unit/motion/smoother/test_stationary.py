"""What stands still from beginning to end is not looked at sample by sample."""

import dataclasses

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.motion import analyse, remove_gravity
from hapticplayer.motion.smoother import state, stationary, strapdown
from hapticplayer.motion.smoother.stationary import (
    StillBins,
    apparent_acceleration,
)
from tests.unit.motion.smoother.conftest import assert_sound, nothing_skipped, rms

ATTITUDE = Rotation.from_rotvec([0.3, -0.5, 0.2])


def on_a_tripod(rng, rate_hz=200.0, seconds=60.0, **more) -> ImuLog:
    count = round(rate_hz * seconds)
    noise = rng.standard_normal((2, count, 3))
    return ImuLog(
        np.arange(count) / rate_hz,
        1.02 * ATTITUDE.inv().apply([0.0, 0.0, G]) + 0.035 * noise[0],
        np.array([0.004, -0.003, 0.005]) + 0.003 * noise[1],
        **more,
    )


def work(log: ImuLog, monkeypatch) -> int:
    """Return how many samples are integrated."""
    touched = []
    opened = strapdown.integrate

    def counting(samples, *more, **named):
        touched.append(len(samples))
        return opened(samples, *more, **named)

    with monkeypatch.context() as patch:
        patch.setattr(strapdown, "integrate", counting)
        remove_gravity(log)
    return sum(touched)


@pytest.mark.parametrize("sampling", list(Sampling))
@pytest.mark.parametrize("rate_hz", [30.0, 200.0, 1000.0])
def test_the_motion_is_that_of_the_full_rate(rng, rate_hz, sampling):
    log = on_a_tripod(rng, rate_hz, sampling=sampling)
    # a gyro's noise is the same per root hertz
    calm = log.angular_rate_radps - log.angular_rate_radps.mean(axis=0)
    rate = log.angular_rate_radps - (1.0 - np.sqrt(rate_hz / 1000.0)) * calm
    log = dataclasses.replace(log, angular_rate_radps=rate)
    done = remove_gravity(log)
    assert_sound(done)
    with nothing_skipped():
        change = done.acceleration_mps2 - remove_gravity(log).acceleration_mps2
    assert np.linalg.norm(change, axis=1).max() < 0.01
    up = ATTITUDE.inv().apply([0.0, 0.0, G])
    assert rms(done.gravity_mps2 - up) < 0.05


def test_so_little_of_the_work_is_left(rng, monkeypatch):
    log = on_a_tripod(rng)
    short = work(log, monkeypatch)
    with nothing_skipped():
        assert short < 0.2 * work(log, monkeypatch)


def test_its_nodes_are_twice_as_far_apart(rng, monkeypatch):
    def nodes():
        counted = []

        def noted(nodes, *more):
            counted.append(len(nodes.duration_s))
            return linearised(nodes, *more)

        with monkeypatch.context() as patch:
            patch.setattr(state, "linearised", noted)
            remove_gravity(log)
        return counted[-1]

    log, linearised = on_a_tripod(rng), state.linearised
    short = nodes()
    with nothing_skipped():
        assert short == pytest.approx(0.5 * nodes(), rel=0.05)


def test_a_recording_that_moves_for_a_moment_is_used_in_full(rng, monkeypatch):
    log = on_a_tripod(rng)
    force = log.specific_force_mps2.copy()
    force[6000:6200, 0] += 3.0 * np.sin(0.05 * np.arange(200))
    knocked = dataclasses.replace(log, specific_force_mps2=force)
    assert work(knocked, monkeypatch) >= len(log)


def test_the_summary_is_the_same(rng):
    log = on_a_tripod(rng)
    short = analyse(log).summary
    with nothing_skipped():
        whole = analyse(log).summary
    assert short["leak_at_rest_mps2"] < 0.02
    assert short["still_s"] == whole["still_s"] == pytest.approx(60.0)
    assert short["gravity_sigma_mps2"] == pytest.approx(
        whole["gravity_sigma_mps2"], rel=0.1
    )
    assert short["gyro_bias_radps"] == pytest.approx(whole["gyro_bias_radps"], abs=1e-4)


def test_only_what_is_still_to_its_end_is_taken_in_parts():
    at = np.linspace(0.0, 2000.0, 41)
    still = StillBins(at, at, np.zeros(3), 1e-3)
    assert stationary.decimation_of(still, 2030, 0.005) == 12
    assert stationary.decimation_of(still, 1000, 0.005) == 1  # too short
    assert stationary.decimation_of(None, 2030, 0.005) == 1
    some = dataclasses.replace(still, still=0.97 * at)
    assert stationary.decimation_of(some, 2030, 0.005) == 1
    for count, ends in ((2000, 200.0), (2003, 201.0), (2030, 200.0)):
        parts = still.decimated(10, count)
        assert parts.edges[-1] == parts.still[-1] == pytest.approx(ends)


def test_quaternions_get_one_sign_each_with_the_one_before(rng):
    turns = Rotation.from_rotvec(0.01 * np.cumsum(rng.standard_normal((50, 3)), axis=0))
    q = turns.as_quat(scalar_first=True)
    flipped = q * np.where(rng.random(50) < 0.5, -1.0, 1.0)[:, None]
    found = stationary.with_one_sign(flipped)
    assert np.abs(np.abs(np.sum(q * found, axis=1)) - 1.0).max() < 1e-12
    assert (np.sum(found[1:] * found[:-1], axis=1) > 0.0).all()


def test_means_stand_for_the_middles_of_their_parts():
    # of parts of 4, between the second sample and the third
    rows = np.arange(50.0)[:, None]
    middle = stationary.interpolated(rows, 4, 200, averaged=True)
    assert middle[4:8, 0] == pytest.approx([0.625, 0.875, 1.125, 1.375])


@pytest.mark.parametrize("averaged", [False, True])
@pytest.mark.parametrize(("per_part", "count"), [(1, 9), (2, 17), (5, 43), (12, 100)])
def test_between_the_middles_of_parts_there_are_straight_lines(
    rng, per_part, count, averaged
):
    values = rng.standard_normal((-(-count // per_part), 3))
    place = (np.arange(count) + (0.5 if averaged else 1.0)) / per_part - 0.5
    rows = np.arange(len(values))
    expected = np.stack([np.interp(place, rows, one) for one in values.T], axis=1)
    found = stationary.interpolated(values, per_part, count, averaged=averaged)
    assert np.abs(found - expected).max() < 1e-12


# ---- zero-velocity intervals ----------------------------------------------------


@pytest.fixture
def solved_s(rng):
    return rng.uniform(0.5, 1.0, 40)


@pytest.fixture
def found(rng):
    return rng.standard_normal((2, 41))


def test_an_acceleration_is_the_change_of_velocity_over_time(found, solved_s):
    change = np.linalg.norm(np.diff(found), axis=0)
    apparent = apparent_acceleration(found, solved_s, solved_s)
    assert apparent == pytest.approx(change / solved_s)


def test_intervals_that_were_solved_need_no_interpolation(found, solved_s):
    same = apparent_acceleration(found, solved_s, solved_s)
    assert apparent_acceleration(found, solved_s, solved_s.copy()) == pytest.approx(
        same
    )


def test_half_an_interval_of_steady_acceleration_has_all_of_it(solved_s):
    time_s = np.concatenate([[0.0], np.cumsum(solved_s)])
    steady = np.stack([3.0 * time_s, -4.0 * time_s])
    halves_s = np.repeat(0.5 * solved_s, 2)
    assert apparent_acceleration(steady, solved_s, halves_s) == pytest.approx(5.0)
