"""Where a recording stands still, against spans that were put there."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.model import ImuLog
from hapticplayer.motion import analyse
from hapticplayer.motion.stillness import (
    STILL_ACCEL_STD_LIMIT_MPS2,
    STILL_RATE_LIMIT_RADPS,
    STILL_RATE_STD_LIMIT_RADPS,
    estimate_accelerometer_gain,
    find_still,
)

UP = np.array([0.0, 0.6, 0.8])


def resting(
    count, rng, *, rate_hz=200.0, gain=1.0, force_std=0.02, rate_std=0.001, **more
):
    """Return a sensor at rest; the deviations are those of all three axes together."""
    noise = rng.standard_normal((2, count, 3)) / np.sqrt(3.0)
    return ImuLog(
        np.arange(count) / rate_hz,
        gain * G * UP + force_std * noise[0],
        rate_std * noise[1],
        **more,
    )


def shaken(log, moving, rng):
    """Return a log that is shaken where `moving`, far beyond what counts as rest."""
    shake = moving[:, None] * rng.standard_normal((2, len(log), 3))
    return dataclasses.replace(
        log,
        specific_force_mps2=log.specific_force_mps2 + 2.0 * shake[0],
        angular_rate_radps=log.angular_rate_radps + 0.5 * shake[1],
    )


def looped(log, per_bin):
    """Return which samples lie in a window of a second below all thresholds."""
    still = np.zeros(len(log), dtype=bool)
    width = round(log.rate_hz / per_bin) * per_bin
    for first in range(0, len(log) // per_bin * per_bin - width + 1, per_bin):
        part = slice(first, first + width)
        force, rate = log.specific_force_mps2[part], log.angular_rate_radps[part]
        still[part] |= bool(
            np.sqrt(force.var(axis=0).sum()) < STILL_ACCEL_STD_LIMIT_MPS2
            and np.sqrt(rate.var(axis=0).sum()) < STILL_RATE_STD_LIMIT_RADPS
            and np.linalg.norm(rate.mean(axis=0)) < STILL_RATE_LIMIT_RADPS
            and np.linalg.norm(force.mean(axis=0)) > 0.5 * G
        )
    return still


@pytest.mark.parametrize("rate_hz", [50.0, 100.0, 200.0, 1000.0])
def test_spans_of_rest_are_found_where_they_are(rate_hz, rng):
    count = round(20.0 * rate_hz)
    time_s = np.arange(count) / rate_hz
    moving = (time_s < 4.0) | ((time_s > 9.0) & (time_s < 15.0))
    log = shaken(resting(count, rng, rate_hz=rate_hz), moving, rng)
    spans = find_still(log)
    found = spans.mask(count)
    assert not (found & moving).any()
    # all but a bin of a quarter of a second at each end
    assert np.count_nonzero(found) / rate_hz > 10.0 - 4 * 0.27
    assert spans.still_s == pytest.approx(np.count_nonzero(found) / rate_hz)


def test_every_window_is_judged_as_in_a_plain_loop(rng):
    # noise whose size wanders about the thresholds
    count = 12_000
    steps = np.repeat(rng.uniform(-1.0, 1.0, (3, 30)), count // 30, axis=1)
    force_std = STILL_ACCEL_STD_LIMIT_MPS2 * 2.0 ** steps[0]
    rate_std = STILL_RATE_STD_LIMIT_RADPS * 2.0 ** steps[1]
    log = resting(count, rng, force_std=force_std[:, None], rate_std=rate_std[:, None])
    turning = STILL_RATE_LIMIT_RADPS * 2.0 ** (steps[2] - 0.7)
    rate = log.angular_rate_radps + np.outer(turning, [0.6, 0.0, 0.8])
    log = dataclasses.replace(log, angular_rate_radps=rate)
    found = find_still(log)
    assert 200 % found.per_bin == 0
    expected = looped(log, found.per_bin)
    assert 0.02 < expected.mean() < 0.98
    assert np.array_equal(found.mask(count), expected)


def test_bins_hold_the_means_of_their_samples(rng):
    log = shaken(resting(1010, rng), np.arange(1010) < 600, rng)
    spans = find_still(log)
    used = 1010 // spans.per_bin * spans.per_bin
    for name in ("specific_force_mps2", "angular_rate_radps"):
        expected = getattr(log, name)[:used].reshape(-1, spans.per_bin, 3).mean(axis=1)
        got = spans.force_mps2 if "force" in name else spans.rate_radps
        assert np.allclose(got, expected.T, rtol=0.0, atol=1e-13)


@pytest.mark.parametrize(
    ("changed", "is_still"),
    [
        ({"force_std": 0.19}, True),
        ({"force_std": 0.22}, False),
        ({"rate_std": 0.019}, True),
        ({"rate_std": 0.022}, False),
    ],
)
def test_more_noise_than_a_sensor_has_is_motion(changed, is_still, rng):
    # ten thousand samples know a deviation to 1 %
    spans = find_still(resting(10_000, rng, **changed))
    assert spans.bins.all() if is_still else spans.bins.mean() < 0.1


@pytest.mark.parametrize(("degrees_per_s", "is_still"), [(10.0, True), (12.0, False)])
def test_a_steady_turn_that_no_bias_explains_is_motion(degrees_per_s, is_still, rng):
    log = resting(2000, rng)
    rate = log.angular_rate_radps + np.radians(degrees_per_s) * UP
    log = dataclasses.replace(log, angular_rate_radps=rate)
    assert find_still(log).bins.all() == is_still
    assert find_still(log).bins.any() == is_still


def test_free_fall_is_no_rest(rng):
    log = resting(2000, rng)
    falling = dataclasses.replace(
        log, specific_force_mps2=log.specific_force_mps2 - G * UP
    )
    assert not find_still(falling).bins.any()


def test_a_hole_is_no_evidence_of_rest(rng):
    log = resting(2000, rng)
    late = log.time_s + np.where(np.arange(2000) >= 1000, 1.0, 0.0)
    spans = find_still(dataclasses.replace(log, time_s=late))
    assert spans.bins.all()  # each side is a still span of its own
    # but less than a second on both sides together is none
    short = resting(300, rng)
    late = short.time_s + np.where(np.arange(300) >= 150, 1.0, 0.0)
    assert not find_still(dataclasses.replace(short, time_s=late)).bins.any()


def test_filled_in_samples_are_not_rest(rng):
    valid = np.ones(2000, dtype=bool)
    valid[400:600] = False
    found = find_still(resting(2000, rng, valid=valid)).mask(2000)
    assert not (found & ~valid).any()
    # a second has to be whole, and a bin belongs to a second
    assert found[:350].all()
    assert found[650:].all()


@pytest.mark.parametrize("count", [2, 3, 7, 100, 199])
def test_less_than_a_second_is_too_short(count, rng):
    spans = find_still(resting(count, rng))
    assert not spans.mask(count).any()
    assert spans.still_s == 0.0


def test_samples_behind_the_last_bin_belong_to_none(rng):
    mask = find_still(resting(2010, rng)).mask(2010)
    assert mask[:2000].all()
    assert not mask[2000:].any()


# ---- gain -----------------------------------------------------------------------


@pytest.mark.parametrize("norm_mps2", [9.0, 9.8, 10.8])
def test_the_gain_brings_the_norm_at_rest_to_1_g(norm_mps2, rng):
    gain = estimate_accelerometer_gain(resting(2000, rng, gain=norm_mps2 / G))
    assert gain.gain == pytest.approx(G / norm_mps2, rel=2e-4)
    assert gain.still_s == pytest.approx(10.0)
    assert "10.0 s of still spans" in gain.reason


@pytest.mark.parametrize("gain", [0.6, 0.8, 1.3, 2.0])
def test_a_gain_that_no_sensor_has_is_not_believed(gain, rng):
    found = estimate_accelerometer_gain(resting(2000, rng, gain=gain))
    assert found.gain == 1.0
    assert found.still_s == 0.0
    assert f"{1 / gain:.3f}" in found.reason


def test_a_jolt_in_a_still_span_does_not_move_the_gain(rng):
    log = resting(20_000, rng, gain=1.05)
    # a slow push of 0.3 m/s^2, as by a floor that gives way: still by every measure
    push = np.zeros((20_000, 3))
    push[4000:8000] = 0.3 * UP
    pushed = dataclasses.replace(
        log, specific_force_mps2=log.specific_force_mps2 + push
    )
    gain = estimate_accelerometer_gain(pushed).gain
    assert gain == pytest.approx(1 / 1.05, rel=1e-3)


@pytest.mark.parametrize("rate_hz", [0.1, 0.5, 0.9, 1.0, 1.1, 2.0, 4.0, 8.0, 10.0])
def test_a_slow_log_has_a_gain_or_none_but_no_accident(rate_hz, rng):
    log = resting(200, rng, rate_hz=rate_hz, gain=1.04)
    gain = estimate_accelerometer_gain(log)
    assert gain.gain in (1.0, pytest.approx(1 / 1.04, rel=1e-3))
    assert (gain.still_s > 0.0) == (gain.gain != 1.0)
    assert (gain.gain == 1.0) == gain.reason.startswith("assumed")
    done = analyse(log)
    assert done.summary["accelerometer_gain"] == gain.gain


def test_a_log_that_moves_throughout_keeps_its_scale(swing):
    gain = estimate_accelerometer_gain(swing[0])
    assert gain.gain == 1.0
    assert "no still span" in gain.reason


@pytest.mark.parametrize("shaken_s", [[], [0, 4], [0, 3.2], [0.3, 1.6, 2.7, 3.9]])
def test_skipped_samples_in_motion_change_no_stillness(monkeypatch, shaken_s):
    rng = np.random.default_rng(5)
    log = resting(800, rng, rate_std=0.8 * STILL_RATE_STD_LIMIT_RADPS)
    moving = np.zeros(len(log), np.bool_)
    for first_s, last_s in zip(shaken_s[::2], shaken_s[1::2], strict=True):
        moving |= (log.time_s >= first_s) & (log.time_s < last_s)
    log = shaken(log, moving, rng)
    quick = find_still(log)
    monkeypatch.setattr("hapticplayer.motion.stillness.may_be_still", lambda _: True)
    assert np.array_equal(quick.bins, find_still(log).bins)
