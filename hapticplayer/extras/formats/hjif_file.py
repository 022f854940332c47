"""The entries of an hjif file that are read, as typed structures."""

from pathlib import Path
from typing import Annotated, Any

from msgspec import Meta, Struct

from hapticplayer.errors import InputError
from hapticplayer.structures import convert, read_json
from hapticplayer.untrusted import ANOTHER

MAX_BYTES = 96 << 20
"""Of JSON that others wrote."""

Number = Annotated[float, Meta(ge=-1e12, le=1e12)]
Factor = Annotated[float, Meta(ge=-1e6, le=1e6)]


class Keyframe(Struct, gc=False):
    """A corner of a curve, or a transient."""

    relative_position: Number | None = None
    amplitude_modulation: Number | None = None
    frequency_modulation: Number | None = None


class EffectEntry(Struct):
    """Of a band, or of the library."""

    effect_type: str = "Basis"
    id: Number = -1.0
    position: Number = 0.0
    phase: Factor = 0.0
    base_signal: str = "Sine"
    keyframes: list[Keyframe] = []
    wavelet_stream: str = ""


class HjifBand(Struct):
    """Effects of one kind."""

    band_type: str
    curve_type: str = "Unknown"
    lower_frequency_limit: Number = 0.0
    upper_frequency_limit: Number | None = None
    block_length: Factor = 0.0
    effects: list[EffectEntry] = []


class Vector(Struct):
    """A direction in frame D, of any length."""

    X: Annotated[float, Meta(ge=-1e3, le=1e3)] = 0.0
    Y: Annotated[float, Meta(ge=-1e3, le=1e3)] = 0.0
    Z: Annotated[float, Meta(ge=-1e3, le=1e3)] = 0.0


class HjifChannel(Struct):
    """Bands that act along one direction."""

    gain: Factor = 1.0
    mixing_coefficient: Factor = 1.0
    reference_device_id: Number | None = None
    direction: Vector | None = None
    body_part_mask: Number = 0.0
    bands: list[HjifBand] = []


class Device(Struct):
    """What amplitudes refer to."""

    id: Number = 0.0
    maximum_amplitude: Factor | None = None


class Perception(Struct):
    """Channels of one modality."""

    perception_modality: str = "Other"
    perception_unit_exponent: Annotated[float, Meta(ge=-9.0, le=9.0)] = 0.0
    reference_devices: list[Device] = []
    effect_library: list[EffectEntry] = []
    channels: list[HjifChannel] = []


class Experience(Struct):
    """A file."""

    perceptions: list[Perception]
    timescale: Annotated[float, Meta(ge=1.0, le=1e12)] = 1000.0


def experience(path: Path) -> Experience:
    """The content of a file; what is null in it counts as absent."""
    given = read_json(path, dict[str, Any], InputError, ANOTHER, MAX_BYTES)
    try:
        return convert(given, Experience, str(path), InputError, ANOTHER)
    except InputError:
        plain = _without_null(given)
        return convert(plain, Experience, str(path), InputError, ANOTHER, strict=False)


def _without_null(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: _without_null(v) for k, v in value.items() if v is not None}
    if isinstance(value, list):
        return [_without_null(one) for one in value]
    return value
