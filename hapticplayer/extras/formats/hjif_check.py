"""What the loader of the published reference software says about an hjif file.

Its rules (MPEGGroup/HapticReferenceSoftware, 2de9ff1), but the JSON schema, which is not
public: what it refuses the whole file for, and what it leaves out without a failure.
"""

import re
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple

from hapticplayer.extras.formats.json_fields import Fields, read_crowd

_ROOT = (
    *("version", "profile", "level", "date", "description", "timescale"),
    *("perceptions", "avatars", "syncs"),
)
_PERCEPTION = (
    *("id", "avatar_id", "description", "perception_modality"),
    *("channels", "effect_library"),
)
_CHANNEL = (
    *("id", "description", "gain", "mixing_coefficient", "body_part_mask", "bands"),
)
_BAND = ("band_type", "lower_frequency_limit", "upper_frequency_limit", "effects")
_MODALITIES = (
    *("Other", "Pressure", "Acceleration", "Velocity", "Position", "Temperature"),
    *("Vibration", "Vibrotactile", "Water", "Wind", "Kinesthetic", "Force"),
    *("Vibrotactile Texture", "Stiffness", "Friction", "Electrotactile"),
)
_PARAMETRIC = (
    *("Force", "Kinesthetic", "Vibration", "Vibrotactile", "Stiffness"),
    "Vibrotactile Texture",
)
_BANDS = ("Curve", "Transient", "VectorialWave", "WaveletWave")
_MOST_CHANNELS, _MOST_BANDS = {1: 127, 2: 65535}, {1: 7, 2: 63}
_DATE = re.compile(r"[+-]?[0-9]{4}")


class HjifFinding(NamedTuple):
    """Something that the loader objects to.

    Attributes:
        is_refusal: the file is refused; else a part of it is left out.
        where: place in the file.
        what: is wrong.
    """

    is_refusal: bool
    where: str
    what: str


def check(path: Path) -> list[HjifFinding]:
    """The objections of the loader; nothing if it takes the file as it is.

    Raises:
        InputError: when it is no JSON object.
    """
    return _Checker(Fields.of(read_crowd(path), "file")).findings


