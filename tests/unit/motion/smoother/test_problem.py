"""Sums over what is near a node against loops over all nodes."""

import numpy as np
import pytest

from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother import problem, strapdown
from hapticplayer.motion.smoother.nodes import gather, rough_vertical
from tests.unit.motion.smoother.conftest import samples_of

HALF_WIDTH_S = 2.0


def rough(force_mps2, step_s):
    """Return the rough verticals of a sensor that does not turn, and its nodes' times."""
    samples = samples_of(step_s, force_mps2, np.zeros_like(force_mps2), averaged=False)
    windows = strapdown.integrate(samples, 4, np.zeros(3), np.zeros((3, 3)))
    nodes = gather(windows, 5, with_matrix=False)
    time_s = np.append(0.0, np.cumsum(nodes.duration_s))
    return rough_vertical(nodes, HALF_WIDTH_S), time_s


@pytest.mark.parametrize("count", [7, 20, 213, 400])
def test_the_rough_vertical_is_that_of_the_mean_force_around(count, rng):
    step_s = rng.uniform(0.01, 0.09, count)
    force = np.array([0.0, 3.0, 9.0]) + rng.standard_normal((count, 3))
    found, time_s = rough(force, step_s)
    ends = np.append(np.arange(0, count, 20), count)
    assert found.shape == (3, len(ends))
    for at, vertical in zip(time_s, found.T, strict=True):
        near = [
            (force[a:b] * step_s[a:b, None]).sum(axis=0)
            for a, b, begin, end in zip(
                ends[:-1], ends[1:], time_s[:-1], time_s[1:], strict=True
            )
            if begin >= at - HALF_WIDTH_S and end <= at + HALF_WIDTH_S
        ]
        total = np.sum(near, axis=0)
        assert vertical == pytest.approx(total / np.linalg.norm(total), abs=1e-12)


def test_without_specific_force_the_vertical_is_the_neighbours():
    force = np.zeros((600, 3))
    force[200:220] = 0.0, 0.0, 9.0
    force[400:420] = 0.0, -9.0, 0.0
    found, time_s = rough(force, np.full(600, 0.04))
    is_second = time_s >= 16.0 - HALF_WIDTH_S + 0.8 - 1e-9
    expected = np.where(is_second, [[0.0], [-1.0], [0.0]], [[0.0], [0.0], [1.0]])
    assert found == pytest.approx(expected, abs=1e-12)


def test_where_nothing_pulls_at_all_up_is_z():
    found, _ = rough(np.zeros((100, 3)), np.full(100, 0.04))
    assert np.array_equal(found, np.tile([[0.0], [0.0], [1.0]], found.shape[1]))


@pytest.mark.parametrize("intervals", [1, 2, 50])
def test_a_mean_square_counts_each_node_by_the_time_around_it(intervals, rng):
    duration_s = rng.uniform(0.2, 1.2, intervals)
    states = rng.standard_normal((intervals + 1, 4))
    # as a solution keeps them: not contiguous
    found = problem.mean_square(states.T[2:], duration_s, HALF_WIDTH_S)
    time_s = np.append(0.0, np.cumsum(duration_s))
    width_s = 0.5 * (np.append(0.0, duration_s) + np.append(duration_s, 0.0))
    squared = np.square(states[:, 2:]).sum(axis=1)
    for at, mean in zip(time_s, found, strict=True):
        near = np.abs(time_s - at) <= HALF_WIDTH_S
        assert mean == pytest.approx(np.average(squared[near], weights=width_s[near]))


@pytest.mark.parametrize("inverse", [False, True])
def test_vectors_are_turned_whatever_their_strides(inverse, rng):
    q = rng.standard_normal((30, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    vectors = rng.standard_normal((30, 3))
    w, x, y, z = q.T
    matrices = np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )
    expected = np.einsum("jin,nj->in" if inverse else "ijn,nj->in", matrices, vectors)
    rotation = w + 1j * x, y + 1j * z
    for given in (vectors.T, np.ascontiguousarray(vectors.T)):
        found = rot.rotate(rot.inverse(rotation) if inverse else rotation, given)
        assert found == pytest.approx(expected, abs=1e-12)
