"""Reads the bands of an hjif channel: their effects as polylines over time.

What is assumed and what is not understood is collected; how much memory waves take is
limited before they are made.
"""

from collections import Counter

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats import hjif_signals as signals
from hapticplayer.extras.formats.hjif_signals import EffectCurve, HjifEffect, Keyframes
from hapticplayer.extras.formats.hjif_wavelet import block_height
from hapticplayer.extras.formats.json_fields import Fields
from hapticplayer.sequence.force_files import MAX_SECONDS
from hapticplayer.untrusted import ANOTHER

MAX_SAMPLES = 3_000_000
"""Milliseconds of waves in a file: 50 min."""


class Bands:
    """Reads all bands of a file.

    Args:
        timescale: ticks in a second.

    Attributes:
        assumed: what a file does not say.
        unread: how often each thing was not understood.

    Raises:
        InputError: for a time scale below 1.
    """

    def __init__(self, timescale: float) -> None:
        if not timescale >= 1.0:
            raise InputError("timescale must be 1 or more", remedy=ANOTHER)
        self.assumed: list[Message] = []
        self.unread: Counter[str] = Counter()
        self._timescale, self._left = timescale, MAX_SAMPLES

    def shape(self, band: Fields, library: dict[int, Fields]) -> EffectCurve:
        """Return a band over time; empty for what is not understood.

        Args:
            band: one of a channel.
            library: effects of the perception, by id.
        """
        kind = band.text("band_type")
        make = {
            "Curve": self._curve,
            "Transient": self._transient,
            "VectorialWave": self._wave,
            "WaveletWave": self._wavelet,
        }.get(kind)
        if make is None:
            self.unread[f"band {kind}"] += 1
            return signals.joined([])
        shapes = []
        for effect in band.objects("effects"):
            known = self._known(effect, library)
            if known is not None:
                shapes.append(make(known, band))
        return signals.joined(shapes)

    def _known(self, effect: Fields, library: dict[int, Fields]) -> Fields | None:
        """Return an effect as a basis effect; None for what is not understood."""
        kind = effect.text("effect_type", "Basis")
        if kind == "Reference":
            found = library.get(int(effect.number("id", -1.0)))
            if found is not None and found.text("effect_type", "Basis") == "Basis":
                where = f"{effect.where}, id"
                position = {"position": effect.values.get("position", 0)}
                return Fields({**found.values, **position}, where)
        if kind == "Basis":
            return effect
        self.unread[f"effect {kind}"] += 1
        return None

    def _curve(self, effect: Fields, band: Fields) -> EffectCurve:
        kind = band.text("curve_type", "Linear")
        if kind in ("Bezier", "Bspline"):
            self.assumed.append(Message("{kind} was read as lines", kind=kind))
        shape = self._effect(effect)
        if kind in ("Cubic", "Akima"):
            self._spend(shape.keys.time_s.max(initial=0.0), band)
        return signals.curve(shape, kind)

    def _transient(self, effect: Fields, band: Fields) -> EffectCurve:
        shape = self._effect(effect)
        self._spend(signals.TRANSIENT_S * len(shape.keys.time_s), band)
        return signals.transient(shape)

    def _wave(self, effect: Fields, band: Fields) -> EffectCurve:
        low_hz = band.number("lower_frequency_limit", 0.0)
        high_hz = band.number("upper_frequency_limit", 1000.0)
        if low_hz > signals.HIGHEST_HZ:
            self.unread[f"waves above {signals.HIGHEST_HZ:.0f} Hz"] += 1
            return EffectCurve(np.zeros(0), np.zeros(0))
        shape = self._effect(effect)
        self._spend(shape.keys.time_s.max(initial=0.0), band)
        return signals.wave(shape, low_hz, min(high_hz, signals.HIGHEST_HZ))

    def _wavelet(self, effect: Fields, band: Fields) -> EffectCurve:
        length_s = band.number("block_length", 0.0, most=1e6) / self._timescale
        self._spend(length_s, band)
        self.assumed.append(
            Message(
                "wavelets were read as envelopes of {carrier_hz:.0f} Hz, their height "
                "is estimated",
                carrier_hz=signals.CARRIER_HZ,
            )
        )
        # an orthonormal transform gathers a tone in coefficients of sqrt(2^level)
        rate_hz = band.number("upper_frequency_limit", 8000.0, most=1e6)
        share = 2.0 * signals.CARRIER_HZ / max(rate_hz, 2.0 * signals.CARRIER_HZ)
        height = share**0.5 * block_height(effect.text("wavelet_stream", ""))
        return signals.envelope(self._begin_s(effect), length_s, height)

    def _spend(self, length_s: float, band: Fields) -> None:
        """Refuse before the memory is taken."""
        self._left -= int(length_s * 1000.0) + 2
        if self._left < 0:
            raise InputError(
                "waves of more than {most_s:.0f} s",
                where=band.where,
                remedy=ANOTHER,
                most_s=MAX_SAMPLES / 1000.0,
            )

    def _effect(self, effect: Fields) -> HjifEffect:
        frames = effect.objects("keyframes")
        rows = np.array(
            [
                [
                    frame.number("relative_position", 0.0),
                    frame.number("amplitude_modulation", np.nan)
                    if "amplitude_modulation" in frame.values
                    else np.nan,
                    frame.number("frequency_modulation")
                    if "frequency_modulation" in frame.values
                    else np.nan,
                ]
                for frame in frames
            ]
        ).reshape(-1, 3)
        rows = rows[np.argsort(rows[:, 0], kind="stable")]
        time_s = rows[:, 0] / self._timescale
        if len(time_s) and not 0.0 <= time_s[0] <= time_s[-1] <= MAX_SECONDS:
            raise InputError(
                "a keyframe lies outside of any clip",
                where=effect.where,
                remedy=ANOTHER,
            )
        return HjifEffect(
            self._begin_s(effect),
            Keyframes(time_s, rows[:, 1], rows[:, 2]),
            effect.number("phase", 0.0, most=1e6),
            effect.text("base_signal", "Sine"),
        )

    def _begin_s(self, effect: Fields) -> float:
        begin_s = effect.number("position", 0.0) / self._timescale
        if not abs(begin_s) <= MAX_SECONDS:
            raise InputError(
                "position lies outside of any clip", where=effect.where, remedy=ANOTHER
            )
        return begin_s