class _Checker:
    """Walks through a file as the loader does."""

    def __init__(self, root: Fields) -> None:
        self.findings: list[HjifFinding] = []
        missing = [name for name in _ROOT if name not in root.values]
        if missing:
            self._refuse(root, f"{', '.join(missing)} missing")
            return
        self._profile, self._level = root.values["profile"], root.values["level"]
        self._head(root.values, root)
        self._unique(self._objects(root, "avatars"), "avatar")
        self._avatars = {one.values.get("id") for one in self._objects(root, "avatars")}
        perceptions = self._objects(root, "perceptions")
        self._unique(perceptions, "perception")
        for perception in perceptions:
            if self._has(perception, _PERCEPTION):
                self._perception(perception)

    def _head(self, values: dict[str, Any], root: Fields) -> None:
        version = re.fullmatch(r"(\d{4})(-(\d))?", str(values["version"]))
        amendment = version and version[3]
        if not version or int(version[1]) < 2023 or amendment == "0":
            self._refuse(root, "version must be a year from 2023 on, or year-n")
        if self._profile not in ("Main", "Simple Parametric"):
            self._refuse(root, "profile must be Main or Simple Parametric")
        if self._level not in (1, 2):
            self._refuse(root, "level must be 1 or 2")
        if not _DATE.search(str(values["date"])):
            self._refuse(root, "date must be as in ISO 8601")
        scale = values["timescale"]
        is_whole = isinstance(scale, int) and not isinstance(scale, bool)
        if self._profile == "Simple Parametric" and scale != 1000:
            self._refuse(root, "timescale must be 1000 in Simple Parametric")
        elif not is_whole or not 1 <= scale <= 48000:
            self._refuse(root, "timescale must be between 1 and 48000")

    def _perception(self, one: Fields) -> None:
        values = one.values
        if values["perception_modality"] not in _MODALITIES:
            self._refuse(one, "unknown perception_modality")
        is_narrow = self._profile == "Simple Parametric" and self._level == 1
        if is_narrow and values["perception_modality"] not in _PARAMETRIC:
            self._refuse(one, "modality not allowed in this profile")
        if values["avatar_id"] != 0 and values["avatar_id"] not in self._avatars:
            self._refuse(one, "avatar_id is not the id of an avatar")
        if "effect_semantic_scheme" in values:
            self._refuse(one, "effect_semantic_scheme is always refused")
        devices = self._objects(one, "reference_devices")
        library = self._objects(one, "effect_library")
        channels = self._objects(one, "channels")
        for group, name in (
            (devices, "reference device"),
            (library, "library effect"),
            (channels, "channel"),
        ):
            self._unique(group, name)
        if len(channels) > _MOST_CHANNELS.get(self._level, 65535):
            self._refuse(one, "too many channels for this level")
        device_ids = {device.values.get("id") for device in devices}
        library_ids = {effect.values.get("id") for effect in library}
        for channel in channels:
            if self._has(channel, _CHANNEL):
                self._channel(channel, device_ids, library_ids)

    def _channel(self, one: Fields, devices: set[Any], library: set[Any]) -> None:
        values = one.values
        if values.get("reference_device_id", None) not in {None, *devices}:
            self._refuse(one, "reference_device_id is not the id of a device")
        direction = values.get("direction")
        if isinstance(direction, dict):
            parts = [direction.get(axis) for axis in "XYZ"]
            whole = [part for part in parts if type(part) is int]
            size = sum(part**2 for part in whole) ** 0.5 / 127.0
            if len(whole) != 3:
                self._leave_out(one, "direction must have whole X, Y, Z")
            elif not 0.99 <= size <= 1.01:
                self._refuse(one, "direction must have the length 127")
        bands = self._objects(one, "bands")
        if len(bands) > _MOST_BANDS.get(self._level, 63):
            self._refuse(one, "too many bands for this level")
        for band in bands:
            if self._has(band, _BAND):
                self._band(band, library)

    def _band(self, one: Fields, library: set[Any]) -> None:
        values, kind = one.values, one.values["band_type"]
        if kind not in _BANDS:
            self._refuse(one, "unknown band_type")
        if kind != "Curve" and "curve_type" in values:
            self._refuse(one, "curve_type belongs to Curve bands only")
        if kind == "WaveletWave":
            length = values.get("block_length")
            if type(length) is not int:
                self._leave_out(one, "block_length missing")
            elif length <= 0 or length & (length - 1):
                self._refuse(one, "block_length must be a power of two")
            if self._profile == "Simple Parametric":
                self._refuse(one, "wavelets are not allowed in this profile")
        low, high = (values[f"{end}_frequency_limit"] for end in ("lower", "upper"))
        if not (type(low) is int and type(high) is int):
            self._leave_out(one, "frequency limits must be whole numbers")
        elif high < low:
            self._refuse(one, "the frequency limits are swapped")
        for effect in self._objects(one, "effects"):
            self._effect(effect, kind, library)

    def _effect(self, one: Fields, kind: str, library: set[Any]) -> None:
        values = one.values
        effect_type = values.get("effect_type")
        if effect_type not in ("Basis", "Reference", "Composite"):
            self._leave_out(one, "effect_type missing or unknown")
        elif type(values.get("position")) is not int:
            self._leave_out(one, "position must be a whole number")
        elif effect_type == "Reference" and values.get("id") not in library:
            self._refuse(one, "id is not in the effect_library")
        if kind == "WaveletWave" and values.get("keyframes"):
            self._refuse(one, "keyframes do not belong into wavelet bands")
        if self._profile == "Simple Parametric" and effect_type == "Composite":
            self._refuse(one, "composite effects are not allowed here")

    def _objects(self, one: Fields, name: str) -> list[Fields]:
        """Return the objects of a list; note what is none."""
        found = one.values.get(name, [])
        if not isinstance(found, list):
            self._refuse(one, f"{name} must be a list")
            return []
        fields = []
        for row, value in enumerate(found):
            where = f"{one.where}, {name}[{row}]".removeprefix("file, ")
            if isinstance(value, dict):
                fields.append(Fields(value, where))
            else:
                self._leave_out(Fields({}, where), "is not an object")
        return fields

    def _has(self, one: Fields, names: tuple[str, ...]) -> bool:
        missing = [name for name in names if name not in one.values]
        if missing:
            self._leave_out(one, f"{', '.join(missing)} missing")
        return not missing

    def _unique(self, group: list[Fields], name: str) -> None:
        counts = Counter(repr(one.values.get("id")) for one in group)
        for one in group:
            if counts[repr(one.values.get("id"))] > 1:
                self._refuse(one, f"id of a {name} is not unique")
                return

    def _refuse(self, one: Fields, what: str) -> None:
        self.findings.append(HjifFinding(True, one.where, what))

    def _leave_out(self, one: Fields, what: str) -> None:
        self.findings.append(HjifFinding(False, one.where, what))
