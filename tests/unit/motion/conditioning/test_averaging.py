"""Averages against analytic integrals, a plain loop and recordings averaged before."""

from itertools import pairwise

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2, Sampling
from hapticplayer.motion.conditioning import average


def mean_of_sine(begin_s, end_s, frequency_hz):
    """Closed form of the mean of sin(2 pi f t) over a span."""
    w = 2 * np.pi * frequency_hz
    return (np.cos(w * begin_s) - np.cos(w * end_s)) / (w * (end_s - begin_s))


def means_by_hand(begin_s, end_s, values, edges):
    """Overlap by overlap: slow and plain."""
    out = []
    for left, right in pairwise(edges):
        total = covered = 0.0
        for a, b, value in zip(begin_s, end_s, values, strict=True):
            overlap = max(0.0, min(b, right) - max(a, left))
            total += overlap * value
            covered += overlap
        out.append(total / covered)
    return np.array(out)


@pytest.mark.parametrize("frequency_hz", [1.0, 12.0, 29.0, 70.0])
def test_an_average_is_the_integral_over_its_centred_window(make_log, frequency_hz):
    end = np.arange(1, 2101) / 210.0
    means = mean_of_sine(end - 1 / 210, end, frequency_hz)
    log = average(make_log(end, force=means[:, None]), 30.0)
    middle = (np.arange(300) + 0.5) / 30.0
    assert log.sampling is Sampling.AVERAGED
    assert log.valid is None
    assert np.allclose(log.time_s, middle, atol=1e-12, rtol=0)
    exact = mean_of_sine(middle - 1 / 60, middle + 1 / 60, frequency_hz)
    assert np.allclose(log.specific_force_mps2[:, 0], exact, atol=1e-11, rtol=0)


def test_samples_at_a_window_edge_count_by_their_overlap(make_log, rng):
    end = 5.0 + np.arange(1, 400) / 199.3
    values = rng.standard_normal((399, 3))
    log = average(make_log(end, force=values, rate=-2.0 * values), 30.0)
    begin = np.concatenate(([end[0] - np.median(np.diff(end))], end[:-1]))
    count = int((end[-1] - begin[0]) * 30.0)
    edges = begin[0] + np.arange(count + 1) / 30.0
    assert len(log) == count
    assert np.allclose(log.time_s, 0.5 * (edges[1:] + edges[:-1]), atol=1e-9)
    for axis in range(3):
        wanted = means_by_hand(begin, end, values[:, axis], edges)
        assert np.allclose(log.specific_force_mps2[:, axis], wanted, atol=1e-11)
        assert np.allclose(log.angular_rate_radps[:, axis], -2 * wanted, atol=1e-11)


def test_a_rate_that_does_not_divide_has_no_timing_error(make_log):
    end = np.arange(1, 2000) / 199.3
    force = mean_of_sine(end - 1 / 199.3, end, 3.0)
    log = average(make_log(end, force=force[:, None]), 30.0)
    exact = mean_of_sine(log.time_s - 1 / 60, log.time_s + 1 / 60, 3.0)
    # both edges split one sample as if it were constant: slope T^2 / 8 each
    bound = 2 * (2 * np.pi * 3.0) / 199.3**2 / 8 * 30.0
    assert np.abs(log.specific_force_mps2[:, 0] - exact).max() < bound
    # half a sample of delay would cost 0.047
    assert bound < 0.004


@pytest.mark.parametrize("frequency_hz", [0.7, 5.0, 7.5, 14.0, 24.0, 37.0, 44.0, 99.0])
def test_the_frequency_response_is_the_documented_sinc(make_log, frequency_hz):
    end = np.arange(1, 9001) / 300.0
    w = 2 * np.pi * frequency_hz
    cosine = (np.sin(w * end) - np.sin(w * (end - 1 / 300))) * 300.0 / w
    sine = mean_of_sine(end - 1 / 300, end, frequency_hz)
    pair = np.stack([cosine, sine, 0 * sine], axis=1)
    log = average(make_log(end, force=pair), 30.0)
    got = log.specific_force_mps2[:, 0] + 1j * log.specific_force_mps2[:, 1]
    # complex gain against the sine at the middle of the window: real, so no phase
    gain = got / np.exp(1j * w * log.time_s)
    x = frequency_hz / 30.0
    assert np.allclose(gain, np.sin(np.pi * x) / (np.pi * x), atol=1e-10)


def test_recordings_averaged_elsewhere_come_out_the_same(shared_data, recording):
    log = average(recording("broad_24"), 30.0)
    folder = shared_data / "orientation" / "averaged_30hz"
    with np.load(folder / "broad_24_disturbed_tapping_A.npz") as reference:
        assert len(log) == len(reference["acc"])
        for ours, name in (
            (log.specific_force_mps2, "acc"),
            (log.angular_rate_radps, "gyr"),
            (log.magnetic_field_ut, "mag"),
        ):
            # float32 in the file
            assert np.allclose(ours, reference[name], rtol=1e-6, atol=2e-6)


