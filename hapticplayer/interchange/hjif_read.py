"""Reads hjif files (ISO/IEC 23090-31), our own and others', as force.

Force amplitudes are newtons by the reference device's `maximum_amplitude`; where a file
gives none, and for Vibrotactile, amplitude 1 is the chosen full scale. Channels without a
direction act along the chosen one.
"""

from collections import Counter
from pathlib import Path

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.interchange import hjif_signals as signals
from hapticplayer.interchange.force_files import (
    MAX_SECONDS,
    ForceFile,
    ReadChoices,
    refuse_large,
)
from hapticplayer.interchange.hjif_signals import Effect, Keyframes, Shape
from hapticplayer.interchange.hjif_wavelet import block_height
from hapticplayer.interchange.json_fields import Fields, read_crowd
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats

FORCE = ("Force", "Kinesthetic")
VIBRATION = ("Vibrotactile", "Vibration")
MAX_SAMPLES = 3_000_000
"""Milliseconds of waves in a file: 50 min."""

_ANOTHER = Message("choose another file")


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file.

    Raises:
        InputError: when it is no such file, or holds no force.
    """
    root = Fields.of(read_crowd(path), str(path))
    if "perceptions" not in root.values:
        raise InputError("holds no perceptions", where=str(path), remedy=_ANOTHER)
    reader = _Reader(choices, root.number("timescale", 1000.0))
    for perception in root.objects("perceptions"):
        reader.add(perception)
    return reader.result(path)


class _Reader:
    """Collects the channels of a file as polylines with a direction in newtons."""

    def __init__(self, choices: ReadChoices, timescale: float) -> None:
        if not timescale >= 1.0:
            raise InputError("timescale must be 1 or more", remedy=_ANOTHER)
        self._choices, self._timescale = choices, timescale
        self._parts: list[tuple[Floats, Shape]] = []
        self._assumed: list[Message] = []
        self._unread: Counter[str] = Counter()
        self._left = MAX_SAMPLES

    def add(self, perception: Fields) -> None:
        """Add the channels of a perception, or note that it is no force."""
        modality = perception.text("perception_modality", "Other")
        if modality not in FORCE + VIBRATION:
            self._unread[f"perception {modality}"] += 1
            return
        library = {
            int(one.number("id", 0.0)): one
            for one in perception.objects("effect_library")
        }
        devices = {
            int(one.number("id", 0.0)): one
            for one in perception.objects("reference_devices")
        }
        exponent = perception.number("perception_unit_exponent", 0.0, most=9.0)
        for channel in perception.objects("channels"):
            scale_n = self._scale_n(channel, modality, devices) * 10.0**exponent
            bands = [self._band(band, library) for band in channel.objects("bands")]
            shape = _summed([one for one in bands if len(one.time_s)])
            if len(shape.time_s):
                self._parts.append((scale_n * self._direction(channel), shape))

    def result(self, path: Path) -> ForceFile:
        """Return all channels as one track.

        Raises:
            InputError: when there are none, or the forces are too large.
        """
        unread = [
            Message("not read: {what} ({count})", what=what, count=count)
            for what, count in self._unread.items()
        ]
        if not self._parts:
            if unread:
                raise InputError(
                    "holds no force that is understood ({first})",
                    where=str(path),
                    remedy=_ANOTHER,
                    first=unread[0],
                )
            time_s, force_n = np.zeros(1), np.zeros((1, 3))
        else:
            time_s = np.unique(np.concatenate([s.time_s for _, s in self._parts]))
            force_n = np.zeros((len(time_s), 3))
            for vector_n, shape in self._parts:
                force_n += np.interp(time_s, *shape)[:, None] * vector_n
        kept = time_s >= 0.0
        if not kept.any():
            raise InputError("ends before 0 s", where=str(path), remedy=_ANOTHER)
        refuse_large(force_n, str(path), Message("give another full scale"))
        track = ForceTrack(
            time_s[kept],
            force_n[kept].astype(np.float32),
            provenance={"source": path.name, "reader": "hjif"},
        )
        return ForceFile(track, (*dict.fromkeys(self._assumed), *unread))

    def _scale_n(
        self, channel: Fields, modality: str, devices: dict[int, Fields]
    ) -> float:
        gain = channel.number("gain", 1.0, most=1e6)
        device = devices.get(int(channel.number("reference_device_id", -1.0)))
        if device is None and devices:
            device = next(iter(devices.values()))
        full_n = self._choices.full_scale_n
        if modality in FORCE and device and "maximum_amplitude" in device.values:
            return gain * device.number("maximum_amplitude", most=1e6)
        self._assumed.append(
            Message(
                "{modality}: amplitude 1 was taken as {full_n:.3g} N",
                modality=modality,
                full_n=full_n,
            )
        )
        return gain * full_n

    def _direction(self, channel: Fields) -> Floats:
        if "direction" not in channel.values:
            chosen = self._choices.direction
            self._assumed.append(
                Message(
                    "no direction in the file: x {x:.2f}, y {y:.2f}, z {z:.2f}",
                    **dict(zip("xyz", chosen, strict=True)),
                )
            )
            return np.array(chosen)
        given = Fields.of(channel.values["direction"], f"{channel.where}, direction")
        vector = np.array([given.number(axis, 0.0, most=1e3) for axis in "XYZ"])
        size = float(np.linalg.norm(vector))
        return np.asarray(vector / size) if size else vector

    def _band(self, band: Fields, library: dict[int, Fields]) -> Shape:
        kind = band.text("band_type")
        make = {
            "Curve": self._curve,
            "Transient": self._transient,
            "VectorialWave": self._wave,
            "WaveletWave": self._wavelet,
        }.get(kind)
        if make is None:
            self._unread[f"band {kind}"] += 1
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
        self._unread[f"effect {kind}"] += 1
        return None

    def _curve(self, effect: Fields, band: Fields) -> Shape:
        kind = band.text("curve_type", "Linear")
        if kind in ("Bezier", "Bspline"):
            self._assumed.append(Message("{kind} was read as lines", kind=kind))
        shape = self._effect(effect)
        if kind in ("Cubic", "Akima"):
            self._spend(shape.keys.time_s.max(initial=0.0), band)
        return signals.curve(shape, kind)

    def _transient(self, effect: Fields, band: Fields) -> Shape:
        shape = self._effect(effect)
        self._spend(signals.TRANSIENT_S * len(shape.keys.time_s), band)
        return signals.transient(shape)

    def _wave(self, effect: Fields, band: Fields) -> Shape:
        low_hz = band.number("lower_frequency_limit", 0.0)
        high_hz = band.number("upper_frequency_limit", 1000.0)
        if low_hz > signals.HIGHEST_HZ:
            self._unread[f"waves above {signals.HIGHEST_HZ:.0f} Hz"] += 1
            return Shape(np.zeros(0), np.zeros(0))
        shape = self._effect(effect)
        self._spend(shape.keys.time_s.max(initial=0.0), band)
        return signals.wave(shape, low_hz, min(high_hz, signals.HIGHEST_HZ))

    def _wavelet(self, effect: Fields, band: Fields) -> Shape:
        length_s = band.number("block_length", 0.0, most=1e6) / self._timescale
        self._spend(length_s, band)
        self._assumed.append(
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
                remedy=_ANOTHER,
                most_s=MAX_SAMPLES / 1000.0,
            )

    def _effect(self, effect: Fields) -> Effect:
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
                remedy=_ANOTHER,
            )
        return Effect(
            self._begin_s(effect),
            Keyframes(time_s, rows[:, 1], rows[:, 2]),
            effect.number("phase", 0.0, most=1e6),
            effect.text("base_signal", "Sine"),
        )

    def _begin_s(self, effect: Fields) -> float:
        begin_s = effect.number("position", 0.0) / self._timescale
        if not abs(begin_s) <= MAX_SECONDS:
            raise InputError(
                "position lies outside of any clip", where=effect.where, remedy=_ANOTHER
            )
        return begin_s


def _summed(shapes: list[Shape]) -> Shape:
    """Return the sum of the bands of a channel, between -1 and 1."""
    if len(shapes) == 1:
        return Shape(shapes[0].time_s, np.clip(shapes[0].value, -1.0, 1.0))
    if not shapes:
        return Shape(np.zeros(0), np.zeros(0))
    time_s = np.unique(np.concatenate([one.time_s for one in shapes]))
    value = np.sum([np.interp(time_s, *one) for one in shapes], axis=0)
    return Shape(time_s, np.clip(value, -1.0, 1.0))
