"""The files that are packed with the video of a sequence, and a description for people."""

import hashlib
import io
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
from msgspec import structs

from hapticplayer import storage
from hapticplayer.errors import Message, SequenceError
from hapticplayer.media.matroska import Attachment
from hapticplayer.model import Feedback
from hapticplayer.sequence import store
from hapticplayer.sequence.arrays import arrays_in
from hapticplayer.sequence.description import FileEntry, written
from hapticplayer.sequence.packed import MANIFEST, Packed, refuse_twins
from hapticplayer.sequence.personal import (
    Personal,
    log_zero_s,
    personal,
    shared_names,
    without_personal,
)
from hapticplayer.untrusted import MAX_ATTACHED_BYTES, read_regular, without_controls

MOTION_FILES = (store.MOTION, store.IMU, "truth.npz", "estimate.npz")
"""What is shared only where that is asked for."""

_MEDIA_TYPES = {".json": "application/json", ".hjif": "haptics/hjif"}
_OTHER_TYPE = "application/octet-stream"
_TEXTS = (
    (MANIFEST, Message("contents and checksums")),
    (store.DESCRIPTION, Message("title, mapping and provenance")),
    (store.MOTION, Message("motion without gravity")),
    (store.IMU, Message("recorded samples")),
    ("truth.npz", Message("true motion of a simulation")),
    ("estimate.npz", Message("sigma and trust of an estimated motion")),
    ("effects", Message("effects")),
    ("force_realistic", Message("force of the feedback realistic, lossless")),
    ("force_random", Message("force of the feedback random, lossless")),
    ("force_", Message("force, lossless")),
)


class Part(NamedTuple):
    """A part of what is shared: its name, what it is, media type and size."""

    name: str
    text: str
    media_type: str
    size_bytes: int


@dataclass(frozen=True, slots=True)
class Contents:
    """What a file for sharing holds.

    Attributes:
        title: of the sequence.
        feedbacks: names of the force tracks.
        video: the clip; its size is that of the file, which no longer holds the rest.
        attached: the files with it.
        has_motion: whether the motion is among them.
        personal: what the sequence holds of people and places.
        with_places: whether that goes along.
    """

    title: str
    feedbacks: tuple[str, ...]
    video: Part
    attached: tuple[Part, ...]
    has_motion: bool
    personal: tuple[Personal, ...] = ()
    with_places: bool = False

    def told(self, *, with_track: bool) -> tuple[tuple[Personal, bool], ...]:
        """What tells of people and places, and whether it goes along.

        Args:
            with_track: whether the file has a place for the camera's own track.
        """
        along, track = self.with_places, with_track and self.has_motion
        return tuple(
            (one, along and (track or not one.is_track)) for one in self.personal
        )

    @property
    def size_bytes(self) -> int:
        """Of everything together."""
        return self.video.size_bytes + sum(part.size_bytes for part in self.attached)


def contents(
    folder: Path,
    *,
    with_motion: bool = False,
    with_places: bool = False,
    extras: Iterable[Attachment] = (),
) -> Contents:
    """The contents that `pack` would write of a sequence; nothing is written."""
    sequence = store.open_sequence(folder)
    files = files_to_pack(
        sequence, extras, with_motion=with_motion, with_places=with_places
    )
    told = personal(sequence)
    if not with_places:
        names = shared_names(sequence.description)
        described = without_personal(sequence.description)
        tracks = {names.get(k, k): one for k, one in sequence.tracks.items()}
        sequence = replace(
            sequence, title=described.title, description=described, tracks=tracks
        )
    found = _contents(sequence, files)
    return replace(found, personal=told, with_places=with_places)


def contents_of(packed: Packed) -> Contents:
    """The contents of a packed file."""
    attached = packed.attached.values()
    is_inside = packed.carrier == packed.sequence.clip
    inside_bytes = sum(len(one.content) for one in attached) if is_inside else 0
    return _contents(packed.sequence, attached, inside_bytes)


def files_to_pack(
    sequence: store.Sequence,
    extras: Iterable[Attachment],
    *,
    with_motion: bool,
    with_places: bool,
) -> tuple[Attachment, ...]:
    """Return the description and the files of a sequence that are packed with its clip."""
    description = sequence.description
    names = [
        name
        for name in description.files
        if name != sequence.clip.name and (with_motion or name not in MOTION_FILES)
    ]
    small = {name: _content(sequence, name) for name in names}
    kept = {*names, sequence.clip.name}
    listed = {k: one for k, one in description.files.items() if k in kept}
    if not with_places:
        zero_s = log_zero_s(description)
        if zero_s and store.IMU in small:
            small[store.IMU] = _from_zero(small[store.IMU], zero_s)
            listed[store.IMU] = _entry_of(small[store.IMU])
    described = structs.replace(description, files=listed)
    if not with_places:
        described = without_personal(described)
    text = storage.json_text(written(described))
    own = (attachment_of(name, content) for name, content in small.items())
    made = (attachment_of(store.DESCRIPTION, text), *own, *extras)
    refuse_twins([MANIFEST, *(one.name for one in made)], sequence.folder)
    if sum(len(one.content) for one in made) > MAX_ATTACHED_BYTES:
        raise SequenceError(
            "has more than {most_mb} MB of force and motion, which is too much for one "
            "file",
            where=str(sequence.folder),
            remedy="share it without the motion, or copy its folder",
            most_mb=MAX_ATTACHED_BYTES >> 20,
        )
    return made


def _content(sequence: store.Sequence, name: str) -> bytes:
    path = store.checked(sequence.folder, name, sequence.description.files)
    return read_regular(path, MAX_ATTACHED_BYTES, SequenceError)


def _from_zero(content: bytes, zero_s: float) -> bytes:
    """The samples of a log whose clock shows a date, from the begin of the clip on."""
    arrays = arrays_in(io.BytesIO(content), store.IMU)
    arrays["time_s"] = arrays["time_s"] - zero_s
    made = io.BytesIO()
    np.savez(made, allow_pickle=False, **arrays)
    return made.getvalue()


def _entry_of(content: bytes) -> FileEntry:
    return FileEntry(len(content), hashlib.sha256(content).hexdigest())


def attachment_of(name: str, content: bytes) -> Attachment:
    return Attachment(name, _MEDIA_TYPES.get(Path(name).suffix, _OTHER_TYPE), content)


def _contents(
    sequence: store.Sequence, attached: Iterable[Attachment], inside_bytes: int = 0
) -> Contents:
    added = {
        one.file: name
        for name, one in sequence.description.feedbacks.items()
        if one.file and name not in tuple(Feedback)
    }
    parts = tuple(
        Part(
            without_controls(one.name),
            _text_of(one.name, added.get(one.name)),
            one.media_type,
            len(one.content),
        )
        for one in attached
    )
    clip = sequence.clip
    video = Part(
        clip.name, Message("video and sound"), "", clip.stat().st_size - inside_bytes
    )
    has_motion = any(part.name == store.MOTION for part in parts)
    return Contents(
        sequence.title, tuple(map(str, sequence.tracks)), video, parts, has_motion
    )


def _text_of(name: str, feedback: str | None) -> str:
    """The description of a file; of an added track, whose file has a number, with its name."""
    if feedback is not None:
        return Message("force of the feedback {name}, lossless", name=feedback)
    if name.endswith(".hjif"):
        return Message("force for other programs")
    return next((text for begin, text in _TEXTS if name.startswith(begin)), "")
