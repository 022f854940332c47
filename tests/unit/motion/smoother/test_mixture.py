"""Short blocks: evidences and variances of the models, and what they make of clips."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog
from hapticplayer.motion import SmootherParameters, analyse
from hapticplayer.motion.smoother import mixture
from hapticplayer.motion.smoother.evidence import VelocityModel, log_evidences
from hapticplayer.motion.smoother.mixture import (
    SENSORS,
    parts_of,
    shake_evidence,
    shaking,
    variances_of,
)
from hapticplayer.motion.smoother.state import prepare
from hapticplayer.motion.smoother.strapdown import integrate
from tests.unit.motion.smoother.conftest import rms, samples_of
from tests.unit.motion.smoother.test_least_squares import Dense, random_problem

MODELS = [VelocityModel(0.1, 0.5), VelocityModel(1.0, 0.5), VelocityModel(5.0, 20.0)]
CLIP_S = 10.0


def moving(rng):
    """Return a problem with all columns, among them those of a body velocity."""
    problem = random_problem(rng, 12, 19)
    resting = np.zeros_like(problem.zero_velocity_weight)
    return dataclasses.replace(problem, zero_velocity_weight=resting)


def test_parts_have_the_evidence_of_the_whole_equations(rng):
    problem, found, expected = moving(rng), [], []
    for model in MODELS:
        found += [part.log_evidence for part in parts_of(problem, [model] * 2, (2.0,))]
        for sensor in SENSORS:
            weight = problem.prior_weight.copy()
            weight[:3] = np.maximum(weight[:3], sensor.gyro_bias_radps**-2.0)
            weight[3:6] = np.maximum(weight[3:6], sensor.accel_bias_mps2**-2.0)
            weight[7:16:4] = np.minimum(weight[7:16:4], sensor.gyro_scale**-2.0)
            weight[16:] = 2.0**-2.0
            under = dataclasses.replace(problem, prior_weight=weight)
            expected.append(log_evidences(under, [model])[0, 0])
            # what one prior for all models has in common
            prior = np.log(weight) - weight * np.square(problem.prior)
            expected[-1] += 0.5 * prior.sum()
    assert np.diff(found) == pytest.approx(np.diff(expected), abs=1e-6)


def test_parts_have_the_variance_of_the_whole_equations(rng):
    part = parts_of(moving(rng), [MODELS[1]] * 2, (0.0,))[1]
    columns = len(part.solution.calibration)
    factor = np.triu(part.solution.factor)
    weight = np.diagonal(factor.T @ factor)
    weight = weight - np.diagonal(part.solution.normal)[1 : 1 + columns]
    whole = dataclasses.replace(
        part.problem,
        tilt=part.problem.tilt[: 1 + columns],
        impulse=part.problem.impulse[: 1 + columns],
        prior=part.problem.prior[:columns],
        prior_weight=weight,
    )
    found, calibration = variances_of(part)
    dense = Dense(whole)
    assert found == pytest.approx(dense.tilt_variance(), rel=1e-6)
    expected = np.diag(dense.covariance())[5 * dense.nodes :]
    assert calibration == pytest.approx(expected, rel=1e-6)


def windows_of(log):
    step_s = np.full(len(log), 1.0 / log.rate_hz)
    samples = samples_of(
        step_s, log.specific_force_mps2, log.angular_rate_radps, averaged=False
    )
    return integrate(samples, round(log.rate_hz / 16.0), np.zeros(3), np.zeros((3, 3)))


@pytest.mark.parametrize(
    ("scene", "on_wheels"),
    [
        ("car-calm", True),
        ("car-motorway", True),
        ("mountain-bike", True),
        ("handheld-quiet", False),
        ("handheld-brisk", False),
        ("walk", False),
        ("run", False),
    ],
)
def test_wheels_shake_a_sensor_without_turning_it(scene, on_wheels):
    found = shake_evidence(shaking(windows_of(simulate_motion(scene, 4).imu)))
    assert (found > 1.0) if on_wheels else (found < 0.0)


def pieces(scene, bias_radps, seed=4):
    """Yield the summary, errors and sigma of each ten seconds of a ride."""
    ride = simulate_motion(scene, seed)
    log = dataclasses.replace(
        ride.imu, angular_rate_radps=ride.imu.angular_rate_radps + bias_radps
    )
    count = round(CLIP_S * log.rate_hz)
    for start in range(0, len(log) - count + 1, 2 * count):
        part = slice(start, start + count)
        found = analyse(log.part(part))
        missed = found.track.gravity_mps2 - G * ride.vertical[part]
        yield found, missed, found.track.gravity_sigma_mps2


@pytest.mark.parametrize(
    ("scene", "bias_degps", "bound_mps2"),
    [
        ("handheld-brisk", 5.0, 0.4),  # offlineVQF 0.8
        ("handheld-quiet", 5.0, 0.4),  # 0.5
        ("walk", 5.0, 0.5),  # 0.9
        ("car-brisk", 0.0, 0.8),  # 1.5
    ],
)
def test_ten_seconds_are_known_as_well_as_sigma_says(scene, bias_degps, bound_mps2):
    bias_radps = np.radians(bias_degps) * np.array([0.6, -0.64, 0.48])
    found = list(pieces(scene, bias_radps))
    assert np.mean([rms(missed) for _, missed, _ in found]) < bound_mps2
    inside = [np.linalg.norm(m, axis=1) <= 2.0 * sigma for _, m, sigma in found]
    assert np.mean(inside) > 0.85


def test_a_large_bias_does_not_drive(rng):
    """A rig in a hand that hardly moves drove at 6 m/s with 4.5 deg/s."""
    time_s = np.arange(1, 1001) / 100.0
    sway = 0.05 * np.sin(2.0 * np.pi * 0.9 * time_s)[:, None] * [1.0, 0.4, 0.2]
    force = [0.0, 0.0, G] + sway + 0.02 * rng.standard_normal((1000, 3))
    rate = np.radians([3.0, -3.0, 1.5]) + 0.05 * sway
    log = ImuLog(time_s, force, rate + 0.002 * rng.standard_normal((1000, 3)))
    assert analyse(log).summary["driven"] < 0.1


@pytest.mark.parametrize(
    ("seconds", "rate_hz", "node_s"),
    [(40, 100, 0.72), (40, 30, 0.8), (40, 15, 0.8), (60, 30, 1.0667)],
)
def test_short_blocks_have_nodes_as_close_at_any_rate(seconds, rate_hz, node_s):
    steps = np.full(seconds * rate_hz, 1.0 / rate_hz)
    force = np.tile([0.0, 0.0, G], (len(steps), 1))
    samples = samples_of(steps, force, np.zeros_like(force), averaged=True)
    block, _ = prepare(samples, None, SmootherParameters())
    assert block.samples_per_node / rate_hz == pytest.approx(node_s, abs=1e-3)


ROAD_BIAS_RADPS = np.radians([1.0, -2.0, 4.5])


@pytest.fixture
def straight_road(rng):
    """20 s of a car that gains speed, by a gyro that nobody calibrated."""
    time_s = np.arange(1, 2001) / 100.0
    force = 0.6 * rng.standard_normal((2000, 3)) + [0.0, 0.0, G]
    force[:, 1] += np.where(time_s < 8.0, 1.2, 0.0)
    rate = 0.003 * rng.standard_normal((2000, 3))
    rate[:, 2] += 0.005 * np.sin(time_s)  # a hand on the wheel
    return ImuLog(time_s, force, rate + ROAD_BIAS_RADPS)


def test_on_a_straight_road_a_steady_turn_is_the_gyro(straight_road):
    """It was taken for a bend, with 0.2 to 0.6 of the 4.5 deg/s."""
    found = analyse(straight_road)
    assert found.summary["driven"] > 0.5
    assert found.calibration.gyro_bias_radps == pytest.approx(
        ROAD_BIAS_RADPS, abs=0.012
    )


def test_a_bias_that_nothing_was_solved_about_is_not_said(straight_road, monkeypatch):
    monkeypatch.setattr(mixture, "MOST_AGAIN", 0)
    found = analyse(straight_road).calibration.gyro_bias_radps
    monkeypatch.setattr(mixture, "yaw_bias_radps", lambda *_: 0.0)
    assert np.array_equal(found, analyse(straight_road).calibration.gyro_bias_radps)


def test_ten_seconds_of_a_car_are_those_of_a_vehicle():
    assert (
        np.mean([one.summary["driven"] for one, *_ in pieces("car-hills", 0.0)]) > 0.6
    )
