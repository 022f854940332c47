"""A mechanism without dry friction, whose motion has closed forms."""

from dataclasses import replace

import pytest

from hapticplayer.devices.dynamics import Mechanism
from hapticplayer.simulation.falcon.kinematics import PlantKinematics
from hapticplayer.simulation.falcon.parameters import PlantGeometry


@pytest.fixture(scope="session")
def kinematics():
    return PlantKinematics(PlantGeometry())


@pytest.fixture(scope="session")
def frictionless():
    return replace(Mechanism(), viscous_nm_s=0.0, coulomb_nm=0.0)
