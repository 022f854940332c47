import dataclasses

import numpy as np
import pytest
from scipy.integrate import quad

from hapticplayer.capture import synchronize
from hapticplayer.capture.clock_lag import TAPS, stamped_here
from hapticplayer.capture.sync import by_recorder as by_recorder_clock
from hapticplayer.capture.sync import events, fit
from hapticplayer.capture.sync import synchronize as synchronizing
from hapticplayer.capture.sync.methods import SyncMethod
from hapticplayer.capture.sync.result import ClipSound, Synchronisation, SyncInput
from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import ClockMap, ImuLog, Sampling
from tests.material.sync_clips import simulate_pats


def error_s(clip, clock, media_s=30.0):
    log_s = (media_s - clip.clock_map.offset_s) / clip.clock_map.rate
    return clock.rate * log_s + clock.offset_s - media_s


def tapped(pats_s, rate_hz, offset_s, rng, peak_mps2=20.0, hz=30.0):
    """A log at rest with damped sines at media times, sampled point by point."""
    t = np.arange(0.0, 30.0, 1.0 / rate_hz)
    force = np.array([0.0, 0.0, 9.81]) + 0.06 * rng.standard_normal((len(t), 3))
    for at_s in pats_s:
        since = np.maximum(t - (at_s - offset_s), 0.0)
        wave = np.exp(-since / 0.03) * np.sin(2 * np.pi * hz * since)
        force[:, 2] += peak_mps2 * wave
    return ImuLog(t, force, np.zeros((len(t), 3)), source="bench")


def thumps(pats_s, rng, rate_hz=16_000, duration_s=25.0):
    t = np.arange(0.0, duration_s, 1.0 / rate_hz)
    sound = 0.004 * rng.standard_normal(len(t))
    for at_s in pats_s:
        since = np.maximum(t - at_s, 0.0)
        sound += 0.4 * np.exp(-since / 0.02) * np.sin(2 * np.pi * 180.0 * since)
    return sound.astype(np.float32)


PATS_S = (3.2, 3.7, 4.25)


@pytest.mark.parametrize("offset_s", [-19.37, 0.0, 1.2345])
def test_pats_in_a_still_log_give_the_offset_to_two_milliseconds(rng, offset_s):
    pats_s = np.array(PATS_S) + max(offset_s, 0.0)
    imu = tapped(pats_s, 200, offset_s, rng)
    found = synchronize(imu, thumps(pats_s, rng))
    assert found.is_confident
    assert found.clock_map.offset_s == pytest.approx(offset_s, abs=0.002)
    assert [pat.heard_s for pat in found.pats] == pytest.approx(pats_s, abs=0.003)


def test_stereo_at_48_khz_gives_the_same_as_mono(rng):
    imu = tapped(PATS_S, 200, 0.5, rng)
    mono = thumps(PATS_S, rng, 48_000)
    once = synchronize(imu, mono, 48_000)
    twice = synchronize(imu, np.stack([mono, mono], axis=1), 48_000)
    assert twice.clock_map.offset_s == pytest.approx(once.clock_map.offset_s, abs=1e-9)
    assert once.clock_map.offset_s == pytest.approx(0.5, abs=0.003)


def test_the_skew_of_a_camera_is_taken_off(rng):
    imu, sound = tapped(PATS_S, 200, 0.5, rng), thumps(PATS_S, rng)
    plain = synchronize(imu, sound)
    late = synchronize(imu, sound, sound_late_s=0.080)
    difference_s = plain.clock_map.offset_s - late.clock_map.offset_s
    assert difference_s == pytest.approx(0.080, abs=1e-12)


@pytest.mark.parametrize(
    ("hard", "rate_hz", "least_within"),
    [(False, 200, 6), (False, 30, 5), (True, 200, 5), (True, 30, 4)],
)
def test_simulated_clips_are_within_half_a_frame(hard, rate_hz, least_within):
    errors, unflagged = [], 0
    for seed in range(31_000, 31_006):
        clip = simulate_pats(seed, hard=hard, rate_hz=rate_hz)
        found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
        errors.append(abs(error_s(clip, found.clock_map)))
        unflagged += errors[-1] > 0.1 and found.is_confident
    assert sum(error <= 0.0167 for error in errors) >= least_within
    assert unflagged == 0


