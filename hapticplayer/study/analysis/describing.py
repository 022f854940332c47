"""Means, standard deviations, and seeded resampling for intervals and p values."""

import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats

CONFIDENCE = 0.95
TAILS = ((1.0 - CONFIDENCE) / 2.0, (1.0 + CONFIDENCE) / 2.0)
_MOST_VALUES = 1 << 22
"""Largest block of resamples, to limit memory."""


@dataclass(frozen=True, slots=True)
class Resampling:
    """Number and seed of resamples.

    Each use has a generator of its own, so that a seed gives the same numbers whatever
    else is computed; `scipy.stats.bootstrap` would give other ones.
    """

    seed: int = 2012
    count: int = 9999

    def generator(self, label: str) -> np.random.Generator:
        """Return the generator of one use."""
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
        low, high = np.quantile(np.concatenate(found), TAILS)
        return float(low), float(high)


@dataclass(frozen=True, slots=True)
class Summary:
    """Summary of a sample; None where it is too small.

    Attributes:
        n: number of values.
        mean: arithmetic mean.
        sd: standard deviation, with n - 1.
        median: of the values.
        q1: first quartile, by linear interpolation (type 7).
        q3: third quartile.
        low: smallest value.
        high: largest value.
        mean_low: lower end of the bootstrap interval of the mean, 95 %.
        mean_high: its upper end.
    """

    n: int
    mean: float | None = None
    sd: float | None = None
    median: float | None = None
    q1: float | None = None
    q3: float | None = None
    low: float | None = None
    high: float | None = None
    mean_low: float | None = None
    mean_high: float | None = None


def summarize(values: Floats, resampling: Resampling, label: str) -> Summary:
    """Return the summary of a sample (n,) without NaN."""
    values = values[~np.isnan(values)]
    if not len(values):
        return Summary(0)
    low, q1, median, q3, high = np.quantile(values, [0.0, 0.25, 0.5, 0.75, 1.0])
    mean_low, mean_high = resampling.interval(
        values, lambda drawn: drawn.mean(axis=-1), f"mean/{label}"
    )
    return Summary(
        n=len(values),
        mean=float(values.mean()),
        sd=float(values.std(ddof=1)) if len(values) > 1 else None,
        median=float(median),
        q1=float(q1),
        q3=float(q3),
        low=float(low),
        high=float(high),
        mean_low=mean_low,
        mean_high=mean_high,
    )
