import tracemalloc

import numpy as np
import pytest

from hapticplayer.playback.meters import Histogram

SHARES = (5.0, 50.0, 95.0, 99.0, 99.9)


@pytest.mark.parametrize("kind", ["normal", "lognormal", "few", "equal"])
def test_percentiles_are_numpys_within_a_step(
    rng: np.random.Generator, kind: str
) -> None:
    values = {
        "normal": rng.normal(3.0, 20.0, 50_000),
        "lognormal": rng.lognormal(1.0, 1.0, 50_000),
        "few": rng.normal(0.0, 5.0, 7),
        "equal": np.full(1000, 12.3456),
    }[kind]
    histogram = Histogram(-150.0, 150.0, 0.05)
    for part in np.array_split(values, 7):
        histogram.add(part)
    expected = np.percentile(values, SHARES, method="inverted_cdf")
    assert histogram.count == len(values)
    assert histogram.most == values.max()
    assert histogram.percentiles(*SHARES) == pytest.approx(expected, abs=0.05)
    if kind == "equal":
        assert histogram.percentiles(50.0) == pytest.approx([12.3456], rel=1e-12)


def test_values_beyond_the_limits_count_and_the_largest_is_kept() -> None:
    histogram = Histogram(0.0, 10.0, 1.0)
    histogram.add(np.array([-5.0, 5.5, 5.5, 300.0], np.float32))
    histogram.add(np.empty(0))
    assert (histogram.count, histogram.most) == (4, 300.0)
    assert histogram.percentiles(0.0, 50.0, 100.0) == [-5.0, 5.5, 300.0]


def test_memory_does_not_grow_with_the_values(rng: np.random.Generator) -> None:
    values = rng.uniform(0.0, 100.0, 500_000)  # 4 MB
    tracemalloc.start()
    try:
        histogram = Histogram(0.0, 100.0, 0.01)
        histogram.add(values)
        kept_bytes, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    # counts and sums of 10 000 bins take 160 kB; other threads may keep some, too
    assert kept_bytes < 500_000
    assert histogram.count == len(values)
