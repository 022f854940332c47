"""The quaternion Kalman filter against closed forms and optics."""

import math
from functools import cache

import numpy as np
import pytest

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import quaternions as quat
from hapticplayer.motion.ekf import EkfParameters, recording
from hapticplayer.motion.ekf.quaternion_filter import QuaternionFilter
from hapticplayer.motion.ekf.recording import run_ekf

T = 0.01
FIELD_UT = np.array([0.0, 20.0, -40.0])  # east, north, up; dips by 63 degrees
UP = np.array([0.0, 0.0, 1.0])


def inclination_deg(q, truth):
    """Angle between the estimated and the true vertical."""
    chord = np.linalg.norm(quat.vertical(q) - quat.vertical(truth), axis=-1)
    return np.degrees(2.0 * np.arcsin(np.minimum(0.5 * chord, 1.0)))


def total_deg(q, truth):
    dot = np.abs(np.sum(q * truth, axis=-1))
    return np.degrees(2.0 * np.arccos(np.minimum(dot, 1.0)))


def tumbling(rng, seconds=40.0, noise=0.02, start=(1.0, 0.0, 0.0, 0.0)):
    """A sensor that turns about a wandering axis; exact truth, sampled every T.

    Returns:
        (orientation (N, 4), specific force, angular rate, field)
    """
    q, rate = turned(seconds, tuple(start))
    to_sensor = quat.conjugate(q)
    force = quat.rotate(to_sensor, G * UP) + noise * rng.standard_normal(rate.shape)
    field = quat.rotate(to_sensor, FIELD_UT)
    field += 10 * noise * rng.standard_normal(rate.shape)
    return q, force, rate.copy(), field


@cache
def turned(seconds, start):
    t = np.arange(0.0, seconds, T)
    axes = [0.9 * np.sin(0.7 * t), 0.8 * np.cos(0.9 * t), 0.5 * np.sin(0.3 * t)]
    rate = np.stack(axes, axis=1)
    q = np.empty((len(t), 4))
    q[0] = start
    for k in range(1, len(t)):
        # the rate holds over the interval that ends at its time
        q[k] = quat.multiply(q[k - 1], quat.from_rotation_vector(T * rate[k]))
    return q, rate


def with_still_start(seconds, force, rate):
    """Put a still span in front; its force and rate are the first sample's and zero."""
    count = round(seconds / T)
    return (
        np.concatenate([np.tile(force[:1], (count, 1)), force]),
        np.concatenate([np.zeros((count, 3)), rate]),
    )


# --- accuracy against closed forms


def test_a_swinging_shaken_sensor_is_followed(swing):
    log, acceleration = swing
    result = run_ekf(log.specific_force_mps2, log.angular_rate_radps, None, 1 / 200)
    true_up = (log.specific_force_mps2 - acceleration) / G
    error = np.linalg.norm(quat.vertical(result.quaternion_wxyz) - true_up, axis=1)
    # sustained shaking of 1 to 2 m/s^2; the specific force itself is off by 0.17
    raw = log.specific_force_mps2
    raw = raw / np.linalg.norm(raw, axis=1, keepdims=True)
    assert np.sqrt(np.mean(error[1000:] ** 2)) < 0.01
    assert np.sqrt(np.mean(np.sum(np.square(raw - true_up), axis=1))) > 0.1
    assert result.still_s == 0.0
    assert np.array_equal(result.gyro_bias_radps, np.zeros(3))


def test_a_still_sensor_stays_where_it_is(still_log):
    result = run_ekf(
        still_log.specific_force_mps2, still_log.angular_rate_radps, None, 1 / 200
    )
    truth = np.array([0.2, -0.3, 0.9]) / np.linalg.norm([0.2, -0.3, 0.9])
    chord = np.linalg.norm(quat.vertical(result.quaternion_wxyz) - truth, axis=1)
    assert chord.max() < math.radians(0.1)
    assert result.still_s == pytest.approx(10.0)


