"""Strapdown windows against a plain loop, closed forms and quadrature."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.motion.smoother.samples import at_middles
from hapticplayer.motion.smoother.strapdown import integrate, spread
from tests.unit.motion.smoother.conftest import (
    WOBBLE,
    apart,
    inside_of,
    samples_of,
    scipy_of,
    window_means,
)

NO_BIAS, NO_MATRIX = np.zeros(3), np.zeros((3, 3))
BIAS = np.array([0.02, -0.05, 0.03])
MATRIX = np.array([[0.01, 0.002, 0.0], [-0.003, -0.02, 0.001], [0.0, 0.004, 0.015]])


def random_samples(rng, count, *, averaged=False, even=False, gain=1.0):
    step = np.full(count, 0.01) if even else rng.uniform(0.002, 0.02, count)
    return samples_of(
        step,
        np.array([0.0, 0.0, 9.8]) + rng.standard_normal((count, 3)),
        3.0 * rng.standard_normal((count, 3)),
        averaged,
        gain=gain,
    )


def looped(samples, per_window, bias=NO_BIAS, matrix=NO_MATRIX):
    """Integrate window by window and sample by sample, as the INSTANT rule says."""
    windows = []
    for first in range(0, len(samples), per_window):
        turned, impulse, power = Rotation.identity(), np.zeros(3), 0.0
        angle, inside = np.zeros(3), []
        for k in range(first, min(first + per_window, len(samples))):
            step = samples.step_s[k]
            rate = np.linalg.solve(
                np.eye(3) + matrix, samples.angular_rate_radps[k] - bias
            )
            force = samples.gain * samples.specific_force_mps2[k]
            turned = turned * Rotation.from_rotvec(rate * step)
            impulse += turned.apply(force) * step
            power += float(force @ force) * step
            angle += rate * step
            inside.append(turned)
        part = slice(first, first + per_window)
        windows.append(
            {
                "duration": samples.step_s[part].sum(),
                "rotation": turned,
                "impulse": impulse,
                "turn": angle,
                "power": power,
                "inside": inside,
            }
        )
    return windows


@pytest.mark.parametrize(
    ("count", "per_window"),
    [(2, 1), (2, 7), (12, 1), (12, 4), (13, 4), (15, 4), (60, 6)],
)
def test_windows_are_those_of_a_plain_loop(count, per_window, rng):
    samples = random_samples(rng, count, gain=1.03)
    got = integrate(samples, per_window, BIAS, MATRIX)
    expected = looped(samples, per_window, BIAS, MATRIX)
    assert len(got.duration_s) == len(expected)
    for n, one in enumerate(expected):
        assert got.duration_s[n] == pytest.approx(one["duration"], rel=1e-13)
        assert np.allclose(got.impulse_mps[:, n], one["impulse"], atol=1e-13)
        assert np.allclose(got.turn_rad[:, n], one["turn"], atol=1e-14)
        assert apart(scipy_of(got.rotation)[n], one["rotation"]) < 1e-13
        for k, orientation in enumerate(one["inside"]):
            assert apart(inside_of(got, n * per_window + k), orientation) < 1e-13


@pytest.mark.parametrize(("count", "per_window"), [(12, 1), (12, 4), (13, 4), (3, 7)])
def test_the_power_is_the_integral_of_the_squared_force(count, per_window, rng):
    samples = random_samples(rng, count, gain=1.03)
    got = integrate(samples, per_window, NO_BIAS, NO_MATRIX).power_m2ps3
    expected = [one["power"] for one in looped(samples, per_window)]
    assert np.allclose(got, expected, rtol=1e-12)


def test_many_windows_are_treated_like_few(rng):
    # enough for several of the chunks that long recordings are taken in
    samples = random_samples(rng, 40_003)
    got = integrate(samples, 4, BIAS, NO_MATRIX)
    last = 40_000
    tail = looped(samples.cut(slice(last, 40_003)), 4, BIAS)[0]
    assert np.allclose(got.impulse_mps[:, -1], tail["impulse"], atol=1e-13)
    for first in range(0, 40_000, 1000):
        one = looped(samples.cut(slice(first, first + 4)), 4, BIAS)[0]
        assert np.allclose(got.impulse_mps[:, first // 4], one["impulse"], atol=1e-13)
        assert apart(scipy_of(got.rotation)[first // 4], one["rotation"]) < 1e-13


@pytest.mark.parametrize("averaged", [False, True])
def test_the_lost_time_of_a_window_is_the_sum_of_its_samples(averaged, rng):
    plain = random_samples(rng, 11, averaged=averaged)
    plain.lost_s[4:8], plain.doubt_s[9] = 0.25, 1.5
    got = integrate(plain, 3, NO_BIAS, NO_MATRIX)
    assert got.lost_s.tolist() == pytest.approx([0.0, 0.5, 0.5, 0.0])


# ---- back to samples ------------------------------------------------------------


@pytest.mark.parametrize("per_window", [1, 4])
@pytest.mark.parametrize("averaged", [False, True])
def test_orientation_and_vertical_come_back_at_each_sample(per_window, averaged):
    width_s, count = 0.01, 41
    if averaged:
        log = WOBBLE.averaged(count, width_s)
        at_s = width_s * (np.arange(count) + 0.5)
        up = window_means(WOBBLE.up, at_s, width_s)
        starts_s = width_s * per_window * np.arange(-(-count // per_window))
    else:
        at_s = width_s * np.arange(1, count + 1)
        log, up = WOBBLE.instant(at_s), WOBBLE.up(at_s)
        starts_s = width_s * per_window * np.arange(-(-count // per_window))
    samples = samples_of(
        np.full(count, width_s),
        log.specific_force_mps2,
        log.angular_rate_radps + BIAS,
        averaged,
    )
    samples = at_middles(samples, BIAS)
    windows = integrate(samples, per_window, BIAS, NO_MATRIX)
    w, x, y, z = WOBBLE.attitude(starts_s).as_quat(scalar_first=True).T
    got, vertical = spread((w + 1j * x, y + 1j * z), windows, samples, BIAS)
    assert got.shape == (count, 4)
    exact = WOBBLE.attitude(at_s)
    inner = slice(1, -2)  # averaged samples need both neighbours
    orientation = Rotation.from_quat(got, scalar_first=True)
    # within a window of 40 ms the averaged ones are off by the third order
    assert apart(exact[inner], orientation[inner]) < (5e-6 if averaged else 1e-12)
    miss = np.linalg.norm(vertical - up, axis=1)[inner]
    # the mean over a window leaves out T^2 / 24 times the angular acceleration, which
    # is 20 rad/s^2 here; taking the middle for the mean would be off by 1e-4
    assert miss.max() < (8e-5 if averaged else 1e-12)


# ---- coarser samples ------------------------------------------------------------


@pytest.mark.parametrize(("count", "per_window"), [(12, 4), (13, 4), (3, 8), (5, 1)])
def test_coarse_samples_keep_time_rotation_and_impulse(count, per_window, rng):
    samples = random_samples(rng, count, gain=1.02)
    samples.lost_s[1], samples.doubt_s[2] = 0.3, 0.7
    got = samples.averages(per_window)
    assert got.gain == samples.gain
    starts = range(0, count, per_window)
    assert len(got) == len(starts)
    for n, first in enumerate(starts):
        part = slice(first, first + per_window)
        step = samples.step_s[part]
        assert got.step_s[n] == pytest.approx(step.sum(), rel=1e-14)
        for name in ("specific_force_mps2", "angular_rate_radps"):
            whole = step @ getattr(samples, name)[part]
            found = got.step_s[n] * getattr(got, name)[n]
            assert np.allclose(found, whole, rtol=1e-12, atol=1e-15)
    assert got.lost_s.sum() == pytest.approx(0.3)
    assert got.doubt_s.sum() == pytest.approx(0.7)
