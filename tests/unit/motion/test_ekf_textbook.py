"""The quaternion Kalman filter against its printed form, written out with matrices."""

import math

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import quaternions as quat
from hapticplayer.motion.ekf import EkfParameters
from hapticplayer.motion.ekf.recording import run_ekf

T = 0.01
GRAVITY = np.array([0.0, 0.0, G])
FIELD_UT = np.array([0.0, 20.0, -40.0])
IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])
# noises at which every term counts within the 10 s of the test
PARAMETERS = EkfParameters(
    gyro_noise_radps_rthz=0.02,
    accelerometer_bias_sigma_mps2=0.2,
    accelerometer_bias_time_s=20.0,
    magnetometer_bias_time_s=20.0,
    start_inclination_sigma_rad=0.02,
    start_heading_sigma_rad=0.02,
    accelerometer_gate_mps2=100.0,
    magnetometer_gate_ut=100.0,
    dip_gate_rad=4.0,
    field_magnitude_ut=float(np.linalg.norm(FIELD_UT)),
    field_dip_rad=math.atan2(40.0, 20.0),
)


def textbook(force, rate, field, p):
    """The filter with 4 + 3 (+ 3) states in the Joseph form, all gates open.

    After each update q is normalised and the covariance projected onto the tangent
    of the unit sphere there.
    """
    state, cov = start(p, field is not None)
    out = []
    for k in range(len(force)):
        if k:
            state, cov = predict(state, cov, rate[k], p)
        r = p.accelerometer_noise_mps2_rthz**2 / T
        state, cov = update(state, cov, GRAVITY, force[k], 4, r)
        if field is not None:
            r = p.magnetometer_noise_ut_rthz**2 / T
            state, cov = update(state, cov, FIELD_UT, field[k], 7, r)
        out.append(state.copy())
    return np.array(out)


def bias_sigma(p, count):
    both = [p.accelerometer_bias_sigma_mps2, p.magnetometer_bias_sigma_ut]
    return np.repeat(both, 3)[:count]


def start(p, has_field):
    """Identity; q moves by half the rotation error."""
    state = np.concatenate([IDENTITY, np.zeros(6 if has_field else 3)])
    tilt, heading = p.start_inclination_sigma_rad, p.start_heading_sigma_rad
    sigma = bias_sigma(p, len(state) - 4)
    spread = np.concatenate([[0.0], 0.5 * np.array([tilt, tilt, heading]), sigma])
    return state, np.diag(spread**2)


def predict(state, cov, rate_radps, p):
    count = len(state) - 4
    keep = math.exp(-T / p.accelerometer_bias_time_s)
    transition = keep * np.eye(len(state))
    turn = quat.from_rotation_vector(T * rate_radps)
    transition[:4, :4] = [quat.multiply(e, turn) for e in np.eye(4)]
    transition[:4, :4] = transition[:4, :4].T
    state = transition @ state
    lost = bias_sigma(p, count) ** 2 * (1.0 - keep**2)
    noise = np.diag(np.concatenate([np.zeros(4), lost]))
    xi = np.array([quat.multiply(state[:4], e) for e in np.eye(4)[1:]]).T
    sigma_g = p.gyro_noise_radps_rthz / math.sqrt(T)
    noise[:4, :4] = (T / 2) ** 2 * sigma_g**2 * xi @ xi.T
    return state, transition @ cov @ transition.T + noise


def update(state, cov, vector, measured, first, variance):
    """Use measured = R(q)' vector + the bias that begins at `first`."""
    size = len(state)
    h = np.zeros((3, size))
    h[:, :4] = derivative_of_rotated(state[:4], vector)
    h[:, first : first + 3] = np.eye(3)
    gain = cov @ h.T @ np.linalg.inv(h @ cov @ h.T + variance * np.eye(3))
    expected = quat.rotate(quat.conjugate(state[:4]), vector)
    state = state + gain @ (measured - expected - state[first : first + 3])
    left = np.eye(size) - gain @ h
    cov = left @ cov @ left.T + variance * gain @ gain.T
    length = np.linalg.norm(state[:4])
    state[:4] /= length
    project = np.eye(size)
    project[:4, :4] = (np.eye(4) - np.outer(state[:4], state[:4])) / length
    return state, project @ cov @ project.T


def derivative_of_rotated(q, vector):
    """d(q* v q)/dq; it is quadratic in q, so that central differences are exact."""
    v = np.concatenate([[0.0], vector])

    def rotated(p):
        return quat.multiply(quat.multiply(quat.conjugate(p), v), p)[1:]

    return np.stack([(rotated(q + e) - rotated(q - e)) / 2 for e in np.eye(4)], axis=1)


def tumbling(rng, count=1000):
    """Noisy samples of a sensor that turns about a wandering axis."""
    t = T * np.arange(count)
    axes = [0.9 * np.sin(0.7 * t), 0.8 * np.sin(0.9 * t), 0.5 * np.sin(0.3 * t)]
    rate = np.stack(axes, axis=1)
    q = np.tile(IDENTITY, (count, 1))
    for k in range(1, count):
        q[k] = quat.multiply(q[k - 1], quat.from_rotation_vector(T * rate[k]))
    to_sensor = quat.conjugate(q)
    # no noise in the first sample: both start from it, at the identity
    noise = rng.standard_normal((2, count, 3)) * (t > 0.0)[:, None]
    force = quat.rotate(to_sensor, GRAVITY) + 0.2 * noise[0]
    return force, rate, quat.rotate(to_sensor, FIELD_UT) + 1.0 * noise[1]


@pytest.mark.parametrize("has_field", [False, True])
def test_the_filter_is_that_of_the_textbook(rng, has_field):
    force, rate, field = tumbling(rng)
    field = field if has_field else None
    ours = run_ekf(force, rate, field, T, PARAMETERS)
    theirs = textbook(force, rate, field, PARAMETERS)
    # ours leaves out how a correction turns its own covariance, which is of second
    # order; 10 % more in any one parameter moves the biases by 6e-5 or more
    sign = np.sign(np.sum(ours.quaternion_wxyz * theirs[:, :4], axis=1))
    difference = ours.quaternion_wxyz - sign[:, None] * theirs[:, :4]
    assert np.abs(difference).max() < 2e-6
    bias = ours.accelerometer_bias_mps2 - theirs[:, 4:7]
    assert np.abs(bias).max() < 2e-6
    if ours.magnetometer_bias_ut is not None:
        bias = ours.magnetometer_bias_ut - theirs[:, 7:]
        assert np.abs(bias).max() < 1e-5
