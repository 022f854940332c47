"""Finds what would tell of people and places in a sequence that is shared, and leaves it out."""

import datetime as dt
import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import PurePath
from typing import Any, NamedTuple

from msgspec import structs

from hapticplayer.errors import Message
from hapticplayer.media.opening import open_media
from hapticplayer.media.telemetry import find_telemetry
from hapticplayer.sequence import store
from hapticplayer.sequence.description import Description

_UNTITLED = "Untitled"
_NAMED = "file"
"""In place of a name."""

_NAMES = ("video", "motion_source", "source")
_NUMBERS = ("sensor", "device_id")
_NO_FILE = ("simulated: ", "estimated from the picture")
_DATE_S = 1e8
"""A log's clock that shows more counts from a year, so that it tells the date."""


class Personal(NamedTuple):
    """Something that tells of people or places.

    Attributes:
        text: what it is.
        value: what it says; "" where that is not read.
        is_track: whether it is the camera's own track.
    """

    text: Message
    value: str
    is_track: bool = False


def personal(sequence: store.Sequence) -> tuple[Personal, ...]:
    """What the description of a sequence and its clip hold of people and places."""
    found = dict.fromkeys(_found(sequence.description))
    with open_media(sequence.clip) as container:
        if find_telemetry(container, sequence.clip) is not None:
            found[Personal(_TRACK, "", is_track=True)] = None
    return tuple(found)


def log_zero_s(description: Description) -> float:
    """What a log's clock shows at the begin of the clip where that is a date, or 0."""
    clock = description.clock_map
    zero_s = 0.0 if clock is None else round(-clock.offset_s / clock.rate)
    return zero_s if abs(zero_s) > _DATE_S else 0.0


def shared_names(description: Description) -> dict[str, str]:
    """By the name of a track the one that it is shared under: not that of a file."""
    stems = {PurePath(name).stem for name in _names_in(description)}
    names = dict.fromkeys(description.feedbacks, "")
    for number, name in enumerate(name for name in names if name in stems):
        names[name] = f"imported {number + 1}"
    return {name: new or name for name, new in names.items()}


def without_personal(description: Description) -> Description:
    """A description without names of files, dates and serial numbers."""
    named = _names_in(description)
    stems = {PurePath(name).stem for name in named}
    zero_s = log_zero_s(description)

    def shared(value: Any, key: str = "") -> Any:
        if isinstance(value, dict):
            kept = {k: v for k, v in value.items() if not _is_left(k, v)}
            return {_renamed(k, named): shared(v, k) for k, v in kept.items()}
        if isinstance(value, list | tuple):
            return [shared(one) for one in value]
        if isinstance(value, float) and key == "offset_s" and zero_s:
            return value + zero_s
        if isinstance(value, str):
            return (
                _NAMED if key in _NAMES and value in named else _renamed(value, named)
            )
        return value

    new, clock = shared_names(description), description.clock_map
    tracks = {
        new[name]: structs.replace(one, provenance=shared(one.provenance))
        for name, one in description.feedbacks.items()
    }
    if clock is not None and zero_s:
        offset_s = clock.offset_s + clock.rate * zero_s
        clock = replace(clock, offset_s=offset_s)
    return structs.replace(
        description,
        title=_UNTITLED if description.title in stems else description.title,
        feedbacks=tracks,
        clock_map=clock,
        provenance=shared(description.provenance),
    )


def _names_in(description: Description) -> set[str]:
    return {one.value for one in _texts_of(description) if one.text == _FILE}


def _renamed(text: str, named: Iterable[str]) -> str:
    """A text without names of files, of which a folder's may be any word."""
    for name in sorted(named, key=len, reverse=True):
        if text != name or "." in name:
            # not where a text of the program takes a value, as in {name}
            text = re.sub(rf"(?<![\w{{]){re.escape(name)}(?!\w)", _NAMED, text)
    return text


_TRACK = Message(
    "motion track of the camera, which may hold places (only an MP4 has it)"
)
_FILE = Message("name of a file")
_CALLED = Message("name of a track, from a file")
_DATE = Message("date")
_NUMBER = Message("name or number of a device")


def _found(description: Description) -> Iterator[Personal]:
    yield from _texts_of(description)
    for name, new in shared_names(description).items():
        if new != name:
            yield Personal(_CALLED, name)
    if zero_s := log_zero_s(description):
        yield Personal(_DATE, _utc(zero_s))


def _utc(seconds: float) -> str:
    try:
        return dt.datetime.fromtimestamp(seconds, dt.UTC).isoformat()
    except (ValueError, OverflowError):  # a clock that counts from another year
        return f"{seconds:.0f} s"


def _texts_of(description: Description) -> Iterator[Personal]:
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
    elif isinstance(value, str | int) and (text := _kind(key, str(value))):
        yield Personal(text, str(value))


def _kind(key: str, value: str) -> Message | None:
    if key in _NAMES and value not in ("", _NAMED):
        return None if value.startswith(_NO_FILE) else _FILE
    if key.endswith("_utc") or key == "date":
        return _DATE
    return _NUMBER if "serial" in key.lower() or key in _NUMBERS else None


def _is_left(key: str, value: Any) -> bool:
    return isinstance(value, str | int) and _kind(key, str(value)) in {_DATE, _NUMBER}
