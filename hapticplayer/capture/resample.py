"""Brings a rate signal to another sensor's times without losing rotation."""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats


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
    ends_s, angle = _integral(time_s, rate, slack_s)
    edges_s = np.concatenate([[2.0 * query_s[0] - query_s[1]], query_s])
    is_inside = (edges_s >= ends_s[0]) & (edges_s <= ends_s[-1])
    rows = np.flatnonzero(is_inside[:-1] & is_inside[1:])
    columns = [np.interp(edges_s, ends_s, column) for column in angle.T]
    at_edges = np.stack(columns, axis=1)
    steps_s = np.diff(edges_s)[rows, None]
    return rows, (at_edges[rows + 1] - at_edges[rows]) / steps_s


def _integral(time_s: Floats, rate: Floats, slack_s: float) -> tuple[Floats, Floats]:
    """Return the integral at the ends of all intervals.

    The outer rates are held `slack_s` longer, because the clocks of two sensors
    begin and end within a fraction of a sample of each other.
    """
    begin_s = 2.0 * time_s[0] - time_s[1]
    ends_s = np.concatenate(
        [[begin_s - slack_s, begin_s], time_s, [time_s[-1] + slack_s]]
    )
    held = np.concatenate([rate[:1], rate, rate[-1:]])
    angle = np.zeros((len(ends_s), rate.shape[1]))
    np.cumsum(held * np.diff(ends_s)[:, None], axis=0, out=angle[1:])
    return ends_s, angle