def test_a_tumbling_sensor_is_followed_with_noise(rng):
    truth, force, rate, _ = tumbling(rng)
    result = run_ekf(force, rate + 0.002 * rng.standard_normal(rate.shape), None, T)
    assert inclination_deg(result.quaternion_wxyz, truth)[200:].max() < 0.5
    assert result.accelerometer_skipped_share == 0.0


def test_quaternions_are_unit_and_every_number_is_finite(rng):
    _, force, rate, field = tumbling(rng)
    result = run_ekf(force, rate, field, T)
    norm = np.linalg.norm(result.quaternion_wxyz, axis=1)
    assert np.abs(norm - 1.0).max() < 1e-9
    for array in (
        result.inclination_sigma_rad,
        result.accelerometer_bias_mps2,
        result.magnetometer_bias_ut,
    ):
        assert np.isfinite(array).all()


def test_a_wrong_start_is_forgotten(rng):
    truth, force, rate, _ = tumbling(rng, start=quat.from_rotation_vector(0.5 * UP))
    force[0] = [G, 0.0, 0.0]  # 90 degrees off, and it passes the gate
    error = inclination_deg(run_ekf(force, rate, None, T).quaternion_wxyz, truth)
    assert error[0] > 80.0
    assert error[1000:].max() < 2.0
    assert error[-1] < 0.3


@pytest.mark.parametrize("axis", [[1.0, 0, 0], [0, 1.0, 0], [0.6, 0.8, 0]])
def test_an_upside_down_start_is_no_special_case(rng, axis):
    start = quat.from_rotation_vector(math.pi * np.array(axis))
    truth, force, rate, _ = tumbling(rng, 5.0, noise=0.0, start=start)
    result = run_ekf(force, rate, None, T)
    assert inclination_deg(result.quaternion_wxyz, truth).max() < 1e-3


def test_a_first_sample_of_zero_is_passed_over(rng):
    truth, force, rate, _ = tumbling(rng, noise=0.0)
    force[0] = 0.0
    result = run_ekf(force, rate, None, T)
    assert inclination_deg(result.quaternion_wxyz, truth).max() < 1e-3


def test_a_start_in_free_fall_is_worked_out_backwards(rng):
    truth, force, rate, _ = tumbling(rng, noise=0.0)
    force[:200] = 0.0
    result = run_ekf(force, rate, None, T)
    assert inclination_deg(result.quaternion_wxyz, truth).max() < 1e-3
    assert result.accelerometer_skipped_share > 0.05


def test_in_free_fall_the_gyroscope_alone_gives_orientation(rng):
    truth, force, rate, _ = tumbling(rng)
    result = run_ekf(0.0 * force, rate, None, T)
    assert total_deg(result.quaternion_wxyz, truth).max() < 1e-5
    assert result.accelerometer_skipped_share == 1.0
    assert np.all(np.diff(result.inclination_sigma_rad) > 0.0)


# --- the gyro's bias


def test_a_still_start_gives_the_gyro_bias(rng):
    truth, force, rate, _ = tumbling(rng)
    still_force, still_rate = with_still_start(3.0, force, rate)
    bias = np.radians([4.0, -1.0, 2.0])
    noisy = still_rate + bias + 0.002 * rng.standard_normal(still_rate.shape)
    result = run_ekf(still_force, noisy, None, T)
    assert np.abs(result.gyro_bias_radps - bias).max() < 5e-4
    assert result.still_s == pytest.approx(3.0, abs=0.3)
    assert inclination_deg(result.quaternion_wxyz[-len(truth) :], truth).max() < 0.5

    refused = EkfParameters(max_gyro_bias_radps=math.radians(1.0))
    uncaptured = run_ekf(still_force, noisy, None, T, refused)
    assert uncaptured.still_s == 0.0
    error = inclination_deg(uncaptured.quaternion_wxyz[-len(truth) :], truth)
    assert error.max() > 5.0


