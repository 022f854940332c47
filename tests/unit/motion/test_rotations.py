"""Rotations as pairs of complex numbers, against scipy and extended precision."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.motion import rotations as rot

# numpy's extended type has 64 bits of mantissa here; where it has no more than
# float64, half of the reference's digits are missing
EXTENDED = pytest.mark.skipif(
    np.finfo(np.longdouble).eps > 1e-18, reason="needs an extended floating type"
)


def pair_of(rotation):
    """Return scipy's rotations as pairs."""
    w, x, y, z = np.moveaxis(rotation.as_quat(scalar_first=True), -1, 0)
    return w + 1j * x, y + 1j * z


def scipy_of(pair):
    """Return pairs (n,) as scipy's rotations."""
    return Rotation.from_quat(rot.to_wxyz(pair), scalar_first=True)


def some(count, seed=1):
    return Rotation.random(count, rng=np.random.default_rng(seed))


def directions(rng, count):
    """Return (3, count) unit vectors without a component near zero."""
    sides = np.where(rng.random((3, count)) < 0.5, -1.0, 1.0)
    vectors = sides * rng.uniform(0.3, 1.0, (3, count))
    return vectors / np.linalg.norm(vectors, axis=0)


def extended_exponential(turn_rad):
    """Return (4, ...) w, x, y, z in extended precision."""
    turn = turn_rad.astype(np.longdouble)
    angle = np.sqrt((turn * turn).sum(axis=0))
    by = np.sin(angle / 2) / np.where(angle > 0, angle, 1)
    return np.concatenate([np.cos(angle / 2)[None], by * turn])


def relative_error(pair, reference):
    got = np.moveaxis(rot.to_wxyz(pair), -1, 0)
    return np.abs((got - reference) / reference).max()


def test_the_product_is_that_of_quaternions():
    left, right = some(200, 1), some(200, 2)
    got = rot.to_wxyz(rot.multiply(pair_of(left), pair_of(right)))
    expected = (left * right).as_quat(scalar_first=True)
    # scipy may return the other sign of the same rotation
    expected *= np.sign(np.sum(got * expected, axis=1))[:, None]
    assert np.allclose(got, expected, rtol=0.0, atol=1e-15)


def test_the_units_multiply_as_hamilton_wrote_them():
    numbers = {"1": (1.0, 0.0), "i": (1j, 0.0), "j": (0.0, 1.0), "k": (0.0, 1j)}
    one, i, j, k = (
        tuple(np.array([part], complex) for part in pair) for pair in numbers.values()
    )

    def wxyz(pair):
        return rot.to_wxyz(pair)[0].tolist()

    assert wxyz(rot.multiply(i, j)) == wxyz(k) == [0.0, 0.0, 0.0, 1.0]
    assert wxyz(rot.multiply(j, k)) == wxyz(i)
    assert wxyz(rot.multiply(k, i)) == wxyz(j)
    assert wxyz(rot.multiply(j, i)) == [0.0, 0.0, 0.0, -1.0]
    assert wxyz(rot.multiply(one, j)) == wxyz(j)


@EXTENDED
@pytest.mark.parametrize(
    "angle_rad", [1e-12, 1e-8, 1e-4, 0.01, 0.15, 0.25, 0.5, 0.7, 0.72, 1.0, 2.0, 4.0]
)
def test_the_exponential_is_exact_at_every_angle(angle_rad, rng):
    # one call per size: which branch is taken depends on the largest angle
    turn = angle_rad * rng.uniform(0.5, 1.0, 300) * directions(rng, 300)
    reference = extended_exponential(turn)
    # a component near zero has no relative error worth the name
    keep = np.abs(reference).min(axis=0) > 0.05 * min(angle_rad, 1.0)
    assert keep.sum() > 100
    pair = rot.exponential(turn[:, keep])
    assert relative_error(pair, reference[:, keep]) < 1e-14


@EXTENDED
@pytest.mark.parametrize("switch_rad", [np.sqrt(0.04), np.sqrt(0.5)])
def test_the_exponential_does_not_jump_where_its_branches_meet(switch_rad, rng):
    axes = directions(rng, 200)
    for scale in (1.0 - 1e-12, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.0 + 1e-12):
        turn = scale * switch_rad * axes
        error = np.moveaxis(
            rot.to_wxyz(rot.exponential(turn)), -1, 0
        ) - extended_exponential(turn)
        assert np.abs(error).max() < 3e-16


