"""Puts a sequence into one video file, or beside one, and takes it out again."""

import hashlib
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from msgspec import to_builtins

from hapticplayer import __version__, storage
from hapticplayer.errors import (
    Message,
    Progress,
    SequenceError,
    UsageError,
    no_progress,
)
from hapticplayer.media import remux
from hapticplayer.media.clip_info import POINTER
from hapticplayer.media.identity import VideoDigest
from hapticplayer.media.matroska import EBML, Attachment
from hapticplayer.sequence import store
from hapticplayer.sequence.contents import attachment_of, files_to_pack
from hapticplayer.sequence.editing import MAX_TITLE
from hapticplayer.sequence.packed import (
    MANIFEST,
    SCHEMA,
    SIDE_CAR,
    VERSION,
    side_car_of,
)
from hapticplayer.sequence.personal import without_personal
from hapticplayer.storage import IsOurs

CONTAINERS = {".mkv": remux.MATROSKA, ".mp4": remux.MP4}
"""Kind of file by the ending of its name."""

_CHECK, _COUNT, _COPY = 0.15, 0.15, 0.5  # shares of the work; the rest reads back


def container_of(target: Path) -> str:
    """Return the kind of file that the ending of a name asks for."""
    kind = CONTAINERS.get(target.suffix.lower())
    if kind is None or target.name.endswith(SIDE_CAR):
        raise UsageError(
            "{name!r} must end with .mkv (one file) or .mp4 (with a side-car)",
            name=target.name,
        )
    return kind


def outputs_of(target: Path) -> list[Path]:
    """Return the files that `pack` writes."""
    is_one = container_of(target) == remux.MATROSKA
    return [target] if is_one else [target, side_car_of(target)]


def pack(  # noqa: PLR0913 - what goes along, and what for
    folder: Path,
    target: Path,
    *,
    with_motion: bool = False,
    with_places: bool = False,
    extras: Iterable[Attachment] = (),
    is_ours: IsOurs | None = None,
    progress: Progress = no_progress,
) -> VideoDigest:
    """Write a sequence as one video file with its force, for others to play.

    Video and sound are copied bit for bit, and read back to make sure.

    Args:
        folder: of the sequence.
        target: ends with .mkv, or with .mp4 for a plain video and a side-car with the force.
        with_motion: share motion and recorded samples too.
        with_places: share names of files, dates, numbers of devices, and in an MP4 with its
            motion the camera's own track, which may hold places.
        extras: files for other programs.
        is_ours: recognises a file that may be overwritten.
        progress: called with each step; raises Cancelled to stop.
    """
    kind = container_of(target)
    sequence = store.open_sequence(folder)
    if not with_places:
        shared = without_personal(sequence.description)
        sequence = replace(sequence, title=shared.title)
    attached = files_to_pack(
        sequence, extras, with_motion=with_motion, with_places=with_places
    )
    _check_clip(sequence, lambda f: progress(_CHECK * f, Message("checking the clip")))
    payload = remux.video_payload(
        sequence.clip,
        lambda f: progress(_CHECK + _COUNT * f, Message("checking the clip")),
    )
    manifest = _manifest(sequence, payload, attached)
    attached = (manifest, *attached)
    # of a title from a file name that is not UTF-8, some is not text
    title = sequence.title.encode(errors="replace").decode()[:MAX_TITLE]
    metadata = {"title": title, POINTER: _pointer(payload, manifest)}
    with _written(target, kind, is_ours) as (part, side_part):
        if side_part is None:
            additions = remux.Additions(attached, metadata)
        else:
            additions = remux.Additions((), metadata, with_motion and with_places)
            remux.write_attachments(side_part, attached)
        _copy(sequence.clip, part, kind, additions, payload, progress)
        progress(1.0, Message("done"))
    return payload


def is_packed(head: bytes) -> bool:
    """Whether a file begins as one that this program packed into Matroska."""
    return head.startswith(EBML) and MANIFEST.encode() in head


def _manifest(
    sequence: store.Sequence, payload: VideoDigest, attached: Iterable[Attachment]
) -> Attachment:
    content: dict[str, Any] = {
        "schema": SCHEMA,
        "version": VERSION,
        "program": f"hapticplayer {__version__}",
        "title": sequence.title,
        "video": to_builtins(payload),
        "files": {
            one.name: {
                "media_type": one.media_type,
                "size_bytes": len(one.content),
                "sha256": hashlib.sha256(one.content).hexdigest(),
            }
            for one in attached
        },
    }
    return attachment_of(MANIFEST, storage.json_text(content))


def _pointer(payload: VideoDigest, manifest: Attachment) -> str:
    return (
        f"video sha256 {payload.sha256}, {MANIFEST} sha256 "
        f"{hashlib.sha256(manifest.content).hexdigest()}"
    )


def _check_clip(sequence: store.Sequence, report: remux.Report) -> None:
    """Refuse a clip that has changed since it was imported."""
    entry = sequence.description.files[sequence.clip.name]
    if storage.sha256_of(sequence.clip, report) != entry.sha256:
        raise store.changed(sequence.clip)


@contextmanager
def _written(
    target: Path, kind: str, is_ours: IsOurs | None
) -> Iterator[tuple[Path, Path | None]]:
    """Yield where to write video and side-car, None without one."""
    if kind == remux.MATROSKA:
        with storage.file_written_aside(target, is_ours) as part:
            yield part, None
        return
    side_car = side_car_of(target)
    with (
        storage.file_written_aside(target) as part,
        storage.file_written_aside(side_car, is_ours) as side_part,
    ):
        yield part, side_part


def _copy(
    clip: Path,
    part: Path,
    kind: str,
    additions: remux.Additions,
    payload: VideoDigest,
    progress: Progress,
) -> None:
    """Copy a clip and read the copy back."""
    before = _CHECK + _COUNT

    def copying(share: float) -> None:
        progress(before + _COPY * share, Message("copying the clip"))

    def reading(share: float) -> None:
        left = 1.0 - before - _COPY
        progress(before + _COPY + left * share, Message("reading the copy"))

    copied = remux.remux(clip, part, kind, additions, copying)
    if copied.difference(payload):
        raise store.changed(clip)
    if payload.difference(remux.video_payload(part, reading)):
        raise SequenceError(
            "cannot be copied into {kind} without changing its video",
            where=str(clip),
            remedy="choose the other kind of file, or convert it to MP4 and import it again",
            kind=kind,
        )
