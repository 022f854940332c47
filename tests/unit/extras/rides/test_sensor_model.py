"""The sensor model against closed forms: means, spectra, limits, steps."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.spatial.transform import Rotation

from hapticplayer.errors import UsageError
from hapticplayer.extras.rides.sensors import (
    SENSORS,
    SensorErrors,
    SensorModel,
    measure,
    window_means,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.model import STANDARD_GRAVITY_MPS2, Sampling

DURATION_S = 20.0
SWAY_M, SWAY_RADPS = 0.05, 9.0
ROLL_RAD, ROLL_RADPS = 0.8, 5.0


def swaying() -> Trajectory:
    """x = A sin(w t), roll = B sin(v t): everything else has a closed form."""
    time_s = np.arange(-1.0, DURATION_S + 1.0, 0.002)
    zero = np.zeros_like(time_s)
    position = np.stack([SWAY_M * np.sin(SWAY_RADPS * time_s), zero, zero], axis=1)
    angles = np.stack([zero, zero, ROLL_RAD * np.sin(ROLL_RADPS * time_s)], axis=1)
    return Trajectory(time_s, position, angles)


def at_rest(duration_s: float) -> Trajectory:
    time_s = np.arange(-1.0, duration_s + 1.0, 0.05)
    zeros = np.zeros((len(time_s), 3))
    return Trajectory(time_s, zeros, zeros)


def force(time_s: float) -> np.ndarray:
    """R^T (a + g z) for a roll about y: the closed form."""
    roll = ROLL_RAD * np.sin(ROLL_RADPS * time_s)
    across = -SWAY_M * SWAY_RADPS**2 * np.sin(SWAY_RADPS * time_s)
    g = STANDARD_GRAVITY_MPS2
    return np.array(
        [
            np.cos(roll) * across - np.sin(roll) * g,
            0.0,
            np.sin(roll) * across + np.cos(roll) * g,
        ]
    )


def test_ideal_sensor_writes_the_force_at_its_time() -> None:
    measured = measure(swaying(), DURATION_S, SENSORS["ideal"], seed=1)
    expected = np.array([force(t) for t in measured.imu.time_s])
    assert measured.imu.sampling is Sampling.INSTANT
    assert len(measured.imu) == 4001
    np.testing.assert_allclose(measured.imu.specific_force_mps2, expected, atol=1e-8)


def test_gyro_loses_no_angle_between_samples() -> None:
    """Chaining its rotations ends at the true roll; a sampled rate would not."""
    model = SensorModel("slow", rate_hz=20.0)
    measured = measure(swaying(), DURATION_S, model, seed=1)
    turned = Rotation.identity()
    for rate in measured.imu.angular_rate_radps[1:]:
        turned = turned * Rotation.from_rotvec(rate / 20.0)
    end = Rotation.from_rotvec([0.0, ROLL_RAD * np.sin(ROLL_RADPS * DURATION_S), 0.0])
    assert (end.inv() * turned).magnitude() < 1e-9


@pytest.mark.parametrize(("rate_hz", "tolerance_mps2"), [(210.0, 2e-3), (200.0, 1e-2)])
def test_averaged_samples_are_the_means_over_their_windows(
    rate_hz: float, tolerance_mps2: float
) -> None:
    """Against adaptive quadrature; the midpoint rule errs by the square of its step.

    A window of 6 2/3 samples takes parts of samples, each as if it were constant.
    """
    model = SensorModel("board", rate_hz=rate_hz, averaged_to_hz=30.0)
    measured = measure(swaying(), DURATION_S, model, seed=1)
    imu = measured.imu
    assert imu.sampling is Sampling.AVERAGED
    assert len(imu) == 600
    np.testing.assert_allclose(imu.time_s, (np.arange(600) + 0.5) / 30.0, atol=1e-12)
    for k in (0, 1, 17, 300, 599):
        window = (k / 30.0, (k + 1) / 30.0)
        mean = [30.0 * quad(lambda t, i=i: force(t)[i], *window)[0] for i in range(3)]
        np.testing.assert_allclose(
            imu.specific_force_mps2[k], mean, atol=tolerance_mps2
        )
        rise = np.sin(ROLL_RADPS * window[1]) - np.sin(ROLL_RADPS * window[0])
        expected_rate = 30.0 * ROLL_RAD * rise
        assert imu.angular_rate_radps[k, 1] == pytest.approx(
            expected_rate, abs=tolerance_mps2
        )
        up_x = (
            30.0
            * quad(lambda t: -np.sin(ROLL_RAD * np.sin(ROLL_RADPS * t)), *window)[0]
        )
        assert measured.vertical[k, 0] == pytest.approx(up_x, abs=0.1 * tolerance_mps2)


def test_mean_of_force_is_mean_motion_plus_mean_gravity() -> None:
    """What gravity removal has to subtract: g times the window-averaged vertical."""
    measured = measure(swaying(), DURATION_S, SensorModel("b", averaged_to_hz=30.0), 1)
    gravity = STANDARD_GRAVITY_MPS2 * measured.vertical
    np.testing.assert_allclose(
        measured.imu.specific_force_mps2 - gravity,
        measured.acceleration_mps2,
        atol=1e-9,
    )
    norms = np.linalg.norm(measured.vertical, axis=1)
    # the roll of up to 4 rad/s turns by 0.13 rad in a window: 1 - 0.13^2 / 24
    assert 0.99915 < norms.min() < 0.9994
    assert norms.max() <= 1.0


def test_window_means_split_a_sample_between_two_windows() -> None:
    values = np.arange(10.0)[:, None] * np.ones((1, 3))
    means = window_means(values, 2.5)
    # by hand: 0, 1 and half of 2; half of 2, 3 and 4; ...
    np.testing.assert_allclose(means[:, 0], [0.8, 3.2, 5.8, 8.2])


def test_noise_bias_and_scale_have_the_stated_sizes() -> None:
    noise = SensorErrors(noise=0.05)
    model = SensorModel("noisy", accelerometer=noise)
    log = measure(at_rest(100.0), 100.0, model, seed=3).imu.specific_force_mps2
    np.testing.assert_allclose(log.std(axis=0), 0.05, rtol=0.02)
    np.testing.assert_allclose(
        log.mean(axis=0), [0.0, 0.0, STANDARD_GRAVITY_MPS2], atol=1.5e-3
    )
    exact = np.tile([1.0, 2.0, 10.0], (4, 1))
    biases, scales = [], []
    for seed in range(300):
        rng = np.random.default_rng(seed)
        biases.append(SensorErrors(bias=0.3).applied(exact, 200.0, rng)[0] - exact[0])
        scales.append(SensorErrors(scale=0.01).applied(exact, 200.0, rng)[0] / exact[0])
    np.testing.assert_allclose(np.std(biases, axis=0), 0.3, rtol=0.15)
    np.testing.assert_allclose(np.std(scales, axis=0), 0.01, rtol=0.15)
    np.testing.assert_allclose(np.mean(scales, axis=0), 1.0, atol=0.002)


def test_bias_instability_is_a_gauss_markov_process() -> None:
    """SD sigma, and a correlation of exp(-1) after its correlation time."""
    errors = SensorErrors(drift=0.02, drift_time_s=0.5)
    rng = np.random.default_rng(5)
    drift = errors.applied(np.zeros((400_000, 3)), 200.0, rng)
    np.testing.assert_allclose(drift.std(axis=0), 0.02, rtol=0.05)
    later = np.mean(drift[:-100] * drift[100:], axis=0) / drift.var(axis=0)
    np.testing.assert_allclose(later, np.exp(-1.0), atol=0.05)


def test_values_are_clipped_at_full_scale_and_nowhere_else() -> None:
    exact = np.linspace(-30.0, 30.0, 601)[:, None] * np.ones((1, 3))
    limit = 2.0 * STANDARD_GRAVITY_MPS2
    rng = np.random.default_rng(1)
    clipped = SensorErrors(limit=limit).applied(exact, 200.0, rng)
    np.testing.assert_array_equal(clipped, np.clip(exact, -limit, limit))
    assert np.sum(np.abs(clipped) == limit) == 3 * np.sum(np.abs(exact[:, 0]) > limit)


def test_values_come_in_whole_steps_within_half_a_step() -> None:
    step = SENSORS["paper-board"].accelerometer.step
    assert step == pytest.approx(0.0383, abs=1e-4)  # 3.9 mg
    exact = np.random.default_rng(2).normal(0.0, 5.0, (1000, 3))
    value = SensorErrors(step=step).applied(exact, 200.0, np.random.default_rng(1))
    np.testing.assert_allclose(value / step, np.round(value / step), atol=1e-9)
    assert 0.45 * step < np.abs(value - exact).max() <= 0.5 * step * (1 + 1e-9)


def test_phone_has_the_gyro_bias_of_an_uncalibrated_phone() -> None:
    log = measure(at_rest(30.0), 30.0, SENSORS["phone"], seed=8).imu
    bias_degps = np.degrees(log.angular_rate_radps.mean(axis=0))
    assert 3.5 < np.linalg.norm(bias_degps) < 5.0
    assert SENSORS["phone"].accelerometer.limit == 2.0 * STANDARD_GRAVITY_MPS2


def test_seeds_of_ride_and_sensor_both_matter() -> None:
    camera = SENSORS["camera"]
    first, again = (measure(at_rest(5.0), 5.0, camera, 4).imu for _ in range(2))
    np.testing.assert_array_equal(first.specific_force_mps2, again.specific_force_mps2)
    np.testing.assert_array_equal(first.angular_rate_radps, again.angular_rate_radps)
    other_copy = SensorModel(
        "camera", accelerometer=camera.accelerometer, gyro=camera.gyro, seed=1
    )
    for model, seed in ((camera, 5), (other_copy, 4)):
        other = measure(at_rest(5.0), 5.0, model, seed).imu
        assert not np.array_equal(first.specific_force_mps2, other.specific_force_mps2)


@pytest.mark.parametrize(
    ("rate_hz", "averaged_to_hz"),
    [(0.0, None), (-5.0, None), (50.0, 60.0), (50.0, 0.0)],
)
def test_impossible_rates_are_refused(
    rate_hz: float, averaged_to_hz: float | None
) -> None:
    with pytest.raises(UsageError, match="give rates above 0"):
        SensorModel("odd", rate_hz=rate_hz, averaged_to_hz=averaged_to_hz)
