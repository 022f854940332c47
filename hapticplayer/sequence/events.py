"""The events of a sequence, found by detectors of extensions; none is applied by itself."""

from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

from hapticplayer import extension
from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.capture.sync.synchronize import read_sound
from hapticplayer.errors import Message, entry_named
from hapticplayer.rendering.event import Event
from hapticplayer.sequence import store


class EventDetector(NamedTuple):
    """Finds one kind of events.

    Attributes:
        name: of the kind.
        title: for people, a word.
        text: for people, what is found.
        find: "module:function" of motion and log in media time, the clip's sound (the
            last two may be None), and the kinds that are wanted; asked once for all
            rows that name it.
    """

    name: str
    title: Message
    text: Message
    find: str


def event_detectors() -> dict[str, EventDetector]:
    """Those of extensions, by name."""
    return {one.name: one for one in extension.rows("event_detectors", EventDetector)}


def events_of(
    folder: str | Path,
    *,
    kinds: Collection[str] | None = None,
    with_sound: bool = True,
) -> tuple[Event, ...]:
    """The events of a sequence that lie in its clip, by their start.

    Args:
        folder: of the sequence.
        kinds: names of detectors; all if None.
        with_sound: whether the sound confirms impacts, if the clip has any.
    """
    known = event_detectors()
    wanted: dict[str, list[str]] = {}
    for kind in known if kinds is None else kinds:
        row = entry_named(known, kind, Message("kind of event"))
        wanted.setdefault(row.find, []).append(kind)
    if not wanted:
        return ()
    sequence = store.open_sequence(folder)
    sound = sound_of(sequence) if with_sound else None
    has_log = store.IMU in sequence.description.files
    imu = store.recorded_log(sequence) if has_log else None
    motion, end_s = store.motion_of(sequence), sequence.duration_s
    events = [
        event.within(end_s)
        for find, names in wanted.items()
        for event in extension.load(find)(motion, imu, sound, names)
        if event.end_s > 0.0 and event.start_s < end_s
    ]
    return tuple(sorted(events, key=lambda one: (one.start_s, one.end_s)))


def sound_of(sequence: store.Sequence) -> ClipSound | None:
    """The sound of a sequence; None without sound."""
    has_audio = sequence.description.clip.has_audio
    return read_sound(sequence.clip) if has_audio else None
