"""What the effects of an hjif band are over time, as polylines.

The meaning is that of the published reference software (MPEGGroup, 2de9ff1): the latest
effect that has begun counts, a curve is 0 from its last keyframe on, a transient is two
periods in 22 ms, a vectorial wave is a base signal with modulated amplitude and
frequency. Only lines stay lines; everything else is sampled every millisecond.
"""

from typing import NamedTuple

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model.arrays import Floats
from hapticplayer.untrusted import ANOTHER

TRANSIENT_S = 0.022
CARRIER_HZ = 150.0
"""Of an envelope: within what is vibration, and below half the rate of the haptic loop."""

HIGHEST_HZ = 400.0
"""Faster waves are aliases at 1 kHz."""

STEP_S = 1e-6
"""How long a jump takes in a polyline."""

BASE_SIGNALS = ("Sine", "Square", "Triangle", "SawToothUp", "SawToothDown")
BEFORE_ZERO = Message("what lies before 0 s was left out")


class Keyframes(NamedTuple):
    """Of one effect; NaN where a keyframe does not say.

    Attributes:
        time_s: (n,) increasing, from the begin of the effect.
        amplitude: (n,).
        frequency_hz: (n,).
    """

    time_s: Floats
    amplitude: Floats
    frequency_hz: Floats


class HjifEffect(NamedTuple):
    """One effect of a band.

    Attributes:
        begin_s: in media time.
        keys: its keyframes.
        phase_rad: of a wave.
        signal: name of the base signal of a wave.
    """

    begin_s: float
    keys: Keyframes
    phase_rad: float = 0.0
    signal: str = "Sine"


class EffectCurve(NamedTuple):
    """An effect as a polyline: zero outside, times (n,) s and values (n,)."""

    time_s: Floats
    value: Floats


def curve(effect: HjifEffect, kind: str) -> EffectCurve:
    """Return a curve through keyframes: Linear, Cubic, Akima, or lines for others."""
    known = ~np.isnan(effect.keys.amplitude)
    time_s, value = effect.keys.time_s[known], effect.keys.amplitude[known]
    time_s, value = stepped(time_s, value)
    if len(time_s) > 1 and kind in ("Cubic", "Akima"):
        steps = np.flatnonzero(np.diff(time_s) < 2.0 * STEP_S) + 1
        runs = zip(np.split(time_s, steps), np.split(value, steps), strict=True)
        parts = [_smooth(*run, kind) for run in runs]
        time_s, value = (np.concatenate(one) for one in zip(*parts, strict=True))
    if len(time_s) and time_s[0] > 0.0:  # holds its first value before it
        time_s, value = np.append(0.0, time_s), np.append(value[:1], value)
    return EffectCurve(effect.begin_s + time_s, value)


def transient(effect: HjifEffect) -> EffectCurve:
    """Return two periods of a sine for each keyframe."""
    known = ~np.isnan(effect.keys.amplitude)
    begins_s, heights = effect.keys.time_s[known], effect.keys.amplitude[known]
    pulse_s = np.arange(round(TRANSIENT_S * 1000.0) + 1) / 1000.0
    pulse = np.sin(4.0 * np.pi * pulse_s / TRANSIENT_S)
    time_s = np.unique((begins_s[:, None] + pulse_s).round(9))
    value = np.zeros(len(time_s))
    firsts = np.searchsorted(time_s, begins_s - STEP_S)
    lasts = np.searchsorted(time_s, begins_s + TRANSIENT_S + STEP_S)
    for begin_s, height, first, last in zip(
        begins_s, heights, firsts, lasts, strict=True
    ):
        since_s = time_s[first:last] - begin_s
        value[first:last] += height * np.interp(since_s, pulse_s, pulse)
    return EffectCurve(effect.begin_s + time_s, value)


def wave(effect: HjifEffect, low_hz: float, high_hz: float) -> EffectCurve:
    """Return a vectorial wave, its frequency between the limits of its band."""
    keys = effect.keys
    time_s = _milliseconds(keys.time_s[-1] if len(keys.time_s) else 0.0)
    height = _between(time_s, keys.time_s, keys.amplitude, 1.0)
    hertz = np.clip(_between(time_s, keys.time_s, keys.frequency_hz, 0.0), 0.0, None)
    if np.any(~np.isnan(keys.frequency_hz)):
        hertz = np.clip(hertz, low_hz, max(low_hz, high_hz))
    step = 0.5 * (hertz[1:] + hertz[:-1]) * np.diff(time_s)
    turns = np.append(0.0, np.cumsum(step)) + effect.phase_rad / (2.0 * np.pi)
    return EffectCurve(effect.begin_s + time_s, height * _base(effect.signal, turns))


def envelope(begin_s: float, length_s: float, height: float) -> EffectCurve:
    """Return a carrier of constant amplitude: all that is read of a wavelet block."""
    time_s = _milliseconds(length_s)
    return EffectCurve(
        begin_s + time_s, height * np.sin(2.0 * np.pi * CARRIER_HZ * (begin_s + time_s))
    )


