"""The legs against reference rows, finite differences and their own inverse."""

import json

import numpy as np
import pytest

from hapticplayer.devices.dynamics import Mechanism
from hapticplayer.simulation.falcon.kinematics import PlantKinematics, solve
from hapticplayer.simulation.falcon.parameters import PlantGeometry


def points(rng, count, radius_m):
    vectors = rng.standard_normal((count, 3))
    vectors /= np.linalg.norm(vectors, axis=1)[:, None]
    return radius_m * np.cbrt(rng.random((count, 1))) * vectors


def test_angles_and_jacobian_agree_with_the_reference_rows(kinematics, shared_data):
    rows = json.loads((shared_data / "falcon" / "golden.json").read_text())
    for row in rows["kinematics"]:
        position = np.array(row["p"]) - [0.0, 0.0, PlantGeometry().centre_z_m]
        pose = kinematics.inverse(tuple(position))
        np.testing.assert_allclose(pose.theta_rad, row["theta"], atol=1e-13)
        np.testing.assert_allclose(np.linalg.inv(pose.rates), row["J"], atol=1e-14)
        counts = (np.array(pose.theta_rad) - PlantGeometry().theta0_rad) / (
            PlantGeometry().count_rad
        )
        np.testing.assert_allclose(counts, row["counts"], atol=1e-9)


def test_rates_are_the_derivatives_of_the_angles(kinematics, rng):
    step_m = 1e-6
    for point in points(rng, 50, 0.05):
        found = np.array(kinematics.inverse(tuple(point)).rates)
        for axis, move in enumerate(step_m * np.eye(3)):
            ahead = kinematics.inverse(tuple(point + move)).theta_rad
            behind = kinematics.inverse(tuple(point - move)).theta_rad
            slope = (np.array(ahead) - behind) / (2 * step_m)
            np.testing.assert_allclose(found[:, axis], slope, rtol=1e-5, atol=1e-5)


def test_forward_undoes_inverse_in_the_whole_workspace(kinematics, rng):
    for point in points(rng, 500, 0.05):
        theta = kinematics.inverse(tuple(point)).theta_rad
        found = kinematics.forward(theta, tuple(point + rng.uniform(-2e-3, 2e-3, 3)))
        np.testing.assert_allclose(found, point, atol=1e-11)


def test_a_position_out_of_reach_is_refused(kinematics):
    with pytest.raises(ValueError, match="math domain"):
        kinematics.inverse((0.0, 0.0, 0.08))


def test_three_equations_are_solved(rng):
    matrix, right = rng.standard_normal((3, 3)), rng.standard_normal(3)
    found = solve(tuple(map(tuple, matrix)), tuple(right))
    np.testing.assert_allclose(found, np.linalg.solve(matrix, right), rtol=1e-12)


@pytest.mark.parametrize("mass_kg", [0.05, 0.13, 0.3])
def test_a_mass_that_is_asked_for_is_felt_in_the_centre(mass_kg):
    inertia = Mechanism().with_lateral_mass(mass_kg).joint_inertia_kg_m2
    rates = np.array(PlantKinematics(PlantGeometry()).inverse((0.0, 0.0, 0.0)).rates)
    felt = inertia * rates.T @ rates
    assert felt[0, 0] == pytest.approx(mass_kg, rel=1e-3)
    assert felt[2, 2] / felt[0, 0] == pytest.approx(2.83, rel=0.01)