def test_a_still_span_later_than_the_search_gives_no_bias(rng):
    _, force, rate, _ = tumbling(rng, 20.0)
    after_force, after_rate = with_still_start(5.0, force[::-1], rate[::-1])
    result = run_ekf(after_force[::-1], after_rate[::-1] + 0.05, None, T)
    assert result.still_s == 0.0
    assert np.array_equal(result.gyro_bias_radps, np.zeros(3))


def test_floating_weightlessly_is_not_standing_still():
    rate = np.tile([0.1, 0.0, 0.0], (500, 1))
    result = run_ekf(np.zeros((500, 3)), rate, None, T)
    assert result.still_s == 0.0


# --- gates and biases of the measurements


def braking(rng):
    """Level and still, then pushed sideways with 8 m/s^2 for 3 s."""
    force = np.tile([0.0, 0.0, G], (2000, 1)) + 0.02 * rng.standard_normal((2000, 3))
    force[1000:1300, 0] += 8.0
    return force, np.zeros((2000, 3))


def test_the_gate_keeps_a_sustained_acceleration_out(rng):
    force, rate = braking(rng)
    upright = np.array([1.0, 0.0, 0.0, 0.0])
    gated = run_ekf(force, rate, None, T)
    open_gate = EkfParameters(accelerometer_gate_mps2=100.0)
    ungated = run_ekf(force, rate, None, T, open_gate)
    assert inclination_deg(gated.quaternion_wxyz, upright).max() < 0.3
    assert inclination_deg(ungated.quaternion_wxyz, upright).max() > 5.0
    # the push itself and the window of 0.4 s after it, in which the mean still fails
    assert 0.15 <= gated.accelerometer_skipped_share < 0.15 + 0.4 / 20
    assert ungated.accelerometer_skipped_share == 0.0


def test_the_gate_without_a_window_judges_each_sample_alone(rng):
    force, rate = braking(rng)
    alone = EkfParameters(accelerometer_gate_window_s=0.0)
    result = run_ekf(force, rate, None, T, alone)
    assert result.accelerometer_skipped_share == pytest.approx(0.15)


def test_tumbling_reveals_the_accelerometer_bias(rng):
    truth, force, rate, _ = tumbling(rng, 80.0)
    bias = np.array([0.15, -0.1, 0.12])
    # this sensor is quieter than hands and worse calibrated than a phone
    p = EkfParameters(
        accelerometer_bias_sigma_mps2=0.3, accelerometer_noise_mps2_rthz=0.05
    )
    result = run_ekf(force + bias, rate, None, T, p)
    assert np.abs(result.accelerometer_bias_mps2[-1] - bias).max() < 0.02
    assert inclination_deg(result.quaternion_wxyz, truth)[-2000:].max() < 0.5


# --- the magnetometer


def test_the_field_gives_the_heading(rng):
    truth, force, rate, field = tumbling(rng)
    result = run_ekf(force, rate, field, T)
    assert total_deg(result.quaternion_wxyz, truth)[500:].max() < 1.0
    assert result.magnetometer_skipped_share == 0.0


def test_earth_is_east_north_up():
    force = np.tile([0.0, 0.0, G], (300, 1))
    # the field comes from the sensor's left (-x): the sensor's y axis looks east
    field = np.tile([-20.0, 0.0, -40.0], (300, 1))
    q = run_ekf(force, 0.0 * force, field, T).quaternion_wxyz[-1]
    assert np.allclose(quat.rotate(q, np.array([0.0, 1.0, 0.0])), [1.0, 0.0, 0.0])
    assert np.allclose(quat.rotate(q, np.array([-1.0, 0.0, 0.0])), [0.0, 1.0, 0.0])


def test_a_late_magnetic_field_gives_the_heading_throughout(rng):
    truth, force, rate, field = tumbling(rng, noise=0.0)
    field[:1000] = 0.0
    result = run_ekf(force, rate, field, T)
    assert total_deg(result.quaternion_wxyz, truth).max() < 0.1
    assert result.magnetometer_skipped_share == pytest.approx(0.25)


