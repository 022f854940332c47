"""Force from motion: direction, size, saturation; the two control conditions."""

import numpy as np
import pytest
from scipy import signal

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Mapping, MotionTrack
from hapticplayer.rendering import no_feedback, random_feedback, render_force


def motion(acceleration, valid=None):
    count = len(acceleration)
    return MotionTrack(
        time_s=np.arange(count) / 100.0,
        acceleration_mps2=acceleration,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0, 0, 0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, bool) if valid is None else valid,
    )


def test_up_pushes_up_and_forward_pulls_away():
    track = render_force(motion(np.array([[0, 0, 2.0], [0, 3.0, 0], [1.0, 0, 0]])))
    expected = [[0, 0.8, 0], [0, 0, -1.2], [0.4, 0, 0]]
    assert np.allclose(track.force_n, expected, atol=1e-6)


def test_a_long_vector_keeps_its_direction():
    track = render_force(motion(np.array([[30.0, -40.0, 12.0]])))
    force = track.force_n[0].astype(float)
    assert np.linalg.norm(force) == pytest.approx(4.5, abs=1e-5)
    assert np.allclose(force / 4.5, np.array([30.0, 12.0, 40.0]) / 51.419841, atol=1e-6)
    assert track.provenance["saturated_share"] == 1.0


def test_gain_is_linear_below_the_limit(rng):
    p = rng.standard_normal((50, 3))
    one = render_force(motion(p), Mapping(gain_n_per_mps2=0.2)).force_n
    two = render_force(motion(p), Mapping(gain_n_per_mps2=0.4)).force_n
    assert np.allclose(2.0 * one, two, atol=1e-6)


def test_samples_that_are_not_valid_give_no_force():
    track = render_force(motion(np.ones((3, 3)), np.array([True, False, True])))
    assert np.any(track.force_n != 0, axis=1).tolist() == [True, False, True]


def test_an_empty_motion_is_refused():
    with pytest.raises(InputError, match="empty"):
        render_force(motion(np.zeros((0, 3))))


def realistic(rng, seconds=300):
    t = np.arange(0, seconds, 0.005)
    return ForceTrack(t, rng.standard_normal((len(t), 3)) * [0.5, 1.0, 0.1])


def test_random_has_the_same_rms_and_span(rng):
    track = realistic(rng)
    noise = random_feedback(track, seed=7)
    assert np.allclose(noise.rms_n(), track.rms_n(), rtol=1e-4)
    assert noise.time_s[0] == track.time_s[0]
    assert noise.time_s[-1] == track.time_s[-1]


def test_random_is_repeatable_and_depends_on_its_seed(rng):
    track = realistic(rng, 20)
    first, again, other = (random_feedback(track, seed) for seed in (1, 1, 2))
    assert np.array_equal(first.force_n, again.force_n)
    assert not np.array_equal(first.force_n, other.force_n)
    assert first.provenance["seed"] == 1


def test_random_has_its_power_below_half_a_hertz(rng):
    noise = random_feedback(realistic(rng, 1200), seed=3)
    rate = 1.0 / np.median(np.diff(noise.time_s))
    frequency, power = signal.welch(noise.force_n[:, 1], rate, nperseg=4096)
    low = power[frequency <= 0.5].sum()
    # of a fourth-order Butterworth 90 % lie below its cut-off; Welch leaks a little
    assert low / power.sum() > 0.85
    # fourth order: 24 dB an octave, so an octave above the cut-off 1/257 is left
    near = power[(frequency > 0.05) & (frequency < 0.3)].mean()
    octave = power[(frequency > 0.98) & (frequency < 1.02)].mean()
    assert octave / near == pytest.approx(1 / 257, rel=0.6)


def test_random_starts_in_the_middle_of_things(rng):
    # without a discarded warm-up every track would begin near zero
    track = realistic(rng, 20)
    starts = [random_feedback(track, seed).force_n[0] for seed in range(40)]
    assert np.std(starts, axis=0)[1] > 0.5 * track.rms_n()[1]


def test_none_is_zero_over_the_same_span(rng):
    track = realistic(rng, 5)
    none = no_feedback(track)
    assert not none.force_n.any()
    assert not len(none.active_s)
    assert none.time_s[-1] == track.time_s[-1]
