"""Reads the bands of an hjif channel: their effects as polylines over time.

What is assumed and what is not understood is collected; how much memory waves take is
limited before they are made.
"""

from collections import Counter

import numpy as np
from msgspec.structs import replace

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats import hjif_signals as signals
from hapticplayer.extras.formats.hjif_file import EffectEntry, HjifBand
from hapticplayer.extras.formats.hjif_signals import EffectCurve, HjifEffect, Keyframes
from hapticplayer.extras.formats.hjif_wavelet import block_height
from hapticplayer.model.limits import MAX_SECONDS
from hapticplayer.untrusted import ANOTHER

MAX_SAMPLES = 3_000_000
"""Milliseconds of waves in a file: 50 min."""

_AS_LINES = ("Bezier", "Bspline")
_UNKNOWN = ("Unknown", "")


class Bands:
    """Reads all bands of a file.

    Args:
        timescale: ticks in a second.
        unread: how often each thing was not understood; it is added to.

    Attributes:
        where: the channel that is read, for errors.
        assumed: what a file does not say.
    """

    def __init__(self, timescale: float, unread: Counter[str]) -> None:
        self.where = ""
        self.assumed: list[Message] = []
        self.unread = unread
        self._timescale, self._left = timescale, MAX_SAMPLES

    def shape(self, band: HjifBand, library: dict[float, EffectEntry]) -> EffectCurve:
        """Return a band over time; empty for what is not understood.

        Args:
            band: one of a channel.
            library: effects of the perception, by id.
        """
        make = {
            "Curve": self._curve,
            "Transient": self._transient,
            "VectorialWave": self._wave,
            "WaveletWave": self._wavelet,
        }.get(band.band_type)
        if make is None:
            self.unread[f"band {band.band_type[:40]}"] += 1
            return signals.joined([])
        shapes = []
        for effect in band.effects:
            known = self._known(effect, library)
            is_empty = known and not known.keyframes
            if is_empty and band.band_type != "WaveletWave":
                self.unread["effect without keyframes"] += 1
                known = None
            if known is not None:
                shapes.append(make(known, band))
        return signals.joined(shapes)

    def _known(
        self, effect: EffectEntry, library: dict[float, EffectEntry]
    ) -> EffectEntry | None:
        """Return an effect as a basis effect; None for what is not understood."""
        kind = effect.effect_type
        if kind == "Reference":
            found = library.get(effect.id)
            if found is not None and found.effect_type == "Basis":
                return replace(found, position=effect.position)
        if kind == "Basis":
            return effect
        self.unread[f"effect {kind[:40]}"] += 1
        return None

    def _curve(self, effect: EffectEntry, band: HjifBand) -> EffectCurve:
        kind = "Cubic" if band.curve_type in _UNKNOWN else band.curve_type
        if kind not in ("Linear", "Cubic", "Akima"):
            shown = (
                Message(kind)
                if kind in _AS_LINES
                else Message("{kind!r}", kind=kind[:40])
            )
            self.assumed.append(Message("{kind} was read as lines", kind=shown))
        shape = self._effect(effect)
        self._list_empty(shape)
        if kind in ("Cubic", "Akima"):
            self._spend(shape.keys.time_s.max(initial=0.0))
        return signals.curve(shape, kind)

    def _transient(self, effect: EffectEntry, _band: HjifBand) -> EffectCurve:
        shape = self._effect(effect)
        self._list_empty(shape)
        self._spend(signals.TRANSIENT_S * len(shape.keys.time_s))
        return signals.transient(shape)

    def _wave(self, effect: EffectEntry, band: HjifBand) -> EffectCurve:
        low_hz = band.lower_frequency_limit
        high_hz = _or(band.upper_frequency_limit, 1000.0)
        if low_hz > signals.HIGHEST_HZ:
            self.unread[f"waves above {signals.HIGHEST_HZ:.0f} Hz"] += 1
            return EffectCurve(np.zeros(0), np.zeros(0))
        if effect.base_signal not in signals.BASE_SIGNALS:
            name = effect.base_signal[:40]
            self.assumed.append(Message("{kind!r} was read as a sine", kind=name))
        shape = self._effect(effect)
        self._spend(shape.keys.time_s.max(initial=0.0))
        return signals.wave(shape, low_hz, min(high_hz, signals.HIGHEST_HZ))

    def _wavelet(self, effect: EffectEntry, band: HjifBand) -> EffectCurve:
        length_s = band.block_length / self._timescale
        self._spend(length_s)
        self.assumed.append(
            Message(
                "wavelets were read as envelopes of {carrier_hz:.0f} Hz, their height "
                "is estimated",
                carrier_hz=signals.CARRIER_HZ,
            )
        )
        self.unread["course of wavelets within their blocks"] += 1
        # an orthonormal transform gathers a tone in coefficients of sqrt(2^level)
        rate_hz = _or(band.upper_frequency_limit, 8000.0)
        share = 2.0 * signals.CARRIER_HZ / max(rate_hz, 2.0 * signals.CARRIER_HZ)
        height = share**0.5 * block_height(effect.wavelet_stream, self.where)
        return signals.envelope(self._begin_s(effect), length_s, height)

    def _spend(self, length_s: float) -> None:
        """Refuse before the memory is taken."""
        self._left -= int(length_s * 1000.0) + 2
        if self._left < 0:
            raise InputError(
                "waves of more than {most_s:.0f} s",
                where=self.where,
                remedy=ANOTHER,
                most_s=MAX_SAMPLES / 1000.0,
            )

    def _effect(self, effect: EffectEntry) -> HjifEffect:
        rows = np.array(
            [
                [
                    _or(frame.relative_position, np.nan),
                    _or(frame.amplitude_modulation, np.nan),
                    _or(frame.frequency_modulation, np.nan),
                ]
                for frame in effect.keyframes
            ]
        ).reshape(-1, 3)
        is_placed = ~np.isnan(rows[:, 0])
        if not is_placed.all():
            self.unread["keyframe without a position"] += int(np.sum(~is_placed))
            rows = rows[is_placed]
        rows = rows[np.argsort(rows[:, 0], kind="stable")]
        time_s = rows[:, 0] / self._timescale
        if len(time_s) and not -MAX_SECONDS <= time_s[0] <= time_s[-1] <= MAX_SECONDS:
            raise InputError(
                "a keyframe lies outside of any clip", where=self.where, remedy=ANOTHER
            )
        return HjifEffect(
            self._begin_s(effect),
            Keyframes(time_s, rows[:, 1], rows[:, 2]),
            effect.phase,
            effect.base_signal,
        )

    def _list_empty(self, shape: HjifEffect) -> None:
        if count := int(np.isnan(shape.keys.amplitude).sum()):
            self.unread["keyframe without an amplitude"] += count

    def _begin_s(self, effect: EffectEntry) -> float:
        begin_s = effect.position / self._timescale
        if not abs(begin_s) <= MAX_SECONDS:
            raise InputError(
                "position lies outside of any clip", where=self.where, remedy=ANOTHER
            )
        return begin_s


def _or(value: float | None, default: float) -> float:
    return default if value is None else value