def test_tumbling_reveals_the_magnetometer_bias(rng):
    truth, force, rate, field = tumbling(rng, 80.0)
    bias = np.array([3.0, -2.0, 2.5])
    known = EkfParameters(
        field_magnitude_ut=float(np.linalg.norm(FIELD_UT)),
        field_dip_rad=math.atan2(40.0, 20.0),
    )
    result = run_ekf(force, rate, field + bias, T, known)
    assert np.abs(result.magnetometer_bias_ut[-1] - bias).max() < 0.5
    assert total_deg(result.quaternion_wxyz, truth)[-2000:].max() < 1.0


@pytest.mark.parametrize(
    "disturbed",
    [
        pytest.param(lambda field: field + 200.0 * np.eye(3)[0], id="norm"),
        # a mirror image has the right norm and, tumbling, mostly a wrong dip
        pytest.param(lambda field: -field, id="dip"),
    ],
)
def test_a_disturbed_field_is_gated_out(rng, disturbed):
    truth, force, rate, field = tumbling(rng)
    field[2500:] = disturbed(field[2500:])
    result = run_ekf(force, rate, field, T)
    assert total_deg(result.quaternion_wxyz, truth)[500:].max() < 1.0
    assert result.magnetometer_skipped_share == pytest.approx(1500 / 4000, abs=0.01)


@pytest.mark.parametrize("kind", ["zero", "parallel to gravity"])
def test_a_field_without_heading_changes_nothing(rng, kind):
    _, force, rate, field = tumbling(rng)
    field = 0.0 * field if kind == "zero" else -5.0 * force
    with_field = run_ekf(force, rate, field, T)
    without = run_ekf(force, rate, None, T)
    difference = with_field.quaternion_wxyz - without.quaternion_wxyz
    assert np.abs(difference).max() < 1e-9
    assert with_field.magnetometer_skipped_share == 1.0


# --- the covariance


@pytest.fixture
def covariances(monkeypatch):
    """Return a list of what the filter ends each sample with, but the last."""
    seen = []

    class Watched(QuaternionFilter):
        def predict(self, turn):
            seen.append(self.P.copy())
            super().predict(turn)

    monkeypatch.setattr(recording, "QuaternionFilter", Watched)
    return seen


def shaken(rng, seconds=10.0):
    """Tumbling, and shaken so hard that the gates open and close."""
    _, force, rate, field = tumbling(rng, seconds)
    t = np.arange(0.0, seconds, T)
    force = force + np.outer(6.0 * np.sin(0.9 * t) ** 8, [1.0, 0.5, -0.3])
    return force, rate, field


@pytest.mark.parametrize("has_field", [False, True])
@pytest.mark.parametrize(
    "parameters",
    [
        EkfParameters(),
        # ill-conditioned: a nearly perfect sensor after a nearly unknown start
        EkfParameters(
            accelerometer_noise_mps2_rthz=1e-5,
            magnetometer_noise_ut_rthz=1e-5,
            start_inclination_sigma_rad=100.0,
        ),
    ],
    ids=["defaults", "ill-conditioned"],
)
def test_the_covariance_is_symmetric_and_positive_definite(
    rng, covariances, has_field, parameters
):
    force, rate, field = shaken(rng)
    result = run_ekf(force, rate, field if has_field else None, T, parameters)
    assert len(covariances) == len(force) - 1
    for covariance in covariances:
        assert np.array_equal(covariance, covariance.T)
        np.linalg.cholesky(covariance)  # raises unless positive definite
    assert 0.05 < result.accelerometer_skipped_share < 0.95


def test_the_covariance_forgets_its_start_and_stays_bounded(rng, covariances):
    force, rate, _ = shaken(rng, 100.0)
    run_ekf(force, rate, None, T)
    variance = np.array([covariance.diagonal() for covariance in covariances])
    assert np.all(variance[5000:].max(axis=0) < 1.1 * variance[2500:5000].max(axis=0))
    assert np.all(variance[-1, :2] < 0.01 * variance[0, :2])


