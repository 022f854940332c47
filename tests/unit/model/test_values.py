"""Value types refuse what nobody may rely on, and cannot be changed."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import (
    M_AD,
    ClockMap,
    ForceTrack,
    ImuLog,
    Mapping,
    PlaybackClock,
    Reconstruction,
)


def log(**changes):
    fields = {
        "time_s": [0.0, 0.1, 0.2],
        "specific_force_mps2": np.ones((3, 3)),
        "angular_rate_radps": np.zeros((3, 3)),
    }
    return ImuLog(**{**fields, **changes})


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"time_s": [0.0, 0.2, 0.1]}, "row 2"),
        ({"time_s": [0.0, 0.1, 0.1]}, "increase"),
        ({"time_s": [0.0, np.nan, 0.1]}, "not finite in row 1"),
        ({"specific_force_mps2": np.ones((3, 2))}, "3 x 2"),
        ({"specific_force_mps2": np.ones((2, 3))}, "2 rows"),
        ({"angular_rate_radps": [[0, 0, 0], [0, np.inf, 0], [0, 0, 0]]}, "row 1"),
        ({"magnetic_field_ut": np.ones((4, 3))}, "4 rows"),
    ],
)
def test_a_log_refuses_what_is_not_motion(changes, message):
    with pytest.raises(InputError, match=message):
        log(**changes)


def test_a_log_is_read_only_and_apart_from_its_source():
    source = np.ones((3, 3))
    made = log(specific_force_mps2=source)
    source[0, 0] = 7.0
    assert made.specific_force_mps2[0, 0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        made.specific_force_mps2[0, 0] = 2.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        made.source = "else"


def test_rate_is_the_median_and_survives_one_gap():
    assert log(time_s=[0.0, 0.1, 5.0]).rate_hz == pytest.approx(1 / 2.5)
    assert log(time_s=np.arange(3) * 0.02).rate_hz == pytest.approx(50.0)


def test_hold_keeps_each_value_until_the_next_row():
    track = ForceTrack([1.0, 2.0], [[1, 0, 0], [2, 0, 0]], Reconstruction.HOLD)
    found = track.at(np.array([0.999, 1.0, 1.999, 2.0, 99.0]))[:, 0]
    assert found.tolist() == [0.0, 1.0, 1.0, 2.0, 2.0]


def test_linear_is_straight_between_rows_and_zero_outside():
    track = ForceTrack([1.0, 2.0], [[1, 0, 0], [2, 0, -4]])
    found = track.at(np.array([0.5, 1.0, 1.25, 2.0]))
    assert found[:, 0].tolist() == [0.0, 1.0, 1.25, 0.0]
    assert found[2, 2] == -1.0


def test_a_part_of_a_track_is_as_if_all_were_asked_for(rng):
    force = rng.normal(size=(400, 3)).astype(np.float32)
    track = ForceTrack(np.cumsum(0.1 + rng.random(400)), force)
    asked = np.concatenate([track.time_s, rng.uniform(-5.0, track.end_s + 5.0, 900)])
    whole = track.at(asked)
    for first in range(0, len(asked), 7):
        some = slice(first, first + 7)
        assert np.array_equal(track.at(asked[some]), whole[some])
    lines = [np.interp(asked, track.time_s, axis, 0.0, 0.0) for axis in force.T]
    is_before = asked < track.end_s
    assert np.array_equal(whole[is_before], np.stack(lines, axis=1)[is_before])
    assert track.at(np.array([-1.0, 1e6])).tolist() == [[0.0] * 3] * 2


@pytest.mark.parametrize("how", list(Reconstruction))
def test_outside_the_active_spans_the_force_is_zero(how, rng):
    for _ in range(20):
        count = int(rng.integers(2, 40))
        force = rng.standard_normal((count, 3)) * (rng.random((count, 1)) < 0.3)
        track = ForceTrack(np.cumsum(0.1 + rng.random(count)), force, how)
        query = np.linspace(-1.0, track.time_s[-1] + 1.0, 3000)
        inside = np.zeros(len(query), dtype=bool)
        for begin, end in track.active_s:
            inside |= (query >= begin) & (query < end)
        assert not np.any(track.at(query)[~inside])
        assert np.all(np.diff(track.active_s.ravel()) > 0)


def test_default_axes_map_up_to_y_and_forward_to_minus_z():
    up, forward, right = np.eye(3)[2], np.eye(3)[1], np.eye(3)[0]
    assert (M_AD @ up).tolist() == [0, 1, 0]
    assert (M_AD @ forward).tolist() == [0, 0, -1]
    assert (M_AD @ right).tolist() == [1, 0, 0]
    assert np.linalg.det(M_AD) == pytest.approx(1.0)


@pytest.mark.parametrize(
    "changes",
    [
        {"axes": np.diag([1.0, 1.0, -1.0])},  # a mirror
        {"axes": np.full((3, 3), 0.5)},
        {"gain_n_per_mps2": 0.0},
        {"gain_n_per_mps2": float("nan")},
        {"gain_n_per_mps2": (0.1, 0.0, 0.2)},
        {"gain_n_per_mps2": (0.1, 0.2)},
        {"force_limit_n": -1.0},
        {"soft_knee_n": 4.5},
        {"soft_knee_n": 0.0},
        {"lever_arm_m": (0.0, float("inf"), 0.0)},
    ],
)
def test_a_mapping_refuses_what_is_no_rotation_or_no_gain(changes):
    with pytest.raises(InputError):
        Mapping(**changes)


def test_a_playback_clock_is_a_line_that_stands_before_its_start():
    clock = PlaybackClock(1, 100.0, 5.0, 2.0, 101.0)
    assert clock.media_s(99.0) == 5.0
    assert clock.media_s(100.5) == 6.0
    assert clock.monotonic_s(6.0) == 100.5
    assert clock.is_running(100.5)
    assert not clock.is_running(99.9)
    assert not clock.is_running(101.1)


@pytest.mark.parametrize("numbers", [(float("inf"), 1.0), (0.0, 0.0), (0.0, -1.0)])
def test_a_clock_map_refuses_what_maps_nothing(numbers):
    with pytest.raises(InputError):
        ClockMap(*numbers)
