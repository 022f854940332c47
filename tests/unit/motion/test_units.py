"""Units are recognised from how gravity looks and turns."""

import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion.repair.timestamps import repair_times
from hapticplayer.motion.repair.units import (
    calm_norm,
    check_force_unit,
    check_rate_unit,
)

T = np.arange(0, 20, 0.01)
DEGREES = 180.0 / np.pi
CLIP_S = 10.0


def named_factor(refused) -> float:
    """The number that a remedy says to multiply or divide by."""
    how, number = re.search(
        r"(multiply|divide) \S+ by ([\d.]*\d)", str(refused.value)
    ).groups()
    return float(number) if how == "multiply" else 1.0 / float(number)


def still(rng, rate_noise, bias=(0.0, 0.0, 0.0)):
    force = [0.0, 3.0, 9.3] + 0.02 * rng.standard_normal((len(T), 3))
    return force, np.array(bias) + rate_noise * rng.standard_normal((len(T), 3))


@pytest.mark.parametrize(
    ("factor", "remedy"),
    [
        (1 / STANDARD_GRAVITY_MPS2, r"in g: multiply it by 9\.80665"),
        (1000 / STANDARD_GRAVITY_MPS2, r"milli-g: multiply it by 0\.00980665"),
        (0.2, "if it is in g.*removed already"),
        (0.02, "gravity seems to be removed already"),
        (5.0, r"give the specific force in m/s\^2"),
    ],
)
def test_a_force_in_another_unit_is_refused_with_the_factor(swing, factor, remedy):
    log, _ = swing
    check_force_unit(log.time_s, log.specific_force_mps2)
    given = factor * log.specific_force_mps2
    with pytest.raises(InputError, match=remedy) as refused:
        check_force_unit(log.time_s, given)
    if "multiply" in remedy and "removed" not in remedy:
        check_force_unit(log.time_s, named_factor(refused) * given)


def test_gravity_of_981_is_not_taken_for_milli_g(rng):
    force, _ = still(rng, 0.001)
    with pytest.raises(InputError, match=r"in cm/s\^2: multiply it by 0\.01"):
        check_force_unit(T, 100.0 * force)


def test_the_calm_norm_looks_past_free_fall_and_shaking(rng):
    force, _ = still(rng, 0.001)
    force[300:900] = 0.02 * rng.standard_normal((600, 3))
    force[1000:1400] += 30.0 * rng.standard_normal((400, 3))
    true = np.hypot(3.0, 9.3)
    assert calm_norm(T, force) == pytest.approx(true, abs=0.01)


def test_turning_tells_degrees_from_radians(swing):
    log, _ = swing
    given = log.time_s, log.specific_force_mps2
    check_rate_unit(*given, log.angular_rate_radps)
    with pytest.raises(InputError, match=r"deg/s: multiply it by") as refused:
        check_rate_unit(*given, DEGREES * log.angular_rate_radps)
    factor = named_factor(refused)
    assert factor == pytest.approx(np.pi / 180.0)
    assert check_rate_unit(*given, factor * DEGREES * log.angular_rate_radps) is None


@pytest.mark.parametrize("per_s", [1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9])
def test_the_number_that_is_named_makes_seconds_of_times(swing, per_s):
    log, _ = swing
    given = per_s * log.time_s
    with pytest.raises(InputError, match=r"(divide|multiply) time_s") as refused:
        repair_times(given.copy(), [])
    line = repair_times(named_factor(refused) * given, [])
    np.testing.assert_allclose(line.time_s, log.time_s, atol=1e-6)


def test_a_rate_that_was_converted_twice_is_recognised():
    angle = 1.2 * np.sin(1.5 * T)
    force = Rotation.from_rotvec(np.outer(-angle, [1.0, 0, 0])).apply([0, 0, 9.8])
    rate = np.outer(1.8 * np.cos(1.5 * T), [1.0, 0, 0])
    check_rate_unit(T, force, rate)
    with pytest.raises(InputError, match=r"twice: multiply it by") as refused:
        check_rate_unit(T, force, rate / DEGREES)
    assert named_factor(refused) == pytest.approx(DEGREES)
    assert check_rate_unit(T, force, named_factor(refused) * rate / DEGREES) is None


@pytest.mark.parametrize("bias", [(0, 0, 0), (0.1, -0.1, 0.1), (0.0, 0.61, 1.9)])
def test_rest_bias_and_turning_about_the_vertical_pass(rng, bias):
    force, rate = still(rng, 0.003, bias)
    check_rate_unit(T, force, rate)


