"""Adds force from a file of any format to a sequence, and exports its tracks."""

from dataclasses import replace
from pathlib import Path
from typing import Any

from hapticplayer.errors import Message, Progress, UsageError, entry_named, no_progress
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ForceTrack, rendered_feedback
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.editing import add_track
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    format_of,
    read_force,
    written_formats,
)
from hapticplayer.sequence.milliseconds import goes_on_after
from hapticplayer.sequence.store import motion_of
from hapticplayer.sequence.unpack import require_packed


def import_force(
    folder: Path,
    name: str,
    path: Path,
    *,
    choices: ReadChoices | None = None,
    form: str | None = None,
    progress: Progress = no_progress,
) -> tuple[Message, ...]:
    """Add the force of a file to a sequence, as a new feedback condition.

    Args:
        folder: of the sequence.
        name: of the condition; letters, digits, blanks, dots, hyphens.
        path: of the file.
        choices: what the file may not say.
        form: name of its format; None: by its suffix.
        progress: called while excursions are predicted; raises Cancelled to stop.

    Returns:
        What was assumed, and what was not understood.
    """
    notes: list[Message] = []

    def read(duration_s: float) -> ForceTrack:
        asked = replace(choices or ReadChoices(), until_s=duration_s)
        found = read_force(path, asked, form)
        notes.extend(found.notes)
        if goes_on_after(found.track, duration_s):
            said = Message(
                "the force goes on until {end_s:.3f} s, the clip ends at {clip_s:.3f} s",
                end_s=float(found.track.time_s[-1]),
                clip_s=duration_s,
            )
            notes.append(said)
        return found.track

    add_track(folder, name, read, progress=progress)
    return tuple(notes)


def export_force(
    folder: Path,
    feedback: str | None,
    target: Path,
    form: str,
    *,
    choices: WriteChoices | None = None,
    progress: Progress = no_progress,
) -> dict[str, Any]:
    """Write a force track of a sequence to a file, until the end of the clip.

    Args:
        folder: of the sequence, or a video that it was packed into.
        feedback: name of the track; None for the one that is rendered from the motion.
        target: of the file.
        form: name of its format.
        choices: of the format.
        progress: called before it is written; raises Cancelled to stop.

    Returns:
        Size and largest error, see `export_track`, with `feedback` and `is_estimated`.
    """
    asked = choices or WriteChoices()
    if asked.with_motion and not force_formats()[form].takes_motion:
        raise UsageError(
            "{name} holds no motion; choose one of {known}",
            name=form,
            known=", ".join(
                one.name for one in written_formats().values() if one.takes_motion
            ),
        )
    is_folder = folder.is_dir()
    sequence = open_sequence(folder) if is_folder else require_packed(folder).sequence
    feedback = feedback or rendered_feedback(sequence.tracks)
    track = entry_named(sequence.tracks, feedback, Message("force track"))
    progress(0.0, Message("writing {name}", name=target.name))
    duration_s = probe(sequence.clip).duration_s
    motion = motion_of(sequence) if asked.with_motion else None
    asked = replace(asked, duration_s=duration_s, motion=motion)
    cost = export_track(track, target, format_of(target, form), asked)
    return {"feedback": str(feedback), "is_estimated": track.is_estimated, **cost}
