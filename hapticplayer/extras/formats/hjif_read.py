"""Reads hjif files (ISO/IEC 23090-31), our own and others', as force.

Force amplitudes are newtons by the reference device's `maximum_amplitude`; where a file
gives none, and for Vibrotactile, amplitude 1 is the chosen full scale. Channels without a
direction act along the chosen one. What `Other` is, the published encoder's modality for
sound and AHAP, is chosen too.
"""

from collections import Counter
from pathlib import Path

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.hjif_bands import Bands
from hapticplayer.extras.formats.hjif_file import (
    Device,
    HjifChannel,
    Perception,
    content_of,
)
from hapticplayer.extras.formats.hjif_signals import (
    BEFORE_ZERO,
    STEP_S,
    EffectCurve,
    from_zero,
)
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import (
    ASK,
    Direction,
    ForceFile,
    ForceQuestion,
    ReadChoices,
)
from hapticplayer.untrusted import ANOTHER

FORCE = ("Force", "Kinesthetic")
VIBRATION = ("Vibrotactile", "Vibration")
_OTHER = "Other"
_ROUNDED = 1e-6
_MEANT = {"force": FORCE[0], "vibration": VIBRATION[0]}


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file."""
    found, unread = content_of(path)
    modalities = {one.perception_modality for one in found.perceptions}
    if _OTHER in modalities and choices.other_is == ASK:
        raise ForceQuestion(str(path), not modalities.isdisjoint(FORCE + VIBRATION))
    reader = _ChannelReader(choices, found.timescale, unread)
    for row, perception in enumerate(found.perceptions):
        reader.add(perception, f"{path}, perceptions[{row}]")
    return reader.result(path)


class _ChannelReader:
    """Collects the channels of a file as polylines with a direction in newtons."""

    def __init__(
        self, choices: ReadChoices, timescale: float, unread: Counter[str]
    ) -> None:
        self._choices, self._bands = choices, Bands(timescale, unread)
        self._parts: list[tuple[Floats, EffectCurve]] = []
        self._masks: set[float] = set()

    def add(self, perception: Perception, where: str) -> None:
        """Add the channels of a perception, or note that it is no force."""
        modality = self._modality(perception.perception_modality)
        if modality not in FORCE + VIBRATION:
            self._bands.unread[f"perception {modality[:40]}"] += 1
            return
        library = {one.id: one for one in perception.effect_library}
        devices = {one.id: one for one in perception.reference_devices}
        unit = 10.0**perception.perception_unit_exponent
        for row, channel in enumerate(perception.channels):
            self._bands.where = f"{where}.channels[{row}]"
            scale_n = self._scale_n(channel, modality, devices) * unit
            if channel.mixing_coefficient != 1.0:
                self._bands.unread["mixing_coefficient"] += 1
            shapes = [self._bands.shape(band, library) for band in channel.bands]
            shape = self._summed([one for one in shapes if len(one.time_s)])
            if len(shape.time_s):
                self._masks.add(channel.body_part_mask)
                self._parts.append((scale_n * self._direction(channel), shape))

    def _modality(self, name: str) -> str:
        if name != _OTHER:
            return name
        meant = _MEANT.get(self._choices.take("other_is"))
        if meant is None:
            return name
        said = Message("{name} was taken as {modality}", name=name, modality=meant)
        self._bands.assumed.append(said)
        return meant

    def result(self, path: Path) -> ForceFile:
        """Return all channels as one track."""
        unread = [
            Message("not read: {what} ({count})", what=what, count=count)
            for what, count in self._bands.unread.items()
        ]
        if len(self._masks) > 1:
            said = Message(
                "channels for {count} parts of the body act on one hand",
                count=len(self._masks),
            )
            self._bands.assumed.append(said)
        if not self._parts:
            if unread:
                raise self._nothing(path, unread[0])
            time_s, force_n = np.zeros(1), np.zeros((1, 3))
        else:
            time_s = np.unique(np.concatenate([s.time_s for _, s in self._parts]))
            force_n = np.zeros((len(time_s), 3))
            for vector_n, shape in self._parts:
                force_n += np.interp(time_s, *shape)[:, None] * vector_n
        if time_s[0] < -2.0 * STEP_S:  # more than the jump of what begins at 0
            unread.append(BEFORE_ZERO)
        time_s, force_n = from_zero(time_s, force_n, str(path))
        refuse_large_force(force_n, str(path), Message("give another full scale"))
        track = ForceTrack(
            time_s,
            force_n.astype(np.float32),
            provenance={"source": path.name, "reader": "hjif"},
        )
        return ForceFile(
            track, tuple(dict.fromkeys(self._bands.assumed)), tuple(unread)
        )

    def _nothing(self, path: Path, first: Message) -> InputError:
        is_other = f"perception {_OTHER}" in self._bands.unread
        say = Message("say what it is (--other-is force, --other-is vibration)")
        return InputError(
            "holds no force that is understood ({first})",
            where=str(path),
            remedy=say if is_other else ANOTHER,
            first=first,
        )

    def _scale_n(
        self, channel: HjifChannel, modality: str, devices: dict[float, Device]
    ) -> float:
        number = channel.reference_device_id
        device = devices.get(-1.0 if number is None else number)
        if device is None and devices:
            device = next(iter(devices.values()))
            if number is not None:
                said = Message(
                    "reference device {number:g} is not in the file; the first was taken",
                    number=number,
                )
                self._bands.assumed.append(said)
            elif len(devices) > 1:
                said = Message(
                    "of {count} reference devices the first was taken",
                    count=len(devices),
                )
                self._bands.assumed.append(said)
        if modality in FORCE and device and device.maximum_amplitude is not None:
            return channel.gain * device.maximum_amplitude
        full_n: float = self._choices.take("full_scale_n")
        self._bands.assumed.append(
            Message(
                "{modality}: amplitude 1 was taken as {full_n:.3g} N",
                modality=modality,
                full_n=full_n,
            )
        )
        return channel.gain * full_n

    def _direction(self, channel: HjifChannel) -> Floats:
        given = channel.direction
        vector = np.array([given.X, given.Y, given.Z] if given else np.zeros(3))
        size = float(np.linalg.norm(vector))
        if size:
            return np.asarray(vector / size)
        chosen: Direction = self._choices.take("direction")
        none = Message("no direction in the file: x {x:.2f}, y {y:.2f}, z {z:.2f}")
        empty = Message(
            "a direction of length 0 was taken as x {x:.2f}, y {y:.2f}, z {z:.2f}"
        )
        text = (empty if given else none).template
        self._bands.assumed.append(
            Message(text, **dict(zip("xyz", chosen, strict=True)))
        )
        return np.array(chosen)

    def _summed(self, shapes: list[EffectCurve]) -> EffectCurve:
        """Return the sum of the bands of a channel, between -1 and 1."""
        if not shapes:
            return EffectCurve(np.zeros(0), np.zeros(0))
        time_s = np.unique(np.concatenate([one.time_s for one in shapes]))
        value = np.sum([np.interp(time_s, *one) for one in shapes], axis=0)
        if np.abs(value).max() > 1.0 + _ROUNDED:
            said = Message("amplitudes beyond 1 were limited")
            self._bands.assumed.append(said)
        return EffectCurve(time_s, np.clip(value, -1.0, 1.0))
