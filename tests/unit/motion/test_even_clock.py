"""Stamps that jitter about an even clock, and those that only look like it."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.motion import analyse
from hapticplayer.motion.even_clock import even_clock
from tools.optical import read_optical

INTERVAL_S = 1.0 / 30.0
EVEN_S = 1.7e3 + INTERVAL_S * np.arange(2000)


def sensed(true_s, stamp_s, seed=1):
    """Stamps, and closed forms at the times when the samples were really taken."""
    rng = np.random.default_rng(seed)
    t = true_s[:, None]
    force = [0.0, 0.0, 9.8] + 2.0 * np.sin(t * [5.0, 7.0, 11.0])
    rate = np.cos(t * [3.0, 6.0, 4.0])
    force = force + rng.normal(0.0, 0.02, force.shape)
    return stamp_s, force, rate + rng.normal(0.0, 0.002, rate.shape)


def jittered(time_s, rng, share=0.2):
    return time_s + share * INTERVAL_S * rng.uniform(-1.0, 1.0, len(time_s))


@pytest.mark.parametrize("share", [0.1, 0.2, 0.4])
@pytest.mark.parametrize("drift_ppm", [0.0, 500.0])
def test_jitter_is_taken_off_and_the_mean_stays(rng, drift_ppm, share):
    """A line through 257 stamps leaves 4 % of their sigma inside, 8 % at the ends."""
    drift_s = 0.5e-6 * drift_ppm * np.square(EVEN_S - EVEN_S[0]) / np.ptp(EVEN_S)
    true_s = EVEN_S + drift_s
    found_s = even_clock(*sensed(true_s, jittered(true_s, rng, share)))
    assert found_s is not None
    assert np.abs(found_s - true_s).max() < 0.25 * share * INTERVAL_S
    assert abs(np.mean(found_s - true_s)) < 0.01 * INTERVAL_S


def dropped(rng):
    """Every tenth sample is missing, the stamps are right."""
    return np.sort(rng.choice(EVEN_S, 1800, replace=False))


def another_rate(_rng):
    steps = np.where(np.arange(2000) < 1000, 1.0, 1.1) * INTERVAL_S
    return np.cumsum(steps)


def wandering(rng):
    """Each step is late by its own, as in a loop that sleeps."""
    return np.cumsum(INTERVAL_S * (1.0 + 0.2 * rng.uniform(-1.0, 1.0, 2000)))


TRUE_TIMES = {
    "even": lambda _rng: EVEN_S,
    "a gap": lambda _rng: np.delete(EVEN_S, slice(900, 960)),
    "dropouts": dropped,
    "another rate": another_rate,
    "wandering": wandering,
    "uneven sampling": lambda rng: jittered(EVEN_S, rng),
    "a few samples": lambda _rng: EVEN_S[:20],
}


@pytest.mark.parametrize("name", TRUE_TIMES)
def test_true_times_stay_as_they_are(name, rng):
    true_s = TRUE_TIMES[name](rng)
    assert even_clock(*sensed(true_s, true_s)) is None


def test_gaps_between_jittered_pieces_stay(rng):
    true_s = np.delete(EVEN_S, slice(900, 960))
    found_s = even_clock(*sensed(true_s, jittered(true_s, rng)))
    assert np.abs(found_s - true_s).max() < 0.05 * INTERVAL_S
    assert found_s[900] - found_s[899] == pytest.approx(61 * INTERVAL_S, rel=2e-3)


def test_stamps_that_jump_beyond_half_an_interval_stay(rng):
    stamps_s = np.sort(jittered(EVEN_S, rng, 0.7))
    assert even_clock(*sensed(EVEN_S, stamps_s)) is None


def error_mps2(log, up, counted):
    miss = analyse(log).track.gravity_mps2 - STANDARD_GRAVITY_MPS2 * up
    return np.sqrt(np.mean(np.square(miss[counted]).sum(axis=1)))


def with_jitter(log, rng):
    step_s = np.median(np.diff(log.time_s))
    noise_s = 0.2 * step_s * rng.uniform(-1.0, 1.0, len(log))
    return replace(log, time_s=log.time_s + noise_s)


def tumbling():
    """A minute of fast rotation and its true vertical, both closed forms."""
    t = INTERVAL_S * np.arange(1800)

    def attitude(at_s):
        angles = [1.2, 0.9, 1.5] * np.sin(at_s[:, None] * [2.0, 3.1, 1.7])
        return Rotation.from_euler("ZYX", angles)

    to_sensor = attitude(t).inv()
    rate = (attitude(t - INTERVAL_S).inv() * attitude(t)).as_rotvec() / INTERVAL_S
    acceleration = [1.5, 2.0, 1.0] * np.sin(t[:, None] * [5.0, 7.0, 11.0])
    up = np.array([0.0, 0.0, 1.0])
    force = to_sensor.apply(acceleration + STANDARD_GRAVITY_MPS2 * up)
    return ImuLog(t, force, rate), to_sensor.apply(up)


def test_jitter_costs_nothing_and_the_summary_says_so(rng):
    """Integrated over the jittered stamps the error is more than ten times as large."""
    log, up = tumbling()
    everywhere = np.ones(len(log), dtype=bool)
    noisy = with_jitter(log, rng)
    done = analyse(noisy)
    assert np.array_equal(done.track.time_s, noisy.time_s)
    assert "jitter by 12 % of an interval" in done.summary["clock"]
    assert analyse(log).summary["clock"] is None
    best = error_mps2(log, up, everywhere)
    assert error_mps2(noisy, up, everywhere) < 1.1 * best


@pytest.mark.parametrize("rate", ["averaged_30hz", "native"])
@pytest.mark.parametrize("family", ["broad_07", "tumvi_room4", "tyrex*Swinging"])
def test_jitter_costs_nothing_on_real_recordings(shared_data, rng, family, rate):
    (path,) = (shared_data / "orientation" / rate).glob(f"{family}*.npz")
    held = read_optical(path)
    best = error_mps2(held.log, held.up, held.counted)
    noisy = with_jitter(held.log, rng)
    assert error_mps2(noisy, held.up, held.counted) < 1.1 * best
    given = held.log.specific_force_mps2, held.log.angular_rate_radps
    assert even_clock(held.log.time_s, *given) is None