def test_averaged_samples_are_averaged_around_their_middles(make_log):
    middle = (np.arange(300) + 0.5) / 30.0
    source = make_log(middle, force=middle[:, None], sampling=Sampling.AVERAGED)
    log = average(source, 10.0)
    assert np.allclose(log.time_s, (np.arange(100) + 0.5) / 10.0, atol=1e-12)
    assert np.allclose(log.specific_force_mps2[:, 0], log.time_s, atol=1e-12)


def test_the_integral_over_the_whole_recording_is_kept(make_log, rng):
    end = np.arange(1, 2001) / 200.0
    values = rng.standard_normal((2000, 3)) + 9.8
    log = average(make_log(end, rate=values), 25.0)
    assert len(log) == 250
    angle = log.angular_rate_radps.sum(axis=0) / 25.0
    assert np.allclose(angle, values.sum(axis=0) / 200.0, rtol=1e-12)


def test_a_dropped_sample_is_covered_by_the_next_one(make_log):
    end = np.delete(np.arange(1, 401) / 200.0, [7, 8, 100])
    held = np.cos(end)
    log = average(make_log(end, force=held[:, None]), 20.0)
    begin = np.concatenate(([0.0], end[:-1]))
    wanted = means_by_hand(begin, end, held, np.arange(41) / 20.0)
    assert log.valid is None
    assert np.allclose(log.specific_force_mps2[:, 0], wanted, atol=1e-12)


def test_a_gap_is_left_out_and_nothing_leaks_across(make_log):
    time_s = np.concatenate([np.arange(1, 203), np.arange(602, 801)]) / 200.0
    force = np.where(time_s < 2.0, 1.0, 5.0)
    log = average(make_log(time_s, force=force[:, None]), 20.0)
    # samples cover 0 to 1.01 s and 3.005 to 4 s
    assert np.all((log.time_s < 1.05) | (log.time_s > 3.0))
    assert len(log) == 21 + 20
    assert np.flatnonzero(~log.valid).tolist() == [20]  # 10 ms of 50 ms covered
    # 3.005 to 3.05 s is enough and holds nothing of what was before the gap
    assert np.allclose(log.specific_force_mps2[log.time_s > 3.0], 5.0, atol=1e-12)
    assert np.allclose(log.specific_force_mps2[log.time_s < 3.0], 1.0, atol=1e-12)


def test_years_between_two_samples_do_not_become_windows(make_log):
    time_s = np.concatenate([np.arange(100) / 100.0, 1.5e9 + np.arange(100) / 100.0])
    log = average(make_log(time_s, force=9.8), 10.0)
    # the second second need not begin with a window
    assert 19 <= len(log) <= 21


def test_invalid_samples_reach_no_valid_average(make_log):
    end = np.arange(1, 401) / 200.0
    valid = np.ones(400, bool)
    valid[100:104] = False
    valid[200:230] = False
    force = np.where(valid, 2.0, 1e6)
    log = average(make_log(end, force=force[:, None], valid=valid), 20.0)
    assert np.allclose(log.specific_force_mps2[log.valid], 2.0, atol=1e-9)
    # four of ten samples missing: enough is left; 30 in a row are three windows
    assert np.flatnonzero(~log.valid).tolist() == [20, 21, 22]


def test_the_magnetic_field_is_carried_along(make_log, rng):
    end = np.arange(1, 401) / 200.0
    field = rng.standard_normal((400, 3)) + 40.0
    log = average(make_log(end, magnetic_field_ut=field, source="x"), 20.0)
    blocks = field.reshape(40, 10, 3).mean(axis=1)
    assert np.allclose(log.magnetic_field_ut, blocks, atol=1e-11)
    assert log.source == "x"
    assert average(make_log(end), 20.0).magnetic_field_ut is None


def test_a_recording_cut_at_a_window_edge_averages_to_the_same(make_log, rng):
    end = 100.0 + np.arange(1, 2101) / 210.0
    force = rng.standard_normal((2100, 3))
    whole = average(make_log(end, force=force), 30.0)
    first = average(make_log(end[:700], force=force[:700]), 30.0)
    second = average(make_log(end[700:], force=force[700:]), 30.0)
    joined = np.vstack([first.specific_force_mps2, second.specific_force_mps2])
    assert np.allclose(joined, whole.specific_force_mps2, atol=1e-11)


def test_a_day_of_samples_keeps_its_digits(make_log):
    end = np.arange(1, 500_001) / 5.0  # 28 h
    force = STANDARD_GRAVITY_MPS2 + np.where(np.arange(500_000) % 2, 1e-6, -1e-6)
    log = average(make_log(end, force=force[:, None]), 2.5)
    error = log.specific_force_mps2 - STANDARD_GRAVITY_MPS2
    assert np.abs(error).max() < 1e-9


@pytest.mark.parametrize("rate_hz", [0.0, -30.0, np.nan, np.inf, 201.0])
def test_rates_that_make_no_sense_are_refused_with_a_remedy(make_log, rate_hz):
    with pytest.raises(InputError) as caught:
        average(make_log(np.arange(400) / 200.0), rate_hz)
    assert caught.value.remedy


@pytest.mark.parametrize("count", [0, 1, 5])
def test_too_few_samples_for_one_window_are_refused(make_log, count):
    with pytest.raises(InputError, match=r"samples"):
        average(make_log(np.arange(count) / 200.0), 30.0)
