"""An even clock for logs whose stamps jitter about one.

A sensor samples by its own clock; a logger stamps a sample when it arrives. Where the
stamps are an even clock plus white noise, rates are integrated over the even clock.
"""

import numpy as np
from scipy.signal import savgol_filter

from hapticplayer.errors import Message
from hapticplayer.model.arrays import Floats

# A step of so many intervals parts two pieces: a dropout or a gap stays as it is.
MAX_STEP_INTERVALS = 1.6
# Samples over which the clock is a straight line; shorter pieces stay as they are.
LINE_SAMPLES = 257
MIN_PIECE_SAMPLES = 65
MIN_JITTERED_SHARE = 0.5
# Of an interval: less costs nothing, more is no jitter.
MIN_JITTER_RMS_INTERVALS, MAX_JITTER_INTERVALS = 0.02, 0.5
# Autocorrelation at lag 1 of white noise is 0, that of its differences -0.5.
WHITE_CORRELATION_TOLERANCE = 0.15
# Keeps ratios of constant values defined.
SMALLEST_MEAN_SQUARE = 1e-30


def even_clock(
    time_s: Floats, force: Floats | None = None, rate: Floats | None = None
) -> Floats | None:
    """Return the times of an even clock (N,), or None where the own ones are better.

    Within a piece without dropouts the even clock is the local straight line through
    the stamps, so that a slow drift remains and the mean offset is 0. It is used where
    the residuals are white and within half an interval, and where the sensors are not
    smoother over their own times, as they are where the sampling was uneven.

    Args:
        time_s: (N,) strictly increasing.
        force: (N, 3) of the accelerometer, in any unit, if it has these times.
        rate: (N, 3) of the gyro.
    """
    if len(time_s) < MIN_PIECE_SAMPLES:
        return None
    steps = time_s[1:] - time_s[:-1]
    interval_s = float(np.median(steps))
    least_s = MIN_JITTER_RMS_INTERVALS * interval_s
    # most logs end here, on a machine's own clock at the range of their steps
    if (
        steps.max() - steps.min() < least_s
        or np.std(steps[steps < MAX_STEP_INTERVALS * interval_s]) < least_s
    ):
        return None
    excess = np.pad(steps / interval_s - 1.0, 1)
    # jitter makes a long step between two short ones, a dropout does not
    early = np.minimum(excess, 0.0)
    is_gap = excess[1:-1] + early[:-2] + early[2:] > MAX_STEP_INTERVALS - 1.0
    edges = np.flatnonzero(np.concatenate([[True], is_gap, [True]]))
    long = np.flatnonzero(np.diff(edges) >= MIN_PIECE_SAMPLES)
    fitted_s, used, products = time_s.copy(), 0, np.zeros(4)
    for piece in long:
        cut = slice(edges[piece], edges[piece + 1])
        fitted_s[cut] = _local_line(time_s[cut])
        left = (time_s[cut] - fitted_s[cut]) / interval_s
        if np.abs(left).max() > MAX_JITTER_INTERVALS:
            return None
        change = np.diff(left)
        pairs = ((left, left), (left[1:], left[:-1]), (change, change))
        products[:3] += [a @ b for a, b in pairs]
        products[3] += change[1:] @ change[:-1]
        used += len(left)
    if used < MIN_JITTERED_SHARE * len(time_s):
        return None
    power, lagged, change_power, change_lagged = products
    is_white = (
        power > used * MIN_JITTER_RMS_INTERVALS**2
        and abs(lagged) < WHITE_CORRELATION_TOLERANCE * power
        and abs(change_lagged + 0.5 * change_power)
        < WHITE_CORRELATION_TOLERANCE * change_power
    )
    if not is_white or (np.diff(fitted_s) <= 0.0).any():
        return None
    ratio = 1.0
    if force is not None:
        ratio *= _roughness(fitted_s, force) / _roughness(time_s, force)
    if rate is not None:
        # it may be the mean over the step that ends with the sample
        middle_s = time_s - 0.5 * np.diff(time_s, prepend=time_s[0] - interval_s)
        own = min(_roughness(time_s, rate), _roughness(middle_s, rate))
        ratio *= _roughness(fitted_s, rate) / own
    return fitted_s if ratio <= 1.0 else None


def jitter_text(time_s: Floats, even_s: Floats) -> Message:
    """Return a sentence on the stamps (N,) that an even clock (N,) has replaced."""
    interval_s = float(np.median(np.diff(even_s)))
    return Message(
        "the time stamps jitter by {share:.0f} % of an interval; an even clock fitted to "
        "them was used",
        share=100.0 * float(np.std(time_s - even_s)) / interval_s,
    )


def _local_line(time_s: Floats) -> Floats:
    """Return stamps (N,) without what a local straight line leaves."""
    count = len(time_s)
    index = np.arange(count) - 0.5 * (count - 1)
    slope = float(index @ time_s / (index @ index))
    line = time_s.mean() + slope * index
    window = min(LINE_SAMPLES, count - 1 + count % 2)
    return np.asarray(line + savgol_filter(time_s - line, window, 1))


def _roughness(time_s: Floats, values: Floats) -> float:
    """Return the mean square of what straight lines between neighbours leave.

    What is not finite counts as nothing: a stream may come before its repair.
    """
    share = (time_s[1:-1] - time_s[:-2]) / (time_s[2:] - time_s[:-2])
    with np.errstate(all="ignore"):
        between = values[:-2] + share[:, None] * (values[2:] - values[:-2])
        squares = np.square(values[1:-1] - between)
    finite = squares[np.isfinite(squares)]
    return (float(finite.mean()) if finite.size else 0.0) + SMALLEST_MEAN_SQUARE