def test_the_expected_error_does_not_depend_on_the_sampling_rate(swing):
    log, _ = swing
    force, rate = log.specific_force_mps2, log.angular_rate_radps
    fast = run_ekf(force, rate, None, 1 / 200).inclination_sigma_rad[-1]
    slow = run_ekf(force[::4], rate[::4], None, 1 / 50).inclination_sigma_rad[-1]
    assert slow == pytest.approx(fast, rel=0.05)


# --- what goes in


def test_float32_and_strided_arrays_give_the_same(rng):
    _, force, rate, field = tumbling(rng, 2.0)
    inputs = [np.float64(np.float32(a)) for a in (force, rate, field)]
    expected = run_ekf(*inputs, T).quaternion_wxyz
    single = run_ekf(*(np.float32(a) for a in inputs), T).quaternion_wxyz
    strided = run_ekf(*(np.repeat(a, 2, axis=1)[:, ::2] for a in inputs), T)
    assert np.array_equal(single, expected)
    assert np.array_equal(strided.quaternion_wxyz, expected)


def test_one_sample_is_enough():
    result = run_ekf([[3.0, 0.0, 4.0]], [[0.1, 0.0, 0.0]], [[0.0, 20.0, -40.0]], T)
    assert np.allclose(quat.vertical(result.quaternion_wxyz), [[0.6, 0.0, 0.8]])


def test_arrays_that_are_no_recording_are_refused():
    three = np.ones((3, 3))
    with pytest.raises(InputError, match="0 samples"):
        run_ekf(np.zeros((0, 3)), np.zeros((0, 3)), None, T)
    for interval_s in (0.0, -T, math.nan, math.inf):
        with pytest.raises(InputError, match="not a recording"):
            run_ekf(three, three, None, interval_s)
    with pytest.raises(InputError, match="as many samples"):
        run_ekf(three, np.ones((2, 3)), None, T)
    with pytest.raises(InputError, match="as many samples"):
        run_ekf(three, three, np.ones((2, 3)), T)
    with pytest.raises(InputError, match="expected N x 3"):
        run_ekf(np.ones((3, 2)), three, None, T)


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_noise_that_is_not_positive_is_refused(value):
    with pytest.raises(UsageError, match="gyro_noise_radps_rthz"):
        EkfParameters(gyro_noise_radps_rthz=value)
    with pytest.raises(UsageError, match="field_magnitude_ut"):
        EkfParameters(field_magnitude_ut=value)


def test_a_dip_beyond_the_vertical_is_refused():
    with pytest.raises(UsageError, match="right angle"):
        EkfParameters(field_dip_rad=math.radians(100.0))
    with pytest.raises(UsageError, match="right angle"):
        EkfParameters(field_dip_rad=math.nan)


# --- real recordings


@pytest.mark.parametrize(
    "name",
    [
        "broad_04_undisturbed_slow_rotation_with_breaks_A",
        "broad_10_undisturbed_slow_translation_A",
    ],
)
def test_a_hand_held_sensor_agrees_with_optics(optical, name):
    (one,) = (one for one in optical("broad native") if one.name == name)
    log, first = one.log, np.flatnonzero(one.counted)[0]
    cut = slice(first + round(30.0 * log.rate_hz))  # the still start and 30 s of motion
    counted, attitude = one.counted[cut], one.attitude[cut]
    samples = log.specific_force_mps2[cut], log.angular_rate_radps[cut]
    result = run_ekf(*samples, None, 1.0 / log.rate_hz)
    difference = quat.vertical(result.quaternion_wxyz) - one.up[cut]
    # such filters were measured to leave 0.64 m/s^2 on average over harder recordings
    assert G * np.sqrt(np.mean(np.sum(difference[counted] ** 2, axis=1))) < 0.15
    assert result.still_s > 20.0
    with_field = run_ekf(*samples, log.magnetic_field_ut[cut], 1.0 / log.rate_hz)
    error = total_deg(with_field.quaternion_wxyz, attitude)[counted]
    assert np.sqrt(np.mean(error**2)) < 3.0
