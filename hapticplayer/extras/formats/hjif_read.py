"""Reads hjif files (ISO/IEC 23090-31), our own and others', as force.

Force amplitudes are newtons by the reference device's `maximum_amplitude`; where a file
gives none, and for Vibrotactile, amplitude 1 is the chosen full scale. Channels without a
direction act along the chosen one.
"""

from pathlib import Path

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.hjif_bands import Bands
from hapticplayer.extras.formats.hjif_signals import EffectCurve
from hapticplayer.extras.formats.json_fields import Fields, read_crowd
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import ForceFile, ReadChoices
from hapticplayer.untrusted import ANOTHER

FORCE = ("Force", "Kinesthetic")
VIBRATION = ("Vibrotactile", "Vibration")


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file."""
    root = Fields.of(read_crowd(path), str(path))
    if "perceptions" not in root.values:
        raise InputError("holds no perceptions", where=str(path), remedy=ANOTHER)
    reader = _ChannelReader(choices, root.number("timescale", 1000.0))
    for perception in root.objects("perceptions"):
        reader.add(perception)
    return reader.result(path)


class _ChannelReader:
    """Collects the channels of a file as polylines with a direction in newtons."""

    def __init__(self, choices: ReadChoices, timescale: float) -> None:
        self._choices, self._bands = choices, Bands(timescale)
        self._parts: list[tuple[Floats, EffectCurve]] = []

    def add(self, perception: Fields) -> None:
        """Add the channels of a perception, or note that it is no force."""
        modality = perception.text("perception_modality", "Other")
        if modality not in FORCE + VIBRATION:
            self._bands.unread[f"perception {modality}"] += 1
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
            shapes = [
                self._bands.shape(band, library) for band in channel.objects("bands")
            ]
            shape = _summed([one for one in shapes if len(one.time_s)])
            if len(shape.time_s):
                self._parts.append((scale_n * self._direction(channel), shape))

    def result(self, path: Path) -> ForceFile:
        """Return all channels as one track."""
        unread = [
            Message("not read: {what} ({count})", what=what, count=count)
            for what, count in self._bands.unread.items()
        ]
        if not self._parts:
            if unread:
                raise InputError(
                    "holds no force that is understood ({first})",
                    where=str(path),
                    remedy=ANOTHER,
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
            raise InputError("ends before 0 s", where=str(path), remedy=ANOTHER)
        refuse_large_force(force_n, str(path), Message("give another full scale"))
        track = ForceTrack(
            time_s[kept],
            force_n[kept].astype(np.float32),
            provenance={"source": path.name, "reader": "hjif"},
        )
        return ForceFile(
            track, tuple(dict.fromkeys(self._bands.assumed)), tuple(unread)
        )

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
        self._bands.assumed.append(
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
            self._bands.assumed.append(
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


def _summed(shapes: list[EffectCurve]) -> EffectCurve:
    """Return the sum of the bands of a channel, between -1 and 1."""
    if len(shapes) == 1:
        return EffectCurve(shapes[0].time_s, np.clip(shapes[0].value, -1.0, 1.0))
    if not shapes:
        return EffectCurve(np.zeros(0), np.zeros(0))
    time_s = np.unique(np.concatenate([one.time_s for one in shapes]))
    value = np.sum([np.interp(time_s, *one) for one in shapes], axis=0)
    return EffectCurve(time_s, np.clip(value, -1.0, 1.0))
