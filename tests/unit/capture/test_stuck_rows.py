"""Which repeats are a stuck sensor, and which a coarse, slow or simulated one."""

import numpy as np
import pytest

from hapticplayer.capture.stuck import flickers, readings_each, stuck_rows

RATE_HZ, COUNT = 100.0, 3000
SPAN = slice(1200, 2000)


def moving(step: float = 1e-5, noise: float = 0.02, still=(), seed: int = 1):
    """Return readings (N, 3) of an accelerometer that is moved, in steps, still in spans."""
    rng = np.random.default_rng(seed)
    time_s = np.arange(COUNT) / RATE_HZ
    amount = np.ones(COUNT)
    for span in still:
        amount[span] = 0.0
    width = np.hanning(21) / np.hanning(21).sum()
    amount = np.convolve(np.pad(amount, 10, "edge"), width, "valid")
    swing = [np.sin(2 * np.pi * f * time_s + f) for f in (0.7, 1.1, 1.7)]
    values = 1.7 * amount * np.array(swing) + [[0.3], [-0.2], [9.8]]
    values = values.T + rng.normal(0.0, noise, (COUNT, 3))
    return step * np.round(values / step)


def stuck(values, span=SPAN, axes=slice(None)):
    values = values.copy()
    values[span, axes] = values[span.start - 1, axes]
    return values


@pytest.mark.parametrize("step", [1e-5, 0.0048, 0.01, 0.0383])
def test_a_stuck_sensor_has_no_readings(step):
    stuck_flags = stuck_rows(stuck(moving(step)))
    assert stuck_flags[SPAN].all()
    assert stuck_flags.sum() == SPAN.stop - SPAN.start


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_one_stuck_axis_takes_the_others_along(axis):
    assert stuck_rows(stuck(moving(), axes=axis))[SPAN].all()


@pytest.mark.parametrize(("value", "is_stuck"), [(-32.768, True), (0.0, False)])
def test_an_axis_with_one_value_throughout_is_stuck(value, is_stuck):
    """A simulated log may lack an axis, which is zero."""
    values = moving()
    values[:, 1] = value
    assert stuck_rows(values).all() == is_stuck


@pytest.mark.parametrize("period", [2, 3, 7])
def test_a_few_rows_that_come_again_are_no_readings(period):
    values = moving()
    block = values[SPAN.start - period : SPAN.start]
    values[SPAN] = np.resize(block, (SPAN.stop - SPAN.start, 3))
    stuck_flags = stuck_rows(values)
    assert stuck_flags[SPAN].all()
    assert stuck_flags.sum() == SPAN.stop - SPAN.start


def test_stuck_until_the_end_is_found():
    span = slice(2500, COUNT)
    assert stuck_rows(stuck(moving(), span))[span].all()


@pytest.mark.parametrize(
    ("step", "noise"),
    [(0.153, 0.02), (0.153, 0.06), (0.098, 0.02), (0.0383, 0.003), (0.0048, 0.0005)],
)
@pytest.mark.parametrize("still", [[SPAN], [slice(0, 600)], [slice(2500, COUNT)]])
def test_a_coarse_sensor_at_rest_works(step, noise, still):
    """Of 8 and 10 bits, with two decimals of g, averaged: the noise is below a step."""
    assert not stuck_rows(moving(step, noise, still)).any()


@pytest.mark.parametrize("begin", [0, 500])
def test_rest_before_a_knock_is_rest_to_a_coarse_sensor(begin):
    values = moving(0.153, 0.02, [slice(begin, 1500)])
    values[1480:1484, 2] += 12.0
    assert not stuck_rows(values).any()


def test_stuck_from_the_beginning_is_found():
    span = slice(1, 900)
    assert stuck_rows(stuck(moving(), span))[span].all()


@pytest.mark.parametrize("each", [2, 4, 10])
def test_a_slow_sensor_holds_its_readings(each):
    values = np.repeat(moving()[: COUNT // each], each, axis=0)
    assert readings_each(values) == each
    assert not stuck_rows(values).any()
    assert stuck_rows(stuck(values))[SPAN].mean() > 0.98


def test_missing_readings_are_not_stuck_ones():
    values = moving()
    values[SPAN] = np.nan
    assert not stuck_rows(values).any()


@pytest.mark.parametrize("step", [1e-5, 0.001, 0.0048])
def test_a_last_bit_that_alone_changes_is_no_reading(step, rng):
    values = moving(step)
    flips = rng.integers(0, 2, (SPAN.stop - SPAN.start, 3))
    values[SPAN] = values[SPAN.start - 1] + step * flips
    ((begin, end),) = flickers(values)
    assert (begin, end) == pytest.approx((SPAN.start, SPAN.stop), abs=3)


@pytest.mark.parametrize(
    ("step", "noise"), [(0.1, 0.02), (0.1, 0.06), (0.0383, 0.01), (0.0048, 0.003)]
)
def test_the_last_bit_of_a_sensor_at_rest_may_change_alone(step, noise):
    assert not flickers(moving(step, noise, [SPAN]))
