"""Mountings are rotations, and gravity excludes some of them."""

import numpy as np
import pytest

from hapticplayer.capture.mounting import (
    MOUNTINGS,
    all_mountings,
    axes_matrix,
    mean_up,
    mounted,
    proposed_mounting,
    up_in_frame_a,
)
from hapticplayer.model import ImuLog


def test_there_are_24_rotations_each_once():
    matrices = [axes_matrix(axes) for axes in all_mountings()]
    assert len({matrix.tobytes() for matrix in matrices}) == 24
    for matrix in matrices:
        np.testing.assert_array_equal(matrix @ matrix.T, np.eye(3))
        assert np.linalg.det(matrix) == pytest.approx(1.0)


def lying(up: tuple[float, float, float], rng) -> ImuLog:
    force = 9.81 * np.array(up) + 0.1 * rng.standard_normal((500, 3))
    return ImuLog(np.arange(500) / 100.0, force, np.zeros((500, 3)))


@pytest.mark.parametrize("name", MOUNTINGS)
def test_gravity_goes_up_once_a_mounting_is_applied(name):
    axes = MOUNTINGS[name].axes
    up = tuple(axes_matrix(axes)[2])  # of the actor, in the recorder's axes
    imu = lying(up, np.random.default_rng(1))
    found = mean_up(imu)
    np.testing.assert_allclose(found, up, atol=0.01)
    assert up_in_frame_a(found, axes)[2] == pytest.approx(1.0, abs=1e-3)
    assert up_in_frame_a(found, proposed_mounting(found))[2] > 0.99
    turned = mounted(imu, axes)
    np.testing.assert_allclose(
        turned.specific_force_mps2.mean(axis=0), (0, 0, 9.81), atol=0.02
    )
    sizes = [np.linalg.norm(one.specific_force_mps2, axis=1) for one in (imu, turned)]
    np.testing.assert_allclose(*sizes)


def test_a_camera_that_looks_to_the_right_sees_the_right():
    """Its y is the actor's right; its x, to its own right, is the actor's back."""
    push = np.array([[0.0, 1.0, 0.0]])  # along where it looks
    axes = axes_matrix(MOUNTINGS["to-the-right"].axes)
    assert (axes @ push[0]).tolist() == [1.0, 0.0, 0.0]
    back = axes @ [1.0, 0.0, 0.0]
    assert back.tolist() == [0.0, -1.0, 0.0]


def test_a_recorder_that_tumbles_has_no_up():
    rng = np.random.default_rng(2)
    force = rng.standard_normal((500, 3))
    force *= 9.81 / np.linalg.norm(force, axis=1)[:, None]
    imu = ImuLog(np.arange(500) / 100.0, force, np.zeros((500, 3)))
    assert mean_up(imu) is None
    assert proposed_mounting(None) == "x,y,z"
