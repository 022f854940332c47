"""A mechanism without dry friction, whose motion has closed forms."""

from dataclasses import replace

import pytest

from hapticplayer.devices.simulated import Geometry, Mechanism
from hapticplayer.devices.simulated.kinematics import Kinematics


@pytest.fixture(scope="session")
def kinematics():
    return Kinematics(Geometry())


@pytest.fixture(scope="session")
def frictionless():
    return replace(Mechanism(), viscous_nm_s=0.0, coulomb_nm=0.0)
