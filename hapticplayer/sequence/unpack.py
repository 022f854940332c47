"""Takes a sequence out of a file that was packed."""

from pathlib import Path

from msgspec import structs

from hapticplayer import storage
from hapticplayer.errors import Message, Progress, SequenceError, no_progress
from hapticplayer.media import remux
from hapticplayer.media.clip_info import probe
from hapticplayer.sequence import store
from hapticplayer.sequence.description import FileEntry, written
from hapticplayer.sequence.pack import CONTAINERS
from hapticplayer.sequence.packed import CLIP, Packed, read_packed
from hapticplayer.storage import FOLDER, refuse_existing


def require_packed(video: Path) -> Packed:
    """Return the sequence in a video or beside it; see `read_packed`."""
    packed = read_packed(video)
    if packed is None:
        raise SequenceError(
            "holds no force and has none beside it",
            where=str(video),
            remedy="choose a file that was written by pack",
        )
    return packed


def unpack(
    video: Path,
    target: Path,
    *,
    accepts_changed: bool = False,
    progress: Progress = no_progress,
) -> None:
    """Write the folder of a sequence from a file that was packed; the force is as it was.

    Args:
        video: the file.
        target: the new folder; must not exist.
        accepts_changed: whether the video may be another one than the force was made for.
        progress: called with each step; raises Cancelled to stop.
    """
    refuse_existing(target, FOLDER)
    packed = require_packed(video)
    kind = CONTAINERS.get(video.suffix.lower(), remux.MATROSKA)
    name = CLIP + ("mp4" if kind == remux.MP4 else "mkv")
    described = packed.sequence.description
    with storage.folder_written_aside(target) as folder:
        payload = remux.remux(
            video,
            folder / name,
            kind,
            remux.Additions(with_motion=True),
            lambda f: progress(0.8 * f, Message("copying the clip")),
        )
        if not accepts_changed:
            written_too = remux.video_payload(folder / name)
            for found in (payload, written_too):
                if why := packed.payload.difference(found):
                    raise _another_video(video, why)
        listed = {k: v for k, v in described.files.items() if k != described.clip.file}
        for one, content in packed.small.items():
            with (folder / one).open("xb") as writer:
                writer.write(content)
        digest = storage.sha256_of(
            folder / name, lambda f: progress(0.8 + 0.2 * f, Message("writing"))
        )
        listed[name] = FileEntry((folder / name).stat().st_size, digest)
        clip = structs.replace(
            described.clip, file=name, duration_s=probe(folder / name).duration_s
        )
        made = structs.replace(described, clip=clip, files=listed)
        storage.write_json(folder / store.DESCRIPTION, written(made))
        progress(1.0, Message("done"))


def _another_video(video: Path, why: Message) -> SequenceError:
    return SequenceError(
        "its video is not the one that the force was made for ({reason})",
        where=str(video),
        reason=why,
        remedy="ask for the file again, or accept it (--accept-changed-video)",
    )
