"""Presets of the rendering: faithful, balanced, equal."""

import numpy as np
import pytest

from hapticplayer.devices.dynamics import Mechanism
from hapticplayer.errors import UsageError
from hapticplayer.model import MotionTrack
from hapticplayer.rendering import render_force
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.presets import PRESETS, YIELDING, render_preset
from hapticplayer.simulation.falcon.kinematics import PlantGeometry, PlantKinematics
from hapticplayer.simulation.falcon.plant import Plant


@pytest.fixture(scope="module")
def swinging():
    """Motion that swings a relaxed hand at its own frequency, then pushes it for long."""
    t = np.arange(0.0, 9.0, 0.005)
    along = np.where(t < 4.0, 11.0 * np.sign(np.sin(2.0 * np.pi * 2.3 * t)), 0.0)
    along += 8.0 * ((t > 4.5) & (t < 8.0))
    acceleration = np.stack([along, 0.0 * t, 0.2 * along], axis=1)
    count = len(t)
    return MotionTrack(
        time_s=t,
        acceleration_mps2=acceleration,
        gravity_mps2=np.zeros((count, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0, 0, 0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, bool),
    )


def test_faithful_is_the_direct_rendering(swinging):
    direct, faithful = render_force(swinging), render_preset(swinging, name="faithful")
    assert np.array_equal(faithful.force_n, direct.force_n)
    assert np.array_equal(faithful.time_s, direct.time_s)
    assert faithful.provenance == {**direct.provenance, "preset": "faithful"}


@pytest.mark.parametrize(("name", "reach_m"), [("balanced", 0.026), ("equal", 0.022)])
def test_the_predicted_relaxed_hand_stays_within(swinging, name, reach_m):
    direct = predict(render_force(swinging), 9.0).hands["relaxed"].reach
    track = render_preset(swinging, name=name)
    assert direct * 0.04 > reach_m
    assert predict(track, 9.0).hands["relaxed"].reach * 0.04 <= reach_m
    made = track.provenance
    assert (made["preset"], made["washout"]["reach_m"]) == (name, reach_m)


def test_a_yielding_hand_stays_within_without_the_spring(swinging):
    track = render_preset(swinging, name="equal")
    reaches = []
    for played in (render_force(swinging), track):
        plant = Plant(PlantKinematics(PlantGeometry()), Mechanism(), YIELDING)
        reach_m = 0.0
        for force in played.at(np.arange(0.0, 9.0, 0.001)).tolist():
            plant.advance((force[0], force[1], force[2]), 0.001)
            reach_m = max(reach_m, float(np.linalg.norm(plant.position_m)))
        reaches.append(reach_m)
    assert reaches[0] > 0.035
    # the full physics has other masses away from the centre: within 1 mm
    assert reaches[1] < 0.023


def test_equal_brings_hands_the_force_that_they_share(swinging):
    shares = [render_preset(swinging, name=one.name).rms_n()[0] for one in PRESETS]
    assert shares[0] > shares[1] > shares[2]


def test_an_unknown_preset_is_refused_with_the_known(swinging):
    with pytest.raises(UsageError, match="faithful, balanced, equal"):
        render_preset(swinging, name="paper")
