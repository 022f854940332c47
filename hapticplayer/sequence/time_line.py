"""What an editor shows of a sequence besides its tracks: effects, events, loudness."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from hapticplayer.errors import (
    HapticPlayerError,
    Message,
    Progress,
    message_of,
    no_progress,
)
from hapticplayer.model import ForceTrack
from hapticplayer.rendering.effects import EffectList
from hapticplayer.rendering.event import Event
from hapticplayer.sequence import store
from hapticplayer.sequence.events import events_of
from hapticplayer.sequence.figures import ForceFigures, force_figures
from hapticplayer.sequence.import_preview import Curve, loudness_of


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
    """Return the time line of a sequence whose force can be rendered again.

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
