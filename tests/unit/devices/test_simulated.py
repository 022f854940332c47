"""The simulated grip against the closed form of a damped oscillator."""

import math

import numpy as np
import pytest

from hapticplayer.devices import DEVICES, make_device
from hapticplayer.devices.simulated.point_mass import FALCON, Hand, SimulatedFalcon
from hapticplayer.errors import DeviceError


def run(force, seconds, hand=None, rate=1000):
    device = SimulatedFalcon(hand)
    device.open()
    device.exchange((0.0, 0.0, 0.0), 0.0)
    return np.array(
        [
            device.exchange(force, (k + 1) / rate)[0]
            for k in range(round(seconds * rate))
        ]
    )


def test_a_step_moves_the_grip_like_a_damped_oscillator():
    hand = Hand()
    m, k, c = hand.mass_kg, hand.stiffness_n_per_m, hand.damping_n_s_per_m
    found = run((0.0, 3.0, 0.0), 2.0)[:, 1]
    t = np.arange(1, 2001) / 1000.0
    decay, omega0 = c / (2 * m), math.sqrt(k / m)
    omega = math.sqrt(omega0**2 - decay**2)
    exact = (
        3.0
        / k
        * (
            1
            - np.exp(-decay * t)
            * (np.cos(omega * t) + decay / omega * np.sin(omega * t))
        )
    )
    # semi-implicit Euler at 1 ms: first order, about half a step of delay
    assert np.abs(found - exact).max() < 2e-4
    assert found[-1] == pytest.approx(3.0 / k, rel=1e-3)


def test_the_grip_never_leaves_the_workspace():
    positions = run((9.0, 9.0, 9.0), 1.0)
    assert np.linalg.norm(positions, axis=1).max() <= FALCON.workspace_radius_m + 1e-12


def test_a_hand_that_is_left_alone_comes_to_rest():
    device = SimulatedFalcon()
    device.open()
    for tick in range(500):
        device.exchange((2.0, 0.0, 0.0), tick / 1000)
    for tick in range(500, 4000):
        reading = device.exchange((0.0, 0.0, 0.0), tick / 1000)
    assert math.hypot(*reading.position_m) < 1e-6


def test_a_long_silence_is_not_replayed():
    device = SimulatedFalcon()
    device.open()
    device.exchange((4.0, 0.0, 0.0), 0.0)
    far = device.exchange((4.0, 0.0, 0.0), 3600.0).position_m[0]
    assert 0.0 < far < 0.04


def test_devices_go_by_name():
    assert make_device("simulated").name == "simulated"
    assert set(DEVICES) == {"simulated"}
    with pytest.raises(DeviceError, match="falcon"):
        make_device("falcon")
