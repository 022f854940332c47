"""A mechanism without dry friction, whose motion has closed forms."""

from dataclasses import replace

import pytest

from hapticplayer.devices.dynamics import Mechanism
from hapticplayer.simulation.falcon.kinematics import Kinematics
from hapticplayer.simulation.falcon.parameters import Geometry


@pytest.fixture(scope="session")
def kinematics():
    return Kinematics(Geometry())


@pytest.fixture(scope="session")
def frictionless():
    return replace(Mechanism(), viscous_nm_s=0.0, coulomb_nm=0.0)
