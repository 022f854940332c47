"""Means, standard deviations, and seeded resampling for intervals and p values."""

import zlib
from dataclasses import dataclass

import numpy as np

from hapticplayer.model.arrays import Floats

CONFIDENCE = 0.95
TAILS = ((1.0 - CONFIDENCE) / 2.0, (1.0 + CONFIDENCE) / 2.0)
_MOST_VALUES = 1 << 18
"""Largest block of resamples: 2 MB."""


@dataclass(frozen=True, slots=True)
class Resampling:
    """Number and seed of resamples.

    Each use has a generator of its own, so that a seed gives the same numbers whatever
    else is computed; `scipy.stats.bootstrap` would give other ones.
    """

    seed: int = 2012
    count: int = 9999

    def generator(self, label: str) -> np.random.Generator:
        return np.random.default_rng([self.seed, zlib.crc32(label.encode())])

    def mean_interval(self, values: Floats, label: str) -> tuple[float, float] | None:
        """Return the percentile bootstrap interval of the mean of (n,).

        How often each distinct value is drawn is multinomial: the work of a resample
        grows with the number of distinct values, which a scale limits. None if all
        values are equal: no resample could differ from them.

        Args:
            values: drawn with replacement.
            label: of this use.
        """
        distinct, counts = np.unique(values, return_counts=True)
        if len(distinct) < 2:
            return None
        rng, found, left = self.generator(label), [], self.count
        while left:
            rows = min(left, max(1, _MOST_VALUES // len(distinct)))
            drawn = rng.multinomial(len(values), counts / len(values), rows)
            found.append(drawn @ distinct / len(values))
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
        mean_low: lower end of the bootstrap interval of the mean, 95 %; None if all
            values are equal.
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
    ends = resampling.mean_interval(values, f"mean/{label}") or (None, None)
    return Summary(
        n=len(values),
        mean=float(values.mean()),
        sd=float(values.std(ddof=1)) if len(values) > 1 else None,
        median=float(median),
        q1=float(q1),
        q3=float(q3),
        low=float(low),
        high=float(high),
        mean_low=ends[0],
        mean_high=ends[1],
    )
