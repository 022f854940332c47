import tracemalloc

import numpy as np
import pytest

from hapticplayer.playback import meters as module
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
        taken = tracemalloc.take_snapshot()
    finally:
        tracemalloc.stop()
    own = tracemalloc.Filter(inclusive=True, filename_pattern=module.__file__)
    kept = taken.filter_traces([own]).statistics("filename")  # not of other threads
    # counts and sums of 10 000 bins
    assert 2 * 8 * 10_000 <= sum(one.size for one in kept) < 2 * 8 * 10_000 + 10_000
    assert histogram.count == len(values)
