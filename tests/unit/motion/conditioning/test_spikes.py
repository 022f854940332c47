"""Spikes go, motion stays: built signals with known faults, and real taps."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import Sampling
from hapticplayer.motion.conditioning import remove_spikes
from hapticplayer.motion.conditioning.spikes import find_spikes


@pytest.fixture
def ride(make_log, rng):
    """Twenty seconds at 90 Hz: slow turns and sways with sensor noise."""
    t = np.arange(1800) / 90.0
    force = np.stack([np.sin(3 * t), 0.7 * np.cos(5 * t), 9.8 + np.sin(2 * t)], axis=1)
    rate = np.stack([0.9 + 0.3 * np.sin(t), 0.4 * np.cos(2 * t), 1.5 + 0 * t], axis=1)
    return make_log(
        t,
        force=force + 0.05 * rng.standard_normal((1800, 3)),
        rate=rate + 0.005 * rng.standard_normal((1800, 3)),
        magnetic_field_ut=40.0 + rng.standard_normal((1800, 3)),
    )


def changed(log, **columns):
    """Return the log with some values set: name=((row, axis, value), ...)."""
    arrays = {}
    for name, entries in columns.items():
        array = getattr(log, name).copy()
        for row, axis, value in entries:
            array[row, axis] = value
        arrays[name] = array
    return dataclasses.replace(log, **arrays)


def removed(report):
    """Return how many samples had an axis replaced."""
    return int((report.force | report.rate | report.field).any(axis=1).sum())


def same(a, b):
    return (
        np.array_equal(a.specific_force_mps2, b.specific_force_mps2)
        and np.array_equal(a.angular_rate_radps, b.angular_rate_radps)
        and np.array_equal(a.magnetic_field_ut, b.magnetic_field_ut)
    )


def test_a_clean_recording_comes_out_bit_for_bit(ride):
    log, report = remove_spikes(ride)
    assert same(log, ride)
    assert removed(report) == 0
    assert not report.kept.any()


def test_glitches_are_removed_and_a_second_pass_finds_none(ride):
    spoilt = changed(
        ride,
        specific_force_mps2=[(100, 0, 30.0), (400, 2, -25.0), (900, 1, 8.0)],
        angular_rate_radps=[(200, 1, -6.0), (1500, 2, 34.0)],
        magnetic_field_ut=[(700, 0, 500.0)],
    )
    log, report = remove_spikes(spoilt)
    assert np.argwhere(report.force).tolist() == [[100, 0], [400, 2], [900, 1]]
    assert np.argwhere(report.rate).tolist() == [[200, 1], [1500, 2]]
    assert np.argwhere(report.field).tolist() == [[700, 0]]
    assert removed(report) == 6
    assert "3 accelerometer, 2 gyro, 1 magnetometer" in report.message
    # the line between the neighbours is off by noise and curvature only
    error = np.abs(log.specific_force_mps2 - ride.specific_force_mps2)
    assert error.max() < 0.25
    assert np.abs(log.angular_rate_radps - ride.angular_rate_radps).max() < 0.03
    assert np.count_nonzero(error) == 3
    assert log.valid is None
    again, second = remove_spikes(log)
    assert same(again, log)
    assert removed(second) == 0


def test_gyro_readings_scaled_twice_go_on_all_axes_at_once(ride):
    rate = ride.angular_rate_radps.copy()
    rows = np.array([50, 300, 301, 800, 803, 1200])  # a pair, and two close together
    rate[rows] /= 14.375
    rate[301] /= 14.375
    log, report = remove_spikes(dataclasses.replace(ride, angular_rate_radps=rate))
    assert report.rate[rows, 2].all()
    assert report.rate[rows, 0].all()
    assert np.flatnonzero(report.rate.any(axis=1)).tolist() == rows.tolist()
    assert np.abs(log.angular_rate_radps - ride.angular_rate_radps).max() < 0.22
    assert not report.force.any()


def test_a_first_or_last_reading_of_zero_goes(ride):
    spoilt = changed(
        ride,
        specific_force_mps2=[(0, 0, 0.0), (0, 1, 0.0), (0, 2, 0.0), (1799, 2, 0.0)],
    )
    log, report = remove_spikes(spoilt)
    assert report.force[0, 2]
    assert report.force[1799, 2]
    assert log.specific_force_mps2[0, 2] == log.specific_force_mps2[1, 2]


def test_an_impact_of_one_sample_on_several_axes_stays(ride):
    impact = changed(
        ride,
        specific_force_mps2=[(500, 2, 40.0), (500, 0, -12.0)],
        angular_rate_radps=[(1000, 1, 4.0)],
    )
    turn = changed(impact, specific_force_mps2=[(1000, 0, 9.0)])
    log, report = remove_spikes(turn)
    assert same(log, turn)
    assert np.flatnonzero(report.kept).tolist() == [500, 1000]


def test_an_impact_that_rings_stays_though_it_is_on_one_axis(ride):
    ringing = 60.0 * np.array([1.0, -0.7, 0.45, -0.3, 0.2, -0.12, 0.05])
    force = ride.specific_force_mps2.copy()
    force[500:507, 2] += ringing
    force[900:903, 1] += [3.0, 20.0, 4.0]  # a soft knock without ringing
    knocked = dataclasses.replace(ride, specific_force_mps2=force)
    log, _ = remove_spikes(knocked)
    assert same(log, knocked)


def test_a_step_stays(ride):
    force = ride.specific_force_mps2.copy()
    force[600:, 0] += 5.0
    force[1000:1030] *= 0.05  # free fall
    stepped = dataclasses.replace(ride, specific_force_mps2=force)
    log, _ = remove_spikes(stepped)
    assert same(log, stepped)


def test_pairs_go_only_when_they_drop_to_zero(ride):
    pair = changed(
        ride,
        specific_force_mps2=[(500, 0, 30.0), (501, 0, 25.0), (900, 2, 0), (901, 2, 0)],
    )
    _, report = remove_spikes(pair)
    assert np.argwhere(report.force).tolist() == [[900, 2], [901, 2]]


def test_in_averaged_samples_only_drops_go(ride):
    averaged = dataclasses.replace(ride, sampling=Sampling.AVERAGED)
    spoilt = changed(averaged, specific_force_mps2=[(500, 0, 30.0), (900, 2, 0.0)])
    log, report = remove_spikes(spoilt)
    assert np.argwhere(report.force).tolist() == [[900, 2]]
    assert log.specific_force_mps2[500, 0] == 30.0


def test_spikes_beside_a_gap_or_a_waiting_recorder_are_kept(ride):
    spiky = changed(ride, specific_force_mps2=[(500, 0, 30.0), (900, 0, 30.0)])
    time_s = spiky.time_s.copy()
    time_s[501:] += 2.0
    force, rate = spiky.specific_force_mps2.copy(), spiky.angular_rate_radps.copy()
    force[895:900], rate[895:900] = force[895], rate[895]
    waiting = dataclasses.replace(
        spiky, time_s=time_s, specific_force_mps2=force, angular_rate_radps=rate
    )
    _, report = remove_spikes(waiting)
    assert removed(report) == 0
    assert report.kept[[500, 900]].all()


def test_invalid_samples_are_neither_judged_nor_used(ride):
    valid = np.ones(1800, bool)
    valid[[499, 500, 508, 700]] = False
    spoilt = changed(
        ride,
        specific_force_mps2=[
            (499, 0, 1e6),
            (508, 0, 1e6),
            (505, 0, 30.0),
            (700, 1, 44.0),
        ],
    )
    log, report = remove_spikes(dataclasses.replace(spoilt, valid=valid))
    assert np.argwhere(report.force).tolist() == [[505, 0]]
    assert abs(log.specific_force_mps2[505, 0] - ride.specific_force_mps2[505, 0]) < 0.3
    assert log.specific_force_mps2[700, 1] == 44.0
    assert np.array_equal(log.valid, valid)


@pytest.mark.parametrize("count", [0, 1, 2, 10])
def test_short_recordings_are_left_alone(make_log, count):
    log = make_log(np.arange(count) / 90.0, force=9.8)
    out, report = remove_spikes(log)
    assert np.array_equal(out.specific_force_mps2, log.specific_force_mps2)
    assert removed(report) == 0


def test_quantised_readings_hold_no_spikes_and_lose_one():
    time_s = np.arange(400) / 90.0
    values = np.round(9.8 + 0.2 * np.sin(time_s), 1)[:, None]
    given = np.array([2.0]), np.ones(400, bool), False
    spikes, kept = find_spikes(time_s, values, *given)
    assert not spikes.any()
    assert not kept.any()
    values[200] = -10.0
    spikes, _ = find_spikes(time_s, values, *given)
    assert np.flatnonzero(spikes[:, 0]).tolist() == [200]


def test_real_taps_survive_bit_for_bit(recording):
    tapped = recording("broad_24")
    log, report = remove_spikes(tapped)
    assert same(log, tapped)
    assert np.abs(log.specific_force_mps2).max() > 155.0
    assert removed(report) == 0
    # they did stand out
    assert report.kept.any()


@pytest.mark.parametrize(
    "name", ["broad_01", "broad_10", "tumvi_room1", "tyrex_Guillaume_Nexus5_NoDist_Sw"]
)
def test_real_recordings_lose_nothing_and_injected_glitches_go(recording, rng, name):
    clean = recording(name)
    assert removed(remove_spikes(clean)[1]) == 0
    rows = np.arange(50, len(clean) - 50, 97)
    axes = rng.integers(0, 3, len(rows))
    force = clean.specific_force_mps2.copy()
    force[rows, axes] += rng.choice([-15.0, 15.0], len(rows))
    log, report = remove_spikes(dataclasses.replace(clean, specific_force_mps2=force))
    assert report.force[rows, axes].mean() > 0.99
    assert report.force.sum() == report.force[rows, axes].sum()
    error = log.specific_force_mps2 - clean.specific_force_mps2
    assert np.sqrt(np.mean(error[report.force] ** 2)) < 0.5


def test_phone_vibration_is_not_taken_for_spikes(recording):
    shaken = recording("broad_27")
    _, report = remove_spikes(shaken)
    assert removed(report) <= 3  # of 54952
    assert report.kept.sum() > 100