@pytest.mark.parametrize(("rate_hz", "bar_s"), [(200, 0.005), (30, 0.025)])
def test_pats_at_both_ends_of_a_long_clip_give_the_drift(rate_hz, bar_s):
    clip = simulate_pats(
        32_000, hard=False, rate_hz=rate_hz, duration_s=400.0, at_both_ends=True
    )
    found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
    assert found.has_drift
    assert len(found.pats) == 6
    assert abs(error_s(clip, found.clock_map, 400.0)) <= bar_s


def test_a_short_clip_is_not_given_a_drift():
    clip = simulate_pats(31_000, hard=False, rate_hz=200)
    found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
    assert found.clock_map.rate == 1.0
    assert not found.has_drift


def test_clear_pats_of_a_short_recording_are_enough():
    """In 20 s there are fewer ways for chance to look like pats, and events to be rare."""
    for seed in range(30, 36):
        clip = simulate_pats(seed, hard=False, rate_hz=30, duration_s=20.0)
        found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
        assert abs(error_s(clip, found.clock_map)) <= 0.0167
        assert found.is_confident


def test_the_log_of_another_ride_is_flagged():
    flagged = 0
    for seed in range(33_000, 33_005):
        clip = simulate_pats(seed, hard=False, rate_hz=200)
        other = simulate_pats(seed + 1, hard=False, rate_hz=200)
        found = synchronize(other.imu, clip.audio, clip.audio_rate_hz)
        flagged += not found.is_confident
    assert flagged >= 4


def test_pats_that_are_only_heard_are_flagged(rng):
    imu = tapped((), 200, 0.0, rng)
    assert not synchronize(imu, thumps(PATS_S, rng)).is_confident


def test_two_pats_are_flagged(rng):
    imu = tapped(PATS_S[:2], 200, 0.0, rng)
    assert not synchronize(imu, thumps(PATS_S[:2], rng)).is_confident


def test_variance_is_sure_only_where_the_pats_agree(rng):
    imu, sound = tapped(PATS_S, 200, 0.5, rng), thumps(PATS_S, rng)
    found = synchronize(imu, sound, method="variance")
    assert found.clock_map.offset_s == pytest.approx(0.5, abs=0.03)
    # a slammed door that only the camera hears comes first
    louder = sound + 2.0 * thumps((1.0,), rng)
    mistaken = synchronize(imu, louder, method="variance")
    assert mistaken.clock_map.offset_s == pytest.approx(-1.7, abs=0.05)
    assert not mistaken.is_confident


def test_a_given_or_embedded_clock_is_taken_as_it_is(rng):
    imu = tapped((), 200, 0.0, rng)
    known = ClockMap(1.5, 1.0001)
    assert synchronize(imu, method="offset", known=known).clock_map == known
    assert synchronize(imu, method="embedded", known=known).clock_map == known
    assert synchronize(imu, known=known).method == "embedded"
    with pytest.raises(UsageError, match="does not know the clip's clock"):
        synchronize(imu, method="embedded")


@pytest.mark.parametrize(
    ("sound", "words"),
    [
        (None, "no sound"),
        (np.zeros(0, np.float32), "no sound"),
        (np.zeros(48_000, np.float32), "silent"),
        (np.full(48_000, np.nan, np.float32), "not finite"),
    ],
)
def test_sound_without_pats_is_refused_with_the_reason(rng, sound, words):
    with pytest.raises(InputError, match=words):
        synchronize(tapped(PATS_S, 200, 0.0, rng), sound)


def test_a_log_of_five_hertz_and_unknown_methods_are_refused(rng):
    with pytest.raises(InputError, match="100 Hz"):
        synchronize(tapped(PATS_S, 5, 0.0, rng), thumps(PATS_S, rng))
    with pytest.raises(UsageError, match="nonsense"):
        synchronize(tapped(PATS_S, 200, 0.0, rng), method="nonsense")


@pytest.mark.parametrize("count", [1, 2, 30])
def test_a_log_of_few_samples_is_no_match_but_no_crash(rng, count):
    imu = tapped(PATS_S, 200, 0.0, rng)
    short = ImuLog(
        imu.time_s[:count],
        imu.specific_force_mps2[:count],
        imu.angular_rate_radps[:count],
    )
    if count == 1:
        with pytest.raises(InputError):
            synchronize(short, thumps(PATS_S, rng))
    else:
        assert not synchronize(short, thumps(PATS_S, rng)).is_confident