def swinging_arm(seed, tilted=False):
    """A sensor on a pendulum's bob, where the force stays along the rod.

    With theta = A sin(w t), a bob at r has r theta'' + g sin(theta) across the rod,
    left out where the force is along it alone, and g cos(theta) + r theta'^2 along it.
    """
    rng = np.random.default_rng(seed)
    t = T[T < CLIP_S]
    amplitude, r = np.radians(rng.uniform(20.0, 75.0)), rng.uniform(0.35, 0.8)
    g = STANDARD_GRAVITY_MPS2
    w = np.sqrt(g / r) * (1.0 - amplitude**2 / 16.0)
    phase = w * t + rng.uniform(0.0, 2.0 * np.pi)
    theta, speed = amplitude * np.sin(phase), amplitude * w * np.cos(phase)
    none = np.zeros_like(t)
    across = g * np.sin(theta) - r * w**2 * theta if tilted else none
    along = g * np.cos(theta) + r * speed**2
    mounted = Rotation.random(rng=rng)
    force = mounted.apply(np.stack([none, across, along], axis=1))
    rate = mounted.apply(np.stack([speed, none, none], axis=1))
    bias = rng.normal(0.0, 0.03, 3)
    shape = (len(t), 3)
    force += 0.2 * rng.standard_normal(shape)
    return t, force, rate + bias + 0.01 * rng.standard_normal(shape)


@pytest.mark.parametrize("tilted", [False, True])
@pytest.mark.parametrize("seed", range(30))
def test_swinging_arms_pass_in_rad_and_not_in_degrees(seed, tilted):
    t, force, rate = swinging_arm(seed, tilted)
    assert check_rate_unit(t, force, rate) is None
    with pytest.raises(InputError, match="deg/s"):
        check_rate_unit(t, force, DEGREES * rate)


@pytest.mark.parametrize("bias_radps", [0.008, 0.015])
def test_a_rest_in_degrees_is_noted_and_not_refused(rng, bias_radps):
    """What rotates so steadily may be a bias at rest, or a long turn."""
    force, rate = still(rng, 0.001, (bias_radps, 0.0, 0.0))
    assert check_rate_unit(T, force, rate) is None
    assert check_rate_unit(T, force, rate / DEGREES) is None
    assert check_rate_unit(T, force, rate * DEGREES) is not None


def test_an_unlikely_unit_without_evidence_is_noted(rng):
    """Fast rotation about the vertical: the force says nothing."""
    force, rate = still(rng, 0.003)
    rate += 20.0 * force / np.linalg.norm(force, axis=1, keepdims=True)
    note = check_rate_unit(T, force, rate)
    assert note is not None
    assert "does not clearly agree" in note
    assert check_rate_unit(T, force, 0.05 * rate) is None


def test_a_recording_shorter_than_two_seconds_passes(rng):
    force, rate = still(rng, 2.0)
    check_rate_unit(T[:50], force[:50], DEGREES * rate[:50])


def test_real_recordings_pass_and_are_refused_in_degrees_or_g(shared_data):
    paths = sorted((shared_data / "orientation" / "native").glob("*.npz"))
    assert len(paths) >= 10
    for path in paths:
        with np.load(path) as data:
            force, rate = data["acc"].astype(float), data["gyr"].astype(float)
            time_s = np.arange(len(force)) / float(data["rate"])
        check_force_unit(time_s, force, path.stem)
        assert check_rate_unit(time_s, force, rate, path.stem) is None
        with pytest.raises(InputError, match="deg/s"):
            check_rate_unit(time_s, force, DEGREES * rate, path.stem)
        with pytest.raises(InputError, match="in g"):
            check_force_unit(time_s, force / STANDARD_GRAVITY_MPS2, path.stem)


def test_no_real_clip_in_the_right_unit_is_refused(shared_data):
    """Ten seconds of phones; in deg/s none passes without a doubt."""
    for path in sorted((shared_data / "orientation" / "averaged_30hz").glob("tyrex*")):
        with np.load(path) as data:
            force, rate = data["acc"].astype(float), data["gyr"].astype(float)
            hz = float(data["rate"])
        count = round(CLIP_S * hz)
        for begin in range(0, len(force) - count, count // 2):
            cut = slice(begin, begin + count)
            given = np.arange(count) / hz, force[cut]
            assert check_rate_unit(*given, rate[cut]) is None
            with pytest.raises(InputError, match="deg/s"):
                check_rate_unit(*given, DEGREES * rate[cut])
