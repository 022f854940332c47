"""What time each sample stands for, and where a recording hangs together."""

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model import Sampling
from hapticplayer.model.arrays import Floats

GAP_STEPS = 3.0
"""A step of more than this many median steps is a gap: nothing is known inside."""
MAX_JITTER = 0.01
"""Steps that differ by less than this share count as even."""
RATE_TOLERANCE = 1e-3
ROUNDING = 1e-6
"""Share of a window that rounding of the time stamps may cost."""

Mask = NDArray[np.bool_]
Indices = NDArray[np.intp]


def median_step_s(time_s: Floats) -> float:
    """Return the median time between samples.

    Raises:
        InputError: for fewer than two samples, which have no rate.
    """
    if len(time_s) < 2:
        raise InputError(
            "{count} samples have no rate",
            remedy="give a recording with at least two samples",
            count=len(time_s),
        )
    return float(np.median(np.diff(time_s)))


def gaps(time_s: Floats, step_s: float) -> Mask:
    """Return (N-1,) True where a step between two samples is a gap."""
    return np.asarray(np.diff(time_s) > GAP_STEPS * step_s)


def intervals(time_s: Floats, sampling: Sampling) -> tuple[Floats, Floats]:
    """Return start and end, (N,) each in s, of the time each sample stands for.

    INSTANT: from the sample before to its own time. AVERAGED: between the midpoints
    to its neighbours. At a gap and at the ends of the recording a sample covers one
    median step, so that the intervals never overlap and a gap stays uncovered.

    Raises:
        InputError: for fewer than two samples.
    """
    step_s = median_step_s(time_s)
    gap = gaps(time_s, step_s)
    # shared edges are the same float on both sides: no sliver between the samples
    if sampling is Sampling.INSTANT:
        start_s = np.where(gap, time_s[1:] - step_s, time_s[:-1])
        return np.concatenate(([time_s[0] - step_s], start_s)), time_s
    middle_s = 0.5 * (time_s[1:] + time_s[:-1])
    half_s = 0.5 * step_s
    start_s = np.where(gap, time_s[1:] - half_s, middle_s)
    end_s = np.where(gap, time_s[:-1] + half_s, middle_s)
    return (
        np.concatenate(([time_s[0] - half_s], start_s)),
        np.concatenate((end_s, [time_s[-1] + half_s])),
    )


def runs(mask: NDArray[Any]) -> tuple[Indices, Indices]:
    """Return first and one-past-last index of each run of True in (N,)."""
    padded = np.concatenate(([False], mask.astype(np.bool_), [False]))
    edges = np.flatnonzero(padded[1:] != padded[:-1])
    return edges[::2], edges[1::2]


def stretches(time_s: Floats, usable: Mask, step_s: float) -> list[slice]:
    """Return the slices in which `usable` is constant and the time has no gap.

    They cover all samples once, in order; filters run in each by itself, so that
    nothing is smeared across a gap or out of an invalid span.
    """
    if not len(time_s):
        return []
    cuts = np.flatnonzero((usable[1:] != usable[:-1]) | gaps(time_s, step_s)) + 1
    bounds = np.concatenate(([0], cuts, [len(time_s)]))
    return [slice(int(a), int(b)) for a, b in pairwise(bounds)]


def bridge(
    time_s: Floats, values: Floats, valid: Mask, longest_s: float
) -> tuple[Floats, Mask]:
    """Replace short invalid runs by straight lines between their valid neighbours.

    A filter must not fall apart at each single invalid sample, nor may it see that
    sample's value.

    Args:
        time_s: (N,).
        values: (N, C).
        valid: (N,).
        longest_s: the largest time between the two neighbours.

    Returns:
        The values, and (N,) True where a sample is valid or has been bridged.
    """
    starts, ends = runs(~valid)
    inner = (starts > 0) & (ends < len(valid))
    starts, ends = starts[inner], ends[inner]
    short = time_s[ends] - time_s[starts - 1] <= longest_s
    if not short.any():
        return values, valid
    edges = np.zeros(len(valid) + 1, dtype=np.int8)
    edges[starts[short]] = 1
    edges[ends[short]] = -1
    filled = np.cumsum(edges[:-1], dtype=np.int8).astype(np.bool_)
    values = values.copy()
    for column in values.T:
        column[filled] = np.interp(time_s[filled], time_s[valid], column[valid])
    return values, valid | filled


