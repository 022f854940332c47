"""Zero-phase low-pass: a Butterworth filter run forwards and backwards.

Frequency response of both passes together (digital, bilinear transform):

    |H(f)| = 1 / (1 + (sqrt(2) - 1) (tan(pi f / rate) / tan(pi cutoff / rate))^(2 order))

so `cutoff` is where the result is 3 dB down (not each pass, as scipy's `filtfilt` has
it: there it would be 6 dB), the phase is zero, and it falls by 12 dB per octave and
order. Gain 1 at zero frequency. A step overshoots on both sides, by nothing at order
1, 3.4 % at 2, 6.9 % at 4, and its edge stays where it was.

Time stamps stay as they are.
"""

import dataclasses

import numpy as np
from numpy.typing import ArrayLike

from hapticplayer.errors import InputError, Message
from hapticplayer.model import MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing

DEFAULT_ORDER = 2
MAX_ORDER = 8
HALF_POWER = np.sqrt(2.0) - 1.0
SETTLING = 5.0
"""Time constants of the slowest pole by which the ends are continued."""
MAX_PADDING = 1 << 14
MAX_BRIDGE = 0.125
"""Invalid spans up to this share of the cutoff's period are bridged by a line."""


def lowpass_response(
    frequency_hz: ArrayLike,
    rate_hz: float,
    cutoff_hz: float,
    order: int = DEFAULT_ORDER,
) -> Floats:
    """Return the gain of `lowpass` at each frequency; zero phase."""
    f = np.asarray(frequency_hz, dtype=np.float64)
    ratio = np.tan(np.pi * f / rate_hz) / np.tan(np.pi * cutoff_hz / rate_hz)
    return np.asarray(1.0 / (1.0 + HALF_POWER * ratio ** (2 * order)))


def lowpass(
    values: Floats, rate_hz: float, cutoff_hz: float, order: int = DEFAULT_ORDER
) -> Floats:
    """Return even samples low-passed with zero phase; response as stated above.

    The ends are continued by odd reflection for five time constants; a straight line
    passes unchanged.

    Args:
        values: (N, C), evenly spaced, no gaps.
        rate_hz: their rate.
        cutoff_hz: -3 dB of the result.
        order: of one pass, 1 to 8.

    Raises:
        InputError: for a cutoff that is not between 0 and half the rate, or another
            order.
    """
    _check(rate_hz, cutoff_hz, order)
    if len(values) < 3:  # a line
        return values.copy()
    from scipy import signal

    edge = np.tan(np.pi * cutoff_hz / rate_hz) / HALF_POWER ** (0.5 / order)
    one_pass_hz = float(np.arctan(edge)) * rate_hz / np.pi
    sections = signal.butter(order, one_pass_hz, fs=rate_hz, output="sos")
    slowest_s = 1.0 / (2.0 * np.pi * one_pass_hz * np.sin(0.5 * np.pi / order))
    pad = _padding(len(values), SETTLING * slowest_s * rate_hz)
    # what the filter leaves alone goes round it: only the rest has to settle
    line = timing.end_line(values)
    longer = timing.continued(values - line, pad)
    smooth = signal.sosfiltfilt(sections, longer, axis=0, padtype=None)
    return np.asarray(line + smooth[pad : pad + len(values)])


def _padding(count: int, wanted: float) -> int:
    """Return by how many rows to continue `count` of them."""
    pad = int(min(np.ceil(wanted), max(count - 1, MAX_PADDING)))
    # a short stretch is repeated; begin where it is zero, so that there is no step
    return pad - pad % (count - 1) if pad >= count else pad


def lowpass_motion(
    track: MotionTrack, cutoff_hz: float, order: int = DEFAULT_ORDER
) -> MotionTrack:
    """Return the track with its acceleration low-passed; gravity and times stay.

    Uneven time stamps: resampled evenly by themselves, filtered, and read at their own
    times. Nothing crosses a gap, and no invalid value reaches a valid one: invalid
    spans shorter than an eighth of the cutoff's period are bridged by a line (and stay
    marked), longer ones are filtered by themselves.

    Args:
        track: gravity-free acceleration.
        cutoff_hz: -3 dB of the result.
        order: of one pass, 1 to 8.

    Raises:
        InputError: as `lowpass`, against half the median rate.
    """
    if len(track) < 2:
        timing.positive(
            cutoff_hz, Message("the cutoff"), Message("give a frequency in Hz")
        )
        return track
    step_s = timing.median_step_s(track.time_s)
    _check(1.0 / step_s, cutoff_hz, order)
    values, usable = timing.bridge(
        track.time_s, track.acceleration_mps2, track.valid, MAX_BRIDGE / cutoff_hz
    )
    out = np.empty_like(values)
    for part in timing.stretches(track.time_s, usable, step_s):
        out[part] = _stretch(track.time_s[part], values[part], step_s, cutoff_hz, order)
    return dataclasses.replace(track, acceleration_mps2=out)


def _stretch(
    time_s: Floats, values: Floats, step_s: float, cutoff_hz: float, order: int
) -> Floats:
    """Return one stretch without gaps, low-passed at its own times."""
    if len(time_s) < 2:
        return values
    even_s, even = timing.even(time_s, values, step_s)
    rate_hz = (len(even_s) - 1) / float(even_s[-1] - even_s[0])
    # a stretch of a few uneven samples may come out slower than the recording
    filtered = lowpass(even, rate_hz, min(cutoff_hz, 0.45 * rate_hz), order)
    if even_s is time_s or len(even_s) < 3:
        columns = [np.interp(time_s, even_s, c) for c in filtered.T]
        return np.stack(columns, axis=1) if even_s is not time_s else filtered
    from scipy.interpolate import CubicSpline

    return np.asarray(CubicSpline(even_s, filtered, axis=0)(time_s))


def _check(rate_hz: float, cutoff_hz: float, order: int) -> None:
    timing.positive(
        rate_hz, Message("the rate"), Message("give the samples per second")
    )
    timing.positive(cutoff_hz, Message("the cutoff"), Message("give a frequency in Hz"))
    if cutoff_hz >= 0.5 * rate_hz:
        raise InputError(
            "a cutoff of {cutoff_hz:g} Hz is not below half the rate of the "
            "samples, {half_rate_hz:.4g} Hz",
            remedy="give a lower cutoff, or leave the low-pass out",
            cutoff_hz=cutoff_hz,
            half_rate_hz=0.5 * rate_hz,
        )
    if not 1 <= order <= MAX_ORDER:
        raise InputError(
            "a low-pass of order {order} is not possible",
            remedy="give an order of 1 to {most}",
            order=order,
            most=MAX_ORDER,
        )
