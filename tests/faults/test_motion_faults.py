"""Flawed recordings through repair and gravity removal, with the default method."""

import functools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from motion_cases import MAX_EXCESS_DEG, Case, Outcome, all_cases, case
from motion_scoring import Score, inclination_deg, score, true_up_at, vertical
from motion_signal import RATE_HZ, Scene

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack
from hapticplayer.motion import remove_gravity
from hapticplayer.motion.repair import repair_samples

CASES = {one.name: one for one in all_cases()}


def of(outcome: Outcome) -> list[str]:
    return [name for name, one in CASES.items() if one.outcome is outcome]


@functools.cache
def processed(name: str) -> tuple[ImuLog, MotionTrack]:
    raw = CASES[name].raw
    imu = repair_samples(raw.time_s, raw.force, raw.rate, raw.field).imu
    return imu, remove_gravity(imu)


def scored(one: Case, track: MotionTrack, valid) -> Score:
    up = vertical(track.quaternion_wxyz)
    error_deg = inclination_deg(up, true_up_at(one, track.time_s))
    return score(one, track.time_s, error_deg, valid)


def assert_sound(track: MotionTrack) -> None:
    """Nothing is NaN, quaternions are unit, and what was removed is 1 g."""
    values = [track.acceleration_mps2, track.gravity_mps2, track.quaternion_wxyz]
    if track.gravity_sigma_mps2 is not None:
        values.append(track.gravity_sigma_mps2[:, None])
        assert (track.gravity_sigma_mps2 >= 0.0).all()
    for array in values:
        assert np.isfinite(array[track.valid]).all()
    norm = np.linalg.norm(track.quaternion_wxyz, axis=1)
    assert np.abs(norm - 1.0).max() < 1e-9
    gravity = np.linalg.norm(track.gravity_mps2, axis=1)
    assert np.allclose(gravity, STANDARD_GRAVITY_MPS2, atol=1e-6)


@pytest.mark.parametrize("name", of(Outcome.RECOVERS))
def test_ten_seconds_after_a_fault_the_vertical_is_right_again(name):
    _, track = processed(name)
    assert_sound(track)
    _, clean = processed("clean")
    best = scored(CASES["clean"], clean, clean.valid)
    figures = scored(CASES[name], track, track.valid)
    assert figures.worst_after < best.worst_after + MAX_EXCESS_DEG
    # an estimator that trusts nothing would pass the line above
    assert figures.invalid_after <= 0.1


@pytest.mark.parametrize(
    "name", [name for name, one in CASES.items() if one.during_deg is not None]
)
def test_the_remaining_information_bounds_the_error_of_a_fault(name):
    _, track = processed(name)
    everywhere = np.ones(len(track), dtype=bool)
    figures = scored(CASES[name], track, everywhere)
    assert figures.during < CASES[name].during_deg


@pytest.mark.parametrize("name", of(Outcome.DEGRADED))
def test_lost_information_costs_no_more_than_it_must(name):
    _, track = processed(name)
    assert_sound(track)
    everywhere = np.ones(len(track), dtype=bool)
    assert scored(CASES[name], track, everywhere).after < CASES[name].bound_deg


@pytest.mark.parametrize("name", of(Outcome.REPORTED))
def test_a_sensor_that_errs_breaks_nothing(name):
    imu, track = processed(name)
    assert_sound(track)
    assert len(track) == len(imu) == len(CASES[name].raw.time_s)


@pytest.mark.parametrize("name", of(Outcome.REFUSED))
def test_unusable_input_is_refused_and_the_message_says_where(name):
    raw = CASES[name].raw
    with pytest.raises(InputError, match=CASES[name].says) as refusal:
        repair_samples(raw.time_s, raw.force, raw.rate, raw.field, source="walk.csv")
    assert refusal.value.where == "walk.csv"
    assert refusal.value.remedy


@pytest.mark.parametrize(
    "name", [name for name in of(Outcome.RECOVERS) if "NaN" in name]
)
def test_a_sample_that_was_filled_in_is_not_valid_afterwards(name):
    imu, track = processed(name)
    filled = np.zeros(len(imu), dtype=bool) if imu.valid is None else ~imu.valid
    # the magnetometer's and the clock's holes leave the motion valid
    assert filled.any() == ("mag" not in name and "stamps" not in name)
    assert not track.valid[filled].any()


def test_a_long_recording_ends_as_well_as_it_begins():
    count = 300_000
    time_s = np.arange(count) / RATE_HZ
    one = case("long", scene=Scene(time_s=time_s))
    raw = one.raw
    track = remove_gravity(repair_samples(raw.time_s, raw.force, raw.rate).imu)
    error_deg = inclination_deg(vertical(track.quaternion_wxyz), raw.up)
    minute = round(60.0 * RATE_HZ)
    assert error_deg[-minute:].max() < error_deg[minute : 2 * minute].max() + 0.2


ONE_G = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])
numbers = st.one_of(
    st.floats(width=64),
    st.sampled_from([0.0, -1.0, 9.81, 1e-300, 1e300, np.nan, np.inf, -np.inf]),
)
edits = st.lists(
    st.tuples(
        st.sampled_from(["time_s", "force", "rate", "field"]),
        st.integers(0, 59),
        st.integers(0, 2),
        numbers,
    ),
    max_size=12,
)


@settings(max_examples=200, derandomize=True)
@given(
    count=st.integers(0, 60),
    edits=edits,
    order=st.permutations(range(4)),
    decimals=st.integers(1, 6),
)
def test_whatever_numbers_come_in_nothing_breaks(count, edits, order, decimals):
    rng = np.random.default_rng(count)
    arrays = {
        "time_s": np.round(np.arange(count) / RATE_HZ, decimals),
        "force": ONE_G + 0.1 * rng.standard_normal((count, 3)),
        "rate": 0.3 * rng.standard_normal((count, 3)),
        "field": 10.0 * ONE_G + rng.standard_normal((count, 3)),
    }
    if count >= 16:
        arrays["time_s"][10:14] = arrays["time_s"][10:14][order]
    for name, row, axis, value in edits:
        if row < count:
            arrays[name][row if name == "time_s" else (row, axis)] = value
    try:
        imu = repair_samples(*arrays.values()).imu
    except InputError:
        return
    track = remove_gravity(imu)
    assert len(track) == len(imu) >= 2
    assert_sound(track)
