"""The entries of an hjif file that are read, as typed structures."""

from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Annotated, Any, NamedTuple, get_args, get_type_hints

from msgspec import Meta, Struct

from hapticplayer.errors import InputError
from hapticplayer.structures import convert, read_json
from hapticplayer.untrusted import ANOTHER

MAX_BYTES = 96 << 20
"""Of JSON that others wrote."""

_DESCRIPTIVE = frozenset(
    (
        *("version", "profile", "level", "date", "description", "name", "id"),
        *("avatars", "avatar_id", "semantic", "effect_semantic_scheme"),
        *("frequency_sampling", "sample_count"),
    )
)
"""Entries that change no force; so does whatever describes a reference device."""

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


class HjifContent(NamedTuple):
    """A file.

    Attributes:
        experience: what is read of it.
        unread: how often each other entry is there that may change the force.
    """

    experience: Experience
    unread: Counter[str]


def content_of(path: Path) -> HjifContent:
    """The content of a file; what is null in it counts as absent."""
    given = read_json(path, dict[str, Any], InputError, ANOTHER, MAX_BYTES)
    try:
        found = convert(given, Experience, str(path), InputError, ANOTHER)
    except InputError:
        given = _without_null(given)
        found = convert(given, Experience, str(path), InputError, ANOTHER, strict=False)
    return HjifContent(found, Counter(_unread(given, Experience)))


def _unread(given: dict[str, Any], kind: type[Struct]) -> Iterator[str]:
    """Yield the names of entries that are not those of their structures."""
    others = given.keys() - set(kind.__struct_fields__)
    if kind is not Device:
        yield from (name[:40] for name in others - _DESCRIPTIVE if given[name])
    for name, inner in _inner_kinds(kind).items():
        entries = given.get(name) or []
        for entry in entries if isinstance(entries, list) else [entries]:
            yield from _unread(entry, inner)


@cache
def _inner_kinds(kind: type[Struct]) -> dict[str, type[Struct]]:
    """The structures within a structure, by their names."""
    hints = get_type_hints(kind).items()
    inner = {name: (*get_args(hint), hint)[0] for name, hint in hints}
    return {
        name: one
        for name, one in inner.items()
        if isinstance(one, type) and issubclass(one, Struct)
    }


def _without_null(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: _without_null(v) for k, v in value.items() if v is not None}
    if isinstance(value, list):
        return [_without_null(one) for one in value]
    return value
