"""The low-pass against the closed form of its response, and what it must not touch."""

import dataclasses

import numpy as np
import pytest
from scipy import signal

from hapticplayer.errors import InputError
from hapticplayer.motion.conditioning import lowpass, lowpass_motion, lowpass_response


def impulse_response(cutoff_hz, order, rate_hz=200.0):
    impulse = np.zeros((8001, 1))
    impulse[4000] = 1.0
    return lowpass(impulse, rate_hz, cutoff_hz, order)[:, 0]


@pytest.mark.parametrize("order", [1, 2, 4, 8])
@pytest.mark.parametrize("cutoff_hz", [2.0, 15.0, 60.0])
def test_the_measured_response_is_the_formula(order, cutoff_hz):
    spectrum = np.fft.rfft(np.roll(impulse_response(cutoff_hz, order), -4000))
    f = np.fft.rfftfreq(8001, 1 / 200.0)
    formula = lowpass_response(f, 200.0, cutoff_hz, order)
    assert np.allclose(spectrum, formula, atol=1e-9)  # complex: no phase either
    half_power = np.interp(cutoff_hz, f, np.abs(spectrum) ** 2)
    assert half_power == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize("order", [1, 2, 5])
def test_the_filter_is_twice_scipys_butterworth(order):
    f = np.linspace(0.5, 90.0, 50)
    edge = np.tan(np.pi * 10.0 / 200.0) / (np.sqrt(2.0) - 1.0) ** (0.5 / order)
    b, a = signal.butter(order, np.arctan(edge) * 200.0 / np.pi, fs=200.0)
    _, once = signal.freqz(b, a, f, fs=200.0)
    formula = lowpass_response(f, 200.0, 10.0, order)
    assert np.allclose(np.abs(once) ** 2, formula, rtol=1e-6, atol=1e-12)


def test_it_falls_by_twelve_decibels_per_octave_and_order():
    far = lowpass_response([40.0, 80.0], 1e5, 2.0, 2)
    assert 20 * np.log10(far[0] / far[1]) == pytest.approx(24.08, abs=0.05)


@pytest.mark.parametrize(("order", "overshoot"), [(1, 0.0), (2, 0.034), (4, 0.069)])
def test_a_step_stays_in_place_and_overshoots_as_documented(order, overshoot):
    step = np.repeat([0.0, 1.0], 2000)[:, None]
    smooth = lowpass(step, 1000.0, 20.0, order)[:, 0]
    assert smooth.max() - 1.0 == pytest.approx(overshoot, abs=1e-3)
    assert smooth.min() == pytest.approx(-overshoot, abs=1e-3)
    assert smooth[1999] + smooth[2000] == pytest.approx(1.0, abs=1e-9)


def test_a_line_passes_unchanged_to_its_very_ends():
    line = np.linspace(-3.0, 8.0, 500)[:, None] * [1.0, -2.0, 0.0] + 4.0
    assert np.abs(lowpass(line, 100.0, 1.5, 2) - line).max() < 1e-9


def test_time_reversed_in_is_time_reversed_out(rng):
    x = rng.standard_normal((3000, 3))
    # the ends settle to e^-5 of what lies beyond them
    inner = slice(200, -200)
    backwards = lowpass(x[::-1], 200.0, 10.0)[::-1]
    assert np.abs(lowpass(x, 200.0, 10.0) - backwards)[inner].max() < 1e-9


def test_only_the_acceleration_of_a_track_changes(make_track):
    time_s = np.arange(2000) / 200.0
    slow, fast = np.sin(2 * np.pi * time_s), np.sin(2 * np.pi * 60 * time_s)
    track = make_track(time_s, slow + fast, sigma=np.ones(2000))
    out = lowpass_motion(track, 10.0)
    gain = lowpass_response([1.0, 60.0], 200.0, 10.0)
    wanted = gain[0] * slow + gain[1] * fast
    inner = slice(200, -200)
    assert np.abs(out.acceleration_mps2[inner, 1] - wanted[inner]).max() < 1e-3
    for name in ("time_s", "gravity_mps2", "quaternion_wxyz", "gravity_sigma_mps2"):
        assert np.array_equal(getattr(out, name), getattr(track, name))


