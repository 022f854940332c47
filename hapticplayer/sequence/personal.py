"""Finds what would tell of people and places in a sequence that is shared, and leaves it out."""

from collections.abc import Iterator
from pathlib import PurePath
from typing import Any, NamedTuple

from msgspec import structs

from hapticplayer.errors import Message
from hapticplayer.media.opening import open_media
from hapticplayer.media.telemetry import find_telemetry
from hapticplayer.sequence import store
from hapticplayer.sequence.description import Description

_UNTITLED = "Untitled"
_NAMES = ("video", "motion_source", "source")
_NUMBERS = ("sensor", "device_id")


class Personal(NamedTuple):
    """Something that tells of people or places.

    Attributes:
        text: what it is.
        value: what it says; "" where that is not read.
    """

    text: Message
    value: str


def personal(sequence: store.Sequence) -> tuple[Personal, ...]:
    """What the description of a sequence and its clip hold of people and places."""
    found = dict.fromkeys(_found(sequence.description))
    with open_media(sequence.clip) as container:
        if find_telemetry(container) is not None:
            found[Personal(_TRACK, "")] = None
    return tuple(found)


def without_personal(description: Description) -> Description:
    """A description without names of files, dates and serial numbers."""
    named = {one.value for one in _found(description) if one.text == _FILE}
    stems = {PurePath(name).stem for name in named}

    def shared(value: Any) -> Any:
        if isinstance(value, dict):
            return {
                shared(k): shared(v) for k, v in value.items() if not _is_left(k, v)
            }
        if isinstance(value, list | tuple):
            return [shared(one) for one in value]
        if isinstance(value, str):
            for name in sorted(named, key=len, reverse=True):
                value = value.replace(name, f"file{PurePath(name).suffix}")
        return value

    tracks = {
        name: structs.replace(one, provenance=shared(one.provenance))
        for name, one in description.feedbacks.items()
    }
    return structs.replace(
        description,
        title=_UNTITLED if description.title in stems else description.title,
        feedbacks=tracks,
        provenance=shared(description.provenance),
    )


_TRACK = Message(
    "motion track of the camera, which may hold places (only an MP4 has it)"
)
_FILE = Message("name of a file")
_DATE = Message("date")
_NUMBER = Message("name or number of a device")


def _found(description: Description) -> Iterator[Personal]:
    yield from _texts(description.provenance)
    for one in description.feedbacks.values():
        yield from _texts(one.provenance)


def _texts(value: Any, key: str = "") -> Iterator[Personal]:
    if isinstance(value, dict):
        for name, one in value.items():
            yield from _texts(one, name)
    elif isinstance(value, list | tuple):
        for one in value:
            yield from _texts(one, key)
    elif isinstance(value, str) and (text := _kind(key, value)):
        yield Personal(text, value)


def _kind(key: str, value: str) -> Message | None:
    if key in _NAMES and PurePath(value).suffix:
        return _FILE
    if key.endswith("_utc") or key == "date":
        return _DATE
    return _NUMBER if "serial" in key.lower() or key in _NUMBERS else None


def _is_left(key: str, value: Any) -> bool:
    return isinstance(value, str) and _kind(key, value) in {_DATE, _NUMBER}
