"""Shares a sequence in one video file, with its force as hjif for other programs."""

import io
from pathlib import Path

from hapticplayer.errors import InputError, Message, Progress, no_progress
from hapticplayer.interchange import hjif
from hapticplayer.interchange.force_files import WriteChoices
from hapticplayer.media.matroska import Attachment
from hapticplayer.media.remux import VideoDigest
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.contents import Contents, attachment_of, contents
from hapticplayer.sequence.pack import pack
from hapticplayer.storage import IsOurs

NAME = "force_realistic.hjif"
ESTIMATED_NAME = "force_estimated.hjif"


def force_for_others(folder: Path) -> tuple[Attachment, ...]:
    """Return the rendered force as hjif; nothing if it does not fit that format.

    Raises:
        SequenceError: when the sequence is damaged.
    """
    sequence = open_sequence(folder)
    track = sequence.rendered
    duration_s = float(sequence.description["clip"]["duration_s"])
    out = io.BytesIO()
    try:
        hjif.write(track, out, WriteChoices(duration_s=duration_s))
    except InputError:
        return ()  # the list of contents shows that it is not there
    name = ESTIMATED_NAME if track.is_estimated else NAME
    return (attachment_of(name, out.getvalue()),)


def shared_contents(
    folder: Path,
    *,
    with_motion: bool = False,
    progress: Progress = no_progress,
) -> Contents:
    """The contents that `share` would write; see `sequence.contents.contents`."""
    progress(0.0, Message("writing {name}", name=NAME))
    return contents(folder, with_motion=with_motion, extras=force_for_others(folder))


def share(
    folder: Path,
    target: Path,
    *,
    with_motion: bool = False,
    is_ours: IsOurs | None = None,
    progress: Progress = no_progress,
) -> VideoDigest:
    """Write a sequence as one video file with its force; see `sequence.pack.pack`."""
    progress(0.0, Message("writing {name}", name=NAME))
    return pack(
        folder,
        target,
        with_motion=with_motion,
        extras=force_for_others(folder),
        is_ours=is_ours,
        progress=progress,
    )
