"""Which samples of a log are not to be trusted."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog
from hapticplayer.model.limits import GAP_STEPS
from hapticplayer.motion import METHODS, analyse
from hapticplayer.motion.flaws import find_flaws

STEP_S = 0.01


@pytest.fixture
def log(rng) -> ImuLog:
    count = 2000
    force = np.array([0.0, 0.0, G]) + rng.standard_normal((count, 3))
    return ImuLog(
        STEP_S * np.arange(count), force, 0.3 * rng.standard_normal((count, 3))
    )


def without(log, *rows):
    keep = np.ones(len(log), dtype=bool)
    for row in rows:
        keep[row] = False
    return ImuLog(
        log.time_s[keep], log.specific_force_mps2[keep], log.angular_rate_radps[keep]
    )


def clipped(log, limit_mps2):
    force = np.clip(log.specific_force_mps2, -limit_mps2, limit_mps2)
    return dataclasses.replace(log, specific_force_mps2=force)


def test_a_whole_log_has_no_flaw(log):
    flaws = find_flaws(log)
    assert flaws.flawless
    assert flaws.valid.all()
    assert flaws.interval_s == pytest.approx(STEP_S)
    assert flaws.saturated_share == 0.0
    step_s = np.full(len(log), STEP_S)
    assert not flaws.lost_s(step_s).any()
    assert not flaws.doubt_s(step_s).any()


@pytest.mark.parametrize("count", [2, 3, 8, 501, 2000])
def test_the_interval_is_the_median_step(count, rng):
    time_s = np.cumsum(rng.uniform(0.5, 1.5, count) * STEP_S)
    log = ImuLog(time_s, np.tile([0.0, 0.0, G], (count, 1)), np.zeros((count, 3)))
    assert find_flaws(log).interval_s == np.median(np.diff(log.time_s))


@pytest.mark.parametrize(("dropped", "is_gap"), [(1, False), (2, False), (3, True)])
def test_a_step_beyond_three_intervals_is_a_gap(dropped, is_gap, log):
    assert GAP_STEPS == 3.0
    # steps of 3 intervals are rounded either way, hence not exactly on it
    holed = without(log, slice(500, 500 + dropped))
    late = holed.time_s + np.where(np.arange(len(holed)) >= 500, -0.001, 0.0)
    flaws = find_flaws(dataclasses.replace(holed, time_s=late))
    assert flaws.flawless == (not is_gap)
    assert np.flatnonzero(~flaws.valid).tolist() == ([499, 500] if is_gap else [])


@pytest.mark.parametrize("dropped", [10, 100, 1000])
def test_a_gap_is_as_long_as_what_no_sample_covers(dropped, log):
    flaws = find_flaws(without(log, slice(500, 500 + dropped)))
    assert flaws.gap_s[500] == pytest.approx(STEP_S * dropped)
    assert np.count_nonzero(flaws.gap_s) == 1


def test_gaps_at_the_first_and_last_step_are_seen(log):
    flaws = find_flaws(without(log, slice(1, 20), slice(1950, 1999)))
    assert np.flatnonzero(~flaws.valid).tolist() == [0, 1, 1930, 1931]


def test_filled_in_samples_are_not_valid(log):
    valid = np.ones(len(log), dtype=bool)
    valid[100:103], valid[0], valid[-1] = False, False, False
    flaws = find_flaws(dataclasses.replace(log, valid=valid))
    assert np.array_equal(flaws.valid, valid)


def test_a_long_hole_is_lost_and_a_short_one_nearly_not(log):
    valid = np.ones(len(log), dtype=bool)
    valid[100:300], valid[500:503] = False, False
    flaws = find_flaws(dataclasses.replace(log, valid=valid))
    step_s = np.full(len(log), STEP_S)
    for lost in (flaws.lost_s(step_s), flaws.doubt_s(step_s)):
        assert not lost[valid].any()
        assert lost[100:300].sum() == pytest.approx(2.0)
        # straight lines bridge three samples well
        assert 0.0 < lost[500:503].sum() < 0.2 * 3 * STEP_S


@pytest.mark.parametrize("count", [35, 100])
def test_dropped_samples_count_like_filled_ones_in_long_gaps(count, log):
    valid = np.ones(len(log), dtype=bool)
    valid[100 : 100 + count] = False
    filled = find_flaws(dataclasses.replace(log, valid=valid))
    dropped = find_flaws(without(log, slice(100, 100 + count)))
    step_s = np.full(len(log), STEP_S)
    for of in ("lost_s", "doubt_s"):
        expected = getattr(filled, of)(step_s).sum()
        got = getattr(dropped, of)(step_s[: len(dropped.gap_s)]).sum()
        assert got == pytest.approx(expected, rel=1e-6)


def test_the_longer_a_gap_the_more_of_it_is_lost(log):
    lost = []
    for dropped in (5, 10, 20, 40, 80):
        flaws = find_flaws(without(log, slice(500, 500 + dropped)))
        step_s = np.full(len(log) - dropped, STEP_S)
        lost.append(float(flaws.lost_s(step_s).sum()) / (dropped * STEP_S))
    assert all(np.diff(lost) > -1e-9)
    assert lost[0] < 0.2
    assert lost[-1] == pytest.approx(1.0)


def test_clipped_samples_are_marked_and_doubted(log):
    wave = np.sin(0.2 * np.arange(len(log)))[:, None] * np.array([30.0, 0.0, 0.0])
    loud = dataclasses.replace(log, specific_force_mps2=log.specific_force_mps2 + wave)
    flaws = find_flaws(clipped(loud, 2.0 * G))
    # interpolation smears a rail, so what is within 0.2 % of it counts
    on_rail = np.abs(loud.specific_force_mps2).max(axis=1) >= 0.998 * 2.0 * G
    assert on_rail.mean() > 0.2
    assert np.array_equal(flaws.force_clipped, on_rail)
    assert not flaws.rate_clipped.any()
    assert np.array_equal(flaws.valid, ~on_rail)
    assert flaws.saturated_share == pytest.approx(on_rail.mean())
    step_s = np.full(len(log), STEP_S)
    assert not flaws.lost_s(step_s).any()
    assert (flaws.doubt_s(step_s)[on_rail] > 0.0).all()


def test_a_clipped_gyro_loses_rotation(log):
    wave = np.sin(0.1 * np.arange(len(log)))[:, None] * np.array([0.0, 12.0, 0.0])
    rail = np.radians(500.0)
    rate = np.clip(log.angular_rate_radps + wave, -rail, rail)
    flaws = find_flaws(dataclasses.replace(log, angular_rate_radps=rate))
    on_rail = np.abs(rate).max(axis=1) >= 0.998 * rail
    assert on_rail.mean() > 0.2
    assert np.array_equal(flaws.rate_clipped, on_rail)
    step_s = np.full(len(log), STEP_S)
    assert (flaws.lost_s(step_s)[on_rail] > 0.0).all()


@pytest.mark.parametrize("method", sorted(METHODS))
def test_all_methods_mark_the_same_samples(method, log):
    valid = np.ones(len(log) - 50, dtype=bool)
    valid[30:33] = False
    holed = dataclasses.replace(without(log, slice(1000, 1050)), valid=valid)
    done = analyse(holed, method)
    expected = valid.copy()
    expected[[999, 1000]] = False
    assert np.array_equal(done.track.valid, expected)
    assert done.summary["invalid_share"] == pytest.approx(1.0 - expected.mean())
    assert done.summary["saturated_share"] == 0.0
