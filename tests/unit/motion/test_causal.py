"""Gravity removal while the samples come."""

import math

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.motion.causal import BRIDGED_S, REST_S, CausalFilter

RATE_HZ, G = 100.0, 9.80665
BIAS = np.array([0.05, -0.1, 0.08])
UPRIGHT = np.array([0.0, 0.0, G])


class Sensor:
    """Lies still or rolls about x, with a gyro bias; `add` feeds a filter."""

    def __init__(self, gain=1.0):
        self.filter, self.gain = CausalFilter(), gain
        self.time_s = self.angle_rad = 0.0

    def add(self, seconds, rate_radps=0.0, push_mps2=(0.0, 0.0, 0.0)):
        found = []
        for _ in range(round(seconds * RATE_HZ)):
            self.time_s += 1.0 / RATE_HZ
            self.angle_rad += rate_radps / RATE_HZ
            up = np.array([0.0, math.sin(self.angle_rad), math.cos(self.angle_rad)])
            force = (G * up + push_mps2) / self.gain
            rate = np.add(BIAS, (rate_radps, 0.0, 0.0))
            found.append(self.filter.add(self.time_s, force, rate))
        return found


@pytest.fixture
def sensor():
    made = Sensor()
    made.add(2 * REST_S)
    return made


def test_acceleration_comes_only_after_a_rest():
    sensor = Sensor()
    assert sensor.add(3.0, rate_radps=2.0) == [None] * 300
    assert sensor.add(REST_S - 0.1)[-1] is None
    assert 0.0 < sensor.filter.rest_s < REST_S
    assert sensor.add(0.2)[-1] == pytest.approx([0.0, 0.0, 0.0], abs=0.02)


def test_a_push_passes_at_once_and_gravity_stays_out_in_a_turn(sensor):
    sensor.add(1.0, rate_radps=math.pi / 2)
    push = (1.0, -2.0, 3.0)
    assert sensor.add(0.01, math.pi / 2, push)[0] == pytest.approx(push, abs=0.15)
    assert sensor.add(0.5)[-1] == pytest.approx([0.0, 0.0, 0.0], abs=0.15)


def test_an_accelerometer_with_another_scale_leaves_no_gravity():
    sensor = Sensor(gain=1.08)
    sensor.add(2 * REST_S)
    assert sensor.add(0.1)[-1] == pytest.approx([0.0, 0.0, 0.0], abs=0.01)


@pytest.mark.parametrize("gain", [9.81, 1e6])
def test_an_accelerometer_without_gravity_is_refused(gain):
    with pytest.raises(InputError, match=r"at rest, gravity is 9\.8"):
        Sensor(gain).add(2 * REST_S)


@pytest.mark.parametrize(
    ("step_s", "force", "rate"),
    [
        (0.01, UPRIGHT * math.nan, BIAS),
        (0.01, UPRIGHT, BIAS * math.inf),
        (0.01, UPRIGHT * 100.0, BIAS),
        (0.01, UPRIGHT, BIAS + 200.0),
        (0.0, UPRIGHT, BIAS),
        (-0.01, UPRIGHT, BIAS),
        (math.nan, UPRIGHT, BIAS),
    ],
    ids=["nan", "inf", "spike", "spin", "twice", "backward", "no-time"],
)
def test_a_sample_that_is_not_usable_leaves_no_trace(sensor, step_s, force, rate):
    assert sensor.filter.add(sensor.time_s + step_s, force, rate) is None
    assert sensor.filter.skipped == 1
    assert sensor.add(0.02)[-1] == pytest.approx([0.0, 0.0, 0.0], abs=0.02)


def test_a_turn_in_a_short_gap_counts(sensor):
    sensor.add(0.2, rate_radps=1.0)
    sensor.time_s += 0.3
    sensor.angle_rad += 0.3
    after = sensor.add(0.02, rate_radps=1.0)
    assert after[0] == pytest.approx([0.0, 0.0, 0.0], abs=0.15)


def test_after_a_clock_went_back_the_sensor_has_to_rest_again(sensor):
    sensor.time_s -= BRIDGED_S + 1.0
    assert sensor.add(0.5)[-1] is None
    assert sensor.add(REST_S)[-1] == pytest.approx([0.0, 0.0, 0.0], abs=0.02)


def test_after_a_long_gap_the_sensor_has_to_rest_again(sensor):
    sensor.time_s += BRIDGED_S
    assert sensor.add(0.5)[-1] is None
    assert sensor.add(REST_S)[-1] is not None