def test_the_size_of_neighbours_does_not_change_a_rotation(rng):
    small = 0.01 * directions(rng, 50)
    large = np.concatenate([small, 3.0 * directions(rng, 1)], axis=1)
    alone, beside = rot.exponential(small), rot.exponential(large)
    for one, other in zip(alone, beside, strict=True):
        assert np.allclose(one, other[:50], rtol=0.0, atol=2e-16)


def test_no_turn_is_the_identity_exactly():
    first, second = rot.exponential(np.zeros((3, 4)))
    assert (first == 1.0).all()
    assert (second == 0.0).all()
    # beside a large one as well, where the other branch is taken
    turn = np.zeros((3, 2))
    turn[0, 1] = 3.0
    first, second = rot.exponential(turn)
    assert first[0] == 1.0
    assert second[0] == 0.0


@pytest.mark.parametrize("shape", [(3, 0), (3, 1), (3, 2, 0), (3, 4, 5)])
def test_the_exponential_keeps_the_shape(shape, rng):
    turn = rng.standard_normal(shape)
    first, second = rot.exponential(turn)
    assert first.shape == second.shape == shape[1:]
    vectors = np.moveaxis(turn, 0, -1).reshape(-1, 3)
    pair = first.reshape(-1), second.reshape(-1)
    if len(vectors):
        turned = Rotation.from_rotvec(vectors).inv() * scipy_of(pair)
        assert turned.magnitude().max() < 1e-14


@EXTENDED
def test_half_the_sinc_is_exact_over_its_range(rng):
    for top in (1e-20, 1e-6, 0.0399, 0.0401, 0.4999):
        squared = rng.uniform(0.01, 1.0, 500) * top
        angle = np.sqrt(squared.astype(np.longdouble))
        reference = np.sin(angle / 2) / angle
        assert np.abs(rot.half_sinc(squared) / reference - 1).max() < 3e-16


@pytest.mark.parametrize("count", [0, 1, 2, 3, 4, 5, 7, 8, 9, 63, 64, 65, 1000])
def test_the_running_product_is_that_of_a_plain_loop(count):
    steps = some(max(count, 1))[:count]
    pair = pair_of(steps) if count else (np.zeros(0, complex), np.zeros(0, complex))
    untouched = pair[0].copy(), pair[1].copy()
    got = rot.cumulative(pair)
    assert [len(part) for part in got] == [count, count]
    total = Rotation.identity()
    for k in range(count):
        total = total * steps[k]
        found = scipy_of((got[0][k : k + 1], got[1][k : k + 1]))
        assert (total.inv() * found).magnitude().max() < 1e-13
    assert all(np.array_equal(a, b) for a, b in zip(pair, untouched, strict=True))


def test_the_running_product_stays_exact_for_hours():
    # 0.003 rad a sample about one axis: after k samples it is one turn by k times it
    count = 2_000_000
    turn = np.array([0.001, -0.002, 0.002])
    first, second = rot.exponential(turn[:, None])
    steps = np.repeat(first, count), np.repeat(second, count)
    at = np.array([9, 99_999, count - 1])
    first, second = rot.cumulative(steps)
    found = scipy_of(rot.unit((first[at], second[at])))
    exact = Rotation.from_rotvec((at + 1)[:, None] * turn)
    # rounding adds up like a random walk over log2(n) levels, not over n samples
    assert (exact.inv() * found).magnitude().max() < 1e-9
    norm = np.abs(first[at]) ** 2 + np.abs(second[at]) ** 2
    assert np.abs(norm - 1.0).max() < 1e-9


def test_the_product_before_a_step_begins_with_none():
    steps = some(5)
    got = scipy_of(rot.before(rot.cumulative(pair_of(steps))))
    assert got[0].magnitude() == 0.0
    expected = steps[0] * steps[1] * steps[2] * steps[3]
    assert (expected.inv() * got[4]).magnitude() < 1e-14


def test_a_rotation_and_its_inverse_cancel():
    pair = pair_of(some(100))
    first, second = rot.multiply(pair, rot.inverse(pair))
    assert np.allclose(first, 1.0, rtol=0.0, atol=1e-15)
    assert np.allclose(second, 0.0, rtol=0.0, atol=1e-15)


def test_any_length_becomes_a_unit_of_the_same_direction():
    pair = pair_of(some(100))
    scaled = 1e-5 * pair[0], 1e-5 * pair[1]
    for got, expected in zip(rot.unit(scaled), pair, strict=True):
        assert np.allclose(got, expected, rtol=0.0, atol=1e-15)