def test_means_of_damped_sines_are_those_of_quadrature():
    time_s = np.arange(6) / 30.0
    waves = fit.window_means(time_s, np.array([0.0571]), 1 / 30.0)[0]
    hz, decay_s = fit.FREQUENCIES_HZ[2], fit.DECAYS_S[1]
    form = 1 * len(fit.FREQUENCIES_HZ) + 2

    def wave(t):
        since = t - 0.0571
        return np.exp(-since / decay_s) * np.sin(2 * np.pi * hz * since)

    for k, middle_s in enumerate(time_s):
        begin, end = max(0.0571, middle_s - 1 / 60), middle_s + 1 / 60
        exact = quad(wave, begin, end)[0] * 30.0 if end > begin else 0.0
        assert waves[form, k] == pytest.approx(exact, abs=1e-7)


def test_an_onset_is_found_to_two_milliseconds_in_noise(rng):
    curve = events.sound_onsets(thumps((5.0, 9.5), rng), 16_000)
    found = events.sound_events(curve).rarest(2)
    assert found.time_s == pytest.approx([5.0, 9.5], abs=0.002)


def test_averages_of_30_hz_give_a_third_of_a_sample(rng):
    fine = tapped(PATS_S, 2100, 0.25, rng, hz=25.0)
    rows = len(fine) // 70
    mean = fine.specific_force_mps2[: rows * 70].reshape(rows, 70, 3).mean(axis=1)
    time_s = fine.time_s[: rows * 70].reshape(rows, 70).mean(axis=1)
    imu = ImuLog(time_s, mean, np.zeros_like(mean), sampling=Sampling.AVERAGED)
    found = synchronize(imu, thumps(PATS_S, rng))
    assert found.is_confident
    assert found.clock_map.offset_s == pytest.approx(0.25, abs=0.010)


def test_a_result_describes_itself_in_plain_values():
    clip = simulate_pats(31_000, hard=False, rate_hz=200)
    found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
    described = found.described()
    assert described["method"] == "pats"
    assert len(described["pats"]) == 3
    assert described["confidence"] > 0.9
    lower = dataclasses.replace(found.clock_map, confidence=0.2)
    assert not dataclasses.replace(found, clock_map=lower).is_confident


def by_recorder(imu, sound, own, look=None):
    """A log whose clock a recorder here knows, but for 5 ms."""
    inputs = SyncInput(
        imu, lambda: ClipSound(sound), own=own, look=look, lag=stamped_here(0.005)
    )
    return synchronizing.automatic(inputs)


@pytest.mark.parametrize("off_s", [-0.03, 0.0, 0.08])
def test_taps_correct_the_clock_of_a_recorder(rng, off_s):
    imu, sound = tapped(PATS_S, 200, off_s, rng), thumps(PATS_S, rng)
    found = by_recorder(imu, sound, ClockMap())
    assert found.is_confident
    assert found.method == "embedded"
    assert found.clock_map.offset_s == pytest.approx(off_s, abs=0.002)
    assert found.lag.measured_by == TAPS
    assert found.lag.lag_s == pytest.approx(-off_s, abs=0.002)
    assert "taps" in found.lag.text


def test_taps_far_from_the_clock_of_a_recorder_are_other_knocks(rng):
    imu, sound = tapped(PATS_S, 200, 2.5, rng), thumps(np.add(PATS_S, 2.5), rng)
    found = by_recorder(imu, sound, ClockMap(residual_s=0.005))
    assert found.is_confident
    assert found.clock_map == ClockMap(residual_s=0.005)
    assert not found.lag.is_measured
    assert "known to about 5 ms; taps and frames could not" in found.lag.text


def test_frames_that_contradict_the_clock_of_a_recorder_ask(rng, monkeypatch):
    frames = Synchronisation(ClockMap(2.5, 1.0, 0.0, 0.99), "frames")
    row = SyncMethod("frames", "frames", "somewhere")
    monkeypatch.setattr(SyncMethod, "function", lambda _row: lambda _inputs: frames)
    monkeypatch.setattr(by_recorder_clock, "sync_method", lambda _name: row)
    sound = np.zeros(16_000, np.float32)
    found = by_recorder(tapped((), 200, 0.0, rng), sound, ClockMap(), lambda: None)
    assert not found.is_confident
    assert "+2.50 s from where the recorder's clock does" in found.contradiction
    assert [one.offset_s for one in found.others] == [0.0, 2.5]
