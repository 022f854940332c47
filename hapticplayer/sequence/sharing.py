"""Shares a sequence in one video file, with its force for other programs."""

from pathlib import Path
from typing import NamedTuple

from hapticplayer import extension
from hapticplayer.errors import InputError, Message, Progress, no_progress
from hapticplayer.media.identity import VideoDigest
from hapticplayer.media.matroska import Attachment
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.contents import Contents, attachment_of, contents
from hapticplayer.sequence.pack import pack
from hapticplayer.storage import IsOurs


class ForceAttachment(NamedTuple):
    """A file with the force of a sequence, for other programs.

    Attributes:
        name: of its format.
        home: "module:function", called with the sequence, returns name and content;
            raises InputError where the force does not fit the format.
    """

    name: str
    home: str


def force_for_others(folder: Path) -> tuple[Attachment, ...]:
    """The rendered force in each format that it fits."""
    sequence = open_sequence(folder)
    found = []
    for row in extension.rows("attachments", ForceAttachment):
        try:
            found.append(attachment_of(*extension.load(row.home)(sequence)))
        except InputError:
            continue  # the list of contents shows that it is not there
    return tuple(found)


def shared_contents(
    folder: Path,
    *,
    with_motion: bool = False,
    with_places: bool = False,
    progress: Progress = no_progress,
) -> Contents:
    """The contents that `share` would write; see `sequence.contents.contents`."""
    progress(0.0, Message("writing the force for other programs"))
    return contents(
        folder,
        with_motion=with_motion,
        with_places=with_places,
        extras=force_for_others(folder),
    )


def share(
    folder: Path,
    target: Path,
    *,
    with_motion: bool = False,
    with_places: bool = False,
    is_ours: IsOurs | None = None,
    progress: Progress = no_progress,
) -> VideoDigest:
    """Write a sequence as one video file with its force; see `sequence.pack.pack`."""
    progress(0.0, Message("writing the force for other programs"))
    return pack(
        folder,
        target,
        with_motion=with_motion,
        with_places=with_places,
        extras=force_for_others(folder),
        is_ours=is_ours,
        progress=progress,
    )
