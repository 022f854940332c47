import numpy as np

from hapticplayer.extras.frames.carrier import Carrier
from hapticplayer.extras.frames.features import CELL_PX, Matches

WIDTH_PX, HEIGHT_PX = 320, 180
HORIZON = slice(0, 20)
DASHBOARD = slice(20, 40)
ROAD = slice(40, 60)


def learned(turn_px: float, frames: int = 300) -> np.ndarray:
    """Let far things turn, a dashboard stay and a road stream; 20 features each."""
    carrier = Carrier(WIDTH_PX, HEIGHT_PX)
    rng = np.random.default_rng(2)
    column = np.tile(np.arange(20) * CELL_PX + 8.0, 3)
    row = np.repeat([72.0, 168.0, 120.0], 20)
    before = np.column_stack([column, row])
    matches = Matches(before, before)
    for number in range(frames):
        turned = np.zeros((60, 2))
        turned[:, 0] = turn_px * np.sin(0.2 * number)
        flow = turned + rng.normal(0.0, 0.1, (60, 2))
        flow[DASHBOARD] -= turned[DASHBOARD]
        flow[ROAD, 1] += 6.0
        matches = Matches(before, before + flow)
        carrier.learn(matches, turned)
    return carrier.holds(matches)


def test_a_dashboard_is_told_from_the_horizon() -> None:
    held = learned(turn_px=0.5)

    assert held[DASHBOARD].all()
    assert not held[HORIZON].any()
    assert not held[ROAD].any()


def test_a_camera_that_does_not_turn_teaches_no_carrier() -> None:
    assert not learned(turn_px=0.02).any()