def even(time_s: Floats, values: Floats, step_s: float) -> tuple[Floats, Floats]:
    """Return a stretch without gaps on even times; itself where it is even already.

    Uneven ones are resampled about `step_s` apart by monotone cubics through the
    samples at their own times: no overshoot, however close two time stamps are.

    Returns:
        Even times (M,) and values (M, C).
    """
    if len(time_s) < 2:
        return time_s, values
    span_s = float(time_s[-1] - time_s[0])
    mean_step_s = span_s / (len(time_s) - 1)
    if np.abs(np.diff(time_s) / mean_step_s - 1.0).max() < MAX_JITTER:
        return time_s, values
    from scipy.interpolate import PchipInterpolator

    even_s = np.linspace(time_s[0], time_s[-1], max(round(span_s / step_s), 1) + 1)
    return even_s, np.asarray(PchipInterpolator(time_s, values, axis=0)(even_s))


def end_line(values: Floats) -> Floats:
    """Return the line (N, C) through the first and the last row."""
    share = np.linspace(0.0, 1.0, len(values))[:, None]
    return np.asarray(values[:1] + share * (values[-1:] - values[:1]))


def continued(values: Floats, reach: int) -> Floats:
    """Return (N, C) with `reach` more rows at both ends, by odd reflection.

    Reflected as often as it takes: around the line through the ends the continuation
    is periodic, so a stretch of any length can be continued by any number of rows.
    """
    last = len(values) - 1
    if last < 1:
        return np.repeat(values, len(values) + 2 * reach, axis=0)
    slope = (values[-1] - values[0]) / last
    around = values - end_line(values)
    row = np.arange(-reach, last + reach + 1)
    phase = row % (2 * last)
    is_mirrored = phase > last
    there = around[np.where(is_mirrored, 2 * last - phase, phase)]
    sign = np.where(is_mirrored, -1.0, 1.0)[:, None]
    return np.asarray(values[0] + slope * row[:, None] + sign * there)


def positive(value: float, name: str, remedy: str) -> float:
    """Return a finite positive number.

    Raises:
        InputError: for any other number.
    """
    if not (np.isfinite(value) and value > 0.0):
        raise InputError(
            "{name} must be a positive number, got {value}",
            remedy=remedy,
            name=name,
            value=value,
        )
    return float(value)


def check_lower_rate(rate_hz: float, input_rate_hz: float, where: str) -> None:
    """Raise InputError unless 0 < rate_hz <= input_rate_hz."""
    positive(rate_hz, Message("the rate"), Message("give a rate in Hz, such as 30"))
    if rate_hz > input_rate_hz * (1.0 + RATE_TOLERANCE):
        raise InputError(
            "{rate_hz:g} Hz is above the rate of the samples, {input_rate_hz:.4g} Hz",
            where=where,
            remedy="give a lower rate; samples can be merged, not made up",
            rate_hz=rate_hz,
            input_rate_hz=input_rate_hz,
        )


def windows(start_s: Floats, end_s: Floats, rate_hz: float) -> tuple[Floats, Floats]:
    """Return opening and closing times (M,) of the windows that hold samples.

    Window k reaches from start_s[0] + k / rate to start_s[0] + (k + 1) / rate; only
    full ones before the last sample's end count. What lies in a gap is left out, so
    that hours of silence don't become millions of windows.

    Args:
        start_s: (N,) where each sample's interval begins, in order.
        end_s: (N,) where it ends.
        rate_hz: windows per second.

    Raises:
        InputError: when the time is shorter than one window.
    """
    origin_s, total_s = float(start_s[0]), float(end_s[-1] - start_s[0])
    # a few ulps of the time stamps must not cost the last window
    count = int(np.floor(total_s * rate_hz + ROUNDING))
    if count < 1:
        raise InputError(
            "{total_s:.4g} s of samples are less than one window of {window_s:.4g} s",
            remedy="give a higher rate or a longer recording",
            total_s=total_s,
            window_s=1.0 / rate_hz,
        )
    closed = np.flatnonzero(start_s[1:] > end_s[:-1])  # before a gap
    begins = start_s[np.concatenate(([0], closed + 1))] - origin_s
    ends = end_s[np.concatenate((closed, [len(end_s) - 1]))] - origin_s
    first = np.floor(begins * rate_hz + ROUNDING).astype(np.int64)
    stop = np.ceil(ends * rate_hz - ROUNDING).astype(np.int64)
    lengths = np.maximum(stop - first, 0)
    offsets = np.repeat(first - np.cumsum(lengths) + lengths, lengths)
    number = np.unique(offsets + np.arange(len(offsets)))
    number = number[number < count]
    return origin_s + number / rate_hz, origin_s + (number + 1) / rate_hz
