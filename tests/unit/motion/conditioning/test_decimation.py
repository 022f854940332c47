"""The anti-aliased decimation against its documented bounds and exact signals."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import Sampling
from hapticplayer.model import quaternions as quat
from hapticplayer.motion.conditioning import (
    average,
    decimate,
    decimate_even,
    decimate_motion,
    decimation_response,
)


def measured_gain(input_hz, frequency_hz):
    """Complex gain at 30 Hz output, away from the ends."""
    t = np.arange(int(40 * input_hz)) / input_hz
    pair = np.stack([np.cos(2 * np.pi * frequency_hz * t)] * 2, axis=1)
    pair[:, 1] = np.sin(2 * np.pi * frequency_hz * t)
    at = np.arange(10 * input_hz, 30 * input_hz, input_hz / 30.0)
    got = decimate_even(pair, input_hz, 30.0, at)
    return (got[:, 0] + 1j * got[:, 1]) / np.exp(
        2j * np.pi * frequency_hz * at / input_hz
    )


@pytest.mark.parametrize("input_hz", [30.0, 90.0, 199.3, 285.714])
def test_pass_band_and_stop_band_are_as_documented(input_hz):
    for frequency_hz in (0.5, 3.0, 8.0, 12.0):
        gain = measured_gain(input_hz, frequency_hz)
        assert np.abs(20 * np.log10(np.abs(gain))).max() < 0.02
        assert np.abs(np.angle(gain)).max() < 1e-3
    if input_hz > 30.0:
        half = 20 * np.log10(np.abs(measured_gain(input_hz, 15.0)))
        assert np.allclose(half, -6.02, atol=0.02)
        for frequency_hz in (18.0, 21.0, 29.9, 44.0):
            gain = measured_gain(input_hz, frequency_hz)
            assert 20 * np.log10(np.abs(gain)).max() < -59.0


@pytest.mark.parametrize("frequency_hz", [1.0, 11.0, 14.0, 16.0, 20.0])
def test_the_response_function_says_what_is_measured(frequency_hz):
    said = float(decimation_response(frequency_hz, 30.0)[0])
    assert measured_gain(200.0, frequency_hz) == pytest.approx(said, abs=2e-4)


def test_aliasing_frequencies_are_removed(make_log):
    end = np.arange(1, 6001) / 200.0
    log = make_log(end, force=np.sin(2 * np.pi * 24.0 * end)[:, None])
    inner = slice(30, -30)
    averaged = average(log, 30.0).specific_force_mps2[inner, 0]
    filtered = decimate(log, 30.0).specific_force_mps2[inner, 0]
    assert np.abs(averaged).max() > 0.2  # sinc(0.8) = 0.23
    assert np.abs(filtered).max() < 1.2e-3


def test_times_are_those_of_the_average_and_a_line_has_no_delay(make_log):
    end = np.arange(1, 2001) / 199.3
    # the mean of t over an interval is its middle
    ramp = (end - 0.5 / 199.3)[:, None]
    log = decimate(make_log(end, force=ramp, rate=3.0), 30.0)
    assert log.sampling is Sampling.AVERAGED
    assert np.array_equal(log.time_s, average(make_log(end), 30.0).time_s)
    # half a sample of delay would be 2.5e-3
    assert np.allclose(log.specific_force_mps2[:, 0], log.time_s, atol=1e-5)
    assert np.allclose(log.angular_rate_radps, 3.0, atol=1e-12)


def test_averaged_samples_are_read_at_their_own_times(make_log):
    middle = (np.arange(300) + 0.5) / 30.0
    log = make_log(middle, force=middle[:, None], sampling=Sampling.AVERAGED)
    slow = decimate(log, 10.0)
    assert np.allclose(slow.specific_force_mps2[:, 0], slow.time_s, atol=1e-4)


def test_uneven_time_stamps_are_resampled_by_themselves(make_log, rng):
    end = np.arange(1, 4001) / 200.0 + rng.uniform(-1e-3, 1e-3, 4000)
    begin = np.concatenate(([end[0] - 1 / 200], end[:-1]))
    wave = np.sin(2 * np.pi * 2.0 * 0.5 * (begin + end))
    slow = decimate(make_log(end, force=wave[:, None]), 30.0)
    error = slow.specific_force_mps2[:, 0] - np.sin(2 * np.pi * 2.0 * slow.time_s)
    # read as if evenly spaced, the jitter would cost 2.8e-3
    assert np.sqrt(np.mean(error[10:-10] ** 2)) < 1e-3


def test_gaps_are_left_out_and_invalid_spans_stay_by_themselves(make_log, rng):
    time_s = np.arange(1, 2001) / 200.0
    keep = (time_s <= 3.0) | (time_s > 6.0)
    time_s = time_s[keep]
    valid = ~((time_s > 1.0) & (time_s <= 1.5))
    force = np.where(time_s < 4.0, 2.0, -3.0)
    force = np.where(valid, force, 1e6 * rng.standard_normal(len(time_s)))
    log = make_log(time_s, force=force[:, None], magnetic_field_ut=np.ones((1400, 3)))
    slow = decimate(dataclasses.replace(log, valid=valid), 20.0)
    assert np.all((slow.time_s < 3.0) | (slow.time_s > 6.0))
    assert len(slow) == 60 + 80
    before = slow.valid & (slow.time_s < 4.0)
    assert np.allclose(slow.specific_force_mps2[before], 2.0, atol=1e-9)
    assert np.allclose(slow.specific_force_mps2[slow.time_s > 6.0], -3.0, atol=1e-9)
    wrong = slow.time_s[~slow.valid]
    assert wrong.min() > 1.0
    assert wrong.max() < 1.5
    assert len(wrong) == 10
    assert np.allclose(slow.magnetic_field_ut, 1.0)


def test_single_invalid_samples_are_bridged(make_log):
    end = np.arange(1, 2001) / 200.0
    valid = np.arange(2000) % 50 != 25
    wave = np.sin(2 * np.pi * 1.5 * (end - 0.5 / 200))
    force = np.where(valid, wave, 1e6)
    slow = decimate(make_log(end, force=force[:, None], valid=valid), 30.0)
    exact = np.sin(2 * np.pi * 1.5 * slow.time_s)
    assert slow.valid is None
    inner = slice(10, -10)
    assert np.abs(slow.specific_force_mps2[inner, 0] - exact[inner]).max() < 1e-3


def test_a_track_keeps_its_equation_and_its_orientation(make_track):
    time_s = np.arange(1, 2001) / 200.0
    sigma = np.linspace(0.1, 0.3, 2000)
    track = make_track(time_s, np.sin(9 * time_s), sigma=sigma)
    slow = decimate_motion(track, 20.0)
    truth = quat.from_rotation_vector(np.outer(0.4 * slow.time_s, [1.0, 0, 0]))
    assert np.abs(slow.quaternion_wxyz - truth).max() < 1e-6
    assert np.allclose(
        slow.gravity_sigma_mps2, np.interp(slow.time_s, time_s, sigma), atol=1e-12
    )
    # sin(9 t) is at 1.4 Hz; its value belongs half a sample before its time stamp
    exact = np.sin(9 * (slow.time_s + 0.5 / 200))
    inner = slice(10, -10)
    assert np.abs(slow.acceleration_mps2[inner, 0] - exact[inner]).max() < 2e-3
    assert slow.valid.all()


@pytest.mark.parametrize("rate_hz", [0.0, np.nan, 250.0])
def test_rates_that_make_no_sense_are_refused_with_a_remedy(make_log, rate_hz):
    with pytest.raises(InputError) as caught:
        decimate(make_log(np.arange(400) / 200.0), rate_hz)
    assert caught.value.remedy
