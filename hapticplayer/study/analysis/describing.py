"""Means, spreads and whether a sample looks normal."""

from dataclasses import dataclass

import numpy as np
from scipy import stats

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.resampling import Resampling

_LEAST_FOR_SHAPIRO = 3


@dataclass(frozen=True, slots=True)
class Summary:
    """A sample in numbers; None where it is too small for one.

    Attributes:
        n: values.
        mean: arithmetic.
        sd: with n - 1.
        median: the middle.
        q1: first quartile, by linear interpolation (type 7).
        q3: third quartile.
        low: smallest value.
        high: largest value.
        mean_low: begin of the bootstrap interval of the mean, 95 %.
        mean_high: its end.
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


@dataclass(frozen=True, slots=True)
class Shapiro:
    """Test of Shapiro and Wilk; None where the sample is too small or constant."""

    w: float | None
    p: float | None


def summarize(values: Floats, resampling: Resampling, label: str) -> Summary:
    """Return a sample (n,) in numbers; NaN do not count."""
    values = values[~np.isnan(values)]
    if not len(values):
        return Summary(0)
    low, q1, median, q3, high = np.quantile(values, [0.0, 0.25, 0.5, 0.75, 1.0])
    begin, end = resampling.interval(
        values, lambda drawn: drawn.mean(axis=-1), f"mean/{label}"
    )
    return Summary(
        len(values),
        float(values.mean()),
        float(values.std(ddof=1)) if len(values) > 1 else None,
        float(median),
        float(q1),
        float(q3),
        float(low),
        float(high),
        begin,
        end,
    )


def shapiro(values: Floats) -> Shapiro:
    """Test whether a sample (n,) may come from a normal distribution."""
    if len(values) < _LEAST_FOR_SHAPIRO or np.ptp(values) == 0.0:
        return Shapiro(None, None)
    found = stats.shapiro(values)
    return Shapiro(float(found.statistic), float(found.pvalue))
