"""Quaternions against scipy's independent implementation and their own laws."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from hapticplayer.model import quaternions as quat

unit = st.integers(0, 2**32 - 1).map(
    lambda seed: quat.normalized(np.random.default_rng(seed).standard_normal((5, 4)))
)


def scipy_rotation(q):
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


@given(unit, unit)
@settings(max_examples=50)
def test_product_rotates_like_two_rotations(p, q):
    v = np.array([[0.3, -1.2, 2.0]])
    both = scipy_rotation(p) * scipy_rotation(q)
    assert np.allclose(quat.rotate(quat.multiply(p, q), v), both.apply(v), atol=1e-12)


@pytest.mark.parametrize("count", [1, 2, 3, 8, 100])
def test_chained_turns_are_products_one_after_the_other(count):
    rng = np.random.default_rng(count)
    turns = quat.normalized(rng.standard_normal((2, count, 4)))
    found = quat.chained(turns)
    for row in range(2):
        so_far = Rotation.identity()
        for k in range(count):
            so_far = so_far * scipy_rotation(turns[row, k])
            apart = so_far.inv() * scipy_rotation(found[row, k])
            assert apart.magnitude() < 1e-12


@given(unit)
@settings(max_examples=50)
def test_vertical_is_the_third_row_of_the_rotation_matrix(q):
    rows = scipy_rotation(q).as_matrix()[:, 2, :]
    assert np.allclose(quat.vertical(q), rows, atol=1e-12)


@given(unit)
@settings(max_examples=50)
def test_rotation_keeps_lengths(q):
    v = np.array([[3.0, -4.0, 12.0]])
    assert np.allclose(np.linalg.norm(quat.rotate(q, v), axis=1), 13.0, atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-3, 1.0, np.pi, 7.0])
def test_rotation_vector_agrees_with_scipy(angle):
    phi = angle * np.array([[0.6, 0.0, -0.8]])
    expected = Rotation.from_rotvec(phi).as_matrix()
    assert np.allclose(
        scipy_rotation(quat.from_rotation_vector(phi)).as_matrix(), expected, atol=1e-12
    )


def test_interpolation_follows_the_great_arc_across_sign_flips():
    time = np.arange(0, 1, 0.01)
    phi = np.outer(3.0 * time, [0.0, 0.6, 0.8])
    q = quat.from_rotation_vector(phi)
    q[40:] *= -1.0  # the same rotations
    query = time[:-1] + 0.005
    exact = quat.from_rotation_vector(np.outer(3.0 * query, [0.0, 0.6, 0.8]))
    found = quat.interpolate(query, time, q)
    angle = 2 * np.arccos(np.minimum(1.0, np.abs(np.sum(found * exact, axis=1))))
    assert angle.max() < 1e-6