def test_vectors_turn_as_with_scipy(rng):
    rotations, vectors = some(200), rng.standard_normal((200, 3))
    got = rot.rotate(pair_of(rotations), vectors.T).T
    assert np.allclose(got, rotations.apply(vectors), rtol=0.0, atol=2e-15)


def test_matrices_are_those_of_scipy():
    rotations = some(200)
    got = np.moveaxis(rot.matrices(pair_of(rotations)), -1, 0)
    assert np.allclose(got, rotations.as_matrix(), rtol=0.0, atol=1e-15)


def test_the_vertical_is_earths_up_in_the_sensor_frame():
    rotations = some(200)
    got = rot.vertical(pair_of(rotations)).T
    expected = rotations.inv().apply([0.0, 0.0, 1.0])
    assert np.allclose(got, expected, rtol=0.0, atol=1e-15)


def test_arrays_of_more_axes_are_treated_element_by_element(rng):
    flat = pair_of(some(12))
    grid = flat[0].reshape(3, 4), flat[1].reshape(3, 4)
    vectors = rng.standard_normal((3, 12))
    for got, expected in (
        (rot.rotate(grid, vectors.reshape(3, 3, 4)), rot.rotate(flat, vectors)),
        (rot.matrices(grid), rot.matrices(flat)),
        (rot.vertical(grid), rot.vertical(flat)),
    ):
        assert np.array_equal(got.reshape(expected.shape), expected)


def test_products_of_vectors_are_those_of_numpy(rng):
    left, right = rng.standard_normal((2, 3, 50))
    assert np.allclose(rot.cross(left, right), np.cross(left.T, right.T).T, atol=1e-15)
    assert np.allclose(rot.dot(left, right), (left * right).sum(axis=0), atol=1e-15)
    squared = np.linalg.norm(left, axis=0) ** 2
    assert np.allclose(rot.squared_norm(left), squared, atol=1e-14)


def test_the_smallest_rotation_turns_by_the_angle_between(rng):
    start, end = directions(rng, 300), directions(rng, 300)
    near = (start * end).sum(axis=0) > -0.9  # nearly opposite ones have few digits
    start, end = start[:, near], end[:, near]
    turn = scipy_of(rot.shortest(start, end))
    assert np.allclose(turn.apply(start.T), end.T, rtol=0.0, atol=1e-14)
    angle = np.arctan2(
        np.linalg.norm(np.cross(start.T, end.T), axis=1), (start * end).sum(axis=0)
    )
    assert np.allclose(turn.magnitude(), angle, rtol=0.0, atol=1e-12)


def test_the_same_direction_needs_no_rotation(rng):
    start = directions(rng, 50)
    # a unit vector's norm is rounded, and so is the cosine
    assert scipy_of(rot.shortest(start, start)).magnitude().max() < 1e-15


def test_opposite_directions_are_half_a_turn_apart():
    start = np.concatenate([np.eye(3), -np.eye(3), np.ones((3, 1)) / np.sqrt(3)], 1)
    turn = scipy_of(rot.shortest(start, -start))
    assert np.allclose(turn.apply(start.T), -start.T, rtol=0.0, atol=1e-15)
    assert np.allclose(turn.magnitude(), np.pi, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("missing_rad", [1e-12, 1e-6, 3e-5, 4.4e-5, 4.6e-5, 1e-4, 1e-2])
def test_nearly_opposite_directions_miss_by_their_defect(missing_rad, rng):
    start = directions(rng, 100)
    across = np.cross(start.T, directions(rng, 100).T).T
    across /= np.linalg.norm(across, axis=0)
    end = -np.cos(missing_rad) * start + np.sin(missing_rad) * across
    turn = scipy_of(rot.shortest(start, end))
    miss = np.linalg.norm(turn.apply(start.T) - end.T, axis=1)
    # closer than 4.5e-5 rad to half a turn the axis is lost, which costs as much;
    # above, 1 + cosine has few digits
    assert miss.max() < max(1e-6, min(1.01 * missing_rad, 4.5e-5))


def test_one_goal_serves_many_directions(rng):
    start, goal = directions(rng, 20), np.array([[0.0], [0.0], [1.0]])
    turn = scipy_of(rot.shortest(start, goal))
    assert np.allclose(turn.apply(start.T), goal.T, rtol=0.0, atol=1e-14)
