"""Reads a sequence that travels with its video: in one Matroska file, or beside an MP4.

Everything in it is untrusted: files are found by name, compared with the size and checksum
that the manifest gives, and read without pickle. The checksum of the video says whether
the force belongs to it; `playback` takes it while it prepares to play.
"""

import hashlib
import io
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from msgspec import Struct
from numpy.typing import NDArray

from hapticplayer.errors import MediaError, Message, SequenceError
from hapticplayer.media.clip_bytes import ClipBytes, path_of
from hapticplayer.media.identity import VideoDigest
from hapticplayer.media.matroska import Attachment, read_attachments
from hapticplayer.sequence import store
from hapticplayer.sequence.arrays import arrays_in
from hapticplayer.sequence.description import (
    Description,
    FileEntry,
    checked_description,
)
from hapticplayer.structures import check_schema, convert, decode
from hapticplayer.untrusted import MAX_ATTACHED_BYTES

MANIFEST = "hapticplayer.json"
SCHEMA, VERSION = "hapticplayer.pack", 1
SIDE_CAR = ".haptics.mkv"
VIDEOS = frozenset(
    f".{ending}"
    for ending in ["mp4", "mov", "mkv", "avi", "webm", "m4v", "360", "lrv", "ts", "mpg"]
)
CLIP = "clip."
"""Begins the name of the video that is unpacked."""

_OWN_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}\.(npz|json)")
_ASK_AGAIN = Message("ask for the file again")
_REFUSAL = SequenceError, _ASK_AGAIN


@dataclass(frozen=True, slots=True, eq=False)
class Packed:
    """A sequence within a video, or beside it.

    Attributes:
        carrier: the file that holds the force; of a remote one its name.
        sequence: with the video as its clip.
        payload: of the video that the force was made for.
        attached: the files by name, those for other programs too.
        small: content of the sequence's own files by name, compared with its checksums.
    """

    carrier: Path
    sequence: store.Sequence
    payload: VideoDigest
    attached: Mapping[str, Attachment]
    small: Mapping[str, bytes]


class _Manifest(Struct):
    """The file that lists all others."""

    files: dict[str, FileEntry]
    video: VideoDigest


class _AttachedFiles:
    """The small files of a sequence, attached to a video; see `store.SmallFiles`."""

    def __init__(self, where: str, attached: Mapping[str, Attachment]) -> None:
        self.where, self._attached = where, attached
        self._left_bytes = MAX_ATTACHED_BYTES

    def arrays(
        self, name: str, listed: Mapping[str, FileEntry]
    ) -> dict[str, NDArray[Any]]:
        content, where = self.content(name, listed), f"{self.where}: {name}"
        found = arrays_in(io.BytesIO(content), where, self._left_bytes)
        self._left_bytes -= sum(one.nbytes for one in found.values())
        return found

    def content(self, name: str, listed: Mapping[str, FileEntry]) -> bytes:
        """Return a file whose size and checksum are as listed."""
        entry, one = listed.get(name), self._attached.get(name)
        where = f"{self.where}: {name}"
        if entry is None or one is None:
            raise SequenceError("is missing", where=where, remedy=_ASK_AGAIN)
        digest = hashlib.sha256(one.content).hexdigest()
        if (len(one.content), digest) != (entry.size_bytes, entry.sha256):
            raise SequenceError(
                "has changed since it was written (its checksum differs)",
                where=where,
                remedy=_ASK_AGAIN,
            )
        return one.content


def is_video_name(path: Path) -> bool:
    """Whether a file has the name of a video, and not that of force beside one."""
    return path.suffix.lower() in VIDEOS and not path.name.endswith(SIDE_CAR)


def side_car_of(video: Path) -> Path:
    """Return where the force of a video is if it is not in the video."""
    return video.with_suffix(SIDE_CAR)


def read_packed(video: Path | ClipBytes) -> Packed | None:
    """Return the sequence in a video, or in the side-car beside it; None without one.

    Of a remote video everything but the video itself is fetched and held.
    """
    if video.name.endswith(SIDE_CAR):
        raise MediaError(
            "holds the force of a video, not the video",
            where=str(video),
            remedy="open the video of that name, which lies beside it",
        )
    carrier = path = path_of(video)
    attached = read_attachments(video, MANIFEST)
    if not attached:
        carrier = side_car_of(path)
        attached = _attached_beside(video, carrier)
    if not attached:
        return None
    return _packed(path, carrier, _by_name(carrier, attached))


def _attached_beside(video: Path | ClipBytes, side_car: Path) -> list[Attachment]:
    if isinstance(video, Path):
        return read_attachments(side_car, MANIFEST) if _is_there(side_car) else []
    if (remote := video.beside(side_car.name)) is None:
        return []
    try:
        return read_attachments(remote, MANIFEST)
    finally:
        remote.close()


def _is_there(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # the name is too long for a file
        return False


def _by_name(carrier: Path, attached: list[Attachment]) -> dict[str, Attachment]:
    named = {one.name: one for one in attached}
    if len(named) < len(attached):
        raise SequenceError(
            "holds two attachments of one name", where=str(carrier), remedy=_ASK_AGAIN
        )
    return named


def _packed(video: Path, carrier: Path, attached: dict[str, Attachment]) -> Packed:
    small = _AttachedFiles(str(carrier), attached)
    where = f"{carrier}: {MANIFEST}"
    given = _manifest(attached[MANIFEST].content, where)
    for name in given.files:
        small.content(name, given.files)
    content = small.content(store.DESCRIPTION, given.files)
    place = f"{carrier}: {store.DESCRIPTION}"
    found = decode(content, dict[str, Any], place, *_REFUSAL)
    description = checked_description(found, place)
    sequence = store.sequence_of(description, small, video.parent, video)
    return Packed(carrier, sequence, given.video, attached, _own(description, small))


def _manifest(content: bytes, where: str) -> _Manifest:
    manifest = decode(content, dict[str, Any], where, *_REFUSAL)
    other = Message("is not a manifest of hapticplayer"), _ASK_AGAIN
    check_schema(manifest, (SCHEMA, VERSION), where, other, SequenceError)
    return convert(manifest, _Manifest, where, SequenceError, _ASK_AGAIN)


def _own(description: Description, small: _AttachedFiles) -> dict[str, bytes]:
    """The files of the sequence beside its clip."""
    listed = description.files
    names = [name for name in listed if name != description.clip.file]
    refuse_twins([MANIFEST, store.DESCRIPTION, *names], Path(small.where))
    for name in names:
        if not _OWN_NAME.fullmatch(name):
            raise SequenceError(
                "holds a file that no sequence has, {name!r}",
                where=small.where,
                remedy=_ASK_AGAIN,
                name=name[:60],
            )
    return {name: small.content(name, listed) for name in names}


def refuse_twins(names: Iterable[str], carrier: Path) -> None:
    """Raise for names that are no file's, or another's: also where case does not count."""
    taken: set[str] = set()
    for name in names:
        store.inside(carrier, name)
        folded = name.casefold()
        if folded in taken or folded.startswith(CLIP):
            raise SequenceError(
                "holds a file that is named like another part of it, {name!r}",
                where=str(carrier),
                remedy=_ASK_AGAIN,
                name=name[:60],
            )
        taken.add(folded)
