"""Gain over time: softer, stronger or silent spans of the effect.

A span multiplies the acceleration by its gain. Its fades lie inside it: a raised
cosine leads from 1 at its start to the gain and back to 1 at its end, so that the
product is continuous in value and slope and nothing changes outside. Spans that
overlap multiply, in any order: a ride at half strength with a silent second in it is
two spans.

Frequency response: flat, `gain`, where the gain is constant. The fades spread a
frequency f over f +- a few 1 / fade; the sidebands fall by 18 dB per octave beyond.
Time stamps stay as they are.
"""

import dataclasses
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.model import MotionTrack
from hapticplayer.model.arrays import Floats

DEFAULT_FADE_S = 0.25


@dataclass(frozen=True, slots=True)
class GainSpan:
    """A span of time with a gain.

    Attributes:
        start_s: where the fade from 1 begins.
        end_s: where the fade back to 1 has ended.
        gain: factor between the fades, 0 or more.
        fade_in_s: length of the first fade.
        fade_out_s: length of the second.

    Raises:
        InputError: when times or gain are not finite, the span is empty, the gain is
            negative, a fade is zero (a jump of the force) or both are longer than the
            span.
    """

    start_s: float
    end_s: float
    gain: float
    fade_in_s: float = DEFAULT_FADE_S
    fade_out_s: float = DEFAULT_FADE_S

    def __post_init__(self) -> None:
        numbers = (self.start_s, self.end_s, self.gain, self.fade_in_s, self.fade_out_s)
        if not np.isfinite(numbers).all():
            raise InputError(
                "a gain span holds a number that is not finite: {numbers}",
                remedy="give times in seconds and a gain",
                numbers=numbers,
            )
        where = Message(
            "span from {start_s:g} s to {end_s:g} s",
            start_s=self.start_s,
            end_s=self.end_s,
        )
        if self.gain < 0.0:
            raise InputError(
                "the gain {gain:g} would reverse the motion",
                where=where,
                remedy="give 0 or more; directions are set by the mapping",
                gain=self.gain,
            )
        if min(self.fade_in_s, self.fade_out_s) <= 0.0:
            raise InputError(
                "a span without a fade makes the force jump",
                where=where,
                remedy="give fades above zero, such as {fade_s} s",
                fade_s=DEFAULT_FADE_S,
            )
        # a span of exactly two fades must not fail over an ulp
        if self.fade_in_s + self.fade_out_s > (self.end_s - self.start_s) * (1 + 1e-9):
            raise InputError(
                "the fades take {fades_s:g} s",
                where=where,
                remedy="give shorter fades or a longer span",
                fades_s=self.fade_in_s + self.fade_out_s,
            )


def gain_at(spans: Iterable[GainSpan], time_s: Floats) -> Floats:
    """Return the product (N,) of all spans' gains at increasing `time_s` (N,)."""
    gain = np.ones(len(time_s))
    for span in spans:
        # only the span's own samples: many short spans cost no more than one long one
        here = slice(*np.searchsorted(time_s, (span.start_s, span.end_s)))
        entered = _raised_cosine((time_s[here] - span.start_s) / span.fade_in_s)
        left = _raised_cosine((span.end_s - time_s[here]) / span.fade_out_s)
        # the fades do not overlap, so their product is one or the other
        gain[here] *= 1.0 + (span.gain - 1.0) * entered * left
    return gain


def modulate(track: MotionTrack, spans: Iterable[GainSpan]) -> MotionTrack:
    """Return the track with its acceleration times `gain_at`; gravity stays."""
    gain = gain_at(spans, track.time_s)
    return dataclasses.replace(
        track, acceleration_mps2=gain[:, None] * track.acceleration_mps2
    )


def _raised_cosine(x: Floats) -> Floats:
    """Return 0 below 0, 1 above 1 and half a cosine between."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * np.clip(x, 0.0, 1.0)))
