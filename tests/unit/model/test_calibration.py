"""A sensor's calibration: other axes, other recordings, two together."""

import math

import numpy as np
import pytest

from hapticplayer.model.calibration import SensorCalibration

KNOWN = SensorCalibration(
    (0.01, 0.02, 0.03),
    (0.001, 0.002, 0.003),
    (0.1, 0.2, 0.3),
    (0.01, 0.02, 0.03),
    1.02,
    0.005,
)


def test_other_axes_turn_values_and_exchange_sigmas():
    upside_down = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    turned = KNOWN.turned(upside_down)
    assert turned.gyro_bias_radps == (-0.02, 0.01, 0.03)
    assert turned.gyro_bias_sigma_radps == (0.002, 0.001, 0.003)
    assert turned.accelerometer_bias_mps2 == (-0.2, 0.1, 0.3)
    assert turned.turned(upside_down.T) == KNOWN


def test_another_recording_is_known_less_well():
    later = KNOWN.for_another_recording()
    assert later.gyro_bias_radps == KNOWN.gyro_bias_radps
    assert later.gyro_bias_sigma_radps[0] == pytest.approx(math.hypot(0.001, 0.0035))
    assert later.accelerometer_scale_sigma > KNOWN.accelerometer_scale_sigma


def test_two_calibrations_are_weighed_by_their_variances():
    other = SensorCalibration((0.05, 0.0, 0.0), (0.002, 0.002, 1.0))
    both = KNOWN.with_other(other)
    # weights 1e6 and 0.25e6; equal; hardly anything known
    assert both.gyro_bias_radps == pytest.approx((0.018, 0.01, 0.03), rel=1e-4)
    assert both.gyro_bias_sigma_radps[1] == pytest.approx(0.002 / math.sqrt(2.0))
    assert both.accelerometer_scale == pytest.approx(1.02, abs=1e-5)
