import array
import math

import numpy as np
import pytest

from hapticplayer.haptics.finite import are_finite

EXTREMES = {"f": np.float32, "d": np.float64}


@pytest.mark.parametrize("kind", ["f", "d"])
@pytest.mark.parametrize("count", [1, 7, 4096, 20_001])
def test_every_finite_number_is(kind: str, count: int) -> None:
    limits = np.finfo(EXTREMES[kind])
    values = [limits.max, limits.min, limits.tiny, -0.0, limits.smallest_subnormal]
    numbers = array.array(kind, np.resize(values, count).tolist())
    assert are_finite(memoryview(numbers))


@pytest.mark.parametrize("kind", ["f", "d"])
@pytest.mark.parametrize("bad", [math.inf, -math.inf, math.nan, -math.nan])
def test_one_number_that_is_not_is_found_anywhere(kind: str, bad: float) -> None:
    for at in (0, 1, 2047, 2048, 4095, 4096, 9999):
        numbers = array.array(kind, [1.5] * 10_000)
        numbers[at] = bad
        assert not are_finite(memoryview(numbers))


@pytest.mark.parametrize("kind", ["f", "d"])
def test_random_bits_are_judged_as_numpy_does(
    rng: np.random.Generator, kind: str
) -> None:
    for _ in range(200):
        size = 4 if kind == "f" else 8
        data = rng.bytes(size * 100)
        expected = bool(np.isfinite(np.frombuffer(data, EXTREMES[kind])).all())
        assert are_finite(memoryview(data).cast(kind)) is expected
