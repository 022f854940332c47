import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.capture.streams import SensorStream, mean_rate, on_common_times


def test_equal_times_change_nothing():
    rng = np.random.default_rng(1)
    time_s = np.cumsum(rng.uniform(0.004, 0.006, 200))
    rate = rng.normal(size=(200, 3))
    rows, mean = mean_rate(time_s, time_s, rate)
    np.testing.assert_array_equal(rows, np.arange(200))
    np.testing.assert_allclose(mean, rate, atol=1e-9)


def test_twice_the_rate_is_averaged_in_pairs():
    rate = np.arange(40.0)[:, None]
    fast_s = np.arange(1, 41) * 0.0025
    rows, mean = mean_rate(fast_s[1::2], fast_s, rate)
    np.testing.assert_array_equal(rows, np.arange(20))
    np.testing.assert_allclose(mean[:, 0], np.arange(20) * 2 + 0.5, atol=1e-9)


@given(seed=st.integers(0, 2**32 - 1), ratio=st.floats(0.3, 20.0))
@settings(max_examples=50)
def test_no_angle_is_lost(seed, ratio):
    """The angle over the covered span equals the integral of the samples there."""
    rng = np.random.default_rng(seed)
    time_s = np.cumsum(rng.uniform(0.5, 1.5, 400)) * 0.005
    rate = rng.normal(size=(400, 3))
    query_s = np.arange(time_s[3], time_s[-3], 0.005 * ratio)
    if len(query_s) < 4:
        return
    rows, mean = mean_rate(query_s, time_s, rate)
    inner = rows[rows > 0]
    steps_s = np.diff(query_s)[inner - 1]
    angle = mean[rows > 0] * steps_s[:, None]
    first_s, last_s = query_s[inner[0] - 1], query_s[inner[-1]]
    starts_s = np.concatenate([[-np.inf], time_s[:-1]])
    share_s = np.clip(
        np.minimum(time_s, last_s) - np.maximum(starts_s, first_s), 0.0, None
    )
    expected = (rate * share_s[:, None]).sum(axis=0)
    np.testing.assert_allclose(angle.sum(axis=0), expected, atol=1e-9)


def test_times_outside_are_left_out():
    time_s = np.arange(100) * 0.01
    query_s = np.arange(-0.5, 1.5, 0.02)
    rows, _ = mean_rate(query_s, time_s, np.ones((100, 3)))
    assert query_s[rows].min() >= -0.02
    assert query_s[rows].max() <= time_s[-1] + 0.005
    assert len(rows) == pytest.approx(50, abs=2)


def test_jitter_of_either_stream_does_not_reach_the_other(rng):
    """Over its jittered stamps the rate would be off by 20 % of itself."""
    interval_s = 1.0 / 30.0
    true_s = interval_s * np.arange(1500)

    def stamped(values):
        noise_s = 0.2 * interval_s * rng.uniform(-1.0, 1.0, len(true_s))
        return SensorStream(true_s + noise_s, values)

    force = 9.8 + np.sin(true_s[:, None] * [5.0, 7.0, 11.0])
    force[100:110] = np.nan
    rate = np.cos(true_s[:, None] * [3.0, 2.0, 4.0])
    found = on_common_times(stamped(force), stamped(rate), None, "")
    rows = np.round(found.time_s / interval_s).astype(int)
    assert len(rows) >= 1499
    assert np.abs(found.time_s - true_s[rows]).max() < 0.05 * interval_s
    inner = rows[2:-2]
    assert np.abs(found.rate[2:-2] - rate[inner]).max() < 0.05
    assert [note.split(":")[0] for note in found.notes] == [
        "accelerometer",
        "gyroscope",
    ]


def test_even_streams_keep_their_times(rng):
    time_s = 0.01 * np.arange(1500)
    given = SensorStream(time_s, rng.normal(size=(1500, 3)))
    other = SensorStream(time_s.copy(), rng.normal(size=(1500, 3)))
    found = on_common_times(given, other, None, "")
    np.testing.assert_array_equal(found.time_s, time_s)
    assert found.notes == ()
