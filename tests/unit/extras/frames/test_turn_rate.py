"""The curves that a person lines up show the same turns at the same time."""

import numpy as np
import pytest

from hapticplayer.capture.frames import FrameRotation
from hapticplayer.extras.frames.turn_rate import turn_rate_of_frames, turn_rate_of_gyro
from hapticplayer.model import ImuLog

OFFSET_S = 2.4  # media time at which the log's clock reads zero
BUMPS_S = (4.0, 9.0, 13.0)


def angle(time_s: np.ndarray, size_rad: float = 0.1) -> np.ndarray:
    """Turns to and fro about z, rad."""
    bumps = [np.exp(-0.5 * ((time_s - at_s) / 0.2) ** 2) for at_s in BUMPS_S]
    return size_rad * np.sum(bumps, axis=0)


@pytest.fixture
def frames() -> FrameRotation:
    edges_s = np.arange(0.0, 16.0, 1 / 30)
    turned = np.zeros((len(edges_s) - 1, 3))
    turned[:, 2] = np.diff(angle(edges_s))
    ones, none = np.ones(len(turned)), np.zeros_like(turned)
    return FrameRotation(edges_s[:-1], edges_s[1:], turned, ones, none, none)


@pytest.fixture
def imu() -> ImuLog:
    log_s = np.arange(-5.0, 20.0, 0.005)
    rate = np.zeros((len(log_s), 3))
    rate[:, 0] = np.gradient(angle(log_s + OFFSET_S), log_s) + 0.03  # and its bias
    return ImuLog(log_s, np.zeros_like(rate), rate)


def fastest_s(time_s: np.ndarray, rate: np.ndarray, near_s: float) -> float:
    """Return the middle of the two fastest moments of a bump."""
    inside = np.abs(time_s - near_s) < 1.0
    return float(np.average(time_s[inside], weights=rate[inside] ** 2))


def test_both_show_each_turn_when_it_was(frames, imu):
    log_s, felt = turn_rate_of_gyro(imu)
    media_s, seen = turn_rate_of_frames(frames)
    for at_s in BUMPS_S:
        assert fastest_s(media_s, seen, at_s) == pytest.approx(at_s, abs=0.01)
        assert fastest_s(log_s + OFFSET_S, felt, at_s) == pytest.approx(at_s, abs=0.01)


def test_both_show_the_same_rate_and_no_bias(frames, imu):
    largest = 0.1 / 0.2 * np.exp(-0.5)  # of the derivative of a Gaussian
    for _, rate in (turn_rate_of_gyro(imu), turn_rate_of_frames(frames)):
        assert rate.max() == pytest.approx(largest, rel=0.15)
        assert np.median(rate) < 0.02  # a bias of 0.03 is gone


def test_gaps_and_cuts_are_flat(frames, imu):
    frames.quality[100:110] = 0.0
    assert not turn_rate_of_frames(frames)[1][100:110].any()
    kept = np.abs(imu.time_s - 1.6) > 0.5
    gap = ImuLog(
        imu.time_s[kept], imu.specific_force_mps2[kept], imu.angular_rate_radps[kept]
    )
    log_s, rate = turn_rate_of_gyro(gap)
    assert not rate[np.abs(log_s - 1.6) < 0.45].any()


def test_a_single_key_frame_is_bridged(frames):
    _, whole = turn_rate_of_frames(frames)
    at = int(np.argmax(whole))
    frames.quality[at] = 0.0
    frames.rotation_rad[at] = 0.0

    assert turn_rate_of_frames(frames)[1][at] == pytest.approx(whole[at], rel=0.1)
