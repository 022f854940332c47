"""What an editor shows of a sequence besides its tracks: events, effects, loudness.

Events are found by detectors of extensions; none is applied by itself.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from hapticplayer import extension
from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.capture.sync.synchronize import read_sound
from hapticplayer.errors import (
    HapticPlayerError,
    Message,
    Progress,
    entry_named,
    message_of,
    no_progress,
)
from hapticplayer.model import ForceTrack
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence import store
from hapticplayer.sequence.figures import ForceFigures, force_figures
from hapticplayer.sequence.import_preview import Curve, loudness_of

LEAST_EFFECT_S = 0.001


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happens in a recording.

    Attributes:
        kind: name of its detector.
        start_s, end_s: media time.
        confidence: 0 to 1; at least 0.5, as what is less is not offered.
        text: a sentence for people.
        effect: what may be made of it; nothing is applied by itself.
    """

    kind: str
    start_s: float
    end_s: float
    confidence: float
    text: Message
    effect: Effect

    def within(self, end_s: float) -> "Event":
        """It without what lies before 0 or after the end of a clip.

        The effect keeps a millisecond at least, also where it would begin after the end.
        """
        effect = self.effect
        first_s = min(effect.start_s, max(0.0, end_s - LEAST_EFFECT_S))
        last_s = min(max(effect.end_s, first_s + LEAST_EFFECT_S), end_s)
        most_s = 0.5 * (last_s - first_s)
        cut = replace(
            effect,
            start_s=first_s,
            end_s=last_s,
            fade_in_s=min(effect.fade_in_s, most_s),
            fade_out_s=min(effect.fade_out_s, most_s),
        )
        start_s, stop_s = max(self.start_s, 0.0), min(self.end_s, end_s)
        return replace(self, start_s=start_s, end_s=stop_s, effect=cut)


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


@dataclass(frozen=True, slots=True, eq=False)
class TimeLine:
    """Effects, events and sound of a sequence, in media time.

    Attributes:
        effects: that the sequence has.
        events: found in its motion; none where `problem` says why.
        loudness: times (N,) in s and values (N,); empty without sound.
        problem: why there are no events, or "".
    """

    effects: EffectList
    events: tuple[Event, ...]
    loudness: Curve
    problem: Message | str = ""


def time_line_of(folder: Path, *, progress: Progress = no_progress) -> TimeLine:
    """Return the timeline of a sequence whose force can be rendered again.

    Args:
        folder: of the sequence.
        progress: called between the steps; raises Cancelled to stop.
    """
    progress(0.0, Message("reading the sequence"))
    sequence = store.open_sequence(folder)
    store.motion_of(sequence)
    effects = store.effects_of(sequence)
    progress(0.2, Message("reading the sound"))
    silence, has_audio = (np.zeros(0),) * 2, sequence.description.clip.has_audio
    loudness = loudness_of(sequence.clip) if has_audio else silence
    progress(0.5, Message("finding events"))
    try:
        return TimeLine(effects, events_of(folder), loudness)
    except HapticPlayerError as problem:  # the effects can be edited all the same
        return TimeLine(effects, (), loudness, message_of(problem))


def figures_of(
    tracks: Sequence[ForceTrack],
    duration_s: float,
    force_limit_n: float,
    *,
    progress: Progress = no_progress,
) -> list[ForceFigures]:
    """Return the figures of tracks; see `force_figures`, arguments as there."""
    found = []
    for number, track in enumerate(tracks):

        def report(share: float, done: int = number) -> None:
            step = Message("predicting excursions")
            progress((done + share) / len(tracks), step)

        found.append(force_figures(track, duration_s, force_limit_n, progress=report))
    return found
