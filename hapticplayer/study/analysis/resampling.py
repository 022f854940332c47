"""Seeded resampling: the same seed gives the same numbers, whatever else is computed."""

import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats

CONFIDENCE = 0.95
_MOST_VALUES = 1 << 22
"""Of one block of resamples, so that large studies do not need much memory."""


@dataclass(frozen=True, slots=True)
class Resampling:
    """How often and from which seed is resampled."""

    seed: int = 2012
    count: int = 9999

    def generator(self, label: str) -> np.random.Generator:
        """Return the generator of one use; others do not disturb it."""
        return np.random.default_rng([self.seed, zlib.crc32(label.encode())])

    def interval(
        self, values: Floats, statistic: Callable[[Floats], Floats], label: str
    ) -> tuple[float, float]:
        """Return the percentile bootstrap interval of a statistic.

        Args:
            values: (n,), drawn with replacement.
            statistic: of the last axis.
            label: of this use.
        """
        rng, found, left = self.generator(label), [], self.count
        while left:
            rows = min(left, max(1, _MOST_VALUES // len(values)))
            found.append(statistic(rng.choice(values, (rows, len(values)))))
            left -= rows
        tail = (1.0 - CONFIDENCE) / 2.0
        low, high = np.quantile(np.concatenate(found), [tail, 1.0 - tail])
        return float(low), float(high)
