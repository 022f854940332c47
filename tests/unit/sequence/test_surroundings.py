"""What the motion of a clip is estimated from: the log, or minutes of a long one."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.motion import SmootherParameters, analyse
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.build import write_sequence
from hapticplayer.sequence.processing import Processing, process_motion
from hapticplayer.sequence.surroundings import MARGIN_S, surroundings

RATE_HZ = 20.0
BIAS_RADPS = np.array([0.05, -0.03, 0.06])


def long_log(hours: float, still_s: float = 0.0) -> ImuLog:
    """Return a log of a shaken sensor that begins still."""
    time_s = np.arange(0.0, 3600.0 * hours, 1.0 / RATE_HZ)
    moves = (time_s >= still_s)[:, None]
    phases = np.outer(time_s, [1.7, 2.3, 3.1])
    force = np.tile([0.0, 0.0, STANDARD_GRAVITY_MPS2], (len(time_s), 1))
    return ImuLog(
        time_s,
        force + moves * 2.0 * np.sin(phases),
        BIAS_RADPS + moves * 0.1 * np.cos(phases),
    )


def test_a_short_log_is_used_whole():
    log = long_log(0.1)
    assert surroundings(log, 100.0, 110.0) == (log, None)


def test_a_log_with_a_gap_there_is_used_whole():
    log, kept = long_log(1.0), 60.0
    ends = (log.time_s < kept) | (log.time_s > 3600.0 - kept)
    torn = ImuLog(
        log.time_s[ends], log.specific_force_mps2[ends], log.angular_rate_radps[ends]
    )
    assert surroundings(torn, 1800.0, 1810.0) == (torn, None)


def test_of_a_long_log_some_minutes_are_used():
    near, _ = surroundings(long_log(10.0), 18_000.0, 18_060.0)
    assert near.time_s[0] == pytest.approx(18_000.0 - MARGIN_S, abs=1.0 / RATE_HZ)
    assert near.time_s[-1] == pytest.approx(18_060.0 + MARGIN_S, abs=1.0 / RATE_HZ)


def test_stillness_that_is_left_out_tells_the_gyro_bias():
    _, known = surroundings(long_log(1.0, still_s=4.0), 1800.0, 1860.0)
    assert known.gyro_bias_radps == pytest.approx(tuple(BIAS_RADPS), abs=1e-9)
    # a random walk of 1e-4 rad/s a root of a second, twice as an estimate
    walk_radps = 2e-4 * np.sqrt(1800.0 - 4.0)
    assert known.gyro_bias_sigma_radps == pytest.approx((walk_radps,) * 3, rel=0.01)


@pytest.mark.parametrize("still_s", [0.0, 2.0])
def test_without_three_still_seconds_nothing_is_known(still_s):
    assert surroundings(long_log(1.0, still_s), 1800.0, 1860.0)[1] is None


def test_ten_seconds_of_a_log_are_estimated_on_all_of_it(swing):
    """The same gravity as of the whole, not that of ten seconds alone."""
    imu, _ = swing
    whole = process_motion(imu, Processing())
    part = whole.part(slice(3000, 5000))
    assert np.array_equal(part.track.gravity_mps2, whole.track.gravity_mps2[3000:5000])
    assert part.imu.time_s[0] == imu.time_s[3000]
    sigma = whole.track.gravity_sigma_mps2[3000:5000]
    assert part.summary["gravity_sigma_mps2"] == np.median(sigma)


def test_an_import_keeps_the_minutes_around_the_clip(tmp_path, tiny_clip, recording):
    log = long_log(1.0, still_s=4.0)
    placed = dataclasses.replace(
        recording, imu=log, clock_map=ClockMap(offset_s=-1800.0, rate=1.0)
    )
    sequence = open_sequence(write_sequence(tiny_clip, placed, tmp_path / "ride"))
    time_s = sequence.motion.time_s
    assert time_s[0] == pytest.approx(-MARGIN_S, abs=0.1)
    assert time_s[-1] == pytest.approx(tiny_clip.duration_s + MARGIN_S, abs=0.1)
    near, known = surroundings(log, 1800.0, 1800.0 + tiny_clip.duration_s)
    expected = analyse(near, parameters=SmootherParameters(calibration=known)).track
    assert np.array_equal(sequence.motion.gravity_mps2, expected.gravity_mps2)
