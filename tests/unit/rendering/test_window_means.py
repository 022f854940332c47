"""What is played between window means: closed forms, gaps, uneven windows, overshoot."""

import numpy as np
import pytest

from hapticplayer.model import Mapping, MotionTrack, Sampling
from hapticplayer.rendering import render_force
from hapticplayer.rendering.window_means import dense_motion

RATE_HZ = 30.0
MIDDLES_S = (np.arange(300) + 0.5) / RATE_HZ
UNEVEN_S = MIDDLES_S + 0.006 * np.sin(1.7 * np.arange(300))


def track(time_s, along_x, valid=None, sampling=Sampling.AVERAGED):
    count = len(time_s)
    return MotionTrack(
        time_s=time_s,
        acceleration_mps2=np.outer(along_x, [1.0, 0.0, 0.0]),
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0, 0, 0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, bool) if valid is None else valid,
        sampling=sampling,
    )


def dense(time_s, along_x, valid=None):
    at_s, acceleration, _ = dense_motion(track(time_s, along_x, valid))
    return at_s, acceleration[:, 0]


def sine_means(frequency_hz):
    return np.sinc(frequency_hz / RATE_HZ) * np.sin(
        2 * np.pi * frequency_hz * MIDDLES_S
    )


@pytest.mark.parametrize("frequency_hz", [0.5, 2.0, 4.0, 8.0])
def test_a_sine_comes_back_from_its_window_means(frequency_hz):
    at_s, values = dense(MIDDLES_S, sine_means(frequency_hz))
    inside = slice(80, -80)  # the ends of the run decay by 0.27 per window
    sine = np.sin(2 * np.pi * frequency_hz * at_s[inside])
    # a cardinal cubic spline through the integral: fundamental and images
    v, k = frequency_hz / RATE_HZ, np.arange(-200, 201)
    level = 1.0 / np.sum((v / (v - k)) ** 4)
    images = level * np.abs(v / (v - k[k != 0])) ** 3
    worst = np.abs(values[inside] - sine).max()
    assert worst <= 1.0 - level + images.sum() + 1e-9
    assert worst <= {0.5: 2e-5, 2.0: 8e-4, 4.0: 0.006, 8.0: 0.07}[frequency_hz]


def test_the_spline_keeps_the_mean_of_every_window(rng):
    means = 5.0 * rng.standard_normal(300)
    _, values = dense(MIDDLES_S, means)
    assert len(values) == 299 * 4 + 1  # 120 Hz; edges fall on every second entry
    # a quadratic in each window: Simpson's rule is exact
    kept = (values[2:-4:4] + 4.0 * values[4:-2:4] + values[6::4]) / 6.0
    np.testing.assert_allclose(kept, means[1:-1], rtol=0, atol=1e-12)


@pytest.mark.parametrize("time_s", [MIDDLES_S, UNEVEN_S])
@pytest.mark.parametrize("slope", [0.0, -3.0])
def test_constant_and_linear_signals_are_exact(time_s, slope):
    at_s, values = dense(time_s, 2.0 + slope * time_s)
    assert len(at_s) > 3 * len(time_s)
    np.testing.assert_allclose(values, 2.0 + slope * at_s, rtol=0, atol=1e-11)


def test_uneven_windows_are_not_worse_than_lines():
    wave = 2 * np.pi * 4.0
    means = np.sinc(4.0 / RATE_HZ) * np.sin(wave * UNEVEN_S)  # of 1/30 s each
    at_s, values = dense(UNEVEN_S, means)
    lines = np.interp(at_s, UNEVEN_S, means)
    errors = [np.std((v - np.sin(wave * at_s))[40:-40]) for v in (values, lines)]
    assert errors[0] < 0.25 * errors[1]


