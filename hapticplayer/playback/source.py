"""What can be played: a sequence, or any video with any force track."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from hapticplayer.errors import MediaError, Message, joined
from hapticplayer.media.clip_bytes import ClipBytes, path_of
from hapticplayer.media.clip_info import ClipInfo, probe
from hapticplayer.model import Feedback, ForceTrack, MotionTrack, rendered_feedback
from hapticplayer.playback.video_check import VideoCheck
from hapticplayer.rendering import coverage_notice, no_feedback, refuse_late
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.description import Description
from hapticplayer.sequence.force_csv import read_force_csv
from hapticplayer.sequence.packed import (
    SIDE_CAR,
    is_video_name,
    read_packed,
    side_car_of,
)
from hapticplayer.sequence.store import DESCRIPTION, Sequence

FROM_FILE = "file"
"""Name of the feedback that `--force FILE` adds."""


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """A clip with the force tracks that can go with it, by name of the feedback.

    `motion` is gravity-free acceleration in media time, where it is known; `path` is
    what was opened, `description` that of the sequence. The `check` withholds the force
    from another video than its own; `notice` is for a person.
    """

    title: str
    path: Path
    clip: ClipInfo
    tracks: Mapping[str, ForceTrack]
    motion: MotionTrack | None
    feedback: str
    description: Description | None = None
    check: VideoCheck | None = None
    notice: Message | None = None

    def coverage_notice(self, feedback: str) -> Message | None:
        """Return a notice if a track covers hardly anything of the clip."""
        return coverage_notice(self.tracks[feedback], self.clip.duration_s)


def open_source(
    place: str | Path | ClipBytes, force: str | Path | None = None
) -> Source:
    """The source at a path: the folder of a sequence, or a video; or a remote video.

    The description in a sequence's folder means the folder; a file of force, such as a
    side-car or one that `import-force` reads, means the video of its name beside it.
    The force is a CSV file with rows `time_s,fx_n,fy_n,fz_n`, held between rows. A
    remote video waits for its server from here on, and is closed by the player.
    """
    if isinstance(place, ClipBytes):
        source = _from_video(place)
        place.patience_s = math.inf
    else:
        path = Path(place)
        path = path.parent if path.name == DESCRIPTION else path
        if force is None and _is_only_force(path):
            return _with_force_of(path)
        source = _from_sequence(path) if path.is_dir() else _from_video(path)
    if force is None:
        return source
    track = read_force_csv(Path(force), source.clip.duration_s)
    refuse_late(track, source.clip.duration_s, str(force))
    tracks = {FROM_FILE: track, **source.tracks}
    return replace(source, tracks=tracks, feedback=FROM_FILE)


_NOT_ONLY_FORCE = (".csv", ".wav")
"""Endings of formats of force that files of motion and sound have, too."""


def _is_only_force(path: Path) -> bool:
    if is_video_name(path) or path.is_dir() or path.suffix in _NOT_ONLY_FORCE:
        return False
    if path.name.endswith(SIDE_CAR):
        return True
    from hapticplayer.sequence.force_formats import read_formats

    formats = read_formats().values()
    return any(path.suffix.lower() in (f.suffix, *f.other_suffixes) for f in formats)


def _with_force_of(path: Path) -> Source:
    """The video beside a file of force."""
    from hapticplayer.sequence.force_formats import read_force

    stem = path.name.removesuffix(SIDE_CAR).removesuffix(path.suffix)
    videos = sorted(one for one in path.parent.glob("*") if is_video_name(one))
    video = next((one for one in videos if one.stem == stem), None)
    if video is None:
        raise MediaError(
            "holds the force of a video, and no video of its name lies beside it",
            where=str(path),
            remedy="put the video there, or give a sequence the force (import-force)",
        )
    source = _from_video(video)
    if path.name.endswith(SIDE_CAR):
        return source
    found = read_force(path)
    refuse_late(found.track, source.clip.duration_s, str(path))
    tracks = {FROM_FILE: found.track, **source.tracks}
    notice = joined("; ", found.notes) if found.notes else source.notice
    return replace(source, tracks=tracks, feedback=FROM_FILE, notice=notice)


def _from_sequence(folder: Path) -> Source:
    sequence = open_sequence(folder)
    entry = sequence.description.files[sequence.clip.name]
    check = VideoCheck(sequence.clip.resolve(), entry.sha256)
    return _source_of(sequence, folder, probe(sequence.clip), check)


def _source_of(
    sequence: Sequence, path: Path, clip: ClipInfo, check: VideoCheck | None = None
) -> Source:
    return Source(
        sequence.title,
        path,
        clip,
        dict(sequence.tracks),
        sequence.motion,
        rendered_feedback(sequence.tracks).value,
        sequence.description,
        check,
    )


def _from_video(video: Path | ClipBytes) -> Source:
    """Return a video with the force in it or beside it, or without any."""
    path = path_of(video)
    if path.suffix == ".json":
        raise MediaError(
            "is not a video", where=str(path), remedy="give the folder of the sequence"
        )
    if (packed := read_packed(video)) is not None:
        whole = path.resolve() if isinstance(video, Path) else video
        check = VideoCheck(whole, packed.payload)  # while the rest is opened
        return _source_of(packed.sequence, path, probe(video), check)
    clip = probe(video)
    tracks = {Feedback.NONE.value: no_feedback_for(clip)}
    notice = _missing_force(path) if clip.names_force else None
    return Source(
        path.name, path, clip, tracks, None, Feedback.NONE.value, notice=notice
    )


def _missing_force(path: Path) -> Message:
    return Message(
        "force belongs to this video, but neither it nor a file {name!r} beside it holds "
        "any; ask for both files again, and rename neither alone",
        name=side_car_of(path).name,
    )


def no_feedback_for(clip: ClipInfo) -> ForceTrack:
    """Return a track without force as long as the clip."""
    time_s = np.array([0.0, max(clip.duration_s, 1e-3)])
    return no_feedback(ForceTrack(time_s, np.zeros((2, 3), dtype=np.float32)))
