"""Rails found in the data, and only where there are some."""

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion.saturation import (
    ACCELEROMETER,
    GYROSCOPE,
    find_rails,
    on_rails,
)

RATE_HZ = 200.0
T = np.arange(0, 30, 1 / RATE_HZ)
RUNNING = {"RunningHand": 6700, "RunningPocket": 3400}


def saturated(values, sensor):
    """Return which readings lie on a rail, and the largest rail or None."""
    rails = find_rails(values, sensor)
    if rails is None:
        return np.zeros(values.shape, bool), None
    return on_rails(values, rails), np.abs(rails[np.isfinite(rails)]).max()


def shaken(peak, rng):
    """Return (N, 3) of broad-band shaking with the given peak."""
    waves = [np.sin(2 * np.pi * f * T + f) for f in (1.3, 2.9, 4.7)]
    values = np.stack([sum(waves), sum(waves[:2]), waves[0]], axis=1)
    values += 0.01 * rng.standard_normal(values.shape)
    return peak * values / np.abs(values).max(axis=0)


@pytest.mark.parametrize("scale_g", [2, 4, 8, 16])
def test_an_accelerometer_clipped_at_a_known_range_is_found(scale_g, rng):
    rail = scale_g * STANDARD_GRAVITY_MPS2
    true = shaken(1.5 * rail, rng)
    mask, full_scale = saturated(np.clip(true, -rail, rail), ACCELEROMETER)
    assert full_scale == pytest.approx(rail)
    assert mask[np.abs(true) >= rail].all()
    # what is smeared towards the rail may be marked as well, within 0.2 %
    assert not mask[np.abs(true) < 0.998 * rail].any()


@pytest.mark.parametrize(("sensor", "rail"), [(ACCELEROMETER, 16.0), (GYROSCOPE, 7.37)])
def test_a_range_that_no_data_sheet_names_is_found_too(sensor, rail, rng):
    true = shaken(1.4 * rail, rng)
    mask, full_scale = saturated(np.clip(true, -rail, rail), sensor)
    assert full_scale == pytest.approx(rail)
    assert np.array_equal(mask, np.abs(true) >= 0.998 * rail)


def test_one_turn_beyond_a_known_range_is_enough():
    rate = np.zeros((2000, 3))
    rate[:, 2] = 12.0 * np.exp(-0.5 * np.square((np.arange(2000) - 900) / 60.0))
    rail = np.radians(500.0)
    mask, full_scale = saturated(np.minimum(rate, rail), GYROSCOPE)
    assert full_scale == pytest.approx(rail)
    assert np.array_equal(mask, rate >= 0.998 * rail)


def test_a_rail_that_wobbles_is_found(rng):
    """As that of RepoIMU's gyros, by 0.1 %."""
    rail = np.radians(422.0)
    true = shaken(1.6 * rail, rng)
    wobble = 1.0 + 0.001 * rng.standard_normal(true.shape).clip(-2.0, 2.0)
    mask, _ = saturated(np.where(np.abs(true) < rail, true, rail * wobble), GYROSCOPE)
    assert mask[true >= rail].mean() > 0.99
    assert not mask[np.abs(true) < 0.99 * rail].any()


def test_a_steady_turn_of_a_noisy_gyro_is_no_rail(rng):
    """A roundabout at 34 degrees a second, 19 of 60 s, as window means at 30 Hz."""
    time_s = np.arange(1800) / 30.0
    edges_s = np.interp(time_s, [20.0, 20.5, 39.0, 39.5], [0.0, 1.0, 1.0, 0.0])
    rate = np.outer(np.radians(34.0) * edges_s, [0.0, 0.0, 1.0])
    rate += np.radians(0.03) * rng.standard_normal(rate.shape)
    assert find_rails(rate, GYROSCOPE) is None


def test_axes_with_different_offsets_share_their_range(rng):
    """As on the phones, which clip at 19.05 to 19.55 m/s^2."""
    true = shaken(35.0, rng)
    rails = np.array([19.05, 19.5, 19.55])
    mask, full_scale = saturated(np.clip(true, -rails, rails), ACCELEROMETER)
    assert full_scale == pytest.approx(19.55)
    assert mask[np.abs(true) >= rails].all()


def still(rng):
    return rng.normal([0.0, 6.0, 13.0], 0.05, (6000, 3))


def quantised(values, step):
    return step * np.round(values / step)


def sinusoid(rate_hz):
    return np.outer(30.0 * np.sin(2 * np.pi * rate_hz * T), [1.0, -0.8, 0.9])


UNCLIPPED = {
    "still": still,
    "still, coarse": lambda rng: quantised(still(rng), 0.04),
    "shaken": lambda rng: shaken(40.0, rng),
    "shaken, coarse": lambda rng: quantised(shaken(40.0, rng), 0.15),
    "each sample four times": lambda rng: np.repeat(shaken(40.0, rng)[::4], 4, axis=0),
    "sinusoid in step with the clock": lambda _: sinusoid(5.0),
    "slow sinusoid, coarse": lambda _: quantised(sinusoid(0.2), 0.04),
    "constant": lambda _: np.full((1000, 3), 15.0),
    "nothing": lambda _: np.zeros((0, 3)),
    "one sample": lambda _: np.full((1, 3), 19.6),
}


@pytest.mark.parametrize("sensor", [ACCELEROMETER, GYROSCOPE])
@pytest.mark.parametrize("name", UNCLIPPED)
def test_samples_that_never_reached_a_rail_are_left_alone(name, sensor, rng):
    mask, full_scale = saturated(UNCLIPPED[name](rng), sensor)
    assert full_scale is None
    assert not mask.any()


def test_only_the_phones_of_running_people_are_clipped(shared_data):
    for path in sorted((shared_data / "orientation" / "native").glob("*.npz")):
        with np.load(path) as recording:
            force, rate = (recording[key].astype(float) for key in ("acc", "gyr"))
        mask, full_scale = saturated(force, ACCELEROMETER)
        clipped = saturated(rate, GYROSCOPE)[0]
        assert clipped.any() == ("TStick_Test10" in path.stem), path.stem
        expected = [n for word, n in RUNNING.items() if word in path.stem]
        if expected:
            assert full_scale == pytest.approx(2 * STANDARD_GRAVITY_MPS2, rel=0.01)
            assert mask.sum(axis=0).max() >= expected[0] - 10
            # 16 g of motion never show as less than 97 % of the rail
            assert np.abs(force[mask]).min() > 0.97 * full_scale
        else:
            assert not mask.any(), path.stem
