"""Brings a rate signal to another sensor's times without losing rotation."""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats, all_of_rows

_GAP_STEPS = 3.0
"""A step of more than this many samples is a gap."""

_MOSTLY = 0.5


def mean_rate(
    query_s: Floats, time_s: Floats, rate: Floats
) -> tuple[NDArray[np.intp], Floats]:
    """Return the mean rate over the interval that ends at each query time.

    The rate holds over the interval that ends at its sample (Sampling.INSTANT).
    Its integral is interpolated at the ends of the query intervals and
    differenced, so the angle over any span is kept exactly; picking or
    interpolating samples would lose it.

    Args:
        query_s: (M,) strictly increasing, M >= 2.
        time_s: (N,) strictly increasing, N >= 2.
        rate: (N, axes).

    Returns:
        The indices (K,) of the query times whose interval is covered, and the mean
        rates (K, axes).
    """
    slack_s = 0.5 * (time_s[-1] - time_s[0]) / (len(time_s) - 1)
    # the outer rates are held longer, because the clocks of two sensors begin and end
    # within a fraction of a sample of each other
    begin_s = 2.0 * time_s[0] - time_s[1]
    ends_s = np.concatenate(
        [[begin_s - slack_s, begin_s], time_s, [time_s[-1] + slack_s]]
    )
    edges_s = np.concatenate([[2.0 * query_s[0] - query_s[1]], query_s])
    is_inside = (edges_s >= ends_s[0]) & (edges_s <= ends_s[-1])
    rows = np.flatnonzero(is_inside[:-1] & is_inside[1:])
    # those inside follow one another
    use = slice(rows[0], rows[-1] + 1) if len(rows) else slice(0)
    steps_s, widths_s = np.diff(edges_s)[use], np.diff(ends_s)
    mean = np.empty((len(rows), rate.shape[1]))
    for axis in range(rate.shape[1]):  # one by one: ten hours are large
        angle = _integral(widths_s, rate[:, axis])
        turned = np.diff(np.interp(edges_s, ends_s, angle))[use]
        np.divide(turned, steps_s, out=mean[:, axis])
    return rows, mean


def mean_rate_with_holes(
    query_s: Floats, time_s: Floats, rate: Floats
) -> tuple[NDArray[np.intp], Floats]:
    """Return the mean rate like `mean_rate`, NaN where it was mostly not measured.

    Args:
        query_s: (M,) strictly increasing, M >= 2.
        time_s: (N,) strictly increasing, N >= 2; a long step is a gap.
        rate: (N, axes); may hold NaN.
    """
    finite = all_of_rows(np.isfinite(rate))
    steps_s = np.diff(time_s, prepend=time_s[0])
    is_gap = steps_s > _GAP_STEPS * np.median(np.diff(time_s))
    missing = ~finite | is_gap
    if not missing.any():
        return mean_rate(query_s, time_s, rate)
    if not finite.all():
        good_s = time_s[finite] if finite.any() else time_s
        good = rate[finite] if finite.any() else np.zeros_like(rate)
        rate = np.stack([np.interp(time_s, good_s, axis) for axis in good.T], axis=1)
    rows, mean = mean_rate(query_s, time_s, rate)
    _, share = mean_rate(query_s, time_s, missing[:, None].astype(np.float64))
    mean[share[:, 0] > _MOSTLY] = np.nan
    return rows, mean


def _integral(widths_s: Floats, rate: Floats) -> Floats:
    """Return the integral of one axis at the ends of all intervals."""
    angle = np.zeros(len(widths_s) + 1)
    held = np.concatenate([rate[:1], rate, rate[-1:]])
    held *= widths_s
    np.cumsum(held, out=angle[1:])
    return angle
