"""Thins a curve to straight pieces within a tolerance.

From each corner the furthest sample is found that a line can reach while it passes all
samples between within their tolerance: the slopes that do form a cone, which only gets
narrower (Imai and Iri 1986; as the swing filter of Elmeleegy et al. 2009, but several
values of the corner are tried and the one that reaches furthest is taken). About n log n
steps of numpy for n samples; `benchmarks.distribution thinning` compares it with
Ramer-Douglas-Peucker.
"""

from collections.abc import Callable

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.milliseconds import Ticks, corners, pieces

Polyline = tuple[Ticks, Floats]

MAX_CORNERS = 900_000
"""What readers of JSON take; about four hours of a ride at 0.01 N."""

_TRIED = np.linspace(0.0, 1.0, 7)  # values of a corner, between its bounds
_WINDOW = 24


def thinned(
    track: ForceTrack,
    until_ms: int,
    tolerance_n: float,
    quantum_n: float,
    signal: Callable[[Floats], Floats] | None = None,
    least: float = -np.inf,
) -> list[Polyline]:
    """Return polylines near a track on the milliseconds from 0 to the end.

    Args:
        track: any.
        until_ms: the end.
        tolerance_n: of each signal.
        quantum_n: values are multiples of it.
        signal: (n, m) of the forces (n, 3) N, such as their size, which between two
            corners of a track is no line; None: the forces.
        least: no value is below it.
    """
    found: list[tuple[list[Ticks], list[Floats]]] = []
    for first, last in pieces(until_ms):
        if signal is None:
            ticks, values = corners(track, first, last)
        else:
            ticks = np.arange(first, last + 1)
            values = signal(track.at(ticks / 1000.0))
        curves = values.T
        found = found or [([], []) for _ in curves]
        for curve, (times, heights) in zip(curves, found, strict=True):
            start = float(heights[-1][-1]) if heights else None
            at, height = thin(ticks, curve, tolerance_n, quantum_n, start, least)
            skipped = 1 if heights else 0  # the corner that both pieces have
            times.append(at[skipped:])
            heights.append(height[skipped:])
        count = sum(len(one) for times, _ in found for one in times)
        if count > MAX_CORNERS:
            raise InputError(
                "the track needs more than {most} keyframes",
                remedy="choose a larger tolerance, or another format",
                most=MAX_CORNERS,
            )
    return [(np.concatenate(t), np.concatenate(h)) for t, h in found]


def thin(
    ticks: Ticks,
    values: Floats,
    tolerance: float,
    quantum: float,
    start: float | None = None,
    least: float = -np.inf,
) -> tuple[Ticks, Floats]:
    """Return the corners of a polyline near samples.

    Args:
        ticks: (n,) increasing times, n >= 2.
        values: (n,) at the times.
        tolerance: largest difference at the times, in the unit of the values, at
            least the quantum. Spans of zeros are kept exactly.
        quantum: the corners are multiples of it.
        start: value of the first corner, which the piece before has ended with.
        least: no corner is below it; a multiple of the quantum, at most every value.

    Returns:
        Times (k,) out of `ticks`, the first and last among them, and values (k,).
    """
    within = np.full(len(values), tolerance - 0.5 * quantum)
    quiet = values == 0.0
    within[1:-1][quiet[:-2] & quiet[1:-1] & quiet[2:]] = 0.0
    within[[0, -1]] = np.where(quiet[[0, -1]], 0.0, within[[0, -1]])
    lower, upper = np.maximum(values - within, least), values + within
    at, last = 0, len(ticks) - 1
    tried = np.array([values[0] if start is None else start])
    kept, heights = [0], []
    while at < last:
        tried = _rounded(tried, quantum)
        far, chosen, bounds = _reach(ticks, lower, upper, at, tried)
        heights.append(float(tried[chosen]))
        tried = bounds[0] + _TRIED * (bounds[1] - bounds[0])
        at = far
        kept.append(at)
    middle = min(max(float(values[last]), tried[0]), tried[-1])
    heights.append(float(_rounded(np.array([middle]), quantum)[0]))
    return ticks[kept], np.array(heights)


def _reach(
    ticks: Ticks, lower: Floats, upper: Floats, at: int, tried: Floats
) -> tuple[int, int, tuple[float, float]]:
    """Return the furthest sample, which value reaches it, and the bounds there."""
    size, last = _WINDOW, len(ticks) - 1
    while True:
        end = min(at + size, last)
        step = (ticks[at + 1 : end + 1] - ticks[at]).astype(np.float64)
        falls = (lower[at + 1 : end + 1] - tried[:, None]) / step
        rises = (upper[at + 1 : end + 1] - tried[:, None]) / step
        low = np.maximum.accumulate(falls, axis=1)
        high = np.minimum.accumulate(rises, axis=1)
        reached = (low <= high).sum(axis=1)
        furthest = int(reached.max())
        if furthest < end - at or end == last:
            break
        size *= 2
    column = max(furthest, 1) - 1
    width = np.where(reached == furthest, (high - low)[:, column], -np.inf)
    chosen = int(np.argmax(width))
    reach = float(step[column])
    bounds = (
        float(tried[chosen] + low[chosen, column] * reach),
        float(tried[chosen] + high[chosen, column] * reach),
    )
    return at + column + 1, chosen, bounds


def _rounded(values: Floats, quantum: float) -> Floats:
    return np.asarray(np.round(values / quantum) * quantum)
