import numpy as np
import pytest

from hapticplayer.capture.vision.egomotion import AHEAD, egomotion, rotation_alone

PX = 1 / 190.0


def matched(rotation_rad, travel_m, count=150, seed=3) -> tuple[np.ndarray, np.ndarray]:
    """Points at 3 to 40 m, before and after the camera has moved."""
    rng = np.random.default_rng(seed)
    before = rng.uniform((-0.8, -0.45), (0.8, 0.45), (count, 2))
    distance = rng.uniform(3.0, 40.0, (count, 1))
    points = distance * np.column_stack([before, np.ones(count)])
    half = np.linalg.norm(rotation_rad) / 2
    axis = np.array(rotation_rad) / (2 * half)
    x, y, z = np.sin(half) * axis
    w = np.cos(half)
    matrix = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    seen = (points - np.array(travel_m)) @ matrix
    return before, seen[:, :2] / seen[:, 2:]


@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("travel_m", [(0, 0, 0.3), (0.05, -0.02, 0.2), (0, 0, 0)])
def test_rotation_is_found_whatever_the_distances(axis, travel_m) -> None:
    rotation = 0.03 * np.eye(3)[axis] + 0.002
    before, after = matched(rotation, travel_m)

    travel = AHEAD
    for _ in range(60):  # two seconds in the same direction
        found = egomotion(before, after, travel, PX)
        travel = travel + 0.15 * (found.travel - travel)
        travel /= np.linalg.norm(travel)

    assert found.rotation_rad == pytest.approx(rotation, abs=5e-4)


def test_rotation_alone_confounds_what_egomotion_tells_apart() -> None:
    rotation = np.array([0.001, 0.002, -0.001])
    before, after = matched(rotation, (0.2, 0.0, 0.4))
    middle, flow = (before + after) / 2, after - before
    travel = np.array([0.45, 0.0, 0.89])

    both = egomotion(before, after, travel, PX).rotation_rad
    alone = rotation_alone(middle, flow, PX)

    assert np.abs(both - rotation).max() < 0.1 * np.abs(alone - rotation).max()


def test_a_third_of_wrong_matches_changes_little() -> None:
    rotation = np.array([0.01, -0.02, 0.005])
    before, after = matched(rotation, (0.0, 0.0, 0.3))
    rng = np.random.default_rng(5)
    after[:50] += rng.uniform(-0.2, 0.2, (50, 2))

    found = egomotion(before, after, AHEAD, PX)

    assert found.rotation_rad == pytest.approx(rotation, abs=5e-4)
    assert found.is_inlier[50:].mean() > 0.95
    assert found.is_inlier[:50].mean() < 0.3