@pytest.mark.parametrize("missing_s", [1 / RATE_HZ, 0.4, 60.0])
def test_means_do_not_cross_a_gap(missing_s, rng):
    left, right = rng.standard_normal((2, 40))
    later_s = MIDDLES_S[40:80] + missing_s
    at_s, both = dense(np.append(MIDDLES_S[:40], later_s), np.append(left, right))
    alone = [dense(MIDDLES_S[:40], left), dense(later_s, right)]
    np.testing.assert_allclose(at_s, np.concatenate([a for a, _ in alone]), atol=1e-12)
    np.testing.assert_allclose(both, np.concatenate([v for _, v in alone]), atol=1e-9)


def test_invalid_samples_reach_no_other_and_give_no_force(rng):
    valid = np.ones(120, bool)
    valid[60:63] = False
    wild = rng.standard_normal(120)
    wild[60:63] = 1e4
    at_s, _, is_valid = dense_motion(track(MIDDLES_S[:120], wild, valid))
    np.testing.assert_array_equal(at_s[~is_valid], MIDDLES_S[60:63])
    force = render_force(track(MIDDLES_S[:120], wild, valid))
    assert not force.force_n[~is_valid].any()
    wild[60:63] = 0.0
    other = render_force(track(MIDDLES_S[:120], wild, valid))
    np.testing.assert_array_equal(force.force_n, other.force_n)


@pytest.mark.parametrize(
    ("time_s", "sampling"),
    [(MIDDLES_S, Sampling.INSTANT), (MIDDLES_S / 4.0, Sampling.AVERAGED),
     (MIDDLES_S[:7], Sampling.AVERAGED), (MIDDLES_S[:1], Sampling.AVERAGED),
     (np.tile([1.0, 1.0, 1.0, 1.6], 20).cumsum() / RATE_HZ, Sampling.AVERAGED)],
)  # fmt: skip
def test_other_samples_and_short_runs_stay_lines(time_s, sampling, rng):
    means = rng.standard_normal(len(time_s))
    force = render_force(track(time_s, means, sampling=sampling))
    np.testing.assert_array_equal(force.time_s, time_s)
    np.testing.assert_allclose(force.force_n[:, 0], 0.4 * means, rtol=1e-6)
    assert force.provenance["reconstruction"] == "linear"


def test_a_slow_log_gets_four_entries_per_window():
    at_s, _ = dense(1000.0 * MIDDLES_S, np.zeros(300))
    assert len(at_s) == 299 * 4 + 1


def test_overshoot_is_that_of_a_quadratic_and_ends_at_the_limit(rng):
    step = np.repeat([0.0, 1.0], 150)
    _, values = dense(MIDDLES_S, step)
    # derivatives at the edges are 1/2 and 1 - z / 2, z = sqrt(3) - 2; at 3/4 of the window
    root, u = np.sqrt(3.0), 0.75
    beside = 0.5 + root * u - 1.5 * (root - 1.0) * u**2
    assert values.max() == pytest.approx(beside, abs=1e-9)  # 1.181
    # at half the rate a window's quadratic is 1.5 (1 - x^2)
    _, values = dense(MIDDLES_S, (-1.0) ** np.arange(300))
    assert np.abs(values).max() == pytest.approx(1.5, abs=1e-9)
    uneven_s = np.cumsum(rng.uniform(0.51, 1.49, 300)) / RATE_HZ
    _, values = dense(uneven_s, rng.choice([-1.0, 1.0], 300))
    assert np.abs(values).max() < 3.0
    hard = render_force(track(MIDDLES_S, 40.0 * step))
    assert hard.peak_n() == pytest.approx(Mapping().force_limit_n, rel=1e-6)


def test_the_force_says_how_it_was_reconstructed():
    force = render_force(track(MIDDLES_S, sine_means(2.0)))
    assert force.provenance["reconstruction"] == "integral-spline"
    assert (force.time_s[0], force.time_s[-1]) == (MIDDLES_S[0], MIDDLES_S[-1])
    # 2 Hz: means and lines leave 0.985 of it
    inside = force.force_n[100:-100, 0] / 0.4
    assert np.abs(inside).max() == pytest.approx(1.0, abs=2e-3)
