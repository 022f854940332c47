"""The low-pass against the closed form of its response, and what it must not touch."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.motion.conditioning import lowpass_motion
from hapticplayer.motion.conditioning.filtering import lowpass


def response(frequency_hz, rate_hz, cutoff_hz):
    """Return the gain that the module states."""
    f = np.asarray(frequency_hz)
    ratio = np.tan(np.pi * f / rate_hz) / np.tan(np.pi * cutoff_hz / rate_hz)
    return 1.0 / (1.0 + (np.sqrt(2.0) - 1.0) * ratio**4)


@pytest.mark.parametrize("cutoff_hz", [2.0, 15.0, 60.0])
def test_the_measured_response_is_the_formula(cutoff_hz):
    impulse = np.zeros((8001, 1))
    impulse[4000] = 1.0
    measured = lowpass(impulse, 200.0, cutoff_hz)[:, 0]
    spectrum = np.fft.rfft(np.roll(measured, -4000))
    f = np.fft.rfftfreq(8001, 1 / 200.0)
    formula = response(f, 200.0, cutoff_hz)
    assert np.allclose(spectrum, formula, atol=1e-9)  # complex: no phase either
    half_power = np.interp(cutoff_hz, f, np.abs(spectrum) ** 2)
    assert half_power == pytest.approx(0.5, abs=1e-3)


def test_a_step_stays_in_place_and_overshoots_as_documented():
    step = np.repeat([0.0, 1.0], 2000)[:, None]
    smooth = lowpass(step, 1000.0, 20.0)[:, 0]
    assert smooth.max() - 1.0 == pytest.approx(0.034, abs=1e-3)
    assert smooth.min() == pytest.approx(-0.034, abs=1e-3)
    assert smooth[1999] + smooth[2000] == pytest.approx(1.0, abs=1e-9)


def test_a_line_passes_unchanged_to_its_very_ends():
    line = np.linspace(-3.0, 8.0, 500)[:, None] * [1.0, -2.0, 0.0] + 4.0
    assert np.abs(lowpass(line, 100.0, 1.5) - line).max() < 1e-9


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
    gain = response([1.0, 60.0], 200.0, 10.0)
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
    exact = response(2.0, 200.0, 12.0) * np.sin(2 * np.pi * 2.0 * time_s)
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
    "cutoff_hz", [100.0, 250.0, 0.0, -1.0, np.nan], ids="{:g} Hz".format
)
def test_cutoffs_that_make_no_sense_are_refused(make_track, cutoff_hz):
    track = make_track(np.arange(400) / 200.0, np.zeros(400))
    with pytest.raises(InputError) as caught:
        lowpass_motion(track, cutoff_hz)
    assert caught.value.remedy