def joined(shapes: list[EffectCurve]) -> EffectCurve:
    """Return effects of one band as one polyline: each ends where the next begins."""
    shapes = sorted(
        (one for one in shapes if len(one.time_s)), key=lambda one: one.time_s[0]
    )
    if not shapes:
        return EffectCurve(np.zeros(0), np.zeros(0))
    parts: list[EffectCurve] = []
    for shape, later in zip(shapes, [*shapes[1:], None], strict=True):
        end_s = np.inf if later is None else later.time_s[0] - 2.0 * STEP_S
        time_s, value = shape
        if time_s[-1] > end_s:
            value = np.append(value[time_s < end_s], np.interp(end_s, time_s, value))
            time_s = np.append(time_s[time_s < end_s], end_s)
        if not len(time_s) or (len(time_s) == 1 and later is not None):
            continue
        edges_s = (time_s[0] - STEP_S, time_s[-1] + STEP_S / 2.0)
        parts.append(
            EffectCurve(
                np.concatenate([edges_s[:1], time_s, edges_s[1:]]),
                np.concatenate([[0.0], value, [0.0]]),
            )
        )
    if not parts:
        return EffectCurve(np.zeros(0), np.zeros(0))
    return EffectCurve(*(np.concatenate(one) for one in zip(*parts, strict=True)))


def stepped(time_s: Floats, value: Floats) -> tuple[Floats, Floats]:
    """A polyline with times (n,) that increase: two values of one time are a step.

    Args:
        time_s: (m,), never decreasing; of more than two alike the first and last count.
        value: (m,).
    """
    rises = np.diff(time_s) > 0.0
    firsts, lasts = np.append(True, rises)[: len(time_s)], np.append(rises, True)
    kept = firsts | lasts[: len(time_s)]
    time_s = time_s[kept] + STEP_S * ~firsts[kept]
    increases = np.append(True, np.diff(np.maximum.accumulate(time_s)) > 0.0)
    increases = increases[: len(time_s)]
    return time_s[increases], value[kept][increases]


def from_zero(time_s: Floats, value: Floats, where: str) -> tuple[Floats, Floats]:
    """Cut lines (n,) (n, k) at 0 s, where they keep their value."""
    if time_s[0] >= 0.0:
        return time_s, value
    if time_s[-1] < 0.0:
        raise InputError("ends before 0 s", where=where, remedy=ANOTHER)
    begin = [[np.interp(0.0, time_s, column) for column in value.T]]
    later = time_s > 0.0
    return np.append(0.0, time_s[later]), np.concatenate([begin, value[later]])


def _smooth(time_s: Floats, value: Floats, kind: str) -> tuple[Floats, Floats]:
    """Return a curve between two steps, every millisecond."""
    if len(time_s) == 1:
        return time_s, value
    first, last = np.ceil(time_s[0] * 1000.0), np.floor(time_s[-1] * 1000.0)
    dense_s = np.union1d(np.arange(first, last + 1.0) / 1000.0, time_s)
    dense_s = np.clip(dense_s, time_s[0], time_s[-1])
    if kind == "Akima" and len(time_s) > 2:
        from scipy.interpolate import Akima1DInterpolator

        return dense_s, np.asarray(Akima1DInterpolator(time_s, value)(dense_s))
    return dense_s, _eased(dense_s, time_s, value)


def _eased(at_s: Floats, time_s: Floats, value: Floats) -> Floats:
    """Return the reference's cubic: level at each keyframe."""
    row = np.clip(np.searchsorted(time_s, at_s, side="right") - 1, 0, len(time_s) - 2)
    share = np.clip((at_s - time_s[row]) / np.diff(time_s)[row], 0.0, 1.0)
    rise = share * share * (3.0 - 2.0 * share)
    return np.asarray(value[row] + np.diff(value)[row] * rise)


def _between(at_s: Floats, time_s: Floats, value: Floats, default: float) -> Floats:
    known = ~np.isnan(value)
    if not known.any():
        return np.full(len(at_s), default)
    return np.interp(at_s, time_s[known], value[known])


def _milliseconds(length_s: float) -> Floats:
    """Return the milliseconds of a span, and its end."""
    even = np.arange(int(length_s * 1000.0) + 1) / 1000.0
    return np.unique(np.append(even, length_s))


def _base(name: str, turns: Floats) -> Floats:
    part = turns - np.floor(turns)
    if name == "Square":
        return np.where(part < 0.5, 1.0, -1.0)
    if name == "Triangle":
        return 1.0 - 4.0 * np.abs(np.round(turns - 0.25) - (turns - 0.25))
    if name in ("SawToothUp", "SawToothDown"):
        rise = 2.0 * (turns - np.floor(turns + 0.5))
        return rise if name == "SawToothUp" else -rise
    return np.sin(2.0 * np.pi * turns)
