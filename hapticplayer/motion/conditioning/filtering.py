"""Zero-phase low-pass: a Butterworth filter of order 2 run forwards and backwards.

Frequency response of both passes together (digital, bilinear transform):

    |H(f)| = 1 / (1 + (sqrt(2) - 1) (tan(pi f / rate) / tan(pi cutoff / rate))^4)

so `cutoff` is where the result is 3 dB down (not each pass, as scipy's `filtfilt` has
it: there it would be 6 dB), the phase is zero, and it falls by 24 dB per octave. Gain 1
at zero frequency. A step overshoots by 3.4 % on both sides, and its edge stays where it
was. Time stamps stay as they are.
"""

import dataclasses
from itertools import pairwise

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.conditioning import timing
from hapticplayer.motion.conditioning.timing import Mask

ORDER = 2
# The ends are continued by so many time constants of the slowest pole.
SETTLING = 5.0
# Invalid spans up to this share of the cutoff's period are bridged by a line.
MAX_BRIDGE = 0.125
# Steps that differ by less than this share count as even.
MAX_JITTER = 0.01


def lowpass_motion(track: MotionTrack, cutoff_hz: float) -> MotionTrack:
    """Return the track with its acceleration low-passed; gravity and times stay.

    Uneven time stamps: resampled evenly by themselves, filtered, and read at their own
    times. Nothing crosses a gap, and no invalid value reaches a valid one: invalid
    spans shorter than an eighth of the cutoff's period are bridged by a line (and stay
    marked), longer ones are filtered by themselves.

    Args:
        track: gravity-free acceleration.
        cutoff_hz: -3 dB of the result.
    """
    timing.positive(cutoff_hz, Message("the cutoff"), Message("give a frequency in Hz"))
    out = lowpass_samples(track.time_s, track.acceleration_mps2, track.valid, cutoff_hz)
    return dataclasses.replace(track, acceleration_mps2=out)


def lowpass_samples(
    time_s: Floats, values: Floats, valid: Mask, cutoff_hz: float
) -> Floats:
    """Return samples (N, C) low-passed as `lowpass_motion` does.

    Args:
        time_s: (N,) strictly increasing.
        values: (N, C).
        valid: (N,).
        cutoff_hz: -3 dB of the result.
    """
    if len(time_s) < 2:
        return values
    step_s = timing.median_step_s(time_s)
    if cutoff_hz >= 0.5 / step_s:
        raise InputError(
            "a cutoff of {cutoff_hz:g} Hz is not below half the rate of the "
            "samples, {half_rate_hz:.4g} Hz",
            remedy="give a lower cutoff, or leave the low-pass out",
            cutoff_hz=cutoff_hz,
            half_rate_hz=0.5 / step_s,
        )
    values, usable = _bridged(time_s, values, valid, MAX_BRIDGE / cutoff_hz)
    out = np.empty_like(values)
    for part in _stretches(time_s, usable, step_s):
        out[part] = _stretch(time_s[part], values[part], step_s, cutoff_hz)
    return out


def lowpass(values: Floats, rate_hz: float, cutoff_hz: float) -> Floats:
    """Return even samples low-passed with zero phase; response as stated above.

    The ends are continued by odd reflection; a straight line passes unchanged.

    Args:
        values: (N, C), evenly spaced, no gaps.
        rate_hz: their rate.
        cutoff_hz: -3 dB of the result, below half the rate.
    """
    if len(values) < 3:  # a line
        return values.copy()
    from scipy import signal

    half_power = np.sqrt(2.0) - 1.0
    edge = np.tan(np.pi * cutoff_hz / rate_hz) / half_power ** (0.5 / ORDER)
    one_pass_hz = float(np.arctan(edge)) * rate_hz / np.pi
    sections = signal.butter(ORDER, one_pass_hz, fs=rate_hz, output="sos")
    slowest_s = 1.0 / (2.0 * np.pi * one_pass_hz * np.sin(0.5 * np.pi / ORDER))
    padding = int(np.ceil(SETTLING * slowest_s * rate_hz))
    # what the filter leaves alone goes round it: only the rest has to settle
    share = np.linspace(0.0, 1.0, len(values))[:, None]
    line = values[:1] + share * (values[-1:] - values[:1])
    smooth = signal.sosfiltfilt(
        sections,
        values - line,
        axis=0,
        padtype="odd",
        padlen=min(padding, len(values) - 1),
    )
    return np.asarray(line + smooth)


def _stretch(time_s: Floats, values: Floats, step_s: float, cutoff_hz: float) -> Floats:
    """Return one stretch without gaps, low-passed at its own times."""
    if len(time_s) < 3:
        return values
    even_s, even = _even(time_s, values, step_s)
    rate_hz = (len(even_s) - 1) / float(even_s[-1] - even_s[0])
    # a stretch of a few uneven samples may come out slower than the recording
    filtered = lowpass(even, rate_hz, min(cutoff_hz, 0.45 * rate_hz))
    if even_s is time_s:
        return filtered
    if len(even_s) < 3:
        return np.stack([np.interp(time_s, even_s, c) for c in filtered.T], axis=1)
    from scipy.interpolate import CubicSpline

    return np.asarray(CubicSpline(even_s, filtered, axis=0)(time_s))


def _stretches(time_s: Floats, usable: Mask, step_s: float) -> list[slice]:
    """Return the slices in which `usable` is constant and the time has no gap.

    They cover all samples once, in order; filters run in each by itself, so that
    nothing is smeared across a gap or out of an invalid span.
    """
    if not len(time_s):
        return []
    cuts = np.flatnonzero((usable[1:] != usable[:-1]) | timing.gaps(time_s, step_s)) + 1
    bounds = np.concatenate(([0], cuts, [len(time_s)]))
    return [slice(int(a), int(b)) for a, b in pairwise(bounds)]


def _bridged(
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
    starts, ends = timing.runs(~valid)
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


def _even(time_s: Floats, values: Floats, step_s: float) -> tuple[Floats, Floats]:
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
