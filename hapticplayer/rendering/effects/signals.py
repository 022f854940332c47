"""What each kind of effect does within its span.

A kind knows nothing of fades, directions and other effects, which `apply` adds.
"""

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from hapticplayer.model.arrays import Floats

FILTER_ORDER = 2
RATE_HZ = 1000.0
"""The loop's own: of the entries in the spans of effects, and of filters and noise."""

Points = tuple[tuple[float, float], ...]


class Span(NamedTuple):
    """What a kind works on; times count from the start of the effect.

    Attributes:
        since_s: (N,) times of the samples.
        values: (N, 3) the signal so far.
        duration_s: of the effect.
        reaches_s: from when to when there is a signal.
        before: returns the signal so far (M, 3) at any times (M,).
        parameters: all of the kind's, by name.
        curve: control points, time in s and value; may be empty.
    """

    since_s: Floats
    values: Floats
    duration_s: float
    reaches_s: tuple[float, float]
    before: Callable[[Floats], Floats]
    parameters: Mapping[str, float]
    curve: Points = ()


def _even(start_s: float, end_s: float) -> Floats:
    """Return times each millisecond."""
    return np.asarray(
        start_s + np.arange(math.ceil((end_s - start_s) * RATE_HZ) + 1) / RATE_HZ
    )


def _value_along(span: Span, constant: str, since_s: Floats) -> Floats:
    """Return the value of the curve, or of the parameter where there is none."""
    if not span.curve:
        return np.full(len(since_s), span.parameters[constant])
    times_s, values = np.array(span.curve).T
    return np.asarray(np.interp(since_s, times_s, values))


def scaled(span: Span) -> Floats:
    gain = _value_along(span, "gain", span.since_s)
    return np.asarray(gain[:, None] * span.values)


def silent(span: Span) -> Floats:
    """Return silence."""
    return np.zeros_like(span.values)


def low_passed(span: Span) -> Floats:
    """The output of a Butterworth filter of second order, run both ways.

    No phase, and half the amplitude at the cut-off. It hears what is around the span.
    """
    from scipy import signal  # playing does not need it

    cutoff_hz = span.parameters["cutoff_hz"]
    margin_s = 1.5 / cutoff_hz  # exp(-6.6) of a step is left
    first_s, last_s = span.reaches_s
    at_s = _even(max(-margin_s, first_s), min(span.duration_s + margin_s, last_s))
    sos = signal.butter(FILTER_ORDER, cutoff_hz, fs=RATE_HZ, output="sos")
    low = signal.sosfiltfilt(sos, span.before(at_s), axis=0, padtype=None)
    return np.stack([np.interp(span.since_s, at_s, axis) for axis in low.T], axis=1)


def high_passed(span: Span) -> Floats:
    """The complement of a low-pass: 1 - 1 / (1 + x^4) = x^4 / (1 + x^4)."""
    return np.asarray(span.values - low_passed(span))


def pulse(span: Span) -> Floats:
    """Return a constant."""
    return np.full(len(span.since_s), span.parameters["amplitude"])


def ramp(span: Span) -> Floats:
    """Return a straight line."""
    first, last = span.parameters["from_amplitude"], span.parameters["to_amplitude"]
    return first + (last - first) * span.since_s / span.duration_s


def sine(span: Span) -> Floats:
    """Return a sine that starts at zero."""
    phase = 2.0 * np.pi * span.parameters["frequency_hz"] * span.since_s
    return np.asarray(span.parameters["amplitude"] * np.sin(phase))


def knock(span: Span) -> Floats:
    return np.asarray(sine(span) * np.exp(-span.since_s / span.parameters["decay_s"]))


def noise(span: Span) -> Floats:
    """Return band-limited noise of the RMS that is asked for over the span."""
    from scipy import signal

    parameters, at_s = span.parameters, _even(0.0, span.duration_s)
    low_hz = parameters["low_hz"]
    band_hz = low_hz, max(parameters["high_hz"], 1.1 * low_hz)
    sos = signal.butter(FILTER_ORDER, band_hz, "bandpass", fs=RATE_HZ, output="sos")
    warm_up = round(3.0 * RATE_HZ / low_hz)
    rng = np.random.default_rng(int(parameters["seed"]))
    noise = signal.sosfilt(sos, rng.standard_normal(warm_up + len(at_s)))[warm_up:]
    noise *= parameters["rms"] / np.sqrt(np.mean(np.square(noise)))
    return np.asarray(np.interp(span.since_s, at_s, noise))


def engine(span: Span) -> Floats:
    """Return a running engine: a frequency, and half as much of its double."""
    at_s = _even(0.0, span.duration_s)
    frequency_hz = _value_along(span, "frequency_hz", at_s)
    middle_hz = 0.5 * (frequency_hz[1:] + frequency_hz[:-1])
    turns = np.concatenate(([0.0], np.cumsum(middle_hz) / RATE_HZ))
    phase = 2.0 * np.pi * np.interp(span.since_s, at_s, turns)
    wave = np.sin(phase) + 0.5 * np.sin(2.0 * phase)
    return np.asarray(span.parameters["amplitude"] / 1.5 * wave)
