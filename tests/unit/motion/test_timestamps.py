"""Stamps as loggers write them, against the times at which samples were taken."""

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.motion.repair.timestamps import RepairKind, repair_times

INTERVAL_S = 0.01


@pytest.fixture
def true_s():
    return np.arange(500) * INTERVAL_S


@pytest.fixture
def values(rng):
    return rng.standard_normal((500, 3))


def kinds(line):
    return {repair.kind: repair.count for repair in line.repairs}


def test_good_times_stay_as_they_are(true_s, values, rng):
    jittered = true_s + 0.25 * INTERVAL_S * rng.uniform(-1, 1, 500)
    for times in (true_s, jittered):
        line = repair_times(times.copy(), [values])
        assert np.array_equal(line.time_s, times)
        assert np.array_equal(line.rows, np.arange(500))
        assert line.repairs == ()


def test_swapped_neighbours_are_put_in_order(true_s, values):
    order = np.arange(500)
    order[[100, 101]] = 101, 100
    order[[0, 1]] = 1, 0
    line = repair_times(true_s[order], [values])
    assert np.array_equal(line.time_s, true_s)
    assert np.array_equal(line.rows, order)
    assert kinds(line) == {RepairKind.SWAPPED: 2}


@pytest.mark.parametrize("stamp", [np.nan, np.inf, 0.0, -5.0, 1e9, 1e300])
def test_one_wild_stamp_is_interpolated(true_s, values, stamp):
    times = true_s.copy()
    times[200] = stamp
    line = repair_times(times, [values])
    assert np.allclose(line.time_s, true_s, atol=1e-12)
    assert kinds(line) == {RepairKind.TIME_FILLED: 1}
    assert line.repairs[0].first_row == 200


def test_missing_stamps_at_both_ends_go_on_at_the_same_pace(true_s, values):
    times = true_s.copy()
    times[:3] = times[-2:] = np.nan
    assert np.allclose(repair_times(times, [values]).time_s, true_s, atol=1e-12)


def test_rows_without_a_time_in_a_gap_are_left_out(true_s, values):
    times = true_s.copy()
    times[300:] += 4.0
    times[299] = times[300] = np.nan
    line = repair_times(times, [values])
    assert np.array_equal(line.rows, np.delete(np.arange(500), [299, 300]))
    assert kinds(line) == {RepairKind.TIME_DROPPED: 2, RepairKind.LOST: 402}


def test_equal_rows_of_a_time_are_kept_once_others_averaged(true_s, values):
    again = np.sort(np.r_[np.arange(500), [50, 50, 350]])
    times, rows = true_s[again], values[again]
    rows[np.searchsorted(again, 350) + 1] += 1.0
    line = repair_times(times, [rows])
    assert np.array_equal(line.time_s, true_s)
    assert kinds(line) == {RepairKind.DUPLICATE: 2, RepairKind.MERGED: 1}
    # 498 rows for themselves, one that was twice more, and two to be averaged
    assert len(line.rows) == 501
    assert line.rows[line.starts[350] : line.starts[351]].tolist() == [352, 353]


@pytest.mark.parametrize("size", [2, 8, 25])
def test_packets_with_the_time_of_their_last_sample_are_spread(true_s, values, size):
    last = np.minimum(np.arange(500) // size * size + size - 1, 499)
    line = repair_times(true_s[last], [values])
    assert np.allclose(line.time_s, true_s, atol=1e-9)
    assert kinds(line) == {RepairKind.SPREAD: 500}


def test_a_late_sample_that_came_with_the_next_is_spread(true_s, values):
    times = true_s.copy()
    times[200] = times[201]
    line = repair_times(times, [values])
    assert np.allclose(line.time_s, true_s, atol=1e-12)


def test_a_lost_packet_is_counted_and_not_filled(true_s, values):
    last = np.arange(500) // 10 * 10 + 9
    keep = np.r_[0:200, 210:500]
    line = repair_times(true_s[last][keep], [values[keep]])
    assert kinds(line) == {RepairKind.SPREAD: 490, RepairKind.LOST: 10}
    assert len(line.time_s) == 490


@pytest.mark.parametrize("jump_s", [0.03, 0.5, 3000.0])
def test_a_clock_that_is_set_back_is_refused_by_its_row(true_s, values, jump_s):
    times = true_s + 1e4
    times[321:] -= jump_s
    with pytest.raises(InputError, match=r"jumps back.*row 321.*cut the recording"):
        repair_times(times, [values])


def test_a_gap_of_hours_is_refused_but_a_lone_first_row_dropped(true_s, values):
    epoch = true_s + 1.7e9
    epoch[0] = 0.0
    line = repair_times(epoch.copy(), [values])
    assert line.rows[0] == 1
    assert kinds(line) == {RepairKind.TIME_DROPPED: 1}
    epoch[1:250] = true_s[1:250]
    with pytest.raises(InputError, match=r"nothing was recorded.*after row 249"):
        repair_times(epoch, [values])


@pytest.mark.parametrize(
    ("factor", "says"),
    [(1e3, "milliseconds: divide time_s by 1000"), (1e6, "microseconds"),
     (1e9, "nanoseconds"), (40.0, "at least 5 samples"), (0.0, "same time")],
)  # fmt: skip
def test_times_in_other_units_are_refused(true_s, values, factor, says):
    with pytest.raises(InputError, match=says):
        repair_times(factor * true_s, [values])


def test_rows_in_no_order_are_refused(true_s, values, rng):
    with pytest.raises(InputError, match=r"time_s (jumps|runs) back") as caught:
        repair_times(rng.permutation(true_s), [values])
    assert "looks like" not in str(caught.value)


@pytest.mark.parametrize("begin_s", [0.0, 0.1, 1.7e9 + 0.3])
def test_five_samples_a_second_are_enough(values, begin_s):
    time_s = begin_s + 0.2 * np.arange(len(values))
    assert len(repair_times(time_s, [values]).time_s) == len(values)
