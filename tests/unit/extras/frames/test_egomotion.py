import numpy as np
import pytest

from hapticplayer.extras.frames.egomotion import AHEAD, egomotion, rotation_alone

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


@pytest.mark.parametrize("swing_m", [0.0, 0.06])
def test_a_swing_of_the_travel_is_not_taken_for_rotation(swing_m) -> None:
    phase = 2 * np.pi * np.arange(60) / 16.0  # 1.9 steps a second
    rng = np.random.default_rng(8)
    travel, errors = AHEAD, []
    for at in phase:  # heaving while the camera pitches, a quarter of a period apart
        rotation = np.array([0.008 * np.sin(at), 1e-4, 1e-4])
        moved = (0.0, swing_m * np.cos(at), 0.2)
        before, after = matched(rotation, moved, seed=rng.integers(1000))
        found = egomotion(
            before, after + 0.1 * PX * rng.normal(size=(150, 2)), travel, PX
        )
        travel = travel + 0.15 * (found.travel - travel)
        travel /= np.linalg.norm(travel)
        errors.append(found.rotation_rad[0] - rotation[0])

    # what is in phase with the heave shifts the rotation in time
    in_phase = 2 * np.mean(errors * np.cos(phase))
    assert abs(in_phase) < 2e-4  # 2.6e-3 where the travel is held
    assert np.std(errors) < 2e-4


def test_without_travel_it_is_as_good_as_rotation_alone() -> None:
    rotation = np.array([0.01, -0.02, 0.005])
    rng = np.random.default_rng(2)
    errors = []
    for seed in range(30):
        before, after = matched(rotation, (0.0, 0.0, 0.0), seed=seed)
        after = after + 0.2 * PX * rng.normal(size=after.shape)
        alone = rotation_alone((before + after) / 2, after - before, PX)
        both = egomotion(before, after, AHEAD, PX).rotation_rad
        errors.append([alone - rotation, both - rotation])

    alone_rad, both_rad = np.std(errors, axis=0)
    assert (both_rad < 1.5 * alone_rad).all()
