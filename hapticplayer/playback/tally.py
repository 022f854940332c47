"""Percentiles of any number of values in a fixed amount of memory."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray


class Tally:
    """Counts values in even steps; those beyond the limits in the first and last one.

    A percentile is the mean of the values in its step (nearest rank): off by less than
    a step, and exact where all of them are equal.

    Args:
        lowest: where the first step begins.
        highest: where the last one ends.
        step: width.

    Attributes:
        count: values so far.
        most: the largest of them.
    """

    def __init__(self, lowest: float, highest: float, step: float) -> None:
        self.count, self.most = 0, -math.inf
        self._lowest, self._step = lowest, step
        steps = math.ceil((highest - lowest) / step)
        self._counts = np.zeros(steps, np.int64)
        self._sums = np.zeros(steps)

    def add(self, values: NDArray[Any]) -> None:
        """Count more values."""
        if not len(values):
            return
        at = ((values - self._lowest) / self._step).astype(np.int64)
        at = np.minimum(np.maximum(at, 0), len(self._counts) - 1)
        np.add.at(self._counts, at, 1)
        np.add.at(self._sums, at, values)
        self.count += len(values)
        self.most = max(self.most, float(values.max()))

    def percentiles(self, *percent: float) -> list[float]:
        """Return them; there must be values."""
        ranks = np.ceil(np.array(percent) / 100.0 * self.count).clip(1, self.count)
        at = np.searchsorted(np.cumsum(self._counts), ranks)
        means: list[float] = (self._sums[at] / self._counts[at]).tolist()
        return means
