"""The motion between window means: the derivative of a spline through their integral.

The integral of the acceleration is known exactly at the edges of the windows: it is the
running sum of the means. A cubic spline through it (not-a-knot at the ends) has a
derivative that is quadratic in each window, keeps the mean of every window, and repeats
constant and linear signals exactly. Source: the histospline of Boneva, Kendall and
Stefanov 1971, "Spline transformations".

Frequency response (Unser 1999, "Splines: a perfect fit for signal and image
processing"): of a sine of frequency f, v = f / rate below 1 / 2, the part

    L(v) = 1 / sum over all integers k of (v / (v - k))^4

comes out, and with it images at f - k rate of size L(v) (v / (v - k))^3: L is 0.9992 at
4 Hz and 0.980 at 8 Hz for 30 windows per second. The mean over a window leaves
sin(x) / x, x = pi v, and a line between means its square of that: together 0.92 and
0.70. The price is noise: at half the rate it comes out as peaks of 1.5 times its size.
"""

import math

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import MotionTrack, Sampling
from hapticplayer.model.arrays import Floats

PLAYED_HZ = 120.0
"""Lines between entries at this rate: four to a window of the paper's board."""

MOST_PER_WINDOW = 4
LEAST_SAMPLES = 8
"""Shorter runs stay lines: the ends of a spline are its worst part."""

STEP_RANGE = (0.5, 1.5)
"""Steps that windows side by side may have, in median steps; others are gaps. Narrower
or wider windows would let the spline swing."""


def dense_motion(motion: MotionTrack) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Return times (M,), acceleration (M, 3) and validity (M,) to be played as lines.

    The windows of averaged samples reach to the midpoints between their times. Runs of
    valid samples without a gap get entries between their samples; a sample's own time
    stays an entry. Everything else is returned as it is: samples that are not averaged,
    or not valid, those of short runs, and a recording of `PLAYED_HZ` or more.
    """
    as_is = motion.time_s, motion.acceleration_mps2, motion.valid
    if motion.sampling is not Sampling.AVERAGED or len(motion) < LEAST_SAMPLES:
        return as_is
    from hapticplayer.motion.conditioning import timing  # brings scipy

    step_s = timing.median_step_s(motion.time_s)
    per_window = min(math.ceil(PLAYED_HZ * step_s), MOST_PER_WINDOW)
    if per_window < 2:
        return as_is
    steps = np.diff(motion.time_s) / step_s
    is_joined = (steps >= STEP_RANGE[0]) & (steps <= STEP_RANGE[1])
    is_joined &= motion.valid[1:] & motion.valid[:-1]
    starts, ends = timing.runs(is_joined)
    is_long = ends - starts >= LEAST_SAMPLES - 1
    bounds = np.stack([starts, ends + 1], axis=1)[is_long]
    runs = [slice(*samples) for samples in bounds.tolist()]
    counts = np.ones(len(steps), dtype=np.intp)
    for run in runs:
        counts[run.start : run.stop - 1] = per_window
    # of the samples among the entries
    places = np.concatenate(([0], np.cumsum(counts)))
    repeats = np.append(counts, 1)
    time_s = np.interp(np.arange(places[-1] + 1), places, motion.time_s)
    acceleration = np.repeat(motion.acceleration_mps2, repeats, axis=0)
    for run in runs:
        entries = slice(places[run.start], places[run.stop - 1] + 1)
        acceleration[entries] = _derivative(
            motion.time_s[run], motion.acceleration_mps2[run], time_s[entries]
        )
    return time_s, acceleration, np.repeat(motion.valid, repeats)


def _derivative(time_s: Floats, means: Floats, at_s: Floats) -> Floats:
    """Return the derivative (M, 3) of the spline through the integral of (N, 3) means."""
    from scipy.interpolate import CubicSpline

    middles = 0.5 * (time_s[1:] + time_s[:-1])
    first_s, last_s = 2.0 * time_s[0] - middles[0], 2.0 * time_s[-1] - middles[-1]
    edges = np.concatenate(([first_s], middles, [last_s]))
    # an uneven step moves a window's middle off its time: a line has to stay a line
    off_s = 0.5 * (edges[1:] + edges[:-1]) - time_s
    means = means + off_s[:, None] * np.gradient(means, time_s, axis=0)
    level = means.mean(axis=0)  # a running sum over hours keeps its digits
    areas = (means - level) * np.diff(edges)[:, None]
    integral = np.concatenate((np.zeros_like(areas[:1]), np.cumsum(areas, axis=0)))
    origin_s = time_s[0]
    return np.asarray(
        level + CubicSpline(edges - origin_s, integral, axis=0)(at_s - origin_s, nu=1)
    )