def test_samples_beyond_a_gap_or_invalid_span_have_no_effect(make_track, rng):
    time_s = np.arange(2000) / 200.0
    time_s[1000:] += 0.5
    valid = ~((time_s > 2.0) & (time_s < 2.5))
    x = rng.standard_normal(2000)
    out = lowpass_motion(make_track(time_s, x, valid), 3.0)
    other = x.copy()
    other[1000:] = 50.0
    other[~valid] = -1e6
    changed = lowpass_motion(make_track(time_s, other, valid), 3.0)
    same = valid & (time_s < 5.0)
    assert np.array_equal(out.acceleration_mps2[same], changed.acceleration_mps2[same])
    assert np.allclose(changed.acceleration_mps2[1000:], 50.0, atol=1e-9)
    assert np.array_equal(out.valid, valid)


def test_single_invalid_samples_are_bridged_and_stay_marked(make_track):
    time_s = np.arange(2000) / 200.0
    valid = np.arange(2000) % 40 != 20
    wave = np.sin(2 * np.pi * time_s)
    spoilt = np.where(valid, wave, 1e6)
    out = lowpass_motion(make_track(time_s, spoilt, valid), 10.0)
    clean = lowpass_motion(make_track(time_s, wave), 10.0)
    error = np.abs(out.acceleration_mps2 - clean.acceleration_mps2).max()
    assert error < 1e-3  # the line is off by (pi T)^2 * 2 = 5e-4
    assert np.array_equal(out.valid, valid)


def test_uneven_time_stamps_are_respected(make_track, rng):
    time_s = np.arange(4000) / 200.0 + rng.uniform(-2e-3, 2e-3, 4000)
    keep = rng.uniform(size=4000) > 0.05
    time_s = np.sort(time_s[keep])
    track = make_track(time_s, np.sin(2 * np.pi * 2.0 * time_s))
    out = lowpass_motion(track, 12.0).acceleration_mps2[:, 0]
    exact = lowpass_response(2.0, 200.0, 12.0) * np.sin(2 * np.pi * 2.0 * time_s)
    error = np.sqrt(np.mean((out - exact)[100:-100] ** 2))
    # taken as even, the dropped samples alone are 1 s off after 20 s
    assert error < 2e-3


def test_time_stamps_within_a_percent_count_as_even(make_track, rng):
    even = np.arange(3000) / 200.0
    x = rng.standard_normal(3000)
    jittered = even + rng.uniform(-1e-5, 1e-5, 3000)
    a = lowpass_motion(make_track(even, x), 10.0).acceleration_mps2
    b = lowpass_motion(make_track(jittered, x), 10.0).acceleration_mps2
    assert np.abs(a - b).max() < 1e-3


@pytest.mark.parametrize("count", [0, 1, 2, 3, 7])
def test_short_tracks_come_out_finite_and_in_range(make_track, count):
    track = make_track(np.arange(count) / 200.0, np.linspace(1.0, 2.0, count))
    out = lowpass_motion(track, 5.0).acceleration_mps2
    assert out.shape == (count, 3)
    assert np.allclose(out, track.acceleration_mps2, atol=1e-9)


def test_a_track_where_every_sample_stands_alone_is_left_alone(make_track):
    time_s = np.cumsum(np.tile([0.005, 0.005, 1.0], 30))
    track = make_track(time_s, np.arange(90.0))
    track = dataclasses.replace(track, valid=np.arange(90) % 3 == 0)
    out = lowpass_motion(track, 20.0)
    assert np.isfinite(out.acceleration_mps2).all()
    alone = track.valid
    assert np.allclose(out.acceleration_mps2[alone], track.acceleration_mps2[alone])


@pytest.mark.parametrize(
    ("cutoff_hz", "order"),
    [(100.0, 2), (250.0, 2), (0.0, 2), (-1.0, 2), (np.nan, 2), (10.0, 0), (10.0, 9)],
)
def test_cutoffs_and_orders_that_make_no_sense_are_refused(
    make_track, cutoff_hz, order
):
    track = make_track(np.arange(400) / 200.0, np.zeros(400))
    with pytest.raises(InputError) as caught:
        lowpass_motion(track, cutoff_hz, order)
    assert caught.value.remedy
    with pytest.raises(InputError):
        lowpass(track.acceleration_mps2, 200.0, cutoff_hz, order)
