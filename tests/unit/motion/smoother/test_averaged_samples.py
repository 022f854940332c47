"""InertialSamples that are means over windows, against closed forms and quadrature."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother.samples import at_middles, window_mean
from hapticplayer.motion.smoother.strapdown import integrate
from tests.unit.motion.smoother.conftest import (
    UP_1_G,
    WOBBLE,
    Motion,
    apart,
    inside_of,
    samples_of,
    scipy_of,
    window_means,
)

NO_BIAS, NO_MATRIX = np.zeros(3), np.zeros((3, 3))


def steady(rate_radps, earth_mps2=UP_1_G):
    """Return a steady turn in which a force is fixed to the earth."""
    rate, extra = np.asarray(rate_radps), np.asarray(earth_mps2) - UP_1_G
    return Motion(
        lambda t: Rotation.from_rotvec(np.multiply.outer(t, rate)),
        lambda t: np.tile(extra, (len(t), 1)),
    )


def closed_form_mean(force, rate, width_s):
    """Return the mean of R^T f over a window about its middle, f at the middle.

    exp(-t [w]x) f averaged over -T/2..T/2 is f_par + sinc f_perp: the odd part,
    which turns it, is zero on average.
    """
    speed = np.linalg.norm(rate)
    axis = rate / speed
    along = np.outer(force @ axis, axis)
    half = 0.5 * speed * width_s
    return along + (np.sin(half) / half) * (force - along)


@pytest.mark.parametrize("turn_rad", [1e-6, 0.05, 0.5, 1.5, 4.0])
@pytest.mark.parametrize("per_window", [1, 3])
def test_a_fixed_force_is_recovered_exactly_from_a_steady_turn(turn_rad, per_window):
    width_s, count = 1.0 / 30.0, 12
    rate = np.array([0.48, 0.6, 0.64]) * turn_rad / width_s
    earth = np.array([1.0, -2.0, 9.8])
    motion = steady(rate, earth)
    middle = width_s * (np.arange(count) + 0.5)
    mean = closed_form_mean(motion.force(middle), rate, width_s)
    steps = np.full(count, width_s)
    samples = samples_of(steps, mean, np.tile(rate, (count, 1)), True)
    windows = integrate(at_middles(samples, NO_BIAS), per_window, NO_BIAS, NO_MATRIX)
    starts = motion.attitude(per_window * width_s * np.arange(count // per_window))
    impulse = starts.apply(windows.impulse_mps.T)
    # nothing is approximated here, up to the one sample without a neighbour per end
    assert np.allclose(impulse[1:-1], per_window * width_s * earth, atol=2e-12)
    for k in range(1, count - 1):
        start = motion.attitude(np.array([k // per_window * per_window * width_s]))
        exact = start.inv()[0] * motion.attitude(middle[k : k + 1])[0]
        assert apart(inside_of(windows, k), exact) < 1e-12


@pytest.mark.parametrize("per_window", [1, 4])
def test_half_a_window_of_a_speeding_turn_is_exact(per_window):
    # about one axis with constant angular acceleration everything has closed forms
    width_s, count, axis = 0.04, 16, np.array([0.6, 0.0, 0.8])
    middle = width_s * (np.arange(count) + 0.5)
    rate = np.outer(2.0 + 5.0 * middle, axis)

    def angle(t):
        return 2.0 * t + 2.5 * t * t

    samples = samples_of(
        np.full(count, width_s), np.tile(UP_1_G, (count, 1)), rate, True
    )
    windows = integrate(at_middles(samples, NO_BIAS), per_window, NO_BIAS, NO_MATRIX)
    for k in range(1, count - 1):
        start_s = k // per_window * per_window * width_s
        exact = Rotation.from_rotvec((angle(middle[k]) - angle(start_s)) * axis)
        assert apart(inside_of(windows, k), exact) < 1e-13


def averaged_windows(width_s, seconds=2.0, per_window=1, motion=WOBBLE):
    count = round(seconds / width_s)
    log = motion.averaged(count, width_s)
    samples = samples_of(
        np.full(count, width_s), log.specific_force_mps2, log.angular_rate_radps, True
    )
    return samples, integrate(
        at_middles(samples, NO_BIAS), per_window, NO_BIAS, NO_MATRIX
    )


@pytest.mark.parametrize("width_s", [0.02, 0.01])
def test_attitude_from_means_is_of_third_order(width_s):
    errors = []
    for width in (width_s, width_s / 2):
        samples, windows = averaged_windows(width)
        total = scipy_of(rot.cumulative(windows.rotation))[-1]
        ends = WOBBLE.attitude(np.array([0.0, len(samples) * width]))
        errors.append(apart(ends[0].inv() * ends[1], total))
    # a plain product of the means is of second order: 1.4e-3 and 3.6e-4 rad
    assert errors[0] < {0.02: 1e-4, 0.01: 2e-5}[width_s]
    assert errors[0] / errors[1] > 6.0


def test_the_middle_of_a_window_is_found_to_third_order():
    errors = []
    for width in (0.02, 0.01):
        samples, windows = averaged_windows(width)
        start = WOBBLE.attitude(width * np.arange(len(samples)))
        middle = WOBBLE.attitude(width * (np.arange(len(samples)) + 0.5))
        inside = scipy_of((windows.inside[0][0], windows.inside[1][0]))
        errors.append(apart(inside[1:-1], (start.inv() * middle)[1:-1]))
    # half of the rotation over the window is off by 1e-3 and 2.6e-4 rad
    assert errors[0] < 2e-5
    assert errors[0] / errors[1] > 7.0


def test_a_fixed_force_is_recovered_to_third_order():
    fixed = Motion(WOBBLE.attitude)
    errors = []
    for width in (0.02, 0.01):
        samples, windows = averaged_windows(width, motion=fixed)
        start = WOBBLE.attitude(width * np.arange(len(samples)))
        force = start.apply(windows.impulse_mps.T) / width
        errors.append(np.linalg.norm(force - UP_1_G, axis=1)[1:-1].max())
    # seen as from the middle of a steady turn it is off by 0.0026 m/s^2
    assert errors[0] < 4e-4
    assert errors[0] / errors[1] > 7.0


CONE_RAD, CONE_RADPS = 0.1, 20.0


def cone(t):
    """Return an axis that runs around a cone: the worst case for means."""
    phase = CONE_RADPS * t
    around = np.stack([np.cos(phase), np.sin(phase), np.zeros_like(t)], axis=-1)
    return Rotation.from_rotvec(CONE_RAD * around)


@pytest.mark.parametrize(("width_s", "better"), [(0.02, 20.0), (0.01, 60.0)])
def test_coning_is_corrected(width_s, better):
    samples, windows = averaged_windows(width_s, 4.0, motion=Motion(cone))
    ends = cone(np.array([0.0, len(samples) * width_s]))
    exact = ends[0].inv() * ends[1]
    with_term = apart(exact, scipy_of(rot.cumulative(windows.rotation))[-1])
    plain = Rotation.identity()
    for rate in samples.angular_rate_radps:
        plain = plain * Rotation.from_rotvec(rate * width_s)
    assert with_term < apart(exact, plain) / better
    # what is missing without: the solid angle that the axis sweeps per round, times
    # 1 - sinc for windows of finite width (Savage 1998, part 1)
    rounds = CONE_RADPS * 4.0 / (2.0 * np.pi)
    swept = 2.0 * np.pi * (1.0 - np.cos(CONE_RAD)) * rounds
    share = 1.0 - np.sinc(CONE_RADPS * width_s / np.pi)
    assert apart(exact, plain) == pytest.approx(swept * share, rel=0.02)


@pytest.mark.parametrize(("width_s", "better"), [(0.02, 5.0), (0.01, 20.0)])
def test_sculling_is_corrected(width_s, better):
    swing_rad, swing_radps, shake_mps2 = 0.1, 20.0, 5.0

    def swing(t):
        return Rotation.from_rotvec(
            swing_rad * np.sin(swing_radps * t)[:, None] * [1.0, 0.0, 0.0]
        )

    def shaken(t):
        return shake_mps2 * np.sin(swing_radps * t)[:, None] * [0.0, 1.0, 0.0]

    # twenty rounds, but for the samples at the ends
    seconds = 40.0 * np.pi / swing_radps
    width_s = seconds / round(seconds / width_s)
    motion = Motion(swing, shaken)
    samples, windows = averaged_windows(width_s, seconds, motion=motion)
    starts = swing(width_s * np.arange(len(samples)))
    mean = starts.apply(windows.impulse_mps.T)[1:-1].mean(axis=0) / width_s
    # without, the mean of rate times change of force is missing (Savage 1998, part 2)
    # less half of it, that of the rate's change times the force
    missing = swing_rad * shake_mps2 * (swing_radps * width_s) ** 2 / 48.0
    assert abs(mean[2] - UP_1_G[2]) < missing / better


@pytest.mark.parametrize(("count", "per_window"), [(10, 3), (11, 4), (7, 1)])
def test_a_short_last_window_of_a_steady_turn_is_like_the_others(count, per_window):
    rate, width_s = np.array([1.0, 2.0, 3.0]), 0.01
    samples = samples_of(
        np.full(count, width_s),
        np.tile(UP_1_G, (count, 1)),
        np.tile(rate, (count, 1)),
        True,
    )
    windows = integrate(at_middles(samples, NO_BIAS), per_window, NO_BIAS, NO_MATRIX)
    for k in range(count):
        exact = Rotation.from_rotvec(rate * width_s * (k % per_window + 0.5))
        assert apart(inside_of(windows, k), exact) < 1e-12


def test_no_sample_of_a_long_recording_stands_out():
    # 100 Hz for 3 minutes: several of the chunks that long recordings are taken in
    width_s, per_window = 0.01, 3
    samples, windows = averaged_windows(width_s, 180.0, per_window)
    total = len(samples) // per_window
    starts = WOBBLE.attitude(width_s * per_window * np.arange(total))
    for row in range(per_window):
        at = width_s * (per_window * np.arange(total) + row + 0.5)
        exact = starts.inv() * WOBBLE.attitude(at)
        inside = scipy_of((windows.inside[0][row], windows.inside[1][row]))
        error = (exact.inv() * inside).magnitude()[2:-2]
        # everywhere else it is below 1e-6 rad
        assert error.max() < 1e-5


# ---- means over windows ---------------------------------------------------------


@pytest.mark.parametrize("turn_rad", [0.0, 1e-9, 0.1, 0.7, 1.0, 4.0, 7.0])
def test_the_mean_of_a_fixed_vector_is_what_quadrature_gives(turn_rad, rng):
    turns = turn_rad * np.array([[0.48, -0.6], [0.6, 0.0], [-0.64, 0.8]])
    vectors = rng.standard_normal((3, 2))
    got = window_mean(vectors, turns)
    for k in range(2):
        expected = window_means(
            lambda t, k=k: Rotation.from_rotvec(
                np.multiply.outer(-t, turns[:, k])
            ).apply(vectors[:, k]),
            np.linspace(-0.5, 0.5, 65)[:-1] + 1 / 128,
            1 / 64,
        ).mean(axis=0)
        assert np.allclose(got[:, k], expected, rtol=0.0, atol=1e-13)


@pytest.mark.parametrize("turn_rad", [0.0, 1e-9, 0.1, 0.7, 1.0, 4.0])
def test_a_mean_is_undone_by_its_inverse(turn_rad, rng):
    turns = turn_rad * np.array([[0.48], [0.6], [-0.64]])
    vectors = rng.standard_normal((3, 1))
    there = window_mean(vectors, turns)
    back = window_mean(there, turns, inverse=True)
    assert np.allclose(back, vectors, rtol=0.0, atol=1e-13)


def test_a_mean_over_whole_turns_is_not_enlarged_without_limit():
    turns = np.array([[0.0], [0.0], [2.0 * np.pi]])
    vectors = np.array([[1.0], [0.0], [1.0]])
    back = window_mean(vectors, turns, inverse=True)
    assert np.isfinite(back).all()
    assert np.linalg.norm(back) < 11.0
    assert back[2, 0] == pytest.approx(1.0)
