"""The three pats that the simulator gives."""

import numpy as np
import pytest

from hapticplayer.extras.rides.pats import Tap, displacement, three_pats

FINE_HZ, FRAME_S = 6000, 1.0 / 30.0


def speed_mps(frequency_hz: float, peak_mps2: float) -> np.ndarray:
    """Speed along the blow, which comes at .1 s of 1.5 s."""
    time_s = np.arange(round(1.5 * FINE_HZ)) / FINE_HZ
    pat = Tap(0.1, peak_mps2, frequency_hz, 0.028, (0.0, 0.0, -1.0))
    return np.gradient(-displacement((pat,), time_s)[:, 2], time_s)


@pytest.mark.parametrize("frequency_hz", range(22, 40, 2))
def test_no_pat_is_lost_in_the_means_of_a_frame(frequency_hz: int) -> None:
    """However it falls on the windows, one of the first three sees it."""
    speed, frame = speed_mps(frequency_hz, 14.0), round(FRAME_S * FINE_HZ)
    begin = round(0.1 * FINE_HZ)
    for phase in range(0, frame, 5):
        edges = begin - phase + frame * np.arange(4)
        means_mps2 = np.diff(speed[edges]) / FRAME_S
        assert np.abs(means_mps2).max() > 0.4  # its noise is .04


def test_a_pushed_camera_comes_back_from_some_millimetres() -> None:
    time_s = np.arange(3 * FINE_HZ) / FINE_HZ
    for seed in range(20):
        pats = three_pats(np.random.default_rng(seed), 0.2)
        moved_m = np.linalg.norm(displacement(pats, time_s), axis=1)
        assert 0.001 < moved_m.max() < 0.01
        assert moved_m[-1] < 1e-5


def test_the_first_push_goes_the_way_of_the_blow() -> None:
    speed = speed_mps(30.0, 20.0)
    first = speed[np.abs(speed) > 0.02][0]
    assert first > 0.0
    assert speed.max() > -2.0 * speed.min()
