"""From force to samples: a carrier that swells with the force, and its part in the band.

A shaker gives nothing below its band. So the magnitude of the force, below the band,
swells a carrier inside it; what one axis has inside the band is played as it is. Both
are at the loop's rate; the samples between follow straight lines.
"""

import math
from collections import deque

import numpy as np

from hapticplayer.extras.shakers.meter import LevelMeter
from hapticplayer.extras.shakers.settings import ShakerSettings
from hapticplayer.model.arrays import Floats
from hapticplayer.model.device import Vector

FULL_N = 4.5
"""Force at which a shaker does all it can."""
SAMPLE_HZ = 48_000
FADE_S = 0.005
"""For what ends without a force of its own: a loop that stands still, a stop."""
STALE_S = 0.010
KEPT_S = 0.7
KNEE = 0.8
"""Of full scale: from here on the limiter bends."""
_MOST = 4.0  # of full force; what is larger is that
_SHARE = 0.5
"""Of the carrier at full force; the direct part has the rest."""


class _OnePole:
    """A low-pass of first order, for samples at any pace."""

    def __init__(self, cut_hz: float) -> None:
        self._rate = 2.0 * math.pi * cut_hz
        self._value = 0.0

    def step(self, value: float, elapsed_s: float) -> float:
        share = -math.expm1(-self._rate * elapsed_s)
        self._value += share * (value - self._value)
        return self._value


class _Split:
    """One channel's two parts of a force, each edge with 12 dB an octave."""

    def __init__(self, low_hz: float, high_hz: float) -> None:
        self._swell = _OnePole(low_hz), _OnePole(low_hz)
        self._below = _OnePole(low_hz), _OnePole(low_hz)
        self._within = _OnePole(high_hz), _OnePole(high_hz)

    def parts(self, size: float, along: float, elapsed_s: float) -> tuple[float, float]:
        """The envelope of the carrier, and the part that is played as it is."""
        for one in self._swell:
            size = one.step(size, elapsed_s)
        for one in self._below:
            along -= one.step(along, elapsed_s)
        for one in self._within:
            along = one.step(along, elapsed_s)
        return size, along


def _splits(settings: ShakerSettings) -> list[_Split]:
    return [_Split(one.low_hz, one.high_hz) for one in settings.bands]


class ShakerSignal:
    """Takes forces with their times, gives samples for stated times; one writer, one reader.

    A force of `now_s` sounds at `now_s + latency_s`.
    """

    def __init__(self, settings: ShakerSettings) -> None:
        self._settings = settings
        self._splits = _splits(settings)
        self._sent: deque[tuple[float, ...]] = deque(maxlen=round(1000 * KEPT_S))
        self._last_s: float | None = None
        self.meter = LevelMeter(settings.channels)

    def push(self, force_n: Vector, now_s: float) -> None:
        """Take the force of a tick; not a number is none."""
        x, y, z = force_n
        size = math.hypot(x, y, z) / FULL_N
        if not size < math.inf:
            size, force_n = 0.0, (0.0, 0.0, 0.0)
        share = min(1.0, _MOST / size) if size else 0.0
        size *= share
        elapsed_s = 0.0 if self._last_s is None else now_s - self._last_s
        self._last_s = now_s
        along = share * force_n[self._settings.axis] / FULL_N
        parts = [split.parts(size, along, elapsed_s) for split in self._splits]
        self._sent.append((now_s, *(number for pair in parts for number in pair)))

    def forget(self) -> None:
        """Drop the forces that have not sounded yet: they were stopped."""
        self._sent.clear()
        self._splits = _splits(self._settings)

    def samples(self, at_s: float, count: int) -> Floats:
        """Return (count, width) samples of -1 to 1; the first sounds at `at_s`."""
        settings = self._settings
        found = np.zeros((count, settings.width))
        sent = list(self._sent)  # one call: the writer may go on
        if not sent:
            return found
        rows = np.array(sent)
        times = at_s - settings.latency_s + np.arange(count) / SAMPLE_HZ
        # a loop that stands still is heard no longer than its last force
        over_s = np.maximum(times - rows[-1, 0] - STALE_S, rows[0, 0] - times)
        fade = np.clip(1.0 - over_s / FADE_S, 0.0, 1.0)
        clock = at_s % 1.0 + np.arange(count) / SAMPLE_HZ
        for number, (channel, band) in enumerate(
            zip(settings.channels, settings.bands, strict=True)
        ):
            swell = np.interp(times, rows[:, 0], rows[:, 1 + 2 * number])
            direct = np.interp(times, rows[:, 0], rows[:, 2 + 2 * number])
            carrier = np.sin(2.0 * np.pi * round(band.carrier_hz) * clock)
            mixed = _SHARE * swell * carrier + (1.0 - _SHARE) * direct
            heard = found[:, channel - 1] = fade * limited(mixed)
            self.meter.note(
                channel,
                float(np.max(np.abs(heard))),
                at_s,
                is_limited=bool(np.any((np.abs(mixed) > KNEE) & (fade > 0.0))),
            )
        return found


def limited(values: Floats) -> Floats:
    """Return values bent towards +-1 above 0.8, without a corner."""
    size = np.abs(values)
    room = 1.0 - KNEE
    bent = KNEE + room * np.tanh((size - KNEE) / room)
    return np.asarray(np.where(size > KNEE, np.sign(values) * bent, values))
